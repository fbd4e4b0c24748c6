#!/usr/bin/env bash
# Runs clang-tidy (.clang-tidy) on the C++ sources that changed.
#   tidy.sh [REVISION]   since REVISION, uncommitted changes included (default: HEAD~1)
# Needs a configured clang build (scripts/clang.sh).
set -euo pipefail

cd "$(dirname "$0")/.."
since=${1:-HEAD~1}
[ -f build/clang/compile_commands.json ] || {
    echo "tidy: there is no build/clang; run scripts/clang.sh first" >&2
    exit 1
}
git rev-parse --quiet --verify "$since^{commit}" >/dev/null || {
    echo "tidy: there is no revision $since" >&2
    exit 2
}
# kernel.cpp and its like are compiled several times, under names of their own: once is enough.
git diff --name-only -z --diff-filter=d "$since" -- 'src/*.cpp' 'tests/*.cpp' 'tools/*.cpp' 'bench/*.cpp' \
    'examples/*.cpp' |
    xargs -0 -r -n 1 -P "$(nproc)" clang-tidy --quiet -p build/clang
echo "tidy: looked at what changed since $since"
