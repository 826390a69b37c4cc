"""Two half-transparent panes over a floor throw shadows by their opacity; writes translucent_casters.png."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def add_square(renderer, center, half_width, color, opacity=1):
    x, y, z = center
    square, mapper, actor = vtkPlaneSource(), vtkPolyDataMapper(), vtkActor()
    square.SetOrigin(x - half_width, y - half_width, z)
    square.SetPoint1(x + half_width, y - half_width, z)
    square.SetPoint2(x - half_width, y + half_width, z)
    mapper.SetInputConnection(square.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)


renderer, window, sun = vtkRenderer(), vtkRenderWindow(), vtkLight()
add_square(renderer, (0, 0, 0), 4, (0.85, 0.82, 0.78))
add_square(renderer, (-0.5, 0, 1.5), 1, (0.3, 0.5, 0.9), 0.5)
add_square(renderer, (0.5, 0.4, 2.0), 1, (0.9, 0.5, 0.3), 0.5)
sun.SetPosition(0.2, -0.6, 1)
sun.SetFocalPoint(0, 0, 0)
renderer.AddLight(sun)
camera = renderer.GetActiveCamera()
camera.SetPosition(3, -9, 5)
camera.SetFocalPoint(0, 0, 0.5)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)

vtkshadows.enable(renderer, "depth-map", translucent_casters="transmittance")
window.Render()
seen = vtkshadows.visibility(renderer)
for share in (0.5, 0.25):
    print(f"{share}: {100 * (abs(seen - share) < 0.01).mean():.1f} % of the picture has that share of the light")

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/translucent_casters.png")
