"""Small datasets like those of abut, and what oracles measure on the results."""

import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "paraview"))

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid


def dataset(points, arrays, kind=vtkPolyData, body_names=()):
    data = kind()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.array(points, float).reshape(-1, 3), deep=True))
    data.SetPoints(vtk_points)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.array(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    if body_names:
        names = vtkStringArray()
        names.SetName("body_names")
        for name in body_names:
            names.InsertNextValue(name)
        data.GetFieldData().AddArray(names)
    return data


def particles(count, plane, seed=1):
    """Random particles with random deformation of positive determinant, and what else abut writes for them."""
    random = np.random.default_rng(seed)
    x, r = random.uniform(-2, 2, (count, 3)), random.uniform(0.1, 0.3, (count, 3))
    F = np.eye(3) + random.uniform(-0.3, 0.3, (count, 3, 3))
    if plane:
        x[:, 2] = r[:, 2] = 0
        F[:, 2, :2] = F[:, :2, 2] = 0
    data = dataset(x, {"half_size": r, "deformation_gradient": F.reshape(count, 9),
                       "body": np.arange(count, dtype=np.int32) % 3, "displacement": random.uniform(-1, 1, (count, 3))},
                   vtkUnstructuredGrid, ["a", "b", "c"])
    return data, x, r, F


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def corners(data, cell):
    points = data.GetCell(cell).GetPoints()
    return np.array([points.GetPoint(i) for i in range(points.GetNumberOfPoints())])


def area_and_centroid(polygon):
    """Of a polygon in the plane z = 0, signed (shoelace)."""
    x, y = polygon[:, 0], polygon[:, 1]
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = cross.sum() / 2
    return area, np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (6 * area)
