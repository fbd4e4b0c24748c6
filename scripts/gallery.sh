#!/usr/bin/env bash
# Renders every glTF file of the assets into one contact sheet with names: docs/gallery/.
#   gallery.sh [ENVIRONMENT]   .hdr or .exr; by default a meadow of the assets
# Needs a release build and $HIMALAYA_ASSETS, by default ../shared/assets beside the repository.
# HIMALAYA names another program than the release build's.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
assets=${HIMALAYA_ASSETS:-$root/../shared/assets}
program=${HIMALAYA:-$root/build/release/src/app/cli/himalaya}
environment=${1:-$assets/hdri/kloppenheim_05_1k.hdr}
sheet=$root/docs/gallery
"$root/scripts/install-deps.sh" --gallery

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pictures=() labels=()
refused=$work/refused.md
: >"$refused"
cd "$assets"
while IFS= read -r -d '' file; do
    name=$(basename "${file%.*}")
    picture=$work/${#labels[@]}.png
    if "$program" render "$file" -o "$picture" --size 160x120 --spp 64 --exposure -1 \
        --env "$environment" --quiet 2>"$work/log"; then
        pictures+=(-label "$name" "$picture")
        labels+=("$name")
    else
        # The last line says why.
        echo "- \`$file\`: $(tail -n 1 "$work/log" | sed "s,^himalaya: error: $file: ,,")" >>"$refused"
        echo "gallery: refused: $file"
    fi
done < <(find core khronos models \( -name '*.gltf' -o -name '*.glb' \) -print0 | sort -z)

mkdir -p "$sheet"
montage "${pictures[@]}" -tile 8x -geometry +4+4 -font DejaVu-Sans -pointsize 10 \
    -background '#202020' -fill '#e0e0e0' -strip -quality 88 "$sheet/contact-sheet.jpg"
{
    cat <<EOF
# Gallery

Every file of the assets that loads, 160 x 120 pixels, 64 samples each, lit by
\`$(basename "$environment")\` beside its own lights. \`scripts/gallery.sh\` makes the sheet and this page.

![Contact sheet: ${#labels[@]} small renderings with their names](contact-sheet.jpg)

EOF
    cat "$sheet/notes.md"
    echo
    if [ -s "$refused" ]; then
        echo "Refused, with the program's reason:"
        echo
        cat "$refused"
    else
        echo "No file is refused."
    fi
} >"$sheet/README.md"
echo "gallery: ${#labels[@]} pictures in $sheet/contact-sheet.jpg, $(wc -l <"$refused") refused"
