#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of classified points of spline models beside the Python one, whose tests it runs: both must give the same exit code and
name the same condition. VERITOPE_CHECK names the program."""
import unittest

import judges
import patch_points_test as python_tests

judges.judge(python_tests.vc)
Off, On, Algebraic = python_tests.Off, python_tests.On, python_tests.Algebraic
Bodies, Models = python_tests.Bodies, python_tests.Models
Work, Bound = python_tests.Work, python_tests.Bound


if __name__ == "__main__":
    unittest.main()
