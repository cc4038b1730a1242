"""Result series in ParaView's pipeline: which folder they are of, filters after them, what they show now."""

from pathlib import Path

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import arrays


def file_of(source):
    """The file that a source or the filters after it show; DataError if there is none."""
    while source is not None:
        name = getattr(source, "FileName", None)
        if name:
            return Path(name[0] if not isinstance(name, str) else name)
        source = getattr(source, "Input", None)
        if isinstance(source, (list, tuple)):
            source = source[0] if source else None
    raise arrays.DataError("abut: select a series of a result folder (e.g. its particles.pvd) in the Pipeline Browser "
                           "first")


def series(folder, name):
    """The series `name` ("particles", "contact") of a result folder, opened if it is not open; DataError if missing."""
    path = Path(folder) / f"{name}.pvd"
    for source in simple.GetSources().values():
        try:
            if not hasattr(source, "Input") and file_of(source).resolve() == path.resolve():
                return source
        except arrays.DataError:
            pass
    if not path.is_file():
        there = sorted(file.stem for file in Path(folder).glob("*.pvd"))
        reason = f'it has {", ".join(there)}' if there else "it is no result folder of abut"
        raise arrays.DataError(f"{folder}: no {name}.pvd ({reason})" + (
            "; contact pairs are written by scenes with contact, unless output/contact is false"
            if name == "contact" and there else ""))
    source = simple.OpenDataFile(str(path))
    simple.RenameSource(name, source)
    return source


def filter_after(source, name, label, **properties):
    """The filter of that XML name after a source: the one that is there, else a new one with these properties.

    paraview.simple knows our filters only in scripts that loaded the plugin themselves, hence this longer way.
    """
    for present in simple.GetSources().values():
        if present.GetXMLName() == name and present.Input == source:
            return present
    controller = simple.servermanager.ParaViewPipelineController()
    proxy = simple.servermanager.CreateProxy("filters", name)
    if proxy is None:
        raise arrays.DataError("abut: load the plugin abut_plugin.py first (Tools > Manage Plugins)")
    controller.PreInitializeProxy(proxy)
    created = simple.servermanager._getPyProxy(proxy)
    created.Input = source
    for key, setting in properties.items():
        setattr(created, key, setting)
    controller.PostInitializeProxy(proxy)
    controller.RegisterPipelineProxy(proxy, label)
    return created


def active_folder():
    """The result folder of the active source, or None if that is a scene file."""
    file = file_of(simple.GetActiveSource())
    return None if file.suffix == ".json" else file.parent


def _leaves(source):
    """The datasets that a source shows now."""
    proxy = source.GetClientSideObject()  # None on a remote server
    data = proxy.GetOutputDataObject(0) if proxy is not None else simple.servermanager.Fetch(source)
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    iterator.InitTraversal()
    leaves = []
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return leaves


def field_words(source, name):
    """A list of words in the field data of what a source shows now."""
    return next((arrays.words(leaf, name) for leaf in _leaves(source) if leaf.GetFieldData().HasArray(name)), [])


def range_of(source, array, percent=99.0):
    """Range of a scalar cell array without the outermost values on either side, which would take all of the colours.

    None if there are no values.
    """
    found = [leaf.GetCellData().GetArray(array) for leaf in _leaves(source) if hasattr(leaf, "GetCellData")]
    values = np.concatenate([vtk_to_numpy(values) for values in found if values is not None] or [np.zeros(0)])
    values = values[np.isfinite(values)]
    return tuple(np.percentile(values, [100 - percent, percent])) if len(values) else None
