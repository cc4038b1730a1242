"""Reads the particle files of abut for the scripts beside the examples. Needs VTK: apt-get install python3-vtk9."""

from vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read(path, *names):
    """A list of the named arrays ("Points": the positions), each as a list of values or of tuples."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    arrays = [grid.GetPoints().GetData() if name == "Points" else grid.GetPointData().GetArray(name) for name in names]
    return [vtk_to_numpy(values).tolist() for values in arrays]
