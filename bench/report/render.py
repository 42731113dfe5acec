#!/usr/bin/env python3
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Brings the generated parts of docs/performance.md up to date with bench/baselines/*.csv.

A table stands between <!-- generated: NAME --> and <!-- end -->; everything else in the page is left as it is. Figures
are written to docs/performance/. Standard library only.
"""
import re
import sys
from pathlib import Path

import figures
import tables
from baseline import read_baseline

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "performance.md"
FIGURES = ROOT / "docs" / "performance"
SECTION = re.compile(r"(<!-- generated: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def main():
    baselines = {}
    for path in sorted((ROOT / "bench" / "baselines").glob("*.csv")):
        baselines[path.stem] = read_baseline(path)

    def fill(match):
        table = getattr(tables, match[2] + "_table", None)
        if table is None:
            sys.exit(f"render.py: docs/performance.md asks for '{match[2]}', and there is no such table")
        return f"{match[1]}\n{table(baselines)}\n\n{match[3]}"

    PAGE.write_text(SECTION.sub(fill, PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    FIGURES.mkdir(exist_ok=True)
    for name, picture in figures.draw_all(baselines).items():
        (FIGURES / f"{name}.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main()
