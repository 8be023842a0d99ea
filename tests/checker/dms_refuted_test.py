#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of `veritope certify` about simplex-spline solids with a defect: both checkers accept them, each finding occurs, and what is
changed in them is rejected. VERITOPE names the program."""
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
import dms_defective                                      # noqa: E402
import dms_invalid_fields as fields                       # noqa: E402

judges.judge(judges.vc)
# What is changed: the number of a field, and its new value. Nothing of a face, a tetrahedron or a point may be another one.
LIES = {
    "tet-reversed": [(0, 1)], "tet-face-overused": [(1, 2), (2, 0)], "cloud-degenerate": [(0, 0), (1, 1)], "cloud-no-core": [(0, 0), (7, Q(1, 3))],
    "cloud-inside": [(5, 3), (6, Q(-1))], "jacobian": [(0, Q(1, 4)), (0, Q(5))], "jacobian-zero": [(1, Q(2)), (0, 5)], "M4": [(0, 1), (1, 2)],
    "M6": [(0, 1)], "M7": [(4, Q(1, 3)), (0, 0)], "M9": [(0, 1), (2, Q(50))], "meeting": [(0, Q(1, 3)), (3, Q(1, 2))],
    "crossing": [(0, 1), (2, Q(9)), (24, 63)], "covering": [(0, 12), (1, Q(50)), (14, Q(50))],
}


def mixed(p, q, share):
    return [a + share * (b - a) for a, b in zip(p, q)]


def refuted(data):
    """A Proof of what certify says."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "m.vdms")
        path.write_bytes(data)
        done = subprocess.run([os.environ["VERITOPE"], "certify", path, "--no-check", "--certificate", f"{path}.cert"],
                              capture_output=True, text=True, check=False, timeout=600)
        assert done.returncode == 1, done.stdout + done.stderr
        return fields.Proof(data, pathlib.Path(f"{path}.cert").read_bytes())


class Refuted(unittest.TestCase):
    def finding(self, name):
        """certify makes a certificate of it, which both checkers accept; what is changed in it is rejected by the condition of its kind, or as
        no such body."""
        proof = refuted(dms_defective.defective()[name])
        self.assertEqual(proof.statement["finding"], name)
        code, line = judges.both(proof.data, proof.certificate())
        self.assertEqual((code, judges.condition(line)), (0, "ACCEPT"), line)
        self.assertLess(len(proof.certificate()), 2000)
        for at, value in LIES[name]:
            self.rejected(proof, {at: value})
        return proof

    def rejected(self, proof, changes):
        """changes: the new values of fields, by their numbers."""
        lie = copy.deepcopy(proof)
        for at, value in changes.items():
            lie.body.fields[at][1] = value
        code, line = judges.both(lie.data, lie.certificate())
        self.assertEqual(code, 1, f"{changes}: {line}")
        self.assertIn(judges.condition(line), (f"W{proof.body.kind}", "B1"), line)

    # PROVES DMS-2.W0
    def test_tet_reversed(self):
        self.finding("tet-reversed")

    # PROVES DMS-2.W1
    def test_tet_face_overused(self):
        self.finding("tet-face-overused")

    # PROVES DMS-2.W2
    def test_cloud_degenerate(self):
        self.finding("cloud-degenerate")

    # PROVES DMS-2.W3
    def test_cloud_no_core(self):
        self.finding("cloud-no-core")

    # PROVES DMS-2.W4
    def test_cloud_inside(self):
        self.finding("cloud-inside")

    # PROVES DMS-2.W5
    def test_jacobian(self):
        self.finding("jacobian")

    # PROVES DMS-2.W6
    def test_jacobian_zero(self):
        self.finding("jacobian-zero")

    # PROVES DMS-2.W7
    def test_m4(self):
        self.finding("M4")

    # PROVES DMS-2.W8
    def test_m6(self):
        self.finding("M6")

    # PROVES DMS-2.W9
    def test_m7(self):
        self.finding("M7")

    # PROVES DMS-2.W10
    def test_m9(self):
        self.finding("M9")

    # PROVES DMS-2.W11
    def test_meeting(self):
        self.finding("meeting")

    # PROVES DMS-2.W12
    def test_crossing(self):
        self.finding("crossing")

    # PROVES DMS-2.W13
    def test_covering(self):
        """A point of one body has the image of one inside of the leaf, which is in the other one."""
        proof = self.finding("covering")
        values = [value for _, value in proof.body.fields]
        t, a, b, c, d, u = values[0], *(values[at:at + 3] for at in (1, 4, 7, 10, 14))
        middle = mixed(mixed(a, b, Q(1, 2)), mixed(c, d, Q(1, 2)), Q(1, 2))
        for other in range(12):
            if other != t:
                self.rejected(proof, {0: other})
        for place in (middle, a, mixed(a, b, Q(1, 2)), [*u[:2], u[2] + 9]):
            self.rejected(proof, dict(zip(range(14, 17), place)))
        small = [mixed(a, p, Q(1, 2**20)) for p in (a, b, c, d)]
        for corners in ([b, a, c, d], [a, b, c, mixed(a, b, Q(1, 3))], small):
            self.rejected(proof, dict(zip(range(1, 13), itertools.chain(*corners))))

    # PROVES DMS-2.V1
    def test_a_fold_of_a_model_with_another_defect(self):
        proof = self.finding("jacobian")
        file = json.loads(proof.data)
        corner = next(cloud for cloud in file["vertices"] if cloud[0] == ["0", "0", "0"])
        corner.append(["1/64", "1/64", "1/64"])
        proof.data = json.dumps(file).encode()
        code, line = judges.both(proof.data, proof.certificate())
        self.assertEqual((code, judges.condition(line)), (1, "E3"), line)


if __name__ == "__main__":
    unittest.main()
