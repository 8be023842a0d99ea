#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Has Coq check the proofs that Gappa finds for docs/bounds/gappa/*.g: `./dev soak proofs`.

For each script: Gappa prints its proof as a Coq term; coq_terms.py reads the term's statement and compares it with the script, and its constant
with the C++ header, exactly; coqc checks the term, and which axioms it stands on. Then one number of the statement is falsified (the constant
one unit in its last place smaller, a box's bound a fourth of it), and coqc must refuse the term.

usage: coq_proofs.py [--out FOLDER] [--jobs N] [NAME...]    NAME: a script without .g; without names all

One JSON line a figure. Exit: 0 all proofs are accepted and all falsified terms refused, 1 not so, 77 gappa, coqc or a library is missing.
Terms and what coqc said stay in FOLDER (default build/coq).
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time
from fractions import Fraction

import coq_terms
from gappa_test import PRECISION, ROOT, SCRIPTS, constants, gappa

MISSING = 77
LIBRARY = "directed_rounding"
# Axioms of Coq's real numbers. A term that stands on any other is refused.
AXIOMS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}
IMPORT = "Require Import Gappa.Gappa_library."
UNKNOWN = re.compile(r"\(UNKNOWN_(float_(?:relative|absolute_wide)_(?:up|dn|zr))\)")


def completed(term):
    """The term with the theorems on directed rounding, which Gappa's library lacks, in their places, and the question for its axioms."""
    term = term.replace(IMPORT, f"{IMPORT}\nRequire Import {LIBRARY}.", 1)
    return UNKNOWN.sub(r"(\1 _ _ _ _ _ h0 _)", term) + "Print Assumptions l1.\n"


def axioms_of(output):
    """The names that `Print Assumptions` lists; an empty set if it says that there are none."""
    if "Closed under the global context" in output:
        return set()
    _, found, rest = output.partition("Axioms:\n")
    return set(re.findall(r"(?m)^([\w.']+)", rest)) if found else {"what Print Assumptions did not say"}


def falsified(term, constant):
    """The term with a false number in its statement: kRel one unit smaller, or a fourth of the bound on a box."""
    whole = re.compile(r"(Notation _kRel := \(float2R \(Float2 \()(\d+)(\) \(-?\d+\)\)\)\.)")
    if whole.search(term):
        return whole.sub(lambda found: f"{found[1]}{int(found[2]) - 1}{found[3]}", term, count=1)
    for line in re.findall(rf"(?m)^Definition \w+ := {coq_terms.DYADIC.pattern}\.$", term):
        if int(line[0]) * Fraction(2) ** int(line[1]) == constant:
            return term.replace(f"Float2 ({line[0]}) ({line[1]})", f"Float2 ({line[0]}) ({int(line[1]) - 2})", 1)
    raise coq_terms.TermError("the term has no constant to falsify")


def expected_constants():
    """{name of a script: (the header's constant as hexadecimal text, None or the factor of a box)}"""
    found = {}
    for name, constant in constants().items():
        found[name] = constant, None
        size = re.search(r"at most kRel (\S+) from the exact value", (SCRIPTS / f"{name}_box.g").read_text())[1]
        found[f"{name}_box"] = constant, Fraction(size)
    return found


class Coq:
    """coqc in a folder."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copy(SCRIPTS / f"{LIBRARY}.v", folder)

    def check(self, name, text):
        """(accepted, output)"""
        path = self.folder / f"{name}.v"
        path.write_text(text)
        done = subprocess.run(["coqc", path.name], cwd=self.folder, capture_output=True, text=True, check=False)
        (self.folder / f"{name}.out").write_text(done.stdout + done.stderr)
        return done.returncode == 0, done.stdout + done.stderr


def examine(coq, name, constant, factor):
    """{what: bool or seconds} of one script, with sentences on stderr for what fails."""
    start, said = time.monotonic(), []
    script = (SCRIPTS / f"{name}.g").read_text()
    proved, term = gappa(script, *PRECISION, "-Bcoq")
    said += [] if proved else ["Gappa finds no proof"]
    wrong = coq_terms.faults(script, term, constant, factor)
    said += wrong
    accepted, output = coq.check(name, completed(term))
    said += [] if accepted else [f"coqc refuses the term: {output.strip()}"]
    extra = axioms_of(output) - AXIOMS if accepted else set()
    said += [f"the term stands on {axiom}" for axiom in sorted(extra)]
    seconds = time.monotonic() - start
    value = coq_terms.read_number(constant)
    lie = falsified(term, coq_terms.round_down(value * factor) if factor else value)
    refused = not coq.check(f"{name}_falsified", completed(lie))[0]
    said += [] if refused else ["coqc accepts the falsified term"]
    for sentence in said:
        print(f"{name}: {sentence}", file=sys.stderr)
    return {"name": name, "accepted": proved and accepted and not extra, "same": not wrong, "refused": refused, "seconds": seconds}


def print_figures(rows, seconds):
    count, slowest = len(rows), max(rows, key=lambda row: row["seconds"])
    used = resource.getrusage(resource.RUSAGE_CHILDREN)

    def figure(name, value, goal, **more):
        print(json.dumps({"name": name, "value": value, "goal": goal, **more}), flush=True)

    figure("proofs_accepted", sum(row["accepted"] for row in rows), f"{count} terms accepted by coqc, on the axioms of the real numbers only")
    figure("proofs_constants", sum(row["same"] for row in rows), f"{count} statements that are the script's, with the header's constant")
    figure("proofs_falsified", sum(row["refused"] for row in rows), f"{count} falsified terms refused by coqc")
    figure("proofs_seconds", round(seconds), "no goal", processor_seconds=round(used.ru_utime + used.ru_stime),
           slowest=slowest["name"], slowest_seconds=round(slowest["seconds"], 1))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build" / "coq")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    expected = expected_constants()
    scripts = sorted(path.stem for path in SCRIPTS.glob("*.g"))
    if set(scripts) != set(expected) or not set(options.names) <= set(scripts):
        print("scripts, constants and names do not match: gappa_test.py says more", file=sys.stderr)
        return 1
    if not shutil.which("gappa") or not shutil.which("coqc"):
        print("gappa or coqc is not installed (Debian: gappa, coq, libcoq-gappa): no proof was checked", file=sys.stderr)
        return MISSING
    coq = Coq(options.out)
    accepted, output = coq.check("library", f"{IMPORT}\n")
    if not accepted:
        print(f"Gappa's Coq library (Debian: libcoq-gappa) is not installed: no proof was checked\n{output}", file=sys.stderr)
        return MISSING
    accepted, output = coq.check(LIBRARY, (SCRIPTS / f"{LIBRARY}.v").read_text())
    if not accepted:
        print(f"{LIBRARY}.v: coqc refuses it: {output}", file=sys.stderr)
        return 1
    start = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda name: examine(coq, name, *expected[name]), options.names or scripts))
    print_figures(rows, time.monotonic() - start)
    return 0 if all(row["accepted"] and row["same"] and row["refused"] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
