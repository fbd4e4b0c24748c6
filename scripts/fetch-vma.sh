#!/usr/bin/env bash
# Puts the Vulkan Memory Allocator, one header, into build/vma/include. Debian 12 does not have it;
# trixie's package is for every architecture and works with Debian 12's Vulkan headers.
# Nothing enters the system; private-apt.sh says how.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
target=$root/build/vma
source "$root/scripts/folder.sh"
source "$root/scripts/private-apt.sh"

for header in "$target/include/vk_mem_alloc.h" /usr/include/vk_mem_alloc.h; do
    if [ -f "$header" ]; then
        echo "fetch-vma: $header is there"
        exit 0
    fi
done

folder_begin "$target"
mkdir -p "$work/root"
private_apt_setup fetch-vma "$work/apt" trixie
echo "fetch-vma: downloading libvulkan-memory-allocator-dev from trixie"
private_apt update
# `download` takes the one package; its dependencies are the system's own headers.
(mkdir -p "$work/apt/cache/archives" && cd "$work/apt/cache/archives" &&
    private_apt download libvulkan-memory-allocator-dev)
private_apt_unpack "$work/root"
mkdir "$work/include"
cp "$work/root/usr/include/vk_mem_alloc.h" "$work/include/"
cp "$work/root/usr/share/doc/libvulkan-memory-allocator-dev/copyright" "$work/"
rm -rf "$work/apt" "$work/root"
folder_end "$target"
echo "fetch-vma: $target/include/vk_mem_alloc.h"
