"""render: one picture, its masks and their conventions, on a plate over a floor seen from above."""

import json
import math
import os

from commandtest import Image, check, enter_empty_folder, finish, succeed, write_plate, write_tetrahedron

WIDTH, HEIGHT = 200, 150
EYE = 20.0  # above the floor, looking down; the picture's top is +y
VIEW = ["--camera", f"0,0,{EYE}:0,0,0:0,1,0:30", "--up", "0,0,1", "--size", f"{WIDTH}x{HEIGHT}"]
PIXELS_PER_UNIT = HEIGHT / (2 * EYE * math.tan(math.radians(15)))  # on the floor


def pixel(x, y):
    """Column and row, from the top, of a point of the floor z = 0."""
    return int(WIDTH / 2 + x * PIXELS_PER_UNIT), int(HEIGHT / 2 - y * PIXELS_PER_UNIT)


def mask_at(mask, x, y):
    column, row = pixel(x, y)
    return mask.rows[row][column][0]


enter_empty_folder()
write_plate("plate.off")
SCENE = ["plate.off", *VIEW, "--floor", "0,0,1,0"]

# A light that travels toward +y: the shadow lies beyond the plate, in the upper half of the picture.
# It is one unit square, less what the plate hides of it.
shadow_pixels = (1.5 - 0.5 * EYE / (EYE - 1)) * PIXELS_PER_UNIT**2
for technique in ("depth-map", "shadow-texture", "stencil-volume", "ray-cast"):
    succeed("render", *SCENE, "--light", "directional:0,1,-1", "--technique", technique,
            "-o", f"{technique}.png", "--visibility", f"{technique}-mask.png")  # fmt: skip
    picture, mask = Image(f"{technique}.png"), Image(f"{technique}-mask-0.png")
    check("picture's size", (picture.width, picture.height), (WIDTH, HEIGHT))
    check("mask's size", (mask.width, mask.height), (WIDTH, HEIGHT))
    check("picture's channels", picture.channels, 3)
    check("mask's channels", mask.channels, 1)
    check("mask in the shadow, top row first", mask_at(mask, 0, 1), 0)
    check("mask opposite to the shadow", mask_at(mask, 0, -1), 255)
    check("mask on the plate", mask_at(mask, 0, 0), 255)
    check("mask of the background", mask.rows[0][0][0], 255)
    dark = sum(255 - value[0] for row in mask.rows for value in row) / 255
    check("shadow's pixels", dark, shadow_pixels, 0.06 * shadow_pixels)
    column, row = pixel(0, 1)
    lit_column, lit_row = pixel(0, -1)
    check("picture is darker in the shadow",
          picture.rows[row][column][0] < picture.rows[lit_row][lit_column][0], True)  # fmt: skip

# Several lights are all on, and each has its mask: from the left, from the right, from above.
succeed("render", *SCENE, "-o", "lights.png", "--visibility", "each.png",
        "--light", "directional:1,0,-1@color=1,0.5,0.5",
        "--light", "spot:3,0,4:0,0,0:40@technique=ray-cast@intensity=0.5",
        "--light", "point:0,0,5@strength=0.5", "--light", "directional:0,1,-1@technique=none")  # fmt: skip
masks = [Image(f"each-{light}.png") for light in range(4)]
check("no mask of a fifth light", os.path.exists("each-4.png"), False)
check("mask without its light's number", os.path.exists("each.png"), False)
check("light 0 shadows the right", mask_at(masks[0], 1, 0), 0)
check("light 0 does not shadow the left", mask_at(masks[0], -1, 0), 255)
check("light 1 shadows the left", mask_at(masks[1], -0.8, 0), 0)
check("light 1 does not shadow the right", mask_at(masks[1], 0.8, 0), 255)
check("light 2 shadows around the plate", mask_at(masks[2], 0, 0.58), 0)
check("light 3 has no technique: all lit", masks[3].count((255,)), WIDTH * HEIGHT)

# Strength 0 is the picture without shadows; so is technique none.
light = "directional:0,1,-1"
succeed("render", *SCENE, "--light", light, "--technique", "none", "-o", "none.png")
succeed("render", *SCENE, "--light", light + "@strength=0", "-o", "weak.png")
check("picture at strength 0 is that without technique",
      Image("weak.png").rows == Image("none.png").rows, True)  # fmt: skip

