"""The depth map's filters and formats, each held against the truth; writes depth_map_filters.png."""
import sys

import vtkshadows
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

ring, mapper, actor = vtkSuperquadricSource(), vtkPolyDataMapper(), vtkActor()
ring.ToroidalOn()
ring.SetPhiResolution(96)
ring.SetThetaResolution(96)
mapper.SetInputConnection(ring.GetOutputPort())
actor.SetMapper(mapper)
actor.RotateX(70)

renderer, window, spot = vtkRenderer(), vtkRenderWindow(), vtkLight()
spot.PositionalOn()
spot.SetConeAngle(40)
spot.SetPosition(-1.5, 3, 2)
renderer.AddLight(spot)
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(2, 2, 5)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, catcher=False, size=4)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(2)


def report(name, **settings):
    vtkshadows.enable(renderer, "depth-map", **{"resolution": 512, "depth_bits": 32, "bias": "automatic", **settings})
    window.Render()
    error = vtkshadows.error(renderer)
    gross = error.gross_false_pixels + error.gross_missed_pixels
    print(f"{name}: {error.mismatch_percent:.4f} % are wrong, {gross} px grossly")


for bits in (16, 8):
    report(f"{bits} bits", depth_bits=bits)
report("bias of the user's, none", bias=(0, 0))
for name in ("none", "hardware", "percentage-closer", "disc", "exact"):
    report(name, filter=name)

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/depth_map_filters.png", transparent=False)
