#!/usr/bin/python3
"""usage: lame.py RESULTS...: compares the last frame with Lamé's solution. Prints the largest and the RMS error of the
radial and of the hoop stress, as shares of the pressure and of the largest hoop stress, and of the displacement."""

import glob
import math
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import vtu  # noqa: E402

A, B, PRESSURE, E, NU = 0.020, 0.040, 1e3, 10e6, 0.3


def exact(r):
    """Radial stress, hoop stress, displacement."""
    c = PRESSURE * A * A / (B * B - A * A)
    return c * (1 - B * B / r**2), c * (1 + B * B / r**2), c * (1 + NU) / E * ((1 - 2 * NU) * r + B * B / r)


def particles(path):
    """Radius before the load, radial stress, hoop stress, displacement."""
    points, moved, stress = vtu.read(path, "Points", "displacement", "stress")
    return [(p[0] - u[0], s[0], s[2], u[0]) for p, u, s in zip(points, moved, stress)]


def last(folder):
    return sorted(glob.glob(os.path.join(folder, "particles", "particles_*.vtu")))[-1]


def errors(path):
    scale = PRESSURE, exact(A)[1], exact(A)[2]
    rows = [[(x - e) / s for x, e, s in zip(row[1:], exact(row[0]), scale)] for row in particles(path)]
    return [f(column) for column in zip(*rows)
            for f in (lambda c: max(map(abs, c)), lambda c: math.sqrt(sum(x * x for x in c) / len(c)))]


if __name__ == "__main__":
    print("results,radial_max,radial_rms,hoop_max,hoop_rms,displacement_max,displacement_rms (percent)")
    for folder in sys.argv[1:]:
        print(folder + "," + ",".join("%.3f" % (100 * e) for e in errors(last(folder))))
