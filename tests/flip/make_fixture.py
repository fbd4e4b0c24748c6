"""Writes fixture.txt: the results of the published package for five pairs of pictures.

    python3 -m venv build/flip-venv
    build/flip-venv/bin/pip install flip-evaluator==1.7 OpenEXR==3.5.3 numpy
    build/flip-venv/bin/python tests/flip/make_fixture.py > tests/flip/fixture.txt

The pictures are those of tests/reference/data. Each pair is compared as radiance (HDR) and, clamped
to [0, 1], as linear values of a display (LDR). A line: kind, reference, test, start and stop
exposure and their number (0 for LDR), the mean error, then the error of every 37th pixel.
"""

import pathlib

import flip_evaluator
import numpy as np
import OpenEXR

PAIRS = [("box", "materials"), ("lens", "transparency"), ("metal", "lens"),
         ("punctual", "box"), ("materials", "metal")]
DATA = pathlib.Path(__file__).resolve().parent.parent / "reference" / "data"


def load(name):
    with OpenEXR.File(str(DATA / f"{name}.exr")) as file:
        return np.ascontiguousarray(file.channels()["RGB"].pixels, dtype=np.float32)


def main():
    for reference, test in PAIRS:
        for kind in ("HDR", "LDR"):
            pair = [load(reference), load(test)]
            if kind == "LDR":
                pair = [np.clip(picture, 0, 1) for picture in pair]
            errors, mean, used = flip_evaluator.evaluate(*pair, kind, inputsRGB=False,
                                                         applyMagma=False)
            exposures = [0, 0, 0]
            if kind == "HDR":
                exposures = [used["startExposure"], used["stopExposure"], used["numExposures"]]
            numbers = [*exposures, mean, *np.squeeze(errors).ravel()[::37]]
            print(kind, reference, test, *(f"{number:.8g}" for number in numbers))


if __name__ == "__main__":
    main()
