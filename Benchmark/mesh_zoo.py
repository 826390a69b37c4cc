"""Error of a technique over a zoo of meshes: scanned, made by CAD, open, non-manifold, degenerate.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Benchmark/mesh_zoo.py

The zoo is every surface of Debian's libcgal-demo (unpacked to build/zoo by Scripts/unpack-zoo; other files
with --meshes) and the made ones of meshes.py. Each stands over a floor, where it is: it is neither moved nor
scaled, welded or triangulated. There are three lights, each a case of its own: directional, a point outside
the mesh's bounds, a point inside. Views and lights are drawn by lot from --seed, the mesh's name, the light
and the number of the view: --only repeats a case of the whole run, another seed shows views not seen before.
A light in the plane of a flat mesh is left out, and counted: there shadow is decided by rounding.

Measured is the technique against ray-cast truth (Docs/Techniques.md): mismatch, and gross false and missed
shadow. Lines come as cases end: if the process dies, the last one names the mesh and light.

Exit status: 0; 1 if a mesh cannot be read or measured, or stencil-volume breaks a bound below; 2 for a
wrong option.
"""
import argparse
import collections
import faulthandler
import fnmatch
import itertools
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import time

import meshes
import numpy
import vtkshadows
from ground_floor import (
    actor_of,
    directional_light,
    floor_actor,
    place_camera,
    size_of,
    spot_light,
    write_png,
)
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What stencil-volume is held to. Gross is in pixels, false and missed together.
GROSS_PER_MILLION_LIMIT = 1.0  # of all receiver pixels
GROSS_PER_CASE_LIMIT = 5
MISMATCH_MEAN_LIMIT = 0.005  # %
MISMATCH_MAX_LIMIT = 0.1  # %
BOUND_TECHNIQUE = "stencil-volume"

# Share of a case's pixels, above which it is told that its truth was uncertain there: they count nowhere.
UNCERTAIN_LIMIT = 0.01

LIGHTS = ("directional", "point-outside", "point-inside")
VIEW_ANGLE = 30  # degrees, vertical
FLAT = 1e-6  # thickness, in diagonals, up to which a mesh is flat
IN_PLANE = 1e-3  # distance in diagonals, or sine, up to which a light is in a flat mesh's plane
FAST_STRIDE = 8  # --fast takes each so many-th file

Case = collections.namedtuple("Case", "mesh light view")


# --- The zoo -----------------------------------------------------------------------------------------


def zoo_of(options):
    """Name to reader, files first."""
    folder = options.meshes
    if folder is None:
        folder = ROOT / "build/zoo"
        subprocess.run([str(ROOT / "Scripts/unpack-zoo")], check=True, stdout=sys.stderr)
    elif not folder.is_dir():
        sys.exit(f"--meshes {folder}: no such folder")
    files = {path.name: path for path in sorted(folder.iterdir()) if path.is_file()}
    made = dict(meshes.MADE)
    if options.only:
        files = {name: path for name, path in files.items() if is_named(name, options.only)}
        made = {name: maker for name, maker in made.items() if is_named(name, options.only)}
        for wanted in options.only:
            if not any(is_named(name, [wanted]) for name in (*files, *made)):
                sys.exit(f"--only {wanted}: there is no such mesh in {folder}, nor is it a made one")
    elif options.fast:
        files = {name: files[name] for name in list(files)[::FAST_STRIDE]}
        made = {name: maker for name, maker in made.items() if name not in meshes.LARGE}
    readers = {name: lambda path=path: meshes.read_mesh(path) for name, path in files.items()}
    readers.update({name: lambda make=make: make(folder) for name, make in made.items()})
    return readers


def is_named(name, patterns):
    return any(fnmatch.fnmatchcase(name, p) or pathlib.Path(name).stem == p for p in patterns)


# --- A scene -----------------------------------------------------------------------------------------


