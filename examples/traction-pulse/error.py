#!/usr/bin/python3
"""usage: error.py RESULTS...: prints for each result folder of the traction pulse the RMS error of the stress (the
paper's formula), the place and height of the top, and the largest stress behind the pulse, where there should be none.
Heights are shares of the pulse's."""

import glob
import math
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import vtu  # noqa: E402

PEAK = 0.0005e6


def exact(x):
    u = (0.150 - x) / 0.100
    return PEAK * max(0.0, 1 - abs(2 * u - 1))


def profile(folder):
    """Stress by place: the mean over the rows of particles, which all have the same places."""
    path = sorted(glob.glob(os.path.join(folder, "particles", "particles_*.vtu")))[-1]
    points, stress = vtu.read(path, "Points", "stress")
    return [p[0] for p in points], [s[0] for s in stress]


def measure(folder):
    x, s = profile(folder)
    rms = math.sqrt(sum((b - exact(a)) ** 2 for a, b in zip(x, s)) / len(x))
    top = max(range(len(s)), key=lambda i: s[i])
    behind = max(abs(b) for a, b in zip(x, s) if a < 0.045)
    return rms, 1000 * x[top], s[top] / PEAK, behind / PEAK


if __name__ == "__main__":
    for folder in sys.argv[1:]:
        print("%.3f,%.2f,%.4f,%.4f" % measure(folder))
