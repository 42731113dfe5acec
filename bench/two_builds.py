#!/usr/bin/env python3
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Compares two builds on the nine-bar study: python3 bench/two_builds.py EARLIER/build/gudgeon build/gudgeon

Prints processor time and evaluations of the second beside the first. The motion is chaotic, so builds differ in what
they compute: the study runs with some clearances a hair apart, and of each the least time of some runs counts, taken in
turns and each with another size of the environment, which moves the stack.
"""
import os
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile

CLEARANCES = [f"{0.5 + k * 1e-6:.6f} mm" for k in range(5)]
ROUNDS = 7
MODEL = pathlib.Path(__file__).parent.parent / "examples/nine_bar/nine_bar.toml"
STUDY = {"study.cycles": "10", "study.wear_stages": "2"}


def find_children_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(program, clearance, folder):
    """Processor time [s] and evaluations of all stages."""
    changes = dict(STUDY, **{"joints.A.radial_clearance": f'"{clearance}"'})
    command = [program, "run", MODEL, "-o", folder, "--overwrite", "--threads", "1"]
    for path, value in changes.items():
        command += ["--set", f"{path}={value}"]
    environment = dict(os.environ, PADDING="x" * random.randrange(4096))
    before = find_children_time()
    told = subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout
    seconds = find_children_time() - before
    rows = re.findall(r"^  \w+ +finished +\d+ +\S+ \S+ +\S+ \S+ +(\d+(?: \d{3})*)", told, re.MULTILINE)
    return seconds, sum(int(row.replace(" ", "")) for row in rows)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    least = {}
    evaluations = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            for clearance in CLEARANCES:
                for program in sys.argv[1:]:
                    seconds, n = run(program, clearance, folder)
                    key = (program, clearance)
                    least[key] = min(seconds, least.get(key, seconds))
                    evaluations[key] = n
    earlier, now = ([(least[p, c], evaluations[p, c]) for c in CLEARANCES] for p in sys.argv[1:])
    for name, column in (("processor time", 0), ("evaluations", 1)):
        a, b = (sum(row[column] for row in rows) for rows in (earlier, now))
        each = sorted(y[column] / x[column] for x, y in zip(earlier, now))
        print(f"{name}: {b / a:.3f} of the earlier build's, {each[0]:.3f} to {each[-1]:.3f} of {len(each)}")


main()
