"""The plots of Docs/Trade.md (see trade_page.py)."""

import math

import matplotlib
import matplotlib.pyplot as plt
from bench_report import KINDS, PEER, pareto_front, worst
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from trade_tables import autos, over_best

# Okabe and Ito's palette (2008), and a marker of its own for each; as in the bench's page.
LOOKS = {
    "depth-map": ("#0072B2", "o"), "object-id": ("#56B4E9", "s"), "shadow-texture": ("#009E73", "D"),
    "planar": ("#E69F00", "^"), "stencil-volume": ("#D55E00", "*"), "ray-cast": ("#000000", "X"),
    "auto": ("#C9B400", "P"), PEER: ("#CC79A7", "v"), "none": ("#999999", "x"),
}  # fmt: skip
NAMES = {PEER: "VTK's vtkShadowMapPass", "none": "no shadows"}
LIGHTS = {"static": "the light still, the camera moving", "moving": "the light moving"}
AXES = {"triangles": "triangles of the crowd", "lights": "lights over the still life",
        "pixels": "pixels of the window", "samples": "sample lights of a soft light"}  # fmt: skip

matplotlib.use("Agg")
plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 10, "axes.grid": True, "grid.color": "#e6e6e6", "axes.axisbelow": True,
    "axes.spines.top": False, "axes.spines.right": False, "figure.constrained_layout.use": True,
})  # fmt: skip


def plain(value, _=None):
    """0.001, 20000, 5×10⁵."""
    if 1e-5 < value < 99999:
        return f"{value:.10f}".rstrip("0").rstrip(".")
    decade = math.floor(math.log10(value) + 1e-9)
    lead = round(value / 10**decade, 2)
    times = "" if lead == 1 else f"{lead:g}\\times"
    return f"${times}10^{{{decade}}}$"


def log_axis(axis, values, margin=1.3):
    """Plain numbers at the decades, and at 2 and 5 of short axes."""
    low, high = min(values) / margin, max(values) * margin
    axis.set_view_interval(low, high, ignore=True)
    decades = math.log10(high / low)
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 1.6 else (1, 3) if decades < 2.5 else (1,), numticks=20))
    axis.set_major_formatter(FuncFormatter(plain))
    axis.set_minor_formatter(NullFormatter())


def scatter(axes, x, y, technique, filled, size=38):
    color, marker = LOOKS.get(technique, ("#555555", "o"))
    unfilled = marker == "x"  # a marker that has no inside
    axes.scatter(x, y, s=size * (1.9 if marker == "*" else 1), marker=marker, linewidths=1.2,
                 facecolors=color if filled or unfilled else "none", edgecolors=None if unfilled else color, alpha=0.85,
                 zorder=3)  # fmt: skip


def legend(axes, techniques, gross):
    handles = []
    for technique in LOOKS:
        if technique in techniques:
            color, marker = LOOKS[technique]
            handles.append(Line2D([], [], color=color, marker=marker, linestyle="", label=NAMES.get(technique, technique)))
    if gross:
        handles.append(Line2D([], [], color="#555555", marker="o", fillstyle="none", linestyle="",
                              label="open: with gross error"))  # fmt: skip
    handles += [Line2D([], [], color="#444444", label="Pareto front"),
                Line2D([], [], color="#888888", linestyle="--", label="frame without shadows")]  # fmt: skip
    axes.axis("off")
    axes.legend(handles=handles, loc="center", frameon=False, fontsize=10, labelspacing=0.8)


def error_against_time(report, kind, soft):
    """Small multiples, a scene each; None where there is nothing of the kind."""
    scenes = [scene for scene in report.scenes if report.of(scene, soft)]
    if not scenes:
        return None
    measure = "mean_absolute_difference" if soft else "mismatch_percent"
    cells = len(scenes) + 1
    columns = min(3, cells)
    lines = math.ceil(cells / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(3.9 * columns, 3.0 * lines + 0.5), squeeze=False)
    techniques = set()
    for axes, scene in zip(grid.flat, scenes):
        rows = report.of(scene, soft)
        pixels = max(max(error["receiver_pixels"] for error in row["errors"]) for row in rows)
        floor = 1e-5 if soft else 50 / max(pixels, 1)  # half a pixel
        points = []
        for row in rows:
            x, y = row["ratio_" + kind], max(worst(row, measure), floor)
            scatter(axes, x, y, row["technique"], soft or not report.is_gross(row))
            techniques.add(row["technique"])
            if row["technique"] != "none":
                points.append((x, y))
        axes.plot(*zip(*pareto_front(points)), color="#444444", linewidth=1.2, zorder=2)
        axes.axvline(1, color="#888888", linestyle="--", linewidth=1)
        axes.set(xscale="log", yscale="log", title=scene)
        log_axis(axes.xaxis, [1, *(row["ratio_" + kind] for row in rows)])
        log_axis(axes.yaxis, [max(worst(row, measure), floor) for row in rows], 1.8)
    for axes in grid.flat[len(scenes) + 1:]:
        axes.axis("off")
    legend(grid.flat[len(scenes)], techniques, not soft)
    figure.supxlabel(f"time of a frame over that without shadows; {LIGHTS[kind]}")
    figure.supylabel("mean absolute difference of visibility" if soft else "mismatch, % of the receivers' pixels")
    return figure


