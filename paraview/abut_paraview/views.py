"""Views of results in ParaView: what the macros and render_series.py show. Needs ParaView and the plugin loaded.

Each function shows a result folder in a render view. The folder is that of the active source: any series of the
folder, or a filter after one. The folder's other series are opened as they are needed.
"""

import json
import os
from pathlib import Path

from paraview import simple

from . import arrays

COLOUR_MAPS = Path(__file__).resolve().parents[1] / "colour_maps"
MOST_IN_LEGEND = 30
GREYS = [0.86, 0.78, 0.91, 0.82]  # of neighbouring bodies behind arrows


# === Where the data comes from


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


def active_folder():
    """The result folder of the active source, or None if that is a scene file."""
    file = file_of(simple.GetActiveSource())
    return None if file.suffix == ".json" else file.parent


def field_words(source, name):
    """A list of words in the field data of what a source shows now."""
    proxy = source.GetClientSideObject()
    data = proxy.GetOutputDataObject(0) if proxy is not None else simple.servermanager.Fetch(source)
    if data.IsA("vtkCompositeDataSet") and not data.GetFieldData().HasArray(name):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            if iterator.GetCurrentDataObject().GetFieldData().HasArray(name):
                return arrays.words(iterator.GetCurrentDataObject(), name)
            iterator.GoToNextItem()
    return arrays.words(data, name)


# === Colours


def _preset(file):
    with open(COLOUR_MAPS / file, encoding="utf-8") as text:
        return json.load(text)[0]


def body_colours(count):
    """`count` colours of bodies, r g b each, those of `abut render`."""
    colours = _preset("bodies.json")["IndexedColors"]
    return [colours[(3 * body + c) % len(colours)] for body in range(count) for c in range(3)]


def _categories(display, names, colours):
    """Colours a display by its cells' `body`, with the bodies' names in the legend."""
    simple.ColorBy(display, ("CELLS", "body"))
    lut = simple.GetColorTransferFunction("body", display)
    lut.InterpretValuesAsCategories = 1
    lut.AnnotationsInitialized = 1
    lut.Annotations = [word for body, name in enumerate(names) for word in (str(body), name)]
    lut.IndexedColors = colours
    lut.IndexedOpacities = [1.0] * len(names)
    return lut


def _legend(lut, view, title):
    bar = simple.GetScalarBar(lut, view)
    bar.Title = title
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.WindowLocation = "Upper Right Corner"
    bar.TitleFontSize = bar.LabelFontSize = 14
    return bar


# === Views


def _view(view):
    view = view or simple.GetActiveViewOrCreate("RenderView")
    if hasattr(view, "UseColorPaletteForBackground"):
        view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesLabelColor = [0, 0, 0]
    return view


def _domains(folder, view):
    """The deformed particles of a result folder (or of the scene source if it is None), shown: source and display."""
    if folder is None:
        source = simple.GetActiveSource()
        while getattr(source, "Input", None) is not None:
            source = source.Input
    else:
        particles = series(folder, "particles")
        source = next((s for s in simple.GetSources().values()
                       if s.GetXMLName() == "AbutDeformedParticles" and s.Input == particles), None)
        if source is None:
            source = simple.DeformedParticles(Input=particles)
            simple.RenameSource("deformed particles", source)
        simple.Hide(particles, view)
    display = simple.Show(source, view)
    display.SetRepresentationType("Surface")
    return source, display


def is_flat(source):
    """Whether all of a source lies in a plane z = constant."""
    bounds = source.GetDataInformation().GetBounds()
    return bounds[4] >= bounds[5]


