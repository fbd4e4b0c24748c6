#!/usr/bin/env bash
# Runs the libFuzzer targets, clang with AddressSanitizer and UndefinedBehaviorSanitizer.
#   fuzz.sh SECONDS [TARGET...]   for so long each; all targets by default
# Starts from fuzz/corpus/TARGET. What a target dies of is left in build/fuzz/findings/TARGET, and
# inputs that reach new code in build/fuzz/found/TARGET, where the next run goes on.
set -euo pipefail

cd "$(dirname "$0")/.."
seconds=${1:-}
if ! [[ $seconds =~ ^[1-9][0-9]*$ ]]; then
    echo "usage: $0 SECONDS [gltf|image|environment]..." >&2
    exit 2
fi
shift
targets=("$@")
[ $# -gt 0 ] || targets=(gltf image environment)

scripts/install-deps.sh --fuzz
cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz -j "$(nproc)"

outcome=0
for target in "${targets[@]}"; do
    findings=build/fuzz/findings/$target found=build/fuzz/found/$target
    mkdir -p "$findings" "$found"
    options=(-max_total_time="$seconds" -max_len=16384 -timeout=25 -rss_limit_mb=4096
        -artifact_prefix="$findings/" -print_final_stats=1 -verbosity=0)
    [ ! -f "fuzz/$target.dict" ] || options+=(-dict="fuzz/$target.dict")
    echo "fuzz: $target, $seconds s"
    build/fuzz/fuzz/fuzz_"$target" "${options[@]}" "$found" "fuzz/corpus/$target" || {
        echo "fuzz: $target failed; the input is in $findings" >&2
        outcome=1
    }
done
exit "$outcome"
