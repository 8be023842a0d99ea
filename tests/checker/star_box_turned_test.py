#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of star-box-turned certificates against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import star_box_turned_test as python_tests

judges.judge(python_tests.vc)
Turned = python_tests.Turned

if __name__ == "__main__":
    unittest.main()
