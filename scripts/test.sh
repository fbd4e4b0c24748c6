#!/usr/bin/env bash
# From a fresh clone to a tested one.
#   test.sh          all tests, optimised; validates the shipped scenes with Khronos' validator
#                    and asks it about the broken files of tests/corpus
#   test.sh --asan   all tests under AddressSanitizer and UndefinedBehaviorSanitizer
# Fails at the first thing that fails; ctest's summary comes last.
set -euo pipefail

cd "$(dirname "$0")/.."
case ${1:-} in
"") preset=release ;;
--asan) preset=asan ;;
*)
    echo "usage: $0 [--asan]" >&2
    exit 2
    ;;
esac

scripts/install-deps.sh --test
scripts/fetch-vma.sh
scripts/fetch-lavapipe.sh
scripts/fetch-openexr-python.sh
if [ "$preset" = release ]; then
    # npm checks the hash that the lock file gives.
    if ! cmp -s scripts/npm/package-lock.json build/npm/package-lock.json ||
        [ ! -f build/npm/node_modules/gltf-validator/package.json ]; then
        mkdir -p build/npm
        cp scripts/npm/package.json scripts/npm/package-lock.json build/npm/
        npm ci --prefix build/npm --no-audit --no-fund
    fi
fi

cmake --preset "$preset" --log-level=WARNING -DHIMALAYA_TESTS=ON
cmake --build --preset "$preset" -j "$(nproc)"
if [ "$preset" = release ]; then
    export GLTF_VALIDATOR_HOME=$PWD/build/npm
    node tests/validate_gltf.mjs scenes/*.glb
    build/release/tests/corpus/generate_corpus build/release/broken_gltf
    node tests/corpus/agree_with_validator.mjs build/release/broken_gltf
fi
ctest --preset "$preset" --no-tests=error -j "$(nproc)"