# So is a distance that nothing is within; one that reaches everywhere changes nothing.
succeed("render", *SCENE, "--light", light + "@distance=0.001@fade=0", "-o", "weak.png")
check("picture with shadows up to a thousandth is that without technique",
      Image("weak.png").rows == Image("none.png").rows, True)  # fmt: skip
succeed("render", *SCENE, "--light", light, "-o", "whole.png")
succeed("render", *SCENE, "--light", light + "@distance=1e6", "-o", "weak.png")
check("picture with shadows up to a million is that with shadows",
      Image("weak.png").rows == Image("whole.png").rows, True)  # fmt: skip

# A light with a radius is soft: some pixels are between 0 and 255. With two sample lights there is one
# value between, at the middle; shadow volumes make a ramp of it.
for technique in ("stencil-volume", "ray-cast"):
    for samples in ([], ["--light-samples", 2]):
        succeed("render", *SCENE, "--light", light + "@radius=0.1", "--technique", technique, *samples,
                "-o", "soft.png", "--visibility", "soft-mask.png")  # fmt: skip
        soft = Image("soft-mask-0.png")
        between = {value for row in soft.rows for value in row} - {(0,), (255,)}
        pixels = sum(map(soft.count, between))
        check(f"{technique}: a soft light's mask has half-shadow", pixels > 20, True)
        check(f"{technique}: more than one value between", len(between) > 1,
              not samples or technique == "stencil-volume")  # fmt: skip

# Views that explain: each is another picture than the plain one, the masks stay. Blue are the volumes
# counted before the receiver, and a count of 1; yellow is the silhouette.
CAST = [*SCENE, "--light", light, "--light", "directional:0,1,-1@technique=depth-map@intensity=0.1"]
OTHER = [*CAST[:-2], "--light", "directional:0,1,-1@technique=stencil-volume@intensity=0.1"]
succeed("render", *CAST, "--technique", "stencil-volume", "--debug", "none", "-o", "plain.png")
succeed("render", *CAST, "--technique", "stencil-volume", "-o", "same.png")
check("--debug none is the plain picture", Image("plain.png").rows == Image("same.png").rows, True)
plain = Image("plain.png")
for view, hue in (
    ("volumes", lambda r, g, b: b - r),
    ("counts", lambda r, g, b: b - r),
    ("silhouette", lambda r, g, b: min(r, g) - b),
):
    # The second time the light to explain is not the first.
    for name, arguments in ((view, [*CAST, "--technique", "stencil-volume"]), (f"{view}-1", OTHER)):
        succeed("render", *arguments, "--debug", view, "-o", f"{name}.png", "--visibility", "debug.png")
        shown = Image(f"{name}.png")
        drawn = sum(hue(*now) > 20 + hue(*before) for rows in zip(shown.rows, plain.rows)
                    for now, before in zip(*rows))  # fmt: skip
        check(f"{name}: 50 or more of {drawn} pixels are nearer to its colour", drawn >= 50, True)
        check(f"{name}: mask in the shadow", mask_at(Image("debug-0.png"), 0, 1), 0)

# Those of the maps: the picture changes, the mask stays. A scene as small as this one has one map, whatever is asked.
succeed("render", *SCENE, "--light", light, "-o", "maps.png")
for view in ("cascades", "texel-density", "map", "lit-part"):
    succeed("render", *SCENE, "--light", light, "--debug", view, "-o", f"{view}.png", "--visibility", "debug.png")
    changed = sum(a != b for rows in zip(Image("maps.png").rows, Image(f"{view}.png").rows) for a, b in zip(*rows))
    check(f"{view}: 50 or more of {changed} pixels are drawn over", changed >= 50, True)
    check(f"{view}: mask in the shadow", mask_at(Image("debug-0.png"), 0, 1), 0)
SUN = [*SCENE, "--light", "directional:0,1,-1"]
succeed("render", *SUN, "-o", "one-map.png")
succeed("render", *SUN, "--cascades", 4, "-o", "four-maps.png")
unlike = sum(a != b for rows in zip(Image("one-map.png").rows, Image("four-maps.png").rows) for a, b in zip(*rows))
check(f"--cascades 4: at most 20 of {unlike} pixels are unlike one map's", unlike <= 20, True)

