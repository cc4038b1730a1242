"""Scene files of abut as VTK data. The program reads the scene; this module only calls it and reads what it writes."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from . import arrays
from .deformed_particles import deformed_particles

POINTS, DOMAINS = 0, 1
NO_GRID, OUTLINE, LINES, IMAGE = 0, 1, 2, 3


def find_program(given=""):
    """The program abut: `given`, else $ABUT, the PATH, the build folders of the source tree that this file is in.

    Raises arrays.DataError saying where it was looked for.
    """
    for said, name in (("the property Program", given), ("$ABUT", os.environ.get("ABUT", ""))):
        if name:
            found = shutil.which(os.path.expanduser(name))
            if found is None:
                raise arrays.DataError(f'abut: {said} is "{name}", which is no program that can be run')
            return found
    found = shutil.which("abut")
    if found:
        return found
    source = Path(__file__).resolve().parents[2]
    for folder in ("release", "debug", "asan"):
        built = source / "build" / folder / "abut"
        if os.access(built, os.X_OK):
            return str(built)
    raise arrays.DataError("abut: the program was not found: not in $ABUT, not on the PATH, not in "
                           f"{source}/build/release. Give its path in the property Program or in $ABUT.")


def _environment():
    """Ours, without the libraries of a ParaView that brings its own: abut uses the system's."""
    environment = dict(os.environ)
    paths = [p for p in environment.pop("LD_LIBRARY_PATH", "").split(os.pathsep) if p and "paraview" not in p.lower()]
    if paths:
        environment["LD_LIBRARY_PATH"] = os.pathsep.join(paths)
    return environment


