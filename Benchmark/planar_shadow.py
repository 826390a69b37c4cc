"""Time of vtkPlanarShadowFilter: polygons alone, with their area, and as an outline.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmark/planar_shadow.py

Spheres, and the zoo's elephant if Scripts/unpack-zoo was run; a directional light, a near one and a low one.
Medians of updates of the light alone: the mesh is ready, as where a light moves.
"""
import argparse
import pathlib
import statistics
import time

import meshes
import vtkshadows
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import vtkSphereSource

ZOO = pathlib.Path(__file__).resolve().parent.parent / "build" / "zoo"
KIND = vtkshadows.vtkPlanarShadowFilter
OUTPUTS = {
    "polygons": (False, KIND.POLYGONS),
    "with area": (True, KIND.POLYGONS),
    "outline": (True, KIND.OUTLINE),
}


def sphere(resolution):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    source.Update()
    return source.GetOutput()


def lights(bounds):
    size = max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
    near = (bounds[1] + size, bounds[2] - size, bounds[5] + 2 * size, 1)
    return {"directional": (0.3, -0.5, 0.8, 0), "near": near, "low": (1, 0.5, 0.05, 0)}


def median_time(shadow, turns):
    times = []
    for _ in range(turns):
        shadow.Modified()
        start = time.perf_counter()
        shadow.Update()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def measure(name, mesh, turns):
    bounds = mesh.GetBounds()
    for light_name, light in lights(bounds).items():
        row = []
        for area, mode in OUTPUTS.values():
            shadow = KIND()
            shadow.SetInputData(mesh)
            shadow.SetLight(*light)
            shadow.SetPlaneOrigin(0, 0, bounds[4])
            shadow.SetComputeArea(area)
            shadow.SetOutputMode(mode)
            shadow.Update()
            row.append(f"{1e3 * median_time(shadow, turns):9.1f}")
        print(f"{name:16} {mesh.GetNumberOfPolys():9} {light_name:12}", *row, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--turns", type=int, default=7)
    turns = parser.parse_args().turns
    print(f"{'mesh':16} {'polygons':>9} {'light':12}", *(f"{name:>9}" for name in OUTPUTS), "(ms)")
    for resolution in (71, 224, 708):
        measure("sphere", sphere(resolution), turns)
    elephant = ZOO / "refined_elephant.off"
    if elephant.exists():
        measure("elephant", meshes.read_mesh(str(elephant)), turns)


if __name__ == "__main__":
    main()
