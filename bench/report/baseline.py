# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Baselines as the benchmarks write them: a line on how they were made, a header, rows."""
import csv
import math
from dataclasses import dataclass


@dataclass
class Baseline:
    made_with: str
    rows: list  # of dictionaries


def read_baseline(path):
    with open(path, encoding="utf-8", newline="") as file:
        first = file.readline()
        return Baseline(first.lstrip("# ").strip(), list(csv.DictReader(file)))


def number(row, column):
    """The value of a column; not a number where it is missing."""
    text = row.get(column) or "nan"
    return float(text)


def case_of(row):
    """Google Benchmark appends how it ran: name/iterations:7/manual_time."""
    return row["name"].split("/")[0]


def figure(value, digits=3):
    """A number with a few significant digits, a dash for what was not measured."""
    if math.isnan(value):
        return "–"
    if value == 0.0:
        return "0"
    places = digits - 1 - math.floor(math.log10(abs(value)))
    if places <= 0:
        return f"{round(value, places):.0f}"
    return f"{value:.{places}f}" if places < 6 else f"{value:.{digits - 1}e}"


def spread(row, column):
    """Median and quartiles in one cell."""
    middle = number(row, column)
    if math.isnan(middle):
        return "–"
    return f"{figure(middle)} ({figure(number(row, column + '.q1'))} – {figure(number(row, column + '.q3'))})"
