"""The tables of Docs/Trade.md, in Markdown (see trade_page.py)."""

import pathlib
import re

from bench_report import KINDS, PEER, cheapest, worst

BUDGETS = (("no gross error", None), ("and 0.1 % mismatch", 0.1), ("and 0.01 %", 0.01))
SOFT_BUDGETS = (0.03, 0.01)


def table(head, lines):
    """Of rows of text."""
    rule = "|" + "---|" * len(head)
    return "\n".join(["| " + " | ".join(head) + " |", rule] + ["| " + " | ".join(line) + " |" for line in lines])


def figure(value):
    """Three digits, as a reader has them: 0.0142, 1.64, 12.4, 812."""
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"


def chosen(row, key):
    """What auto took for each light: its explanation up to the colon."""
    explanations = row.get(key) or ["nothing is said"]
    return "; ".join(dict.fromkeys(text.split(":")[0] for text in explanations))


def over_best(report, row, kind):
    """auto's frame over the fastest fixed setting's without gross error: (ratio, its name), or None."""
    best = cheapest([other for other in report.choices(row["scene"], row["soft"]) if report.is_right(other)], kind)
    return best and (row["ratio_" + kind] / best["ratio_" + kind], best["setting"])


def autos(report, soft=False):
    return [row for scene in report.scenes for row in report.of(scene, soft) if row["technique"] == "auto"]


def auto_table(report, soft=False):
    lines = []
    error = "mean_penumbra_difference" if soft else "mismatch_percent"
    for row in autos(report, soft):
        line = [row["scene"], chosen(row, "explanations"), f"{worst(row, error):.3f}",
                str(max(e["gross_false_pixels"] + e["gross_missed_pixels"] for e in row["errors"]))]  # fmt: skip
        for kind in KINDS:
            if kind == "moving":
                line.append(chosen(row, "explanations_moving"))
            found = over_best(report, row, kind)
            line.append(f"{row['ratio_' + kind]:.2f}" + (f", {found[0]:.2f} times {found[1]}" if found else ", no other is right"))
        lines.append(line)
    head = "difference in the penumbra" if soft else "mismatch %"
    return table(["scene", "auto took, for a still light", head, "gross px", "static, over the best setting",
                  "for a moving light", "moving, over the best setting"], lines)  # fmt: skip


def cheapest_table(report, kind):
    lines = []
    for scene in report.scenes:
        line = [scene]
        for _, most in BUDGETS:
            best = cheapest([row for row in report.choices(scene) if report.is_right(row, most)], kind)
            line.append(f"{best['setting']}, {best['ratio_' + kind]:.2f}" if best else "none")
        lines.append(line)
    return table(["scene"] + [name for name, _ in BUDGETS], lines)


def soft_table(report, kind):
    lines = []
    for scene in report.scenes:
        rows = report.choices(scene, True)
        if not rows:
            continue
        line = [scene]
        of_budgets = [[row for row in rows if worst(row, "mean_absolute_difference") <= most] for most in SOFT_BUDGETS]
        for right in of_budgets + [[row for row in rows if report.is_right(row)]]:
            best = cheapest(right, kind)
            line.append(f"{best['setting'][5:]}, {best['ratio_' + kind]:.2f}" if best else "none")
        lines.append(line)
    heads = [f"mean difference at most {most}" for most in SOFT_BUDGETS]
    return table(["scene"] + heads + [f"and {0.01 * report.limits.penumbra_difference_percent:g} within the penumbra"], lines)


def peer_table(report):
    """VTK's own pass beside depth maps, at the finest resolution that the bench has of both."""
    lines = []
    for scene in report.scenes:
        rows = report.of(scene)
        peers = {row["resolution"]: row for row in rows if row["technique"] == PEER}
        maps = {row["resolution"]: row for row in rows
                if row["setting"] == f"depth-map/percentage-closer/{row['resolution']}"}  # fmt: skip
        shared = sorted(set(peers) & set(maps))
        for resolution in shared[-1:]:
            line = [scene, str(resolution)]
            for row in (peers[resolution], maps[resolution]):
                line += [f"{worst(row, 'mismatch_percent'):.2f}", f"{worst(row, 'gross_percent'):.2f}",
                         f"{row['ratio_static']:.2f}", f"{row['ratio_moving']:.2f}"]  # fmt: skip
            lines.append(line)
    heads = [f"{name}: {what}" for name in ("VTK's", "depth-map") for what in ("mismatch %", "gross %", "static", "moving")]
    return table(["scene", "texels"] + heads, lines)


def exponent_table(report):
    """A row a setting, a column an axis."""
    axes = [axis for axis in ("triangles", "lights", "pixels", "samples") if any(fit["axis"] == axis for fit in report.fits)]
    fits = {(fit["setting"].removeprefix("soft/"), fit["axis"]): fit for fit in report.fits}
    lines = []
    for setting in dict.fromkeys(setting for setting, _ in fits):
        line = [setting]
        for axis in axes:
            fit = fits.get((setting, axis))
            error = "" if fit is None or fit["exponent_error"] is None else f" ± {fit['exponent_error']:.2f}"
            line.append("" if fit is None else "in the noise" if fit["exponent"] is None else f"{fit['exponent']:.2f}{error}")
        lines.append(line)
    return table(["setting"] + axes, lines)


def tables(report):
    """By the name that stands between the page's markers."""
    made = {"machine": machine(report), "auto": auto_table(report), "cheapest-static": cheapest_table(report, "static"),
            "cheapest-moving": cheapest_table(report, "moving"), "soft": soft_table(report, "static"),
            "peer": peer_table(report)}  # fmt: skip
    if autos(report, True):
        made["soft-auto"] = auto_table(report, True)
    if report.fits:
        made["exponents"] = exponent_table(report)
    return made


def machine(report):
    told = report.machine
    # Of files the names alone: where they lie says nothing to a reader.
    plan = re.sub(r"\b(statue|volume|input) ([^,]*)", lambda each: f"{each[1]} {pathlib.PurePath(each[2]).name}", report.plan)
    failed = f" Failed, and left out: {', '.join(report.failures)}." if report.failures else ""
    return (f"Measured with vtkshadows {told['vtkshadows']} on VTK {told['vtk']}, {told['renderer']}, {told['cores']} cores; "
            f"{plan}; {len(report.rows) + len(report.sweeps)} runs.{failed}")  # fmt: skip
