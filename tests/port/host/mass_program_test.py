#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs batuta-mass as a user would: mass_program_test.py PROGRAM GUARD_OBJ GROUP."""

import json
import os
import struct
import subprocess
import sys
import tempfile

PROGRAM, GUARD, GROUP = sys.argv[1:4]
CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 4)]
# Each face of the box, counter-clockwise from outside; corners are counted from 1.
FACES = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=600, check=False)


def check(condition, what):
    if not condition:
        sys.exit("FAILED: %s" % (what,))


def near(number, truth, error=1e-12):
    return abs(number - truth) <= error * max(1.0, abs(truth))


def write(folder, name, content):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode("ascii"))
    return path


def obj(faces):
    vertices = "".join("v %g %g %g\n" % corner for corner in CORNERS)
    return vertices + "".join("f " + " ".join(map(str, face)) + "\n" for face in faces)


def binary_stl(faces):
    triangles = [(f[0], f[i], f[i + 1]) for f in faces for i in (1, 2)]
    bytes_of = b"solid in name only".ljust(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        corners = [x for corner in triangle for x in CORNERS[corner - 1]]
        bytes_of += struct.pack("<12fH", 0, 0, 0, *corners, 0)
    return bytes_of


def refuses(words, exit_code, *parts):
    """The program leaves with the code, nothing on standard output, and one line that holds all parts."""
    result = run(*words)
    check(result.returncode == exit_code, (words, result.returncode, result.stderr))
    check(result.stdout == "", (words, result.stdout))
    check(result.stderr.startswith("batuta-mass: ") and result.stderr.count("\n") == 1, (words, result.stderr))
    for part in parts:
        check(part in result.stderr, (words, part, result.stderr))


def told(*words):
    """The one JSON object that the program prints."""
    result = run(*words, "--json")
    check(result.returncode == 0 and result.stderr == "" and result.stdout.count("\n") == 1, (words, result))
    return json.loads(result.stdout)


def usage(folder):
    box = write(folder, "box.obj", obj(FACES))
    help_text = run("--help")
    check(help_text.returncode == 0 and help_text.stderr == "", help_text)
    for word in ("FILE", "--density", "--mass", "--scale", "--json", "Exit codes"):
        check(word in help_text.stdout, word)
    check(max(map(len, help_text.stdout.splitlines())) <= 120, "help fits a terminal")
    refuses([], 2, "FILE")
    refuses(["--nonsense", box], 2, "--nonsense")
    refuses([box, "stray"], 2, "stray")
    for option in ("--density", "--mass", "--scale"):
        for number in ("0", "-1", "x", "nan", "inf", "1e999", ""):
            refuses([box, option, number], 2, option)
    refuses([box, "--density", "1", "--mass", "1"], 2, "--mass")
    refuses([os.path.join(folder, "none.obj")], 2, "none.obj", "No such file")
    refuses([write(folder, "box.ply", "ply")], 2, "box.ply", ".obj or .stl")
    os.mkdir(os.path.join(folder, "folder.obj"))
    refuses([os.path.join(folder, "folder.obj")], 2, "folder.obj", "cannot be read")


def check_box(answer, mass, unit):
    """A box of 1 x 2 x 4 units with a corner at the origin."""
    square, cube = unit**2, unit**3
    check(near(answer["mass"], mass), answer)
    check(near(answer["volume"] / cube, 8) and near(answer["area"] / square, 28), answer)
    check(near(answer["density"], mass / (8 * cube)), answer)
    check(all(near(x / unit, truth) for x, truth in zip(answer["center"], (0.5, 1, 2))), answer)
    moments = [mass * square / 12 * sides for sides in (1 + 4, 1 + 16, 4 + 16)]
    check(all(near(x / mass, truth / mass) for x, truth in zip(answer["moments"], moments)), answer)
    for i, row in enumerate(answer["inertia"]):
        for j, element in enumerate(row):
            check(near(element / mass, moments[2 - i] / mass if i == j else 0), answer)
    check(near(sum(x * x for x in answer["axes"]), 1), answer)


def answers(folder):
    for name, content in (("box.obj", obj(FACES)), ("box.stl", binary_stl(FACES))):
        box = write(folder, name, content)
        check_box(told(box), 7850 * 8, 1)
        check_box(told(box, "--density", "2"), 16, 1)
        check_box(told(box, "--mass", "3"), 3, 1)
        check_box(told(box, "--mass", "3", "--scale", "0.001"), 3, 0.001)
        check_box(told(box, "--scale", "0.5"), 7850, 0.5)
        check(told(box)["triangles"] == 12 and told(box)["vertices"] == 8, told(box))
    text = run(GUARD, "--scale", "0.001")
    check(text.returncode == 0 and text.stderr == "", text)
    lines = text.stdout.splitlines()
    check([line.split()[0] for line in lines[:7]]
          == ["mesh", "density", "mass", "volume", "area", "centre", "inertia"], text.stdout)
    # 90 x 10 x 10 and 10 x 30 x 10 mm: 12 cm^3 of steel
    check(near(float(lines[2].split()[1]), 12e-6 * 7850, 1e-9), lines[2])
    x = (9 * 45 + 3 * 5) / 12e3
    y = (9 * 5 + 3 * 25) / 12e3
    check(all(near(float(word), truth, 1e-9) for word, truth in zip(lines[5].split()[1:], (x, y, 0.005))), lines[5])
    check("batuta::MassProperties<float> mass" in text.stdout and "make_body<float>" in text.stdout, text.stdout)


def refusals(folder):
    inside_out = [face[::-1] for face in FACES]
    for name, form in (("a.obj", obj), ("b.stl", binary_stl)):
        refuses([write(folder, name, form(FACES[1:]))], 1, name, "open: the edge from vertex", "triangle")
        refuses([write(folder, name, form(inside_out))], 1, name, "inverted", "turn the triangles round")
        refuses([write(folder, name, form([inside_out[0]] + FACES[1:]))], 1, name, "go the same way along")
        refuses([write(folder, name, form(FACES + [(1, 2, 8, 7)]))], 1, name, "triangles")
        refuses([write(folder, name, form(FACES + [(1, 1, 2, 3)]))], 1, name, "triangle 13: no area")
        refuses([write(folder, name, form(FACES[:1]))], 1, name, "2 triangles enclose nothing")
    refuses([write(folder, "c.obj", obj(FACES) + "f 1 2 9\n")], 1, "c.obj: line 15: there is no vertex 9")
    refuses([write(folder, "d.stl", binary_stl(FACES)[:-1])], 1, "d.stl", "12 triangles take 684 bytes")
    refuses([write(folder, "e.stl", bytes(range(256)) * 4)], 1, "e.stl", "neither an ASCII STL")
    refuses([write(folder, "f.stl", "")], 1, "f.stl", "neither an ASCII STL")
    refuses([write(folder, "g.stl", "solid\nfacet\n")], 1, "g.stl: line 2: expected: facet normal X Y Z")
    refuses([write(folder, "h.obj", obj(FACES)), "--scale", "1e150"], 1, "too large")
    # What the printed lines of C++ could not hold, or a body of floats not be made of.
    for scale in ("1e30", "1e9", "1e-10", "1e-16"):
        refuses([write(folder, "i.obj", obj(FACES)), "--scale", scale], 1, "i.obj", "for a body of floats")
    # The mass alone, and the moments alone: what is beyond float would make a body that cannot be moved.
    for words in (("--mass", "1e39"), ("--mass", "1e38", "--scale", "6")):
        refuses([write(folder, "j.obj", obj(FACES)), *words], 1, "j.obj", "for a body of floats")


with tempfile.TemporaryDirectory() as scratch:
    {"Usage": usage, "Answers": answers, "Refusals": refusals}[GROUP](scratch)
