"""What each cost saver of the shadow volumes brings: frame times with one of them off at a time.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/volume_costs.py

Scenes: those of ground_floor.py, and a crowd: 400 spheres on a long floor, a few of them in view. Static: the
camera moves. Moving: every light moves each frame. Ratios are medians of those over the same frame without
shadows, taken in turn; the ray cast is there to compare with.
"""
import argparse
import json
import pathlib

import ground_floor
import vtkshadows
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

AUTOMATIC, Z_FAIL = 0, 1  # vtkStencilShadowVolumePass::VariantType
AUTOMATIC_COUNTER, WRAPPING_STENCIL, FLOAT_COUNTER = 0, 1, 2

DEFAULTS = {
    "Variant": AUTOMATIC,
    "Counter": AUTOMATIC_COUNTER,
    "OneSidedClosedPieces": True,
    "Culling": True,
    "Confinement": True,
    "MergedDraws": True,
}

CASES = {
    "all savers": {},
    "caps always (z-fail)": {"Variant": Z_FAIL},
    "every triangle casts": {"OneSidedClosedPieces": False},
    "every triangle casts, caps always": {"OneSidedClosedPieces": False, "Variant": Z_FAIL},
    "no caster left out": {"Culling": False},
    "volumes to infinity, no scissor": {"Confinement": False},
    "caps always, a call for each kind of faces": {"Variant": Z_FAIL, "MergedDraws": False},
    "counted in floats": {"Counter": FLOAT_COUNTER},
    "counted in a wrapping stencil": {"Counter": WRAPPING_STENCIL},
    "none of them": {
        "Variant": Z_FAIL,
        "OneSidedClosedPieces": False,
        "Culling": False,
        "Confinement": False,
        "MergedDraws": False,
        "Counter": FLOAT_COUNTER,
    },
}


def crowd():
    renderer = vtkRenderer()
    for i in range(20):
        for j in range(20):
            sphere = vtkSphereSource()
            sphere.SetCenter(3.0 * (i - 9.5), 3.0 * j, 0.8)
            sphere.SetRadius(0.8)
            sphere.SetThetaResolution(48)
            sphere.SetPhiResolution(32)
            renderer.AddActor(ground_floor.mesh_actor(sphere, (0.85, 0.55, 0.35)))
    renderer.AddActor(ground_floor.floor_actor(70, 0))
    renderer.AddLight(ground_floor.directional_light((0.6, 0.4, -1)))
    ground_floor.place_camera(renderer, (0, -9, 6), (0, 3, 0.5))
    return renderer


def measure(name, renderer, window, rounds):
    renderer.SetBackground(0.86, 0.89, 0.92)
    window.AddRenderer(renderer)
    window.Render()
    shadows = vtkshadows.enable(renderer, "stencil-volume")
    volumes = shadows.GetStencilShadowVolumePass()
    rows = []
    for case, settings in CASES.items():
        for setting, value in {**DEFAULTS, **settings}.items():
            getattr(volumes, f"Set{setting}")(value)
        row = {"scene": name, "case": case}
        window.Render()
        row["casters"] = (
            f"{volumes.GetNumberOfZPassCasters()} + {volumes.GetNumberOfZFailCasters()}"
            f" - {volumes.GetNumberOfCulledCasters()}"
        )
        row["faces"] = volumes.GetNumberOfFaces()
        row["calls"] = volumes.GetNumberOfDraws()
        row["bytes_per_triangle"] = volumes.GetMemoryInBytes() / max(volumes.GetNumberOfTriangles(), 1)
        row.update(ground_floor.frame_times(renderer, window, shadows, rounds))
        rows.append(row)
        print_row(row)
    if "ray-cast" in vtkshadows.techniques():
        shadows = vtkshadows.enable(renderer, "ray-cast")
        row = {"scene": name, "case": "ray cast"}
        row.update(ground_floor.frame_times(renderer, window, shadows, rounds))
        rows.append(row)
        print_row(row)
    vtkshadows.disable(renderer)
    window.RemoveRenderer(renderer)
    return rows


def print_row(row):
    print(
        f"| {row['scene']} | {row['case']} | {row.get('casters', '')} | {row.get('faces', '')} "
        f"| {row.get('calls', '')} | {row['ratio_static']:.2f} | {row['ratio_moving']:.2f} "
        f"| {row.get('bytes_per_triangle', 0):.0f} |",
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mesh", type=pathlib.Path, default=ground_floor.ROOT / "build/demo/refined_elephant.off")
    parser.add_argument("--rounds", type=int, default=16)
    parser.add_argument("--scenes", default="still-life,scan,tubes-and-glyphs,crowd")
    parser.add_argument("--size", default="1024x768")
    parser.add_argument("--json", type=pathlib.Path)
    options = parser.parse_args()
    makers = {
        "still-life": ground_floor.still_life,
        "scan": lambda: ground_floor.scan(options.mesh),
        "tubes-and-glyphs": ground_floor.tubes_and_glyphs,
        "crowd": crowd,
    }
    unknown = set(options.scenes.split(",")) - set(makers)
    if unknown:
        parser.error(f"--scenes {','.join(sorted(unknown))}: known are {','.join(makers)}")

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*ground_floor.size_of(options.size))
    heads = "scene, case, casters: z-pass + z-fail - left out, faces drawn, calls, static, moving, bytes a triangle"
    print("| " + heads.replace(", ", " | ") + " |")
    print("|" + "---|" * 8)
    rows = []
    for name in options.scenes.split(","):
        rows += measure(name, makers[name](), window, options.rounds)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
