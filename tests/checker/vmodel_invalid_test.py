#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of vmodel-invalid-1 against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import vmodel_invalid_test as python_tests

judges.judge(python_tests.vc)
Honest, Lies, Links, ValidModels = python_tests.Honest, python_tests.Lies, python_tests.Links, python_tests.ValidModels
Bodies, Limits, Hostile = python_tests.Bodies, python_tests.Limits, python_tests.Hostile
LiesThatTwoConditionsReject = python_tests.LiesThatTwoConditionsReject

if __name__ == "__main__":
    unittest.main()
