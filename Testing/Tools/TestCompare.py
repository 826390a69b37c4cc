"""compare: the files, the JSON's keys and figures, the printed table."""

import json
import os

from commandtest import Image, check, enter_empty_folder, finish, succeed, write_plate, write_tetrahedron

KEYS = {
    "technique", "light", "explanation", "filter", "depth_bits", "receiver_pixels", "shadow_pixels", "mismatch_percent", "gross_pixels",
    "gross_false_pixels", "gross_missed_pixels", "mean_absolute_difference", "culled_receivers", "frame_ms_unshadowed",
    "frame_ms_static", "frame_ms_moving", "ratio_static", "ratio_moving", "triangles", "vtk_version",
    "gl_renderer",
}  # fmt: skip
TIMES = [key for key in sorted(KEYS) if key.startswith(("frame_ms", "ratio"))]

enter_empty_folder()
write_plate("plate.off")
FLOOR = ["--floor", "0,0,1,0"]  # one unit below the plate
LIGHTS = ["--light", "directional:0.3,0.4,-1", "--light", "spot:1,-3,5:0,0,0:30"]
out = succeed("compare", "plate.off", "-o", "made/folder", "--size", "240x180", "--frames", 3,
              "--json", "too.json", *FLOOR, *LIGHTS)  # fmt: skip

techniques = ["depth-map", "object-id", "planar", "shadow-texture", "stencil-volume", "ray-cast"]
expected = {"unshadowed.png", "comparison.json"}
for name in techniques:
    expected.add(f"{name}.png")
    expected |= {f"{name}-{kind}-{light}.png" for kind in ("visibility", "error") for light in (0, 1)}
check("files", sorted(os.listdir("made/folder")), sorted(expected))
for name in sorted(expected - {"comparison.json"}):
    image = Image(f"made/folder/{name}")
    check(f"{name}'s size", (image.width, image.height), (240, 180))

with open("made/folder/comparison.json") as file:
    text = file.read()
with open("too.json") as file:
    check("--json writes the same", file.read() == text, True)
rows = json.loads(text)
check("rows", [(row["technique"], row["light"]) for row in rows],
      [(name, light) for name in techniques for light in (0, 1)])  # fmt: skip
for row in rows:
    name = f"{row['technique']}, light {row['light']}: "
    check(name + "keys", set(row), KEYS)
    check(name + "triangles of plate and floor", row["triangles"], 4)
    check(name + "has receivers", row["receiver_pixels"] > 10000, True)
    check(name + "has shadow", row["shadow_pixels"] > 100, True)
    check(name + "gross is false and missed", row["gross_pixels"],
          row["gross_false_pixels"] + row["gross_missed_pixels"])  # fmt: skip
    check(name + "mismatch, %", row["mismatch_percent"], 0, 0.1)
    for key in TIMES:
        check(name + key + " is positive", row[key] > 0, True)
    check(name + "names VTK and OpenGL", bool(row["vtk_version"] and row["gl_renderer"]), True)
    if row["technique"] == "ray-cast":
        check(name + "mismatch of the truth itself, pixels", row["gross_pixels"], 0)
    if row["technique"] in ("planar", "stencil-volume"):
        check(name + "mismatch, %, of what is exact to the pixel", row["mismatch_percent"], 0, 0.01)

# A floor that catches: pictures with alpha, and the same measure.
succeed("compare", "plate.off", "-o", "caught", "--size", "240x180", "--frames", 1, "--floor", "catcher",
        "--technique", "depth-map", "--up", "0,1,0", *LIGHTS[:2])  # fmt: skip
for name in ("unshadowed", "depth-map"):
    check(f"channels of {name} with a catcher", Image(f"caught/{name}.png").channels, 4)
with open("caught/comparison.json") as file:
    row = json.load(file)[0]
check("receivers of a catcher", row["receiver_pixels"] > 5000, True)

table = [line.split() for line in out.splitlines()]
for name in techniques:
    check(f"lines of {name} in the table", sum(line[:1] == [name] for line in table), 2)

# Chosen techniques; none is not a shadow, and is only measured if asked for.
succeed("compare", "plate.off", "-o", "one", "--size", "80x60", "--frames", 1,
        "--techniques", "none,depth-map", *FLOOR)  # fmt: skip
with open("one/comparison.json") as file:
    rows = json.load(file)
check("chosen techniques", [row["technique"] for row in rows], ["none", "depth-map"])
check("without technique, the shadow is missed", rows[0]["mismatch_percent"] > 1, True)
check("picture without technique is the unshadowed one",
      Image("one/none.png").rows == Image("one/unshadowed.png").rows, True)  # fmt: skip

# How a translucent mesh casts, and that of a closed one hidden faces are left out of a frame with shadows.
write_tetrahedron("closed.off")
succeed("compare", "plate.off", "closed.off", "-o", "ways", "--size", "80x60", "--frames", 1, "--opacity", "0.5,1",
        "--translucent-casters", "opaque", "--cull-hidden-faces", "--techniques", "none,depth-map", *FLOOR)  # fmt: skip
with open("ways/comparison.json") as file:
    rows = json.load(file)
check("receivers that were culled", [row["culled_receivers"] for row in rows], [0, 1])
check("shadow of a translucent plate is missed without technique", rows[0]["mismatch_percent"] > 1, True)
check("and not by depth maps", rows[1]["mismatch_percent"] < 0.5 * rows[0]["mismatch_percent"], True)

# Chosen ones are compared if asked for, and say why.
out = succeed("compare", "plate.off", "-o", "auto", "--size", "80x60", "--frames", 1,
              "--techniques", "auto,depth-map", "--max-error", 5, *FLOOR)  # fmt: skip
with open("auto/comparison.json") as file:
    rows = json.load(file)
check("auto and a named one", [row["technique"] for row in rows], ["auto", "depth-map"])
check("error of auto", rows[0]["mismatch_percent"] <= 5, True)
names = ("depth-map", "planar", "stencil-volume", "ray-cast")
check("explanation of auto", rows[0]["explanation"].startswith(names) and "5 %" in rows[0]["explanation"], True)
check("explanation of a named one", rows[1]["explanation"], "depth-map: named, not chosen.")
check("printed explanation", f"auto, light 0: {rows[0]['explanation']}" in out, True)

finish()
