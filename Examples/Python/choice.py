"""Which shadow for this figure? "auto" takes what is fastest within a budget, and says why; writes choice.png."""
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

renderer, window, sun = vtkRenderer(), vtkRenderWindow(), vtkLight()
sun.SetPosition(-1, 2, 1.5)
renderer.AddLight(sun)
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(2, 2, 5)
window.SetSize(640, 480)
window.OffScreenRenderingOn()
window.AddRenderer(renderer)
vtkshadows.add_floor(renderer, catcher=False, size=4)
renderer.ResetCamera()
renderer.GetActiveCamera().Zoom(2)

for said, budget in (
    ("no gross error", {}),
    ("0.005 % of the pixels wrong", {"maximum_error": 0.005}),
    ("10 s a frame", {"maximum_error": 0, "maximum_frame_time": 10000}),
):
    shadows = vtkshadows.enable(renderer, **budget)
    for _ in range(200):  # in the first frames it finds out what is fast here
        window.Render()
        if shadows.GetChoiceIsSettled():
            break
    print(f"{said}: {vtkshadows.error(renderer).mismatch_percent:.4f} % are wrong\n  {vtkshadows.explanation(renderer)}")

folder = sys.argv[1] if len(sys.argv) > 1 else "."
vtkshadows.screenshot(window, f"{folder}/choice.png", transparent=False)
