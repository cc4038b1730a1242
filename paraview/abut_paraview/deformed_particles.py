"""Particles as the domains that they stand for, deformed by their deformation gradients.

A particle at x with half edges r and deformation gradient F is the set of points x + F (xi * r), xi in [-1, 1]^d
(CPDI: Sadeghirad, Brannon and Burghardt 2011, Eq. 12): a parallelogram in the plane, a parallelepiped in space.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_POLYGON, VTK_QUAD, VTK_TRIANGLE, vtkCellArray,
                                           vtkUnstructuredGrid)

from . import arrays

WHO = "Deformed Particles"
DOMAINS, ELLIPSES = 0, 1


def _reference(shape, plane, resolution):
    """Points of the undeformed shape in [-1, 1]^3, cells as rows of point numbers, VTK type of the cells."""
    if shape == DOMAINS and plane:
        return np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float), np.arange(4)[None, :], VTK_QUAD
    if shape == DOMAINS:
        z = np.repeat([-1.0, 1.0], 4)
        x = np.tile([-1.0, 1.0, 1.0, -1.0], 2)
        y = np.tile([-1.0, -1.0, 1.0, 1.0], 2)
        return np.stack([x, y, z], axis=1), np.arange(8)[None, :], VTK_HEXAHEDRON
    if plane:
        angle = 2 * np.pi * np.arange(resolution) / resolution
        circle = np.stack([np.cos(angle), np.sin(angle), np.zeros(resolution)], axis=1)
        return circle, np.arange(resolution)[None, :], VTK_POLYGON
    return (*_sphere(resolution), VTK_TRIANGLE)


def _sphere(resolution):
    """A unit sphere of `resolution` meridians and half as many bands, as triangles."""
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetRadius(1)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(max(3, resolution // 2 + 1))
    source.GenerateNormalsOff()
    source.Update()
    sphere = source.GetOutput()
    points = vtk_to_numpy(sphere.GetPoints().GetData()).astype(float)
    points /= np.linalg.norm(points, axis=1)[:, None]  # VTK computes them in single precision
    return points, vtk_to_numpy(sphere.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def is_particles(data):
    """Whether a dataset has what deformed_particles() needs."""
    point_data = data.GetPointData() if data is not None and hasattr(data, "GetPointData") else None
    return point_data is not None and all(point_data.HasArray(name) for name in ("half_size", "deformation_gradient"))


def deformed_particles(data, shape=DOMAINS, scale=1.0, resolution=16):
    """The particles of `data` (a vtkPointSet with `half_size` and `deformation_gradient`) as cells.

    shape: DOMAINS, quadrilaterals in the plane (all half_size z are 0) and hexahedra in space, or ELLIPSES, polygons of
      `resolution` corners with the domain's half edges as semi-axes, in space triangulated ellipsoids.
    scale: of every domain about its centre; 0.9 shows the single domains.
    Returns (vtkUnstructuredGrid, number of particles left out because their place or shape is not a number). All point
    arrays of the input become cell arrays. `displacement` is given at the points too, varying over each domain as it
    deforms: Warp By Vector with a factor of -1 gives the undeformed domains. Raises arrays.DataError.
    """
    half_size = arrays.point_array(data, "half_size", 3, WHO).astype(float, copy=False)
    gradient = arrays.point_array(data, "deformation_gradient", 9, WHO).astype(float, copy=False)
    centre = arrays.points_of(data).astype(float, copy=False)
    keep = np.flatnonzero(np.isfinite(centre).all(axis=1) & np.isfinite(half_size).all(axis=1)
                          & np.isfinite(gradient).all(axis=1))
    left_out = len(centre) - len(keep)
    half_size, F, centre = half_size[keep], gradient[keep].reshape(-1, 3, 3), centre[keep]

    plane = not half_size[:, 2].any()
    reference, cells, cell_type = _reference(shape, plane, resolution)
    offset = scale * half_size[:, None, :] * reference[None, :, :]  # of the undeformed points from their centre
    deformed = np.matmul(offset, F.transpose(0, 2, 1))              # F times each
    points = (centre[:, None, :] + deformed).reshape(-1, 3)

    particles, corners, (cell_count, cell_size) = len(keep), len(reference), cells.shape
    connectivity = (corners * np.arange(particles)[:, None, None] + cells[None, :, :]).reshape(-1)
    offsets = cell_size * np.arange(particles * cell_count + 1)

    output = vtkUnstructuredGrid()
    vtk_points = vtkPoints()
    vtk_points.SetData(arrays.to_vtk(points))
    output.SetPoints(vtk_points)
    cell_array = vtkCellArray()
    cell_array.SetData(arrays.to_vtk(offsets.astype(np.int64)), arrays.to_vtk(connectivity.astype(np.int64)))
    output.SetCells(cell_type, cell_array)

    of_cell = np.repeat(keep, cell_count) if cell_count > 1 else keep
    for array in arrays.numeric(data.GetPointData()):
        output.GetCellData().AddArray(arrays.picked(array, of_cell))
    displacement = data.GetPointData().GetArray("displacement")
    if displacement is not None and displacement.GetNumberOfComponents() == 3:
        of_centre = vtk_to_numpy(displacement)[keep].astype(float, copy=False)
        at_points = (of_centre[:, None, :] + deformed - offset).reshape(-1, 3)
        output.GetPointData().AddArray(arrays.to_vtk(at_points, "displacement"))
    output.GetFieldData().ShallowCopy(data.GetFieldData())
    return output, left_out
