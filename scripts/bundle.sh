#!/usr/bin/env bash
# Makes build/bundle/himalaya-VERSION-linux-x86_64 and a .tar.gz of it: the program with the
# libraries it needs, the Vulkan loader and the scenes, to be unpacked anywhere on any x86-64 Linux
# with glibc 2.36 or newer and run as bin/himalaya. A GPU needs its driver there and nothing else.
#
#   bundle.sh [FOLDER]   takes the program from this build folder (default: builds build/release)
#
# What every Linux has stays out: the C library, the C++ runtime and whatever belongs to the driver.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-}
if [ -z "$build" ]; then
    build=$root/build/release
    [ -f "$build/CMakeCache.txt" ] || (cd "$root" && cmake --preset release --log-level=WARNING \
        -DHIMALAYA_TESTS=OFF -DHIMALAYA_BENCH=OFF)
    cmake --build "$build" --target himalaya -j "$(nproc)"
fi

version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=himalaya-$version-linux-$(uname -m)
work=$root/build/bundle/$name
rm -rf "$work"
cmake --install "$build" --component program --prefix "$work" --strip >/dev/null
mkdir -p "$work/lib" "$work/share/doc"

# Of the same age as the program or older on every machine that has the C library's version.
is_of_the_system() {
    case $1 in
    linux-vdso.* | ld-linux* | libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.*) ;;
    libstdc++.so.* | libgcc_s.so.*) ;;
    *) return 1 ;;
    esac
}

# The library's file, stripped, under the name that is asked for, and its licence.
take() {
    install -m 755 "$(readlink -f "$2")" "$work/lib/$1"
    strip --strip-unneeded "$work/lib/$1"
    package=$(dpkg -S "$(readlink -f "$2")" 2>/dev/null | sed 's/[:,].*//' | head -n 1) || true
    if [ -n "$package" ] && [ -f "/usr/share/doc/$package/copyright" ]; then
        install -m 644 -D "/usr/share/doc/$package/copyright" "$work/share/doc/$package/copyright"
    fi
}

# ldd writes "NAME => PATH (ADDRESS)".
ldd "$build/src/app/cli/himalaya" | awk '$2 == "=>" {print $1, $3}' | while read -r library path; do
    is_of_the_system "$library" || take "$library" "$path"
done
# Opened by name at run time, so ldd knows nothing of them: the loader, and what NVIDIA's driver
# opens in turn. Containers often mount the driver alone, and it then offers no device.
for library in libvulkan.so.1 libEGL.so.1 libGLdispatch.so.0; do
    path=$(ldconfig -p | awk -v l="$library" '$1 == l && /x86-64/ {print $NF; exit}')
    if [ -n "$path" ]; then
        take "$library" "$path"
    else
        echo "bundle: there is no $library here, so the bundle relies on the machine's own" >&2
    fi
done
install -m 644 "$root/LICENSE" "$root/README.md" "$work/share/doc/"
# Compiled into the program.
for library in vma wuffs; do
    [ ! -f "$root/build/$library/copyright" ] ||
        install -m 644 -D "$root/build/$library/copyright" "$work/share/doc/$library/copyright"
done

# Starts from elsewhere, with none of this machine's search paths but its own folder.
if ! env -i "$work/bin/himalaya" --version >/dev/null; then
    echo "bundle: the bundled program does not start" >&2
    exit 1
fi
outside=$(env -i ldd "$work/bin/himalaya" | awk '$2 == "=>" {print $1, $3}' | while read -r l p; do
    is_of_the_system "$l" || case $(readlink -f "$p") in "$work"/*) ;; *) echo "$l" ;; esac
done)
if [ -n "$outside" ]; then
    echo "bundle: these libraries still come from this machine:" $outside >&2
    exit 1
fi

tar -C "$root/build/bundle" --sort=name --owner=0 --group=0 -czf "$work.tar.gz" "$name"
echo "bundle: $work.tar.gz ($(du -h "$work.tar.gz" | cut -f 1); unpacked $(du -sh "$work" | cut -f 1))"
