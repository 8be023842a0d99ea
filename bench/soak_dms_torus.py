#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A cubic simplex-spline torus over a ring with six corners, figure 2 of [HHQ04]: seconds of its certificate and of
the C++ checker.

    soak_dms_torus.py BIN_FOLDER [--outward] [--grow] [--degree N] [--keep FOLDER]

The domain is a hexagonal ring of cubes, six tetrahedra each, with rational corners; the control points bend it to a
round ring with bulging walls. Clouds reach a tenth of the shortest edge. Those of the boundary are collapsed, or with
--outward drawn outward. --grow also measures rings of about 5,000 and 20,000 tetrahedra, for the exponent.
"""
import argparse
import collections
import itertools
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction

DIRECTIONS = ((30, 0), (15, 26), (-15, 26), (-30, 0), (-15, -26), (15, -26))  # of the corners, about 30 long
INNER, WIDTH = 2, 1


def domain(along, across):
    """(points, tetrahedra): 6 along x across x across cubes."""
    points, numbers = [], {}
    for a, r, z in itertools.product(range(6 * along), range(across + 1), range(across + 1)):
        (side, step), radius = divmod(a, along), INNER + Fraction(WIDTH * r, across)
        (p, q), share = (DIRECTIONS[(side + i) % 6] for i in (0, 1)), Fraction(step, along)
        x, y = (radius / 30 * (p[c] + share * (q[c] - p[c])) for c in (0, 1))
        numbers[a, r, z] = len(points)
        points.append((x, y, Fraction(WIDTH * z, across)))
    tetrahedra = []
    for cube in itertools.product(range(6 * along), range(across), range(across)):
        for order in itertools.permutations(range(3)):
            at, chain = list(cube), []
            for axis in (None, *order):
                if axis is not None:
                    at[axis] += 1
                chain.append(numbers[at[0] % (6 * along), at[1], at[2]])
            if determinant(*(points[v] for v in chain)) < 0:
                chain[2], chain[3] = chain[3], chain[2]
            tetrahedra.append(chain)
    return points, tetrahedra


def determinant(p, q, r, s):
    a, b, c = ([x - y for x, y in zip(v, p)] for v in (q, r, s))
    return sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))


def boundary_vertices(tetrahedra):
    faces = collections.Counter(frozenset(f) for t in tetrahedra for f in itertools.combinations(t, 3))
    return {v for face, count in faces.items() if count == 1 for v in face}


def bent(point):
    """The image: a round ring whose section is a square with bulging sides."""
    x, y, z = map(float, point)
    turn = math.atan2(y, x)
    step = (turn % (math.pi / 3)) - math.pi / 6
    radius = math.hypot(x, y) * math.cos(step) / math.cos(math.pi / 6)
    u, v = 2 * (radius - INNER) / WIDTH - 1, 2 * z / WIDTH - 1
    u, v = u * (1 - v * v / 5), v * (1 - u * u / 5)
    image = ((INNER + (u + 1) * WIDTH / 2) * math.cos(turn), (INNER + (u + 1) * WIDTH / 2) * math.sin(turn), v / 2)
    return [str(round(c * 2**20) / 2**20) for c in image]


def identity(points, tetrahedra):
    return {
        "format": "veritope-dms-1",
        "degree": 1,
        "attributes": [],
        "vertices": [[[str(c) for c in p]] for p in points],
        "tetrahedra": tetrahedra,
        "control": [{"at": [v], "value": [str(c) for c in p]} for v, p in enumerate(points)],
    }


def torus(program, folder, along, across, degree, is_outward):
    """The file of the model, and its number of tetrahedra."""
    points, tetrahedra = domain(along, across)
    start, path = folder / "domain.vdms", folder / f"torus-{along}-{across}.vdms"
    start.write_text(json.dumps(identity(points, tetrahedra)))
    clouds = ["--degree", str(degree), "--clouds", "1/10:1"]
    subprocess.run([program, "dms", "make", start, "-o", path, *clouds], check=True, stdout=subprocess.DEVNULL)
    model = json.loads(path.read_text())
    if not is_outward:
        for v in boundary_vertices(tetrahedra):
            del model["vertices"][v][1:]
    knots = [[[Fraction(c) for c in knot] for knot in cloud] for cloud in model["vertices"]]
    for control in model["control"]:
        used = collections.Counter(control["at"])
        places = [knots[v][min(i, len(knots[v]) - 1)] for v, times in used.items() for i in range(times)]
        control["value"] = bent([sum(p[c] for p in places) / degree for c in range(3)])
    path.write_text(json.dumps(model))
    return path, len(tetrahedra)


def seconds_of(command, codes):
    """Processor time of a command that ends with one of the codes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in codes:
        raise SystemExit(f"{command[0]} ended with {done.returncode}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(options, folder, along, across):
    program, checker = options.bin / "veritope", options.bin / "veritope-check"
    path, count = torus(program, folder, along, across, options.degree, options.outward)
    report, proof = folder / "report.json", folder / "torus.cert"
    command = [program, "certify", "--no-check", "-j", "1", "--json", report, "--certificate", proof, path]
    figures = {"tetrahedra": count, "seconds": seconds_of(command, (0,))}
    figures["checker_seconds"] = seconds_of([checker, path, proof], (0,))
    found = json.loads(report.read_text())["files"][0]
    if found["verdict"] != "VALID" or [shell["genus"] for shell in found["shells"]] != [1]:
        raise SystemExit("the torus is not proved to be one")
    figures["patches"], figures["faces"] = found["counts"]["patches"], found["counts"]["faces"]
    figures["certificate_bytes"] = proof.stat().st_size
    print(json.dumps(figures), file=sys.stderr)
    return figures


def figure(name, value, goal, **more):
    print(json.dumps({"name": name, "value": round(value, 3), "goal": goal, **more}))


def run(options, folder):
    kind = "outward" if options.outward else "collapsed"
    most = 40 if options.outward else 5
    first = measure(options, folder, 4, 3)
    figure(f"dms_torus_{kind}_seconds", first["seconds"], f"<= {most}", **first)
    figure(f"dms_torus_{kind}_checker", first["checker_seconds"], f"<= {2 * most}")
    is_good = first["seconds"] <= most and first["checker_seconds"] <= 2 * most
    if options.grow:
        last = [measure(options, folder, *size) for size in ((6, 5), (10, 8))][-1]
        growth = math.log(last["tetrahedra"] / first["tetrahedra"])
        for key in ("seconds", "checker_seconds"):
            exponent = math.log(last[key] / first[key]) / growth
            figure(f"dms_torus_{kind}_{key}_exponent", exponent, "<= 1.15", tetrahedra=last["tetrahedra"])
            is_good &= exponent <= 1.15
    return is_good


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--outward", action="store_true", help="clouds of the boundary are drawn outward")
    parser.add_argument("--grow", action="store_true", help="also 5,400 and 23,040 tetrahedra")
    parser.add_argument("--degree", type=int, default=3)
    parser.add_argument("--keep", type=pathlib.Path, help="an existing folder for the models")
    options = parser.parse_args()
    if options.keep:
        raise SystemExit(not run(options, options.keep))
    with tempfile.TemporaryDirectory() as folder:
        raise SystemExit(not run(options, pathlib.Path(folder)))


if __name__ == "__main__":
    main()