class Stage:
    """A mesh over a floor; `show` gives it one case's light and view."""

    def __init__(self, name, mesh, seed):
        self.name = name
        self.seed = seed
        points = meshes.surface_points(mesh)
        if not len(points):
            raise ValueError("none of its faces has finite points")
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.center = (self.low + self.high) / 2
        self.diagonal = float(numpy.linalg.norm(self.high - self.low))
        if self.diagonal == 0:
            raise ValueError("all its faces are in one point")
        # An upright flat mesh stands on its edge; one that lies would hide in the floor.
        height = self.high[2] - self.low[2]
        self.floor = self.low[2] - (0.25 * self.diagonal if height < 0.05 * self.diagonal else 0)
        self.half_width = 1.5 * float((self.high - self.low).max())
        self.plane = plane_of(points, self.center, self.diagonal)
        self.triangles = meshes.triangle_count(mesh)

        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        body = actor_of(mapper, (0.62, 0.68, 0.78))
        body.GetProperty().SetInterpolationToFlat()
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.86, 0.89, 0.92)
        self.renderer.AddActor(body)
        self.renderer.AddActor(floor_actor(self.half_width, self.floor, self.center[:2]))

    def show(self, case, aspect):
        """The case's light, or None if it is left out; `aspect` is the window's width over its height."""
        # A generator of its own, so that a case does not depend on those before it.
        lot = random.Random(f"{self.seed}/{self.name}/{case.light}/{case.view}")
        light = self._light(case.light, lot)
        if self._is_in_plane(light):
            return None
        self.renderer.RemoveAllLights()
        self.renderer.AddLight(light)
        self._place_camera(light, lot, aspect)
        return light

    def _light(self, kind, lot):
        if kind == "directional":
            return directional_light(-from_angles(lot.uniform(0, 360), lot.uniform(20, 80)))
        if kind == "point-outside":
            away = lot.uniform(0.8, 2.5) * self.diagonal
            position = self.center + away * from_angles(lot.uniform(0, 360), lot.uniform(20, 80))
        else:
            inside = numpy.array([lot.uniform(0.1, 0.9) for _ in range(3)])
            position = self.low + inside * (self.high - self.low)
        return spot_light(position, position - (0, 0, self.diagonal), 90)  # 90 degrees: a point light

    def _is_in_plane(self, light):
        if self.plane is None:
            return False
        position = numpy.array(light.GetPosition())
        if light.GetPositional():
            sine = numpy.dot(position - self.center, self.plane) / self.diagonal
        else:
            sine = numpy.dot(position, self.plane) / numpy.linalg.norm(position)
        return abs(sine) < IN_PLANE

    def _place_camera(self, light, lot, aspect):
        """From where the mesh is whole in view, and its shadow as far as the floor goes."""
        corners = numpy.array(list(itertools.product(*zip(self.low, self.high))))
        seen = numpy.concatenate((corners, self._shadow(light, corners)))
        focus = (seen.min(axis=0) + seen.max(axis=0)) / 2
        toward = from_angles(lot.uniform(0, 360), lot.uniform(10, 65))
        right = numpy.cross((0, 0, 1), toward)
        right /= numpy.linalg.norm(right)
        up = numpy.cross(toward, right)
        slope = math.tan(math.radians(VIEW_ANGLE / 2))
        off = seen - focus
        distance = (off @ toward + numpy.maximum(abs(off @ up), abs(off @ right) / aspect) / slope).max()
        place_camera(self.renderer, focus + 1.05 * distance * toward, focus, VIEW_ANGLE)

    def _shadow(self, light, corners):
        """Where the floor is shadowed by `corners`, those it has, drawn in to the floor's edge."""
        position = numpy.array(light.GetPosition())
        shadows = []
        for corner in corners:
            along = corner - position if light.GetPositional() else -position
            if along[2] >= 0:
                continue
            hit = corner + along * (self.floor - corner[2]) / along[2]
            reach = self.half_width / max(self.half_width, *abs(hit - self.center)[:2])
            shadows.append((*(self.center + reach * (hit - self.center))[:2], self.floor))
        return numpy.array(shadows).reshape(-1, 3)


def plane_of(points, center, diagonal):
    """The normal of the plane in which all points are; None if there is none."""
    moments = (points - center).T @ (points - center) / len(points)
    normal = numpy.linalg.eigh(moments)[1][:, 0]  # of the least eigenvalue
    distances = (points - center) @ normal
    return normal if distances.max() - distances.min() <= FLAT * diagonal else None


def from_angles(azimuth, elevation):
    """Unit vector; degrees."""
    azimuth, elevation = math.radians(azimuth), math.radians(elevation)
    return numpy.array((math.cos(azimuth) * math.cos(elevation), math.sin(azimuth) * math.cos(elevation),
                        math.sin(elevation)))


# --- Measuring ---------------------------------------------------------------------------------------


