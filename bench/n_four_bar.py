#!/usr/bin/env python3
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Writes models whose size is a number: python3 n_four_bar.py four_bars|clearance_chain N > model.toml

four_bars: N four-bars in a row, N + 1 posts and N beams of 1 m. clearance_chain: N bars hung one from the other by
revolute joints with clearance.
"""
import sys

CONTACT = """
[materials.steel]
young_modulus = "200 GPa"
poisson_ratio = 0.3

[contacts.steel]
bearing_material = "steel"
journal_material = "steel"
normal_force = { law = "lankarani_nikravesh", restitution = 0.9 }
"""


def write_bar(name, angle):
    print(f"\n[bodies.{name}]\nmass = 1\ninertia = {1 / 12!r}\ncenter_of_mass = [0.5, 0]")
    print(f"points = {{ a = [0, 0], b = [1, 0] }}\nstart = {{ angle = \"{angle} deg\" }}")


def write_revolute(name, first, second):
    print(f"\n[joints.{name}]\ntype = \"revolute\"\nbetween = [\"{first}\", \"{second}\"]")


def write_four_bars(n):
    pivots = ", ".join(f"p{i} = [{i}, 0]" for i in range(n + 1))
    print(f"name = \"four_bars_{n}\"\ngravity = [0, -9.81]\n\n[bodies.frame]\npoints = {{ {pivots} }}")
    for i in range(n + 1):
        write_bar(f"post_{i}", 90)
        write_revolute(f"foot_{i}", f"frame.p{i}", f"post_{i}.a")
        if i > 0:
            write_bar(f"beam_{i}", 0)
            write_revolute(f"left_{i}", f"post_{i - 1}.b", f"beam_{i}.a")
            write_revolute(f"right_{i}", f"beam_{i}.b", f"post_{i}.b")
    print("\n[study]\ncycle_time = \"1 s\"\ncycles = 1")


def write_clearance_chain(n):
    print(f"name = \"clearance_chain_{n}\"\ngravity = [0, -9.81]\n\n[bodies.frame]\npoints = {{ b = [0, 0] }}")
    for i in range(n):
        write_bar(f"bar_{i}", -90)
        first = "frame.b" if i == 0 else f"bar_{i - 1}.b"
        print(f"\n[joints.j{i}]\ntype = \"revolute_clearance\"\nbearing = \"{first}\"\njournal = \"bar_{i}.a\"")
        print("bearing_radius = \"10 mm\"\nradial_clearance = \"0.1 mm\"\nwidth = \"10 mm\"\ncontact = \"steel\"")
    print(CONTACT + "\n[study]\ncycle_time = \"1 s\"\ncycles = 1")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("four_bars", "clearance_chain"):
        sys.exit(__doc__)
    (write_four_bars if sys.argv[1] == "four_bars" else write_clearance_chain)(int(sys.argv[2]))


main()
