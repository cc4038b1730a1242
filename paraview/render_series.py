"""Renders a result folder of abut to PNG pictures, one for each frame of its particles.

    pvbatch render_series.py RESULTS -o FOLDER [--preset bodies|stress|contact] [--size 1200x900] [--last]

Camera and colours are the same in all pictures. Where ParaView is built for X only, as Debian's is, a display is
needed: xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvbatch render_series.py ...
"""

import argparse
import inspect
import os
import re
import sys
from pathlib import Path

if not hasattr(inspect, "getargspec"):  # ParaView up to 5.11 wants it, Python from 3.11 on has it no longer
    inspect.getargspec = inspect.getfullargspec

HERE = Path(__file__).resolve().parent


def arguments():
    parser = argparse.ArgumentParser(prog="render_series.py", description=__doc__.splitlines()[0])
    parser.add_argument("results", metavar="RESULTS", type=Path, help="result folder of abut run")
    parser.add_argument("-o", "--output", metavar="FOLDER", type=Path, required=True, help="where the pictures go")
    parser.add_argument("--preset", choices=["bodies", "stress", "contact"], default="bodies")
    parser.add_argument("--size", metavar="WIDTHxHEIGHT", default="1200x900", help="of the pictures [pixels]")
    parser.add_argument("--last", action="store_true", help="only the last frame")
    chosen = parser.parse_args()
    size = re.fullmatch(r"(\d{2,5})x(\d{2,5})", chosen.size)
    if not size:
        parser.error(f'--size {chosen.size}: give two numbers, e.g. "1200x900"')
    chosen.size = [int(size[1]), int(size[2])]
    if not chosen.results.is_dir():
        parser.error(f"{chosen.results}: no such folder")
    if not (chosen.results / "particles.pvd").is_file():
        parser.error(f"{chosen.results}: has no particles.pvd, so it is no result folder of abut")
    return chosen


def check_display():
    """Debian's ParaView ends with an abort where there is no display; this says why."""
    from vtkmodules.vtkRenderingCore import vtkRenderWindow
    import vtkmodules.vtkRenderingOpenGL2  # makes the kind of window known

    if vtkRenderWindow().GetClassName().startswith("vtkX") and not os.environ.get("DISPLAY"):
        sys.exit('render_series.py: this ParaView needs a display, and there is none: xvfb-run -a -s '
                 '"-screen 0 1280x1024x24 -noreset" pvbatch render_series.py ...')


def union(a, b):
    """Of two ranges (low, high, low, high ...), of which either may be None."""
    if a is None or b is None:
        return a or b
    return [(min, max)[i % 2](x, y) for i, (x, y) in enumerate(zip(a, b))]


def main():
    chosen = arguments()
    try:
        import paraview
    except ImportError:
        sys.exit("render_series.py: no Python module paraview here; run it with pvbatch, and on Debian with the "
                 "package python3-paraview (or with the folder that .ci/paraview.sh names on PYTHONPATH)")
    check_display()
    from paraview import simple

    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(str(HERE / "plugin" / "abut_plugin.py"), remote=False, ns=vars(simple))
    from abut_paraview import arrays, sources, views

    view = simple.CreateView("RenderView")
    view.ViewSize = chosen.size
    try:
        particles = sources.series(chosen.results, "particles")
        times = list(particles.TimestepValues)
        if not times:
            raise arrays.DataError(f"{chosen.results}: particles.pvd has no frames")
        times = times[-1:] if chosen.last else times
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        view.ViewTime = times[-1]
        _, source, lut = getattr(views, f"show_{chosen.preset}")(chosen.results, view)
        array = {"bodies": None, "stress": "von_mises_stress", "contact": "separation"}[chosen.preset]

        bounds = values = None
        for time in times:
            particles.UpdatePipeline(time)
            box = particles.GetDataInformation().GetBounds()
            bounds = union(bounds, box if box[0] <= box[1] else None)
            if array:
                source.UpdatePipeline(time)
                values = union(values, sources.range_of(source, array))
        if values and array == "separation":
            views.rescale_around_zero(lut, *values)
        elif values:
            lut.RescaleTransferFunction(*values)

        label = simple.AnnotateTimeFilter(Input=particles, Format="t = {time:.4g} s")
        text = simple.Show(label, view)
        text.Color, text.FontSize, text.WindowLocation = [0, 0, 0], 18, "Upper Left Corner"
        views.look_at(particles, view, bounds)
        view.OrientationAxesVisibility = 0 if views.is_flat(particles) else 1

        chosen.output.mkdir(parents=True, exist_ok=True)
        first = len(particles.TimestepValues) - len(times)
        for number, time in enumerate(times, start=first):
            view.ViewTime = time
            simple.Render(view)
            picture = chosen.output / f"{chosen.preset}_{number:05d}.png"
            if not simple.SaveScreenshot(str(picture), view, ImageResolution=chosen.size):
                raise OSError(f"{picture}: cannot be written")
        print(f"{len(times)} pictures in {chosen.output}")
    except (arrays.DataError, OSError) as error:
        sys.exit(f"render_series.py: {error}")


main()
