#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Cracks of one ulp to 1e-3 and holes, planted into a sphere of triangles: the report tells them apart, and names
the right edge and gap.

    soak_gaps.py BIN_FOLDER [--count N] [--seed S]

A crack moves one corner of one face. Its four open edges must be near the edges that they belonged to, with the exact
gap: the smaller of the greatest distances of one edge from the other one, in rationals. A hole is one face or two that
are missing; no edge of it may be near another.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests" / "support"))
from edge_gaps import squared_distance  # noqa: E402


def sphere(turns, rings):
    """(points, faces)."""
    points = [(0.0, 0.0, 1.0)]
    for r in range(1, rings):
        for t in range(turns):
            polar, turn = math.pi * r / rings, 2 * math.pi * t / turns
            points.append((math.sin(polar) * math.cos(turn), math.sin(polar) * math.sin(turn), math.cos(polar)))
    points.append((0.0, 0.0, -1.0))
    ring = lambda r, t: 1 + (r - 1) * turns + t % turns
    faces = [(0, ring(1, t), ring(1, t + 1)) for t in range(turns)]
    for r in range(1, rings - 1):
        for t in range(turns):
            faces.append((ring(r, t), ring(r + 1, t), ring(r + 1, t + 1)))
            faces.append((ring(r, t), ring(r + 1, t + 1), ring(r, t + 1)))
    return points, faces + [(ring(rings - 1, t), len(points) - 1, ring(rings - 1, t + 1)) for t in range(turns)]


def report(program, points, faces):
    text = f"OFF {len(points)} {len(faces)} 0\n" + "".join("%r %r %r\n" % p for p in points)
    text += "".join("3 %d %d %d\n" % f for f in faces)
    options = ["--format", "off", "--as-indexed", "--json", "-", "--no-check"]
    done = subprocess.run([program, "certify", *options, "-"], input=text, capture_output=True, text=True)
    return json.loads(done.stdout)["files"][0]


def plant_crack(rng, points, faces):
    """The old and the new number of the vertex that a face's corner leaves."""
    face, corner = rng.randrange(len(faces)), rng.randrange(3)
    old = faces[face][corner]
    direction = [rng.gauss(0, 1) for _ in range(3)]
    step = 10 ** rng.uniform(-16, -3) / math.hypot(*direction)
    moved = tuple(a + step * d for a, d in zip(points[old], direction))
    points.append(moved if moved != points[old] else (math.nextafter(points[old][0], 9), *points[old][1:]))
    faces[face] = tuple(len(points) - 1 if i == corner else v for i, v in enumerate(faces[face]))
    return old, len(points) - 1


def is_right_crack(found, points, old, new):
    defects = [d for d in found["defects"] if d["rule"] == "M3"]
    if len(defects) != 4 or found["counts"]["near_edges"] != 4:
        return False
    exact = [[Fraction(x) for x in p] for p in points]
    for defect in defects:
        a, b = defect["edges"][0]
        moved, kept = (a, b) if a in (old, new) else (b, a)
        other = sorted((kept, old if moved == new else new))
        e, f = [exact[a], exact[b]], [exact[v] for v in other]
        gap = min(squared_distance(e, f), squared_distance(f, e))
        if defect["near_edge"] != other or Fraction(defect["gap"]["squared"]) != gap:
            return False
    return True


def is_right(rng, program, wants_crack):
    points, faces = (list(part) for part in sphere(16, 12))
    if wants_crack:
        old, new = plant_crack(rng, points, faces)
        return is_right_crack(report(program, points, faces), points, old, new)
    for _ in range(rng.choice((1, 1, 2))):
        del faces[rng.randrange(len(faces))]
    found = report(program, points, faces)
    return found["rules"]["M3"] >= 3 and found["counts"]["near_edges"] == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    models, wrong = {"cracks": 0, "holes": 0}, {"cracks": 0, "holes": 0}
    for seed in range(options.seed, options.seed + options.count):
        kind = ("holes", "cracks")[seed % 2]
        models[kind] += 1
        if not is_right(random.Random(seed), options.bin / "veritope", kind == "cracks"):
            wrong[kind] += 1
            print(f"wrong: --count 1 --seed {seed}", file=sys.stderr)
    for kind, number in wrong.items():
        print(json.dumps({"name": f"gaps_wrong_{kind}", "value": number, "goal": "0", "models": models[kind]}))
    raise SystemExit(any(wrong.values()))


if __name__ == "__main__":
    main()
