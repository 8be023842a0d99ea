#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker's reading of models (mfem) beside the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import model_mfem_test as python_tests

judges.judge(python_tests.vc)
globals().update({name: case for name, case in vars(python_tests).items() if isinstance(case, type) and issubclass(case, unittest.TestCase)})

if __name__ == "__main__":
    unittest.main()
