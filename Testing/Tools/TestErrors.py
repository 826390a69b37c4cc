"""Bad input: one line that names the thing and the remedy, a status that is not zero, nothing left."""

import os
import re

from commandtest import check, command, enter_empty_folder, finish, tree, write_off, write_tetrahedron

enter_empty_folder()
write_tetrahedron("mesh.off")
write_off("nan.off", [(0, 0, 0), (1, 0, 0), ("nan", 1, 0), (0, "inf", 0)], [(0, 1, 2), (0, 1, 3)])
write_off("empty.off", [], [])
write_off("points.off", [(0, 0, 0), (1, 1, 1)], [])
write_off("spot.off", [(1, 1, 1)] * 3, [(0, 1, 2)])
write_off("index.off", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)])
with open("short.off", "w") as file:
    file.write("OFF\n4 4 0\n0 0 0\n1 0 0\n")
for name in ["prose.off", "prose.ply", "prose.stl", "prose.vtp", "prose.vtk", "prose.gltf", "prose.glb",
             "prose.obj", "prose.vti", "prose.vtu", "mesh.docx"]:  # fmt: skip
    with open(name, "w") as file:
        file.write("Call me Ishmael. Some years ago, never mind how long precisely, having little or "
                   "no money in my purse, I thought I would sail about a little.\n")  # fmt: skip
open("void.ply", "w").close()
os.mkdir("folder")
with open("flat.vti", "w") as file:
    file.write("""<VTKFile type="ImageData" version="1.0">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
<PointData Scalars="s"><DataArray type="Float32" Name="s" format="ascii">0 1 1 1 1 1 1 1</DataArray>
</PointData></Piece></ImageData></VTKFile>""")

PICTURE = ["-o", "picture.png"]


def refused(words, *arguments, status=1):
    """The command must fail with one line that has every word of `words`, and leave nothing behind."""
    before = tree(".")
    got, out, err = command(*arguments)
    case = " ".join(map(str, arguments)) or "(no arguments)"
    print(f"     {case}\n     {err.strip()}")
    check("status", got, status)
    check("lines on stderr", len(err.splitlines()), 1)
    check("lines on stdout", len(out.splitlines()), 0)
    check("begins with the command's name", err.startswith("vtkshadows: "), True)
    check("has a remedy", "; " in err, True)
    check("names what is wrong", [word for word in words if word not in err], [])
    check("files left behind", sorted(set(tree(".")) ^ set(before)), [])


def refused_input(words, path, *arguments):
    refused(["input " + path, *words], "render", path, *PICTURE, *arguments)


def refused_option(words, option, value, remedy):
    refused([f"{option} {value}", *words, remedy], "render", "mesh.off", *PICTURE, option, value)


# --- Inputs ---
refused_input(["no such file"], "missing.ply")
refused_input(["is a folder"], "folder")
refused_input(["no kind that is read", ".off", ".vtp"], "mesh.docx")
refused_input(["empty file"], "void.ply")
refused_input(["empty mesh"], "empty.off")
refused_input(["no faces", "2 points"], "points.off")
refused_input(["2 of its points are not finite", "point 2"], "nan.off")
refused_input(["one point"], "spot.off")
refused_input(["line 6", "vertex 7"], "index.off")
refused_input(["line 4", "2 of 4 vertices"], "short.off")
for extension in ["off", "ply", "stl", "vtp", "vtk", "gltf", "glb", "vti", "vtu"]:
    refused_input(["OFF" if extension == "off" else "." + extension], "prose." + extension)
refused_input(["empty mesh"], "prose.obj")
with open("appended.vtp", "w") as file:
    file.write('<VTKFile type="PolyData">\n<AppendedData encoding="base64">_prose</VTKFile>\n')
vtk = re.search(r"VTK (\d+)\.(\d+)", command("--version")[1])
is_old = tuple(map(int, vtk.groups())) < (9, 4)
refused_input(["check that the file is whole", "another data mode" if is_old else ".vtp"], "appended.vtp")
refused(["--isovalue 7", "outside", "0 to 1"], "render", "flat.vti", *PICTURE, "--isovalue", 7)
refused(["missing.ply"], "compare", "mesh.off", "missing.ply", "-o", "results")

