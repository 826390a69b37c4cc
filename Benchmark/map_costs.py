"""Time of techniques by maps: what cascades, cubes and several lights cost over what they are held against.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/map_costs.py
    ... Benchmark/map_costs.py --scenes terrain --rounds 60 --cascades 2,4,8
    ... Benchmark/map_costs.py --scenes terrain,room --cpu

Software OpenGL, 1024x768. Each comparison is of ways to draw one scene, of which the first is what the others are held
against. All of them are timed in every round, so that they share the machine's moods, by some frames in a row, so that
each finds in the processor's caches what its last frame left there, as it does when it draws alone; printed are medians
of the rounds' ratios, and the mean, in which the frames count in which a map is drawn. Static: the light stands and the
camera moves a little, as it does when someone looks about; every way sees the same views. Moving: the light moves, too.
With --cpu the processor time of all threads is taken instead of the time on the clock: on a machine that does other
things, too, its ratios are the steadier ones.
A further comparison is a function that yields a scene, with its name, and the ways, in SCENES.
"""
import argparse
import math
import statistics
import time
from typing import Any, NamedTuple

import vtkshadows
from ground_floor import (
    directional_light,
    floor_actor,
    mesh_actor,
    place_camera,
    spot_light,
    still_life,
    switched_on,
    timed,
)
from terrain import look, terrain
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow

WARM_UP = 4  # rounds: a process's first frames are slower than later ones, whatever they show


class Way(NamedTuple):
    """A technique, or none, with its settings; light: instead of the scene's own."""

    technique: str = "depth-map"
    settings: dict = {}
    setup: Any = None  # called with the vtkShadowPass
    light: Any = None


class Scene(NamedTuple):
    name: str
    renderer: Any
    move: Any  # called with the number of the round: the camera's place in it
    ways: dict


def lamp(position):
    light = vtkLight()
    light.PositionalOn()
    light.SetConeAngle(180)
    light.SetPosition(position)
    return light


def around(renderer):
    """A camera that sways about its subject."""
    camera = renderer.GetActiveCamera()
    place = camera.GetPosition()

    def move(i):
        camera.SetPosition(place)
        camera.Azimuth(3 * math.sin(0.4 * i))
        camera.OrthogonalizeViewUp()

    return move


def terrain_scenes(options):
    """Cascades over one map, of as many texels each; looking about and walking."""
    for name in ("looking about", "walking"):
        renderer, eye = terrain(4, 15)

        def move(i, name=name, eye=eye, renderer=renderer):
            turn = 60 + (10 * math.sin(0.15 * i) if name == "looking about" else 0)
            step = 1.5 * i if name == "walking" else 0
            place = (eye[0] + 0.5 * step, eye[1] + 0.87 * step, eye[2])
            look(renderer, place, turn)

        ways = {"one map": Way(settings={"resolution": 1024, "cascades": 1})}
        for count in options.cascades:
            ways[f"{count} cascades"] = Way(settings={"resolution": 1024, "cascades": count})
        yield Scene(f"terrain, {name}", renderer, move, ways)


def room():
    """Closed, with three balls and a lamp among them."""
    renderer = vtkRenderer()
    walls = vtkCubeSource()
    walls.SetBounds(-3, 3, -3, 3, 0, 4)
    renderer.AddActor(mesh_actor(walls, (0.8, 0.8, 0.75)))
    for place, radius in (((1.5, 1.5, 1), 0.6), ((-1.6, 0.2, 2), 0.4), ((0.3, 1.8, 3), 0.3)):
        ball = vtkSphereSource()
        ball.SetCenter(place)
        ball.SetRadius(radius)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(64)
        renderer.AddActor(mesh_actor(ball, (0.8, 0.5, 0.3)))
    place_camera(renderer, (0, -2.8, 1.5), (0, 3, 1.5), 80)
    renderer.AddLight(lamp((0.2, 0.3, 2.1)))
    return renderer


def room_scenes(options):
    """Six maps of a lamp in a closed room over one of a spot, of as many texels each."""
    renderer = room()
    for texels in (1024, 2048):
        size = {"resolution": texels}
        ways = {
            "one map": Way(settings=size, light=spot_light((0.2, 0.3, 3.6), (0.2, 0.3, 0), 78)),
            "cube": Way(settings=size, light=lamp((0.2, 0.3, 2.1))),
        }
        yield Scene(f"closed room, {texels} texels", renderer, around(renderer), ways)


def eight_spots():
    renderer = still_life()
    renderer.RemoveAllLights()
    for i in range(8):
        a = 0.25 * math.pi * i
        spot = spot_light((4 * math.cos(a), 4 * math.sin(a), 6), (0, 0, 0.4), 32)
        spot.SetIntensity(0.2)
        renderer.AddLight(spot)
    return renderer


