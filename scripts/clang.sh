#!/usr/bin/env bash
# Compiles everything with clang and runs the tests labelled `unit` with it: a second compiler's
# warnings, and, without a precompiled header, whether every file includes what it uses.
set -euo pipefail

cd "$(dirname "$0")/.."
scripts/install-deps.sh --clang
scripts/fetch-vma.sh
cmake --preset clang --log-level=WARNING
cmake --build --preset clang -j "$(nproc)"
ctest --preset clang -L unit --no-tests=error -j "$(nproc)"
