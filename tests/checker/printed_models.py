# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What print_model says that the C++ checker reads. VERITOPE_PRINT_MODEL names the program, VERITOPE_CHECK the checker."""
import os
import pathlib
import subprocess
import unittest
from fractions import Fraction as Q

import judges
from star_box_itd_test import hollow

PRINT = os.environ["VERITOPE_PRINT_MODEL"]


def printed(text, fmt):
    """(exit status, text). A run that takes more than 60 s is a failure."""
    path = pathlib.Path(judges.FOLDER.name) / "printed"
    path.write_bytes(text if isinstance(text, bytes) else text.encode("latin-1"))
    done = subprocess.run([PRINT, fmt, path], capture_output=True, text=True, timeout=60, check=False)
    return done.returncode, done.stdout + done.stderr


def fraction(word):
    n, d = word.split("/")
    return Q(int(n, 16), int(d, 16))


def entity_of(block):
    (_, kind, rational, components), *lines = [line.split(" ") for line in block.splitlines()]
    return {"kind": kind, "rational": rational == "1", "components": int(components),
            "degrees": [int(line[1]) for line in lines if line[0] == "axis"],
            "knots": [list(map(fraction, line[2:])) for line in lines if line[0] == "axis"],
            "points": [tuple(map(fraction, line[1:])) for line in lines if line[0] == "point"]}


def wanted(e):
    """An entity of the forge, in the same words."""
    shape = e["shape"]
    return {"kind": e["kind"], "rational": shape["rational"], "components": shape["components"], "degrees": shape["degrees"],
            "knots": [list(map(Q, axis)) for axis in shape["knots"]], "points": [tuple(map(Q, p)) for p in shape["points"]]}


class PrintedTest(unittest.TestCase):
    fmt = None

    def entities(self, text, fmt=None):
        status, out = printed(text, fmt or self.fmt)
        self.assertEqual(status, 0, out[:300])
        return [entity_of("entity" + block) for block in out.split("entity")[1:]]

    def reads(self, entities, text, fmt=None):
        found = self.entities(text, fmt)
        self.assertEqual(len(found), len(entities))
        for number, (one, other) in enumerate(zip(found, map(wanted, entities))):
            for key in other:
                self.assertEqual(one[key], other[key], (number, key))

    def refused(self, word, *texts, fmt=None):
        """With the word in the reason; the checker itself refuses too, with exit 4 and one line."""
        for text in texts:
            with self.subTest(text[-200:]):
                status, out = printed(text, fmt or self.fmt)
                self.assertEqual((status, out.count("\n")), (4, 1), out[:300])
                self.assertIn(word, out)
        model = texts[0] if isinstance(texts[0], bytes) else texts[0].encode("latin-1")
        self.assertEqual(judges.in_cpp(model, hollow(model, fmt or self.fmt))[:2], (4, ""))


if __name__ == "__main__":
    unittest.main()
