"""bench: rows, journal, going on after a cut, CSV, JSON; and its page, as a browser shows it."""

import csv
import json
import math
import os
import re
import shutil
import subprocess

from commandtest import check, command, enter_empty_folder, finish, succeed, write_tetrahedron

enter_empty_folder()
SMALL = ["--size", "160x120", "--detail", "0.05", "--frames", "1", "--quiet"]
SCENES = ["--scenes", "still-life,closed-box"]
SETTINGS = ["--settings", "none,depth-map/percentage-closer/512,stencil-volume/z-fail,vtk-shadow-map/512,"
            "soft/planar/plateaus"]  # fmt: skip


def rows_of(folder):
    with open(os.path.join(folder, "bench.json")) as file:
        return {row["key"]: row for row in json.load(file)["rows"]}


def lines_of(folder):
    with open(os.path.join(folder, "journal.jsonl")) as file:
        return file.read().splitlines()


# --- A bench ---
succeed("bench", "-o", "out", *SCENES, *SETTINGS, *SMALL)
rows = rows_of("out")
names = ["none", "depth-map/none/2048", "depth-map/percentage-closer/512", "stencil-volume/z-fail",
         "vtk-shadow-map/512", "soft/planar/plateaus"]  # fmt: skip
check("rows", sorted(rows), sorted(f"{scene}|{name}" for scene in ("still-life", "closed-box") for name in names))
check("failures", [row["failure"] for row in rows.values() if row["failure"]], [])
with_errors = bool(rows["still-life|none"]["errors"])  # not in a build without Embree
for key, row in rows.items():
    check(f"{key}: times are there", min(row[f"frame_ms_{kind}"] for kind in ("unshadowed", "static", "moving")) > 0, True)
    check(f"{key}: rounds", row["rounds"], 1)
    if not with_errors:
        continue
    error = row["errors"][0]
    check(f"{key}: the error map is there", os.path.exists("out/pictures/" + error["picture"]), True)
    if row["technique"] == "vtk-shadow-map":
        # Read off pictures, the truth itself must come out right: else the peer's figures mean nothing.
        check(f"{key}: error of reading pictures, %", error["error_of_pictures_percent"], 0, 0.05)
if with_errors:
    for scene in ("still-life", "closed-box"):
        unshadowed = rows[f"{scene}|none"]["errors"][0]
        share = 100 * unshadowed["shadow_pixels"] / unshadowed["receiver_pixels"]
        check(f"{scene}: mismatch without shadows is the share in shadow, %", unshadowed["mismatch_percent"], share, 1e-9)
        check(f"{scene}: something is in shadow", share > 1, True)
        exact = rows[f"{scene}|stencil-volume/z-fail"]["errors"][0]
        check(f"{scene}: mismatch of volumes, %", exact["mismatch_percent"], 0, 0.05)
    # VTK's pass casts nothing from a light that shines all around: it is as wrong as no shadow is.
    lamp = rows["closed-box|vtk-shadow-map/512"]["errors"][0]
    check("closed-box by VTK's pass: missed", lamp["gross_missed_pixels"] > 0, True)
stages = [stage["name"] for stage in rows["still-life|stencil-volume/z-fail"]["stages"]]
check("stages", [name for name in ("scene", "stencil-volume", "shading") if name not in stages], [])
check("memory of a map", rows["still-life|depth-map/percentage-closer/512"]["texture_bytes"] > 0, True)

with open("out/bench.csv", newline="") as file:
    table = list(csv.DictReader(file))
check("lines of CSV", len(table), len(rows))
for line in table:
    row = rows[f"{line['scene']}|{line['setting']}"]
    check(f"{row['key']}: CSV has JSON's time", float(line["frame_ms_static"]), row["frame_ms_static"])

# Limits of an error that passes for none, for those who judge the rows.
core = json.loads(subprocess.run([os.environ["VTKSHADOWS_ERROR_LIMIT_CASES"]], capture_output=True, text=True, check=True).stdout)
with open("out/bench.json") as file:
    check("limits are Core's", json.load(file)["limits"], core["limits"])

