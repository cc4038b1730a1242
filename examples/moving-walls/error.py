#!/usr/bin/python3
"""usage: error.py RESULTS...: prints for each result folder of the moving walls the paper's velocity error: the mean
over the run of the RMS deviation from the exact velocity, in % of the velocity of the ends.
       error.py --series RESULTS: the RMS deviation over time and strain."""

import glob
import math
import os
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import vtu  # noqa: E402

RATE = 0.0025
END_VELOCITY = 0.025


def frames(folder):
    with open(os.path.join(folder, "particles.pvd")) as file:
        for time, path in re.findall(r'timestep="([^"]*)".*?file="([^"]*)"', file.read()):
            yield float(time), os.path.join(folder, path)


def rms(path):
    points, moved, velocity = vtu.read(path, "Points", "displacement", "velocity")
    total = 0.0
    for p, u, v in zip(points, moved, velocity):
        total += (v[0] - RATE * (p[0] - u[0])) ** 2 + v[1] ** 2
    return 100 * math.sqrt(total / len(points)) / END_VELOCITY


def series(folder):
    return [(time, rms(path)) for time, path in frames(folder)]


def mean(errors):
    area = sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(errors, errors[1:]))
    return area / errors[-1][0]


if __name__ == "__main__":
    if sys.argv[1] == "--series":
        for time, error in series(sys.argv[2]):
            print("%.4g,%.4g,%.4g" % (time, RATE * time, error))
    else:
        for folder in sys.argv[1:]:
            print("%.4g" % mean(series(folder)))
