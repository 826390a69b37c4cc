"""visibility() and error(): shapes, ranges, which way is up, which light."""
import unittest

import numpy
import vtkshadows
from scene import SIZE, Scene
from vtkmodules.vtkCommonCore import vtkObject

SCENE = Scene()
WIDTH, HEIGHT = SIZE
SHADOW_AREA = 100  # pixels: the disc of radius 0.4 is 40 pixels a unit, about 800 and more


class TestVisibility(unittest.TestCase):
    def setUp(self):
        for light in list(SCENE.renderer.GetLights()):
            if light is not SCENE.light:
                SCENE.renderer.RemoveLight(light)
        SCENE.light.SwitchOn()
        vtkshadows.disable(SCENE.renderer)
        vtkshadows.enable(SCENE.renderer, "depth-map")
        SCENE.window.Render()

    def check_mask(self, mask):
        self.assertEqual((mask.shape, mask.dtype), ((HEIGHT, WIDTH), numpy.float32))
        self.assertTrue(mask.flags.c_contiguous and mask.flags.owndata)
        self.assertGreaterEqual(mask.min(), 0)
        self.assertLessEqual(mask.max(), 1)

    def assert_shadow_at(self, mask, x, y):
        row, column = SCENE.pixel(x, y)
        got = mask[row, column]
        print(f"visibility at row {row}, column {column}: got {got}, expected 0, tolerance 0")
        self.assertEqual(got, 0)

    def test_row_zero_is_at_the_top(self):
        for technique in vtkshadows.techniques():
            if technique == "none":
                continue
            with self.subTest(technique=technique):
                vtkshadows.enable(SCENE.renderer, technique)
                SCENE.window.Render()
                mask = vtkshadows.visibility(SCENE.renderer)
                self.check_mask(mask)
                self.assert_shadow_at(mask, -1.5, -1.5)
                for lit in ((1.5, 1.5), (-1.5, 1.5), (1.5, -1.5)):
                    self.assertEqual(mask[SCENE.pixel(*lit)], 1)

    def test_auto_says_why(self):
        vtkshadows.enable(SCENE.renderer, maximum_error=0.5)
        SCENE.window.Render()
        shadows = SCENE.renderer.GetPass()
        self.assertEqual((shadows.GetTechnique(), shadows.GetMaximumError()), ("auto", 0.5))
        why = vtkshadows.explanation(SCENE.renderer)
        print(why)
        self.assertTrue(why.startswith(shadows.GetChosenTechnique(SCENE.light)))
        if shadows.GetRayCastShadowPass():
            self.assertLessEqual(vtkshadows.error(SCENE.renderer).mismatch_percent, 0.5)
        vtkshadows.enable(SCENE.renderer, "depth-map", maximum_error=0)
        SCENE.window.Render()
        self.assertEqual(vtkshadows.explanation(SCENE.renderer), "depth-map: named, not chosen.")
        with self.assertRaisesRegex(ValueError, "light: 7 is out of range"):
            vtkshadows.explanation(SCENE.renderer, 7)

    def test_none_is_lit_everywhere(self):
        vtkshadows.enable(SCENE.renderer, "none")
        SCENE.window.Render()
        self.assertEqual(vtkshadows.visibility(SCENE.renderer).min(), 1)

    def test_lights_by_index_and_by_themselves(self):
        second = SCENE.add_light((-1, 1, 1))
        SCENE.window.Render()
        self.assert_shadow_at(vtkshadows.visibility(SCENE.renderer, 1), 1.5, -1.5)
        by_light = vtkshadows.visibility(SCENE.renderer, second)
        self.assertTrue((by_light == vtkshadows.visibility(SCENE.renderer, numpy.int64(1))).all())

        # All at once, by one light and by two.
        both = vtkshadows.visibilities(SCENE.renderer)
        self.assertEqual(both.shape, (2, *by_light.shape))
        for index in (0, 1):
            self.assertTrue((both[index] == vtkshadows.visibility(SCENE.renderer, index)).all(), index)
        self.assertFalse((both[0] == both[1]).all())

        # An index counts the lights that are on.
        SCENE.light.SwitchOff()
        SCENE.window.Render()
        self.assert_shadow_at(vtkshadows.visibility(SCENE.renderer, 0), 1.5, -1.5)
        alone = vtkshadows.visibilities(SCENE.renderer)
        self.assertTrue((alone == vtkshadows.visibility(SCENE.renderer, 0)[numpy.newaxis]).all())
        second.SwitchOff()
        with self.assertRaisesRegex(RuntimeError, "no light that is switched on"):
            vtkshadows.visibilities(SCENE.renderer)

    def test_strength_is_left_out(self):
        vtkshadows.enable(SCENE.renderer, strength=0.5)
        SCENE.window.Render()
        self.assert_shadow_at(vtkshadows.visibility(SCENE.renderer), -1.5, -1.5)

    def test_volume_counts(self):
        vtkshadows.enable(SCENE.renderer, "stencil-volume")
        SCENE.window.Render()
        for settings, expected in (
            (dict(variant="automatic"), 1),
            (dict(variant="z-fail", counter="wrapping-stencil"), 1),
            (dict(variant="z-pass", counter="float"), 1),
        ):
            with self.subTest(**settings):
                vtkshadows.enable(SCENE.renderer, "stencil-volume", **settings)
                SCENE.window.Render()
                counts = vtkshadows.volume_counts(SCENE.renderer, SCENE.light)
                self.assertEqual((counts.shape, counts.dtype), ((HEIGHT, WIDTH), numpy.int32))
                self.assertEqual(counts[SCENE.pixel(-1.5, -1.5)], expected)
                self.assertLessEqual(counts[SCENE.pixel(1.5, 1.5)], 0)
                # Everything in this picture receives.
                mask = vtkshadows.visibility(SCENE.renderer, SCENE.light)
                self.assertEqual(int(((counts > 0) != (mask < 0.5)).sum()), 0)
        vtkshadows.enable(SCENE.renderer, "stencil-volume", variant="automatic", counter="automatic")

        # Both sides of the sphere cast if every face must.
        volumes = SCENE.renderer.GetPass().GetStencilShadowVolumePass()
        volumes.OneSidedClosedPiecesOff()
        SCENE.window.Render()
        self.assertEqual(vtkshadows.volume_counts(SCENE.renderer)[SCENE.pixel(-1.5, -1.5)], 2)

    def test_a_caster_that_was_flat_casts_again(self):
        """A matrix without an inverse is warned of, and the next matrix is looked at by itself."""
        vtkshadows.enable(SCENE.renderer, "stencil-volume")
        SCENE.window.Render()
        before = vtkshadows.visibility(SCENE.renderer)
        vtkObject.GlobalWarningDisplayOff()
        SCENE.sphere.SetScale(1, 1, 0)
        SCENE.window.Render()
        SCENE.sphere.SetScale(1, 1, 1)
        vtkObject.GlobalWarningDisplayOn()
        SCENE.window.Render()
        self.assertTrue((vtkshadows.visibility(SCENE.renderer) == before).all())

    def test_debug_views_are_drawn_over_the_frame(self):
        vtkshadows.enable(SCENE.renderer, "stencil-volume")
        plain = SCENE.frame()
        mask = vtkshadows.visibility(SCENE.renderer)
        for view in ("volumes", "silhouette", "counts", "none"):
            with self.subTest(view=view):
                vtkshadows.enable(SCENE.renderer, "stencil-volume", debug_view=view)
                different = int((SCENE.frame() != plain).any(axis=2).sum())
                print(f"{view}: pixels that differ: got {different}, expected {view != 'none'}")
                self.assertEqual(different > 50, view != "none")
                self.assertEqual(different == 0, view == "none")
                self.assertTrue((vtkshadows.visibility(SCENE.renderer) == mask).all())

    def test_debug_views_of_maps(self):
        vtkshadows.enable(SCENE.renderer, "depth-map", debug_view="none")
        plain = SCENE.frame()
        for view in ("cascades", "texel-density", "map", "lit-part"):
            with self.subTest(view=view):
                vtkshadows.enable(SCENE.renderer, "depth-map", debug_view=view)
                different = int((SCENE.frame() != plain).any(axis=2).sum())
                print(f"{view}: pixels that differ: got {different}, expected 50 or more")
                self.assertGreater(different, 50)
        vtkshadows.enable(SCENE.renderer, "depth-map", debug_view="none")
        self.assertTrue((SCENE.frame() == plain).all())

    def test_light_samples(self):
        """One name for both soft techniques: of two samples each, a pixel sees none, one or both."""
        for technique in {"stencil-volume", "ray-cast"} & set(vtkshadows.techniques()):
            with self.subTest(technique=technique):
                vtkshadows.enable(SCENE.renderer, technique, radius=0.1, light_samples=2)
                SCENE.window.Render()
                steps = numpy.unique(numpy.rint(2 * vtkshadows.visibility(SCENE.renderer)))
                self.assertEqual(list(steps), [0, 1, 2])

    @unittest.skipUnless("ray-cast" in vtkshadows.techniques(), "a build without Embree")
    def test_error(self):
        vtkshadows.enable(SCENE.renderer, "depth-map", resolution=1024)
        SCENE.window.Render()
        fine = vtkshadows.error(SCENE.renderer)
        print(fine)
        self.check_mask(fine.visibility)
        self.check_mask(fine.truth)
        self.assertEqual((fine.error_map.shape, fine.error_map.dtype), ((HEIGHT, WIDTH, 3), numpy.uint8))
        self.assert_shadow_at(fine.truth, -1.5, -1.5)
        self.assertGreater(fine.shadow_pixels, SHADOW_AREA)
        self.assertLess(fine.shadow_pixels, fine.receiver_pixels)
        self.assertLess(fine.mismatch_percent, 0.5)
        self.assertEqual(fine.gross_pixels, 0)

        # The measure must see a bad technique: one that shadows nothing misses the whole shadow.
        vtkshadows.enable(SCENE.renderer, "none")
        SCENE.window.Render()
        bad = vtkshadows.error(SCENE.renderer)
        print(bad)
        self.assertEqual(bad.mismatch_pixels, bad.shadow_pixels)
        self.assertEqual(bad.gross_false_pixels, 0)
        self.assertGreater(bad.gross_missed_pixels, SHADOW_AREA)
        self.assertEqual(bad.gross_pixels, bad.gross_missed_pixels)


if __name__ == "__main__":
    unittest.main(verbosity=2)
