"""Contact pairs as arrows: where bodies touch, how hard, and which way the detected normals point."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkArrowSource

from . import arrays

WHO = "Contact View"
BY_FORCE, BY_AREA, FIXED = 0, 1, 2
NORMAL, FORCE = 0, 1


def spacing_of(points):
    """The least distance of different coordinates [m]: that of the grid, as contact pairs lie at its nodes.

    None where all points are at one place.
    """
    if len(points) == 0 or not np.ptp(points, axis=0).any():
        return None
    round_off = 1e-6 * np.ptp(points, axis=0).max()
    steps = np.concatenate([np.diff(np.unique(points[:, axis])) for axis in range(3)])
    return steps[steps > round_off].min()


def flat_arrow():
    """An arrow from 0 to 1 along x in the plane z = 0, two cells: a shaft and a head."""
    points, cells = vtkPoints(), vtkCellArray()
    for x, y in ((0, -0.045), (0.65, -0.045), (0.65, 0.045), (0, 0.045), (0.65, -0.15), (1, 0), (0.65, 0.15)):
        points.InsertNextPoint(x, y, 0)
    for cell in ((0, 1, 2, 3), (4, 5, 6)):
        cells.InsertNextCell(len(cell), cell)
    arrow = vtkPolyData()
    arrow.SetPoints(points)
    arrow.SetPolys(cells)
    return arrow


def _solid_arrow(resolution):
    source = vtkArrowSource()
    source.SetTipResolution(resolution)
    source.SetShaftResolution(resolution)
    source.Update()
    return source.GetOutput()


def contact_arrows(data, scale_by=BY_FORCE, length=4.0, reference=0.0, spacing=0.0, direction=NORMAL,
                   only_in_contact=True, bodies="", resolution=8):
    """An arrow for each contact pair of `data` (a frame of contact.pvd), starting at the pair's node.

    scale_by: the arrows' lengths follow the magnitude of `force` (BY_FORCE) or `area` (BY_AREA), or are equal (FIXED).
    length: of an arrow whose value is `reference`, in spacings of the grid.
    reference: value of an arrow of that length [N or m^2]; 0: the frame's largest.
    spacing: of the grid [m]; 0: found from the places of the pairs.
    direction: NORMAL (unit, from body_a to body_b) or FORCE (on body_a).
    only_in_contact: leaves out pairs that no force acted on in the last step.
    bodies: only pairs in which one of these takes part, names or numbers with commas; empty: all.
    resolution: corners of a solid arrow's round; arrows of plane scenes are flat.
    Returns (vtkPolyData, number of pairs left out because a value is not a number). Every array of a pair is at its
    arrow's points and cells. Arrows of no length are left out. Raises arrays.DataError.
    """
    needed = [("normal", 3)] if direction == NORMAL else [("force", 3)]
    if scale_by == BY_FORCE:
        needed.append(("force", 3))
    elif scale_by == BY_AREA:
        needed.append(("area", 1))
    values = {name: arrays.point_array(data, name, components, WHO).astype(float) for name, components in needed}
    points = arrays.points_of(data).astype(float)
    pointing = values["normal" if direction == NORMAL else "force"]
    size = (np.linalg.norm(values["force"], axis=1) if scale_by == BY_FORCE
            else np.abs(values["area"]) if scale_by == BY_AREA else np.ones(len(points)))

    finite = np.isfinite(points).all(axis=1) & np.isfinite(pointing).all(axis=1) & np.isfinite(size)
    wanted = finite & pointing.any(axis=1) & (size > 0)
    if only_in_contact:
        wanted &= arrays.point_array(data, "in_contact", 1, WHO) != 0
    numbers = arrays.body_numbers(bodies, arrays.words(data, "body_names"), WHO)
    if numbers is not None:
        pairs = [np.isin(arrays.point_array(data, name, 1, WHO), numbers) for name in ("body_a", "body_b")]
        wanted &= pairs[0] | pairs[1]
    index = np.flatnonzero(wanted)
    output = vtkPolyData()
    output.GetFieldData().ShallowCopy(data.GetFieldData())
    if len(index) == 0:  # the arrays all the same, so that a view coloured by one keeps it
        for array in arrays.numeric(data.GetPointData()):
            for attributes in (output.GetPointData(), output.GetCellData()):
                attributes.AddArray(arrays.picked(array, index))
        return output, int(np.count_nonzero(~finite))

    if spacing <= 0:
        spacing = spacing_of(points[np.isfinite(points).all(axis=1)])
        if spacing is None:  # one place: its share of the interface is about as wide as the grid's cells
            area = data.GetPointData().GetArray("area")
            spacing = max((area.GetTuple1(int(i)) for i in index), default=0) if area is not None else 0
            spacing = spacing if spacing > 0 else 1.0
    longest = reference if reference > 0 and scale_by != FIXED else size[index].max()
    arrows = vtkPolyData()
    arrows_points = vtkPoints()
    arrows_points.SetData(arrays.to_vtk(points[index]))
    arrows.SetPoints(arrows_points)
    for array in arrays.numeric(data.GetPointData()):
        arrows.GetPointData().AddArray(arrays.picked(array, index))
    arrows.GetPointData().AddArray(arrays.to_vtk(length * spacing * size[index] / longest, "arrow length"))
    arrows.GetPointData().AddArray(arrays.to_vtk(pointing[index], "arrow direction"))

    plane = not points[index, 2].any() and not pointing[index, 2].any()
    glyph = vtkGlyph3D()
    glyph.SetInputData(arrows)
    glyph.SetSourceData(flat_arrow() if plane else _solid_arrow(resolution))
    glyph.SetScaleModeToScaleByScalar()
    glyph.SetColorModeToColorByScalar()
    glyph.SetInputArrayToProcess(0, 0, 0, 0, "arrow length")
    glyph.SetInputArrayToProcess(1, 0, 0, 0, "arrow direction")
    glyph.SetOutputPointsPrecision(1)  # double
    glyph.FillCellDataOn()
    glyph.Update()
    output.ShallowCopy(glyph.GetOutput())
    if plane:  # the rotations leave round-off there
        vtk_to_numpy(output.GetPoints().GetData())[:, 2] = 0
    for attributes in (output.GetPointData(), output.GetCellData()):
        for name in ("arrow length", "arrow direction", "GlyphScale", "GlyphVector"):
            attributes.RemoveArray(name)
    output.GetFieldData().ShallowCopy(data.GetFieldData())
    return output, int(np.count_nonzero(~finite))
