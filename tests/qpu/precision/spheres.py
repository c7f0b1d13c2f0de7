#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""spheres.py DUMP_PROGRAM NAME...: the reference spheres, drawn by our programs with VideoCore IV's arithmetic.

Both stages of each program run at every pixel of an analytic sphere, so that nothing but arithmetic differs from the
generic program in float64. Cells: mean of the difference in codes, share of pixels off by more than 1 code, and the
largest difference, where N.V > 0.05; bold where a limit of the picture tests (0.05, 0.1 %, 4) is broken.
"""
import sys

import numpy as np

from program import Difference, Fed
from qpu_math import Exact, Float32, Qpu

SIZE, HALF = 256, np.tan(np.radians(20.0))
ROTATION = (-0.3764000879256042, 0.2688572056611459, 0.0, 0.8865882791767989)  # of the reference files' sun
ARITHMETIC = [("float32", Float32())] + [
    (f"{bits} bits {direction}", Qpu(bits, direction)) for bits in (14, 12) for direction in ("up", "down", "random")]
ROUGHNESSES = (0.05, 0.1, 0.2, 0.3, 0.8)


def to_sun():
    x, y, z, w = ROTATION
    u, v = np.array([x, y, z]), np.array([0.0, 0.0, -1.0])
    return -(v + 2 * np.cross(u, np.cross(u, v) + w * v))


def visible_points():
    """Points of the unit sphere that the pixels of a camera at distance 4 see at N.V > 0.05."""
    row, column = np.mgrid[0:SIZE, 0:SIZE]
    ray = np.stack([HALF * ((column + 0.5) / (SIZE / 2) - 1), HALF * (1 - (row + 0.5) / (SIZE / 2)),
                    -np.ones((SIZE, SIZE))], -1).reshape(-1, 3)
    ray /= np.linalg.norm(ray, axis=1, keepdims=True)
    eye = np.array([0.0, 0.0, 4.0])
    b = ray @ eye
    hit = b * b - 15 > 0
    points = eye + ray[hit] * (-b[hit] - np.sqrt(b[hit] ** 2 - 15))[:, None]
    return points[np.einsum("ij,ij->i", points, -ray[hit]) > 0.05]


def main():
    dumper, points, sun = sys.argv[1], visible_points(), to_sun()
    print("| program | metallic | roughness | distance | " + " | ".join(title for title, _ in ARITHMETIC) + " |")
    print("|" + "---|" * (4 + len(ARITHMETIC)))
    for name in sys.argv[2:]:
        for distance, metallic, roughness in [(d, m, r) for d in (4, 100) for m in (0, 1) for r in ROUGHNESSES]:
            scenes = [[0.9, 0.5, 0.2, metallic, roughness, 0, 0, distance, *sun]]
            expected = Fed(dumper, name.replace("+vc4", ""), scenes).shade(Exact(), points, points)
            program = Fed(dumper, name, scenes)
            cells = [str(Difference(program.shade(each, points, points), expected)) for _, each in ARITHMETIC]
            print(f"| `{name}` | {metallic} | {roughness} | {distance} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
