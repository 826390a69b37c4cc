"""The classic faults of depth maps, made on purpose and counted: Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/map_artefacts.py --output DIR

A still life under a directional light, 1024x768; a picture of each in the folder.
"""
import argparse
import pathlib

import vtkshadows
from ground_floor import directional_light, still_life, write_png
from vtkmodules.vtkRenderingCore import vtkRenderWindow

RANGE = 2.0**24  # steps of a float map's depths

ARTEFACTS = {
    "none (the default)": {},
    "acne: no bias": {"bias": (0, 0)},
    "a bias of 4 steps and 1.1 slopes": {"bias": (4, 1.1)},
    "a bias of 4 steps and 2 slopes": {"bias": (4, 2)},
    "detached shadows: a bias of 15 % of the range": {"bias": (0.15 * RANGE, 0)},
    "repetition beyond the map": {"beyond": "repeat"},
    "bars beyond the map": {"beyond": "clamp"},
    "jagged edges: 128 texels, filter none": {"resolution": 128, "filter": "none"},
    "the same, percentage-closer": {"resolution": 128},
    "acne of 8 bits without bias": {"depth_bits": 8, "bias": (0, 0)},
    "8 bits, automatic bias": {"depth_bits": 8},
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, help="folder for pictures")
    options = parser.parse_args()
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
    renderer = still_life()
    renderer.RemoveAllLights()
    renderer.AddLight(directional_light((-0.5, 0.6, -1)))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1024, 768)
    window.AddRenderer(renderer)
    print("| | mismatch % | gross false px | gross missed px |\n|---|---|---|---|")
    for i, (name, settings) in enumerate(ARTEFACTS.items()):
        vtkshadows.enable(renderer, "depth-map", **settings)
        window.Render()
        error = vtkshadows.error(renderer)
        print(
            f"| {name} | {error.mismatch_percent:.3f} | {error.gross_false_pixels} | {error.gross_missed_pixels} |",
            flush=True,
        )
        if options.output:
            write_png(options.output / f"artefact-{i}.png", window=window)
        vtkshadows.disable(renderer)


if __name__ == "__main__":
    main()