def lights_scenes(options):
    """Eight spots with shadows over the same eight without."""
    renderer = eight_spots()
    ways = {"without shadows": Way("none"), "depth-map": Way()}
    yield Scene("still life, 8 spots", renderer, around(renderer), ways)


def confined_scenes(options):
    """A part of a wide scene: the view of a light confined to what is seen, over the whole."""
    renderer = vtkRenderer()
    for i in range(400):
        ball = vtkSphereSource()
        ball.SetCenter(9 * (i % 20 - 9.6), 9 * (i // 20 - 9.6), 1)
        ball.SetRadius(0.9)
        renderer.AddActor(mesh_actor(ball, (0.8, 0.5, 0.3)))
    renderer.AddActor(floor_actor(100, 0))
    place_camera(renderer, (3, -14, 6), (0, 0, 0.5))
    renderer.AddLight(directional_light((-0.5, 0.6, -1)))
    ways = {
        "whole": Way(setup=lambda shadows: shadows.GetDepthShadowMapPass().ConfineToViewOff()),
        "confined": Way(setup=lambda shadows: shadows.GetDepthShadowMapPass().ConfineToViewOn()),
    }
    yield Scene("400 balls", renderer, around(renderer), ways)


SCENES = {
    "terrain": terrain_scenes,
    "room": room_scenes,
    "lights": lights_scenes,
    "confined": confined_scenes,
}


def prepared(renderer, way):
    """A vtkShadowPass of its own, so that each way keeps its maps."""
    renderer.SetPass(None)
    shadows = vtkshadows.enable(renderer, way.technique, **way.settings)
    if way.setup:
        way.setup(shadows)
    renderer.SetPass(None)
    return shadows


def show(renderer, way, shadows):
    renderer.SetPass(None if way.technique == "none" else shadows)
    if way.light:
        renderer.RemoveAllLights()
        renderer.AddLight(way.light)


def shift_lights(renderer, i):
    for light in switched_on(renderer):
        x, y, z = light.GetPosition()
        light.SetPosition(x * (1.001 if i % 2 else 1 / 1.001), y, z)


def all_frames(visits):
    return [milliseconds for visit in visits for milliseconds in visit]


def ratios(times):
    first = next(iter(times.values()))
    median = statistics.median
    medians = [median(median(a) / median(b) for a, b in zip(own, first)) for own in times.values()]
    means = [statistics.mean(all_frames(own)) / statistics.mean(all_frames(first)) for own in times.values()]
    return medians, means


def processor_time(window):
    begin = time.process_time()
    window.Render()
    window.WaitForCompletion()
    return 1e3 * (time.process_time() - begin)


def timed_in_turn(window, scene, passes, options, is_moving, take):
    """Frame times of every way, a list for each of its visits. The first frame of a visit, which looks shaders up, is not
    timed."""
    times = {name: [] for name in passes}
    for i in range(WARM_UP + options.rounds):
        for name, way in scene.ways.items():
            show(scene.renderer, way, passes[name])
            visit = []
            for j in range(options.frames + 1):
                frame = i * (options.frames + 1) + j
                scene.move(0.5 * frame)
                if is_moving:
                    shift_lights(scene.renderer, frame)
                visit.append(take(window))
            if i >= WARM_UP:
                times[name].append(visit[1:])
    return times


def compare(window, scene, options, take):
    window.AddRenderer(scene.renderer)
    passes = {name: prepared(scene.renderer, way) for name, way in scene.ways.items()}
    static = timed_in_turn(window, scene, passes, options, False, take)
    moving = timed_in_turn(window, scene, passes, options, True, take)
    for name, still, still_mean, moved in zip(passes, *ratios(static), ratios(moving)[0]):
        print(
            f"| {scene.name} | {name} | {statistics.median(all_frames(static[name])):.1f} "
            f"| {still:.2f} | {still_mean:.2f} | {moved:.2f} |",
            flush=True,
        )
    window.RemoveRenderer(scene.renderer)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--frames", type=int, default=4, help="timed frames of a way in each round")
    parser.add_argument("--scenes", default=",".join(SCENES), help=f"of {', '.join(SCENES)}")
    parser.add_argument("--cascades", default="4", help="numbers of cascades, 1 to 8")
    parser.add_argument("--cpu", action="store_true", help="processor time instead of the clock's")
    options = parser.parse_args()
    options.cascades = [int(count) for count in options.cascades.split(",")]
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1024, 768)
    print("| scene | way | static ms | static | static, of the means | moving |\n|---|---|---|---|---|---|")
    for name in options.scenes.split(","):
        for scene in SCENES[name](options):
            compare(window, scene, options, processor_time if options.cpu else timed)


if __name__ == "__main__":
    main()
