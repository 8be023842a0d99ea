#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of collar certificates against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import collar_test as python_tests

judges.judge(python_tests.vc)
Collars, Lies, Knot, Hostile = python_tests.Collars, python_tests.Lies, python_tests.Knot, python_tests.Hostile

if __name__ == "__main__":
    unittest.main()
