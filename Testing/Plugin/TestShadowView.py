"""The plugin in pvbatch: load it, make the view, and look for shadows in its screenshots."""
import pathlib
import re
import sys
import unittest

from paraview import simple
from scene import SIZE, SOURCES, add_light, make_view, near, pixel, read
from scene import screenshot as save_screenshot

PLUGIN, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
TECHNIQUES = sys.argv[3:]
SHADOW = (-1.5, -1.5)
LIT = (1.5, 1.5)

simple.LoadPlugin(PLUGIN, remote=False, ns=globals())
VIEW = make_view("RenderViewShadows")


def screenshot(view, name):
    return save_screenshot(view, FOLDER / f"{name}.png")


class TestShadowView(unittest.TestCase):
    def setUp(self):
        VIEW.Technique = "none"
        VIEW.Resolution = 2048
        VIEW.Filter = "percentage-closer"
        VIEW.Cascades = 1
        VIEW.ObjectDepths = 1
        VIEW.ObjectType = "prop"
        VIEW.TexturePerCaster = 0
        VIEW.TranslucentCasters = "None"
        VIEW.CullHiddenFaces = 0
        VIEW.MaximumError = VIEW.MaximumFrameTime = 0
        VIEW.LightRadius = 0
        VIEW.ShadowStrength = 1
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

    def test_its_name_in_the_list_of_views(self):
        self.assertEqual(VIEW.GetXMLLabel(), "Render View (Shadows)")

    def test_none_is_an_ordinary_render_view(self):
        ordinary = read(FOLDER / "ordinary.png")  # of SaveOrdinaryView.py
        different = int((ordinary != self.unshadowed).any(axis=2).sum())
        print(f"pixels that differ: got {different}, expected 0, tolerance 0")
        self.assertEqual(different, 0)

    def test_shadows(self):
        frames = {}
        for technique in TECHNIQUES:
            with self.subTest(technique=technique):
                VIEW.Technique = technique
                frames[technique] = screenshot(VIEW, technique)
                self.assert_shadow(frames[technique], self.unshadowed)
        for technique, frame in frames.items():
            far = abs(frames["depth-map"].astype(int) - frame).max(axis=2) > 64
            print(f"depth-map and {technique} disagree: got {far.sum()} px, expected 0, tolerance 20")
            self.assertLessEqual(far.sum(), 20)

    def test_resolution(self):
        for technique in ("depth-map", "object-id"):
            VIEW.Technique = technique
            VIEW.Resolution = 2048
            fine = screenshot(VIEW, "resolution-2048")
            VIEW.Resolution = 16
            coarse = screenshot(VIEW, "resolution-16")
            different = int((fine != coarse).any(axis=2).sum())
            print(f"pixels that a coarse {technique} changes: got {different}, expected 20 or more")
            self.assertGreaterEqual(different, 20)

    def test_filter(self):
        VIEW.Technique = "depth-map"
        default = screenshot(VIEW, "filter-percentage-closer")
        for name in ("none", "hardware", "disc", "variance", "exponential", "exact"):
            with self.subTest(filter=name):
                VIEW.Filter = name
                frame = screenshot(VIEW, f"filter-{name}")
                self.assert_shadow(frame, self.unshadowed)
                different = int((frame != default).any(axis=2).sum())
                print(f"pixels that {name} changes: got {different}, expected 1 or more")
                self.assertGreaterEqual(different, 1)

    def explanation(self):
        VIEW.UpdatePropertyInformation()
        said = VIEW.GetProperty("Explanation").GetElement(0)
        print(said)
        return said

    def test_explanation_and_budget(self):
        VIEW.Technique = "auto"
        self.assert_shadow(screenshot(VIEW, "auto"), self.unshadowed)
        said = self.explanation()
        self.assertEqual(len(said.splitlines()), 1, "a line for the one light")
        self.assertRegex(said, "^light 1: [a-z-]+ .*no gross error")
        VIEW.MaximumError = 0.25
        screenshot(VIEW, "auto-error")
        self.assertIn("0.25 %", self.explanation())
        VIEW.MaximumError, VIEW.MaximumFrameTime = 0, 12345
        for _ in range(60):  # frames in which it tells what is fast
            simple.Render(VIEW)
        self.assertIn("within the 12345 ms", self.explanation())
        other = simple.AddLight(VIEW)
        other.Position, other.FocalPoint = (-1, 1, 1), (0, 0, 0)
        try:
            screenshot(VIEW, "auto-two")
            self.assertEqual(len(self.explanation().splitlines()), 2, "a line a light")
        finally:
            simple.RemoveLight(other)

    def test_light_radius(self):
        """A disc whose half-angle has the tangent 0.1: half shadow reaches 0.26 to both sides of the edge."""
        VIEW.LightRadius = 0.1
        for technique in ("auto", "ray-cast", "stencil-volume"):
            if technique not in (*TECHNIQUES, "auto"):
                continue
            VIEW.Technique = technique
            frame = screenshot(VIEW, f"radius-{technique}")
            self.assert_shadow(frame, self.unshadowed)
            plane = (near(self.unshadowed, *LIT).max(), near(frame, *SHADOW).max())
            half = ((frame.max(axis=2) < 0.9 * plane[0]) & (frame.max(axis=2) > 1.2 * plane[1] + 5)).sum()
            print(f"{technique}: in half shadow: got {half} px, expected 1000 or more")
            self.assertGreaterEqual(half, 1000)

    def test_shadow_strength(self):
        VIEW.Technique = "depth-map"
        before = near(self.unshadowed, *SHADOW)
        for strength in (0, 0.5):
            VIEW.ShadowStrength = strength
            got = near(screenshot(VIEW, f"strength-{strength}"), *SHADOW)
            expected = (1 - strength) * before.max()
            print(f"strength {strength}: got {got.min()} to {got.max()}, expected {expected}, tolerance 2")
            self.assertLessEqual(abs(got - expected).max(), 2)

    def test_bad_values_change_nothing(self):
        VIEW.Technique = "ray-cast" if "ray-cast" in TECHNIQUES else "stencil-volume"
        before = screenshot(VIEW, "good-values")
        said = []
        observer = VIEW.GetClientSideObject().AddObserver("ErrorEvent", lambda *_: said.append(1))
        VIEW.LightRadius = -1
        VIEW.ShadowStrength = 2
        after = screenshot(VIEW, "bad-values")
        VIEW.GetClientSideObject().RemoveObserver(observer)
        different = int((before != after).any(axis=2).sum())
        print(f"errors: got {len(said)}, expected 2; pixels that differ: got {different}, expected 0, tolerance 0")
        self.assertEqual((len(said), different), (2, 0))

    def test_cascades(self):
        """Beside the eye they are finer than one map of as many texels."""
        place = [list(each) for each in (VIEW.CameraPosition, VIEW.CameraFocalPoint, VIEW.CameraViewUp)]
        VIEW.CameraParallelProjection = 0
        VIEW.CameraPosition, VIEW.CameraFocalPoint, VIEW.CameraViewUp = (-4, -4, 0.5), (0, 0, 0.5), (0, 0, 1)
        VIEW.Resolution = 64
        for technique in ("depth-map", "object-id"):
            VIEW.Technique = technique
            frames = []
            for VIEW.Cascades in (1, 4):
                frames.append(screenshot(VIEW, f"cascades-{VIEW.Cascades}"))
            different = int((frames[0] != frames[1]).any(axis=2).sum())
            print(f"pixels that cascades of {technique} change: got {different}, expected 20 or more")
            self.assertGreaterEqual(different, 20)
        VIEW.CameraPosition, VIEW.CameraFocalPoint, VIEW.CameraViewUp = place
        VIEW.CameraParallelProjection = 1

    def test_object_depths(self):
        """Without them a source has no shadow on itself, not even of two pieces far apart."""
        VIEW.Technique = "object-id"
        VIEW.ObjectDepths = 0
        self.assert_shadow(screenshot(VIEW, "objects-two"), self.unshadowed)
        both = simple.AppendGeometry(Input=SOURCES)
        for source in SOURCES:
            simple.Hide(source, VIEW)
        display = simple.Show(both, VIEW)
        display.ColorArrayName = [None, ""]
        display.DiffuseColor = (0.7, 0.7, 0.7)
        display.Specular = 0
        try:
            VIEW.Technique = "none"
            unshadowed = screenshot(VIEW, "objects-none")
            VIEW.Technique = "object-id"
            alone = screenshot(VIEW, "objects-one")
            change = abs(near(alone, *SHADOW) - near(unshadowed, *SHADOW)).max()
            print(f"as one source: got a change of {change} in the shadow, expected 0, tolerance 1")
            self.assertLessEqual(change, 1)
            VIEW.ObjectDepths = 1
            self.assert_shadow(screenshot(VIEW, "objects-depths"), unshadowed)
        finally:
            simple.Delete(both)
            for source in SOURCES:
                simple.Show(source, VIEW)

    def test_object_types(self):
        """By IDs alone a source shadows itself only where it is several objects, blocks or pieces."""
        ways = {"piece": simple.AppendGeometry(Input=SOURCES), "block": simple.GroupDatasets(Input=SOURCES)}
        VIEW.ObjectDepths = 0
        for source in SOURCES:
            simple.Hide(source, VIEW)
        try:
            for kind, both in ways.items():
                with self.subTest(object_type=kind):
                    display = simple.Show(both, VIEW)
                    display.ColorArrayName = [None, ""]
                    display.DiffuseColor = (0.7, 0.7, 0.7)
                    display.Specular = 0
                    VIEW.Technique = "none"
                    unshadowed = screenshot(VIEW, f"objects-{kind}-none")
                    VIEW.Technique = "object-id"
                    alone = screenshot(VIEW, f"objects-{kind}-prop")
                    change = abs(near(alone, *SHADOW) - near(unshadowed, *SHADOW)).max()
                    print(f"as one source: got a change of {change} in the shadow, expected 0, tolerance 1")
                    self.assertLessEqual(change, 1)
                    VIEW.ObjectType = kind
                    self.assert_shadow(screenshot(VIEW, f"objects-{kind}"), unshadowed)
                    VIEW.ObjectType = "prop"
                    simple.Hide(both, VIEW)
        finally:
            for both in ways.values():
                simple.Delete(both)
            for source in SOURCES:
                simple.Show(source, VIEW)

    def assert_glyphs_apart(self, source, places, kinds, coarser=("prop",)):
        """By IDs alone the glyphs at `places` are lit while merged by a coarser kind, and else in shadow."""

        def around(name):
            frame = screenshot(VIEW, f"glyphs-{name}")
            return [near(frame, *place) for place in places]

        simple.Hide(SOURCES[0], VIEW)
        try:
            display = simple.Show(source, VIEW)
            if source.GetXMLLabel() != "Glyph":
                display.SetRepresentationType("3D Glyphs")
                display.GlyphType = "Sphere"
                display.GlyphType.Radius = 0.3
                display.GlyphType.ThetaResolution = display.GlyphType.PhiResolution = 48
                display.Orient = display.Scaling = 0
                display.ScaleFactor = 1
            display.ColorArrayName = [None, ""]
            display.DiffuseColor = (0.7, 0.7, 0.7)
            display.Specular = 0
            VIEW.Technique = "none"
            before = around("none")
            VIEW.Technique = "object-id"
            VIEW.ObjectDepths = 0
            for kind in (*coarser, *kinds):
                VIEW.ObjectType = kind
                for lit, now in zip(before, around(kind)):
                    if kind in coarser:
                        change = abs(now - lit).max()
                        print(f"on a lower glyph, by {kind}: got a change of {change}, expected 0, tolerance 1")
                        self.assertLessEqual(change, 1)
                    else:
                        print(f"on a lower glyph, by {kind}: got {now.max()}, expected under half of {lit.min()}")
                        self.assertLess(now.max(), lit.min() / 2)
        finally:
            simple.Delete(source)
            simple.Show(SOURCES[0], VIEW)

    def test_object_type_instance(self):
        ends = simple.Line(Point1=(0, 0, 1), Point2=(0.8, 0.8, 1.8), Resolution=1)  # one toward the light
        self.assert_glyphs_apart(ends, [(0.1, 0.1)], ["instance"])

    def test_object_type_instance_of_blocks(self):
        """Two blocks of two glyphs each, and each glyph of the one under one of the other."""
        low = simple.Line(Point1=(0, 0, 1), Point2=(1.2, -1.2, 1), Resolution=1)
        high = simple.Line(Point1=(0.8, 0.8, 1.8), Point2=(2.0, -0.4, 1.8), Resolution=1)
        both = simple.GroupDatasets(Input=[low, high])
        self.assert_glyphs_apart(both, [(0.1, 0.1), (1.3, -1.1)], ["block", "instance", "piece"])
        # Two blocks, and each glyph under one of its own.
        left = simple.Line(Point1=(0, 0, 1), Point2=(0.8, 0.8, 1.8), Resolution=1)
        right = simple.Line(Point1=(1.2, -1.2, 1), Point2=(2.0, -0.4, 1.8), Resolution=1)
        both = simple.GroupDatasets(Input=[left, right])
        self.assert_glyphs_apart(both, [(0.1, 0.1), (1.3, -1.1)], ["instance", "piece"], ["prop", "block"])

    def test_object_type_of_the_filter_glyph(self):
        """Its glyphs are pieces of meshes: no mapper has them as instances."""
        left = simple.Line(Point1=(0, 0, 1), Point2=(0.8, 0.8, 1.8), Resolution=1)
        right = simple.Line(Point1=(1.2, -1.2, 1), Point2=(2.0, -0.4, 1.8), Resolution=1)
        both = simple.GroupDatasets(Input=[left, right])
        glyphs = simple.Glyph(Input=both, GlyphType="Sphere", GlyphMode="All Points")
        glyphs.ScaleFactor = 1
        glyphs.GlyphType.Radius = 0.3
        glyphs.GlyphType.ThetaResolution = glyphs.GlyphType.PhiResolution = 48
        self.assert_glyphs_apart(glyphs, [(0.1, 0.1), (1.3, -1.1)], ["piece"], ["prop", "block", "instance"])

    def test_translucent_casters(self):
        """A sphere of the opacity 0.5 is two surfaces: a quarter of the light is left behind it."""
        display = simple.GetDisplayProperties(SOURCES[0], VIEW)
        display.Opacity = 0.5
        try:
            VIEW.Technique = "depth-map"
            before = near(self.unshadowed, *SHADOW)
            for name, share in (("None", 1), ("Opaque", 0), ("Transmittance", 0.25)):
                with self.subTest(translucent_casters=name):
                    VIEW.TranslucentCasters = name
                    got = near(screenshot(VIEW, f"translucent-{name}"), *SHADOW)
                    print(f"{name}: got {got.min()} to {got.max()}, expected {share} of {before.max()}")
                    self.assertLessEqual(abs(got - share * before).max(), 2)
        finally:
            display.Opacity = 1

    def test_cull_hidden_faces(self):
        """The closed sphere loses its far half, which nobody sees, and the open plane nothing."""
        VIEW.Technique = "depth-map"
        whole = screenshot(VIEW, "faces-all")

        def culled():
            return int(re.search(r"NumberOfCulledReceivers: (\d+)", str(VIEW.GetClientSideObject())).group(1))

        self.assertEqual(culled(), 0)
        for VIEW.CullHiddenFaces, expected in ((1, 1), (0, 0)):
            for _ in range(3):  # it is proven in the second
                frame = screenshot(VIEW, f"faces-{VIEW.CullHiddenFaces}")
            print(f"sources with faces left out: got {culled()}, expected {expected}, tolerance 0")
            self.assertEqual(culled(), expected)
            different = int((frame != whole).any(axis=2).sum())
            print(f"pixels that differ: got {different}, expected 0, tolerance 3")
            self.assertLessEqual(different, 3)

    def test_texture_per_caster(self):
        """A sphere takes the shadow of another, between it and the light."""
        upper = simple.Sphere(Center=(0.6, 0.6, 2.1), Radius=0.2, ThetaResolution=48, PhiResolution=48)
        simple.Show(upper, VIEW)
        try:
            VIEW.Technique = "shadow-texture"
            frames = []
            for VIEW.TexturePerCaster in (0, 1):
                frames.append(near(screenshot(VIEW, f"textures-{VIEW.TexturePerCaster}"), 0.23, 0.23))
            print(f"on the lower sphere: got {frames[1].max()}, expected under half of {frames[0].min()}")
            self.assertLess(frames[1].max(), frames[0].min() / 2)
        finally:
            simple.Delete(upper)

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
        self.light.Intensity = 0.4
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
        for source in SOURCES:
            simple.ClearSelection(source)
        self.assertTrue(selected, "got no source selected, expected the plane or the sphere")
        self.assert_shadow(screenshot(VIEW, "after-selection"), self.unshadowed)


if __name__ == "__main__":
    # Not by sys.exit: pvbatch would leave without closing its window, which X reports as an error.
    if not unittest.main(argv=sys.argv[:1], verbosity=2, exit=False).result.wasSuccessful():
        sys.exit(1)
