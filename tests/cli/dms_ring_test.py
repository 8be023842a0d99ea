#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A ring of 36 cubic tetrahedra with clouds outward: a small file whose tiles have long coefficients, so that the work allowed to its
certificate must grow with them."""
import json
import sys
import unittest

from support import BIN, ROOT, Folder, run

sys.path[:0] = [str(ROOT / "bench")]
import soak_dms_torus                                     # noqa: E402


class Ring(Folder):
    def test_the_certificate_is_accepted(self):
        path, count = soak_dms_torus.torus(BIN / "veritope", self.folder, 1, 1, 3, True)
        done = run("certify", path.name, "--json", "-", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done)
        found = json.loads(done.stdout)["files"][0]
        self.assertEqual((count, found["verdict"], [shell["genus"] for shell in found["shells"]]), (36, "VALID", [1]))
        self.assertGreater(found["counts"]["patches"], 3000)


if __name__ == "__main__":
    unittest.main()
