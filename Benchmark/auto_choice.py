"""What "auto" chooses, whether it keeps to its budget of error, and what it costs over the best fixed setting.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/auto_choice.py
    ... Benchmark/auto_choice.py --scenes scan,lot-3 --budgets 0,0.1 --rounds 20
    ... Benchmark/auto_choice.py --scenes lot-1,lot-2,lot-3 --rounds 0 --size 640x480   # errors alone

Scenes: those of ground_floor.py, a terrain, and scenes by lot (lot-N, N the seed): a floor, some of spheres, cones,
cubes and a soup of slivers, one to three lights of any kind, a view. Budgets: percent; 0: no gross error.

For each scene and budget every fixed setting is held against the truth in the view. Those that keep to the budget, for
every light, compete. They and auto, once it has settled, draw frames in turn: static, the camera moves a little, and
moving, every light moves. A time is the least of its frames, by the clock and by the process's CPU time, which other
programs on the machine disturb less; printed are the ratios of auto's to the best of the others', which is named. Then
the camera goes around in large steps, and auto's error is measured at each: the largest is printed.
"""
import argparse
import math
import pathlib
import random
import sys
import time

import vtkshadows
from error_limits import ErrorLimits
from ground_floor import (
    ROOT,
    directional_light,
    floor_actor,
    mesh_actor,
    place_camera,
    scan,
    size_of,
    spot_light,
    still_life,
    switched_on,
    tubes_and_glyphs,
)
from meshes import random_soup
from terrain import look, terrain
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

FIXED = {
    "depth-map 512": ("depth-map", dict(resolution=512)),
    "depth-map 1024": ("depth-map", dict(resolution=1024)),
    "depth-map 2048": ("depth-map", dict(resolution=2048)),
    "depth-map 4096": ("depth-map", dict(resolution=4096)),
    "depth-map 4 x 1024": ("depth-map", dict(resolution=1024, cascades=4)),
    "depth-map hardware": ("depth-map", dict(filter="hardware")),
    "depth-map exact": ("depth-map", dict(filter="exact")),
    "depth-map exact 4 x": ("depth-map", dict(filter="exact", cascades=4)),
    "object-id": ("object-id", {}),
    "planar": ("planar", {}),
    "stencil-volume": ("stencil-volume", {}),
    "ray-cast": ("ray-cast", {}),
}
LIMITS = ErrorLimits.of_library()  # of "no gross error"
SETTLING = 80  # frames
TIMED = 2  # frames of a kind a turn, after those that are drawn for the change
LEAD = 3


def by_lot(seed):
    lot = random.Random(seed)
    renderer = vtkRenderer()
    renderer.AddActor(floor_actor(4, 0))
    for _ in range(lot.randint(2, 25)):
        source = lot.choice((vtkSphereSource, vtkConeSource, vtkCubeSource))()
        if not isinstance(source, vtkCubeSource):
            source.SetResolution(lot.randint(6, 60)) if isinstance(
                source, vtkConeSource
            ) else source.SetThetaResolution(lot.randint(6, 200))
        actor = mesh_actor(source, (0.5, 0.7, 0.9))
        actor.SetPosition(lot.uniform(-3, 3), lot.uniform(-3, 3), lot.uniform(0.2, 2))
        actor.SetScale(lot.uniform(0.05, 1))
        actor.RotateWXYZ(lot.uniform(0, 360), lot.uniform(-1, 1), lot.uniform(-1, 1), 1)
        renderer.AddActor(actor)
    if lot.random() < 0.4:
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(random_soup(lot.choice((100, 3000))))
        soup = vtkActor()
        soup.SetMapper(mapper)
        soup.SetPosition(0, 0, 1.5)
        renderer.AddActor(soup)
    for _ in range(lot.randint(1, 3)):
        kind = lot.choice(("directional", "spot", "point"))
        place = (lot.uniform(-3, 3), lot.uniform(-3, 3), lot.uniform(2.5, 6))
        if kind == "directional":
            light = directional_light([-x for x in place])
        elif kind == "spot":
            light = spot_light(place, (0, 0, 0), lot.uniform(20, 60))
        else:
            light = vtkLight()
            light.PositionalOn()
            light.SetConeAngle(180)
            light.SetPosition(place)
        light.SetIntensity(0.6)
        renderer.AddLight(light)
    angle = lot.uniform(0, 2 * math.pi)
    far = lot.uniform(5, 14)
    place_camera(
        renderer, (far * math.cos(angle), far * math.sin(angle), lot.uniform(1.5, 8)), (0, 0, 0.6)
    )
    return renderer


