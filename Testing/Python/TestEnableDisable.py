"""enable() changes the picture where a shadow falls, disable() gives back the very frame before."""
import gc
import unittest

import vtkshadows
from scene import Scene
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

# One window for all tests: many in one process abort VTK 9.2 under X.
SCENE = Scene()
SHADOW = (-1.5, -1.5)  # where the sphere's shadow falls
LIT = (1.5, 1.5)


class TestEnableDisable(unittest.TestCase):
    def setUp(self):
        SCENE.renderer.SetPass(None)
        self.before = SCENE.frame()

    def assert_same(self, got, expected):
        different = int((got != expected).any(axis=2).sum())
        self.assertEqual(different, 0, f"pixels that differ: got {different}, expected 0, tolerance 0")

    def assert_shadowed(self, frame):
        dark, lit = SCENE.pixel(*SHADOW), SCENE.pixel(*LIT)
        print(f"shadow: {frame[dark]} from {self.before[dark]}, lit: {frame[lit]} from {self.before[lit]}")
        self.assertLess(int(frame[dark].max()), int(self.before[dark].max()) // 4)
        self.assertLessEqual(abs(int(frame[lit].max()) - int(self.before[lit].max())), 1)

    def test_every_technique(self):
        for technique in vtkshadows.techniques():
            with self.subTest(technique=technique):
                shadows = vtkshadows.enable(SCENE.renderer, technique)
                self.assertEqual(shadows.GetTechnique(), technique)
                frame = SCENE.frame()
                if technique == "none":
                    self.assert_same(frame, self.before)
                else:
                    self.assert_shadowed(frame)
                self.assertTrue(vtkshadows.disable(SCENE.renderer))
                self.assert_same(SCENE.frame(), self.before)

    def test_the_previous_pass_draws_and_comes_back(self):
        steps = vtkRenderStepsPass()
        SCENE.renderer.SetPass(steps)
        before = SCENE.frame()

        self.assertIs(vtkshadows.enable(SCENE.renderer).GetDelegatePass(), steps)
        gc.collect()
        self.assert_shadowed(SCENE.frame())
        vtkshadows.enable(SCENE.renderer, "none")  # a second time: the same pass, the same memory
        gc.collect()
        vtkshadows.disable(SCENE.renderer)
        self.assertIs(SCENE.renderer.GetPass(), steps)
        self.assert_same(SCENE.frame(), before)

    def test_strength(self):
        vtkshadows.enable(SCENE.renderer, "depth-map", strength=0)
        self.assert_same(SCENE.frame(), self.before)
        vtkshadows.enable(SCENE.renderer, "depth-map", strength=0.5)
        dark = SCENE.pixel(*SHADOW)
        got, expected = int(SCENE.frame()[dark].max()), int(self.before[dark].max()) / 2
        print(f"half strength: got {got}, expected {expected}, tolerance 1.5")
        self.assertLessEqual(abs(got - expected), 1.5)

    def test_hidden_faces(self):
        """Those of the sphere are left out once it is known to be closed; the floor is not."""
        shadows = vtkshadows.enable(SCENE.renderer, "depth-map")
        for _ in range(3):
            whole = SCENE.frame()
        self.assertEqual(shadows.GetNumberOfCulledReceivers(), 0)
        vtkshadows.enable(SCENE.renderer, "depth-map", cull_hidden_faces=True)
        SCENE.window.Render()
        SCENE.window.Render()
        while not shadows.GetCullingIsSettled():
            SCENE.window.Render()
        culled = SCENE.frame()
        self.assertEqual(shadows.GetNumberOfCulledReceivers(), 1)
        different = int((culled != whole).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected at most 3")
        self.assertLessEqual(different, 3)
        vtkshadows.enable(SCENE.renderer, "depth-map", cull_hidden_faces=False)
        self.assert_same(SCENE.frame(), whole)

    def test_props_that_do_not_take_part(self):
        vtkshadows.enable(SCENE.renderer, "depth-map")
        vtkshadows.set_casts_shadows(SCENE.sphere, False)
        self.assert_same(SCENE.frame(), self.before)
        vtkshadows.set_casts_shadows(SCENE.sphere, True)
        self.assert_shadowed(SCENE.frame())
        vtkshadows.set_receives_shadows(SCENE.floor, False)
        dark = SCENE.pixel(*SHADOW)
        self.assertEqual(SCENE.frame()[dark].tolist(), self.before[dark].tolist())
        vtkshadows.set_receives_shadows(SCENE.floor, True)

    def test_stand_in(self):
        vtkshadows.enable(SCENE.renderer, "depth-map")
        by_itself = SCENE.frame()
        speck = vtkSphereSource()
        speck.SetRadius(0.01)
        speck.SetCenter(*SCENE.sphere.GetCenter())
        speck.Update()
        vtkshadows.set_stand_in(SCENE.sphere, speck.GetOutput())
        changed = int((SCENE.frame() != by_itself).any(axis=-1).sum())
        print(f"with a speck as stand-in: {changed} pixels changed, at least 500 expected")
        self.assertGreaterEqual(changed, 500)
        self.assertEqual(vtkshadows.vtkShadowPass.GetStandIn(SCENE.sphere), speck.GetOutput())
        vtkshadows.set_stand_in(SCENE.sphere, None)
        self.assert_same(SCENE.frame(), by_itself)

    def test_disable_without_shadows(self):
        self.assertFalse(vtkshadows.disable(SCENE.renderer))


if __name__ == "__main__":
    unittest.main(verbosity=2)