# --- Outputs: found out before the work ---
refused(["-o folder", "is a folder"], "render", "mesh.off", "-o", "folder")
refused(["-o picture.jpg", ".png"], "render", "mesh.off", "-o", "picture.jpg")
refused(["-o no/picture.png", "does not exist"], "render", "mesh.off", "-o", "no/picture.png")
refused(["-o mesh.off", "is a file"], "compare", "mesh.off", "-o", "mesh.off")
refused(["-o mesh.off/in", "is a file"], "compare", "mesh.off", "-o", "mesh.off/in")
refused(["--json mesh.off", "is an input"], "render", "mesh.off", *PICTURE, "--json", "mesh.off")
refused(["--visibility mask.gif", ".png"], "render", "mesh.off", *PICTURE, "--visibility", "mask.gif")
refused(["picture-0.png", "two files"], "render", "mesh.off", "-o", "picture-0.png",
        "--visibility", "picture.png")  # fmt: skip
for unwritable in ["/proc/picture.png"]:
    if os.path.isdir(os.path.dirname(unwritable)):
        refused(["-o " + unwritable, "cannot write"], "render", "mesh.off", "-o", unwritable)
        refused(["-o " + unwritable, "cannot write"], "compare", "mesh.off", "-o", unwritable)

# --- Options ---
for size in ["0x10", "10x0", "-3x10"]:
    refused_option(["no area"], "--size", size, "WxH")
refused_option(["width and a height"], "--size", "100", "WxH")
refused_option(["OpenGL driver"], "--size", "9999999x10", "at most")
refused_option(["no technique"], "--technique", "photon", "depth-map")
refused(["--techniques photon", "depth-map"], "compare", "mesh.off", "-o", "results",
        "--techniques", "depth-map,photon")  # fmt: skip
refused_option(["no such budget"], "--max-error", "-1", "at most 100")
refused_option(["no such budget"], "--max-error", "nan", "at most 100")
refused_option(["no such budget"], "--max-frame-time", "0", "more than 0")
refused_option(["less than 1"], "--resolution", "0", "1 or more")
refused_option(["OpenGL driver"], "--resolution", "1000000", "at most")
refused_option(["less than 1"], "--cascades", "0", "1 or more")
refused_option(["more than 8"], "--cascades", "9", "1 to 8")
refused_option(["less than 1"], "--frames", "-2", "1 or more")
refused_option(["less than 1"], "--light-samples", "0", "1 or more")
refused_option(["more than 4096"], "--light-samples", "5000", "1 to 4096")
refused_option(["no filter"], "--filter", "soft-ish", "percentage-closer")
refused_option(["no format"], "--depth-bits", "12", "8, 16, 24, 32")
refused(["--depth-bits 8", "variance", "another --filter"], "render", "mesh.off", *PICTURE,
        "--filter", "variance", "--depth-bits", "8")  # fmt: skip
refused_option(["no object"], "--object-type", "atom", "prop, block, instance, piece")
refused_option(["no format"], "--object-depth-bits", "12", "8, 16, 24, 32")
refused_option(["less than 1"], "--object-taps", "0", "1 or more")
refused_option(["more than 4"], "--object-taps", "5", "1 to 4")
refused_option(["no way"], "--translucent-casters", "half", "none, opaque, stochastic, transmittance")
for opacity in ("0", "1.5", "-1", "nan"):
    refused_option(["no opacity"], "--opacity", opacity, "more than 0 and at most 1")
refused(["--opacity 2 value(s)", "1 mesh(es)", "one for each"], "render", "mesh.off", *PICTURE, "--opacity", "1,0.5")
refused_option(["no view"], "--debug", "x-ray", "volumes, silhouette, counts")
for words in ([], ["--technique", "ray-cast"], ["--light", "point:1,2,3@technique=none"]):
    technique = words[1].split("=")[-1] if words else "depth-map"
    refused(["--debug counts", "technique is " + technique, "--technique stencil-volume"],
            "render", "mesh.off", *PICTURE, "--debug", "counts", *words)  # fmt: skip

for view in ("cascades", "texel-density", "map", "lit-part"):
    refused(["--debug " + view, "technique is ray-cast", "--technique depth-map"], "render", "mesh.off", *PICTURE,
            "--debug", view, "--technique", "ray-cast")  # fmt: skip

# --- Of bench ---
refused(["-o", "missing", "folder"], "bench")
refused(["--scenes stil-life", "still-life"], "bench", "-o", "results", "--scenes", "stil-life")
refused(["--settings photon", "--list"], "bench", "-o", "results", "--settings", "photon")
refused(["--detail 0", "0.01 to 100"], "bench", "-o", "results", "--detail", "0")
refused(["--triangles 5", "10000"], "bench", "-o", "results", "--triangles", "5")
refused(["--seconds -1"], "bench", "-o", "results", "--seconds", "-1")
refused(["--size 0x3", "no area"], "bench", "-o", "results", "--size", "0x3")
refused(["--statue no.off", "no such file"], "bench", "-o", "results", "--statue", "no.off")
refused(["--opacity 1 value(s)", "0 mesh(es)"], "bench", "-o", "results", "--opacity", "0.5")
refused(["--translucent-casters half", "stochastic"], "bench", "-o", "results", "--translucent-casters", "half")
refused(["-o mesh.off", "is a file"], "bench", "-o", "mesh.off")
refused(["input missing.ply"], "bench", "missing.ply", "-o", "results")
refused(["--frames 0", "less than 1"], "bench", "-o", "results", "--frames", "0")

