#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits what a rough surface scatters between its facets (energy.md): prints the constants of
glsl/fragment/energy/textures.glsl and of packEnergy() in src/pack.cpp, and their largest errors. Needs numpy; takes
about a minute.

The albedo E is that of GGX with height-correlated Smith shadowing, alpha = roughness^2, by a deterministic sum over the
normals that the eye sees (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023). No point of
it is one of the float64 reference that tests/generator/energy_test.cpp compares with.
"""
import numpy as np

POINTS = 640  # a side of the square of visible normals
ROUGHNESS = np.array([0.1, 0.13, 0.17, 0.23, 0.27, 0.33, 0.37, 0.43, 0.47, 0.53, 0.57, 0.63, 0.67, 0.73, 0.77, 0.83, 0.87,
                      0.93, 0.97, 1])
N_DOT_V = np.array([0.019, 0.027, 0.036, 0.045, 0.06, 0.08, 0.12, 0.16, 0.23, 0.27, 0.33, 0.37, 0.43, 0.47, 0.53, 0.57, 0.63,
                    0.67, 0.73, 0.77, 0.83, 0.87, 0.93, 0.97, 0.999])


def albedo(n_dot_v, alpha):
    """The share of a white sky's light that leaves after one reflection."""
    ring = (np.arange(POINTS) + 0.5) / POINTS
    u, phi = np.meshgrid(ring, np.pi * ring)
    view = np.array([alpha * np.sqrt(1 - n_dot_v**2), 0, n_dot_v])
    view /= np.linalg.norm(view)
    z = (1 - u) * (1 + view[2]) - view[2]
    radius = np.sqrt(np.maximum(1 - z * z, 0))
    half = np.array([alpha * (radius * np.cos(phi) + view[0]), alpha * radius * np.sin(phi), z + view[2]])
    half /= np.sqrt((half * half).sum(axis=0))
    n_dot_l = 2 * (np.sqrt(1 - n_dot_v**2) * half[0] + n_dot_v * half[2]) * half[2] - n_dot_v
    smith = lambda cosine: 0.5 * np.sqrt(1 + alpha**2 * (1 / cosine**2 - 1)) - 0.5
    shadowing = (1 + smith(n_dot_v)) / (1 + smith(n_dot_v) + smith(np.maximum(n_dot_l, 1e-9)))
    return np.where(n_dot_l > 0, shadowing, 0).mean()


def fit(terms, k):
    """The least largest error of 1 + k, for log2 k a sum of terms: Lawson's weights."""
    terms = np.stack(terms, axis=1)
    slope = k * np.log(2) / (1 + k)  # of log(1 + k) over log2 k
    weights = np.ones(len(k))
    best = np.inf
    for _ in range(1000):
        scale = np.sqrt(weights) * slope
        found = np.linalg.lstsq(terms * scale[:, None], np.log2(k) * scale, rcond=None)[0]
        errors = abs(np.exp2(terms @ found) - k) / (1 + k)
        if errors.max() < best:
            best, constants = errors.max(), found
        weights *= errors / errors.max() + 0.02
        weights /= weights.sum()
    return constants, best


def main():
    r, n = (grid.ravel() for grid in np.meshgrid(ROUGHNESS, N_DOT_V, indexing="ij"))
    k = 1 / np.array([albedo(y, x * x) for x, y in zip(r, n)]) - 1
    one, alpha, log_n = np.ones_like(r), r * r, np.log2(n)
    smith2 = n * n + alpha**2 * (1 - n * n)
    wide = np.log2(np.sqrt(smith2) + 3 * alpha)
    constants, worst = fit([one, np.log2(r), log_n, n, wide, r * wide], k)
    print("textures: 1, log2 r, log2 N.V, N.V, wide, r wide:", constants.round(4), f"worst {100 * worst:.2f} %")
    log_s = np.log2(smith2)
    constants, worst = fit([log_n, r * log_n, alpha * log_n, log_s, r * log_s, alpha * log_s, one, r, alpha, np.log2(r)], k)
    print("factors: x, y: 1, r, r^2; z: 1, r, r^2, log2 r:", constants.round(4), f"worst {100 * worst:.2f} %")


if __name__ == "__main__":
    main()
