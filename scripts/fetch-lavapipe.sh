#!/usr/bin/env bash
# Puts Mesa's lavapipe 25, a Vulkan device that runs on the CPU, into build/lavapipe for the tests
# labelled `gpu`. Debian 12's own lavapipe (22.3) has no ray tracing; bookworm-backports has 25.0.
# Nothing enters the system; private-apt.sh says how.
#
# Leaves build/lavapipe/icd.json (the driver's manifest), lib/ (the driver and those of its libraries
# that the system lacks or has too old) and env.sh, to be sourced for running a program by hand.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
target=$root/build/lavapipe
source "$root/scripts/folder.sh"
source "$root/scripts/private-apt.sh"

driver_loads() {
    [ -f "$target/icd.json" ] &&
        ! LD_LIBRARY_PATH=$target/lib ldd "$target/lib/libvulkan_lvp.so" | grep -q 'not found'
}
if driver_loads && grep -qF "\"$target/lib/libvulkan_lvp.so\"" "$target/icd.json"; then
    echo "fetch-lavapipe: $target/icd.json is there"
    exit 0
fi

release=$(. /etc/os-release && echo "${ID:-}-${VERSION_CODENAME:-}")
if [ "$release" != debian-bookworm ]; then
    echo "fetch-lavapipe: made for Debian 12, this is '$release'." \
        "Install your system's Mesa Vulkan drivers, 25.0 or newer." >&2
    exit 1
fi

folder_begin "$target"
mkdir -p "$work"/root "$work"/lib
private_apt_setup fetch-lavapipe "$work/apt" bookworm bookworm-backports
echo "fetch-lavapipe: downloading mesa-vulkan-drivers from bookworm-backports"
private_apt update
# apt itself tells which libraries this system lacks or has too old.
private_apt --yes --no-install-recommends --download-only -t bookworm-backports \
    install mesa-vulkan-drivers
private_apt_unpack "$work/root"

# Keep the driver and the unpacked libraries among its dependencies; the rest is other drivers.
folders=$(find "$work/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
driver=$(find "$work/root" -name libvulkan_lvp.so)
cp "$driver" "$work/lib/"
LD_LIBRARY_PATH=$folders ldd "$driver" | awk -v from="$work/root/" 'index($3, from) == 1 {print $3}' |
    xargs -r cp -L -t "$work/lib"
rm -rf "$work/apt" "$work/root"

cat >"$work/icd.json" <<JSON
{
    "file_format_version": "1.0.0",
    "ICD": { "library_path": "$target/lib/libvulkan_lvp.so", "api_version": "1.3.0" }
}
JSON
cat >"$work/env.sh" <<SH
export VK_DRIVER_FILES="$target/icd.json"
export LD_LIBRARY_PATH="$target/lib\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}"
SH
folder_end "$target"
if ! driver_loads; then
    echo "fetch-lavapipe: the driver's libraries are incomplete:" >&2
    LD_LIBRARY_PATH=$target/lib ldd "$target/lib/libvulkan_lvp.so" | grep 'not found' >&2
    exit 1
fi
echo "fetch-lavapipe: VK_DRIVER_FILES=$target/icd.json"
