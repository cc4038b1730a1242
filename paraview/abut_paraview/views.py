"""Views of results in ParaView: what the macros and render_series.py show. Needs ParaView and the plugin loaded.

Each show_... shows a result folder in a render view and returns the deformed particles, the source that is coloured and
the colour map. The folder is that of the active source: any series of the
folder, or a filter after one. The folder's other series are opened as they are needed.
"""

import json
import os
from pathlib import Path

from paraview import simple

from . import arrays
from .sources import active_folder, field_words, filter_after, range_of, series

COLOUR_MAPS = Path(__file__).resolve().parents[1] / "colour_maps"
MOST_IN_LEGEND = 30
LEGEND_WIDTH = 0.2  # of the picture's width
VIEWED_FROM, UP = [0.408, -0.802, 0.435], [0, 0, 1]  # of scenes in space, as `abut render` sees them
SOLID_OPACITY = 0.06  # of bodies in space around arrows; every particle on the line of sight counts
SEEN_SCALE = 1.01  # of domains: neighbours overlap by a hair, so that no white pixels show between them
GREYS = [0.88, 0.82, 0.93, 0.85]  # of neighbouring bodies behind arrows


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
    bar.HorizontalTitle = 1
    if lut.InterpretValuesAsCategories:
        count = len(lut.Annotations) // 2
        bar.WindowLocation = "Any Location"
        bar.ScalarBarLength = min(0.9, 0.035 * count)
        bar.Position = [1 - 0.7 * LEGEND_WIDTH, 0.95 - bar.ScalarBarLength]
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
        source = filter_after(particles, "AbutDeformedParticles", "deformed particles", Scale=SEEN_SCALE)
        simple.Hide(particles, view)
    display = simple.Show(source, view)
    display.SetRepresentationType("Surface")
    display.Opacity = 1
    display.AmbientColor = display.DiffuseColor = [0.35, 0.35, 0.35]  # of what has no body: boundaries, grid
    display.LineWidth = 2
    return source, display


def is_flat(source):
    """Whether all of a source lies in a plane z = constant."""
    bounds = source.GetDataInformation().GetBounds()
    return bounds[4] >= bounds[5]


def look_at(source, view, bounds=None):
    """Fits the view to a source, or to bounds; plane scenes are seen from above, and beside the legend."""
    bounds = bounds or source.GetDataInformation().GetBounds()
    if bounds[0] > bounds[1]:
        return
    if bounds[4] < bounds[5]:
        view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [0, 0, 0], VIEWED_FROM, UP
        margin = [0.1 * (bounds[axis + 1] - bounds[axis]) for axis in (0, 2, 4)]  # particles end beyond their centres
        view.ResetCamera(*[edge + (-1, 1)[i % 2] * margin[i // 2] for i, edge in enumerate(bounds)])
        return
    view.InteractionMode = "2D"
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    aspect = view.ViewSize[0] / view.ViewSize[1]
    half = 0.54 * max(height, width / (aspect * (1 - LEGEND_WIDTH)), 1e-300)
    x, y = (bounds[0] + bounds[1]) / 2 + LEGEND_WIDTH * half * aspect, (bounds[2] + bounds[3]) / 2
    view.CameraParallelProjection = 1
    view.CameraFocalPoint, view.CameraPosition = [x, y, bounds[4]], [x, y, bounds[4] + 4 * half]
    view.CameraViewUp, view.CameraParallelScale = [0, 1, 0], half


def _unshaded(source, display):
    """Plane scenes need no light: colours are then exactly those of the map."""
    if is_flat(source):
        display.Ambient, display.Diffuse, display.Specular = 1, 0, 0


def _update(source, view):
    source.UpdatePipeline(view.ViewTime)  # simple.UpdatePipeline() takes time 0 for none


def show_bodies(folder=None, view=None):
    """Deformed particles in the colours of their bodies, with the bodies' names in the legend."""
    view = _view(view)
    source, display = _domains(folder, view)
    _update(source, view)
    _unshaded(source, display)
    names = field_words(source, "body_names")
    lut = _categories(display, names, body_colours(len(names)))
    _legend(lut, view, "body")
    display.SetScalarBarVisibility(view, len(names) <= MOST_IN_LEGEND)
    return source, source, lut


def show_stress(folder=None, view=None, array="von_mises_stress", title="von Mises stress [Pa]"):
    """Deformed particles coloured by a scalar of theirs."""
    view = _view(view)
    source, display = _domains(folder, view)
    _update(source, view)
    _unshaded(source, display)
    if source.CellData.GetArray(array) is None:
        raise arrays.DataError(f'the particles have no array "{array}"'
                               f"{arrays.did_you_mean(array, list(source.CellData.keys()))}")
    simple.ColorBy(display, ("CELLS", array))
    lut = simple.GetColorTransferFunction(array)
    lut.ApplyPreset("Viridis (matplotlib)", True)
    lut.RescaleTransferFunction(*(range_of(source, array) or (0, 1)))
    _legend(lut, view, title)
    display.SetScalarBarVisibility(view, True)
    return source, source, lut


def show_contact(folder, view=None):
    """Arrows at contact pairs, scaled by force and coloured by separation, over the bodies in greys."""
    if folder is None:
        raise arrays.DataError("abut: a scene has no contact pairs yet; open contact.pvd of its results")
    view = _view(view)
    contact = series(folder, "contact")
    source, display = _domains(folder, view)
    _update(source, view)
    _unshaded(source, display)
    display.UseSeparateColorMap = 1
    names = field_words(source, "body_names")
    _categories(display, names, [GREYS[body % len(GREYS)] for body in range(len(names)) for _ in range(3)])
    display.SetScalarBarVisibility(view, False)

    arrows = filter_after(contact, "AbutContactView", "contact view")
    simple.Hide(contact, view)
    over = simple.Show(arrows, view)
    _update(arrows, view)
    over.SetRepresentationType("Surface")
    if not is_flat(source):
        display.Opacity = SOLID_OPACITY
    else:  # in front of the bodies, in the same plane otherwise
        bounds = source.GetDataInformation().GetBounds()
        _unshaded(source, over)
        over.Position = [0, 0, 1e-3 * max(bounds[1] - bounds[0], bounds[3] - bounds[2])]
    simple.ColorBy(over, ("CELLS", "separation"))
    lut = simple.GetColorTransferFunction("separation")
    preset = _preset("separation.json")
    lut.RGBPoints, lut.ColorSpace, lut.NanColor = preset["RGBPoints"], preset["ColorSpace"], preset["NanColor"]
    rescale_around_zero(lut, *(range_of(arrows, "separation") or (-1, 1)))
    _legend(lut, view, "separation [m]")
    over.SetScalarBarVisibility(view, True)
    return source, arrows, lut


def rescale_around_zero(lut, low, high):
    """Makes zero the middle of a diverging map."""
    most = max(abs(low), abs(high))
    lut.RescaleTransferFunction(-most if most > 0 else -1, most if most > 0 else 1)


def run_macro(show):
    """Shows the active source with one of the functions above; errors become one text for the user."""
    try:
        view = _view(None)
        active = simple.GetActiveSource()
        look_at(show(active_folder(), view)[0], view)
        simple.Render(view)
        simple.SetActiveSource(active)
    except arrays.DataError as error:
        from vtkmodules.vtkCommonCore import vtkOutputWindow
        vtkOutputWindow.GetInstance().DisplayErrorText(f"{error}\n")
        if os.environ.get("ABUT_MACROS_RAISE"):  # tests
            raise
