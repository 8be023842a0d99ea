#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Microstructures inside of random solids: what `veritope micro --model` keeps is proved inside, and false claims are
not.

usage: soak_micro_inside.py BIN_FOLDER --rounds N --seed S [--python-share P]
Solids are unions of cubes with tunnels, notches and voids, and spheres with bubbles, scaled and sheared. Cages are
boxes, hulls and rings. Each round: the microstructure must be VALID with --model, the C++ checker accepts it, and a
share goes to the Python checker. In box cages bubbles are cut into the solid: in the corner of a cell, where the answer
must stay VALID; in a node and across arms, where it must not be. Nor may it be for the solid moved away by its width,
or shrunk below the size of a tile. One JSON line a kind.
"""
import argparse
import csv
import fractions
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PYTHON_CHECKER = ROOT / "verify/checker/veritope_check.py"
FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def cube_mesh(low, high, turned=False):
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    return corners, [face[::-1] if turned else face for face in FACES]


def joined(*meshes):
    points, faces = [], []
    for more, polygons in meshes:
        faces += [tuple(i + len(points) for i in f) for f in polygons]
        points += more
    return points, faces


def polycube(rng):
    """The boundary of a union of cubes: a block without some of its cubes."""
    size = [rng.randint(2, 5) for _ in range(3)]
    cubes = set(itertools.product(*map(range, size)))
    for _ in range(rng.randint(0, 4)):
        axis, at = rng.randrange(3), [rng.randrange(n) for n in size]
        line = {tuple(i if a == axis else at[a] for a in range(3)) for i in range(size[axis])}
        hole = {tuple(at)} if rng.random() < .5 else line
        if len(cubes - hole) > 2:
            cubes -= hole
    numbers, faces = {}, []
    for cube in sorted(cubes):
        for n, face in enumerate(FACES):
            axis = (2, 1, 0)[n // 2]
            if tuple(c + ((1 if n % 2 else -1) if a == axis else 0) for a, c in enumerate(cube)) in cubes:
                continue
            corners = [tuple(cube[a] + (i >> a & 1) for a in range(3)) for i in face]
            faces.append(tuple(numbers.setdefault(p, len(numbers)) for p in corners))
    return list(numbers), faces


def sphere(rng, radius, middle, turned):
    around, up = rng.randint(6, 40), rng.randint(4, 24)
    points = [(0, 0, -radius), (0, 0, radius)]
    for j in range(1, up):
        for i in range(around):
            a, b = 2 * math.pi * i / around, math.pi * j / up - math.pi / 2
            unit = (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
            points.append(tuple(radius * x for x in unit))
    at = lambda i, j: 0 if j == 0 else 1 if j == up else 2 + (j - 1) * around + i % around  # noqa: E731
    faces = []
    for j in range(up):
        for i in range(around):
            quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
            for triangle in ((quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])):
                if len(set(triangle)) == 3:
                    faces.append(triangle[::-1] if turned else triangle)
    return [tuple(x + m for x, m in zip(p, middle)) for p in points], faces


def hollow_sphere(rng):
    parts = [sphere(rng, 1.0, (0, 0, 0), False)]
    for sign in (-1, 1)[:rng.randint(0, 2)]:
        middle = (sign * .45, rng.uniform(-.1, .1), rng.uniform(-.1, .1))
        parts.append(sphere(rng, rng.choice((.05, .2, .4)), middle, True))
    return joined(*parts)


def some_solid(rng):
    points, faces = polycube(rng) if rng.random() < .6 else hollow_sphere(rng)
    scale, shear = 2.0 ** rng.randint(-3, 6), rng.choice((0, 0, .25))
    if rng.random() < .5:
        points = [(x + shear * y, y, z + shear * x) for x, y, z in points]
    return [tuple(scale * c for c in p) for p in points], faces


def as_off(mesh):
    points, faces = mesh
    return f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%r %r %r\n" % p for p in points) + "".join(
        f"{len(f)} {' '.join(map(str, f))}\n" for f in faces)


class Soak:
    def __init__(self, options, folder):
        self.options, self.bin = options, pathlib.Path(options.bin).resolve()
        self.model, self.other, self.cage, self.out, self.list, self.certificate = (
            folder / name for name in ("m.off", "other.off", "cage.vjson", "out.vmicro", "list.csv", "out.cert"))
        self.counts = dict.fromkeys(("rounds", "empty", "kept", "failures", "lies", "accepted_lies", "bubbles",
                                     "refused_bubbles", "python", "python_rejects"), 0)

    def run(self, *arguments):
        done = subprocess.run([self.bin / "veritope", *map(str, arguments)], capture_output=True, text=True,
                              timeout=600, check=False)
        return done.returncode, done.stdout + done.stderr

    def verdict(self, model):
        status, text = self.run("certify", self.out, "--model", model, "--certificate", self.certificate)
        return {0: "VALID", 3: "UNDECIDED"}.get(status, f"status {status}"), text

    def is_solid(self, mesh):
        self.other.write_text(as_off(mesh))
        return self.run("certify", "-q", self.other)[0] == 0

    def complain(self, seed, what, text):
        print(f"seed {seed}: {what}: {text.splitlines()[0] if text else ''}", file=sys.stderr)

    def round(self, seed):
        rng = random.Random(seed)
        mesh = some_solid(rng)
        if not self.is_solid(mesh):
            return
        self.model.write_text(self.other.read_text())
        kind = rng.choice(("box", "box", "hull", "radial"))
        more = {"box": [], "hull": ["--degrees", rng.choice(("2,2,2", "3,3,3"))], "radial": []}[kind]
        status, text = self.run("cage", kind, "--around", self.model, "-o", self.cage, *more)
        if status != 0:
            return
        node = rng.choice(("1/5", "1/8", "1/4"))
        tile = f"jack,node={node},cap={rng.choice(('1/8', '1/16', '1/10'))},degree={rng.choice((1, 3))}"
        counts = [rng.randint(4, 12) for _ in range(3)]
        status, text = self.run("micro", "--cage", self.cage, "--tile", tile, "--counts", ",".join(map(str, counts)),
                                "--model", self.model, "--list", self.list, "-o", self.out)
        if status not in (0, 3):
            return self.complain(seed, f"micro ends with {status}", text)
        with open(self.list, newline="") as file:
            kept = [tuple(int(row[k]) for k in "ijk") for row in csv.DictReader(file) if row["status"] == "kept"]
        if not kept:
            self.counts["empty"] += 1
            return
        self.counts["rounds"] += 1
        self.counts["kept"] += len(kept)
        verdict, text = self.verdict(self.model)
        if verdict != "VALID":
            self.counts["failures"] += 1
            return self.complain(seed, f"{kind}: not VALID inside of its own model", text)
        self.check_in_python(rng, seed)
        self.lies(rng, seed, mesh)
        if kind == "box":
            self.bubbles(rng, seed, mesh, counts, rng.choice(kept))

    def check_in_python(self, rng, seed):
        if rng.random() >= self.options.python_share:
            return
        self.counts["python"] += 1
        done = subprocess.run([sys.executable, "-B", PYTHON_CHECKER, self.out, self.certificate, "--model", self.model],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            self.counts["python_rejects"] += 1
            self.complain(seed, "the Python checker", done.stdout)

    def lies(self, rng, seed, mesh):
        points, faces = mesh
        axis = rng.randrange(3)
        width = max(p[axis] for p in points) - min(p[axis] for p in points)
        away = [tuple(c + (width if a == axis else 0) for a, c in enumerate(p)) for p in points]
        small = [tuple((c - points[0][a]) / 256 + points[0][a] for a, c in enumerate(p)) for p in points]
        for name, lie in (("moved away", (away, faces)), ("shrunk", (small, faces))):
            self.lie(seed, name, lie)

    def lie(self, seed, name, mesh):
        if not self.is_solid(mesh):
            return
        self.counts["lies"] += 1
        verdict, text = self.verdict(self.other)
        if verdict != "UNDECIDED":
            self.counts["accepted_lies"] += 1
            self.complain(seed, f"{name}: {verdict}", text)

    def bubbles(self, rng, seed, mesh, counts, cell):
        points = json.loads(self.cage.read_text())["entities"][0]["shape"]["points"]
        corners = [[float(fractions.Fraction(x)) for x in p] for p in points]
        low, high = corners[0], corners[-1]
        sizes = [(high[a] - low[a]) / counts[a] for a in range(3)]
        at = lambda t: [low[a] + (cell[a] + t[a]) * sizes[a] for a in range(3)]  # noqa: E731
        bubble = lambda lo, hi: joined(mesh, cube_mesh(at(lo), at(hi), True))    # noqa: E731
        half = rng.choice((.001, .03, .1))
        self.lie(seed, "a bubble in the node", bubble((.5 - half,) * 3, (.5 + half,) * 3))
        self.lie(seed, "a bubble across arms", bubble((.1,) * 3, (.9,) * 3))
        begin, side = rng.choice((1 / 64, 1 / 16)), rng.choice((2 ** -12, 1 / 64, 1 / 8))
        free = bubble((begin,) * 3, (begin + side,) * 3)
        if not self.is_solid(free):
            return
        self.counts["bubbles"] += 1
        verdict, text = self.verdict(self.other)
        if verdict != "VALID":
            self.counts["refused_bubbles"] += 1
            self.complain(seed, f"a bubble of {side} at {begin} of cell {cell}: {verdict}", text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bin")
    parser.add_argument("--rounds", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--python-share", type=float, default=.1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        soak = Soak(options, pathlib.Path(folder))
        for n in range(options.rounds):
            soak.round(options.seed * 1000003 + n)
    c = soak.counts
    for name, value, more in (
            ("not_proved", c["failures"] + c["refused_bubbles"],
             ("rounds", "empty", "kept", "failures", "bubbles", "refused_bubbles")),
            ("accepted_lies", c["accepted_lies"], ("lies",)), ("python_rejects", c["python_rejects"], ("python",))):
        more = {key: c[key] for key in more}
        print(json.dumps({"name": f"micro_inside_{name}", "value": value, "goal": "0", **more}))


if __name__ == "__main__":
    main()
