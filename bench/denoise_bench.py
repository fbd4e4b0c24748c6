#!/usr/bin/env python3
"""Error before and after denoising, against a reference of 4096 samples, as JSON on standard output.

    bench/denoise_bench.py [--himalaya PROGRAM] [--device cpu|vulkan] [--scenes a,b] > OUT.json

Renders each shipped scene at 320 x 180 with 4, 16 and 64 samples and two seeds, denoises it, and
measures relMSE and FLIP of both pictures with `himalaya compare`. By default albedo and normal are
denoised first; it also measures with noisy guides and without guides. References are cached in
build/denoise_bench. Exits with 1 if a denoised picture has a larger error than the raw one.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZE = "320x180"
REFERENCE_SAMPLES = 4096
SAMPLES = (4, 16, 64)
SEEDS = (1, 2)
MEASURES = ("relmse", "flip")


class Bench:
    def __init__(self, program, device):
        self.program, self.device = program, device
        self.folder = ROOT / "build" / "denoise_bench"
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], stdout=subprocess.PIPE,
                              check=True)
        return json.loads(done.stdout) if done.stdout else {}

    def render(self, scene, samples, seed, path, *flags):
        return self.run("render", f"demo:{scene}", "--size", SIZE, "--spp", samples, "--seed", seed,
                        "--device", self.device, "--quiet", "--json", "-o", path, *flags)

    def reference(self, scene):
        path = self.folder / f"{scene}_{REFERENCE_SAMPLES}.exr"
        if not path.exists():
            unfinished = path.with_suffix(".new.exr")
            self.render(scene, REFERENCE_SAMPLES, 999, unfinished)
            os.replace(unfinished, path)
        return path

    def measure(self, path, layer, reference):
        report = self.run("compare", path, reference, "--layer", layer, "--json")
        return {name: report["layers"][0][name] for name in MEASURES}

    def denoise(self, path, reference, *flags):
        denoised = self.folder / "denoised.exr"
        report = self.run("denoise", path, "-o", denoised, *flags, "--device", "cpu", "--json")
        return report, self.measure(denoised, "denoised=beauty", reference)

    def row(self, scene, samples):
        reference = self.reference(scene)
        results = []
        for seed in SEEDS:
            path = self.folder / f"{scene}_{samples}.exr"
            self.render(scene, samples, seed, path, "--aov", "albedo,normal")
            report, denoised = self.denoise(path, reference)
            results.append({
                "raw": self.measure(path, "beauty", reference),
                "denoised": denoised,
                "clean_guides": self.denoise(path, reference, "--clean-guides")[1],
                "without_guides": self.denoise(path, reference, "--without-guides")[1]})
        means = {kind: {name: float(f"{sum(r[kind][name] for r in results) / len(results):.4g}")
                        for name in MEASURES} for kind in results[0]}
        return report, {"scene": scene, "samples": samples, **means}


def worse(row):
    return [name for name in MEASURES if row["denoised"][name] > row["raw"][name]]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--himalaya", default=ROOT / "build/release/src/app/cli/himalaya")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--scenes", default="cornell,hero,spheres")
    options = parser.parse_args()
    bench = Bench(options.himalaya, options.device)
    rows, report = [], {}
    for scene in options.scenes.split(","):
        for samples in SAMPLES:
            report, row = bench.row(scene, samples)
            rows.append(row)
            print(json.dumps(row), file=sys.stderr)
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"],
                            stdout=subprocess.PIPE, text=True).stdout.strip()
    lines = ",\n    ".join(json.dumps(row) for row in rows)
    print(f'{{\n  "commit": "{commit}", "program": {json.dumps(report["program"])},\n'
          f'  "denoiser": {json.dumps(report["denoiser"])},\n'
          f'  "size": "{SIZE}", "reference_samples": {REFERENCE_SAMPLES}, "seeds": {len(SEEDS)},\n'
          f'  "rows": [\n    {lines}\n  ]\n}}')
    bad = [(row["scene"], row["samples"], worse(row)) for row in rows if worse(row)]
    for scene, samples, names in bad:
        print(f"denoise_bench: {scene} at {samples} samples is worse in {', '.join(names)}",
              file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