# Options of object-ID maps and shadow textures. With depths the plate's mask is the depth map's whatever has an ID.
for options in (["--object-type", "piece"], ["--object-depth-bits", 8], ["--object-taps", 4], ["--object-ids-alone"],
                ["--cascades", 3]):  # fmt: skip
    succeed("render", *SCENE, "--light", light, "--technique", "object-id", *options,
            "-o", "objects.png", "--visibility", "objects-mask.png")  # fmt: skip
    check(f"{options}: mask in the shadow", mask_at(Image("objects-mask-0.png"), 0, 1), 0)
    check(f"{options}: mask on the plate", mask_at(Image("objects-mask-0.png"), 0, 0), 255)
# A texture each: beside the smaller plate above it, the lower one is in its shadow.
write_plate("upper.off", height=2.0, half=0.3)
for options, expected in (([], 255), (["--texture-per-caster"], 0)):
    succeed("render", "plate.off", "upper.off", *SCENE[1:], "--light", "directional:0,0.2,-1",
            "--technique", "shadow-texture", *options, "-o", "plates.png", "--visibility", "plates-mask.png")  # fmt: skip
    check(f"{options}: mask on the lower plate, in the shadow of the upper one",
          mask_at(Image("plates-mask-0.png"), 0, 0.44), expected)  # fmt: skip

# How a translucent plate casts: not, whole, or by its opacity; by depth maps without a grain. One of two opacities.
HALF = [*SCENE, "--light", light, "--technique", "depth-map", "--opacity", 0.25]
for name, expected in ((None, 255), ("none", 255), ("opaque", 0), ("transmittance", 0.75 * 255)):
    options = ["--translucent-casters", name] if name else []
    succeed("render", *HALF, *options, "-o", "glass.png", "--visibility", "glass-mask.png")
    check(f"mask behind a translucent plate, {name}", mask_at(Image("glass-mask-0.png"), 0, 1), expected, 1)
succeed("render", *HALF, "--translucent-casters", "stochastic", "-o", "glass.png", "--visibility", "glass-mask.png")
mask = Image("glass-mask-0.png")
dark = sum(255 - value[0] for row in mask.rows for value in row) / 255
check("shadow's pixels by the plate's opacity", dark, 0.25 * shadow_pixels, 0.06 * shadow_pixels)
succeed("render", "plate.off", "upper.off", *SCENE[1:], "--light", "directional:0,0.4,-1", "--technique", "depth-map",
        "--opacity", "1,0.5", "--translucent-casters", "transmittance", "-o", "glass.png",
        "--visibility", "glass-mask.png")  # fmt: skip
glass = Image("glass-mask-0.png")
check("opaque plate of two", mask_at(glass, 0, 0.8), 0)
check("translucent plate of two, on the other", mask_at(glass, 0, 0.44), 127.5, 1)

# Faces that the eye cannot see: left out of the tetrahedron, not of the open plate; the picture stays.
write_tetrahedron("closed.off")
for culls in (False, True):
    option = ["--cull-hidden-faces"] if culls else []
    succeed("render", "closed.off", *SCENE, "--light", light, "--technique", "depth-map", *option,
            "-o", f"culled-{culls}.png", "--json", "culled.json", "--frames", 1)  # fmt: skip
    with open("culled.json") as file:
        check(f"{option}: receivers that were culled", json.load(file)[0]["culled_receivers"], int(culls))
whole, culled = Image("culled-False.png"), Image("culled-True.png")
unlike = sum(a != b for rows in zip(whole.rows, culled.rows) for a, b in zip(*rows))
check(f"--cull-hidden-faces: at most 3 of {unlike} pixels are unlike", unlike <= 3, True)

# A spot straight above, whose cone falls off by the smoothstep of the angle's cosine; beside the plate.
SPOT = "spot:0,0,10:0,0,0:10"
for name, attributes in (("spot", ""), ("falloff", "@falloff=0.8"), ("ambient", "@intensity=0"),
                         ("projected", "@texture=stencil-volume-mask-0.png")):  # fmt: skip
    succeed("render", *SCENE, "--technique", "none", "--light", SPOT + attributes, "-o", f"{name}.png")
