#!/bin/bash
# install_test.sh BUILD WORK COMPILER: installs BUILD below WORK, then builds and runs the examples
# against it and looks at headers, exported symbols and sizes.
set -eu
build=$1 work=$2 compiler=$3
source=$(cd "$(dirname "$0")/../.." && pwd)
fail() { echo "install: $*"; exit 1; }

rm -rf "$work"
mkdir -p "$work"
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >"$work/install.log"
library=$(find "$prefix" -name 'libhimalaya.*' -type f)
program=$prefix/bin/himalaya

echo "headers: each compiles alone, with nothing but the standard library"
for header in "$prefix"/include/himalaya/*.h; do
  echo "#include <himalaya/$(basename "$header")>" |
    "$compiler" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$prefix/include" -x c++ - ||
    fail "$header does not compile alone"
done
if grep -rnE '#include <' "$prefix/include" | grep -vE '#include <(himalaya/[a-z]+\.h|[a-z_]+)>'; then
  fail "a header includes another library"
fi

if [[ $library == *.so* ]]; then
  echo "exports: the library's own names only"
  foreign=$(nm -D --defined-only --demangle "$library" |
    grep -vE ' (himalaya::|(typeinfo|typeinfo name|vtable) for himalaya::)' || true)
  [ -z "$foreign" ] || fail "exported: $foreign"
fi
nm --demangle "$library" 2>/dev/null | grep -E ' T operator (new|delete)' &&
  fail "the library replaces operator new"

bytes=$(($(stat -c %s "$program") + $(stat -c %s "$library")))
echo "size: $bytes bytes, program and library"
[[ $(grep CMAKE_BUILD_TYPE "$build/CMakeCache.txt") != *=Release || $bytes -lt 25000000 ]] ||
  fail "the program and the library are larger than 25 MB"

echo "examples"
cmake -S "$source/examples" -B "$work/examples" -DCMAKE_PREFIX_PATH="$prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release >"$work/configure.log"
cmake --build "$work/examples" >"$work/build.log" || { cat "$work/build.log"; exit 1; }

# Lambertian: albedo * E / pi, with E = pi.
seen=$("$work/examples/scene_in_memory" "$work/memory.exr")
[ "$seen" = "0.8000 0.4000 0.2000 at 2.0000 m" ] || fail "scene_in_memory says $seen"
[ -s "$work/memory.exr" ] || fail "scene_in_memory wrote nothing"

# The library renders what the program does, to the bit.
"$work/examples/render_file" "$source/scenes/spheres.glb" "$work/library.exr"
"$program" render "$source/scenes/spheres.glb" --size 128x128 --spp 16 --device cpu --quiet \
  -o "$work/program.exr"
"$program" compare "$work/library.exr" "$work/program.exr" --max-rmse 0 ||
  fail "the library's picture is not the program's"
"$work/examples/render_file" /nowhere.glb "$work/none.png" 2>"$work/error.txt" &&
  fail "a missing file is no error"
grep -q "/nowhere.glb: can't be opened" "$work/error.txt" || fail "$(cat "$work/error.txt")"
