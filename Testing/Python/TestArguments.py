"""Wrong arguments: one error that names the value and the remedy, and nothing is changed."""
import inspect
import math
import re
import types
import unittest

import numpy
import vtkshadows
from scene import Scene
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkTexture

SCENE = Scene()


class TestArguments(unittest.TestCase):
    def setUp(self):
        vtkshadows.disable(SCENE.renderer)

    def assert_refused(self, pattern, call, *args, kind=ValueError, **kwargs):
        with self.assertRaisesRegex(kind, pattern) as caught:
            call(*args, **kwargs)
        print(caught.exception)
        self.assertNotIn("\n", str(caught.exception))

    def test_enable(self):
        for pattern, arguments in (
            ("'shadow-magic'; there are depth-map", dict(technique="shadow-magic")),
            ("unknown technique None", dict(technique=None)),
            ("unknown setting 'resolutoin'; there are resolution", dict(resolutoin=1)),
            ("resolution: 0 is out of range; give 1", dict(resolution=0)),
            ("cascades: 0 is out of range; give 1 to 8", dict(cascades=0)),
            ("cascades: 9 is out of range; give 1 to 8", dict(cascades=9)),
            ("resolution: 1.5 is not a whole number", dict(resolution=1.5)),
            ("object_type: 'atom' is not known; there are prop, block", dict(object_type="atom")),
            ("object_depth: 1 is not True or False", dict(object_depth=1)),
            ("object_depth_bits: 12 is no format .* 8, 16, 24 or 32", dict(object_depth_bits=12)),
            ("object_taps: 5 is out of range; give 1 to 4", dict(object_taps=5)),
            ("light_samples: 5000 .* give 1 to 4096", dict(light_samples=5000)),
            ("filter: 'gaussian' is not known; there are percentage-closer, none", dict(filter="gaussian")),
            ("filter: 4 is not known", dict(filter=4)),
            ("filter_radius: nan is out of range; give 0.5 to 64", dict(filter_radius=math.nan)),
            ("filter_taps: 257 .* give 1 to 256", dict(filter_taps=257)),
            ("depth_bits: 12 is no format .* 8, 16, 24 or 32", dict(depth_bits=12)),
            ("bias: 'none' is neither 'automatic' nor", dict(bias="none")),
            ("bias: inf is not a finite number", dict(bias=(math.inf, 1))),
            ("beyond: 'dark' .* lit, repeat, clamp", dict(beyond="dark")),
            ("epsilon_scale: 0.0 is out of range", dict(epsilon_scale=0)),
            ("variant: 'zfail' is not known; there are automatic, z-fail", dict(variant="zfail")),
            ("variant: 1 is not known", dict(variant=1)),
            ("counter: 'abacus' .* automatic, wrapping-stencil, float", dict(counter="abacus")),
            ("smoothing: 'much' is not True or False", dict(smoothing="much")),
            ("texture_per_caster: 1 is not True or False", dict(texture_per_caster=1)),
            ("near_plane: -1.0 is out of range; give 0 or more", dict(near_plane=-1)),
            ("near_plane: nan is out of range", dict(near_plane=math.nan)),
            ("debug_view: 'x-ray' .* none, volumes, silhouette, counts", dict(debug_view="x-ray")),
            ("maximum_error: -1.0 is out of range; give 0 to 100", dict(maximum_error=-1)),
            ("maximum_error: nan is out of range", dict(maximum_error=math.nan)),
            ("maximum_frame_time: 'fast' is not a number", dict(maximum_frame_time="fast")),
            ("strength: 1.5 is out of range; give 0 to 1", dict(strength=1.5)),
            ("strength: nan is out of range", dict(strength=math.nan)),
            ("strength: 'dark' is not a number", dict(strength="dark")),
            ("maximum_distance: -1.0 is out of range", dict(maximum_distance=-1)),
            ("fade: 2.0 is out of range; give 0 to 1", dict(fade=2)),
            ("translucent_casters: 'half' is not known; there are none, opaque", dict(translucent_casters="half")),
            ("cull_hidden_faces: 1 is not True or False", dict(cull_hidden_faces=1)),
            ("radius: inf is out of range; give 0 or more", dict(radius=math.inf)),
            ("delegate: int is not a vtkRenderPass", dict(delegate=1)),
        ):
            with self.subTest(**arguments):
                self.assert_refused(pattern, vtkshadows.enable, SCENE.renderer, **arguments)
                self.assertIsNone(SCENE.renderer.GetPass())

    def test_every_setting_is_documented_once(self):
        """Each once, and with all of its names where it takes one of several."""
        settings = vtkshadows._settings.SETTINGS
        text = inspect.getdoc(vtkshadows.enable)
        parameters = text[text.index("Parameters\n---") : text.index("Returns\n---")]
        parts = re.split(r"^(\w+) : ", parameters, flags=re.MULTILINE)[1:]
        self.assertEqual(sorted(parts[::2]), sorted(["technique", "delegate", *settings]))
        told = dict(zip(parts[::2], parts[1::2]))
        with_names = 0
        for name, setting in settings.items():
            with self.assertRaises(ValueError) as refused:
                setting.check(name, "no such")
            known = re.search("is not known; there are (.*)$", str(refused.exception))
            for each in known.group(1).split(", ") if known else ():
                self.assertIn(f'"{each}"', told[name], name)
            with_names += bool(known)
        print(f"settings that take a name: got {with_names}, expected 8 or more")
        self.assertGreaterEqual(with_names, 8)

    def test_settings_arrive(self):
        shadows = vtkshadows.enable(SCENE.renderer, resolution=512, strength=0.25, radius=2)
        self.assertEqual(shadows.GetDepthShadowMapPass().GetResolution(), 512)
        objects = shadows.GetObjectIDShadowPass()
        self.assertEqual(objects.GetResolution(), 512)
        vtkshadows.enable(
            SCENE.renderer, object_type="piece", object_depth=False, object_depth_bits=24, object_taps=3
        )
        self.assertEqual((objects.GetObjectType(), objects.GetDepthBits(), objects.GetTaps()), (3, 24, 3))
        self.assertFalse(objects.GetSelfShadows())
        vtkshadows.enable(SCENE.renderer, cascades=3)
        self.assertEqual(objects.GetNumberOfCascades(), 3)
        self.assertEqual(shadows.GetDepthShadowMapPass().GetNumberOfCascades(), 3)
        self.assertEqual(shadows.GetLightStrength(SCENE.light), 0.25)
        self.assertEqual(shadows.GetLightRadius(SCENE.light), 2)
        maps = shadows.GetDepthShadowMapPass()
        vtkshadows.enable(
            SCENE.renderer, filter="soft", filter_taps=8, filter_radius=2, depth_bits=16, light_samples=300
        )
        self.assertEqual((maps.GetFilterName(maps.GetFilter()), maps.GetFilterTaps()), ("soft", 8))
        self.assertEqual((maps.GetFilterRadius(), maps.GetDepthBits(), maps.GetLightSamples()), (2, 16, 256))
        vtkshadows.enable(SCENE.renderer, bias=(2, 1.5), beyond="clamp")
        self.assertEqual((maps.GetBiasMode(), maps.GetConstantBias(), maps.GetSlopeBias()), (1, 2, 1.5))
        self.assertEqual(maps.GetBeyond(), maps.CLAMP_BEYOND)
        vtkshadows.enable(SCENE.renderer, bias="automatic", beyond="lit")
        self.assertEqual((maps.GetBiasMode(), maps.GetBeyond()), (0, 0))
        volumes = shadows.GetStencilShadowVolumePass()
        vtkshadows.enable(
            SCENE.renderer, "stencil-volume", variant="z-pass-capped", counter="float", debug_view="counts"
        )
        self.assertEqual((volumes.GetVariant(), volumes.GetCounter()), (3, 2))
        self.assertEqual(shadows.GetDebugView(), "counts")
        self.assertTrue(volumes.GetSmoothing())
        vtkshadows.enable(SCENE.renderer, smoothing=False)
        self.assertFalse(volumes.GetSmoothing())
        textures = shadows.GetShadowTexturePass()
        self.assertEqual(textures.GetResolution(), 512)
        vtkshadows.enable(SCENE.renderer, texture_per_caster=True, near_plane=2.5)
        self.assertTrue(textures.GetTexturePerCaster())
        self.assertEqual((textures.GetCasterSelection(), textures.GetNearPlane()), (1, 2.5))
        vtkshadows.enable(SCENE.renderer, near_plane=0)
        self.assertEqual((textures.GetCasterSelection(), textures.GetNearPlane()), (0, 2.5))
        vtkshadows.enable(SCENE.renderer, light_samples=16)
        self.assertEqual(volumes.GetLightSamples(), 16)
        self.assertEqual(volumes.GetVariant(), 3)  # what is not named stays
        for value, name in enumerate(("none", "opaque", "stochastic", "transmittance")):
            vtkshadows.enable(SCENE.renderer, translucent_casters=name)
            self.assertEqual(shadows.GetTranslucentCasting(), value)
        for culled in (True, False):
            vtkshadows.enable(SCENE.renderer, cull_hidden_faces=culled)
            self.assertEqual(shadows.GetCullHiddenFaces(), culled)
        planar = shadows.GetPlanarShadowPass()
        vtkshadows.enable(SCENE.renderer, soft_method="plateaus", plane_textures=True, texture_resolution=99)
        self.assertEqual((planar.GetSoftMethod(), planar.GetTextureResolution()), (planar.PLATEAUS, 99))
        self.assertTrue(planar.GetPlaneTextures())
        vtkshadows.enable(SCENE.renderer, maximum_error=2, maximum_frame_time=30, maximum_distance=9, fade=0.5)
        self.assertEqual((shadows.GetMaximumError(), shadows.GetMaximumFrameTime()), (2, 30))
        self.assertEqual(shadows.GetLightMaximumDistance(SCENE.light), 9)
        self.assertEqual(shadows.GetLightFade(SCENE.light), 0.5)
        ray_cast = shadows.GetRayCastShadowPass()
        if ray_cast:
            vtkshadows.enable(SCENE.renderer, epsilon_scale=2)
            self.assertEqual((ray_cast.GetLightSamples(), ray_cast.GetEpsilonScale()), (16, 2))

    def test_what_has_a_renderer(self):
        several = [SCENE.renderer, vtkRenderer()]
        for thing in (
            SCENE.renderer,
            SCENE.window,
            types.SimpleNamespace(renderer=SCENE.renderer, renderers=several),  # a PyVista plotter
            types.SimpleNamespace(renderers=several[:1]),
        ):
            vtkshadows.enable(thing)
            self.assertIsInstance(SCENE.renderer.GetPass(), vtkshadows.vtkShadowPass)
            vtkshadows.disable(thing)
            self.assertIsNone(SCENE.renderer.GetPass())
        self.assert_refused(
            "2 renderers; give one", vtkshadows.enable, types.SimpleNamespace(renderers=several)
        )
        for thing in (None, 3, SCENE.light, types.SimpleNamespace(renderers=[])):
            self.assert_refused("not a vtkRenderer", vtkshadows.enable, thing)

    def test_lights(self):
        calls = (vtkshadows.visibility, vtkshadows.error, vtkshadows.volume_counts)
        for call in calls:
            self.assert_refused("no shadows; call vtkshadows.enable", call, SCENE.renderer)
        vtkshadows.enable(SCENE.renderer)
        for call in calls:
            self.assert_refused("light: 1 is out of range", call, SCENE.renderer, 1)
            self.assert_refused("light: -1 is out of range", call, SCENE.renderer, -1)
            self.assert_refused("'sun' is neither a vtkLight", call, SCENE.renderer, "sun")
            self.assert_refused("not one of this renderer's", call, SCENE.renderer, vtkLight())
        SCENE.light.SwitchOff()
        self.assert_refused("no light switched on", vtkshadows.visibility, SCENE.renderer)
        SCENE.light.SwitchOn()

    def test_props(self):
        self.assert_refused("int is not a vtkProp", vtkshadows.set_casts_shadows, 3, True)
        self.assert_refused("not a vtkProp", vtkshadows.set_receives_shadows, SCENE.light, True)
        self.assert_refused("not a vtkProp", vtkshadows.set_stand_in, SCENE.light, None)
        self.assert_refused("str is not a vtkPolyData", vtkshadows.set_stand_in, SCENE.sphere, "hull")

    def test_falloff(self):
        """Of a spot, from an image however it is given; a directional light has none."""
        pixels = numpy.full((4, 6, 3), 51, "uint8")
        pixels[0] = 255  # the row at the top
        spot = SCENE.add_light((0, 0, 4))
        spot.PositionalOn()
        spot.SetConeAngle(30)
        image = vtkImageData()
        image.SetDimensions(2, 2, 1)
        image.AllocateScalars(3, 3)
        arguments = (SCENE.renderer, 1)
        self.assert_refused("no shadows; call vtkshadows.enable", vtkshadows.set_smooth_cone, *arguments, 0.5)
        shadows = vtkshadows.enable(SCENE.renderer, "none")
        try:
            vtkshadows.set_smooth_cone(*arguments, 0.5)
            self.assertEqual(shadows.GetLightSmoothCone(spot), 0.5)
            vtkshadows.set_smooth_cone(*arguments, 0)
            for each in (pixels, pixels[..., 0], image, vtkTexture()):
                texture = vtkshadows.set_light_texture(*arguments, each, up=(0, 2, 0))
                self.assertIs(shadows.GetLightTexture(spot), texture)
            up = [0.0, 0.0, 0.0]
            shadows.GetLightTextureUp(spot, up)
            self.assertEqual(up, [0, 1, 0])
            # The row at the top is where y is high, and lets five times as much through.
            vtkshadows.set_light_texture(*arguments, pixels)
            SCENE.light.SetSwitch(0)
            frame = SCENE.frame().astype(int)
            reach = 4 * math.tan(math.radians(30))
            high, low = (frame[SCENE.pixel(0, y * reach)] for y in (0.8, -0.8))
            print(f"at the top: got {high}, expected five times {low}, tolerance 6")
            self.assertTrue((abs(high - 5 * low) <= 6).all() and high.min() > 50)
            SCENE.light.SetSwitch(1)
            for pattern, call, *wrong in (
                ("share: 1.5 is out of range; give 0 to 1", vtkshadows.set_smooth_cone, 1.5),
                ("share: nan is out of range", vtkshadows.set_smooth_cone, math.nan),
                ("image: 'missing.png' is no .png file", vtkshadows.set_light_texture, "missing.png"),
                ("image: int is none; give a vtkTexture", vtkshadows.set_light_texture, 3),
                ("shape \\(4, 6, 2\\).* give uint8", vtkshadows.set_light_texture, pixels[..., :2]),
                ("type float64 is none", vtkshadows.set_light_texture, pixels / 255),
                ("up: \\(0, 0, 0\\) is no direction", vtkshadows.set_light_texture, pixels, (0, 0, 0)),
                ("up: nan is not a finite number", vtkshadows.set_light_texture, pixels, (0, 0, math.nan)),
            ):
                self.assert_refused(pattern, call, *arguments, *wrong)
            sun = (SCENE.renderer, 0)
            self.assert_refused("no spot", vtkshadows.set_smooth_cone, *sun, 0.5, kind=RuntimeError)
            self.assert_refused("no spot", vtkshadows.set_light_texture, *sun, pixels, kind=RuntimeError)
            self.assertIsNotNone(vtkshadows.set_light_texture(*arguments, pixels))
            self.assertIsNone(vtkshadows.set_light_texture(*arguments, None))
            self.assertIsNone(shadows.GetLightTexture(spot))
        finally:
            SCENE.light.SetSwitch(1)
            SCENE.renderer.RemoveLight(spot)

    def test_vtk_errors_are_raised(self):
        """What only VTK can find out comes as a RuntimeError with its message, and is not printed."""
        no_window = vtkRenderer()
        no_window.AddLight(vtkLight())
        vtkshadows.enable(no_window)
        self.assert_refused("window", vtkshadows.visibility, no_window, kind=RuntimeError)

        vtkshadows.enable(SCENE.renderer, "depth-map")
        SCENE.window.Render()
        self.assert_refused(
            'technique is "depth-map".* Give it "stencil-volume"',
            vtkshadows.volume_counts,
            SCENE.renderer,
            kind=RuntimeError,
        )

        # Of the technique itself, and not only of the pass.
        shadows = vtkshadows.enable(SCENE.renderer, "stencil-volume")
        with self.assertRaisesRegex(RuntimeError, "Variant 9 is none of"):
            with vtkshadows._errors.VtkErrors(shadows):
                shadows.GetStencilShadowVolumePass().SetVariant(9)


if __name__ == "__main__":
    unittest.main(verbosity=2)
