# Writes knob.stl: a closed torus of 48 x 20 corners whose tube swells and shrinks around it. Units are millimetres.
import numpy as np

n, m = 48, 20
u, v = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
tube = 2 + 0.5 * np.cos(3 * u)
p = np.stack([(5.5 + tube * np.cos(v)) * np.cos(u), (5.5 + tube * np.cos(v)) * np.sin(u), tube * np.sin(v)], axis=-1)
a, b = np.roll(p, -1, 0), np.roll(p, -1, 1)
c = np.roll(a, -1, 1)
triangles = np.concatenate([np.stack(t, axis=2).reshape(-1, 3, 3) for t in ((p, a, c), (p, c, b))])


def write(name, triangles):
    data = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    data["corners"] = triangles
    with open(name, "wb") as f:
        f.write(b"abut knob".ljust(80) + np.uint32(len(triangles)).tobytes() + data.tobytes())


write("knob.stl", triangles)
write("knob-open.stl", triangles[1:])  # one triangle is missing
flipped = triangles.copy()
flipped[0] = flipped[0, ::-1]
write("knob-flipped.stl", flipped)  # one triangle is inside out
print("volume", np.linalg.det(triangles).sum() / 6, "mm^3")
