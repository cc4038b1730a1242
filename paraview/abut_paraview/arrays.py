"""Arrays of VTK data as numpy arrays, with messages that say what to do where one is missing."""

import difflib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


class DataError(Exception):
    """The data can't be shown as asked; the message is for the user."""


def names_of(attributes):
    """Names of the arrays of point, cell or field data."""
    return [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]


def numeric(attributes):
    """The arrays of numbers among point or cell data; words have no place in numpy."""
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return [array for array in arrays if array is not None]


def did_you_mean(name, names):
    """'; did you mean "steel"?', or nothing if no name is near."""
    near = difflib.get_close_matches(name, names, n=1)
    return f'; did you mean "{near[0]}"?' if near else ""


def point_array(data, name, components, who):
    """The point array of that name, shape (points, components), or (points,) for one component.

    who: the filter, for the message. Raises DataError if the array is missing or has another number of components.
    """
    array = data.GetPointData().GetArray(name)
    if array is None:
        there = ", ".join(names_of(data.GetPointData())) or "none"
        raise DataError(f'{who}: the input has no point array "{name}" (there are: {there}). abut writes it unless the '
                        "scene's output/.../arrays leaves it out.")
    if array.GetNumberOfComponents() != components:
        raise DataError(f'{who}: the array "{name}" has {array.GetNumberOfComponents()} components, not {components}')
    return vtk_to_numpy(array)


def points_of(data):
    """Coordinates, shape (points, 3)."""
    points = data.GetPoints()
    if points is None or points.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return vtk_to_numpy(points.GetData())


def to_vtk(values, name=None):
    """A copy of a numpy array as a VTK array."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    if name is not None:
        array.SetName(name)
    return array


def picked(array, index):
    """The tuples of a VTK array at the places `index`, as a new VTK array of the same name."""
    result = to_vtk(vtk_to_numpy(array)[index], array.GetName())
    for component in range(array.GetNumberOfComponents()):
        if array.GetComponentName(component):
            result.SetComponentName(component, array.GetComponentName(component))
    return result


def words(data, name):
    """The list of words of that name in the field data; empty if there is none."""
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array is not None else []


def body_numbers(text, names, who):
    """Numbers of the bodies in a list "ball, 3", of names or numbers. None for an empty text: all bodies.

    Raises DataError for a name that no body has.
    """
    wanted = [word.strip() for word in (text or "").split(",") if word.strip()]
    if not wanted:
        return None
    numbers = []
    for word in wanted:
        if word in names:
            numbers.append(names.index(word))
        elif word.isdigit() and (not names or int(word) < len(names)):
            numbers.append(int(word))
        else:
            raise DataError(f'{who}: no body "{word}"{did_you_mean(word, names)}')
    return numbers
