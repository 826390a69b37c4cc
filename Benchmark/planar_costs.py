"""Time of planar shadows, beside the depth map's: the figures in Docs/Techniques.md.

    PYTHONPATH=build/lib/python3/dist-packages xvfb-run -a python3 Benchmark/planar_costs.py

200 000 triangles over one floor, one light, software OpenGL: frames in turn, as ground_floor.py takes them.
Static: the camera moves. Moving: the light moves each frame.
"""
import argparse

import vtkshadows
from ground_floor import directional_light, floor_actor, frame_times, mesh_actor, place_camera, spot_light
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

LIGHTS = {
    "directional": lambda: directional_light((-0.5, 0.6, -1)),
    "spot": lambda: spot_light((4, -4, 7), (0, 0, 0.4), 32),
}


def two_bodies(light, side=224):
    """A sphere and a torus of 2 * side**2 triangles each."""
    sphere = vtkSphereSource()
    sphere.SetRadius(1)
    sphere.SetCenter(-0.8, 0.2, 1)
    sphere.SetThetaResolution(side)
    sphere.SetPhiResolution(side)
    torus = vtkParametricFunctionSource()
    torus.SetParametricFunction(vtkParametricTorus())
    torus.SetUResolution(side)
    torus.SetVResolution(side)
    torus.SetWResolution(2)
    ring = mesh_actor(torus, (0.35, 0.55, 0.85))
    ring.SetScale(0.8)
    ring.RotateX(65)
    ring.SetPosition(1.5, -0.6, 1.2)
    renderer = vtkRenderer()
    for actor in (mesh_actor(sphere, (0.88, 0.5, 0.3)), ring, floor_actor(6, 0)):
        renderer.AddActor(actor)
    renderer.AddLight(LIGHTS[light]())
    place_camera(renderer, (1.2, -8.6, 4.6), (0, 0, 0.55))
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--lights", default="directional,spot")
    options = parser.parse_args()
    ways = (
        ("planar", "planar", {}),
        ("planar, textures", "planar", {"plane_textures": True}),
        ("depth-map", "depth-map", {}),
    )
    print("| light | technique | unshadowed ms | static | moving |\n|---|---|---|---|---|")
    for light in options.lights.split(","):
        for name, technique, settings in ways:
            renderer = two_bodies(light)
            window = vtkRenderWindow()
            window.SetOffScreenRendering(True)
            window.SetMultiSamples(0)
            window.SetSize(1024, 768)
            window.AddRenderer(renderer)
            shadows = vtkshadows.enable(renderer, technique, **settings)
            window.Render()
            times = frame_times(renderer, window, shadows, options.rounds)
            print(
                f"| {light} | {name} | {times['frame_ms_unshadowed']:.1f} "
                f"| {times['ratio_static']:.2f} | {times['ratio_moving']:.2f} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
