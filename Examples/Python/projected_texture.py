"""A window's light on a wall, through its bars, and a lamp whose cone ends softly; writes projected_texture.png."""
import sys

import numpy
import vtkshadows
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def add_spot(renderer, position, focus, cone):
    light = vtkLight()
    light.PositionalOn()
    light.SetPosition(*position)
    light.SetFocalPoint(*focus)
    light.SetConeAngle(cone)
    renderer.AddLight(light)
    return light


cone, mapper, actor = vtkConeSource(), vtkPolyDataMapper(), vtkActor()
cone.SetResolution(60)
cone.SetDirection(0, 0, 1)
mapper.SetInputConnection(cone.GetOutputPort())
actor.SetMapper(mapper)

renderer, window = vtkRenderer(), vtkRenderWindow()
renderer.AddActor(actor)
sunlit = add_spot(renderer, (3, -3, 4), (0, 0, -0.4), 14)
lamp = add_spot(renderer, (-2, -1.5, 2.5), (0.2, 0.2, -0.5), 25)
lamp.SetColor(0.2, 0.25, 0.45)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -5, 4)
camera.SetViewUp(0, 0, 1)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, shadow="depth-map", catcher=False)
renderer.ResetCamera()
camera.Zoom(1.5)

panes = numpy.zeros((240, 240, 3), "uint8")  # row 0 is at the top
for row in range(3):
    for column in range(2):
        panes[80 * row + 5 : 80 * row + 75, 120 * column + 5 : 120 * column + 115] = (255, 220, 150)
vtkshadows.set_light_texture(renderer, sunlit, panes)
vtkshadows.set_smooth_cone(renderer, lamp, 0.6)

window.Render()
shadow = 100 * (vtkshadows.visibility(renderer, sunlit) < 0.5).mean()
print(f"in the shadow of the cone: {shadow:.1f} % of the picture")
path = sys.argv[1] if len(sys.argv) > 1 else "projected_texture.png"
vtkshadows.screenshot(window, path, transparent=False)
