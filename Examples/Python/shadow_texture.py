"""Shadow textures: hard, and soft by distance; writes shadow_texture.png."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkArrowSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

renderer, window, lamp = vtkRenderer(), vtkRenderWindow(), vtkLight()
for height in (0.3, 1.2):
    arrow, mapper, actor = vtkArrowSource(), vtkPolyDataMapper(), vtkActor()
    arrow.SetTipResolution(60)
    arrow.SetShaftResolution(60)
    mapper.SetInputConnection(arrow.GetOutputPort())
    actor.SetMapper(mapper)
    actor.SetPosition(-0.6, height, 1.0 - height)
    renderer.AddActor(actor)
lamp.PositionalOn()
lamp.SetConeAngle(180)  # to all sides
lamp.SetPosition(1, 5, 1)
renderer.AddLight(lamp)
renderer.GetActiveCamera().SetPosition(1, 5, 6)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, shadow="shadow-texture", catcher=False, size=3)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(1.8)

print(vtkshadows.vtkShadowTexturePass.GetLimits())
window.Render()
print(f"hard: {vtkshadows.error(renderer).mismatch_percent:.4f} % of the pixels are wrong")
vtkshadows.enable(renderer, "shadow-texture", radius=0.3)  # the higher the arrow, the softer
window.Render()
print(f"soft: {vtkshadows.error(renderer).mean_absolute_difference:.4f} from the truth in the mean")
vtkshadows.screenshot(window, sys.argv[1] if len(sys.argv) > 1 else "shadow_texture.png")
