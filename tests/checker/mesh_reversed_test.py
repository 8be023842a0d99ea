#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of meshes with reversed triangles beside the Python one, whose tests it runs: both must give the same exit code and name
the same condition. VERITOPE_CHECK names the program."""
import unittest

import judges
import mesh_reversed_test as python_tests

judges.judge(python_tests.vc)
globals().update({name: case for name, case in vars(python_tests).items() if isinstance(case, type) and name != "ReversedTest"})

if __name__ == "__main__":
    unittest.main()
