#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""samples.py DUMP_PROGRAM BRDF_SAMPLES NAME...: points lit by one sun, against their radiance in float64.

BRDF_SAMPLES is reference/brdf_samples.csv, by others. The programs' output is encoded, so that a difference is in codes.
Cells as spheres.py's, over the points where N.V > 0.05.
"""
import sys

import numpy as np

from program import Difference, Fed
from spheres import ARITHMETIC


def encode(color):
    color = np.clip(color, 0, 1)
    return np.where(color <= 0.0031308, 12.92 * color, 1.055 * color ** (1 / 2.4) - 0.055)


def main():
    dumper, rows = sys.argv[1], np.genfromtxt(sys.argv[2], delimiter=",", names=True, skip_header=2)
    rows = rows[rows["vz"] > 0.05]
    column = lambda *names: np.stack([rows[name] for name in names], -1)  # noqa: E731
    scenes = np.concatenate([column("base_r", "base_g", "base_b", "metallic", "roughness"),
                             column("vx", "vy", "vz"), column("lx", "ly", "lz")], axis=1)
    origin = np.zeros((len(rows), 3))
    normals = origin + [0.0, 0.0, 1.0]
    print("| program | " + " | ".join(title for title, _ in ARITHMETIC) + " |")
    print("|" + "---|" * (1 + len(ARITHMETIC)))
    for name in sys.argv[3:]:
        brdf = "seed" if "seed" in name else "gltf"
        expected = encode(column(*(f"{brdf}_{channel}" for channel in "rgb")))
        program = Fed(dumper, name, scenes)
        cells = [str(Difference(program.shade(each, origin, normals), expected)) for _, each in ARITHMETIC]
        print(f"| `{name}` | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
