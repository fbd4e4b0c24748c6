#!/usr/bin/env bash
# Puts Wuffs, whose one C file holds the PNG decoder that we use, into build/wuffs. No release of
# Debian has it; the source package `pywuffs` on PyPI ships it. Nothing else of pywuffs is used.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/folder.sh"
source "$root/scripts/pypi.sh"
file=wuffs-unsupported-snapshot.c

pypi_begin fetch-wuffs "$root/build/wuffs" 2.0.1
echo "fetch-wuffs: downloading pywuffs $version from PyPI (0.4 MB)"
pypi_pip download --no-binary :all: -d "$work/package" <<END
pywuffs==$version --hash=sha256:5a9fd8a5026badf9e133940cee87ad58bd5cb4cd5264b9c46b607cb34e2bb9ab
END
tar -xzf "$work/package/pywuffs-$version.tar.gz" -C "$work/package"
mv "$work/package/pywuffs-$version/libs/wuffs/release/c/$file" "$work/"
rm -r "$work/package"
sed -n '/^\/\/ Copyright/,/^\/\/ SPDX/ s,^// \?,,p' "$work/$file" >"$work/copyright"
pypi_end
echo "fetch-wuffs: $target/$file"
