#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The tiers quick, standard and full lose no test: each ctest entry has one of the labels and a time limit; the cases
that tests/standard_cases.txt moves to standard exist; a Python file that is split by class is registered with all
of its classes.

usage: tiers_test.py CTEST BUILD_FOLDER
"""
import ast
import collections
import json
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = {"quick": 600, "standard": 1800, "full": 6000}
CTEST = BUILD = None


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def entries():
    return json.loads(output_of(CTEST, "--test-dir", BUILD, "--show-only=json-v1"))["tests"]


def property_of(entry, name):
    return next((p["value"] for p in entry["properties"] if p["name"] == name), None)


def cases_of(program):
    """{Suite.Case} of a GoogleTest program."""
    out, suite = set(), ""
    for line in output_of(program, "--gtest_list_tests").splitlines():
        name = line.split("#")[0].strip()
        if line.startswith(" "):
            out.add(suite + name)
        elif name.endswith("."):
            suite = name
    return out


def test_classes(script):
    """Names of the script's classes that hold tests."""
    classes = [node for node in ast.parse(script.read_text()).body if isinstance(node, ast.ClassDef)]
    return {node.name for node in classes
            if any(isinstance(f, ast.FunctionDef) and f.name.startswith("test") for f in node.body)}


class Tiers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.entries = entries()

    def test_each_entry_has_one_tier_and_its_time_limit(self):
        self.assertGreater(len(self.entries), 50)
        for entry in self.entries:
            with self.subTest(entry=entry["name"]):
                tiers = [label for label in property_of(entry, "LABELS") or [] if label in LIMITS]
                self.assertEqual(len(tiers), 1, tiers)
                self.assertGreaterEqual(property_of(entry, "TIMEOUT"), LIMITS[tiers[0]])

    def test_the_standard_cases_exist_and_run_as_standard(self):
        lines = (ROOT / "tests" / "standard_cases.txt").read_text().splitlines()
        rows = [line.split() for line in lines if line and line[0] != "#"]
        wanted = collections.defaultdict(set)
        for binary, case in rows:
            wanted[binary].add(case)
        for binary, cases in wanted.items():
            runs = [entry for entry in self.entries if pathlib.Path(entry["command"][0]).name == binary]
            self.assertEqual(cases - cases_of(runs[0]["command"][0]), set(), binary)
            filters = {label: {entry["command"][1] for entry in runs if label in property_of(entry, "LABELS")}
                       for label in LIMITS}
            (quick,), (standard,) = filters["quick"], filters["standard"]
            self.assertEqual(set(quick.removeprefix("--gtest_filter=-").split(":")), cases)
            self.assertEqual(set(standard.removeprefix("--gtest_filter=").split(":")), cases)

    def test_all_shards_of_a_program_run(self):
        shards = collections.defaultdict(list)
        for entry in self.entries:
            values = dict(value.split("=", 1) for value in property_of(entry, "ENVIRONMENT") or [])
            if "GTEST_TOTAL_SHARDS" in values:
                shards[(*entry["command"], int(values["GTEST_TOTAL_SHARDS"]))].append(int(values["GTEST_SHARD_INDEX"]))
        self.assertTrue(shards)
        for (*command, total), indices in shards.items():
            self.assertEqual(sorted(indices), list(range(total)), command)

    def test_scripts_that_are_split_by_class_are_registered_whole(self):
        runs = collections.defaultdict(list)
        for entry in self.entries:
            scripts = [part for part in entry.get("command", []) if part.endswith("_test.py")]
            if scripts:
                runs[scripts[0]].append(entry["command"][entry["command"].index(scripts[0]) + 1:])
        split = 0
        for script, arguments in runs.items():
            classes = test_classes(pathlib.Path(script))
            named = [set(words) & classes for words in arguments]
            if all(named):
                split += 1
                self.assertEqual(set().union(*named), classes, script)
        self.assertGreaterEqual(split, 1)


if __name__ == "__main__":
    CTEST, BUILD = sys.argv[1:3]
    del sys.argv[1:3]
    unittest.main()
