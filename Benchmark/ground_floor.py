"""Error and time of the techniques on three scenes: the table in README.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/ground_floor.py

- still life: sphere, torus, cone and cube on a table, one spot light;
- scan: a scanned mesh with self-shadows under a directional light (Debian's refined_elephant, unpacked by
  Scripts/demo; another with --mesh);
- tubes and glyphs: 200 000 triangles of thin things, a spot and a directional light.

Times are medians of frames taken in turn (unshadowed, static, moving, and again), so that a noisy machine
slows all of them; a ratio is the median of the ratios of each turn. Static: the camera moves. Moving: every
light moves each frame.
"""
import argparse
import json
import math
import pathlib
import statistics
import sys
import time

import vtkshadows
from meshes import read_off
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import (
    vtkArrowSource,
    vtkConeSource,
    vtkCubeSource,
    vtkParametricFunctionSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

ROOT = pathlib.Path(__file__).resolve().parent.parent


def actor_of(mapper, color):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbientColor(color)
    actor.GetProperty().SetAmbient(0.22)
    return actor


def mesh_actor(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    return actor_of(mapper, color)


def torus_source(u, v):
    torus = vtkParametricFunctionSource()
    torus.SetParametricFunction(vtkParametricTorus())
    torus.SetUResolution(u)
    torus.SetVResolution(v)
    torus.SetWResolution(2)
    return torus


def floor_actor(half_width, height, center=(0, 0)):
    x, y = center
    plane = vtkPlaneSource()
    plane.SetOrigin(x - half_width, y - half_width, height)
    plane.SetPoint1(x + half_width, y - half_width, height)
    plane.SetPoint2(x - half_width, y + half_width, height)
    return mesh_actor(plane, (0.82, 0.80, 0.76))


def spot_light(position, focus, cone, color=(1, 1, 1)):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.PositionalOn()
    light.SetConeAngle(cone)
    light.SetExponent(0)
    light.SetPosition(position)
    light.SetFocalPoint(focus)
    light.SetColor(color)
    return light


def directional_light(along, color=(1, 1, 1)):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition([-a for a in along])
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(color)
    return light


def place_camera(renderer, position, focus, angle=30):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focus)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()


def still_life():
    sphere = vtkSphereSource()
    sphere.SetRadius(1)
    sphere.SetCenter(-0.6, 0.2, 1)
    sphere.SetThetaResolution(96)
    sphere.SetPhiResolution(96)
    ring = mesh_actor(torus_source(96, 48), (0.35, 0.55, 0.85))
    ring.SetScale(0.6)
    ring.RotateX(65)
    ring.SetPosition(1.5, -0.6, 0.86)
    cone = vtkConeSource()
    cone.SetHeight(1.6)
    cone.SetRadius(0.6)
    cone.SetResolution(72)
    cone.SetDirection(0, 0, 1)
    cone.SetCenter(0.7, 1.5, 0.8)
    cube = vtkCubeSource()
    block = mesh_actor(cube, (0.55, 0.7, 0.4))
    block.RotateZ(28)
    block.SetPosition(-1.7, -1.2, 0.5)

    renderer = vtkRenderer()
    for actor in (
        mesh_actor(sphere, (0.88, 0.5, 0.3)),
        ring,
        mesh_actor(cone, (0.85, 0.75, 0.35)),
        block,
        floor_actor(6, 0),
    ):
        renderer.AddActor(actor)
    renderer.AddLight(spot_light((4, -4, 7), (0, 0, 0.4), 32))
    place_camera(renderer, (1.2, -8.6, 4.6), (0, 0, 0.55))
    return renderer


def scan(path):
    mesh = read_off(path)
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    animal = mesh_actor(normals, (0.62, 0.68, 0.78))
    animal.RotateX(90)  # it stands along y
    low, high = animal.GetBounds()[4:6]
    renderer = vtkRenderer()
    renderer.AddActor(animal)
    renderer.AddActor(floor_actor(1.5 * (high - low), low))
    renderer.AddLight(directional_light((-0.5, 0.6, -1)))
    size = high - low
    place_camera(renderer, (0.9 * size, -1.9 * size, low + 1.2 * size), (0, 0, low + 0.42 * size))
    return renderer


def helices(count, steps):
    points = vtkPoints()
    lines = vtkCellArray()
    for i in range(count):
        phase = 2.399963 * i  # the golden angle spreads them
        radius = 0.25 + 0.09 * (i % 7)
        x, y = 1.9 * math.cos(phase) * math.sqrt(i / count), 1.9 * math.sin(phase) * math.sqrt(i / count)
        lines.InsertNextCell(steps)
        for s in range(steps):
            t = s / (steps - 1)
            turn = phase + 5.0 * math.pi * t
            lines.InsertCellPoint(
                points.InsertNextPoint(
                    x + radius * math.cos(turn), y + radius * math.sin(turn), 0.1 + 2.2 * t
                )
            )
    curves = vtkPolyData()
    curves.SetPoints(points)
    curves.SetLines(lines)
    tube = vtkTubeFilter()
    tube.SetInputData(curves)
    tube.SetRadius(0.018)
    tube.SetNumberOfSides(12)
    tube.CappingOn()
    return tube


def arrows(per_side):
    points = vtkPoints()
    vectors = vtkFloatArray()
    vectors.SetNumberOfComponents(3)
    vectors.SetName("flow")
    for i in range(per_side):
        for j in range(per_side):
            for k in range(3):
                x = -2.6 + 5.2 * i / (per_side - 1)
                y = -2.6 + 5.2 * j / (per_side - 1)
                points.InsertNextPoint(x, y, 0.35 + 0.8 * k)
                vectors.InsertNextTuple3(-y, x, 0.4 * math.sin(3 * x + k))
    grid = vtkPolyData()
    grid.SetPoints(points)
    grid.GetPointData().AddArray(vectors)
    arrow = vtkArrowSource()
    arrow.SetTipResolution(12)
    arrow.SetShaftResolution(12)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(grid)
    mapper.SetSourceConnection(arrow.GetOutputPort())
    mapper.SetOrientationArray("flow")
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScaleFactor(0.24)
    return actor_of(mapper, (0.85, 0.45, 0.3))


def tubes_and_glyphs():
    renderer = vtkRenderer()
    renderer.AddActor(mesh_actor(helices(30, 250), (0.4, 0.6, 0.75)))
    renderer.AddActor(arrows(18))
    renderer.AddActor(floor_actor(5, 0))
    renderer.AddLight(spot_light((3, -4, 7), (0, 0, 0.8), 35, (0.75, 0.72, 0.65)))
    renderer.AddLight(directional_light((0.7, 0.5, -1), (0.4, 0.42, 0.5)))
    place_camera(renderer, (1.6, -8.4, 5.2), (0, 0, 0.75))
    return renderer


def switched_on(renderer):
    lights = renderer.GetLights()
    return [
        lights.GetItemAsObject(i)
        for i in range(lights.GetNumberOfItems())
        if lights.GetItemAsObject(i).GetSwitch()
    ]


def timed(window):
    begin = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    return 1e3 * (time.perf_counter() - begin)


def frame_times(renderer, window, shadows, rounds):
    """Medians in milliseconds and of the ratios; camera and lights end where they began."""
    camera = renderer.GetActiveCamera()
    lights = switched_on(renderer)
    places = [light.GetPosition() for light in lights]
    unshadowed, static, moving = [], [], []

    def swing(i):
        camera.Azimuth(0.4 if i % 2 else -0.4)

    def move_lights(i):
        for light, (x, y, z) in zip(lights, places):
            light.SetPosition(x * (1 + 0.002 * (i % 5)), y, z)

    for i in range(2 * (rounds // 2 + 1)):
        renderer.SetPass(None)
        window.Render()  # the first frame of a pass looks shaders up
        swing(i)
        unshadowed.append(timed(window))
        renderer.SetPass(shadows)
        window.Render()
        swing(i + 1)
        static.append(timed(window))
        move_lights(2 * i)
        window.Render()
        move_lights(2 * i + 1)
        moving.append(timed(window))
        move_lights(0)
    median = statistics.median
    return {
        "frame_ms_unshadowed": median(unshadowed),
        "frame_ms_static": median(static),
        "frame_ms_moving": median(moving),
        "ratio_static": median(s / u for s, u in zip(static, unshadowed)),
        "ratio_moving": median(m / u for m, u in zip(moving, unshadowed)),
    }


def write_png(path, image=None, window=None):
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    if window:
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        writer.SetInputConnection(grab.GetOutputPort())
    else:
        writer.SetInputData(image)
    writer.Write()


def measure(name, renderer, window, size, options):
    """One row a technique and light."""
    window.SetSize(*size)
    renderer.SetBackground(0.86, 0.89, 0.92)
    window.AddRenderer(renderer)
    window.Render()
    rows = []
    for technique in options.techniques:
        shadows = vtkshadows.enable(renderer, technique, resolution=options.resolution)
        shadows.SetCullHiddenFaces(options.cull_hidden_faces)
        window.Render()
        if options.output:
            write_png(options.output / f"{name}-{size[0]}x{size[1]}-{technique}.png", window=window)
        errors = []
        for light in switched_on(renderer):
            error = vtkshadows.vtkShadowErrorMeasure()
            error.Measure(renderer, light)
            errors.append(error)
            if options.output:
                path = options.output / f"{name}-{size[0]}x{size[1]}-{technique}-error-{len(errors) - 1}.png"
                write_png(path, image=error.GetErrorMap())
        times = {}
        if size == options.sizes[0]:
            times = frame_times(renderer, window, shadows, options.rounds)
            if technique == "ray-cast":
                rates = []
                for _ in range(5):
                    window.Render()
                    traced = shadows.GetRayCastShadowPass().GetTraceSeconds()
                    rates.append(shadows.TimeBareTracing(renderer) / traced)
                times["rays_of_bare_loop"] = statistics.median(rates)
        for light, error in enumerate(errors):
            rows.append(
                {
                    "scene": name,
                    "size": f"{size[0]}x{size[1]}",
                    "technique": technique,
                    "light": light,
                    "receiver_pixels": error.GetReceiverPixels(),
                    "shadow_pixels": error.GetShadowPixels(),
                    "mismatch_percent": error.GetMismatchPercent(),
                    "gross_percent": error.GetGrossPercent(),
                    "gross_false_pixels": error.GetGrossFalsePixels(),
                    "gross_missed_pixels": error.GetGrossMissedPixels(),
                    "uncertain_pixels": error.GetUncertainPixels(),
                    **times,
                }
            )
            print_row(rows[-1])
        vtkshadows.disable(renderer)
    window.RemoveRenderer(renderer)
    return rows


def print_row(row):
    line = (
        f"| {row['scene']} | {row['size']} | {row['technique']} | {row['light']} "
        f"| {row['mismatch_percent']:.4f} | {row['gross_false_pixels']} + {row['gross_missed_pixels']} "
    )
    if "ratio_static" in row:
        line += (
            f"| {row['frame_ms_unshadowed']:.1f} | {row['ratio_static']:.2f} | {row['ratio_moving']:.2f} |"
        )
    else:
        line += "| | | |"
    if "rays_of_bare_loop" in row:
        line += f" {row['rays_of_bare_loop']:.2f} of a bare loop's rays a second"
    print(line, flush=True)


def size_of(text):
    width, height = text.split("x")
    return int(width), int(height)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mesh", type=pathlib.Path, default=ROOT / "build/demo/refined_elephant.off")
    parser.add_argument("--resolution", type=int, default=2048)
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--cull-hidden-faces", action="store_true", help="as SetCullHiddenFaces does")
    parser.add_argument("--scenes", default="still-life,scan,tubes-and-glyphs")
    parser.add_argument("--techniques", default="depth-map,ray-cast")
    parser.add_argument("--sizes", default="1024x768,768x768,333x1000", help="times at the first only")
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, help="folder for pictures and error maps")
    options = parser.parse_args()
    options.techniques = options.techniques.split(",")
    options.sizes = [size_of(s) for s in options.sizes.split(",")]
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)

    makers = {
        "still-life": still_life,
        "scan": lambda: scan(options.mesh),
        "tubes-and-glyphs": tubes_and_glyphs,
    }
    if "scan" in options.scenes and not options.mesh.exists():
        sys.exit(f"--mesh {options.mesh}: no such file; run Scripts/demo, which unpacks it, or name a mesh")

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    print("| scene | window | technique | light | mismatch % | gross false + missed px "
          "| unshadowed ms | static | moving |")
    print("|---|---|---|---|---|---|---|---|---|")
    rows = []
    for name in options.scenes.split(","):
        for size in options.sizes:
            rows += measure(name, makers[name](), window, size, options)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
