#!/usr/bin/python3
"""usage: drift.py RESULTS: prints for each frame of an impact of two bodies what should not change: momentum and
angular momentum, by the particles; and the energies and the work of contact, by history.csv."""

import csv
import math
import os
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import vtu  # noqa: E402


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sums(path):
    points, velocity, mass = vtu.read(path, "Points", "velocity", "mass")
    momentum = [sum(m * v[k] for m, v in zip(mass, velocity)) for k in range(3)]
    turn = [math.fsum(m * cross(p, v)[k] for m, p, v in zip(mass, points, velocity)) for k in range(3)]
    scale = sum(m * math.hypot(*v) for m, v in zip(mass, velocity)) / 2
    return momentum, turn, scale


folder = sys.argv[1]
with open(os.path.join(folder, "particles.pvd")) as file:
    frames = [(float(t), os.path.join(folder, p)) for t, p in re.findall(r'timestep="([^"]*)".*?file="([^"]*)"', file.read())]
with open(os.path.join(folder, "history.csv")) as file:
    history = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
energy = history[0]["total_energy"]
print("time_ms,momentum_drift,angular_momentum,angular_momentum_drift_percent,energy_percent,strain_percent,contact_work_percent")
first = None
for time, path in frames:
    momentum, turn, scale = sums(path)
    if first is None:
        first, unit = turn, scale
    row = min(history, key=lambda r: abs(r["time"] - time))
    drift = math.hypot(*(a - b for a, b in zip(turn, first))) / math.hypot(*first)
    print("%.3f,%.1e,%.6e,%.2e,%.2f,%.2f,%.2f" % (
        1e3 * time, math.hypot(*momentum) / unit, turn[2], 100 * drift, 100 * row["total_energy"] / energy,
        100 * row["strain_energy"] / energy, 100 * row["contact_work"] / energy))
