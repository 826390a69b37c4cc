"""No X display of the user's is needed: the command brings up its own, says so, and takes it down."""

import os

from commandtest import Image, check, command, enter_empty_folder, finish, write_tetrahedron

enter_empty_folder()
write_tetrahedron("mesh.off")
RENDER = ["render", "mesh.off", "-o", "picture.png", "--size", "64x48"]

bare = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
for case, display in [("no DISPLAY", {}), ("a DISPLAY that does not answer", {"DISPLAY": ":987"})]:
    status, _, err = command(*RENDER, environment={**bare, **display})
    print("     " + err.strip())
    check(f"status with {case}", status, 0)
    # A VTK that renders without a display says nothing.
    check(f"lines on stderr with {case}", len(err.splitlines()) <= 1, True)
    check(f"says Xvfb, or nothing, with {case}", "Xvfb" in err or not err, True)
    check(f"picture's width with {case}", Image("picture.png").width, 64)
    os.remove("picture.png")
needs_display = bool(err)

status, _, err = command(*RENDER, "--quiet", environment=bare)
check("stderr under --quiet", err, "")
check("status under --quiet", status, 0)

# Without Xvfb there is one line with the remedy, and no picture.
os.remove("picture.png")
if needs_display:
    status, _, err = command(*RENDER, environment={**bare, "PATH": "/nowhere"})
    print("     " + err.strip())
    check("status without Xvfb", status, 1)
    check("lines on stderr without Xvfb", len(err.splitlines()), 1)
    check("remedy without Xvfb", "install" in err and "DISPLAY" in err, True)
    check("picture without Xvfb", os.path.exists("picture.png"), False)

finish()
