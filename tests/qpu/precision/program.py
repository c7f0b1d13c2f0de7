# SPDX-License-Identifier: MIT
"""A composed program, fed and run."""
import json
import subprocess

import numpy as np

from glsl import Program, Run

WIDTH = {"float": 1, "vec2": 2, "vec3": 3, "vec4": 4, "mat3": 3, "mat4": 4}


class Fed:
    """A program with uniforms for each of some scenes: rows of 11 numbers, see dump_program.cpp."""

    def __init__(self, dumper, name, scenes):
        rows = "\n".join(" ".join(repr(float(v)) for v in scene) for scene in scenes)
        lines = subprocess.run([dumper, name], input=rows, check=True, capture_output=True, text=True).stdout.splitlines()
        texts = json.loads(lines[0])
        self.vertex, self.fragment = Program(texts["vertex"]), Program(texts["fragment"])
        each = [json.loads(line) for line in lines[1:]]
        self.uniforms = {name: np.array([values[name] for values in each]).T for name in each[0]}

    def shade(self, arithmetic, points, normals):
        """gl_FragColor.rgb at points of a surface; there is one scene for each point, or one for all."""
        number = arithmetic.number
        one = np.ones(len(points), number)
        tangents = np.cross([0.0, 1.0, 0.0], normals)
        lengths = np.linalg.norm(tangents, axis=1, keepdims=True)
        tangents = np.where(lengths > 1e-6, tangents / np.maximum(lengths, 1e-6), [1.0, 0.0, 0.0])
        scope = self._scope(self.vertex, number)
        scope.update(aPosition=_columns(points, number), aNormal=_columns(normals, number),
                     aTangent=_columns(tangents, number) + [one], aUv0=[0 * one, 0 * one])
        for name, (kind, glsl, _) in self.vertex.globals.items():
            if kind == "varying":
                scope[name] = [0 * one] * WIDTH[glsl]
        varyings = Run(self.vertex, arithmetic, scope).scope
        scope = self._scope(self.fragment, number)
        scope.update({name: varyings[name] for name, (kind, *_) in self.fragment.globals.items() if kind == "varying"})
        textures = {"uNormalTexture": [0.5 * one, 0.5 * one, one], "uBaseColorTexture": [one] * 4,
                    "uMetallicRoughnessTexture": [one] * 4}
        color = Run(self.fragment, arithmetic, scope, textures).scope["gl_FragColor"][:3]
        return np.stack(np.broadcast_arrays(*color, one)[:3], -1).astype(np.float64)

    def _scope(self, program, number):
        """Uniforms as values: a vector's components, a matrix's columns, or an array's elements."""
        scope = {}
        for name, (kind, glsl, count) in program.globals.items():
            if kind != "uniform" or name not in self.uniforms:
                continue
            flat = [row.astype(number) if len(row) > 1 else number(row[0]) for row in self.uniforms[name]]
            width, grouped = WIDTH[glsl], glsl.startswith("mat") or count > 1
            scope[name] = [flat[i:i + width] for i in range(0, len(flat), width)] if grouped else flat
        return scope


def _columns(points, number):
    return [points[:, i].astype(number) for i in range(points.shape[1])]


def codes(color):
    """What a framebuffer of 8 bits would hold, unrounded; NaN counts as black."""
    return np.clip(np.nan_to_num(color), 0, 1) * 255


class Difference:
    """Of two pictures in codes, against the limits of the picture tests."""

    def __init__(self, actual, expected):
        error = np.abs(codes(actual) - codes(expected))
        self.mean, self.share, self.most = error.mean(), (error.max(axis=1) > 1).mean(), error.max()

    def __str__(self):
        text = f"{self.mean:.3f}, {100 * self.share:.2f} %, {self.most:.1f}"
        return text if self.mean <= 0.05 and self.share <= 0.001 and self.most <= 4 else f"**{text}**"
