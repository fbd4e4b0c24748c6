#!/usr/bin/env bash
# Puts OpenEXR's own Python package and numpy into build/openexr-python, for the test that reads our
# files back. pip checks the wheels' hashes.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
target=$root/build/openexr-python
version=3.3.2

# Written last, so that a folder half made does not count.
if [ "$(cat "$target/version" 2>/dev/null)" = "$version" ]; then
    echo "fetch-openexr-python: $target is there"
    exit 0
fi
if ! python3 -m pip --version >/dev/null 2>&1; then
    echo "fetch-openexr-python: python3 with pip is needed (Debian: python3-pip)" >&2
    exit 1
fi
work=$root/build/openexr-python.new
rm -rf "$work"
mkdir -p "$work"
# The wheels are those for Debian's Python 3.11 on x86-64.
cat >"$work/requirements.txt" <<'END'
OpenEXR==3.3.2 --hash=sha256:78ddd5149c2aaca35556328fb9d112ba9d31c0f0a3cdf373ed76ae384c91bf81
numpy==1.26.4 --hash=sha256:666dbfb6ec68962c033a450943ded891bed2d54e6755e35e5835d63f4f6931d5
END
python3 -m pip install --quiet --disable-pip-version-check --no-deps --only-binary :all: \
    --require-hashes -r "$work/requirements.txt" --target "$work"
echo "$version" >"$work/version"
rm -rf "$target"
mv "$work" "$target"
echo "fetch-openexr-python: OpenEXR $version is in $target"
