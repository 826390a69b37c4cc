"""Planar shadows: exact on a floor, soft in three ways, and baked; writes planar_shadows.png and its texture."""
import sys

import vtkshadows
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCylinderSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

cylinder, mapper, actor = vtkCylinderSource(), vtkPolyDataMapper(), vtkActor()
cylinder.SetResolution(60)
cylinder.SetHeight(2)
mapper.SetInputConnection(cylinder.GetOutputPort())
actor.SetMapper(mapper)
vtkshadows.set_receives_shadows(actor, False)  # what is not flat takes no planar shadow

renderer, window, lamp = vtkRenderer(), vtkRenderWindow(), vtkLight()
lamp.PositionalOn()
lamp.SetConeAngle(180)  # to all sides
lamp.SetPosition(3, 5, 3)
renderer.AddLight(lamp)
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(4, 5, 9)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, shadow="planar", catcher=False, size=4)
renderer.ResetCamera()

window.Render()
print(f"hard: {vtkshadows.error(renderer).mismatch_percent:.4f} % of the floor's pixels are wrong")
for method in ("plateaus", "offset-planes", "sample-lights"):
    vtkshadows.enable(renderer, "planar", radius=0.4, soft_method=method)
    window.Render()
    print(f"{method}: {vtkshadows.error(renderer).mean_absolute_difference:.4f} from the truth in the mean")

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/planar_shadows.png")
planar = vtkshadows.enable(renderer, "planar", plane_textures=True).GetPlanarShadowPass()
window.Render()
texture, writer = vtkImageData(), vtkPNGWriter()
planar.GetPlaneTexture(lamp, 0, texture)  # placed in the world: origin, spacing and direction
writer.SetInputData(texture)
writer.SetFileName(f"{folder}/planar_shadows_texture.png")
writer.Write()
