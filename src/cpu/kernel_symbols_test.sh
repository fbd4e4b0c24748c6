#!/bin/sh
# Usage: kernel_symbols_test.sh ISA OBJECT
# What a kernel object offers the linker must bear its instruction set's name. Any other symbol (an
# inline function of a header, say) could become the one copy the whole program uses, and crash it on
# an older processor.
set -eu
foreign=$(nm --demangle --defined-only --extern-only "$2" |
    sed 's/^[0-9a-f]* *[A-Za-z] //' | grep -v "^hm_render_tile_$1\$" |
    grep -v -E "(^|[ <(:*&])(hm|glm)_$1::" || true)
if [ -n "$foreign" ]; then
    printf 'symbols of the %s kernel without its name:\n%s\n' "$1" "$foreign"
    exit 1
fi
nm --defined-only "$2" | grep -q "T hm_render_tile_$1\$"
