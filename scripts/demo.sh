#!/usr/bin/env bash
# From a fresh clone to a picture: installs packages, builds, renders the scene demo:hero into
# demo.png and demo.exr of the current folder.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/release
SECONDS=0

"$root/scripts/install-deps.sh" --build
"$root/scripts/fetch-vma.sh"

# The tests need more packages, so a first configuration leaves them out; test.sh adds them later.
options=()
if [ ! -f "$build/CMakeCache.txt" ]; then
    options=(-DHIMALAYA_TESTS=OFF -DHIMALAYA_BENCH=OFF)
fi
(cd "$root" && cmake --preset release --log-level=WARNING "${options[@]}")
cmake --build "$build" --target himalaya -j "$(nproc)"
built=$SECONDS

"$build/src/app/cli/himalaya" render demo:hero -o demo.png -o demo.exr
echo "demo: $PWD/demo.png and demo.exr, built in ${built} s, rendered in $((SECONDS - built)) s"