class Zoo:
    """Walks through the meshes in one window and keeps what it found."""

    def __init__(self, options):
        self.options = options
        self.readers = zoo_of(options)
        # One for all: many windows in a process abort on VTK 9.2.
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*options.size)
        self.rows = []
        self.skipped = {}  # no surfaces: name to reason
        self.left_out = []  # cases whose light is in a flat mesh's plane
        self.failures = {}  # name to message

    def measure_all(self):
        for name in self.readers:
            self.with_stage(name, self._measure_mesh)

    def with_stage(self, name, act):
        """Call act(stage), the mesh's renderer being the window's; what fails is noted."""
        try:
            stage = Stage(name, self.readers[name](), self.options.seed)
        except meshes.NoSurface as reason:
            self.skipped[name] = str(reason)
            print(f"{name:34} skipped: {reason}", flush=True)
            return
        except Exception as failure:
            self._fail(name, failure)
            return
        self.window.AddRenderer(stage.renderer)
        vtkshadows.enable(stage.renderer, self.options.technique)
        try:
            act(stage)
        except Exception as failure:
            self._fail(name, failure)
        finally:
            vtkshadows.disable(stage.renderer)
            self.window.RemoveRenderer(stage.renderer)

    def _fail(self, name, failure):
        self.failures[name] = f"{type(failure).__name__}: {failure}"
        print(f"{name:34} FAILED: {self.failures[name]}", flush=True)

    def _measure_mesh(self, stage):
        for view in range(self.options.views):
            for light in LIGHTS:
                self._measure_case(stage, Case(stage.name, light, view))

    def _measure_case(self, stage, case):
        light = stage.show(case, self._aspect())
        print(f"{stage.name:34} {stage.triangles:9} {case.light:13} {case.view:4} ", end="", flush=True)
        if light is None:
            self.left_out.append(case)
            print("left out: the light is in the flat mesh's plane", flush=True)
            return
        begin = time.perf_counter()
        self.window.Render()
        error = vtkshadows.error(stage.renderer, light)
        camera = stage.renderer.GetActiveCamera()
        row = {
            "mesh": stage.name,
            "triangles": stage.triangles,
            "light": case.light,
            "view": case.view,
            "receiver_pixels": error.receiver_pixels,
            "shadow_pixels": error.shadow_pixels,
            "uncertain_pixels": error.uncertain_pixels,
            "mismatch_percent": error.mismatch_percent,
            "gross_false_pixels": error.gross_false_pixels,
            "gross_missed_pixels": error.gross_missed_pixels,
            "seconds": time.perf_counter() - begin,
            "light_position": light.GetPosition(),
            "camera_position": camera.GetPosition(),
            "camera_focal_point": camera.GetFocalPoint(),
        }
        self.rows.append(row)
        print(figures_of(row), flush=True)

    def _aspect(self):
        return self.options.size[0] / self.options.size[1]

    def write_pictures(self, rows):
        """Picture and error map of each row's case, which is shown again."""
        for row in rows:
            case = Case(row["mesh"], row["light"], row["view"])

            def write(stage, case=case):
                light = stage.show(case, self._aspect())
                self.window.Render()
                name = f"{case.mesh}-{case.light}-{case.view}"
                write_png(self.options.output / f"{name}.png", window=self.window)
                error = vtkshadows.vtkShadowErrorMeasure()
                error.Measure(stage.renderer, light)
                write_png(self.options.output / f"{name}-error.png", image=error.GetErrorMap())

            self.with_stage(case.mesh, write)


def gross_of(row):
    return row["gross_false_pixels"] + row["gross_missed_pixels"]


def is_hardly_measured(row):
    return row["uncertain_pixels"] >= UNCERTAIN_LIMIT * (row["receiver_pixels"] + row["uncertain_pixels"])


def figures_of(row):
    gross = f"{row['gross_false_pixels']} + {row['gross_missed_pixels']}"
    return (f"{row['mismatch_percent']:10.4f} {gross:>15} {row['uncertain_pixels']:9} "
            f"{row['receiver_pixels']:9} {row['seconds']:7.2f}")


HEADER = (f"{'mesh':34} {'triangles':>9} {'light':13} view {'mismatch %':>10} {'gross f. + m.':>15} "
          f"{'uncertain':>9} {'receivers':>9} {'seconds':>7}")


# --- The end -----------------------------------------------------------------------------------------


def summary_of(zoo):
    rows = zoo.rows
    receivers = sum(row["receiver_pixels"] for row in rows)
    gross = sum(gross_of(row) for row in rows)
    mismatches = [row["mismatch_percent"] for row in rows]
    return {
        "technique": zoo.options.technique,
        "vtk": vtkVersion.GetVTKVersion(),
        "seed": zoo.options.seed,
        "size": "{}x{}".format(*zoo.options.size),
        "meshes": len({row["mesh"] for row in rows}),
        "cases": len(rows),
        "cases_left_out": len(zoo.left_out),
        "receiver_pixels": receivers,
        "uncertain_pixels": sum(row["uncertain_pixels"] for row in rows),
        "gross_false_pixels": sum(row["gross_false_pixels"] for row in rows),
        "gross_missed_pixels": sum(row["gross_missed_pixels"] for row in rows),
        "gross_per_million": 1e6 * gross / max(receivers, 1),
        "mismatch_mean_percent": statistics.fmean(mismatches),
        "mismatch_max_percent": max(mismatches),
        "cases_over_gross_limit": sum(gross_of(row) > GROSS_PER_CASE_LIMIT for row in rows),
        "cases_hardly_measured": sum(is_hardly_measured(row) for row in rows),
    }


