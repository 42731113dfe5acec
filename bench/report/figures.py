# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/performance.md as SVG: work against precision, and cost a loop."""
import math

from baseline import case_of, number
from tables import METHODS

WIDTH, HEIGHT = 720, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 210, 40, 50
COLORS = ["#0b6e8f", "#5fb0c9", "#3a7d34", "#b5472f", "#d69226", "#7b5aa6"]


class LogPlot:
    """Both axes logarithmic; series are drawn one after the other, each with its name on the right."""

    def __init__(self, title, x_title, y_title, points):
        finite = [p for p in points if all(math.isfinite(v) and v > 0.0 for v in p)]
        self.x = self.decades([p[0] for p in finite])
        self.y = self.decades([p[1] for p in finite])
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
                      'font-family="sans-serif" font-size="12">',
                      f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
                      self.text(LEFT, 22, title, size=14)]
        self.n_series = 0
        self.draw_axes(x_title, y_title)

    @staticmethod
    def decades(values):
        return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)) + 1e-9)

    @staticmethod
    def text(x, y, words, anchor="start", size=12, turn=""):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}"{turn}>{words}</text>'

    def at(self, x, y):
        share_x = (math.log10(x) - self.x[0]) / (self.x[1] - self.x[0])
        share_y = (math.log10(y) - self.y[0]) / (self.y[1] - self.y[0])
        return LEFT + share_x * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - share_y * (HEIGHT - TOP - BOTTOM)

    def draw_axes(self, x_title, y_title):
        for k in range(self.x[0], self.x[1] + 1):
            x, bottom = self.at(10.0 ** k, 10.0 ** self.y[0])
            self.parts.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{bottom:.1f}" stroke="#dddddd"/>')
            self.parts.append(self.text(x, bottom + 16, f"1e{k}", "middle"))
        for k in range(self.y[0], self.y[1] + 1):
            x, y = self.at(10.0 ** self.x[0], 10.0 ** k)
            self.parts.append(f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#dddddd"/>')
            self.parts.append(self.text(x - 6, y + 4, f"1e{k}", "end"))
        middle = (TOP + HEIGHT - BOTTOM) / 2
        self.parts.append(self.text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_title, "middle"))
        self.parts.append(self.text(18, middle, y_title, "middle", turn=f' transform="rotate(-90 18 {middle:.1f})"'))

    def add(self, name, points):
        points = [self.at(*p) for p in points if all(math.isfinite(v) and v > 0.0 for v in p)]
        if not points:
            return
        color = COLORS[self.n_series % len(COLORS)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in points]
        y = TOP + 14 + 20 * self.n_series
        self.parts.append(f'<rect x="{WIDTH - RIGHT + 14}" y="{y - 9}" width="12" height="10" fill="{color}"/>')
        self.parts.append(self.text(WIDTH - RIGHT + 32, y, name))
        self.n_series += 1

    def finish(self):
        return "\n".join(self.parts + ["</svg>", ""])


def draw_precision(rows, case):
    def points(method):
        return [(number(r, "error"), number(r, "seconds")) for r in rows if r["method"] == method]

    plot = LogPlot(f"{case.replace('_', ' ')}: time of the whole run against error over the short horizon",
                   "largest error of the motion (rad, m)", "processor time (s)",
                   [p for method in METHODS for p in points(method)])
    for method, title in METHODS.items():
        plot.add(title, points(method))
    return plot.finish()


def draw_loops(rows):
    loops = [r for r in rows if case_of(r).startswith("n_four_bar_")]

    def points(column):
        return [(int(case_of(r).rsplit("_", 1)[1]), number(r, column) / int(case_of(r).rsplit("_", 1)[1]))
                for r in loops]

    series = {"gudgeon": "gudgeon_ns", "textbook": "textbook_ns", "sparse textbook": "sparse_ns"}
    plot = LogPlot("N-four-bar: one evaluation", "loops N", "ns a loop", [p for c in series.values() for p in points(c)])
    for title, column in series.items():
        plot.add(title, points(column))
    return plot.finish()


def draw_all(baselines):
    pictures = {"cost_a_loop": draw_loops(baselines["eval"].rows)}
    rows = baselines["precision"].rows
    for case in dict.fromkeys(row["case"] for row in rows):
        pictures[f"precision_{case}"] = draw_precision([r for r in rows if r["case"] == case], case)
    return pictures
