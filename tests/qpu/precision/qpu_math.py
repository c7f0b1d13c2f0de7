# SPDX-License-Identifier: MIT
"""Arithmetic as VideoCore IV does it, or worse: float32 with special functions of a given precision.

Additions and multiplications round towards zero (the rounding mode that VC4CL, the OpenCL driver of the same
GPU, reports), and denormals are zero.

The special function unit computes exp2, log2, 1/x and 1/sqrt(x). Broadcom's reference guide states no precision.
Measured on a Raspberry Pi 2 (Sugizaki, qiita.com/ysugi, articles e3118ada915d2a6485eb and a24ac7c65db95f0a0a54,
2017; 27 results are printed there): 15 bits behind the binary point, 1/x off by up to 2^-14.99 of the result,
1/sqrt(x) by up to 2^-14.17. Of exp2 and log2 nobody seems to have printed figures; Mesa's author calls them
inaccurate (github.com/anholt/mesa, issue 8). So `Qpu(bits)` takes a bound for all four: the result is off by up
to 2^-bits of itself, log2's by 2^-bits where it is less than 1; then it is cut to 15 bits. 14 is what was
measured; 13 and 12 are margins.

`direction` says how the error lies: "up" and "down" always to one side by all of the bound, which is the worst
for differences; "random" evenly between, the same for the same argument.

Mesa 25.0.7 (vc4_program.c, ntq_rcp and ntq_rsq) follows 1/x and 1/sqrt(x) with one Newton step each, log2 and exp2
with nothing; sqrt is the reciprocal of 1/sqrt; pow is exp2(y log2 x); division is a product with 1/x.
"""
import numpy as np

F = np.float32


def toward_zero(exact):
    """float64 to float32, cut off; denormals are zero."""
    with np.errstate(over="ignore", invalid="ignore"):
        rounded = exact.astype(F)
        away = np.abs(rounded.astype(np.float64)) > np.abs(exact)
        rounded = np.where(away, np.nextafter(rounded, F(0)), rounded)
    return np.where(np.abs(rounded) < F(2.0**-126), F(0), rounded)


class Exact:
    """float64 with exact functions: what the formulas mean."""

    number = np.float64

    def add(self, a, b):
        return a + b

    def sub(self, a, b):
        return a - b

    def mul(self, a, b):
        return a * b

    def exp2(self, x):
        return np.exp2(x)

    def log2(self, x):
        with np.errstate(divide="ignore"):
            return np.log2(np.abs(x))

    def rcp(self, x):
        with np.errstate(divide="ignore"):
            return 1.0 / x

    def rsq(self, x):
        with np.errstate(divide="ignore"):
            return 1.0 / np.sqrt(np.abs(x))

    def sqrt(self, x):
        return np.sqrt(np.abs(x))


class Float32(Exact):
    """A software rasteriser: float32, each operation rounded to nearest."""

    number = F

    def _round(self, x):
        return np.asarray(x, np.float64).astype(F)

    def exp2(self, x):
        return self._round(np.exp2(x.astype(np.float64)))

    def log2(self, x):
        with np.errstate(divide="ignore"):
            return self._round(np.log2(np.abs(x.astype(np.float64))))

    def rcp(self, x):
        with np.errstate(divide="ignore"):
            return self._round(1.0 / x.astype(np.float64))

    def rsq(self, x):
        with np.errstate(divide="ignore"):
            return self._round(1.0 / np.sqrt(np.abs(x.astype(np.float64))))

    def sqrt(self, x):
        return self._round(np.sqrt(np.abs(x.astype(np.float64))))


class Qpu:
    number = F
    MANTISSA = 15

    def __init__(self, bits, direction):
        self.bound = 2.0**-bits
        self.direction = direction

    def add(self, a, b):
        return toward_zero(np.float64(a) + np.float64(b))

    def sub(self, a, b):
        return toward_zero(np.float64(a) - np.float64(b))

    def mul(self, a, b):
        return toward_zero(np.float64(a) * np.float64(b))

    def exp2(self, x):
        return self._unit(np.exp2(np.float64(x)), x, 0)

    def log2(self, x):
        with np.errstate(divide="ignore"):
            return self._unit(np.log2(np.abs(np.float64(x))), x, 1)

    def rcp(self, x):
        with np.errstate(divide="ignore"):
            r = self._unit(1.0 / np.float64(x), x, 0)
        return self.mul(r, self.sub(F(2), self.mul(x, r)))

    def rsq(self, x):
        with np.errstate(divide="ignore"):
            r = self._unit(1.0 / np.sqrt(np.abs(np.float64(x))), x, 0)
        half = self.mul(F(0.5), self.mul(x, self.mul(r, r)))
        return self.mul(r, self.sub(F(1.5), half))

    def sqrt(self, x):
        return self.rcp(self.rsq(x))

    def _unit(self, exact, argument, floor):
        """floor: 1 where the error is that of a result of at least 1."""
        off = self._lean(argument) * self.bound * np.maximum(np.abs(exact), floor)
        with np.errstate(invalid="ignore"):
            result = np.where(np.isfinite(exact), exact + off, exact)
        mantissa, exponent = np.frexp(result)
        scale = 2.0 ** (self.MANTISSA + 1)
        with np.errstate(invalid="ignore", over="ignore"):
            cut = np.ldexp(np.trunc(mantissa * scale) / scale, exponent)
        return toward_zero(cut)

    def _lean(self, argument):
        if self.direction == "up":
            return 1.0
        if self.direction == "down":
            return -1.0
        bits = np.asarray(argument, F).view(np.uint32).astype(np.uint64)
        noise = (bits * np.uint64(2654435761) >> np.uint64(7)) & np.uint64(0xFFFF)
        return noise.astype(np.float64) / 32767.5 - 1.0