def plain_terrain():
    renderer, eye = terrain()
    look(renderer, eye, 60)
    return renderer


def scene_of(name, mesh):
    if name.startswith("lot-"):
        return by_lot(int(name[4:]))
    makers = {"still-life": still_life, "tubes-and-glyphs": tubes_and_glyphs, "terrain": plain_terrain}
    return scan(mesh) if name == "scan" else makers[name]()


def errors_of(renderer):
    """Of each light the figures of vtkshadows.error, by their names."""
    measured = [vars(vtkshadows.error(renderer, light)) for light in switched_on(renderer)]
    return [{name: value for name, value in error.items() if isinstance(value, (int, float))} for error in measured]


def keeps(errors, budget):
    return all(error["mismatch_percent"] <= budget if budget else LIMITS.is_right(error) for error in errors)


def figure(errors, budget):
    """What a budget is about, in percent, of the light that is most wrong: mismatch, or gross error of more than a pixel."""
    if budget:
        return max(error["mismatch_percent"] for error in errors)
    return max(error["gross_percent"] if error["gross_pixels"] > LIMITS.gross_pixels else 0 for error in errors)


class Motion:
    """Small steps of the camera, and of the lights, to and fro."""

    def __init__(self, renderer):
        self.renderer = renderer
        self.places = [light.GetPosition() for light in switched_on(renderer)]
        self.count = 0

    def camera(self):
        self.count += 1
        self.renderer.GetActiveCamera().Azimuth(0.1 if self.count % 2 else -0.1)

    def lights(self, share=None):
        self.count += 1
        step = 0.002 * (1 + self.count % 5) if share is None else share
        for light, (x, y, z) in zip(switched_on(self.renderer), self.places):
            light.SetPosition(x * (1 + step), y, z)


def timed(window):
    wall, cpu = time.perf_counter(), time.process_time()
    window.Render()
    window.WaitForCompletion()
    return 1000 * (time.perf_counter() - wall), 1000 * (time.process_time() - cpu)


def least(frames):
    return min(wall for wall, _ in frames), min(cpu for _, cpu in frames)


def settle(window, shadows, step):
    for _ in range(SETTLING):
        step()
        window.Render()
        if shadows.GetChoiceIsSettled():
            break
    step()
    window.Render()


def settle_both(renderer, window, shadows):
    """The choice while the lights stand, and while they move."""
    motion = Motion(renderer)
    settle(window, shadows, motion.camera)
    for _ in range(LEAD):
        motion.lights()
        window.Render()
    settle(window, shadows, motion.lights)
    motion.lights(0)
    for _ in range(LEAD):
        motion.camera()
        window.Render()
    settle(window, shadows, motion.camera)


def times_of(renderer, window, ways, rounds):
    """{way: ((static wall, cpu), (moving wall, cpu))}, frames in turn."""
    motion = Motion(renderer)
    frames = {name: ([], []) for name in ways}
    for i in range(rounds):
        names = list(ways) if i % 2 else list(reversed(list(ways)))
        for name in names:
            renderer.SetPass(ways[name])
            for kind, step in enumerate((motion.camera, motion.lights)):
                for k in range(LEAD + TIMED):
                    step()
                    each = timed(window)
                    if k >= LEAD:
                        frames[name][kind].append(each)
            motion.lights(0)
            window.Render()
            window.Render()
    return {name: tuple(least(each) for each in both) for name, both in frames.items()}


