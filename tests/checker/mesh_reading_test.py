#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker's readers of meshes beside the Python checker's, whose tests it runs. VERITOPE_CHECK names the program."""
import struct
import unittest

import judges
import mesh_models as models
import mesh_reading_test as python_tests

judges.judge(python_tests.vc)


def refused(self, fmt, *texts, word=""):
    """Both refuse; the C++ checker says where, and has the word in its reason."""
    for text in map(python_tests.binary, texts):
        certificate = python_tests.any_certificate(text, fmt)
        self.assertEqual(judges.in_python(text, certificate, frozenset())[0], 4, text[:200])
        code, nothing, message = judges.in_cpp(text, certificate)
        self.assertEqual((code, nothing), (4, ""), (text[:200], message))
        self.assertRegex(message, "(byte|line) [0-9]+: .*" + word)


python_tests.Reading.refused = refused
Common, Stl, Obj, Off, Ply = python_tests.Common, python_tests.Stl, python_tests.Obj, python_tests.Off, python_tests.Ply


class Reasons(python_tests.Reading):
    def test_the_reason_of_a_refusal_is_printed(self):
        self.refused("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 77\n", word="found '77'")
        self.refused("stl", "solid x\nendsolid x\n", word="no triangle")
        data = models.stl_binary(models.TET)
        for n, word in ((5, "too early"), (2 ** 31, "too early"), (2 ** 32 - 1, "too early"), (0, "no triangle")):
            self.refused("stl", data[:80] + struct.pack("<I", n) + data[84:] * (n > 0), word=word)
        self.refused("stl", data[:96] + b"\0\0\x80\x7f" + data[100:], word="not finite")
        data = models.ply(models.TET, "binary_little_endian")
        at = data.index(b"end_header\n") + 11
        self.refused("ply", data[:at] + b"\xff" * 4 + data[at + 4:], word="not finite")
        self.refused("ply", data[:-4] + struct.pack("<i", 4), word="out of range")


if __name__ == "__main__":
    unittest.main()
