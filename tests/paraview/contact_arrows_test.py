import unittest

from support import cell_array, corners, dataset, np

from abut_paraview.arrays import DataError
from abut_paraview.contact_arrows import BY_AREA, BY_FORCE, FIXED, FORCE, NORMAL, contact_arrows, spacing_of


def pairs(space=False):
    """Four pairs on a grid of spacing 0.5, the last not in contact."""
    normal = np.array([[1.0, 0, 0], [0, 1, 0], [-0.6, 0.8, 0], [0, -1, 0]])
    points = np.array([[0.0, 0, 0], [0.5, 0, 0], [0.5, 1, 0], [2, 1, 0]])
    if space:
        points[3, 2], normal[2] = 0.5, [0, 0.6, 0.8]
    magnitude = np.array([10.0, 5, 2.5, 0])
    return dataset(points, {"normal": normal, "force": -magnitude[:, None] * normal, "area": [0.1, 0.2, 0.4, 0.2],
                            "separation": [-1e-3, -2e-3, 0, 3e-3], "in_contact": np.array([1, 1, 1, 0], np.int32),
                            "body_a": np.array([0, 0, 1, 0], np.int32), "body_b": np.array([1, 2, 2, 3], np.int32)},
                   body_names=["a", "b", "c", "ball 1"]), points, normal


def arrows_of(output, points, cells_each):
    """Start and end of each arrow."""
    count = output.GetNumberOfCells() // cells_each
    result = []
    for arrow in range(count):
        own = np.concatenate([corners(output, cell) for cell in range(arrow * cells_each, (arrow + 1) * cells_each)])
        start = points[arrow]
        distance = np.linalg.norm(own - start, axis=1)
        result.append((start, own[distance.argmax()]))
    return result


