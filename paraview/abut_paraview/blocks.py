"""Filters of datasets applied to the parts of composite data."""

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet

from .arrays import DataError


def map_leaves(data, applies, convert, who, wanted):
    """The composite `data` with `convert` applied to each dataset that it `applies` to; all others stay as they are.

    A vtkMultiBlockDataSet keeps its structure, the leaves of other kinds become blocks one after the other.

    Raises DataError if there is none; `wanted` says what was looked for.
    """
    output = vtkMultiBlockDataSet()
    same_structure = data.IsA("vtkMultiBlockDataSet")
    if same_structure:
        output.CopyStructure(data)
    found = False
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        if applies(leaf):
            leaf = convert(leaf)
            found = True
        if same_structure:
            output.SetDataSet(iterator, leaf)
        else:
            number = output.GetNumberOfBlocks()
            output.SetBlock(number, leaf)
            meta = iterator.GetCurrentMetaData() if iterator.HasCurrentMetaData() else None
            if meta is not None and meta.Has(vtkCompositeDataSet.NAME()):
                output.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), meta.Get(vtkCompositeDataSet.NAME()))
        iterator.GoToNextItem()
    if not found:
        raise DataError(f"{who}: no block of the input has {wanted}")
    output.GetFieldData().ShallowCopy(data.GetFieldData())
    return output
