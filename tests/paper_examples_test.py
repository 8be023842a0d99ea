#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""paper_examples_test.py PROGRAM EXPECTED [ARGUMENT...]: the program's output, with the arguments, is the committed text."""
import difflib
import pathlib
import subprocess
import sys

made = subprocess.run([sys.argv[1], *sys.argv[3:]], check=True, capture_output=True, text=True).stdout
expected = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
sys.stdout.writelines(difflib.unified_diff(expected.splitlines(True), made.splitlines(True), "expected", "made"))
sys.exit(made != expected)
