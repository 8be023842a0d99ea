#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every code and reason that a JSON report can hold has a page that `veritope explain` prints.

The codes come from where they arise: the names of Code in robust/base/result.cc, the string literals that sources pass as
the code of a fault or of a finding, open_reason_name, and the closed lists of the schemas.
"""
import json
import pathlib
import re
import tempfile
import unittest

import support

SOURCE_FOLDERS = ("cli", "report", "verify/certify", "solids")
WORD = r'"([a-z]+(?:-[a-z]+)*)"'
REPORTED = [re.compile(pattern) for pattern in (
    r"\bFault\s*\{\s*" + WORD,                                  # Fault{"code", place, message}
    r"\b(?:give_up|refuse|fail)\s*\([^;\"]*\{\s*" + WORD,       # give_up(status, {"code", place, message})
    r"\bundecided\s*\(\s*" + WORD,                              # undecided("code", message)
    r"\bcode\s*=\s*" + WORD,                                    # finding.code = "code"
)]
CASE_NAME = re.compile(r"case (?:Code|OpenReason)::k\w+:\s*return " + WORD)


def code_bodies(text):
    """C++ without its comments."""
    return re.sub(r"//.*", "", text)


def codes_of_sources(root):
    codes = set()
    for folder in SOURCE_FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cc"):
                text = code_bodies(path.read_text())
                codes.update(code for pattern in REPORTED for code in pattern.findall(text))
    for path in (root / "robust/base/result.cc", root / "interval/intersect/point_projection.cc"):
        codes.update(CASE_NAME.findall(path.read_text()))
    return codes


def closed_lists(schema, keys):
    """The words of every enum that stands under one of the keys."""
    found = set()
    if isinstance(schema, dict):
        for key, value in schema.items():
            if key in keys and isinstance(value, dict):
                found.update(word for word in value.get("enum", []) if isinstance(word, str))
            found |= closed_lists(value, keys)
    elif isinstance(schema, list):
        for value in schema:
            found |= closed_lists(value, keys)
    return found


def codes_of_schemas(root):
    codes = set()
    for path in sorted((root / "docs").glob("*.schema.json")):
        codes |= closed_lists(json.loads(path.read_text()), {"code", "rule", "reason"})
    return codes


def sections(page):
    return dict(re.findall(r"(?ms)^## (\S+)\n(.*?)(?=^## |\Z)", page))


def words(text):
    return " ".join(text.split())


class ReasonCodes(unittest.TestCase):
    def setUp(self):
        rules = support.ROOT / "docs" / "rules"
        self.reasons = sections((rules / "reasons.md").read_text())
        self.pages = set(self.reasons) | set(sections((rules / "patches.md").read_text())) | {f"M{i}" for i in range(1, 10)}

    def test_every_code_that_is_reported_has_a_page_and_is_explained(self):
        reported = codes_of_sources(support.ROOT) | codes_of_schemas(support.ROOT) | {"undecided", "unreadable"}
        for known in ("not-covered", "file-changed", "side-open", "bad-environment", "zero-equation", "M7"):
            self.assertIn(known, reported)  # the search works
        self.assertEqual(reported - self.pages, set(), "codes without a section in docs/rules")
        for code in sorted(reported):
            explained = support.run("explain", code)
            self.assertEqual((explained.returncode, explained.stderr), (0, ""), code)
            self.assertTrue(explained.stdout.startswith(f"{code}  "), code)

    def test_every_page_is_about_a_code_that_is_reported(self):
        reported = codes_of_sources(support.ROOT) | codes_of_schemas(support.ROOT) | {"undecided", "unreadable"}
        self.assertEqual(set(self.reasons) - reported, set())

    def test_the_page_says_what_the_program_prints(self):
        listed = support.run("explain").stdout
        for code, section in self.reasons.items():
            printed = support.run("explain", code).stdout
            head, rest = printed.split("\n", 1)
            meaning, causes, remedy = re.split(r"(?m)^(?:Where it comes from|What helps)\n", rest)
            name = head.split("  ", 1)[1]
            expected = f"{name[0].upper()}{name[1:]}. {meaning} - Where it comes from: {causes} - What helps: {remedy}"
            self.assertEqual(words(section), words(expected), code)
            self.assertIn(head, listed)
            self.assertLessEqual(len(printed.splitlines()), 25)
            self.assertLessEqual(max(map(len, printed.splitlines())), 80)

    def test_verdicts_may_be_written_in_capitals_and_an_unknown_code_is_refused(self):
        for verdict in ("UNDECIDED", "UNREADABLE"):
            self.assertEqual(support.run("explain", verdict).stdout, support.run("explain", verdict.lower()).stdout)
        refused = support.run("explain", "not-a-code")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("not-a-code", refused.stderr)


class PlantedCodes(unittest.TestCase):
    """A new code is found however it is reported."""

    def codes(self, source):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in (("cli/new.cc", source), ("robust/base/result.cc", ""), ("interval/intersect/point_projection.cc", "")):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return codes_of_sources(root)

    def test_a_new_code_is_found(self):
        for source in ('f = Fault{"new-code", {}, "words"};', 'return give_up(kExitUndecided,\n    {"new-code", {}, why});',
                       'return refuse({"new-code", {}, "x"});', 'return undecided(\n  "new-code", "x");', 'out.code = "new-code";'):
            self.assertEqual(self.codes(source), {"new-code"}, source)

    def test_comments_and_other_words_are_not_codes(self):
        self.assertEqual(self.codes('// Fault{"old-code"}\nprint("some words"); f(undecided(a, "words"));'), set())

    def test_an_enum_of_a_schema_is_found_where_it_is_a_code(self):
        schema = {"$defs": {"x": {"properties": {"code": {"enum": ["new-code", None]}, "kind": {"enum": ["other"]}}}}}
        self.assertEqual(closed_lists(schema, {"code"}), {"new-code"})


if __name__ == "__main__":
    unittest.main()
