#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of collar certificates of version 2 against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import collar_2_test as python_tests

judges.judge(python_tests.one.vc)
CollarsOfVersion2, ThinPlate = python_tests.CollarsOfVersion2, python_tests.ThinPlate

if __name__ == "__main__":
    unittest.main()
