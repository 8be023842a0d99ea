#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Every claim of docs/THEORY.md is proved by a test, or stands in docs/unproved-claims.txt with the reason.

A claim is whatever carries an id {#ID} in docs/THEORY.md, usually a heading or the start of a list item:

    ### MESH-3 Fan lemma {#MESH-3}
    - {#MESH-3.K1} every edge has exactly two faces.

ID = capital letters and digits, "-", a number, then any dotted parts: MESH-3, MESH-3.K1, THEORY-2.K3. Ids are never reused.
A test (tests/, in C++ or Python) that fails when the claim is false says so in a comment, one or several ids:

    // PROVES MESH-3, MESH-3.K1
    # PROVES MESH-4

docs/unproved-claims.txt: lines "ID: reason", # starts a comment. This program lists the claims that no test proves; it fails if
one of them has no line there, if a line there is about a proved or unknown claim, or if a test cites an unknown id.
"""
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "infra"))
from comments import split  # noqa: E402
from tree import ROOT, files  # noqa: E402

ID = r"[A-Z][A-Z0-9]*-\d+(?:\.\w+)*"
CLAIM = re.compile(r"\{#([\w.-]+)\}")
PROVES = re.compile(r"\bPROVES\s+((?:[\w.-]+)(?:\s*,\s*[\w.-]+)*)")


def claims(root):
    """([ids in order], [faults]) of docs/THEORY.md."""
    theory = root / "docs" / "THEORY.md"
    ids, faults = [], []
    for claim in CLAIM.findall(theory.read_text() if theory.is_file() else ""):
        if not re.fullmatch(ID, claim):
            faults.append(f"docs/THEORY.md: {{#{claim}}} is no claim id (MESH-3, MESH-3.K1)")
        elif claim in ids:
            faults.append(f"docs/THEORY.md: {{#{claim}}} is there twice")
        ids.append(claim)
    return ids, faults


def citations(root):
    """{id: [file:line]} of the tests."""
    cited = {}
    for path in files(root, {".cc", ".h", ".py"}):
        if path.parts[0] != "tests" or path.name == pathlib.Path(__file__).name:
            continue
        for line, comment in split(path, (root / path).read_text())[1]:
            for match in PROVES.finditer(comment):
                for name in re.split(r"\s*,\s*", match[1].rstrip(".")):
                    cited.setdefault(name.rstrip("."), []).append(f"{path}:{line + comment.count(chr(10), 0, match.start())}")
    return cited


def unproved(root):
    """{id: reason} of docs/unproved-claims.txt."""
    path = root / "docs" / "unproved-claims.txt"
    lines = [line for line in (path.read_text() if path.is_file() else "").splitlines() if line and not line.startswith("#")]
    return {name.strip(): reason.strip() for name, _, reason in (line.partition(":") for line in lines)}


def find_faults(root):
    ids, faults = claims(root)
    cited, excused = citations(root), unproved(root)
    for name, places in cited.items():
        if name not in ids:
            faults.append(f"{places[0]}: PROVES {name}: docs/THEORY.md has no such claim")
    for name in ids:
        if name not in cited and not excused.get(name):
            faults.append(f"docs/THEORY.md: no test proves {name}, and docs/unproved-claims.txt gives no reason")
    for name in excused:
        if name not in ids:
            faults.append(f"docs/unproved-claims.txt: docs/THEORY.md has no claim {name}")
        elif name in cited:
            faults.append(f"docs/unproved-claims.txt: {name} is proved in {cited[name][0]}")
    return faults


class ClaimsOfTheTree(unittest.TestCase):
    def test_every_claim_is_proved_by_a_test_or_listed_with_a_reason(self):
        ids, _ = claims(ROOT)
        excused = unproved(ROOT)
        print(f"{len(ids)} claims, {len(excused)} proved by no test" + "".join(f"\n  {n}: {r}" for n, r in excused.items()))
        faults = find_faults(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))


class PlantedFaults(unittest.TestCase):
    SOUND = {
        "docs/THEORY.md": "## MESH-1 One {#MESH-1}\n- {#MESH-1.K1} k\n## MESH-2 Two {#MESH-2}\n",
        "docs/unproved-claims.txt": "# why\nMESH-2: a definition\n",
        "tests/a_test.cc": "// PROVES MESH-1, MESH-1.K1.\nTEST(A, B) {}\n",
    }

    def faults(self, changes):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for path, text in {**self.SOUND, **changes}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            return find_faults(root)

    def test_the_sound_tree_has_none(self):
        self.assertEqual(self.faults({}), [])

    def test_an_unproved_claim_is_found(self):
        self.assertIn("no test proves MESH-1.K1", self.faults({"tests/a_test.cc": "// PROVES MESH-1\n"})[0])
        self.assertIn("no test proves MESH-2", self.faults({"docs/unproved-claims.txt": "MESH-2:\n"})[0])

    def test_an_unknown_id_is_found(self):
        self.assertIn("no such claim", self.faults({"tests/b_test.py": "# PROVES MESH-7\n"})[0])
        self.assertIn("no claim MESH-7", self.faults({"docs/unproved-claims.txt": "MESH-2: a\nMESH-7: b\n"})[0])

    def test_an_excuse_for_a_proved_claim_is_found(self):
        self.assertIn("is proved in", self.faults({"tests/b_test.py": "# PROVES MESH-2\n"})[0])

    def test_a_malformed_or_repeated_id_is_found(self):
        theory = self.SOUND["docs/THEORY.md"]
        self.assertIn("there twice", self.faults({"docs/THEORY.md": theory + "{#MESH-1}"})[0])
        self.assertIn("is no claim id", self.faults({"docs/THEORY.md": theory + "{#mesh}"})[0])


if __name__ == "__main__":
    unittest.main()
