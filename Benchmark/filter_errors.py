"""How far each filter and format of the depth map is from the truth, and what it costs: Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/filter_errors.py
    ... filter_errors.py --what times

Errors at 1024x768: of hard lights mismatch in percent and gross pixels, false + missed; of lights with a radius
the mean absolute difference from a ray cast of 256 sample lights. Times are of frames over the unshadowed one, all
filters in turn in every round; a process's first rounds are not counted.
"""
import argparse

import vtkshadows
from ground_floor import directional_light, spot_light, still_life, tubes_and_glyphs
from planar_costs import compare, two_bodies
from vtkmodules.vtkRenderingCore import vtkRenderWindow

SCENES = {"still life": still_life, "tubes and glyphs": tubes_and_glyphs, "two bodies": lambda: two_bodies("spot")}
LIGHTS = {
    "spot": (lambda: spot_light((4, -4, 7), (0, 0, 0.4), 32), (0.1, 0.3, 1.0)),
    "directional": (lambda: directional_light((-0.5, 0.6, -1)), (0.02, 0.05, 0.2)),
}
SOFT = ("soft", "sample-lights")
FILTERS = list(
    vtkshadows.vtkDepthShadowMapPass.GetFilterName(i)
    for i in range(vtkshadows.vtkDepthShadowMapPass.GetNumberOfFilters())
)


def opened(window, scene, light):
    renderer = SCENES[scene]()
    renderer.RemoveAllLights()
    renderer.AddLight(LIGHTS[light][0]())
    window.AddRenderer(renderer)
    return renderer


def error_of(window, renderer, **settings):
    shadows = vtkshadows.enable(renderer, "depth-map", **settings)
    # The ray cast's samples: those of the depth map are its own.
    shadows.GetRayCastShadowPass().SetLightSamples(256)
    window.Render()
    error = vtkshadows.error(renderer)
    vtkshadows.disable(renderer)
    return error


def hard(window, scenes):
    rows = [(name, {"filter": name}) for name in FILTERS if name not in SOFT]
    rows += [(f"percentage-closer, {bits} bits", {"depth_bits": bits}) for bits in (24, 16, 8)]
    rows += [(f"{name}, 16 bits", {"filter": name, "depth_bits": 16}) for name in ("none", "hardware")]
    print("| scene | light | filter | mismatch % | gross false + missed px | mean difference |\n|---|---|---|---|---|---|")
    for scene in scenes:
        for light in LIGHTS:
            renderer = opened(window, scene, light)
            for name, settings in rows:
                e = error_of(window, renderer, **settings)
                print(
                    f"| {scene} | {light} | {name} | {e.mismatch_percent:.4f} "
                    f"| {e.gross_false_pixels} + {e.gross_missed_pixels} | {e.mean_absolute_difference:.5f} |",
                    flush=True,
                )
            window.RemoveRenderer(renderer)


def soft(window, scenes):
    print("| scene | light | radius | " + " | ".join(SOFT) + " | percentage-closer |\n|---|---|---|---|---|---|")
    for scene in scenes:
        for light, (_, radii) in LIGHTS.items():
            renderer = opened(window, scene, light)
            for radius in radii:
                differences = [
                    error_of(window, renderer, filter=name, radius=radius).mean_absolute_difference
                    for name in (*SOFT, "percentage-closer")
                ]
                print(f"| {scene} | {light} | {radius} | " + " | ".join(f"{d:.4f}" for d in differences) + " |", flush=True)
            window.RemoveRenderer(renderer)


def times(window, scenes, rounds):
    """Lights have a radius, so that soft filters do their work."""
    print("| scene | light | filter | unshadowed ms | static | moving |\n|---|---|---|---|---|---|")
    for scene in scenes:
        for light, (_, radii) in LIGHTS.items():
            renderer = opened(window, scene, light)
            ways = {name: ("depth-map", {"filter": name, "radius": radii[1]}) for name in FILTERS}
            compare(renderer, window, ways, rounds, f"{scene} | {light}")
            window.RemoveRenderer(renderer)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--what", default="hard,soft", help="of hard, soft, times")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--rounds", type=int, default=20)
    options = parser.parse_args()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1024, 768)
    scenes = options.scenes.split(",")
    for what in options.what.split(","):
        if what == "times":
            times(window, scenes, options.rounds)
        else:
            {"hard": hard, "soft": soft}[what](window, scenes)


if __name__ == "__main__":
    main()
