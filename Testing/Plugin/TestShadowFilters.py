"""The plugin's filters in pvbatch: on a sphere, their output is closed, and is what the properties say."""
import sys
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
RADIUS = 0.5  # of ParaView's Sphere; its facets lie a little inside
SILHOUETTE_LENGTH = 2 * numpy.pi * RADIUS
LENGTH = 3


def fetch(proxy):
    proxy.UpdatePipeline()
    data = servermanager.Fetch(proxy)
    return data, vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def corners(cells, size):
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


def unbalanced(faces):
    """Edges along which not as many triangles run one way as the other."""
    directed = numpy.concatenate((faces[:, (0, 1)], faces[:, (1, 2)], faces[:, (2, 0)]))
    edges, edge_of = numpy.unique(numpy.sort(directed, axis=1), axis=0, return_inverse=True)
    signs = numpy.where(directed[:, 0] < directed[:, 1], 1, -1)
    return int((numpy.bincount(edge_of.ravel(), weights=signs, minlength=len(edges)) != 0).sum())


class TestShadowFilters(unittest.TestCase):
    def setUp(self):
        self.sphere = simple.Sphere(Radius=RADIUS, ThetaResolution=48, PhiResolution=48)

    def test_silhouette(self):
        for light in ((1, 2, 3, 0), (2, 4, 6, 0)):
            lines, points = fetch(ShadowSilhouette(Input=self.sphere, Light=light))  # noqa: F821
            start, end = points[corners(lines.GetLines(), 2)].transpose(1, 0, 2)
            # A closed loop: what is left at an end is taken up at a beginning.
            self.assertTrue((numpy.sort(start, axis=0) == numpy.sort(end, axis=0)).all())
            length = numpy.linalg.norm(end - start, axis=1).sum()
            print(f"length: got {length}, expected {SILHOUETTE_LENGTH} to 1.5 times it: it zigzags")
            self.assertTrue(0.99 * SILHOUETTE_LENGTH < length < 1.5 * SILHOUETTE_LENGTH)

    def test_volume_is_closed(self):
        for settings in (
            dict(),
            dict(Light=(0, 0, 2, 1)),
            dict(ExtentMode="Length"),  # its default serves, though the source has not run yet
            dict(ExtentMode="Length", Length=LENGTH),
            dict(CastingFaces="All"),
            dict(Bounds=(-9, 9, -9, 9, -9, 9)),
        ):
            with self.subTest(**settings):
                volume, points = fetch(ShadowVolume(Input=self.sphere, **settings))  # noqa: F821
                faces = corners(volume.GetPolys(), 3)
                self.assertGreater(len(faces), 1000)
                print(f"edges that do not close: got {unbalanced(faces)}, expected 0, tolerance 0")
                self.assertEqual(unbalanced(faces), 0)
                a, b, c = points[faces].transpose(1, 0, 2)
                self.assertGreater((a * numpy.cross(b, c)).sum(), 0)  # wound outward
                parts = vtk_to_numpy(volume.GetCellData().GetArray("ShadowVolumePart"))
                self.assertEqual(set(parts), {0, 1, 2})
                if "Bounds" in settings:
                    self.assertLess(points[:, 2].min(), -9)

    def test_planar_shadow(self):
        light = numpy.array((1, 2, 3))
        settings = dict(Light=(*light, 0), PlaneOrigin=(0, 0, -1), PlaneNormal=(0, 0, 1))
        expected = numpy.pi * RADIUS**2 * numpy.linalg.norm(light) / light[2]
        for mode in ("Polygons", "Outline"):
            with self.subTest(mode=mode):
                shadow, points = fetch(
                    PlanarShadow(Input=self.sphere, OutputMode=mode, **settings)  # noqa: F821
                )
                self.assertTrue((abs(points[:, 2] + 1) < 1e-12).all())
                area = vtk_to_numpy(shadow.GetFieldData().GetArray("ShadowArea"))[0]
                print(f"area: got {area}, expected {expected} but for the facets, tolerance 1 %")
                self.assertAlmostEqual(area, expected, delta=0.01 * expected)
                if mode == "Polygons":
                    self.assertGreater(shadow.GetNumberOfPolys(), 1000)
                else:
                    self.assertEqual(shadow.GetNumberOfLines(), 1)
        cut, points = fetch(
            PlanarShadow(  # noqa: F821
                Input=self.sphere, Bounds=(-9, 0, -9, 9, -9, 9), ComputeArea=0, **settings
            )
        )
        self.assertLess(points[:, 0].max(), 1e-12)
        self.assertFalse(cut.GetFieldData().HasArray("ShadowArea"))

    def test_blocks_cast_one_by_one(self):
        apart = simple.Sphere(Center=(3, 0, 0), Radius=RADIUS, ThetaResolution=48, PhiResolution=48)
        alone, _ = fetch(ShadowVolume(Input=self.sphere))  # noqa: F821
        both = ShadowVolume(Input=simple.GroupDatasets(Input=[self.sphere, apart]))  # noqa: F821
        both.UpdatePipeline()
        got, expected = both.GetDataInformation().GetNumberOfCells(), 2 * alone.GetNumberOfCells()
        print(f"triangles of two blocks: got {got}, expected {expected}, tolerance 0")
        self.assertEqual(got, expected)

    def test_volume_of_a_length(self):
        volume, points = fetch(
            ShadowVolume(Input=self.sphere, ExtentMode="Length", Length=LENGTH)  # noqa: F821
        )
        a, b, c = points[corners(volume.GetPolys(), 3)].transpose(1, 0, 2)
        got, expected = (a * numpy.cross(b, c)).sum() / 6, numpy.pi * RADIUS**2 * LENGTH
        print(f"volume: got {got}, expected {expected} but for the facets, tolerance 1 %")
        self.assertAlmostEqual(got, expected, delta=0.01 * expected)


if __name__ == "__main__":
    if not unittest.main(argv=sys.argv[:1], verbosity=2, exit=False).result.wasSuccessful():
        sys.exit(1)
