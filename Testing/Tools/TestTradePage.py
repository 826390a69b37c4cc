"""trade_page.py: the tables and plots of a bench of which each figure is known."""

import json
import os
import subprocess
import sys

script = sys.argv[1]
folder = sys.argv[2]
os.makedirs(folder, exist_ok=True)
os.chdir(folder)
sys.path.insert(0, os.path.dirname(script))
failed = 0


def check(what, got, expected):
    global failed
    ok = got == expected
    failed += not ok
    print(f"{'ok  ' if ok else 'FAIL'} {what}: got {got!r}, expected {expected!r}")


def row(scene, setting, ratio, mismatch, gross, moving=None, **more):
    """A row as the bench writes it, of 100 000 receiver pixels: `gross` of them, `mismatch` in percent."""
    error = {"light": 0, "receiver_pixels": 100000, "mismatch_percent": mismatch, "gross_false_pixels": gross,
             "gross_missed_pixels": 0, "gross_percent": gross / 1000, "mean_absolute_difference": mismatch / 100,
             "mean_penumbra_difference": mismatch / 25}  # fmt: skip
    made = {"key": f"{scene}|{setting}", "scene": scene, "setting": setting, "soft": setting.startswith("soft/"),
            "technique": setting.removeprefix("soft/").split("/")[0], "axis": None, "value": None, "failure": None,
            "resolution": 2048 if "2048" in setting else None, "errors": [error], "ratio_static": ratio,
            "ratio_moving": moving or ratio, "cost_ms_moving": 1.0}  # fmt: skip
    made.update(more)
    return made


rows = [
    row("a", "none", 1.0, 20.0, 20000),
    row("a", "vtk-shadow-map/2048", 1.1, 12.0, 9000),
    row("a", "depth-map/percentage-closer/2048", 1.5, 0.05, 2),  # two gross pixels: fastest, but not right
    row("a", "shadow-texture/2048", 2.0, 0.2, 1, moving=4.0),  # one in 100 000 is right
    row("a", "stencil-volume", 4.0, 0.0, 0, moving=2.5),
    row("a", "auto", 2.2, 0.05, 0, moving=3.0, explanations=["depth-map (1024 texels): 0.05 % wrong", "ray-cast: else"],
        explanations_moving=["stencil-volume: exact", "stencil-volume: as well"]),
    row("a", "soft/ray-cast/16-samples", 5.0, 0.9, 0),
    row("a", "soft/depth-map/soft/2048", 3.0, 2.0, 0),
    row("a", "soft/stencil-volume/8-samples", 4.0, 0.9, 0, moving=3.0),
    row("a", "soft/ray-cast/4-samples", 2.0, 1.01, 0),  # 0.0404 within the penumbra: steps can be seen
    row("a", "soft/auto", 4.4, 0.5, 0, explanations=["ray-cast (16 samples): 0.5 %"]),
    row("a", "planar", 1.0, 0.0, 0, failure="it broke"),
    row("a", "object-id/2048", 1.0, 2.1, 0),  # not gross, but too much
    row("b", "auto", 1.2, 0.0, 0),  # nothing to hold it against
]
fits = [{"axis": "triangles", "setting": "stencil-volume", "exponent": 0.9, "exponent_error": 0.05, "factor_ms": 0.01,
         "points": 2, "left_out": 0},
        {"axis": "lights", "setting": "planar", "exponent": None, "exponent_error": None, "factor_ms": None, "points": 0,
         "left_out": 3}]  # fmt: skip
rows += [row("crowd", "stencil-volume", 2, 0, 0, axis="triangles", value=value, errors=[], cost_ms_moving=0.01 * value**0.9)
         for value in (1e4, 1e5)]  # fmt: skip
rows[3]["errors"][0]["receiver_pixels"] = 20000  # nor is a single one gross error where pixels are few
limits = {"gross_percent": 0.001, "gross_pixels": 1, "mismatch_percent": 2.0, "soft_difference_percent": 1.0,
          "penumbra_difference_percent": 4.0}  # fmt: skip
report = {"limits": limits, "machine": {"vtkshadows": "0", "vtk": "9", "renderer": "r", "cores": 2}, "plan": "window 4x3, statue /some/where/scan.off",
          "scenes": [{"name": "a"}, {"name": "b"}], "rows": rows, "fits": fits}  # fmt: skip
with open("bench.json", "w") as file:
    json.dump(report, file)