def broken_bounds(summary):
    bounds = (
        ("gross_per_million", GROSS_PER_MILLION_LIMIT),
        ("cases_over_gross_limit", 0),
        ("mismatch_mean_percent", MISMATCH_MEAN_LIMIT),
        ("mismatch_max_percent", MISMATCH_MAX_LIMIT),
    )
    # Written so that NaN breaks a bound.
    return [f"{name} is {summary[name]:.6g}, at most {limit:g} is allowed"
            for name, limit in bounds if not summary[name] <= limit]


def print_summary(zoo, summary, worst, seconds):
    print(f"\n{summary['technique']}, VTK {summary['vtk']}, {summary['size']}, seed {summary['seed']}, "
          f"{seconds:.0f} s")
    print(f"meshes {summary['meshes']}, cases {summary['cases']}, left out {summary['cases_left_out']}, "
          f"skipped {len(zoo.skipped)}, failed {len(zoo.failures)}")
    print(f"receiver pixels {summary['receiver_pixels']}, uncertain {summary['uncertain_pixels']}")
    print(f"gross false {summary['gross_false_pixels']}, missed {summary['gross_missed_pixels']}: "
          f"{summary['gross_per_million']:.3f} per million receiver pixels")
    print(f"mismatch mean {summary['mismatch_mean_percent']:.5f} %, "
          f"max {summary['mismatch_max_percent']:.4f} %")
    print(f"cases with gross above {GROSS_PER_CASE_LIMIT}: {summary['cases_over_gross_limit']}; "
          f"hardly measured: {summary['cases_hardly_measured']}")
    for name, reason in zoo.skipped.items():
        print(f"skipped {name}: {reason}")
    print_rows(f"Hardly measured, the truth being uncertain in {UNCERTAIN_LIMIT:.0%} of the pixels or more",
               filter(is_hardly_measured, zoo.rows))
    print_rows(f"The {len(worst)} worst", worst)


def print_rows(title, rows):
    lines = [f"{row['mesh']:34} {row['triangles']:9} {row['light']:13} {row['view']:4} {figures_of(row)}"
             for row in rows]
    if lines:
        print("\n".join([f"\n{title}:", HEADER, *lines]))


def options_of(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--technique", default=BOUND_TECHNIQUE)
    parser.add_argument("--meshes", type=pathlib.Path, help="folder; left out: libcgal-demo's, unpacked")
    parser.add_argument("--only", type=lambda text: text.split(","), help="names or patterns, by commas")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--views", type=int, default=1, help="views of each mesh and light (1)")
    parser.add_argument("--size", type=size_of, default=(1024, 768), help="of the window (1024x768)")
    parser.add_argument("--worst", type=int, default=10, help="how many to list and picture (10)")
    parser.add_argument("--json", type=pathlib.Path, help="file for all rows")
    parser.add_argument("--output", type=pathlib.Path, help="folder for the worst: pictures and error maps")
    parser.add_argument("--fast", action="store_true",
                        help=f"each {FAST_STRIDE}th file and the small made ones")
    options = parser.parse_args(arguments)
    if options.technique not in vtkshadows.techniques():
        parser.error(f"--technique {options.technique}: there are {', '.join(vtkshadows.techniques())}")
    if options.views < 1:
        parser.error(f"--views {options.views}: give 1 or more")
    return options


def main():
    faulthandler.enable()
    options = options_of(sys.argv[1:])
    begin = time.perf_counter()
    zoo = Zoo(options)
    print(HEADER)
    zoo.measure_all()
    if not zoo.rows:
        sys.exit("nothing was measured")

    summary = summary_of(zoo)
    worst = sorted(zoo.rows, key=lambda row: (gross_of(row), row["mismatch_percent"]), reverse=True)
    worst = worst[: options.worst]
    print_summary(zoo, summary, worst, time.perf_counter() - begin)
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
        zoo.write_pictures(worst)
    if options.json:
        everything = {
            "summary": summary,
            "rows": zoo.rows,
            "left_out": [case._asdict() for case in zoo.left_out],
            "skipped": zoo.skipped,
            "failures": zoo.failures,
        }
        options.json.write_text(json.dumps(everything, indent=2) + "\n")

    broken = broken_bounds(summary) if options.technique == BOUND_TECHNIQUE else []
    for name, failure in zoo.failures.items():
        print(f"FAILED {name}: {failure}")
    for bound in broken:
        print(f"BROKEN {bound}")
    return 1 if broken or zoo.failures else 0


if __name__ == "__main__":
    sys.exit(main())