plain, falloff, ambient, projected = (Image(f"{name}.png") for name in ("spot", "falloff", "ambient", "projected"))
for y in (-0.7, -1.0, -1.3):
    column, row = pixel(0, y)
    place = (HEIGHT / 2 - row - 0.5) / PIXELS_PER_UNIT  # of the pixel's middle
    cosine, side, inner = (math.cos(angle) for angle in
                           (math.atan(abs(place) / 10), math.radians(10), math.radians(2)))  # fmt: skip
    t = (cosine - side) / (inner - side)
    unlit = ambient.rows[row][column][0]
    full = plain.rows[row][column][0] - unlit
    check(f"light at y = {y}: more than 50 of {full}", full > 50, True)
    check(f"falloff at y = {y}", falloff.rows[row][column][0] - unlit, full * t * t * (3 - 2 * t), 2)
# And that projects a mask, dark above its middle. The light looks along the scene's up: so y is up in the image.
for y, share in ((0.31, 0), (-0.31, 1)):
    column, row = pixel(0, y)
    unlit = ambient.rows[row][column][0]
    check(f"light that the image lets through at y = {y}", projected.rows[row][column][0] - unlit,
          share * (plain.rows[row][column][0] - unlit), 1)  # fmt: skip

# JSON names each light's own technique, and has the frame's times.
succeed("render", *SCENE, "-o", "timed.png", "--technique", "depth-map", "--json", "timed.json", "--frames", 2,
        "--light", light, "--light", "directional:1,0,-1@technique=ray-cast")  # fmt: skip
with open("timed.json") as file:
    rows = json.load(file)
check("techniques in JSON", [row["technique"] for row in rows], ["depth-map", "ray-cast"])
check("lights in JSON", [row["light"] for row in rows], [0, 1])
check("times are positive", all(row["frame_ms_static"] > 0 for row in rows), True)

# Left out, the technique is chosen, and why is printed and in the JSON.
out = succeed("render", *SCENE, "-o", "chosen.png", "--visibility", "chosen.png", "--json", "chosen.json",
              "--frames", 2, "--light", light, "--max-error", 1, "--max-frame-time", 1e6)  # fmt: skip
with open("chosen.json") as file:
    row = json.load(file)[0]
check("technique that is left out", row["technique"], "auto")
check("error within its budget", row["mismatch_percent"] <= 1, True)
check("explanation says the budgets", "1 % wrong was asked for" in row["explanation"]
      and "within the" in row["explanation"], True)  # fmt: skip
check("explanation is printed", "light 0: " in out and "measured in this view" in out or "exact" in out, True)
check("mask in the shadow, chosen", mask_at(Image("chosen-0.png"), 0, 1), 0)

# Without a word.
check("stdout under --quiet", succeed("render", *SCENE, "-o", "quiet.png", "--quiet"), "")

# The floor: none leaves the plate alone, so that nothing is shadowed.
succeed("render", "plate.off", *VIEW, "--floor", "none", "--light", light,
        "-o", "alone.png", "--visibility", "alone-mask.png")  # fmt: skip
check("mask without a floor", Image("alone-mask-0.png").count((255,)), WIDTH * HEIGHT)

# A catcher: the figure and its shadow, and nothing else. What the shadow takes of a floor's brightness is
# what is not ambient, 0.72 of white at 1/sqrt(3). It reaches one unit to the left and down.
write_tetrahedron("tetrahedron.off")
taken = 0.72 / math.sqrt(3)
for technique in ("depth-map", "shadow-texture", "stencil-volume", "ray-cast"):
    succeed("render", "tetrahedron.off", *VIEW, "--floor", "catcher", "--light", "directional:-1,-1,-1",
            "--technique", technique, "-o", "caught.png", "--visibility", "caught-mask.png")  # fmt: skip
    caught = Image("caught.png")
    check(f"{technique}: channels", caught.channels, 4)
    check(f"{technique}: background", caught.rows[0][0], (0, 0, 0, 0))
    check(f"{technique}: alpha of the figure", mask_at(caught, 0.2, 0.2) > 0, True)
    column, row = pixel(-0.3, -0.3)
    check(f"{technique}: colour of the shadow", caught.rows[row][column][:3], (0, 0, 0))
    check(f"{technique}: alpha of the shadow", caught.rows[row][column][3],
          255 * taken / (0.28 + taken), 1)  # fmt: skip
    check(f"{technique}: mask in the shadow", mask_at(Image("caught-mask-0.png"), -0.3, -0.3), 0)

finish()
