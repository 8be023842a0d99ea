#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of classified points beside the Python one, whose tests it runs: both must give the same exit code and name the same
condition. VERITOPE_CHECK names the program."""
import unittest

import judges
import points_test as python_tests

judges.judge(python_tests.vc)
Accepted, Conditions, Bodies = python_tests.Accepted, python_tests.Conditions, python_tests.Bodies
Coordinates, Lines = python_tests.Coordinates, python_tests.Lines


class Program(python_tests.Program):
    PROGRAM = [judges.CHECK]


if __name__ == "__main__":
    unittest.main()
