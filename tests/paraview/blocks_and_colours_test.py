import json
import re
import unittest

from support import SOURCE, dataset, np, particles
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection

from abut_paraview.arrays import DataError
from abut_paraview.blocks import map_leaves
from abut_paraview.deformed_particles import deformed_particles, is_particles


class Blocks(unittest.TestCase):
    @staticmethod
    def convert(data):
        return map_leaves(data, is_particles, lambda leaf: deformed_particles(leaf)[0], "Filter", "particles")

    def test_only_particles_are_converted(self):
        for nested in (False, True):
            blocks, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
            inner.SetBlock(0, particles(4, True)[0])
            inner.SetBlock(1, dataset([[1, 2, 3]], {}))
            blocks.SetBlock(0, inner)
            blocks.GetMetaData(0).Set(blocks.NAME(), "inner")
            output = self.convert(blocks if nested else inner)
            leaves = output.GetBlock(0) if nested else output
            self.assertEqual(leaves.GetBlock(0).GetNumberOfPoints(), 16)
            self.assertEqual(leaves.GetBlock(1).GetNumberOfPoints(), 1)
            if nested:
                self.assertEqual(output.GetMetaData(0).Get(blocks.NAME()), "inner")

    def test_partitioned_collections_of_newer_readers(self):
        collection, part = vtkPartitionedDataSetCollection(), vtkPartitionedDataSet()
        part.SetPartition(0, particles(4, True)[0])
        collection.SetPartitionedDataSet(0, part)
        self.assertEqual(self.convert(collection).GetBlock(0).GetNumberOfPoints(), 16)

    def test_none_is_an_error(self):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, dataset([[1, 2, 3]], {}))
        with self.assertRaisesRegex(DataError, "Filter: no block of the input has particles"):
            self.convert(blocks)


class Colours(unittest.TestCase):
    """The colour maps are those of `abut render`."""

    source = (SOURCE / "io/render/colours.cpp").read_text(encoding="utf-8")

    def table(self, name):
        text = self.source[self.source.index(f"constexpr std::array {name}{{"):]
        codes = re.findall(r"hex\(0x([0-9a-f]{6})\)", text[:text.index("};")])
        return [np.array(list(bytes.fromhex(code))) for code in codes]

    def test_bodies(self):
        with open(SOURCE / "paraview/colour_maps/bodies.json", encoding="utf-8") as text:
            colours = np.array(json.load(text)[0]["IndexedColors"]).reshape(-1, 3) * 255
        base = self.table("body_colours")
        self.assertEqual((len(base), len(colours)), (24, 72))
        expected = base + [0.7 * c for c in base] + [0.6 * c + 0.4 * 255 for c in base]
        np.testing.assert_allclose(colours, expected, atol=0.51)

    def test_separation(self):
        with open(SOURCE / "paraview/colour_maps/separation.json", encoding="utf-8") as text:
            points = np.array(json.load(text)[0]["RGBPoints"]).reshape(-1, 4)
        expected = self.table("cool_warm")
        np.testing.assert_allclose(points[:, 0], np.linspace(-1, 1, len(expected)), atol=1e-5)
        np.testing.assert_allclose(points[:, 1:] * 255, expected, atol=0.01)


if __name__ == "__main__":
    unittest.main()
