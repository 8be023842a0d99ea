#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of patch-invalid certificates against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import patch_invalid_test as python_tests

judges.judge(python_tests.vc)
Crossings, Sides, Lies = python_tests.Crossings, python_tests.Sides, python_tests.Lies
SoundModels, Hostile = python_tests.SoundModels, python_tests.Hostile

if __name__ == "__main__":
    unittest.main()
