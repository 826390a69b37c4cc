"""Time of planar shadows, beside the depth map's: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/planar_costs.py

200 000 triangles over one floor, one light, software OpenGL. Static: the camera moves. Moving: the light moves
each frame. A process's first frames are slower than later ones, whatever they show: they are not counted.
"""
import argparse
import statistics

import vtkshadows
from ground_floor import (
    directional_light,
    floor_actor,
    mesh_actor,
    place_camera,
    spot_light,
    switched_on,
    timed,
    torus_source,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

WARM_UP = 5  # rounds

LIGHTS = {
    "directional": lambda: directional_light((-0.5, 0.6, -1)),
    "spot": lambda: spot_light((4, -4, 7), (0, 0, 0.4), 32),
}

WAYS = {
    "planar": ("planar", {}),
    "planar, textures": ("planar", {"plane_textures": True}),
    "depth-map": ("depth-map", {}),
}


def two_bodies(light, side=224):
    """A sphere and a torus of 2 * side**2 triangles each."""
    sphere = vtkSphereSource()
    sphere.SetRadius(1)
    sphere.SetCenter(-0.8, 0.2, 1)
    sphere.SetThetaResolution(side)
    sphere.SetPhiResolution(side)
    ring = mesh_actor(torus_source(side, side), (0.35, 0.55, 0.85))
    ring.SetScale(0.8)
    ring.RotateX(65)
    ring.SetPosition(1.5, -0.6, 1.2)
    renderer = vtkRenderer()
    for actor in (mesh_actor(sphere, (0.88, 0.5, 0.3)), ring, floor_actor(6, 0)):
        renderer.AddActor(actor)
    renderer.AddLight(LIGHTS[light]())
    place_camera(renderer, (1.2, -8.6, 4.6), (0, 0, 0.55))
    return renderer


def passes(renderer, ways):
    """The ways to compare, each a vtkShadowPass of its own."""
    made = {}
    for name, (technique, settings) in ways.items():
        made[name] = vtkshadows.enable(renderer, technique, **settings)
        renderer.SetPass(None)
    return made


def compare(renderer, window, ways, rounds, label):
    """A row a way: ratios to the unshadowed frame. Every way in every round, so that all share the machine's moods."""
    window.Render()
    lamp = switched_on(renderer)[0]
    place = lamp.GetPosition()
    camera = renderer.GetActiveCamera()
    ways = passes(renderer, ways)
    unshadowed, ratios = [], {name: ([], []) for name in ways}
    for i in range(WARM_UP + rounds):
        renderer.SetPass(None)
        window.Render()
        camera.Azimuth(0.4 if i % 2 else -0.4)
        plain = timed(window)
        if i >= WARM_UP:
            unshadowed.append(plain)
        for name, shadows in ways.items():
            renderer.SetPass(shadows)
            window.Render()  # the first frame of a pass looks shaders up
            camera.Azimuth(0.1 if i % 2 else -0.1)
            static = timed(window)
            lamp.SetPosition(place[0] * (1 + 0.002 * (i % 5)), place[1], place[2])
            window.Render()
            lamp.SetPosition(place[0] * (1.001 + 0.002 * (i % 5)), place[1], place[2])
            moving = timed(window)
            if i >= WARM_UP:
                ratios[name][0].append(static / plain)
                ratios[name][1].append(moving / plain)
    for name, (static, moving) in ratios.items():
        print(
            f"| {label} | {name} | {statistics.median(unshadowed):.1f} "
            f"| {statistics.median(static):.2f} | {statistics.median(moving):.2f} |",
            flush=True,
        )


def main(title, ways):
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--lights", default="directional,spot")
    options = parser.parse_args()
    print("| light | technique | unshadowed ms | static | moving |\n|---|---|---|---|---|")
    for light in options.lights.split(","):
        renderer = two_bodies(light)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(1024, 768)
        window.AddRenderer(renderer)
        compare(renderer, window, ways, options.rounds, light)


if __name__ == "__main__":
    main(__doc__.splitlines()[0], WAYS)
