"""Cascades: sharp shadows beside the eye in a scene that reaches to the horizon; writes cascades.png."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def add(renderer, source, color):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)


renderer, window, sun = vtkRenderer(), vtkRenderWindow(), vtkLight()
ground = vtkPlaneSource()  # 4 km wide, in metres
ground.SetOrigin(-2000, -2000, 0)
ground.SetPoint1(2000, -2000, 0)
ground.SetPoint2(-2000, 2000, 0)
add(renderer, ground, (0.6, 0.65, 0.45))
for i in range(200):  # an avenue of trees, 10 m high
    for side in (-8, 8):
        tree = vtkConeSource()
        tree.SetResolution(24)
        tree.SetHeight(10)
        tree.SetRadius(2.5)
        tree.SetDirection(0, 0, 1)
        tree.SetCenter(10 * i, side, 5)
        add(renderer, tree, (0.25, 0.5, 0.3))
sun.SetPosition(0.4, -1, 0.5)
sun.SetFocalPoint(0, 0, 0)
renderer.AddLight(sun)
camera = renderer.GetActiveCamera()
camera.SetPosition(-12, 0, 2)
camera.SetFocalPoint(0, 0, 2)
camera.SetViewUp(0, 0, 1)
camera.SetClippingRange(1, 4000)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)

for cascades in (1, 4):
    vtkshadows.enable(renderer, "depth-map", resolution=1024, cascades=cascades)
    window.Render()
    print(f"{cascades}: {vtkshadows.error(renderer).mismatch_percent:.2f} % of the pixels are wrong")

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/cascades.png")
vtkshadows.enable(renderer, "depth-map", debug_view="cascades")  # by colour
window.Render()
vtkshadows.screenshot(window, f"{folder}/cascades_explained.png")
