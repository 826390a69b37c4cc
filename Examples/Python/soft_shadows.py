"""Soft shadows by depth maps, and how far they are from the truth; writes soft_shadows.png."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

sphere, mapper, actor = vtkSphereSource(), vtkPolyDataMapper(), vtkActor()
sphere.SetThetaResolution(60)
sphere.SetPhiResolution(60)
mapper.SetInputConnection(sphere.GetOutputPort())
actor.SetMapper(mapper)

renderer, window, lamp = vtkRenderer(), vtkRenderWindow(), vtkLight()
lamp.PositionalOn()
lamp.SetConeAngle(40)
lamp.SetPosition(2, 4, 2)
renderer.AddLight(lamp)
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(2, 2, 5)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, shadow="depth-map", catcher=False, size=5)
renderer.ResetCamera()

for name in ("percentage-closer", "sample-lights", "soft"):
    vtkshadows.enable(renderer, "depth-map", radius=0.4, filter=name)
    window.Render()
    print(f"{name}: {vtkshadows.error(renderer).mean_absolute_difference:.4f} from the truth in the mean")

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/soft_shadows.png", transparent=False)
