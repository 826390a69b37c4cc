"""Silhouettes, shadow volumes and planar shadows in a pipeline, without any rendering."""
import unittest

import numpy
import vtkshadows
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkFiltersSources import vtkCubeSource

TOWARD = numpy.array([0.3, -0.5, 0.8]) / numpy.linalg.norm([0.3, -0.5, 0.8])
# A cube of side 2 seen along TOWARD.
AREA = 4 * numpy.abs(TOWARD).sum()


def array(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def corners(cells, size):
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


class TestFilters(unittest.TestCase):
    def setUp(self):
        self.cube = vtkCubeSource()
        self.cube.SetXLength(2)
        self.cube.SetYLength(2)
        self.cube.SetZLength(2)

    def run_filter(self, kind, **settings):
        shadow = kind()
        shadow.SetInputConnection(self.cube.GetOutputPort())
        shadow.SetLightDirection(*-TOWARD)
        for name, value in settings.items():
            getattr(shadow, f"Set{name}")(value)
        shadow.Update()
        return shadow, shadow.GetOutput()

    def test_silhouette(self):
        _, lines = self.run_filter(vtkshadows.vtkShadowSilhouetteFilter)
        points = vtk_to_numpy(lines.GetPoints().GetData())
        ends = corners(lines.GetLines(), 2)
        self.assertEqual(ends.shape, (6, 2))
        area = 0.5 * (numpy.cross(points[ends[:, 0]], points[ends[:, 1]]) @ TOWARD).sum()
        print(f"area: got {area}, expected {AREA}, tolerance 1e-6")
        self.assertAlmostEqual(area, AREA, delta=1e-6)
        # vtkCubeSource's faces have points of their own: welding makes neighbours of them.
        self.assertTrue((array(lines.GetCellData(), "OriginalCellId1") >= 0).all())
        self.assertEqual(set(abs(array(lines.GetCellData(), "SignedMultiplicity"))), {1})

    def test_volume(self):
        kind = vtkshadows.vtkShadowVolumeFilter
        _, volume = self.run_filter(kind, ExtentMode=kind.LENGTH_EXTENT, Length=2.5)
        points = vtk_to_numpy(volume.GetPoints().GetData())
        self.assertEqual(points.dtype, numpy.float64)
        a, b, c = points[corners(volume.GetPolys(), 3)].transpose(1, 0, 2)
        got = (a * numpy.cross(b, c)).sum() / 6
        print(f"volume: got {got}, expected {2.5 * AREA}, tolerance 1e-9")
        self.assertAlmostEqual(got, 2.5 * AREA, delta=1e-9)
        parts = array(volume.GetCellData(), "ShadowVolumePart")
        self.assertEqual([int((parts == part).sum()) for part in range(3)], [6, 12, 6])
        self.assertEqual(kind.FAR_CAP, 2)

    def test_planar_shadow(self):
        kind = vtkshadows.vtkPlanarShadowFilter
        settings = dict(PlaneOrigin=(0, 0, -2), PlaneNormal=(0, 0, -3))
        shadow, flat = self.run_filter(kind, **settings)
        points = vtk_to_numpy(flat.GetPoints().GetData())
        self.assertEqual(points.dtype, numpy.float64)
        self.assertTrue((abs(points[:, 2] + 2) < 1e-15).all())
        # The three faces toward the light, two triangles each.
        self.assertEqual(flat.GetNumberOfCells(), 6)
        self.assertEqual(len(set(array(flat.GetCellData(), "OriginalCellIds"))), 3)
        self.assertTrue((array(flat.GetPointData(), "OriginalPointIds") >= 0).all())
        area, expected = array(flat.GetFieldData(), "ShadowArea")[0], AREA / TOWARD[2]
        print(f"area: got {area}, expected {expected}, tolerance 1e-9")
        self.assertAlmostEqual(area, expected, delta=1e-9)
        normal = array(flat.GetFieldData(), "ShadowPlaneNormal")
        self.assertEqual(normal.tolist(), [[0, 0, 1]])

        shadow.SetOutputModeToOutline()
        shadow.Update()
        outline = shadow.GetOutput()
        self.assertEqual((outline.GetNumberOfLines(), outline.GetNumberOfPoints()), (1, 6))
        self.assertAlmostEqual(array(outline.GetCellData(), "LoopArea")[0], expected, delta=1e-9)

    def test_a_light_that_moves(self):
        shadow, _ = self.run_filter(vtkshadows.vtkShadowVolumeFilter)
        for x in range(5):
            shadow.SetLightPosition(x, 0, 3)
            shadow.Update()
        self.assertEqual(shadow.GetNumberOfMeshBuilds(), 1)
        self.cube.SetXLength(3)
        shadow.Update()
        self.assertEqual(shadow.GetNumberOfMeshBuilds(), 2)

    def test_one_message_for_what_is_no_light(self):
        shadow, _ = self.run_filter(vtkshadows.vtkShadowSilhouetteFilter)
        messages = []

        @calldata_type(VTK_STRING)
        def collect(caller, event, message):
            messages.append(message)

        shadow.AddObserver("ErrorEvent", collect)
        shadow.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        shadow.SetLight(0, 0, 0, 0)
        shadow.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("Light (0, 0, 0, 0) is no light", messages[0])
        self.assertEqual(shadow.GetOutput().GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