def run(*arguments):
    done = subprocess.run([sys.executable, script, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


page = "# Words\n\n<!-- bench: auto -->\nold\n<!-- bench end -->\n\nmore words\n<!-- bench: other -->\nkept\n<!-- bench end -->\n"
with open("page.md", "w") as file:
    file.write(page)
status, out, err = run("bench.json", "-o", "plots", "--page", "page.md")
print(out, err)
check("status", status, 0)
text = open("page.md").read()
check("the table is in the page, its words and other places are kept", text == page.replace(
    "old", "| scene | auto took, for a still light | mismatch % | gross px | static, over the best setting | for a moving light | "
    "moving, over the best setting |\n|---|---|---|---|---|---|---|\n"
    "| a | depth-map (1024 texels); ray-cast | 0.050 | 0 | 2.20, 1.10 times shadow-texture/2048 | stencil-volume | 3.00, 1.20 times stencil-volume |\n"
    "| b | nothing is said | 0.000 | 0 | 1.20, no other is right | nothing is said | 1.20, no other is right |"), True)  # fmt: skip
check("a place without a table is told of", "other" in err, True)
pictures = ("auto", "costs", "error-moving", "error-static", "soft-static")
check("plots", sorted(os.listdir("plots")), [f"{name}.png" for name in pictures])
before = {name: open(f"plots/{name}.png", "rb").read() for name in pictures}
again = run("bench.json", "-o", "plots", "--page", "page.md")
check("the same bench gives the same page", (again[0], open("page.md").read() == text), (0, True))
check("and the same plots", [name for name in pictures if open(f"plots/{name}.png", "rb").read() != before[name]], [])

import matplotlib.image  # noqa: E402

for name in pictures:
    # Of what is drawn: not white, and neither grey.
    pixels = matplotlib.image.imread(f"plots/{name}.png")[:, :, :3]
    coloured = (pixels.max(axis=2) - pixels.min(axis=2) > 0.2).sum()
    check(f"{name}: markers are drawn", coloured > 50, True)

from bench_report import Report  # noqa: E402
from trade_tables import tables  # noqa: E402

made = {name: table.splitlines()[2:] for name, table in tables(Report("bench.json")).items()}
check("cheapest right settings", made["cheapest-static"],
      ["| a | shadow-texture/2048, 2.00 | stencil-volume, 4.00 | stencil-volume, 4.00 |", "| b | none | none | none |"])  # fmt: skip
check("while the light moves", made["cheapest-moving"][0], "| a | stencil-volume, 2.50 | stencil-volume, 2.50 | stencil-volume, 2.50 |")
check("soft", made["soft"], ["| a | ray-cast/4-samples, 2.00 | stencil-volume/8-samples, 4.00 | stencil-volume/8-samples, 4.00 |"])
check("auto among soft settings", made["soft-auto"],
      ["| a | ray-cast (16 samples) | 0.020 | 0 | 4.40, 1.10 times soft/stencil-volume/8-samples | nothing is said | "
       "4.40, 1.47 times soft/stencil-volume/8-samples |"])  # fmt: skip
check("VTK's own pass", made["peer"], ["| a | 2048 | 12.00 | 9.00 | 1.10 | 1.10 | 0.05 | 0.00 | 1.50 | 1.50 |"])
told = tables(Report("bench.json"))["machine"]
check("files by name alone, failures told", ("statue scan.off" in told, "/some" in told, "a|planar" in told), (True, False, True))
check("exponents", made["exponents"], ["| stencil-volume | 0.90 ± 0.05 |  |", "| planar |  | in the noise |"])

# Masks shade what is nearest in a pixel: where things are translucent, techniques by masks do not count.
glass = [row("g", "ray-cast", 1.2, 0.0, 0), row("g", "planar", 1.1, 0.0, 0), row("g", "planar/textures-2048", 2.5, 0.0, 0, moving=3.0),
         row("g", "object-id/2048", 2.0, 0.0, 0, moving=5.0), row("g", "soft/ray-cast/16-samples", 2.0, 0.1, 0),
         row("g", "soft/depth-map/soft/2048", 9.0, 0.1, 0), row("g", "auto", 2.0, 0.0, 0)]  # fmt: skip
with open("glass.json", "w") as file:
    json.dump(dict(report, scenes=[{"name": "g", "translucents": True}], rows=glass), file)
made = {name: table.splitlines()[-1] for name, table in tables(Report("glass.json")).items()}
check("cheapest that shades translucent things", (made["cheapest-static"], made["cheapest-moving"]),
      ("| g | object-id/2048, 2.00 | object-id/2048, 2.00 | object-id/2048, 2.00 |",
       "| g | planar/textures-2048, 3.00 | planar/textures-2048, 3.00 | planar/textures-2048, 3.00 |"))  # fmt: skip
check("soft, too", made["soft"], "| g | depth-map/soft/2048, 9.00 | depth-map/soft/2048, 9.00 | depth-map/soft/2048, 9.00 |")
check("and auto is held against those", made["auto"].split(" | ")[4], "2.00, 1.00 times object-id/2048")

# By other limits other settings are right: the two gross pixels, and the steps in the penumbra.
loose = dict(report, limits=dict(limits, gross_pixels=2, soft_difference_percent=1.02,
                                  penumbra_difference_percent=5.0))  # fmt: skip
with open("loose.json", "w") as file:
    json.dump(loose, file)
made = {name: table.splitlines() for name, table in tables(Report("loose.json")).items()}
check("cheapest by looser limits", made["cheapest-static"][2],
      "| a | depth-map/percentage-closer/2048, 1.50 | depth-map/percentage-closer/2048, 1.50 | stencil-volume, 4.00 |")  # fmt: skip
check("soft by looser limits", (made["soft"][0].split(" | ")[-1], made["soft"][2].split(" | ")[-1]),
      ("and 0.05 within the penumbra |", "ray-cast/4-samples, 2.00 |"))  # fmt: skip

for name, content, told in (("empty.json", "{}", "machine"), ("no.json", "no JSON", "is no JSON"),
                            ("old.json", json.dumps(dict(report, limits={})), "--resume"),
                            ("older.json", json.dumps({key: report[key] for key in report if key != "limits"}), "--resume")):  # fmt: skip
    with open(name, "w") as file:
        file.write(content)
    status, out, err = run(name, "-o", "none")
    print("     " + err.strip())
    check(f"{name}: one message that names it", (status, err.count("\n"), name in err, told in err, os.path.exists("none")),
          (1, 1, True, True, False))  # fmt: skip
print(f"{failed} failed")
sys.exit(1 if failed else 0)
