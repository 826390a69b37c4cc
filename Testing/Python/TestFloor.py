"""add_floor: where it lies, what it shows, its light; screenshot: a PNG that is right over any page."""
import pathlib
import tempfile
import unittest
import warnings

import numpy
import vtkshadows
from scene import SIZE, Scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

KEPT = tempfile.TemporaryDirectory(prefix="vtkshadows-")  # goes with the test
FOLDER = pathlib.Path(KEPT.name)


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1].astype(float)


def cube_actor(bounds):
    cube = vtkCubeSource()
    cube.SetBounds(*bounds)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(cube.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


class TestFloor(unittest.TestCase):
    def setUp(self):
        # A cube of side 2, its lowest point at y = -1, in a renderer that nobody has set up.
        self.renderer, self.window = vtkRenderer(), SCENE.window
        SCENE.window.RemoveRenderer(SCENE.renderer)
        self.window.AddRenderer(self.renderer)
        self.cube = cube_actor((-1, 1, -1, 1, -1, 1))
        self.renderer.AddActor(self.cube)

    def tearDown(self):
        self.window.RemoveRenderer(self.renderer)

    def test_newcomer(self):
        floor = vtkshadows.add_floor(self.renderer, shadow="depth-map")
        self.assertFalse(self.renderer.IsActiveCameraCreated())  # VTK resets it in its first frame
        self.assertEqual(self.renderer.GetPass().GetTechnique(), "depth-map")
        matrix = floor.GetUserMatrix()
        numpy.testing.assert_allclose(
            [[matrix.GetElement(row, column) for column in (2, 3)] for row in range(3)],
            [[0, 0], [6, -1.001], [0, 0]],
            atol=1e-6,
        )
        lights = list(self.renderer.GetLights())
        self.assertEqual([light.LightTypeIsHeadlight() for light in lights], [1, 0])
        self.assertAlmostEqual(lights[0].GetIntensity(), 1 / 3)
        x, y, z = lights[1].GetPosition()
        self.assertTrue(x < 0 < y and z > 0)  # left, above, before: the eye looks along -z

        # It does not count where the camera is reset, and shows a shadow.
        self.window.Render()
        bounds = self.renderer.ComputeVisiblePropBounds()
        self.assertEqual(bounds, (-1, 1, -1, 1, -1, 1))
        self.renderer.GetActiveCamera().Elevation(30)
        with_shadow = self.shot()
        self.assertGreater((with_shadow[..., 3] % 255 > 0).sum(), 1000)
        vtkshadows.disable(self.renderer)
        self.assertEqual((self.shot()[..., 3] % 255 > 0).sum(), 0)

    def shot(self, **arguments):
        vtkshadows.screenshot(self.window, FOLDER / "shot.png", **arguments)
        return read_png(FOLDER / "shot.png")

    def test_again(self):
        first = vtkshadows.add_floor(self.renderer, shadow="ray-cast", color=(0.5, 0, 0), fade=0.5)
        count = self.renderer.GetActors().GetNumberOfItems()
        lights = self.renderer.GetLights().GetNumberOfItems()
        second = vtkshadows.add_floor(
            self.renderer, shadow="ray-cast", catcher=False, normal=(0, 0, 2), offset=-4, size=2
        )
        self.assertIs(first, second)
        self.assertEqual(self.renderer.GetActors().GetNumberOfItems(), count)
        self.assertEqual(self.renderer.GetLights().GetNumberOfItems(), lights)
        self.assertEqual(second.GetBounds(), (-2, 2, -2, 2, -4, -4))
        self.assertTrue(second.GetUseBounds())
        self.assertEqual(second.GetProperty().GetOpacity(), 1)
        self.assertFalse(vtkshadows.vtkShadowPass.IsShadowCatcher(second))

    def test_no_light_that_casts(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vtkshadows.add_floor(self.renderer, shadow="depth-map", light=False)
        self.assertEqual(len(caught), 1)
        self.assertIn("add a vtkLight", str(caught[0].message))
        self.assertEqual(self.renderer.GetLights().GetNumberOfItems(), 0)

    def test_refused(self):
        for pattern, arguments in (
            ("unknown technique 'x'; there are", dict(shadow="x")),
            ("size: 0 is out of range", dict(size=0)),
            ("size: inf", dict(size=float("inf"))),
            ("normal: 'up' is not known; give 'auto' or three numbers", dict(normal="up")),
            (r"normal: \(0, 0\) is not three numbers", dict(normal=(0, 0))),
            ("normal: .* is no direction", dict(normal=(0, 0, 0))),
            ("normal: inf is not a finite number", dict(normal=(0, 0, float("inf")))),
            ("offset: nan is not a finite number", dict(offset=float("nan"))),
            ("strength: 2.0 is out of range; give 0 to 1", dict(strength=2)),
            ("fade: 'much' is not a number", dict(fade="much")),
            ("color: 1.5 is out of range", dict(color=(0, 0, 1.5))),
            ("strength and fade are a catcher's", dict(catcher=False, fade=0.1)),
        ):
            with self.subTest(**arguments), self.assertRaisesRegex(ValueError, pattern):
                vtkshadows.add_floor(self.renderer, **arguments)
        self.cube.VisibilityOff()
        with self.assertRaisesRegex(RuntimeError, "nothing with an extent .* add actors"):
            vtkshadows.add_floor(self.renderer, shadow="depth-map")
        self.assertEqual(self.renderer.GetActors().GetNumberOfItems(), 1)
        self.assertIsNone(self.renderer.GetPass())

    def test_set_shadow_catcher(self):
        is_catcher = vtkshadows.vtkShadowPass.IsShadowCatcher
        vtkshadows.set_shadow_catcher(self.cube, color=(0.1, 0.2, 0.3), strength=0.5, fade=0.25)
        self.assertTrue(is_catcher(self.cube))
        self.assertTrue(self.cube.HasTranslucentPolygonalGeometry())
        self.assertEqual(self.cube.GetPropertyKeys().Get(vtkshadows.vtkShadowPass.SHADOW_CATCHER(), 3), 0.5)
        vtkshadows.set_shadow_catcher(self.cube, False)
        self.assertFalse(is_catcher(self.cube))
        with self.assertRaisesRegex(ValueError, "Renderer is not a vtkActor"):
            vtkshadows.set_shadow_catcher(self.renderer)


class TestScreenshot(unittest.TestCase):
    def setUp(self):
        SCENE.window.AddRenderer(SCENE.renderer)
        vtkshadows.set_shadow_catcher(SCENE.floor, color=(0.2, 0, 0.4), strength=0.8)

    def tearDown(self):
        vtkshadows.disable(SCENE.renderer)
        SCENE.window.RemoveRenderer(SCENE.renderer)

    def test_over_any_page(self):
        SCENE.renderer.SetBackground(0.3, 0.6, 0.1)
        for technique in vtkshadows.techniques():
            # What "auto" has to choose from is all within its limits, but not alike.
            vtkshadows.enable(SCENE.renderer, technique, radius=0.1).HoldChoiceOn()
            vtkshadows.screenshot(SCENE.renderer, FOLDER / "page.png")
            rgba = read_png(FOLDER / "page.png")
            self.assertEqual(rgba.shape, (SIZE[1], SIZE[0], 4))
            self.assertEqual(SCENE.renderer.GetBackground(), (0.3, 0.6, 0.1))
            for page in ((1, 1, 1), (0, 0, 0), (1, 0, 1)):
                SCENE.renderer.SetBackground(*page)
                alpha = rgba[..., 3:] / 255
                laid = alpha * rgba[..., :3] + (1 - alpha) * 255 * numpy.array(page)
                worst = abs(laid - SCENE.frame()).max()
                print(f"{technique} over {page}: got {worst:.3f} of 255, expected at most 1.5")
                self.assertLessEqual(worst, 1.5)
            SCENE.renderer.SetBackground(0.3, 0.6, 0.1)
            if technique != "none":
                row, column = SCENE.pixel(-1.5, -1.5)  # under the sphere's centre, along the light
                numpy.testing.assert_allclose(rgba[row, column], [51, 0, 102, 204], atol=1)

    def test_opaque(self):
        vtkshadows.screenshot(SCENE.window, str(FOLDER / "opaque.png"), transparent=False)
        numpy.testing.assert_array_equal(read_png(FOLDER / "opaque.png"), SCENE.frame())

    def test_refused(self):
        for name in ("picture.jpg", "picture", "picture.png.bmp"):
            with self.assertRaisesRegex(ValueError, "is no .png file; .*alpha"):
                vtkshadows.screenshot(SCENE.window, FOLDER / name)
            self.assertFalse((FOLDER / name).exists())
        with self.assertRaisesRegex(ValueError, "int is no vtkRenderWindow"):
            vtkshadows.screenshot(1, FOLDER / "picture.png")
        with self.assertRaises(OSError):
            vtkshadows.screenshot(SCENE.window, FOLDER / "missing" / "picture.png")
        with self.assertRaisesRegex(ValueError, "is in none"):
            vtkshadows.screenshot(vtkRenderer(), FOLDER / "picture.png")


SCENE = Scene()

if __name__ == "__main__":
    unittest.main(verbosity=2)
