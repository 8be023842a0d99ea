#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of points of expressions beside the Python one, whose tests it runs: both must give the same exit code and name the same
condition. VERITOPE_CHECK names the program."""
import unittest

import judges
import expression_points_test as python_tests

judges.judge(python_tests.vc)
Words, Codes, Lines = python_tests.Words, python_tests.Codes, python_tests.Lines
Files, Work = python_tests.Files, python_tests.Work

if __name__ == "__main__":
    unittest.main()