# --- Going on ---
status, out, err = command("bench", "-o", "out", *SCENES, *SETTINGS, *SMALL)
print("     " + err.strip())
check("status where a journal is", status, 1)
check("the remedy", "--resume" in err, True)
whole = lines_of("out")
shutil.copytree("out", "cut")
with open("cut/journal.jsonl", "w") as file:
    file.write("\n".join(whole[:7]) + "\n" + whole[7][:50])
succeed("bench", "-o", "cut", "--resume", *SCENES, *SETTINGS, *SMALL)
check("rows after the cut", sorted(rows_of("cut")), sorted(rows))
check("lines that were kept", lines_of("cut")[:7], whole[:7])
before = lines_of("cut")
succeed("bench", "-o", "cut", "--resume", *SCENES, *SETTINGS, *SMALL)
check("nothing is measured twice", lines_of("cut"), before)
status, out, err = command("bench", "-o", "cut", "--resume", *SCENES, *SETTINGS, *SMALL[:2], "--detail", "0.06", *SMALL[4:])
print("     " + err.strip())
check("status with another detail", (status, "measured otherwise" in err), (1, True))

# A run in which the bench ended twice is not tried again; once may have been its user.
for times, expected in ((1, None), (2, "the bench ended in it twice; measure it alone, in another folder")):
    os.makedirs(f"ended{times}")
    begin = json.dumps({"begin": "still-life|none"}) + "\n"
    with open(f"ended{times}/journal.jsonl", "w") as file:
        file.write("\n".join(whole[:2]) + "\n" + begin + (json.dumps({"resumed": True}) + "\n" + begin) * (times - 1))
    succeed("bench", "-o", f"ended{times}", "--resume", "--scenes", "still-life", "--settings", "none", *SMALL)
    check(f"ended {times} times in it", rows_of(f"ended{times}")["still-life|none"]["failure"], expected)

# A scene that cannot be made fails its own runs alone.
with open("broken.off", "w") as file:
    file.write("OFF\n3 1 0\n0 0")
succeed("bench", "-o", "broken", "--scenes", "statue,fence", "--settings", "planar/textures", "--statue", "broken.off", *SMALL)
broken = rows_of("broken")
print("     " + str(broken["statue|planar/textures-2048"]["failure"]))
check("the statue's failure names the scene", "statue" in (broken["statue|planar/textures-2048"]["failure"] or ""), True)
check("the fence is measured", broken["fence|planar/textures-2048"]["failure"], None)

# --- The user's own meshes, and sweeps ---
write_tetrahedron("mesh.off")
succeed("bench", "mesh.off", "-o", "own", "--settings", "depth-map/percentage-closer/512", *SMALL)
check("rows of meshes", sorted(rows_of("own")), ["meshes|depth-map/percentage-closer/512"])
check("receivers culled unasked", rows_of("own")["meshes|depth-map/percentage-closer/512"]["culled_receivers"], 0)
# How its frames are drawn, and how what is translucent casts, is the user's to say, too.
SHADOWED = ["--settings", "depth-map/percentage-closer/512", "--opacity", 0.5, *SMALL]
shadowed = []
for how in ("none", "opaque"):
    succeed("bench", "mesh.off", "-o", how, "--translucent-casters", how, *SHADOWED)
    errors = rows_of(how)["meshes|depth-map/percentage-closer/512"]["errors"]
    if with_errors:
        shadowed.append(errors[0]["shadow_pixels"])
if with_errors:
    check("pixels in shadow of what does not cast", shadowed[0], 0)
    check("pixels in shadow of what casts as if opaque", shadowed[1] > 50, True)
status, out, err = command("bench", "mesh.off", "-o", "opaque", "--resume", "--translucent-casters", "none", *SHADOWED)
check("status by another way to cast", (status, "measured otherwise" in err), (1, True))
succeed("bench", "mesh.off", "-o", "culled", "--cull-hidden-faces", "--settings", "depth-map/percentage-closer/512", *SMALL)
check("receivers culled", rows_of("culled")["meshes|depth-map/percentage-closer/512"]["culled_receivers"], 1)
succeed("bench", "-o", "sweeps", "--scenes", "fence", "--settings", "planar,shadow-texture/2048", "--sweeps", "--fast",
        *SMALL)  # fmt: skip
