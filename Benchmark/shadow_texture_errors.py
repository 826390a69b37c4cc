"""Error of shadow textures against ray-cast truth: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/shadow_texture_errors.py

Each scene twice: with every prop a receiver, where what shadows itself counts as wrong; and with the ground alone
as one. Then a light with a radius, over bodies of one to two units, on the ground, against a hard depth map.
"""
import vtkshadows
from ground_floor import still_life, switched_on, tubes_and_glyphs
from planar_costs import two_bodies
from vtkmodules.vtkRenderingCore import vtkRenderWindow

SIZE = 1024, 768
RADII = {"spot": (0.1, 0.3, 1.0), "directional": (0.02, 0.05, 0.2)}


def window_of(renderer):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return window


def is_ground(actor):
    bounds = actor.GetBounds()
    return bounds[5] - bounds[4] == 0


def hard(name, renderer):
    window = window_of(renderer)
    actors = list(renderer.GetActors())
    for each in (False, True):
        vtkshadows.enable(renderer, "shadow-texture", texture_per_caster=each)
        for ground_alone in (True, False):
            for actor in actors:
                vtkshadows.set_receives_shadows(actor, is_ground(actor) or not ground_alone)
            window.Render()
            for i in range(len(switched_on(renderer))):
                error = vtkshadows.error(renderer, i)
                print(
                    f"| {name}, light {i} | {'one each' if each else 'one for all'} "
                    f"| {'ground' if ground_alone else 'all'} | {error.receiver_pixels} "
                    f"| {error.mismatch_percent:.4f} "
                    f"| {error.gross_false_pixels} + {error.gross_missed_pixels} |",
                    flush=True,
                )


def soft(light):
    renderer = two_bodies(light)
    window = window_of(renderer)
    for actor in renderer.GetActors():
        vtkshadows.set_receives_shadows(actor, is_ground(actor))
    for radius in RADII[light]:
        row = []
        for technique, each in (("shadow-texture", False), ("shadow-texture", True), ("depth-map", False)):
            vtkshadows.enable(
                renderer, technique, radius=radius, texture_per_caster=each, light_samples=256
            )
            window.Render()
            row.append(f"{vtkshadows.error(renderer).mean_absolute_difference:.4f}")
        print(f"| {light} | {radius} | " + " | ".join(row) + " |", flush=True)


def main():
    print("| scene | textures | receivers | pixels | mismatch % | gross false + missed |")
    print("|---|---|---|---|---|---|")
    hard("still life", still_life())
    hard("tubes and glyphs", tubes_and_glyphs())
    print("| light | radius | one for all | one each | hard |\n|---|---|---|---|---|")
    for light in RADII:
        soft(light)


if __name__ == "__main__":
    main()
