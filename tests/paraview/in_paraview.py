"""The plugin, the macros and render_series.py in the real ParaView; run it through paraview.sh.

Everything is tried on results that abut makes here. Pictures are kept in a folder if one is named.
"""
import inspect

inspect.getargspec = inspect.getfullargspec  # ParaView 5.11 with Python 3.11
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkIOImage import vtkPNGReader
import numpy as np

SCENE = {
    "title": "A disk hits a block",
    "grid": {"cell": "1 mm", "lower": [0, 0], "upper": ["12 mm", "12 mm"]},
    "time": {"end": "0.12 ms"},
    "method": {"shape": "ugimp", "transfer": {"scheme": "xpic", "order": 2}},
    "materials": {"rubber": {"model": "neo-hookean", "density": "1 g/cm^3", "youngs_modulus": "10 MPa",
                             "poissons_ratio": 0.33}},
    "bodies": [{"name": "block", "material": "rubber", "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "4 mm"]}},
               {"name": "ball", "material": "rubber", "disk": {"center": ["6 mm", "6.55 mm"], "radius": "2.5 mm"},
                "velocity": ["1 m/s", "-5 m/s"]}],
    "contact": {"law": {"type": "friction", "coefficient": 0.2}},
    "boundaries": [{"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}}],
    "output": {"every": "0.03 ms", "history_every": "10 us"},
}


def data_of(source, time=None):
    source.UpdatePipeline() if time is None else source.UpdatePipeline(time)
    return source.GetClientSideObject().GetOutputDataObject(0)


class InParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.pictures = Path(sys.argv[1]) if len(sys.argv) > 1 else cls.folder / "pictures"
        cls.pictures.mkdir(exist_ok=True)
        (cls.folder / "scene.json").write_text(json.dumps(SCENE), encoding="utf-8")
        subprocess.run([os.environ["ABUT"], "run", "scene.json", "-o", "results", "--quiet", "--threads", "1"],
                       cwd=cls.folder, check=True)
        cls.results = cls.folder / "results"
        simple.LoadPlugin(str(SOURCE / "paraview/plugin/abut_plugin.py"), remote=False, ns=vars(simple))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def tearDown(self):
        simple.ResetSession()

    def open(self, name):
        return simple.OpenDataFile(str(self.results / name))

    def picture(self, view, name):
        """A screenshot as rows of r g b; it must not be blank."""
        file = self.pictures / f"{name}.png"
        simple.SaveScreenshot(str(file), view, ImageResolution=[600, 450])
        return self.shows_something(file)

    def shows_something(self, file):
        reader = vtkPNGReader()
        reader.SetFileName(str(file))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3]
        self.assertGreater(np.any(pixels != pixels[0], axis=1).mean(), 0.05, f"{file}: next to nothing is drawn")
        self.assertGreater(len(np.unique(pixels, axis=0)), 20, file)
        return pixels

    # === Our files in ParaView's own filters

    def test_series_have_the_physical_time(self):
        for name in ("particles", "grid", "contact"):
            times = list(self.open(f"{name}.pvd").TimestepValues)
            self.assertEqual((len(times), times[0], times[-1]), (5, 0, 0.12e-3), name)
            self.assertTrue(all(0 <= time - 3e-5 * i < 5e-6 for i, time in enumerate(times[:-1])), times)

    def test_own_filters_work_at_once(self):
        particles = self.open("particles.pvd")
        end = particles.TimestepValues[-1]
        start = data_of(particles, 0.0)
        start_points, count = vtk_to_numpy(start.GetPoints().GetData()).copy(), start.GetNumberOfPoints()
        self.assertEqual(start.GetFieldData().GetAbstractArray("body_names").GetValue(1), "ball")

        warped = data_of(simple.WarpByVector(Input=particles, Vectors=["POINTS", "displacement"], ScaleFactor=-1), end)
        np.testing.assert_allclose(vtk_to_numpy(warped.GetPoints().GetData()), start_points, atol=1e-9)
        ball = simple.Threshold(Input=particles, Scalars=["POINTS", "body"], LowerThreshold=1, UpperThreshold=1)
        of_body = vtk_to_numpy(start.GetPointData().GetArray("body"))
        self.assertEqual(data_of(ball, end).GetNumberOfPoints(), np.count_nonzero(of_body == 1))
        glyphs = simple.Glyph(Input=particles, GlyphType="Arrow", OrientationArray=["POINTS", "velocity"],
                              ScaleArray=["POINTS", "velocity"], ScaleFactor=1e-4, GlyphMode="All Points")
        self.assertGreater(data_of(glyphs, end).GetNumberOfPoints(), 10 * count)
        tensors = simple.TensorGlyph(Input=particles, Tensors=["POINTS", "stress"], ScaleFactor=1e-9)
        self.assertGreater(data_of(tensors, end).GetNumberOfPoints(), 10 * count)

    def test_particles_are_traced_by_their_id(self):
        particles = self.open("particles.pvd")
        paths = simple.TemporalParticlesToPathlines(Input=particles, Selection=None, IdChannelArray="id",
                                                    MaskPoints=1, MaxTrackLength=10, MaxStepDistance=[1, 1, 1])
        for time in particles.TimestepValues:
            lines = data_of(paths, time)
        count = data_of(particles).GetNumberOfPoints()
        self.assertEqual(lines.GetNumberOfLines(), count)
        self.assertEqual(lines.GetNumberOfPoints(), 5 * count)

    def test_a_growing_series_is_reloaded(self):
        grown = self.folder / "growing"
        grown.mkdir()
        whole = (self.results / "particles.pvd").read_text(encoding="utf-8").replace('file="', f'file="{self.results}/')
        lines = [line for line in whole.splitlines() if "<DataSet" in line]
        (grown / "particles.pvd").write_text(whole.replace(lines[3], "").replace(lines[4], ""), encoding="utf-8")
        particles = simple.OpenDataFile(str(grown / "particles.pvd"))
        self.assertEqual(len(particles.TimestepValues), 3)
        (grown / "particles.pvd").write_text(whole, encoding="utf-8")
        simple.ReloadFiles(particles)
        particles.UpdatePipelineInformation()
        self.assertEqual(len(particles.TimestepValues), 5)

    # === Plugin

    def test_deformed_particles(self):
        particles = self.open("particles.pvd")
        end = particles.TimestepValues[-1]
        count = data_of(particles, end).GetNumberOfPoints()
        domains = simple.DeformedParticles(Input=particles)
        self.assertEqual(data_of(domains, end).GetNumberOfCells(), count)
        domains.Shape = "ellipses"
        domains.Resolution = 9
        self.assertEqual(data_of(domains, end).GetNumberOfPoints(), 9 * count)
        moved = data_of(domains, end).GetBounds()
        self.assertNotEqual(moved, data_of(domains, 0.0).GetBounds())

    def test_contact_view(self):
        contact = self.open("contact.pvd")
        end = contact.TimestepValues[-1]
        arrows = simple.ContactView(Input=contact)
        touching = np.count_nonzero(vtk_to_numpy(data_of(contact, end).GetPointData().GetArray("in_contact")))
        self.assertGreater(touching, 2)
        self.assertEqual(data_of(arrows, end).GetNumberOfCells(), 2 * touching)
        arrows.OnlyInContact, arrows.ScaleBy, arrows.Bodies = 0, "fixed length", "ball"
        self.assertEqual(data_of(arrows, end).GetNumberOfCells(), 2 * data_of(contact, end).GetNumberOfPoints())

    def test_wrong_input_gives_an_empty_output_and_one_message(self):
        contact = self.open("contact.pvd")
        wrong = simple.DeformedParticles(Input=contact)
        said = []

        def listen(window, event, text=""):
            said.append(text)

        listen.CallDataType = "string0"
        observer = vtkOutputWindow.GetInstance().AddObserver("ErrorEvent", listen)
        self.assertEqual(data_of(wrong, 0.0).GetNumberOfCells(), 0)
        vtkOutputWindow.GetInstance().RemoveObserver(observer)
        self.assertEqual(len(said), 1, said)
        self.assertIn('no point array "half_size"', said[0])

    def test_scene_source(self):
        scene = simple.OpenDataFile(str(self.folder / "scene.json"))
        self.assertEqual(scene.GetXMLName(), "AbutScene")
        blocks = data_of(scene)
        self.assertEqual([blocks.GetMetaData(i).Get(blocks.NAME()) for i in range(3)], ["bodies", "boundaries", "grid"])
        scene.Particles, scene.Grid = "points", "none"
        self.assertEqual(data_of(scene).GetNumberOfBlocks(), 2)
        self.assertTrue(data_of(scene).GetBlock(0).GetPointData().HasArray("half_size"))
        domains = simple.DeformedParticles(Input=scene)
        particles = data_of(scene).GetBlock(0).GetNumberOfPoints()
        self.assertEqual(data_of(domains).GetBlock(0).GetNumberOfCells(), particles)

    def test_colour_maps_are_imported(self):
        for file, name in (("bodies", "abut bodies"), ("separation", "abut separation")):
            simple.ImportPresets(str(SOURCE / f"paraview/colour_maps/{file}.json"))
            self.assertTrue(simple.GetColorTransferFunction(file).ApplyPreset(name, True), name)
        lut = simple.GetColorTransferFunction("bodies")
        self.assertEqual(len(lut.IndexedColors), 72 * 3)
        self.assertEqual(len(simple.GetColorTransferFunction("separation").RGBPoints), 9 * 4)

    # === Macros and the script

    def run_macro(self, name, file):
        view = simple.CreateView("RenderView")
        view.ViewSize = [600, 450]
        simple.SetActiveSource(simple.OpenDataFile(str(file)))
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        simple.GetAnimationScene().GoToLast()
        macro = SOURCE / "paraview/macros" / f"{name}.py"
        exec(compile(macro.read_text(encoding="utf-8"), str(macro), "exec"), {})
        return view

    def test_macros(self):
        for name in ("show_bodies", "show_stress", "show_contact"):
            for opened in ("particles.pvd", "contact.pvd"):
                pixels = self.picture(self.run_macro(name, self.results / opened), f"{name}-{opened[:-4]}")
                if name == "show_bodies":  # exactly the colours of `abut render`
                    for colour in ((0x3B, 0x6F, 0xB6), (0xE8, 0x86, 0x2D)):
                        self.assertGreater(np.all(pixels == colour, axis=1).mean(), 0.02)
                simple.ResetSession()

    def test_macro_on_a_scene(self):
        self.picture(self.run_macro("show_bodies", self.folder / "scene.json"), "show_bodies-scene")
        with self.assertRaisesRegex(Exception, "no contact pairs yet"):
            self.run_macro("show_contact", self.folder / "scene.json")

    def render(self, *arguments):
        return subprocess.run(["pvbatch", str(SOURCE / "paraview/render_series.py"), *map(str, arguments)], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_render_series(self):
        outcome = self.render(self.results, "-o", self.pictures / "series", "--preset", "contact", "--size", "400x300")
        self.assertEqual(outcome.returncode, 0, outcome.stdout)
        self.assertEqual(sorted(file.name for file in (self.pictures / "series").iterdir()),
                         [f"contact_{i:05d}.png" for i in range(5)])
        for file in (self.pictures / "series").iterdir():
            self.shows_something(file)

    def test_render_series_of_nothing(self):
        (self.folder / "empty").mkdir()
        outcome = self.render(self.folder / "empty", "-o", self.folder / "none")
        self.assertNotEqual(outcome.returncode, 0)
        self.assertIn("has no particles.pvd, so it is no result folder of abut", outcome.stdout)
        self.assertFalse((self.folder / "none").exists())


outcome = unittest.main(argv=["in_paraview"], exit=False, verbosity=2).result
sys.stdout.flush()
os._exit(0 if outcome.wasSuccessful() else 1)  # ParaView's own shutdown is none of our business
