#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of star-box certificates of version 2 against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import star_box_2_test as python_tests

judges.judge(python_tests.vc)
SoundModels, Lies, FlatPatches = python_tests.SoundModels, python_tests.Lies, python_tests.FlatPatches

if __name__ == "__main__":
    unittest.main()
