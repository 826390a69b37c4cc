"""How far cascades are from the truth, and whether they shimmer: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/cascade_errors.py

Terrains 10 km wide by lot, seen from 2 m above ground, 1024x768, software OpenGL.

Errors: four cascades of 1024 texels, and one map of 2048, against the ray cast. A view in which fewer than a tenth of
the pixels are measured is left out.

Numbers: errors of one view by 1 to 8 cascades, and by each scheme.

Shimmer: share of the pixels whose visibility passes 0.5 although neither what they show nor the light has changed. So
the picture's camera stands still, and the cascades are fitted to another one at its place, whose view holds the
picture's, and which turns in small steps (vtkMapShadowPass::SetFitCamera). Whatever differs from one step to the next
is the cascades' own doing; the truth is one and the same. Then it walks, and the pixels nearest to a seam between cascades
may change theirs.
"""
import argparse

import vtkshadows
from terrain import look, terrain
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderWindow

SUNS = (15, 8, 25, 40)  # degrees above the horizon
SCHEMES = ("practical", "logarithmic", "uniform")


def maps_of(renderer, resolution, cascades, **settings):
    """The renderer's depth maps, with these settings from its next frame on."""
    shadows = vtkshadows.enable(renderer, "depth-map", resolution=resolution, cascades=cascades, **settings)
    return shadows.GetDepthShadowMapPass()


def measured(window, renderer, *settings):
    maps_of(renderer, *settings)
    window.Render()
    return vtkshadows.error(renderer)


def errors(window, seeds):
    print("| terrain | sun | azimuth | measured px | in shadow | one map of 2048 | four cascades of 1024 | gross px |")
    print("|---|---|---|---|---|---|---|---|")
    worst, least_gain = 0.0, float("inf")
    for seed in seeds:
        renderer, eye = terrain(seed, SUNS[seed % len(SUNS)])
        window.AddRenderer(renderer)
        for azimuth in range(0, 360, 60):
            look(renderer, eye, azimuth)
            one = measured(window, renderer, 2048, 1)
            if one.receiver_pixels < 0.1 * one.truth.size:
                continue
            four = measured(window, renderer, 1024, 4)
            worst = max(worst, four.mismatch_percent)
            least_gain = min(least_gain, one.mismatch_percent / max(four.mismatch_percent, 1e-6))
            print(
                f"| {seed} | {SUNS[seed % len(SUNS)]} | {azimuth} | {one.receiver_pixels} | {one.shadow_pixels} "
                f"| {one.mismatch_percent:.2f} % | {four.mismatch_percent:.2f} % | {four.gross_pixels} |",
                flush=True,
            )
        window.RemoveRenderer(renderer)
    print(f"four cascades: {worst:.2f} % at worst; one map has {least_gain:.1f} times as much or more")


def numbers(window, seed):
    """What each further cascade brings, and each scheme."""
    renderer, eye = terrain(seed, SUNS[seed % len(SUNS)])
    window.AddRenderer(renderer)
    look(renderer, eye, 60)
    for scheme in SCHEMES:
        row = []
        for count in (1, 2, 3, 4, 6, 8):
            maps_of(renderer, 1024, count).SetCascadeScheme(scheme)
            window.Render()
            row.append(f"{vtkshadows.error(renderer).mismatch_percent:.2f}")
        print(f"terrain {seed}, {scheme}: mismatch by 1, 2, 3, 4, 6, 8 cascades: {', '.join(row)} %", flush=True)
    window.RemoveRenderer(renderer)


def shimmer(window, seed, steps):
    renderer, eye = terrain(seed, SUNS[seed % len(SUNS)])
    window.AddRenderer(renderer)
    look(renderer, eye, 300)
    camera = renderer.GetActiveCamera()
    wide = vtkCamera()
    for name, turn, walk in (("turning by 0.25 degrees", 0.25, 0.0), ("walking by 0.5 m", 0.0, 0.5)):
        wide.DeepCopy(camera)
        camera.SetViewAngle(12)
        maps = maps_of(renderer, 1024, 4)
        maps.SetFitCamera(wide)
        wide.Yaw(-turn * steps / 2)
        before, worst, flips, drawn = None, 0.0, 0, maps.GetNumberOfMapBuilds()
        for _ in range(steps):
            window.Render()
            now = vtkshadows.visibility(renderer) > 0.5
            if before is not None:
                different = int((now != before).sum())
                worst, flips = max(worst, 100 * different / now.size), flips + different
            before = now
            wide.Yaw(turn)
            direction = wide.GetDirectionOfProjection()
            wide.SetPosition([p - walk * d for p, d in zip(wide.GetPosition(), direction)])
            wide.SetFocalPoint([p + d for p, d in zip(wide.GetPosition(), direction)])
        print(
            f"terrain {seed}, {name}, {steps} steps, {100 * (1 - before.mean()):.0f} % in shadow: "
            f"at worst {worst:.4f} % of the pixels flip in a step, "
            f"{100 * flips / now.size / (steps - 1):.5f} % in the mean; "
            f"{maps.GetNumberOfMapBuilds() - drawn} maps drawn",
            flush=True,
        )
        maps.SetFitCamera(None)
        camera.SetViewAngle(30)
    window.RemoveRenderer(renderer)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", default="1,2,3,4,5,6")
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--only", choices=("errors", "numbers", "shimmer"), help="one of the three figures")
    options = parser.parse_args()
    seeds = [int(seed) for seed in options.seeds.split(",")]
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1024, 768)
    if options.only in (None, "errors"):
        errors(window, seeds)
    if options.only in (None, "numbers"):
        numbers(window, seeds[-1])
    if options.only in (None, "shimmer"):
        for seed in seeds[:2]:
            shimmer(window, seed, options.steps)


if __name__ == "__main__":
    main()
