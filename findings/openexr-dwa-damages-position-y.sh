#!/usr/bin/env bash
# OpenEXR's DWAA and DWAB decide by a channel's last name part what a channel is: of a layer
# `position` with the 32-bit float channels X, Y and Z they keep X and Z bit for bit and store Y as a
# colour of 16 bits, because luminance is called Y: what is beyond 65504 comes back infinite, and the
# rest is rounded. Nothing is raised or warned about.
#
# Seen on 2026-12-01 with the package OpenEXR 3.5.0 from PyPI (Python 3.11, x86-64 Linux):
#   position.X: exact, position.Y: largest inf of 1000000.0, position.Z: exact
# Exits with 0 while that is so.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: \
    OpenEXR==3.5.0 numpy==1.26.4
cd "$work"
"$work/venv/bin/python" - <<'END'
import numpy as np
import OpenEXR

values = np.linspace(1.0, 1e6, 64 * 32, dtype=np.float32).reshape(32, 64)
for name, codec in ("DWAA", OpenEXR.DWAA_COMPRESSION), ("DWAB", OpenEXR.DWAB_COMPRESSION):
    header = {"compression": codec, "type": OpenEXR.scanlineimage}
    channels = {f"position.{c}": values for c in "XYZ"}
    OpenEXR.File(header, channels).write("position.exr")
    back = OpenEXR.File("position.exr", separate_channels=True).channels()
    for c in "XYZ":
        pixels = back[f"position.{c}"].pixels
        exact = bool((pixels == values).all())
        print(f"{name} position.{c}: {'exact' if exact else f'largest {pixels.max()} of {values.max()}'}")
        assert exact == (c != "Y"), "changed: this channel was treated otherwise"
    assert np.isinf(back["position.Y"].pixels.max()), "changed: Y holds large values otherwise"
print("as recorded")
END
