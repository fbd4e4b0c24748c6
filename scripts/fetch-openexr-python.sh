#!/usr/bin/env bash
# Puts the Python packages of OpenEXR and OpenImageIO, and numpy, into build/openexr-python, for the test that reads our
# files back.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/folder.sh"
source "$root/scripts/pypi.sh"

pypi_begin fetch-openexr-python "$root/build/openexr-python" 3.5.0
# The wheels are those for Debian's Python 3.11 on x86-64.
pypi_pip install --only-binary :all: --target "$work" <<END
OpenEXR==$version --hash=sha256:afe3ffc4131717930a33474d0e16f789de73d9dd030d0955860a031d15d1df9b
openimageio==3.2.2.0 --hash=sha256:1133b6a6c04270398c419804e0d293b2bb3ce2d7607a17724cc45f385036b05b
numpy==1.26.4 --hash=sha256:666dbfb6ec68962c033a450943ded891bed2d54e6755e35e5835d63f4f6931d5
END
pypi_end
echo "fetch-openexr-python: OpenEXR $version is in $target"