def look_at(source, view):
    """Fits the view to a source; plane scenes are seen from above and turned no more."""
    if is_flat(source):
        view.InteractionMode = "2D"
        bounds = source.GetDataInformation().GetBounds()
        x, y = (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2
        view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [x, y, 0], [x, y, 1], [0, 1, 0]
    simple.ResetCamera(view)


def _update(source, view):
    simple.UpdatePipeline(time=view.ViewTime, proxy=source)


def show_bodies(folder=None, view=None):
    """Deformed particles in the colours of their bodies, with the bodies' names in the legend."""
    view = _view(view)
    source, display = _domains(folder, view)
    _update(source, view)
    names = field_words(source, "body_names")
    lut = _categories(display, names, body_colours(len(names)))
    _legend(lut, view, "body")
    display.SetScalarBarVisibility(view, len(names) <= MOST_IN_LEGEND)
    return source, lut


def show_stress(folder=None, view=None, array="von_mises_stress", title="von Mises stress [Pa]"):
    """Deformed particles coloured by a scalar of theirs."""
    view = _view(view)
    source, display = _domains(folder, view)
    _update(source, view)
    if source.CellData.GetArray(array) is None:
        raise arrays.DataError(f'the particles have no array "{array}"'
                               f"{arrays.did_you_mean(array, list(source.CellData.keys()))}")
    simple.ColorBy(display, ("CELLS", array))
    lut = simple.GetColorTransferFunction(array)
    lut.ApplyPreset("Viridis (matplotlib)", True)
    display.RescaleTransferFunctionToDataRange(False, True)
    _legend(lut, view, title)
    display.SetScalarBarVisibility(view, True)
    return source, lut


def show_contact(folder, view=None):
    """Arrows at contact pairs, scaled by force and coloured by separation, over the bodies in greys."""
    if folder is None:
        raise arrays.DataError("abut: a scene has no contact pairs yet; open contact.pvd of its results")
    view = _view(view)
    contact = series(folder, "contact")
    source, display = _domains(folder, view)
    _update(source, view)
    display.UseSeparateColorMap = 1
    names = field_words(source, "body_names")
    _categories(display, names, [GREYS[body % len(GREYS)] for body in range(len(names)) for _ in range(3)])
    display.SetScalarBarVisibility(view, False)

    arrows = next((s for s in simple.GetSources().values() if s.GetXMLName() == "AbutContactView" and s.Input == contact),
                  None)
    if arrows is None:
        arrows = simple.ContactView(Input=contact)
        simple.RenameSource("contact view", arrows)
    simple.Hide(contact, view)
    over = simple.Show(arrows, view)
    _update(arrows, view)
    over.SetRepresentationType("Surface")
    if is_flat(source):  # in front of the bodies, in the same plane else
        bounds = source.GetDataInformation().GetBounds()
        over.Position = [0, 0, 1e-3 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])]
    simple.ColorBy(over, ("CELLS", "separation"))
    lut = simple.GetColorTransferFunction("separation")
    preset = _preset("separation.json")
    lut.RGBPoints, lut.ColorSpace, lut.NanColor = preset["RGBPoints"], preset["ColorSpace"], preset["NanColor"]
    rescale_around_zero(lut, *(arrows.CellData.GetArray("separation").GetRange()
                               if arrows.CellData.GetArray("separation") is not None else (-1, 1)))
    _legend(lut, view, "separation [m]")
    over.SetScalarBarVisibility(view, True)
    return arrows, lut


def rescale_around_zero(lut, low, high):
    """Makes zero the middle of a diverging map."""
    most = max(abs(low), abs(high))
    lut.RescaleTransferFunction(-most if most > 0 else -1, most if most > 0 else 1)


def run_macro(show):
    """Shows the active source with one of the functions above; errors become one text for the user."""
    try:
        view = _view(None)
        active = simple.GetActiveSource()
        source = show(active_folder(), view)[0]
        look_at(source, view)
        simple.Render(view)
        simple.SetActiveSource(source if active is None else active)
    except arrays.DataError as error:
        from vtkmodules.vtkCommonCore import vtkOutputWindow
        vtkOutputWindow.GetInstance().DisplayErrorText(f"{error}\n")
        if os.environ.get("ABUT_MACROS_RAISE"):  # tests
            raise
