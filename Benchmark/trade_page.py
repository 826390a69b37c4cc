"""The plots and tables of Docs/Trade.md, made of what `vtkshadows bench` measured.

    build/bin/vtkshadows bench -o results --sweeps
    /usr/bin/python3 Benchmark/trade_page.py results/bench.json -o Docs/Trade --page Docs/Trade.md

Plots are PNGs in the folder; without sweeps, auto or soft settings in the bench, theirs are not made. A table goes into
the page between two lines, `<!-- bench: NAME -->` and `<!-- bench end -->`, in place of what is there; the page's words are
left alone. Without --page the tables are printed. Needs matplotlib (Debian's python3-matplotlib).
"""

import argparse
import pathlib
import re
import sys

from bench_report import Report
from trade_plots import plots, save
from trade_tables import tables


def fill(page, made):
    """The page's text with the tables that were made in their places; and the places for which none was."""
    missing = []

    def place(match):
        name = match.group(1)
        if name not in made:
            missing.append(name)
            return match.group()
        return f"<!-- bench: {name} -->\n{made[name]}\n<!-- bench end -->"

    return re.sub(r"<!-- bench: ([a-z-]+) -->\n.*?<!-- bench end -->", place, page, flags=re.DOTALL), missing


def main():
    parser = argparse.ArgumentParser(description="The plots and tables of Docs/Trade.md from a bench.json.")
    parser.add_argument("bench", metavar="bench.json", help="as vtkshadows bench writes it")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="FOLDER", help="for the plots; made")
    parser.add_argument("--page", type=pathlib.Path, metavar="FILE", help="the page whose tables are made anew")
    options = parser.parse_args()
    try:
        report = Report(options.bench)
        page = options.page and options.page.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        sys.exit(f"trade_page.py: {error}")
    if not report.rows:
        sys.exit(f"trade_page.py: {options.bench}: no row has an error that was measured; use a build with Embree")
    made = tables(report)
    options.output.mkdir(parents=True, exist_ok=True)
    for name, figure in plots(report).items():
        save(figure, options.output / f"{name}.png")
        print(options.output / f"{name}.png")
    if not options.page:
        print("\n\n".join(f"{name}\n\n{text}" for name, text in made.items()))
        return
    text, missing = fill(page, made)
    options.page.write_text(text, encoding="utf-8")
    print(options.page)
    for name in missing:
        print(f"not in this bench, and left as it was: {name}", file=sys.stderr)


if __name__ == "__main__":
    main()
