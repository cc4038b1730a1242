"""Scenes through the real program, found through $ABUT."""
import json
import os
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from support import area_and_centroid, cell_array, corners, np, vtk_to_numpy

from abut_paraview import scene
from abut_paraview.arrays import DataError

SMALL = {
    "title": "A disk hits a block",
    "grid": {"cell": "1 mm", "lower": [0, 0], "upper": ["12 mm", "10 mm"]},
    "time": {"end": "0.4 ms"},
    "materials": {"rubber": {"model": "neo-hookean", "density": "1 g/cm^3", "youngs_modulus": "10 MPa",
                             "poissons_ratio": 0.33}},
    "bodies": [{"name": "block", "material": "rubber", "box": {"lower": ["2 mm", 0], "upper": ["10 mm", "4 mm"]}},
               {"name": "ball", "material": "rubber", "disk": {"center": ["6 mm", "6.6 mm"], "radius": "2.5 mm"},
                "velocity": ["1 m/s", "-5 m/s"]}],
    "contact": {"law": {"type": "friction", "coefficient": 0.2}},
    "boundaries": [{"name": "floor", "wall": {"axis": "y", "side": "lower", "position": 0}},
                   {"name": "press", "traction": {"body": "block", "axis": "x", "side": "lower", "pressure": "1 MPa"}}],
    "output": {"every": "0.1 ms"},
}


def leaves(blocks, prefix=""):
    """Names and data of all blocks."""
    found = {}
    for i in range(blocks.GetNumberOfBlocks()):
        name, block = prefix + blocks.GetMetaData(i).Get(blocks.NAME()), blocks.GetBlock(i)
        found.update(leaves(block, name + "/") if block.IsA("vtkMultiBlockDataSet") else {name: block})
    return found


class Scene(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "scene.json"
        self.write(SMALL)

    def write(self, content):
        self.file.write_text(json.dumps(content) if not isinstance(content, str) else content, encoding="utf-8")

    def test_bodies_boundaries_and_grid(self):
        found = leaves(scene.scene_blocks(scene.model_of(self.file)))
        self.assertEqual(set(found), {"bodies", "boundaries/floor", "boundaries/press", "grid"})
        bodies = found["bodies"]
        block = [corners(bodies, int(cell)) for cell in np.flatnonzero(cell_array(bodies, "body") == 0)]
        self.assertAlmostEqual(sum(area_and_centroid(domain)[0] for domain in block), 8e-3 * 4e-3, delta=1e-12)
        self.assertEqual(bodies.GetFieldData().GetAbstractArray("body_names").GetValue(1), "ball")
        floor = found["boundaries/floor"]
        np.testing.assert_allclose(floor.GetBounds(), [0, 12e-3, 0, 0, 0, 0], atol=1e-15)
        np.testing.assert_array_equal(cell_array(floor, "axis"), [1])
        press = found["boundaries/press"]
        np.testing.assert_allclose(press.GetBounds(), [2e-3, 2e-3, 0, 4e-3, 0, 0], atol=1e-12)
        np.testing.assert_allclose(cell_array(press, "traction"), [[1e6, 0, 0]] * press.GetNumberOfCells(), atol=1e-6)
        np.testing.assert_allclose(found["grid"].GetBounds(), [0, 12e-3, 0, 10e-3, 0, 0], atol=1e-15)
        self.assertEqual(found["grid"].GetNumberOfCells(), 4)

    def test_points_and_kinds_of_grids(self):
        model = scene.model_of(self.file)
        found = leaves(scene.scene_blocks(model, scene.POINTS, scene.LINES))
        self.assertTrue(found["bodies"].GetPointData().HasArray("half_size"))
        self.assertEqual(found["grid"].GetNumberOfCells(), 13 + 11)
        self.assertEqual(leaves(scene.scene_blocks(model, grid_as=scene.IMAGE))["grid"].GetDimensions(), (13, 11, 1))
        self.assertNotIn("grid", leaves(scene.scene_blocks(model, grid_as=scene.NO_GRID)))

    def test_scene_in_space(self):
        solid = SMALL | {"analysis": "3d", "contact": None,
                         "grid": {"cell": "1 mm", "lower": [0, 0, 0], "upper": ["4 mm", "3 mm", "2 mm"]},
                         "bodies": [{"name": "cube", "material": "rubber",
                                     "box": {"lower": [0, 0, 0], "upper": ["1 mm", "1 mm", "1 mm"]}}],
                         "boundaries": [{"name": "lid", "wall": {"axis": "z", "side": "upper", "position": "2 mm",
                                                                 "velocity": "-3 m/s"}}]}
        del solid["contact"]
        self.write(solid)
        model = scene.model_of(self.file)
        for surfaces, kind in ((True, "vtkPolygon"), (False, "vtkPolyLine")):
            lid = leaves(scene.scene_blocks(model, grid_as=scene.LINES, surfaces=surfaces))["boundaries/lid"]
            np.testing.assert_allclose(lid.GetBounds(), [0, 4e-3, 0, 3e-3, 2e-3, 2e-3], atol=1e-15)
            self.assertIn(lid.GetCell(0).GetClassName(), (kind, "vtkQuad"))
            np.testing.assert_allclose(cell_array(lid, "velocity"), [[0, 0, -3]])
        # Lines on the six sides: along x 2 (4 + 3) - 4 of the 4 x 3 lattice points of the section, and so on.
        lines = scene.grid_lines(model[2])
        self.assertEqual(lines.GetNumberOfCells(), (2 * (4 + 3) - 4) + (2 * (5 + 3) - 4) + (2 * (5 + 4) - 4))
        self.assertEqual(scene.grid_outline(model[2]).GetNumberOfCells(), 12)

    def test_what_the_program_says_is_the_error(self):
        self.write(SMALL | {"bodies": [dict(SMALL["bodies"][0], material="ruber")]})
        with self.assertRaisesRegex(DataError, 'no material "ruber"; did you mean "rubber"'):
            scene.model_of(self.file)
        self.write("{")
        with self.assertRaisesRegex(DataError, "scene.json"):
            scene.model_of(self.file)
        with self.assertRaisesRegex(DataError, "no such file"):
            scene.model_of(self.file.with_name("nothing.json"))

    def test_the_program_is_looked_for(self):
        self.assertEqual(scene.find_program(), os.environ["ABUT"])
        with self.assertRaisesRegex(DataError, 'the property Program is "/no/abut"'):
            scene.find_program("/no/abut")
        with mock.patch.dict(os.environ, {"ABUT": "/no/where", "PATH": ""}):
            with self.assertRaisesRegex(DataError, r"\$ABUT is"):
                scene.find_program()

    def test_the_model_is_kept_until_the_scene_changes(self):
        cache = scene.SceneCache()
        first = cache.model(self.file)
        self.assertIs(cache.model(self.file), first)
        changed = SMALL | {"bodies": SMALL["bodies"][:1], "contact": {}}
        del changed["contact"]
        self.write(changed)
        later = time.time() + 10
        os.utime(self.file, (later, later))
        second = cache.model(self.file)
        self.assertLess(second[0].GetNumberOfPoints(), first[0].GetNumberOfPoints())
        cache.clear()
        self.assertIsNot(cache.model(self.file), second)


if __name__ == "__main__":
    unittest.main()
