#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""veritope_check.py MODEL CERT: starts the checker, which is the folder veritope_checker beside this file."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
try:
    from veritope_checker.program import main
except ImportError as missing:
    print("ERROR: the folder veritope_checker is not beside veritope_check.py: %s" % missing, file=sys.stderr)
    sys.exit(4)

if __name__ == "__main__":
    sys.exit(main(sys.argv))
