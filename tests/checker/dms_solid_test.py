#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Both checkers of dms-solid-1: honest certificates of `veritope certify` are accepted, and each lie dies by the condition that is named.
VERITOPE names the program."""
import copy
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction as Q

import judges

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "support")]
import dms_files as files                                 # noqa: E402

judges.judge(judges.vc)
MADE = {}


def bent(p):
    x, y, z = p
    return [x + y * y / 16, y + z * x / 32, z]


def mirrored(p):
    return [-p[0], p[1], p[2]]


def certified(data):
    """(what certify says, a Proof or None)"""
    if data not in MADE:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "m.vdms")
            path.write_bytes(data)
            done = subprocess.run([os.environ["VERITOPE"], "certify", path, "--no-check", "--certificate", f"{path}.cert"],
                                  capture_output=True, text=True, check=False, timeout=600)
            kept = pathlib.Path(f"{path}.cert")
            MADE[data] = done.stdout, files.Proof(data, kept.read_bytes()) if kept.exists() else None
    said, proof = MADE[data]
    return said, copy.deepcopy(proof)


def block(degree=2, counts=(1, 1, 1), radius=Q(1, 20), reach=False, warp=bent, seed=1, keep=lambda cell: True):
    points, tetrahedra = files.grid_domain(counts, keep)
    return files.model(degree, files.clouds_of(points, degree, counts, radius, seed, reach), tetrahedra, warp)


def as_leaf_p(proof):
    for tree in proof.body.trees:
        tree[0][1] = 13
    return proof


class Case(unittest.TestCase):
    def proof(self, data):
        said, proof = certified(data)
        self.assertIsNotNone(proof, said)
        return proof

    def judged(self, expected, proof, skip=(), **values):
        code, line = judges.both(proof.data, proof.certificate(**values), frozenset(skip))
        self.assertEqual(judges.condition(line), expected, line)
        self.assertEqual(code, 0 if expected == "ACCEPT" else 1, line)

    def dies_by(self, condition, proof, **values):
        """By this condition alone: without it the certificate is accepted."""
        self.judged(condition, proof, **values)
        self.judged("ACCEPT", proof, (condition,), **values)


class Honest(Case):
    # PROVES DMS-1
    def test_blocks(self):
        for data in (block(), block(3), block(1), block(2, (2, 2, 2)), block(3, (2, 2, 2), Q(1, 4)), block(4, (1, 1, 2)),
                     block(2, (1, 1, 1), reach=True), block(2, (2, 1, 1), Q(0))):
            self.judged("ACCEPT", self.proof(data))

    def test_a_ring(self):
        data = block(2, (3, 3, 1), Q(0), keep=lambda cell: cell != (1, 1, 0))
        proof = self.proof(data)
        self.assertEqual(proof.statement["genus"], 1)
        self.judged("ACCEPT", proof)

    def test_separate_control_points(self):
        self.judged("ACCEPT", self.proof(files.separate(block(2, (1, 1, 1), Q(0)))))

    def test_leaves_of_kind_p(self):
        # Without clouds in the inside the map of each tetrahedron is one polynomial.
        self.judged("ACCEPT", as_leaf_p(self.proof(block(2))))

    def test_cut_leaves(self):
        proof = self.proof(block(2))
        for at in (None, Q(1, 3)):
            for edge in range(6):
                forged = copy.deepcopy(proof)
                leaf = forged.body.trees[0][0]
                forged.body.trees[0] = [["cut", edge, at], leaf, leaf]
                self.judged("ACCEPT", forged)


def own_domain(degree=1, attributes=("heat",)):
    """An attribute domain: one tetrahedron that has nothing to do with the model."""
    control = [{"at": list(at), "value": ["1/2"] * len(attributes)} for at in itertools.combinations_with_replacement(range(4), degree)]
    return {"degree": degree, "attributes": list(attributes), "vertices": [[[str(9 * (i == a)) for a in range(3)]] for i in range(-1, 3)],
            "tetrahedra": [[0, 1, 2, 3]], "control": control}


class AttributeDomains(Case):
    def with_domain(self, change=lambda own, file: None, **own):
        proof = self.proof(block(2))
        file = json.loads(proof.data)
        file["attribute_domain"] = own_domain(**own)
        change(file["attribute_domain"], file)
        proof.data = json.dumps(file).encode()
        return proof

    def test_they_mean_nothing(self):
        for own in {}, {"degree": 3, "attributes": ("heat", "load")}:
            self.judged("ACCEPT", self.with_domain(**own))
        # A reversed tetrahedron, far away: syntax is all that is looked at.
        self.judged("ACCEPT", self.with_domain(lambda own, _: own["tetrahedra"][0].reverse()))

    def test_the_claim_is_about_the_geometry(self):
        def swap(_, file):
            file["tetrahedra"][3][:2] = file["tetrahedra"][3][1::-1]
        self.judged("D1", self.with_domain(swap))

    def test_what_the_format_forbids_is_refused(self):
        def turn(own, file):
            file["attribute_domain"] = dict(reversed(own.items()))

        def move(own, file):
            file["control"] = file.pop("control")  # now the last key
        changes = (lambda own, _: own.pop("degree"), lambda own, _: own.update(format="veritope-dms-1"), lambda own, _: own.update(degree=0),
                   lambda own, _: own.update(degree=10), lambda own, _: own.update(attributes=[]), lambda own, _: own.update(attributes=[""]),
                   lambda own, _: own.update(attributes=["a", "b"]), lambda own, _: own["vertices"].pop(),
                   lambda own, _: own["vertices"][0].append(["1", "2"]), lambda own, _: own["tetrahedra"].clear(),
                   lambda own, _: own["tetrahedra"].append([0, 1, 2, 4]), lambda own, _: own["control"].pop(),
                   lambda own, _: own["control"].append(own["control"][0]), lambda own, _: own["control"][0]["value"].append("0"),
                   lambda own, _: own["control"][0].update(value=["1/0"]), lambda own, _: own["control"][0].update(at=[4]),
                   lambda own, file: file.update(attribute_domain=None), lambda own, file: file.update(attribute_domain=[own]),
                   lambda own, _: own.update(attribute_domain=own_domain()), turn, move,
                   lambda own, file: (file.update(attributes=["heat"]), [c["value"].append("1") for c in file["control"]]),
                   lambda own, _: own.update(attributes=[str(i) for i in range(257)], control=[
                       {"at": c["at"], "value": ["1"] * 257} for c in own["control"]]))
        for number, change in enumerate(changes):
            proof = self.with_domain(change)
            code, line = judges.both(proof.data, proof.certificate())
            self.assertEqual(code, 4, (number, line))


class Refuted(Case):
    def test_what_is_no_solid_is_invalid(self):
        for data in block(warp=mirrored), block(2, (2, 2, 2), warp=lambda p: [p[0] * (3 - p[0]), p[1], p[2]]):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder, "m.vdms")
                path.write_bytes(data)
                done = subprocess.run([os.environ["VERITOPE"], "certify", path, "--no-check"], capture_output=True, text=True, check=False,
                                      timeout=600)
                self.assertEqual(done.returncode, 1, done)
                self.assertIn("jacobian: the determinant of the derivative is below 0 at (", done.stdout)


class Lies(Case):
    def of_model(self, change, data=None):
        """A proof of the model, about a changed one."""
        proof = self.proof(data or block(2, (2, 2, 2)))
        file = json.loads(proof.data)
        change(file)
        proof.data = json.dumps(file).encode()
        return proof

    # PROVES DMS-1.D1
    def test_a_reversed_tetrahedron(self):
        def swap(f):
            f["tetrahedra"][3][:2] = f["tetrahedra"][3][1::-1]
        self.judged("D1", self.of_model(swap))

    # PROVES DMS-1.D2
    def test_a_face_twice(self):
        self.judged("D2", self.of_model(lambda f: f["tetrahedra"].__setitem__(1, f["tetrahedra"][0])))

    # PROVES DMS-1.D3
    def test_another_domain(self):
        proof, other = self.proof(block(2, (2, 1, 1))), self.proof(block(2, (1, 2, 1)))
        proof.body.domain = other.body.domain
        code, line = judges.both(proof.data, proof.certificate())
        self.assertEqual(code, 1)
        self.assertIn(judges.condition(line), ("C1", "B1", "C2", "C3", "W1"))

    # PROVES DMS-1.E1
    def test_control_points_that_disagree(self):
        def move(f):
            f["control"][-1]["value"][0] = "1001/1000"
        proof = self.of_model(move, files.separate(block(2, (1, 1, 1), Q(0), warp=lambda p: p)))
        self.judged("E1", proof)

    # PROVES DMS-1.E2
    def test_a_knot_behind_a_face(self):
        def move(f):
            cloud = next(c for c in f["vertices"] if len(c) > 1)
            cloud[1] = ["4", "1", "1"]
        self.judged("E2", self.of_model(move))

    # PROVES DMS-1.E3
    def test_a_knot_of_the_boundary_inside(self):
        def move(f):
            corner = next(i for i, c in enumerate(f["vertices"]) if c[0] == ["0", "0", "0"])
            f["vertices"][corner].append(["1/64", "1/64", "1/64"])
        self.judged("E3", self.of_model(move, block(2)))

    # PROVES DMS-1.J1
    def test_a_matrix_of_another_map(self):
        proof = self.proof(block(2))
        proof.body.trees[2][0][2] = [Q(c) for c in (1, 9, 0, 0, 1, 0, 0, 0, 1)]
        self.dies_by("J1", proof)

    # PROVES DMS-1.J2
    def test_a_leaf_of_kind_p_that_knots_cut(self):
        self.judged("J2", as_leaf_p(self.proof(block(2, (2, 2, 2)))))
        proof = as_leaf_p(self.proof(block(2)))
        proof.body.trees[2][0][2] = [Q(c) for c in (1, 9, 0, 0, 1, 0, 0, 0, 1)]
        self.dies_by("J2", proof)

    # PROVES DMS-1.J3
    def test_a_mirror(self):
        # The map is turned inside out in the first place: R turns it back, but for J3.
        proof = self.proof(block(2))
        leaf = proof.body.trees[0][0]
        leaf[2] = [-c for c in leaf[2]]
        self.judged("J3", proof)

    # PROVES DMS-1.T1
    def test_tiles_that_do_not_tile(self):
        honest = self.proof(block(2, (1, 1, 1), reach=True))
        face = next(i for i, tiles in enumerate(honest.body.tiles) if len(tiles) > 3)
        def without(b):
            del b.tiles[face][1]
        def twice(b):
            b.tiles[face].append(b.tiles[face][0])
        def turned(b):
            b.tiles[face][0][0].reverse()
        def off_the_plane(b):
            b.points[0] = [c + Q(1, 1000) for c in b.points[0]]
        for lie in (without, twice, turned, off_the_plane):
            proof = copy.deepcopy(honest)
            lie(proof.body)
            self.judged("T1", proof)

    # PROVES DMS-1.T2
    def test_a_face_that_knots_cut(self):
        proof = self.proof(block(2, (1, 1, 1), reach=True))
        face = next(i for i, tiles in enumerate(proof.body.tiles) if len(tiles) > 3)
        proof.body.tiles[face] = []
        self.judged("T2", proof)

    # PROVES DMS-1.T3
    def test_the_surface_of_another_map(self):
        proof, other = self.proof(block(2, (2, 1, 1))), self.proof(block(2, (2, 1, 1), warp=lambda p: [2 * p[0], p[1], p[2]]))
        proof.body.surface = other.body.surface
        code, line = judges.both(proof.data, proof.certificate())
        self.assertEqual(code, 1)
        self.assertIn(judges.condition(line), ("C1", "B1", "C2", "C3", "W1"))

    def test_wrong_numbers(self):
        proof = self.proof(block(2))
        for key in ("tetrahedra", "control_points", "leaves", "patches", "shells", "bodies", "genus"):
            self.dies_by("W3", proof, **{key: 7 + proof.statement[key]})


class Limits(Case):
    def test_the_layout(self):
        proof = self.proof(block(2))
        honest = proof.body.encode()
        for body in (honest[:-1], honest + b"\0", b"VTDX" + honest[4:], honest[:4] + b"\xff\xff\xff\xff" + honest[8:],
                     honest[:8] + b"\xff\xff\xff\xff" + honest[12:], honest[:12] + b"\xff\xff\xff\x0f" + honest[16:], b"", b"VTDM"):
            code, line = judges.both(proof.data, proof.certificate(body))
            self.assertEqual((code, judges.condition(line)), (1, "B1"), line)

    def test_cuts_at_the_ends_of_edges(self):
        proof = self.proof(block(2))
        leaf = proof.body.trees[0][0]
        for at in (Q(0), Q(1), Q(-1, 2), Q(3, 2)):
            proof.body.trees[0] = [["cut", 0, at], leaf, leaf]
            self.judged("B1", proof)

    def test_long_numbers(self):
        proof = self.proof(block(2))
        proof.body.trees[0][0][2][0] += Q(1, 3**700)
        self.judged("B2", proof)

    def test_refused_models(self):
        proof = self.proof(block(2))
        proof.data = proof.data.replace(b'"degree": 2', b'"degree": 3')
        self.assertEqual(judges.both(proof.data, proof.certificate())[0], 4)


if __name__ == "__main__":
    unittest.main()
