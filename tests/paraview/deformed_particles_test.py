import unittest

from support import area_and_centroid, cell_array, corners, dataset, np, particles, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYGON, VTK_QUAD, VTK_TRIANGLE, vtkUnstructuredGrid
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

from abut_paraview.arrays import DataError
from abut_paraview.deformed_particles import DOMAINS, ELLIPSES, deformed_particles, is_particles


class DeformedParticles(unittest.TestCase):
    def test_areas_and_centres_of_parallelograms(self):
        data, x, r, F = particles(50, plane=True)
        output, left_out = deformed_particles(data)
        self.assertEqual((output.GetNumberOfCells(), left_out), (50, 0))
        for p in range(50):
            self.assertEqual(output.GetCellType(p), VTK_QUAD)
            area, centre = area_and_centroid(corners(output, p))
            self.assertAlmostEqual(area, np.linalg.det(F[p, :2, :2]) * 4 * r[p, 0] * r[p, 1], delta=1e-13)
            np.testing.assert_allclose(centre, x[p, :2], atol=1e-12)
            # The first edge runs along the first column of F.
            edge = corners(output, p)[1] - corners(output, p)[0]
            np.testing.assert_allclose(edge, 2 * r[p, 0] * F[p, :, 0], atol=1e-13)

    def test_volumes_of_hexahedra(self):
        data, x, r, F = particles(40, plane=False)
        output, _ = deformed_particles(data)
        size = vtkCellSizeFilter()  # positive only if VTK's order of corners is kept
        size.SetInputData(output)
        size.Update()
        volumes = cell_array(size.GetOutput(), "Volume")
        np.testing.assert_allclose(volumes, np.linalg.det(F) * 8 * r.prod(axis=1), rtol=1e-12)
        self.assertEqual(output.GetCellType(0), VTK_HEXAHEDRON)
        for p in range(40):
            np.testing.assert_allclose(corners(output, p).mean(axis=0), x[p], atol=1e-13)

    def test_ellipses_have_the_polygons_area(self):
        data, x, r, F = particles(20, plane=True)
        n = 24
        output, _ = deformed_particles(data, ELLIPSES, scale=0.8, resolution=n)
        for p in range(20):
            self.assertEqual(output.GetCellType(p), VTK_POLYGON)
            area, centre = area_and_centroid(corners(output, p))
            exact = n / 2 * np.sin(2 * np.pi / n) * np.linalg.det(F[p, :2, :2]) * r[p, 0] * r[p, 1] * 0.8**2
            self.assertAlmostEqual(area, exact, delta=1e-13)
            np.testing.assert_allclose(centre, x[p, :2], atol=1e-12)

    def test_ellipsoids_lie_on_their_quadric_and_are_closed(self):
        data, x, r, F = particles(5, plane=False)
        output, _ = deformed_particles(data, ELLIPSES, resolution=12)
        per_particle = output.GetNumberOfCells() // 5
        np.testing.assert_array_equal(cell_array(output, "body"), np.repeat([0, 1, 2, 0, 1], per_particle))
        for p in range(5):
            volume = 0
            for cell in range(p * per_particle, (p + 1) * per_particle):
                self.assertEqual(output.GetCellType(cell), VTK_TRIANGLE)
                a, b, c = corners(output, cell)
                for point in (a, b, c):
                    self.assertAlmostEqual(np.linalg.norm(np.linalg.solve(F[p], point - x[p]) / r[p]), 1, delta=1e-12)
                volume += np.dot(a - x[p], np.cross(b - x[p], c - x[p])) / 6
            # An inscribed closed surface with outward normals: a little less than the ellipsoid's volume.
            exact = 4 / 3 * np.pi * np.linalg.det(F[p]) * r[p].prod()
            self.assertTrue(0.75 * exact < volume < exact, volume / exact)

    def test_arrays_and_names_are_carried_over(self):
        data, x, r, F = particles(7, plane=True)
        output, _ = deformed_particles(data)
        self.assertEqual(output.GetCellData().GetNumberOfArrays(), data.GetPointData().GetNumberOfArrays())
        np.testing.assert_array_equal(cell_array(output, "deformation_gradient"), F.reshape(7, 9))
        self.assertEqual(cell_array(output, "body").dtype, np.int32)
        self.assertEqual(output.GetFieldData().GetAbstractArray("body_names").GetValue(2), "c")

    def test_displacement_of_the_corners_leads_back_to_the_undeformed_domain(self):
        data, x, r, F = particles(9, plane=True)
        output, _ = deformed_particles(data)
        points = vtk_to_numpy(output.GetPoints().GetData())
        undeformed = (points - vtk_to_numpy(output.GetPointData().GetArray("displacement"))).reshape(9, 4, 3)
        start = x - cell_array(output, "displacement")
        np.testing.assert_allclose(undeformed.min(axis=1), start - r, atol=1e-13)
        np.testing.assert_allclose(undeformed.max(axis=1), start + r, atol=1e-13)

    def test_particles_that_are_not_numbers_are_left_out_and_counted(self):
        data, x, r, F = particles(6, plane=True)
        vtk_to_numpy(data.GetPointData().GetArray("deformation_gradient"))[2, 0] = np.nan
        vtk_to_numpy(data.GetPoints().GetData())[4, 1] = np.inf
        output, left_out = deformed_particles(data)
        self.assertEqual((output.GetNumberOfCells(), left_out), (4, 2))
        np.testing.assert_array_equal(cell_array(output, "body"), [0, 1, 0, 2])

    def test_single_precision(self):
        data, x, r, F = particles(3, plane=True)
        single = dataset(x, {"half_size": r.astype(np.float32),
                             "deformation_gradient": F.reshape(-1, 9).astype(np.float32)}, vtkUnstructuredGrid)
        output, _ = deformed_particles(single)
        area, _ = area_and_centroid(corners(output, 0))
        self.assertAlmostEqual(area, np.linalg.det(F[0, :2, :2]) * 4 * r[0, 0] * r[0, 1], delta=1e-6)

    def test_nothing_gives_nothing(self):
        empty = dataset([], {"half_size": np.zeros((0, 3)), "deformation_gradient": np.zeros((0, 9))},
                        vtkUnstructuredGrid)
        for shape in (DOMAINS, ELLIPSES):
            output, left_out = deformed_particles(empty, shape)
            self.assertEqual((output.GetNumberOfCells(), output.GetNumberOfPoints(), left_out), (0, 0, 0))

    def test_missing_or_unfit_arrays_are_named(self):
        data, *_ = particles(3, plane=True)
        self.assertTrue(is_particles(data))
        data.GetPointData().RemoveArray("half_size")
        self.assertFalse(is_particles(data))
        with self.assertRaisesRegex(DataError, 'no point array "half_size".*deformation_gradient, body'):
            deformed_particles(data)
        unfit = dataset([[0, 0, 0]], {"half_size": [[1.0, 1.0]], "deformation_gradient": np.eye(3).reshape(1, 9)})
        with self.assertRaisesRegex(DataError, '"half_size" has 2 components, not 3'):
            deformed_particles(unfit)


if __name__ == "__main__":
    unittest.main()
