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

Random tests do not guard a claim's conditions as examples do. A claim that only random tests cite has a line "random ID: reason" in the
same file, and no other claim has one. A test is random if it, or a function of its file that it calls, draws numbers.
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
RANDOM = re.compile(r"\b[Rr]andom\b|\brc::")
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


def functions(path, code):
    """[(first line, last line, name, text)] of a file: its functions and tests, by the shape of well-formatted C++ and Python."""
    is_python = path.suffix == ".py"
    start = re.compile(r"^ *(?:async )?def (\w+)\(" if is_python else r"^(?:TEST\w*\(\w+, (\w+)\)|[A-Za-z].*?\b(\w+)\(.*)")
    found, lines = [], code.splitlines()
    for number, line in enumerate(lines, 1):
        match = start.match(line)
        if match:
            if found:
                found[-1][1] = min(found[-1][1], number - 1)
            found.append([number, len(lines), next(filter(None, match.groups())), []])
        if found and found[-1][1] == len(lines):
            found[-1][3].append(line)
            if not is_python and line.startswith("}"):
                found[-1][1] = number
    return [(first, last, name, "\n".join(text)) for first, last, name, text in found]


def random_tests(path, code):
    """[first line] of the functions of a file that draw numbers, or call one that does."""
    all_of_them = functions(path, code)
    names = {name for _, _, name, text in all_of_them if RANDOM.search(text)}
    while True:
        more = {name for _, _, name, text in all_of_them if names & set(re.findall(r"\b\w+(?=[(<])", text))} - names
        if not more:
            return [first for first, _, name, _ in all_of_them if name in names]
        names |= more


def only_random(root, cited):
    """The ids that only random tests cite. A citation speaks of the first function at or after it, or of the one that it stands in."""
    places_of, sure = {}, set()
    for name, places in cited.items():
        for place in places:
            path, _, number = place.rpartition(":")
            places_of.setdefault(path, []).append((int(number), name))
    for path, places in places_of.items():
        code = (root / path).read_text()
        all_of_them, drawn = functions(pathlib.Path(path), code), random_tests(pathlib.Path(path), code)
        for number, name in places:
            if next((first for first, last, _, _ in all_of_them if last >= number), None) not in drawn:
                sure.add(name)
    return set(cited) - sure


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
    cited, lines = citations(root), unproved(root)
    excused = {name: reason for name, reason in lines.items() if not name.startswith("random ")}
    said = {name.removeprefix("random ").strip(): reason for name, reason in lines.items() if name not in excused}
    drawn = only_random(root, cited)
    for name in sorted(drawn & set(ids)):
        if not said.get(name):
            faults.append(f"{cited[name][0]}: only random tests prove {name}, and docs/unproved-claims.txt does not say so")
    for name in sorted(set(said) - drawn):
        faults.append(f"docs/unproved-claims.txt: random {name}: no test cites it, or one that is not random does")
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
        drawn = sum(name.startswith("random ") for name in excused)
        print(f"{len(ids)} claims, {len(excused) - drawn} proved by no test, {drawn} by random ones only" + "".join(f"\n  {n}: {r}" for n, r in excused.items()))
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

    def test_a_claim_that_only_random_tests_prove_is_found(self):
        drawn = "// PROVES MESH-1, MESH-1.K1\nTEST(A, B) {\n  Random random(1);\n}\n"
        helper = "void draw() {\n  Random random(1);\n}\n\n// PROVES MESH-1, MESH-1.K1\nTEST(A, B) {\n  draw();\n}\n"
        for text in (drawn, helper):
            found = self.faults({"tests/a_test.cc": text})
            self.assertEqual(len(found), 2)
            self.assertIn("only random tests prove MESH-1", found[0])
        said = self.SOUND["docs/unproved-claims.txt"] + "random MESH-1: a\nrandom MESH-1.K1: b\n"
        self.assertEqual(self.faults({"tests/a_test.cc": helper, "docs/unproved-claims.txt": said}), [])
        self.assertIn("one that is not random does", self.faults({"docs/unproved-claims.txt": said})[0])
        plain = "// PROVES MESH-1, MESH-1.K1\nTEST(A, C) {\n}\n"
        self.assertEqual(self.faults({"tests/a_test.cc": drawn, "tests/b_test.cc": plain}), [])
        python = "class A:\n    def test_b(self):\n        # PROVES MESH-1, MESH-1.K1\n        self.x = random.random()\n"
        self.assertEqual(len(self.faults({"tests/a_test.cc": "", "tests/b_test.py": python})), 2)

    def test_a_malformed_or_repeated_id_is_found(self):
        theory = self.SOUND["docs/THEORY.md"]
        self.assertIn("there twice", self.faults({"docs/THEORY.md": theory + "{#MESH-1}"})[0])
        self.assertIn("is no claim id", self.faults({"docs/THEORY.md": theory + "{#mesh}"})[0])


if __name__ == "__main__":
    unittest.main()
