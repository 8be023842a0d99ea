#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Makes predicates from formula files: docs/how-to/generate-a-predicate.md.

Without arguments: makes the committed predicates again (predicates/generated/*.formula, docs/bounds/gappa/*.formula).
With formula files: writes NAME.h, NAME.cc, NAME.md and NAME.g to the folder --output.
"""
import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tools"))

from predicate_generator.bounds import Bound, BoundError  # noqa: E402
from predicate_generator.cpp import Names  # noqa: E402
from predicate_generator.expression import TooLarge  # noqa: E402
from predicate_generator.formula import FormulaError, read_formula  # noqa: E402
from predicate_generator.gappa import write_by_hand_scripts, write_scripts  # noqa: E402
from predicate_generator.header import write_header  # noqa: E402
from predicate_generator.page import write_page  # noqa: E402
from predicate_generator.source import write_source  # noqa: E402
from predicate_generator.tests import write_same_formulas_test, write_test  # noqa: E402


class Place:
    """What the comments and #includes of the generated files call each other; test is "" where none is written."""

    def __init__(self, name, committed, formula):
        folder = "predicates/generated/" if committed else ""
        self.formula = folder + f"{name}.formula" if committed else formula
        self.header = self.include = f"{folder}{name}.h"
        self.page = f"docs/bounds/{name}.md" if committed else f"{name}.md"
        self.script = f"gappa/{name}.g" if committed else f"{name}.g"
        self.test = f"tests/predicates/generated/{name}_test.cc" if committed else ""


def script_paths(committed, name):
    return [f"{'docs/bounds/gappa/' * committed}{name}{kind}.g" for kind in ("", "_box")]


def generate(path, shown, committed):
    """{path: text} of one formula file."""
    formula = read_formula(path.read_text(encoding="utf-8"), shown)
    if formula.name != path.stem:
        raise FormulaError(shown, 1, 1, f"the file of {formula.name} is called {path.name}")
    names, bound, place = Names(formula), Bound(formula), Place(formula.name, committed, path.name)
    files = {place.header: write_header(formula, names, bound, place),
             place.header[:-1] + "cc": write_source(formula, names, place),
             place.page: write_page(formula, names, bound, place)}
    files.update(zip(script_paths(committed, formula.name), write_scripts(formula, names, bound, place.formula)))
    if committed:
        files[place.test] = write_test(formula, names, bound, place)
    return files


def committed_files():
    files = {}
    for path in sorted((ROOT / "predicates" / "generated").glob("*.formula")):
        files.update(generate(path, str(path.relative_to(ROOT)), True))
    by_hand = []
    for path in sorted((ROOT / "docs" / "bounds" / "gappa").glob("*.formula")):
        shown = str(path.relative_to(ROOT))
        formula = read_formula(path.read_text(encoding="utf-8"), shown)
        by_hand.append(formula)
        files.update(zip(script_paths(True, formula.name), write_by_hand_scripts(formula, Names(formula), shown, ROOT)))
    files["tests/predicates/generated/same_formulas_test.cc"] = write_same_formulas_test(by_hand)
    return files


def main():
    parser = argparse.ArgumentParser(description="Makes predicates from formula files "
                                                 "(docs/how-to/generate-a-predicate.md).")
    parser.add_argument("formulas", nargs="*", type=pathlib.Path, metavar="FILE.formula")
    parser.add_argument("--output", type=pathlib.Path, help="folder for the files of FILE.formula; it must exist")
    options = parser.parse_args()
    if bool(options.formulas) != bool(options.output):
        parser.error("FILE.formula and --output go together")
    folder = options.output or ROOT
    try:
        if options.formulas:
            files = {}
            for path in options.formulas:
                files.update(generate(path, str(path), False))
        else:
            files = committed_files()
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8")
    except (FormulaError, BoundError, TooLarge, OSError, UnicodeDecodeError) as error:
        print(f"generate_predicates: {error}", file=sys.stderr)
        return 1
    except RecursionError:
        print("generate_predicates: the formula is nested too deeply, or a sum has too many terms: name parts of it",
              file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
