#!/usr/bin/env python3
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Times `gudgeon check` of large models: python3 bench/check_times.py build/gudgeon

Prints the table of docs/performance.md: processor time of the whole program, reading and printing included, the least
of some runs.
"""
import pathlib
import resource
import subprocess
import sys
import tempfile

SIZES = {"four_bars": (100, 400, 1000, 2000, 5000), "clearance_chain": (100, 500, 1000, 2000)}
RUNS = 5


def find_children_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(program, model):
    before = find_children_time()
    subprocess.run([program, "check", model], stdout=subprocess.DEVNULL, check=True)
    return find_children_time() - before


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print("| model | N | check s | 1000 s / N |\n| --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for kind, sizes in SIZES.items():
            for n in sizes:
                model = pathlib.Path(folder, f"{kind}_{n}.toml")
                writer = pathlib.Path(__file__).with_name("n_four_bar.py")
                model.write_bytes(subprocess.check_output([sys.executable, writer, kind, str(n)]))
                seconds = min(measure(sys.argv[1], model) for _ in range(RUNS))
                print(f"| {kind} | {n} | {seconds:.3f} | {1000 * seconds / n:.3f} |")


main()
