#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""No two files define a type of one name in one namespace. Where two .cc files see different types of the same name,
no compiler says so: the linker takes one of std::vector's functions for both, and memory is lost or freed twice. A
fuzzer found two such pairs when every test had passed. infra_install includes all installed headers together, and
takes minutes; this test takes seconds, and reads internal headers, .cc files and the checker, too."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("robust", "splines", "interval", "predicates", "topology", "solids", "models", "io", "verify", "render",
           "named_predicates", "hard_models", "report", "cli", "interop")

# A namespace with one declaration has no comment at its end.
DECLARES = re.compile(r"(?m)^namespace(?: [\w:]+)? \{[^{}]*\}$")
OPEN = re.compile(r"(?:inline )?namespace(?: ([\w:]+))? \{")
CLOSE = re.compile(r"\}  // namespace")
# clang-format puts what a namespace declares at the beginning of a line. Specializations have < after the name.
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|union|enum class|enum)(?: \[\[\w+\]\])?(?: alignas\(\w+\))? (\w+)"
                  r"(?: final)?(?: : [^;]*)? ?\{")


def definitions(text):
    """(name with its namespaces, line) of the types that a file defines. Those of unnamed namespaces are left out, and
    aliases, which make nothing that is linked."""
    scope = []
    text = DECLARES.sub(lambda match: "\n" * match[0].count("\n"), text)
    for number, line in enumerate(text.splitlines(), 1):
        if opened := OPEN.match(line):
            scope.append(opened[1])
        elif CLOSE.match(line):
            scope.pop()
        elif None not in scope and (found := TYPE.match(line)):
            yield "::".join([*scope, found[1]]), number
    if scope:
        raise ValueError(f"a namespace does not end with a comment: {scope}")


def defined_twice(files):
    """{name: places} of the names that several files define, for (path, text). A compiler sees those of one file."""
    places = {}
    for path, text in files:
        for name, number in definitions(text):
            places.setdefault(name, {}).setdefault(path, number)
    return {name: [f"{path}:{line}" for path, line in found.items()] for name, found in places.items() if len(found) > 1}


class OneDefinition(unittest.TestCase):
    def test_no_name_of_a_type_is_defined_twice(self):
        paths = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".h", ".cc")]
        self.assertGreater(len(paths), 600)
        files = [(str(path.relative_to(ROOT)), path.read_text()) for path in paths]
        self.assertGreater(sum(1 for _, text in files for _ in definitions(text)), 1500)
        self.assertEqual(defined_twice(files), {})

    def test_what_counts(self):
        def file(body, scope="namespace a {"):
            return "f.cc", f"{scope}\n{body}\n}}  // namespace\n"

        one = "g.h", "\nnamespace a {\nstruct X {\n  int y;\n};\n}  // namespace a\n"
        self.assertEqual(defined_twice([one, file("class X final : public Y {")]), {"a::X": ["g.h:3", "f.cc:2"]})
        declared = "f.cc", "namespace a {\nclass Y;\n}\nnamespace a {\nstruct X {\n};\n}  // namespace a\n"
        for other in (declared, file("enum class X : int { p, q };"), file("template <int N>\nstruct X : Y<N> {"),
                      file("template <int N> struct X {"), file("union X {")):
            with self.subTest(other=other):
                self.assertEqual(list(defined_twice([one, other])), ["a::X"])
        for other in (one, file("struct X {", "namespace {"), file("struct X {", "namespace a::b {"), file("struct X;"),
                      file("struct X<int> {"), file("// struct X {"), file("using X = int;"), file("struct XY {")):
            with self.subTest(other=other):
                self.assertEqual(defined_twice([one, other]), {})
        with self.assertRaises(ValueError):
            list(definitions("namespace a {\nstruct X {\n};\n}\n"))


if __name__ == "__main__":
    unittest.main()
