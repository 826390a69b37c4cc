"""The plugin in pvbatch: load it, make the view, and look for shadows in its screenshots.

A sphere floats over a plane; light comes down from +x and +y, so that the shadow falls toward -x, -y. The
camera looks straight down with +y up.
"""
import pathlib
import sys
import unittest

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

PLUGIN, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
SIZE = (400, 300)
PER_UNIT = SIZE[1] / 2 / 3  # pixels a world unit: the parallel scale is 3
SHADOW = (-1.5, -1.5)
LIT = (1.5, 1.5)


def pixel(x, y):
    return int(SIZE[1] / 2 - y * PER_UNIT), int(SIZE[0] / 2 + x * PER_UNIT)


def near(frame, x, y):
    """The 5 x 5 pixels around a point of the plane."""
    row, column = pixel(x, y)
    return frame[row - 2 : row + 3, column - 2 : column + 3].astype(int)


def make_view(kind):
    view = simple.CreateView(kind)
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseLight = 0  # the light kit
    view.CameraParallelProjection = 1
    view.CameraPosition = (0, 0, 10)
    view.CameraFocalPoint = (0, 0, 0)
    view.CameraViewUp = (0, 1, 0)
    view.CameraParallelScale = 3
    for source in SOURCES:
        display = simple.Show(source, view)
        display.ColorArrayName = [None, ""]
        display.Specular = 0
    return view


def add_light(view):
    light = simple.AddLight(view)
    light.Position = (1, 1, 1)
    light.FocalPoint = (0, 0, 0)
    return light


def screenshot(view, name):
    """The view as bytes (height, width, 3), row 0 at the top; also kept as name.png."""
    path = FOLDER / f"{name}.png"
    simple.SaveScreenshot(str(path), view, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1, :, :3]


simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())
SOURCES = [
    simple.Sphere(Center=(0, 0, 1.5), Radius=0.4, ThetaResolution=48, PhiResolution=48),
    simple.Plane(Origin=(-5, -5, 0), Point1=(5, -5, 0), Point2=(-5, 5, 0)),
]
VIEW = make_view("RenderViewShadows")


class TestShadowView(unittest.TestCase):
    def setUp(self):
        VIEW.Technique = "none"
        VIEW.UseLight = 0
        VIEW.UseFXAA = 0
        self.light = add_light(VIEW)
        self.unshadowed = screenshot(VIEW, "none")

    def tearDown(self):
        simple.RemoveLight(self.light)

    def assert_shadow(self, frame, unshadowed):
        dark, before = near(frame, *SHADOW).max(), near(unshadowed, *SHADOW).min()
        print(f"in the shadow: got {dark}, expected under half of {before}")
        self.assertLess(dark, before / 2)
        change = abs(near(frame, *LIT) - near(unshadowed, *LIT)).max()
        print(f"in the light: got a change of {change}, expected 0, tolerance 1")
        self.assertLessEqual(change, 1)
        brighter = (frame.astype(int) - unshadowed).max()
        self.assertLessEqual(brighter, 1, "a shadow never brightens")

    def test_it_is_in_the_list_of_views(self):
        self.assertEqual(VIEW.GetXMLLabel(), "Render View (Shadows)")
        self.assertEqual((VIEW.SMProxy.GetProperty("Technique").GetElement(0)), "none")

    def test_none_is_an_ordinary_render_view(self):
        ordinary = make_view("RenderView")
        light = add_light(ordinary)
        different = int((screenshot(ordinary, "ordinary") != self.unshadowed).any(axis=2).sum())
        simple.RemoveLight(light)
        simple.Delete(ordinary)
        print(f"pixels that differ: got {different}, expected 0, tolerance 0")
        self.assertEqual(different, 0)

    def test_shadows(self):
        frames = {}
        for technique in ("depth-map", "ray-cast"):
            with self.subTest(technique=technique):
                VIEW.Technique = technique
                frames[technique] = screenshot(VIEW, technique)
                self.assert_shadow(frames[technique], self.unshadowed)
        far = abs(frames["depth-map"].astype(int) - frames["ray-cast"]).max(axis=2) > 64
        print(f"pixels where the two disagree: got {far.sum()}, expected 0, tolerance 20")
        self.assertLessEqual(far.sum(), 20)

    def test_resolution(self):
        VIEW.Technique = "depth-map"
        VIEW.Resolution = 2048
        fine = screenshot(VIEW, "resolution-2048")
        VIEW.Resolution = 16
        coarse = screenshot(VIEW, "resolution-16")
        VIEW.Resolution = 2048
        different = int((fine != coarse).any(axis=2).sum())
        print(f"pixels that a coarse map changes: got {different}, expected 20 or more")
        self.assertGreaterEqual(different, 20)

    def test_spot_light(self):
        self.light.Type = "Positional"
        self.light.Position = (4, 4, 4)
        self.light.ConeAngle = 60
        unshadowed = screenshot(VIEW, "spot-none")
        VIEW.Technique = "depth-map"
        frame = screenshot(VIEW, "spot")
        # Nearer to the light than a directional one's: its shadow reaches farther.
        dark, before = near(frame, -2.2, -2.2).max(), near(unshadowed, -2.2, -2.2).min()
        print(f"in the shadow: got {dark}, expected under half of {before}")
        self.assertLess(dark, before / 2)

    def test_light_kit(self):
        """With the light kit on, the added light still casts; the kit's own lights fill its shadow."""
        VIEW.UseLight = 1
        unshadowed = screenshot(VIEW, "kit-none")
        VIEW.Technique = "depth-map"
        frame = screenshot(VIEW, "kit")
        dark, before = near(frame, *SHADOW).mean(), near(unshadowed, *SHADOW).mean()
        print(f"in the shadow: got {dark:.0f}, expected under {before:.0f}")
        self.assertLess(dark, before - 10)
        self.assertGreater(dark, 10)

    def test_headlight_casts_nothing(self):
        self.light.Coords = "Headlight"
        unshadowed = screenshot(VIEW, "headlight-none")
        VIEW.Technique = "depth-map"
        different = int((screenshot(VIEW, "headlight") != unshadowed).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 0, tolerance 0")
        self.assertEqual(different, 0)

    def test_fxaa(self):
        VIEW.UseFXAA = 1
        unshadowed = screenshot(VIEW, "fxaa-none")
        VIEW.Technique = "depth-map"
        frame = screenshot(VIEW, "fxaa")
        self.assert_shadow(frame, unshadowed)

    def test_selection(self):
        """Picking draws ids instead of colours: shadows must not touch them."""
        VIEW.Technique = "depth-map"
        simple.Render(VIEW)
        row, column = pixel(*SHADOW)
        row = SIZE[1] - 1 - row
        simple.SelectSurfacePoints(Rectangle=[column - 60, row - 60, column + 60, row + 60], View=VIEW)
        selected = [s for s in SOURCES if s.GetSelectionInput(s.Port) is not None]
        simple.ClearSelection()
        self.assertTrue(selected, "got no source selected, expected the plane or the sphere")
        self.assert_shadow(screenshot(VIEW, "after-selection"), self.unshadowed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
