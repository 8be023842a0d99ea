#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Real models: the manifest's truth, and the same verdict after transformations that change nothing.

usage: soak_models.py BIN_FOLDER manifest|jobs|transforms [SEED]
manifest    verdict, exit code and every count of all files against MANIFEST.tsv; both checkers accept every
            certificate.
jobs        report and certificate of every readable file are the same bytes for 1, 2, 3 and 7 jobs.
transforms  every readable file relabelled, mapped exactly (coordinate permutations, reflections, shears and scalings
            that round nothing, the orientation reversed where the determinant is negative) and cut into four: same
            verdict, counts and genus, volume * |det|.
"""
import csv
import fractions
import itertools
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = pathlib.Path(os.environ.get("VERITOPE_DATA", ROOT / "../shared/data")) / "mesh"
BIN = pathlib.Path(sys.argv[1]).resolve()
PYTHON_CHECKER = ROOT / "verify/checker/veritope_check.py"
COUNTS = {"vertices": "vertices", "triangles": "faces", "boundary_edges": "boundary_edges",
          "nonmanifold_edges": "nonmanifold_edges",
          "misoriented_edges": "misoriented_edges", "nonmanifold_vertices": "nonmanifold_vertices",
          "degenerate_faces": "degenerate_faces", "duplicate_faces": "duplicate_faces",
          "selfint_pairs": "selfint_pairs",
          "shells": "shells", "euler": "euler", "genus": "genus"}
sys.path.insert(0, str(PYTHON_CHECKER.parent))
from veritope_checker.mesh.mesh_reader import read_model  # noqa: E402


def certify(path, *more):
    """(exit status, the file's part of the JSON report)."""
    done = subprocess.run([BIN / "veritope", "certify", path, "--json", "-", *more], capture_output=True)
    return done.returncode, json.loads(done.stdout)["files"][0]


def figure(name, value, goal):
    print(json.dumps({"name": name, "value": value, "goal": goal}), flush=True)


def differences(line, status, report):
    """The differences between the report and the manifest's line."""
    if line["class"] == "malformed":
        if status == 4 and report["verdict"] == "UNREADABLE":
            return []
        return [f"exit {status}, {report['verdict']}; expected UNREADABLE"]
    valid = line["valid_solid"] == "1"
    wrong = []
    if report["verdict"] != ("VALID" if valid else "INVALID") or status != (0 if valid else 1):
        wrong.append(f"{report['verdict']}, exit {status}")
    for column, key in COUNTS.items():
        ours = report["counts"][key]
        if line[column] != ("" if ours is None else str(ours)):
            wrong.append(f"{key} {ours}, manifest {line[column]}")
    volume = report["volume"]
    if volume and line["volume_sign"] != str((fractions.Fraction(volume["exact"]) > 0)
                                             - (fractions.Fraction(volume["exact"]) < 0)):
        wrong.append(f"volume {volume['exact']}, sign in the manifest {line['volume_sign']}")
    return wrong


def manifest():
    files = disagree = rejected = certificates = 0
    with open(DATA / "MANIFEST.tsv", newline="") as f, tempfile.TemporaryDirectory() as folder:
        certificate = pathlib.Path(folder) / "c"
        for line in csv.DictReader(f, delimiter="\t"):
            path = DATA / line["file"]
            status, report = certify(path, "--certificate", certificate)
            files += 1
            wrong = differences(line, status, report)
            disagree += bool(wrong)
            for text in wrong:
                print(f"{line['file']}: {text}", file=sys.stderr)
            if status in (0, 1):
                certificates += 1
                for checker in ([BIN / "veritope-check"], [sys.executable, PYTHON_CHECKER]):
                    rejected += subprocess.run([*checker, path, certificate], capture_output=True).returncode != 0
    figure("manifest_files", files, "204, the files of the folder")
    figure("manifest_disagreements", disagree, "0")
    figure("manifest_certificates", certificates, "165")
    figure("manifest_certificates_rejected", rejected, "0, by either checker")
    return disagree + rejected


def jobs():
    files = differ = 0
    with open(DATA / "MANIFEST.tsv", newline="") as f, tempfile.TemporaryDirectory() as folder:
        certificate = pathlib.Path(folder) / "c"
        for line in csv.DictReader(f, delimiter="\t"):
            if line["class"] == "malformed":
                continue
            outputs = set()
            for n in (1, 2, 3, 7):
                _, report = certify(DATA / line["file"], "--certificate", certificate, "--no-check", "--jobs", str(n))
                del report["seconds"]
                outputs.add((json.dumps(report), certificate.read_bytes()))
            files += 1
            if len(outputs) != 1:
                differ += 1
                print(f"{line['file']}: {len(outputs)} outputs", file=sys.stderr)
    figure("jobs_files", files, "165")
    figure("jobs_outputs_that_differ", differ, "0")
    return differ


def exact(value):
    """The fraction as a float, or None if that would round."""
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if fractions.Fraction(number) == value else None


def mapped(points, matrix):
    out = []
    for p in points:
        q = [exact(sum(m * fractions.Fraction(c) for m, c in zip(row, p) if m)) for row in matrix]
        if None in q:
            return None
        out.append(q)
    return out


def determinant(m):
    return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
               for i in range(3))


