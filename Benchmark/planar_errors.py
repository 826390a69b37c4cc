"""How far planar shadows are from the truth: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/planar_errors.py

Sphere, torus, cone and cube that take no shadows, over a floor that does, 1024x768. Hard shadows: the light from
overhead to grazing; lights, planes and views by lot, at tilts and offsets of up to 1e6 times the scene. The error
measure leaves out what a light grazes, so that near 90 degrees pixels are counted that are unlike the ray cast's.
Soft ones: each method, by the light's size, against a ray cast of 256 sample lights.
"""
import argparse
import math
import random

import vtkshadows
from ground_floor import directional_light, spot_light, still_life, switched_on
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkRenderWindow

SIZE = (1024, 768)


def scene(window, place=None):
    """A still life of which the floor alone receives, without lights."""
    renderer = still_life()
    renderer.RemoveAllLights()
    window.AddRenderer(renderer)
    actors = renderer.GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        bounds = actor.GetBounds()
        vtkshadows.set_receives_shadows(actor, bounds[4] == bounds[5])
        if place:
            actor.SetUserMatrix(place)
    return renderer


def away(place, point):
    return place.MultiplyPoint((*point, 1.0))[:3]


def by_lot(rng):
    """A rigid placement, its offset up to 1e6."""
    transform = vtkTransform()
    transform.Translate(*(rng.gauss(0, 1) * 10 ** rng.uniform(0, 6) for _ in range(3)))
    transform.RotateWXYZ(rng.uniform(0, 360), *(rng.gauss(0, 1) for _ in range(3)))
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(transform.GetMatrix())
    return matrix


def angles(window):
    print("| light | degrees from the normal | receiver px | in shadow | unlike the ray cast |")
    print("|---|---|---|---|---|")
    for degrees in (0, 30, 60, 80, 85, 88, 89, 89.9):
        renderer = scene(window)
        a = math.radians(degrees)
        renderer.AddLight(directional_light((-0.8 * math.sin(a), 0.6 * math.sin(a), -math.cos(a))))
        shadows = vtkshadows.enable(renderer, "planar")
        window.Render()
        got = vtkshadows.visibility(renderer)
        shadows.SetTechnique("ray-cast")
        window.Render()
        truth = vtkshadows.visibility(renderer)
        print(
            f"| directional | {degrees} | {vtkshadows.error(renderer).receiver_pixels} | {(truth < 0.5).sum()} "
            f"| {(abs(got - truth) > 0.5).sum()} |",
            flush=True,
        )
        window.RemoveRenderer(renderer)


def lots(window, cases, seed):
    rng = random.Random(seed)
    worst, gross, mean = 0.0, 0, 0.0
    for case in range(cases):
        place = by_lot(rng)
        renderer = scene(window, place)
        light = rng.choice((spot_light, directional_light))
        toward = (rng.uniform(-4, 4), rng.uniform(-4, 4), rng.uniform(1.5, 8))
        if light is spot_light:
            renderer.AddLight(spot_light(away(place, toward), away(place, (0, 0, 0.4)), rng.uniform(20, 80)))
        else:
            zero = away(place, (0, 0, 0))
            renderer.AddLight(directional_light([z - t for z, t in zip(zero, away(place, toward))]))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(away(place, (rng.uniform(-6, 6), rng.uniform(-9, -5), rng.uniform(1, 7))))
        camera.SetFocalPoint(away(place, (0, 0, 0.5)))
        camera.SetViewUp([a - b for a, b in zip(away(place, (0, 0, 1)), away(place, (0, 0, 0)))])
        renderer.ResetCameraClippingRange()
        vtkshadows.enable(renderer, "planar")
        window.Render()
        error = vtkshadows.error(renderer)
        worst = max(worst, error.mismatch_percent)
        mean += error.mismatch_percent / cases
        gross += error.gross_pixels
        window.RemoveRenderer(renderer)
    print(f"{cases} by lot, seed {seed}: mismatch {mean:.4f} % in the mean, {worst:.4f} % at worst; gross {gross} px")


def soft(window):
    print("| light | radius | sample lights | offset planes | plateaus | shadows drawn |\n|---|---|---|---|---|---|")
    lights = {
        "spot": (lambda: spot_light((4, -4, 7), (0, 0, 0.4), 32), (0.1, 0.3, 1.0)),
        "directional": (lambda: directional_light((-0.5, 0.6, -1)), (0.02, 0.05, 0.2)),
    }
    for name, (make, radii) in lights.items():
        for radius in radii:
            renderer = scene(window)
            renderer.AddLight(make())
            shadows = vtkshadows.enable(renderer, "planar", radius=radius)
            shadows.GetRayCastShadowPass().SetLightSamples(256)
            differences = []
            throws = 0
            for method in ("sample-lights", "offset-planes", "plateaus"):
                vtkshadows.enable(renderer, "planar", soft_method=method)
                window.Render()
                throws = max(throws, shadows.GetPlanarShadowPass().GetNumberOfThrows())
                differences.append(vtkshadows.error(renderer, switched_on(renderer)[0]).mean_absolute_difference)
            print(f"| {name} | {radius} | " + " | ".join(f"{d:.4f}" for d in differences) + f" | {throws} |", flush=True)
            window.RemoveRenderer(renderer)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    angles(window)
    lots(window, options.cases, options.seed)
    soft(window)


if __name__ == "__main__":
    main()