with open("sweeps/bench.json") as file:
    sweeps = json.load(file)
axes = {(fit["axis"], fit["setting"]) for fit in sweeps["fits"]}
expected = {(axis, name) for axis in ("triangles", "lights", "pixels") for name in ("planar", "shadow-texture/2048")}
check("fits", axes, expected | {("samples", "soft/planar")})
for fit in sweeps["fits"]:
    check(f"points of {fit['axis']}, {fit['setting']}", fit["points"] + fit["left_out"], 3)
    rows = [row for row in sweeps["rows"] if row["axis"] == fit["axis"] and row["cost_ms_moving"] > 0 and
            (row["setting"] == fit["setting"] or row["setting"].startswith(fit["setting"] + "/"))]  # fmt: skip
    if fit["exponent"] is not None:  # else a single cost stands out of the noise
        xs, ys = ([math.log(row[key]) for row in rows] for key in ("value", "cost_ms_moving"))
        x0, y0 = sum(xs) / len(xs), sum(ys) / len(ys)
        slope = sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)
        check(f"exponent of {fit['axis']}, {fit['setting']}", fit["exponent"], slope, 1e-9)

# --- The page ---
if not os.path.exists("out/bench.html"):
    print("SKIPPED the page: this build has no Chart.js (libjs-chart.js)")
    finish()
browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if not browser:
    print("SKIPPED the page: no browser is installed (chromium)")
    finish()


def page_of(path):
    run = subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--user-data-dir=" + os.path.abspath("profile"),
         "--virtual-time-budget=10000", "--dump-dom", "file://" + os.path.abspath(path)],
        capture_output=True, text=True, timeout=120, check=False)  # fmt: skip
    return run.stdout


# A table of extremes as the journal of a bench has it; measuring them is the label extremes' own test.
extreme = {"case": "scale by points 1e-12", "kind": "scale by points", "value": "1e-12", "looks_plain": True, "heavy": False,
           "beyond": False, "technique": "planar", "drawn": True, "frame_unlike_percent": 0, "truth_alike_percent": 100,
           "alike_percent": 98.5, "receivers": 100, "shadowed": 5, "uncertain": 0, "mismatch": 1, "gross": 0,
           "mismatch_percent": 1, "opengl_error": 0, "messages": []}  # fmt: skip
shutil.copytree("own", "extremes")
with open("extremes/journal.jsonl", "a") as file:
    file.write(json.dumps({"extreme": extreme["case"], "figures": [extreme]}) + "\n")
succeed("bench", "mesh.off", "-o", "extremes", "--settings", "depth-map/percentage-closer/512", "--resume", *SMALL)
page = page_of("extremes/bench.html")
check("a cell of the extremes is in the page, coloured",
      re.findall(r'<td[^>]*background: rgb\(243, 179, 160\)[^>]*>([^<]*)</td>', page), ["98.500 / 1.000 / 0"])  # fmt: skip
check("script errors of that page", 'data-errors="0"' in page and 'data-done="1"' in page, True)

for path, plots in (("out/bench.html", 4 if with_errors else 0), ("sweeps/bench.html", (1 if with_errors else 0) + 4)):
    page = page_of(path)
    body = re.search(r"<body[^>]*>", page)
    body = body.group() if body else "no body"
    if "sweeps" in path and with_errors:
        plots = 2 + 4  # the fence has hard and soft settings of the technique planar
    check(f"{path}: script errors", 'data-errors="0"' in body, True)
    check(f"{path}: the script came to its end", 'data-done="1"' in body, True)
    inks = [int(ink) for ink in re.findall(r'data-ink="(\d+)"', page)]
    check(f"{path}: plots", len(inks), plots)
    check(f"{path}: blank plots", [ink for ink in inks if ink < 5000], [])
    check(f"{path}: nothing is fetched", re.findall(r'(?:src|href)="(?!data:)[^"]*"', page), [])
finish()
