#!/usr/bin/env bash
# Puts OpenEXR's own Python package and numpy into build/openexr-python, for the test that reads our
# files back.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/folder.sh"
source "$root/scripts/pypi.sh"

pypi_begin fetch-openexr-python "$root/build/openexr-python" 3.3.2
# The wheels are those for Debian's Python 3.11 on x86-64.
pypi_pip install --only-binary :all: --target "$work" <<END
OpenEXR==$version --hash=sha256:78ddd5149c2aaca35556328fb9d112ba9d31c0f0a3cdf373ed76ae384c91bf81
numpy==1.26.4 --hash=sha256:666dbfb6ec68962c033a450943ded891bed2d54e6755e35e5835d63f4f6931d5
END
pypi_end
echo "fetch-openexr-python: OpenEXR $version is in $target"
