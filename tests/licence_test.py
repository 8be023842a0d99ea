#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every source file says its licence in its first three lines, the one that LICENSE.md gives its folder, and LICENSES/ has its text."""
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from tree import ROOT, files  # noqa: E402

LIBRARY = "LGPL-3.0-or-later"
FORMAT_AND_CHECKERS = "Apache-2.0 OR MIT"
SPDX = re.compile(r"SPDX-License-Identifier: (.+)")


def allowed_licences(path):
    """Tests of the format may be as permissive as it is."""
    if str(path).startswith(("verify/format/", "verify/checker/")):
        return [FORMAT_AND_CHECKERS]
    return [LIBRARY, FORMAT_AND_CHECKERS] if path.parts[0] == "tests" else [LIBRARY]


def stated_licence(text):
    """The licence named in the first three lines, or None."""
    match = SPDX.search("\n".join(text.splitlines()[:3]))
    return match[1].rstrip("*/ ") if match else None


class Licences(unittest.TestCase):
    def test_every_source_file_states_the_licence_of_its_folder(self):
        wrong = []
        for path in files(ROOT, {".h", ".cc", ".inc", ".py"}):
            stated = stated_licence((ROOT / path).read_text())
            if stated not in allowed_licences(path):
                wrong.append(f"{path}: states {stated}, expected {' or '.join(allowed_licences(path))}")
        self.assertFalse(wrong, "\n" + "\n".join(wrong))

    def test_the_text_of_every_licence_is_there(self):
        for name in ("LGPL-3.0-or-later", "GPL-3.0-or-later", "Apache-2.0", "MIT"):
            self.assertTrue((ROOT / "LICENSES" / f"{name}.txt").is_file(), name)

    def test_a_missing_or_late_line_is_no_statement(self):
        self.assertIsNone(stated_licence("int a;\n"))
        self.assertIsNone(stated_licence("\n\n\n// SPDX-License-Identifier: MIT\n"))
        self.assertEqual(stated_licence("// SPDX-License-Identifier: Apache-2.0 OR MIT\n"), FORMAT_AND_CHECKERS)
        self.assertEqual(stated_licence("/* SPDX-License-Identifier: MIT */\n"), "MIT")


if __name__ == "__main__":
    unittest.main()
