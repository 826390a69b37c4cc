"""What the depth map's filter "exact" costs over the plain one, and how wrong both are.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/exact_lookup.py
    ... exact_lookup.py --scenes terrain,room,spots --cpu

The three scenes of ground_floor.py, or a terrain, a lamp in a closed room and eight spots, 1024x768, software OpenGL.
Times are of whole frames, those of both filters and of the frame without shadows taken in turn; a ratio is the median
of the turns' ratios. Static: the camera moves. Moving: every light moves each frame. A process's first frames are slower
than later ones: they are not counted. With --cpu times are the processor's, of all threads.
"""
import argparse
import pathlib
import statistics
import sys

import vtkshadows
from ground_floor import ROOT, scan, still_life, switched_on, timed, tubes_and_glyphs
from map_costs import eight_spots, processor_time, room
from terrain import look, terrain
from vtkmodules.vtkRenderingCore import vtkRenderWindow

FILTERS = ("percentage-closer", "exact")
WARM_UP = 3  # rounds


def country():
    renderer, eye = terrain(4, 15)
    look(renderer, eye, 60)
    return renderer


def passes(renderer, resolution):
    """A vtkShadowPass for each filter; none is left with the renderer."""
    made = {}
    for name in FILTERS:
        made[name] = vtkshadows.enable(renderer, "depth-map", resolution=resolution)
        made[name].GetDepthShadowMapPass().SetFilter(name)
        renderer.SetPass(None)
    return made


def frame_times(renderer, window, ways, rounds, take):
    """Milliseconds: {way: (static, moving)}, and of the frame without shadows."""
    camera = renderer.GetActiveCamera()
    lights = switched_on(renderer)
    places = [light.GetPosition() for light in lights]

    def move_lights(share):
        for light, (x, y, z) in zip(lights, places):
            light.SetPosition(x * (1 + share), y, z)

    unshadowed, times = [], {name: ([], []) for name in ways}
    for i in range(WARM_UP + 2 * (rounds // 2)):
        turn = 0.4 if i % 2 else -0.4
        renderer.SetPass(None)
        window.Render()  # the first frame of a pass looks shaders up
        camera.Azimuth(turn)
        plain = take(window)
        if i >= WARM_UP:
            unshadowed.append(plain)
        for name in list(ways) if i % 2 else reversed(list(ways)):
            renderer.SetPass(ways[name])
            window.Render()
            camera.Azimuth(turn / 4)
            static = take(window)
            move_lights(0.002 * (i % 5) + 0.001)
            window.Render()
            move_lights(0.002 * (i % 5) + 0.002)
            moving = take(window)
            move_lights(0)
            if i >= WARM_UP:
                times[name][0].append(static)
                times[name][1].append(moving)
    return unshadowed, times


def ratio(times, others):
    return statistics.median(a / b for a, b in zip(times, others))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mesh", type=pathlib.Path, default=ROOT / "build/demo/refined_elephant.off")
    parser.add_argument("--resolution", type=int, default=2048)
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--scenes", default="still-life,scan,tubes-and-glyphs", help="of these, terrain, room and spots")
    parser.add_argument("--cpu", action="store_true", help="processor time instead of the clock's")
    options = parser.parse_args()
    makers = {
        "still-life": still_life,
        "scan": lambda: scan(options.mesh),
        "tubes-and-glyphs": tubes_and_glyphs,
        "terrain": country,
        "room": room,
        "spots": eight_spots,
    }
    if "scan" in options.scenes and not options.mesh.exists():
        sys.exit(f"--mesh {options.mesh}: no such file; run Scripts/demo, which unpacks it, or name a mesh")

    print(
        "| scene | filter | mismatch %, each light | gross false + missed px | static | moving "
        "| static over plain | moving over plain |\n|---|---|---|---|---|---|---|---|"
    )
    for scene in options.scenes.split(","):
        renderer = makers[scene]()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(1024, 768)
        window.AddRenderer(renderer)
        window.Render()
        ways = passes(renderer, options.resolution)
        errors = {name: [] for name in ways}
        for name, shadows in ways.items():
            renderer.SetPass(shadows)
            window.Render()
            for light in switched_on(renderer):
                measure = vtkshadows.vtkShadowErrorMeasure()
                measure.Measure(renderer, light)
                errors[name].append(measure)
        take = processor_time if options.cpu else timed
        unshadowed, times = frame_times(renderer, window, ways, options.rounds, take)
        plain = times[FILTERS[0]]
        for name, (static, moving) in times.items():
            mismatch = ", ".join(f"{e.GetMismatchPercent():.4f}" for e in errors[name])
            gross = ", ".join(f"{e.GetGrossFalsePixels()} + {e.GetGrossMissedPixels()}" for e in errors[name])
            print(
                f"| {scene} | {name} | {mismatch} | {gross} "
                f"| {ratio(static, unshadowed):.2f} | {ratio(moving, unshadowed):.2f} "
                f"| {ratio(static, plain[0]):.2f} | {ratio(moving, plain[1]):.2f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
