#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The committed examples are what tools/make_examples.py writes, byte for byte."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent


class Examples(unittest.TestCase):
    def test_the_generator_writes_the_committed_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "tools" / "make_examples.py", folder], check=True)
            made = sorted(pathlib.Path(folder).iterdir())
            self.assertEqual([path.name for path in made], ["part_with_hole.stl", "quarter_pipe.itd", "self_crossing.off", "sound_part.stl"])
            for path in made:
                committed = (ROOT / "examples" / path.name).read_bytes()
                self.assertTrue(path.read_bytes() == committed, f"examples/{path.name} differs")


if __name__ == "__main__":
    unittest.main()