def views_around(renderer, window, shadows, budget, views):
    """The largest error of auto in views around the scene, by the budget's figure, and how many miss it."""
    renderer.SetPass(shadows)
    camera = renderer.GetActiveCamera()
    worst, missed = 0.0, 0
    for _ in range(views):
        camera.Azimuth(360 / views)
        renderer.ResetCameraClippingRange()
        window.Render()
        errors = errors_of(renderer)
        worst = max(worst, figure(errors, budget))
        missed += 0 if keeps(errors, budget) else 1
    return worst, missed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mesh", type=pathlib.Path, default=ROOT / "build/demo/refined_elephant.off")
    parser.add_argument("--rounds", type=int, default=8, help="0: no times")
    parser.add_argument("--views", type=int, default=12)
    parser.add_argument("--size", type=size_of, default=(1024, 768), help="WxH")
    parser.add_argument("--scenes", default="still-life,scan,tubes-and-glyphs,terrain,lot-1,lot-2,lot-3,lot-4")
    parser.add_argument("--budgets", default="0,1,0.1,0.01")
    parser.add_argument("--explain", action="store_true", help="print why, for each light")
    options = parser.parse_args()
    if "scan" in options.scenes and not options.mesh.exists():
        sys.exit(f"--mesh {options.mesh}: no such file; run Scripts/demo, which unpacks it, or name a mesh")
    budgets = [float(text) for text in options.budgets.split(",")]

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*options.size)
    print(
        "| scene | budget % | auto, static | auto, moving | best, static | best, moving | static: wall, CPU "
        "| moving: wall, CPU | error % in the view | largest of the views | views missed |\n|" + "---|" * 11
    )
    for name in options.scenes.split(","):
        renderer = scene_of(name, options.mesh)
        window.AddRenderer(renderer)
        window.Render()
        fixed, errors = {}, {}
        for way, (technique, settings) in FIXED.items() if options.rounds else ():
            fixed[way] = vtkshadows.enable(renderer, technique, **settings)
            window.Render()
            errors[way] = errors_of(renderer)
            renderer.SetPass(None)
        chosen = {}
        for budget in budgets:
            shadows = vtkshadows.enable(renderer, "auto", maximum_error=budget)
            if options.rounds:
                settle_both(renderer, window, shadows)
            chosen[budget] = shadows
            renderer.SetPass(None)
        right = {way for budget in budgets for way in fixed if keeps(errors[way], budget)}
        ways = {way: fixed[way] for way in right}
        ways.update({budget: chosen[budget] for budget in budgets})
        times = times_of(renderer, window, ways, options.rounds) if options.rounds else {}
        for budget in budgets:
            shadows = chosen[budget]
            renderer.SetPass(shadows)
            motion = Motion(renderer)
            taken = []
            for step in (motion.camera, motion.lights):
                for _ in range(LEAD):
                    step()
                    window.Render()
                taken.append(
                    "; ".join(
                        sorted({shadows.GetExplanation(light).split(":")[0] for light in switched_on(renderer)})
                    )
                )
            motion.lights(0)
            for _ in range(LEAD):
                window.Render()
            own = errors_of(renderer)
            if options.explain:
                for light in switched_on(renderer):
                    print("   ", shadows.GetExplanation(light))
            competing = [way for way in fixed if keeps(errors[way], budget)]
            best = [min(competing, key=lambda way: times[way][kind][0], default="-") for kind in (0, 1)]
            ratios = [
                "-" if not times else
                ", ".join(
                    f"{times[budget][kind][clock] / min(times[way][kind][clock] for way in competing):.2f}"
                    for clock in (0, 1)
                )
                for kind in (0, 1)
            ]
            worst, missed = views_around(renderer, window, shadows, budget, options.views)
            print(
                f"| {name} | {budget or 'no gross'} | {taken[0]} | {taken[1]} | {best[0]} | {best[1]} "
                f"| {ratios[0]} | {ratios[1]} | {figure(own, budget):.4f} | {worst:.4f} | {missed} |",
                flush=True,
            )
        renderer.SetPass(None)
        window.RemoveRenderer(renderer)


if __name__ == "__main__":
    main()