def random_matrix(rng):
    """A signed permutation, scaled by a power of two, sometimes with a shear."""
    order = rng.sample(range(3), 3)
    matrix = [[0, 0, 0] for _ in range(3)]
    scale = fractions.Fraction(2) ** rng.choice([0, 1, -3, 40, -40])
    for row, column in enumerate(order):
        matrix[row][column] = scale * rng.choice([1, -1])
    if rng.random() < 0.6:
        i, j = rng.sample(range(3), 2)
        matrix[i] = [a + rng.choice([1, -1, 2]) * b for a, b in zip(matrix[i], matrix[j])]
    return matrix


def relabelled(rng, points, faces):
    order = list(range(len(points)))
    rng.shuffle(order)
    place = {v: i for i, v in enumerate(order)}
    out = [tuple(place[v] for v in f) for f in faces]
    out = [f[k:] + f[:k] for f in out for k in [rng.randrange(3)]]
    rng.shuffle(out)
    return [points[v] for v in order], out


def subdivided(points, faces):
    """Each facet cut into four at exact midpoints, or None if one rounds. For sound models only: a duplicate would stay
    one, but a degenerate facet would give four."""
    points, middle, out = list(points), {}, []

    def mid(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            p = [exact((fractions.Fraction(s) + fractions.Fraction(t)) / 2) for s, t in zip(points[a], points[b])]
            if None in p:
                raise ArithmeticError
            middle[key] = len(points)
            points.append(p)
        return middle[key]

    try:
        for a, b, c in faces:
            x, y, z = mid(a, b), mid(b, c), mid(c, a)
            out += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
    except ArithmeticError:
        return None
    return points, out


def write_off(path, points, faces):
    with open(path, "w") as f:
        f.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        f.writelines("%r %r %r\n" % tuple(map(float, p)) for p in points)
        f.writelines("3 %d %d %d\n" % tuple(t) for t in faces)


def compare(before, after, det, cut):
    """The facts that changed although they must not."""
    wrong = []
    keys = ["verdict"]
    if before["verdict"] != after["verdict"]:
        wrong.append(f"verdict {before['verdict']} -> {after['verdict']}")
    keys = ["shells", "bodies", "euler", "genus"] if cut else [
        "faces", "referenced_vertices", "edges", "boundary_edges", "nonmanifold_edges", "misoriented_edges",
        "nonmanifold_vertices",
        "degenerate_faces", "duplicate_faces", "selfint_pairs", "shells", "bodies", "euler", "genus"]
    for key in keys:
        if before["counts"][key] != after["counts"][key]:
            wrong.append(f"{key} {before['counts'][key]} -> {after['counts'][key]}")
    if before["volume"]:
        old, new = (fractions.Fraction(report["volume"]["exact"]) for report in (before, after))
        if new != old * abs(det):
            wrong.append("volume")
    return wrong


def transforms(seed):
    rng = random.Random(seed)
    runs = changed = 0
    done = {"relabelled": 0, "mapped": 0, "cut": 0}
    with open(DATA / "MANIFEST.tsv", newline="") as f, tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "m.off"
        for line in csv.DictReader(f, delimiter="\t"):
            if line["class"] == "malformed" or int(line["triangles"]) > 20000:
                continue
            source = DATA / line["file"]
            fmt = {"stlb": "stl"}.get(line["format"], line["format"])
            points, faces = read_model(source.read_bytes(), fmt, False)[:2]
            _, before = certify(source, "--no-check")
            variants = [("relabelled", 1, False, relabelled(rng, points, faces))]
            for matrix in itertools.islice((random_matrix(rng) for _ in itertools.count()), 4):
                moved, det = mapped(points, matrix), determinant(matrix)
                if moved:
                    turned = faces if det > 0 else [(a, c, b) for a, b, c in faces]
                    variants.append(("mapped", det, False, relabelled(rng, moved, turned)))
            if line["valid_solid"] == "1":
                variants.append(("cut", 1, True, subdivided(points, faces)))
            for name, det, cut, model in variants:
                if model is None:
                    continue
                write_off(path, *model)
                _, after = certify(path)
                wrong = compare(before, after, det, cut)
                runs += 1
                done[name] += 1
                changed += bool(wrong)
                for text in wrong:
                    print(f"{line['file']} {name} (seed {seed}): {text}", file=sys.stderr)
    figure("transforms_runs", runs, ">= 400: " + ", ".join(f"{k} {v}" for k, v in done.items()))
    figure("transforms_changed", changed, "0")
    return changed


def main(mode, seed="1"):
    return 1 if {"manifest": manifest, "jobs": jobs, "transforms": lambda: transforms(int(seed))}[mode]() else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[2:]))