def _read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def model_of(scene, program=""):
    """What `abut particles` makes of a scene file: (particles, boundaries, grid).

    Raises arrays.DataError with what the program said if it refuses the scene.
    """
    scene = Path(scene).resolve()
    if not scene.is_file():
        raise arrays.DataError(f"{scene}: no such file")
    command = find_program(program)
    with tempfile.TemporaryDirectory(prefix="abut-scene-") as folder:
        folder = Path(folder)
        files = [folder / "particles.vtu", folder / "boundaries.vtp", folder / "grid.vti"]
        run = subprocess.run([command, "particles", str(scene), "-o", str(files[0]), "--boundaries", str(files[1]),
                              "--grid", str(files[2]), "--no-png"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, cwd=scene.parent, env=_environment(), check=False)
        said = run.stderr.decode(errors="replace").strip()
        if run.returncode != 0 or not all(file.exists() for file in files):
            raise arrays.DataError(said or f"{command} particles {scene}: failed with exit code {run.returncode}")
        readers = vtkXMLUnstructuredGridReader(), vtkXMLPolyDataReader(), vtkXMLImageDataReader()
        return tuple(_read(reader, file) for reader, file in zip(readers, files))


class SceneCache:
    """The model of the last scene file, made anew only when the file or the program has changed."""

    def __init__(self):
        self._key = self._model = None

    def clear(self):
        self._key = None

    def model(self, scene, program=""):
        try:
            key = (os.path.abspath(scene), os.stat(scene).st_mtime_ns, os.stat(find_program(program)).st_mtime_ns)
        except OSError as error:
            raise arrays.DataError(f"{scene}: {error.strerror}") from error
        if key != self._key:
            self._model = model_of(scene, program)
            self._key = key
        return self._model


def grid_lines(grid):
    """The lines of a grid (vtkImageData) as vtkPolyData: in the plane all, in space those on its six sides."""
    nodes = np.array(grid.GetDimensions())
    lower = np.array(grid.GetOrigin())
    upper = lower + (nodes - 1) * np.array(grid.GetSpacing())
    flat = nodes == 1
    ends = []
    for along in np.flatnonzero(~flat):
        b, c = [axis for axis in range(3) if axis != along]
        places = [np.linspace(lower[axis], upper[axis], nodes[axis]) for axis in (b, c)]
        at_b, at_c = (values.ravel() for values in np.meshgrid(*places, indexing="ij"))
        if not flat.any():
            on_side = np.isin(at_b, places[0][[0, -1]]) | np.isin(at_c, places[1][[0, -1]])
            at_b, at_c = at_b[on_side], at_c[on_side]
        line = np.zeros((len(at_b), 2, 3))
        line[:, :, b], line[:, :, c] = at_b[:, None], at_c[:, None]
        line[:, 0, along], line[:, 1, along] = lower[along], upper[along]
        ends.append(line.reshape(-1, 3))
    return _lines(np.concatenate(ends) if ends else np.zeros((0, 3)))


def grid_outline(grid):
    """The edges of a grid's box as vtkPolyData."""
    bounds = np.array(grid.GetBounds()).reshape(3, 2)
    ends = []
    for along in np.flatnonzero(bounds[:, 0] != bounds[:, 1]):
        b, c = [axis for axis in range(3) if axis != along]
        for at_b, at_c in {(at_b, at_c) for at_b in bounds[b] for at_c in bounds[c]}:
            for end in bounds[along]:
                point = np.zeros(3)
                point[along], point[b], point[c] = end, at_b, at_c
                ends.append(point)
    return _lines(np.array(ends).reshape(-1, 3))


def _lines(ends):
    lines = vtkPolyData()
    points, cells = vtkPoints(), vtkCellArray()
    points.SetData(arrays.to_vtk(ends))
    cells.SetData(arrays.to_vtk(2 * np.arange(len(ends) // 2 + 1, dtype=np.int64)),
                  arrays.to_vtk(np.arange(len(ends), dtype=np.int64)))
    lines.SetPoints(points)
    lines.SetLines(cells)
    return lines


def _boundary(boundaries, number, surfaces):
    """The cells of one boundary as vtkPolyData of their own, polygons as their outlines unless `surfaces`."""
    cells = np.flatnonzero(vtk_to_numpy(boundaries.GetCellData().GetArray("boundary")) == number)
    part = vtkPolyData()
    points, lines, polygons = vtkPoints(), vtkCellArray(), vtkCellArray()
    points.SetDataTypeToDouble()
    for cell in cells:
        corners = boundaries.GetCell(int(cell)).GetPoints()
        numbers = [points.InsertNextPoint(corners.GetPoint(i)) for i in range(corners.GetNumberOfPoints())]
        if len(numbers) > 2 and not surfaces:
            numbers.append(numbers[0])
        (polygons if len(numbers) > 2 and surfaces else lines).InsertNextCell(len(numbers), numbers)
    part.SetPoints(points)
    part.SetLines(lines)
    part.SetPolys(polygons)
    for i in range(boundaries.GetCellData().GetNumberOfArrays()):
        part.GetCellData().AddArray(arrays.picked(boundaries.GetCellData().GetArray(i), cells))
    return part


def _add(blocks, name, data):
    number = blocks.GetNumberOfBlocks()
    blocks.SetBlock(number, data)
    blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)


def scene_blocks(model, particles_as=DOMAINS, grid_as=OUTLINE, surfaces=False):
    """A model of model_of() as a vtkMultiBlockDataSet: "bodies", "boundaries" with a block for each, "grid".

    particles_as: POINTS, or DOMAINS as deformed_particles() makes them. grid_as: NO_GRID, OUTLINE, LINES or IMAGE.
    surfaces: whether boundaries of scenes in space are surfaces, which hide what is behind them, or their outlines.
    """
    particles, boundaries, grid = model
    blocks = vtkMultiBlockDataSet()
    _add(blocks, "bodies", deformed_particles(particles)[0] if particles_as == DOMAINS else particles)
    parts = vtkMultiBlockDataSet()
    for number, name in enumerate(arrays.words(boundaries, "boundary_names")):
        _add(parts, name, _boundary(boundaries, number, surfaces))
    _add(blocks, "boundaries", parts)
    if grid_as != NO_GRID:
        _add(blocks, "grid", grid if grid_as == IMAGE else grid_lines(grid) if grid_as == LINES else grid_outline(grid))
    blocks.GetFieldData().ShallowCopy(particles.GetFieldData())
    return blocks