def costs(report):
    """Of the sweeps, an axis each, with the fits and their exponents; None without sweeps."""
    axes_there = [axis for axis in AXES if any(fit["axis"] == axis for fit in report.fits)]
    if not axes_there:
        return None
    columns = min(2, len(axes_there))
    lines = math.ceil(len(axes_there) / columns)
    figure, grid = plt.subplots(lines, columns, figsize=(7.4 * columns, 3.6 * lines), squeeze=False)
    for axes in grid.flat[len(axes_there):]:
        axes.axis("off")
    for axes, axis in zip(grid.flat, axes_there):
        xs, ys = [], []
        for fit in report.fits:
            rows = sorted((row for row in report.sweeps if row["axis"] == axis and row["cost_ms_moving"] > 0 and fit["axis"] == axis
                           and (row["setting"].startswith(fit["setting"] + "/") if axis == "samples" else
                                row["setting"] == fit["setting"])), key=lambda row: row["value"])  # fmt: skip
            if not rows:
                continue
            color, marker = LOOKS.get(rows[0]["technique"], ("#555555", "o"))
            exact = "exact" in fit["setting"]
            x, y = [row["value"] for row in rows], [row["cost_ms_moving"] for row in rows]
            xs += x
            ys += y
            label = fit["setting"].removeprefix("soft/").replace(PEER, "VTK's own")
            if fit["exponent"] is not None:
                error = "" if fit["exponent_error"] is None else f" ± {fit['exponent_error']:.2f}"
                label += f":\nexponent {fit['exponent']:.2f}{error}"
                axes.plot([x[0], x[-1]], [fit["factor_ms"] * v ** fit["exponent"] for v in (x[0], x[-1])], color=color,
                          linestyle="--" if exact else "-", linewidth=1.2)  # fmt: skip
            axes.scatter(x, y, color=color, marker=marker, facecolors="none" if exact else color, s=36, label=label, zorder=3)
        axes.set(xscale="log", yscale="log", xlabel=AXES[axis])
        if xs:
            log_axis(axes.xaxis, xs)
            log_axis(axes.yaxis, ys, 1.6)
            axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5), labelspacing=1.1, frameon=False)
    figure.supylabel("milliseconds over the frame without shadows; the light moving")
    return figure


def auto_over_best(report):
    """auto's frame over the fastest right setting's, a scene a line; None where auto was not measured."""
    rows = [row for row in autos(report) if any(over_best(report, row, kind) for kind in KINDS)]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(7.5, 0.34 * len(rows) + 1.3))
    values = [1.0, 1.25]
    for line, row in enumerate(rows):
        for kind, marker, color in (("static", "o", "#0072B2"), ("moving", "D", "#D55E00")):
            found = over_best(report, row, kind)
            if found:
                values.append(found[0])
                axes.scatter(found[0], line, marker=marker, color=color, s=45, zorder=3)
    axes.axvline(1, color="#444444", linewidth=1)
    axes.axvline(1.25, color="#888888", linestyle="--", linewidth=1)
    axes.set(xscale="log", yticks=range(len(rows)), yticklabels=[row["scene"] for row in rows],
             xlabel="auto's frame over that of the fastest setting without gross error (dashed: 1.25)")  # fmt: skip
    axes.invert_yaxis()
    log_axis(axes.xaxis, values, 1.1)
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 1.25, 1.5, 2, 3, 5, 7), numticks=30))
    handles = [Line2D([], [], color="#0072B2", marker="o", linestyle="", label=LIGHTS["static"]),
               Line2D([], [], color="#D55E00", marker="D", linestyle="", label=LIGHTS["moving"])]  # fmt: skip
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.4, -0.18 - 0.6 / len(rows)), ncols=2, frameon=False)
    return figure


def plots(report):
    """Figures by the name of their file."""
    made = {
        "error-static": error_against_time(report, "static", False),
        "error-moving": error_against_time(report, "moving", False),
        "soft-static": error_against_time(report, "static", True),
        "costs": costs(report),
        "auto": auto_over_best(report),
    }
    return {name: figure for name, figure in made.items() if figure is not None}


def save(figure, path):
    # The same figures give the same bytes: neither dates nor versions.
    figure.savefig(path, dpi=80, metadata={"Software": None})
    plt.close(figure)
