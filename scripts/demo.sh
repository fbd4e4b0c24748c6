#!/usr/bin/env bash
# From a fresh clone to a picture: installs packages, builds, and renders the scene demo:hero into
# demo.png and demo.exr of the current folder, after a small preview.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/release
himalaya=$build/src/app/cli/himalaya
SECONDS=0
step() { printf '\n== %s (%d:%02d) ==\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }

step "1 of 4: packages"
"$root/scripts/install-deps.sh" --build
"$root/scripts/fetch-vma.sh"

step "2 of 4: building, three minutes on two cores"
# The tests need more packages, so a first configuration leaves them out; test.sh adds them later.
options=()
if [ ! -f "$build/CMakeCache.txt" ]; then
    options=(-DHIMALAYA_TESTS=OFF -DHIMALAYA_BENCH=OFF)
fi
(cd "$root" && cmake --preset release --log-level=WARNING "${options[@]}")
cmake --build "$build" --target himalaya -j "$(nproc)"

denoise=(--denoise)
if [ ! -e "$root/build/oidn" ]; then
    echo "demo: the denoiser could not be installed, so the pictures stay noisy" >&2
    denoise=()
fi
step "3 of 4: preview"
"$himalaya" render demo:hero -o demo-preview.png --size 320x180 --spp 16 "${denoise[@]}"

step "4 of 4: picture"
"$himalaya" render demo:hero -o demo.png -o demo.exr "${denoise[@]}"
printf '\ndemo: %s/demo.png and demo.exr, in %d:%02d\n' "$PWD" $((SECONDS / 60)) $((SECONDS % 60))
