#!/usr/bin/env bash
# Makes build/kit/himalaya-kit.tar.gz, for building on a machine that has a C++ compiler, CMake and
# ninja, but neither our libraries nor a way to get them: the committed sources, and of the Debian
# packages that they need the headers, libraries and shader compiler. There:
#
#   tar xzf himalaya-kit.tar.gz && himalaya-kit/build.sh    # himalaya-kit/build/src/app/cli/himalaya
#
# Runs on Debian 12 with the packages of install-deps.sh --build.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
work=$root/build/kit/himalaya-kit
rm -rf "$work"
mkdir -p "$work/source" "$work/deps"

"$root/scripts/fetch-vma.sh"
"$root/scripts/fetch-wuffs.sh"
git -C "$root" archive HEAD -- . ':!docs/images' ':!docs/gallery' ':!tests' | tar -x -C "$work/source"
mkdir -p "$work/source/build/vma"
cp -r "$root"/build/vma/include "$work/source/build/vma/"
cp -r "$root"/build/wuffs "$work/source/build/"

# The packages that a build needs, and the libraries that those depend on but every system has.
packages="libglm-dev libsimdjson-dev libsimdjson14 libopenexr-dev libopenexr-3-1-30 libimath-dev
    libimath-3-1-29 libspng-dev libspng0 libjpeg62-turbo-dev libjpeg62-turbo zlib1g-dev zlib1g
    libtbb-dev libtbb12 libtbbbind-2-5 libtbbmalloc2 libxxhash-dev libxxhash0 libcli11-dev
    libfmt-dev libfmt9 libexpected-dev libvulkan-dev libvulkan1 libvulkan-volk-dev glslang-tools
    spirv-tools spirv-headers pkg-config pkgconf pkgconf-bin libpkgconf3"
# shellcheck disable=SC2086  # one word per package
dpkg-query -L $packages | sort -u | while read -r path; do
    case $path in
    /usr/include/* | /usr/lib/* | /usr/bin/* | /usr/share/cmake/* | /usr/share/pkgconfig/*) ;;
    /usr/share/cmake-*/* | /usr/share/CLI11/* | /usr/share/doc/*/copyright | /lib/*) ;;
    *) continue ;;
    esac
    if [ -L "$path" ] || [ -f "$path" ]; then
        mkdir -p "$work/deps$(dirname "$path")"
        cp -P "$path" "$work/deps$path"
    fi
done
# NVIDIA's driver opens these by name and offers no device without (see bundle.sh).
for library in libEGL.so.1 libGLdispatch.so.0; do
    path=$(ldconfig -p | awk -v l="$library" '$1 == l && /x86-64/ {print $NF; exit}')
    [ -z "$path" ] || cp -L "$path" "$work/deps/usr/lib/x86_64-linux-gnu/$library"
done
# Debian 12 has /lib as a link to /usr/lib.
if [ -d "$work/deps/lib" ]; then
    cp -rP "$work/deps/lib/." "$work/deps/usr/lib/"
    rm -r "$work/deps/lib"
fi

cat >"$work/build.sh" <<'SH'
#!/usr/bin/env bash
# Builds himalaya from the sources beside this file, with the libraries beside this file.
set -euo pipefail

kit=$(cd "$(dirname "$0")" && pwd)
deps=$kit/deps/usr
machine=x86_64-linux-gnu
export PATH=$PATH:$deps/bin  # the machine's own compiler first
export LD_LIBRARY_PATH=$deps/lib/$machine${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PKG_CONFIG_LIBDIR=$deps/lib/$machine/pkgconfig:$deps/share/pkgconfig
export PKG_CONFIG_SYSROOT_DIR=$kit/deps

# Another compiler warns of other things, which is no reason not to build.
cmake -S "$kit/source" -B "$kit/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DHIMALAYA_TESTS=OFF -DHIMALAYA_BENCH=OFF -DHIMALAYA_WARNINGS_AS_ERRORS=OFF \
    -DHIMALAYA_VULKAN=ON -DCMAKE_PREFIX_PATH="$deps" -DCMAKE_LIBRARY_ARCHITECTURE=$machine \
    -DCMAKE_CXX_FLAGS="-isystem $deps/include -isystem $deps/include/$machine" \
    -DCMAKE_BUILD_RPATH="$deps/lib/$machine"
cmake --build "$kit/build" --target himalaya
echo "kit: $kit/build/src/app/cli/himalaya"
SH
chmod +x "$work/build.sh"
tar -C "$root/build/kit" --owner=0 --group=0 -czf "$root/build/kit/himalaya-kit.tar.gz" himalaya-kit
echo "kit: build/kit/himalaya-kit.tar.gz ($(du -h "$root/build/kit/himalaya-kit.tar.gz" | cut -f 1))"