refused_option(["no direction"], "--light", "directional:0,0,0", "not zero")
refused_option(["no direction"], "--light", "spot:1,1,1:1,1,1:30", "focal point")
for cone in ["0", "90", "-4", "180"]:
    refused_option(["cone angle"], "--light", f"spot:0,0,5:0,0,0:{cone}", "between 0 and 90")
refused_option(["3 numbers"], "--light", "directional:1,2", "directional:DX,DY,DZ")
refused_option(["not a finite number"], "--light", "point:1,2,nan", "point:PX,PY,PZ")
refused_option(["no kind of light"], "--light", "sun", "spot:PX,PY,PZ")
refused_option(["strength"], "--light", "point:1,2,3@strength=1.5", "0 (no shadow) to 1")
refused_option(["fade"], "--light", "point:1,2,3@fade=1.5", "0 to 1")
refused_option(["distance"], "--light", "point:1,2,3@distance=-2", "0")
SPOT = "spot:3,-3,5:0,0,0:30"
refused_option(["falloff"], "--light", SPOT + "@falloff=1.5", "0 to 1")
refused_option(["falloff"], "--light", SPOT + "@falloff=nan", "finite")
refused_option(["only a spot"], "--light", "point:1,2,3@falloff=0.5", "give a spot")
refused_option(["only a spot"], "--light", "directional:1,2,-3@texture=picture.png", "give a spot")
for file in ("missing.png", "void.ply", "mesh.off", "folder"):
    refused(["--light @texture " + file, "no PNG file", "give an image"], "render", "mesh.off", *PICTURE,
            "--light", SPOT + "@texture=" + file)  # fmt: skip
refused_option(["radius is negative"], "--light", "point:1,2,3@radius=-1", "0 or more")
refused_option(["intensity is negative"], "--light", "point:1,2,3@intensity=-1", "0 or more")
refused_option(["color"], "--light", "point:1,2,3@color=0,0,2", "0 to 1")
refused_option(["@flavour=sweet"], "--light", "point:1,2,3@flavour=sweet", "@technique=NAME")
refused(["photon", "depth-map"], "render", "mesh.off", *PICTURE, "--light", "point:1,2,3@technique=photon")
refused(["ray-cast", "compare"], "compare", "mesh.off", "-o", "results",
        "--light", "point:1,2,3@technique=ray-cast")  # fmt: skip

refused_option(["focal point"], "--camera", "1,1,1:1,1,1:0,0,1:30", "looks at")
refused_option(["up vector"], "--camera", "0,0,9:0,0,0:0,0,1:30", "across the view")
refused_option(["up vector"], "--camera", "9,0,0:0,0,0:0,0,0:30", "across the view")
for angle in ["0", "180", "-30"]:
    refused_option(["view angle"], "--camera", f"9,0,0:0,0,0:0,0,1:{angle}", "0 and 180")
refused_option(["4 parts"], "--camera", "9,0,0:0,0,0", "PX,PY,PZ")
refused_option(["no normal"], "--floor", "0,0,0,1", "not zero")
refused_option(["4 numbers"], "--floor", "carpet", "auto, none")
refused(["-o picture.jpg", "alpha", "ends in .png"], "render", "mesh.off", "-o", "picture.jpg",
        "--floor", "catcher")  # fmt: skip
refused_option(["no up"], "--up", "0,0,0", "not zero")

# --- Command lines that cannot be read ---
refused(["subcommand", "--help"], status=2)
refused(["--output", "--help"], "render", "mesh.off", status=2)
refused(["INPUT", "--help"], "render", *PICTURE, status=2)
refused(["--bogus", "render --help"], "render", "mesh.off", *PICTURE, "--bogus", status=2)
refused(["--debug", "compare --help"], "compare", "mesh.off", "-o", "results", "--debug", "volumes",
        status=2)  # fmt: skip
refused(["--cascades", "--help"], "render", "mesh.off", *PICTURE, "--cascades", "some", status=2)
refused(["--resolution", "--help"], "render", "mesh.off", *PICTURE, "--resolution", "many", status=2)

finish()