class ContactArrows(unittest.TestCase):
    def test_directions_and_lengths_by_force(self):
        data, points, normal = pairs()
        output, left_out = contact_arrows(data, BY_FORCE, length=2)
        self.assertEqual((output.GetNumberOfCells(), left_out), (2 * 3, 0))  # shaft and head each
        for (start, end), n, length in zip(arrows_of(output, points, 2), normal, (1, 0.5, 0.25)):
            np.testing.assert_allclose(end - start, length * n, atol=1e-12)
        for cell in range(output.GetNumberOfCells()):
            np.testing.assert_array_equal(corners(output, cell)[:, 2], 0)

    def test_lengths_by_area_fixed_and_with_a_reference(self):
        data, points, normal = pairs()
        lengths = {BY_AREA: (0.25, 0.5, 1.0, 0.5), FIXED: (1, 1, 1, 1)}
        for scale_by, expected in lengths.items():
            output, _ = contact_arrows(data, scale_by, length=2, only_in_contact=False)
            for (start, end), n, length in zip(arrows_of(output, points, 2), normal, expected):
                np.testing.assert_allclose(end - start, length * n, atol=1e-12)
        output, _ = contact_arrows(data, BY_FORCE, length=2, reference=20, spacing=3)
        start, end = arrows_of(output, points, 2)[0]
        np.testing.assert_allclose(end - start, 2 * 3 * 10 / 20 * normal[0], atol=1e-12)

    def test_along_the_force(self):
        data, points, normal = pairs()
        output, _ = contact_arrows(data, FIXED, length=2, direction=FORCE, only_in_contact=False)
        self.assertEqual(output.GetNumberOfCells(), 2 * 3)  # no force, no direction
        for (start, end), n in zip(arrows_of(output, points, 2), normal):
            np.testing.assert_allclose(end - start, -n, atol=1e-12)

    def test_solid_arrows_in_space(self):
        data, points, normal = pairs(space=True)
        output, _ = contact_arrows(data, FIXED, length=2, only_in_contact=False)
        each = output.GetNumberOfCells() // 4
        for (start, end), n in zip(arrows_of(output, points, each), normal):
            np.testing.assert_allclose(end - start, n, atol=1e-6)  # VTK's arrow is in single precision

    def test_arrays_are_carried_to_the_arrows(self):
        data, *_ = pairs()
        output, _ = contact_arrows(data)
        names = {data.GetPointData().GetArrayName(i) for i in range(data.GetPointData().GetNumberOfArrays())}
        for attributes in (output.GetPointData(), output.GetCellData()):
            self.assertEqual({attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}, names)
        np.testing.assert_array_equal(cell_array(output, "separation"), np.repeat([-1e-3, -2e-3, 0], 2))
        np.testing.assert_array_equal(cell_array(output, "body_b"), np.repeat([1, 2, 2], 2))
        self.assertEqual(output.GetPointData().GetArray("separation").GetNumberOfTuples(), output.GetNumberOfPoints())
        self.assertEqual(output.GetFieldData().GetAbstractArray("body_names").GetNumberOfValues(), 4)

    def test_choice_of_bodies(self):
        data, *_ = pairs()
        for bodies, count in (("c", 2), ("a", 2), ("a, b", 3), ("1", 2), ("", 3), ("ball 1", 0)):
            self.assertEqual(contact_arrows(data, bodies=bodies)[0].GetNumberOfCells(), 2 * count, bodies)
        self.assertEqual(contact_arrows(data, FIXED, bodies="ball 1", only_in_contact=False)[0].GetNumberOfCells(), 2)
        with self.assertRaisesRegex(DataError, 'no body "bal 1"; did you mean "ball 1"'):
            contact_arrows(data, bodies="bal 1")
        with self.assertRaisesRegex(DataError, 'no body "7"'):
            contact_arrows(data, bodies="7")

    def test_pairs_that_are_not_numbers_are_left_out_and_counted(self):
        data, points, normal = pairs()
        data.GetPointData().GetArray("normal").SetComponent(0, 1, np.nan)
        data.GetPointData().GetArray("force").SetComponent(1, 0, np.inf)
        output, left_out = contact_arrows(data, length=2)
        self.assertEqual((output.GetNumberOfCells(), left_out), (2, 2))
        start, end = arrows_of(output, points[2:], 2)[0]
        np.testing.assert_allclose(end - start, normal[2], atol=1e-12)  # now the longest

    def test_nothing_gives_nothing(self):
        data, *_ = pairs()
        empty = dataset([], {name: np.zeros((0, 3)) for name in ("normal", "force")} | {"in_contact": np.zeros(0)})
        output, _ = contact_arrows(empty)
        self.assertEqual(output.GetNumberOfCells(), 0)
        self.assertTrue(output.GetCellData().HasArray("normal") and output.GetPointData().HasArray("normal"))
        for i in range(4):  # before the first step
            data.GetPointData().GetArray("force").SetTuple3(i, 0, 0, 0)
        self.assertEqual(contact_arrows(data)[0].GetNumberOfCells(), 0)
        self.assertEqual(contact_arrows(data, FIXED)[0].GetNumberOfCells(), 2 * 3)

    def test_one_pair_has_a_spacing_too(self):
        one = dataset([[3, 4, 0]], {"normal": [[0.0, 1, 0]], "area": [0.25]})
        output, _ = contact_arrows(one, FIXED, length=2, only_in_contact=False)
        start, end = arrows_of(output, np.array([[3, 4, 0]]), 2)[0]
        np.testing.assert_allclose(end - start, [0, 0.5, 0], atol=1e-12)

    def test_missing_arrays_are_named(self):
        for needed in ("normal", "force", "in_contact"):
            data, *_ = pairs()
            data.GetPointData().RemoveArray(needed)
            with self.assertRaisesRegex(DataError, f'no point array "{needed}"'):
                contact_arrows(data)

    def test_spacing_is_that_of_the_grid(self):
        random = np.random.default_rng(2)
        nodes = random.integers(0, 200, (300, 3)) * 14.3e-6 + [1e-3, -5, 7]
        self.assertAlmostEqual(spacing_of(nodes), 14.3e-6, delta=1e-11)
        self.assertIsNone(spacing_of(np.ones((4, 3))))
        self.assertIsNone(spacing_of(np.zeros((0, 3))))


if __name__ == "__main__":
    unittest.main()
