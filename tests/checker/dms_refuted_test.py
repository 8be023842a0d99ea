#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of `veritope certify` about simplex-spline solids with a defect: both checkers accept them, each finding occurs, and what is
changed in them is rejected. VERITOPE names the program."""
import copy
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
    "crossing": [(0, 1), (2, Q(9)), (24, 63)],
}


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
    # PROVES DMS-2
    def test_each_finding_is_made_and_accepted_and_lies_are_not(self):
        models = dms_defective.defective()
        self.assertEqual(sorted(models), sorted(fields.KINDS))
        for finding, data in models.items():
            with self.subTest(finding):
                proof = refuted(data)
                self.assertEqual(proof.statement["finding"], finding)
                code, line = judges.both(proof.data, proof.certificate())
                self.assertEqual((code, judges.condition(line)), (0, "ACCEPT"), line)
                self.assertLess(len(proof.certificate()), 2000)
                for at, value in LIES[finding]:
                    lie = copy.deepcopy(proof)
                    lie.body.fields[at][1] = value
                    code, line = judges.both(lie.data, lie.certificate())
                    self.assertEqual(code, 1, f"{at}: {line}")


if __name__ == "__main__":
    unittest.main()
