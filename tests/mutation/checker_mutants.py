#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Would the attacks notice a broken checker?  Source-level mutants of both checkers.

Each mutant is one small textual change in a checking condition (a comparison, a sign, a constant, a
dropped condition).  It is killed if some case of a fixed corpus (attacks, honest certificates, damaged
files), or some test of tests/checker and tests/checker_py, gets another verdict than from the unchanged Python checker.
equivalent.diff lists mutants that no input can tell from the checker, each with the reason; they are run, too: one
that is killed, or that no line of the checker gives any more, ends the run with exit 1.

    python3 tests/mutation/checker_mutants.py python [--sample N] [--jobs J]
    python3 tests/mutation/checker_mutants.py cpp    [--sample N] [--jobs J] [--show]
    python3 tests/mutation/checker_mutants.py python_patches|cpp_patches [--sample N] [--jobs J] [--corpus-only]

The first two are about the claims about meshes, the last two about those about patches. --corpus-only: survivors of the corpus are not
tried with the unit tests.
"""
import argparse
import collections
import hashlib
import importlib
import io
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import attacks                                            # noqa: E402
import patch_attacks                                      # noqa: E402
import patch_differential                                 # noqa: E402
import patch_liars                                        # noqa: E402
import patch_solids                                       # noqa: E402
import patch_mutation_test                                # noqa: E402
import points_liars                                       # noqa: E402
import differential                                       # noqa: E402

CHECKER = attacks.CHECKER_PY.parent
# C++ headers without conditions of the page
NOT_CONDITIONS = ("checker.h", "numbers.h", "sha256.h", "claims.h", "mesh_claims.h", "patch_claims.h", "collar_claim.h")
# Together these attacks hit every pair of strategy and condition that 500 seeds hit.
SEEDS = (21, 36, 37, 43, 64, 69, 72, 73, 74, 75, 86, 87, 89, 90, 94, 101, 106, 114, 115, 123, 134, 141, 150, 183, 187,
         192, 197, 209, 215, 225, 232, 247, 250, 252, 253, 261, 277, 301, 320, 325, 345, 352, 356, 390, 431, 433, 452)
NO_CONDITIONS = ("__init__.py", "errors.py", "claims.py")  # of the Python checker, the same
MESH_TESTS = ("mesh_test", "mesh_reading_test", "mesh_reversed_test", "points_test")
PATCH_TESTS = ("star_box_test", "star_box_hostile_test", "star_box_itd_test", "model_g2_test", "model_mfem_test",
               "model_faces_test", "star_box_turned_test", "patch_invalid_test", "patch_invalid_2_test", "volume_folded_test", "collar_test")
CPU_LIMIT, LIMIT = 120, 900                               # seconds of this process, and of the clock, for one mutant

# (name, what to look for, replacements); applied to one occurrence at a time, outside of strings
OPERATORS = [
    ("comparison", r"(?<![<>=!-])<=(?!>)", ["<"]), ("comparison", r"(?<![<>=!-])>=", [">"]),
    ("comparison", r"(?<![<\w])<(?![<=])(?= )", ["<=", ">"]), ("comparison", r"(?<![>-])>(?![>=])(?= )", [">=", "<"]),
    ("comparison", r"==", ["!="]), ("comparison", r"!=", ["=="]),
    ("sign", r"(?<= )\+(?= )", ["-"]), ("sign", r"(?<= )-(?= )", ["+"]), ("sign", r"(?<=[(\[, ])-(?=[a-z])", [""]),
    ("off by one", r"(?<=[+-] )1\b", ["0", "2"]), ("constant", r"(?<![\w.\"'])\d+\b(?!\.)", ["N+1", "N-1"]),
    ("logic", r"\band\b", ["or"]), ("logic", r"\bor\b", ["and"]), ("logic", r"&&", ["||"]), ("logic", r"\|\|", ["&&"]),
    ("logic", r"\bnot (?!in\b)", [""]), ("logic", r"(?<=[ (])!(?=[a-z_(])", [""]),
    ("min max", r"\bmin\b", ["max"]), ("min max", r"\bmax\b", ["min"]),
    ("truth", r"\bTrue\b|\btrue\b", ["FALSE"]), ("truth", r"\bFalse\b|\bfalse\b", ["TRUE"]),
    ("index", r"\[0\]", ["[1]"]), ("index", r"\[1\]", ["[0]"]), ("bits", r"(?<= )&(?= )", ["|"]), ("bits", r"(?<= )\^(?= )", ["|"]),
    ("break", r"\bcontinue\b", ["break"]), ("break", r"\bbreak\b", ["continue"]),
]


def mutate_line(line, python):
    """(operator, new line) for each way to change one line."""
    code = re.sub(r"\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])*'", lambda m: "\0" * len(m.group()), line)
    code = re.sub(r"#.*" if python else r"//.*", lambda m: "\0" * len(m.group()), code)
    message = re.match(r"\s*(raise |return \0)", code)      # nothing but the text could change
    for name, pattern, replacements in () if message else OPERATORS:
        for m in re.finditer(pattern, code):
            for r in replacements:
                if r in ("N+1", "N-1"):
                    r = str(int(m.group()) + (1 if r == "N+1" else -1))
                if r in ("TRUE", "FALSE"):
                    r = r.capitalize() if python else r.lower()
                yield name, line[:m.start()] + r + line[m.end():]
    yield from drop(line, code, python)


def drop(line, code, python):
    """Drop a rejection or force a condition."""
    indent = line[:len(line) - len(line.lstrip())]
    if python:
        if re.match(r"\s*(raise|return \")", code.replace("\0", "\"")):
            yield "drop", indent + "pass"
        m = re.match(r"(\s*(?:if|elif|while) )(.*):\s*\0*$", code)
        if m:
            yield "force", m.group(1) + "not (" + line[m.start(2):m.end(2)] + "):"
            yield "force", m.group(1) + "False:"
    else:
        if re.match(r"\s*(fail|reject|throw|need|require)\b.*;\s*\0*$", code):
            yield "drop", indent + ";"
        m = re.match(r"(\s*if \()(.*)(\) .*;\s*\0*$|\) \{\s*\0*$)", code)
        if m and m.group(2).count("(") == m.group(2).count(")"):
            yield "force", m.group(1) + "!(" + line[m.start(2):m.end(2)] + ")" + line[m.start(3):]
            yield "force", m.group(1) + "false && (" + line[m.start(2):m.end(2)] + ")" + line[m.start(3):]


def mutants(path, first=None):
    """(file, line number, operator, mutated text) of one source file, from the line that holds `first`."""
    lines = path.read_text().split("\n")
    python, doc, started = path.suffix == ".py", False, first is None
    for i, line in enumerate(lines):
        started = started or first in line
        quotes = line.count('"""')
        if started and not doc and not quotes and not line.lstrip().startswith(("#", "//", "import ", "/*", "*", "from ")):
            seen = {line}
            for name, new in mutate_line(line, python):
                if new not in seen:
                    seen.add(new)
                    yield path, i + 1, name, new, "\n".join(lines[:i] + [new] + lines[i + 1:])
        doc = doc != (quotes % 2 == 1)


def equivalents():
    """{(file, line before, line, mutated line): reason} of equivalent.diff."""
    entries, text = {}, (HERE / "equivalent.diff").read_text()
    for block in text.split("\n@ ")[1:]:
        head, *rest = block.split("\n")
        name, _, reason = head.partition(": ")
        before, old = "", ""
        for row in rest:
            if row.startswith("+"):
                entries[name, before, old, row[1:].strip()] = reason
            elif row.startswith("-"):
                old = row[1:].strip()
            elif row.startswith(" "):
                before = row.strip()
    return entries


def key_of(mutant):
    path, number, _, new, _ = mutant
    lines = path.read_text().split("\n")
    return path.name, lines[number - 2].strip(), lines[number - 1].strip(), new.strip()


# ---------------------------------------------------------------- the corpus

def unit_cases():
    """The files that tests/checker_py gives the checker: model, certificate, and the answers that a certificate of points-1 is about."""
    sys.path.insert(0, str(HERE.parent / "checker_py"))
    seen, modules = [], [importlib.import_module(name) for name in MESH_TESTS]
    check = modules[0].vc.check

    def spy(*files):
        if None not in files:
            seen.append(files)
        return check(*files)
    for module in modules:
        module.vc.check = spy
        unittest.TextTestRunner(stream=io.StringIO()).run(unittest.defaultTestLoader.loadTestsFromModule(module))
    modules[0].vc.check = check
    return list(dict.fromkeys(seen))


def corpus():
    """(files, verdict of the unchanged Python checker) of all cases, small ones first."""
    py, cases = attacks.load_checker(), []
    for seed in SEEDS:
        cases += [(c.bytes, cert) for _, c, cert in attacks.attacks(random.Random(seed))]
    for seed in range(40):
        cases += [(c.bytes, cert) for _, c, cert in attacks.honest_certificates(random.Random(seed)) if cert]
    for seed in range(600):
        cases.append(differential.damaged_model(random.Random(seed))[1:])
    for seed in range(40):
        cases += [c[1:3] for c in differential.damaged_certificate(random.Random(seed))]
    for seed in range(60):
        for source in (points_liars.points_attacks, points_liars.honest):
            cases += [(c.bytes, cert, c.answers) for _, c, cert in source(random.Random(seed))]
    cases += unit_cases()
    cases = list(dict.fromkeys(cases))
    random.Random(1).shuffle(cases)
    return judged(py, cases)


def judged(py, cases):
    """The cases with their verdicts, small ones first."""
    cases.sort(key=lambda files: sum(map(len, files)) // 2000)
    return [(files, attacks.condition_of(*py.check(*files))) for files in cases]


def damaged(cert, rng):
    """Bytes of the body changed, with its hash mended."""
    head, body = cert.split(b"\n", 1)
    lie = bytearray(body)
    for _ in range(rng.randint(1, 2)):
        at = rng.randrange(len(lie))
        if rng.random() < .7:
            lie[at] = rng.choice((0, 1, 127, 128, 255, lie[at] ^ 1 << rng.randrange(8)))
        else:
            del lie[at:at + rng.randint(1, 3)]
    old, new = [hashlib.sha256(bytes(b)).hexdigest().encode() for b in (body, lie)]
    return head.replace(old, new) + b"\n" + bytes(lie)


def patch_corpus():
    """As corpus(), of the claims about patches."""
    py, rng, cases = attacks.load_checker(), random.Random(1), []
    for source, seeds in patch_mutation_test.SEEDS:
        for seed in seeds:
            cases += [(model, cert) for _, model, cert in source(random.Random(seed))]
    for seed in range(24):
        cases += [(c.bytes, cert) for _, c, cert in patch_attacks.Run.honest_certificates(random.Random(seed))]
    for build in (patch_solids.models.cubic_octahedron, patch_solids.models.bicubic_ball):
        proof = patch_solids.proved(build())
        model = patch_solids.forge.encode_model(proof.entities)
        plans = [proof.plan, *patch_liars.swapped_centres(patch_liars.Case(proof, None), rng)]
        cases += [(model, plan.certificate(model)) for plan in plans]
    cases = [c for c in dict.fromkeys(cases) if len(c[0]) + len(c[1]) < 40000]
    cases += [(model, damaged(cert, rng)) for model, cert in rng.sample(cases, len(cases) // 3)]
    cases += [patch_differential.model_case(random.Random(seed))[1:] for seed in range(400)]
    return judged(py, cases)


# ---------------------------------------------------------------- running

def tree_with(mutant):
    """A folder with the checker in Python and its tests, one file of it mutated."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="mutant", dir="/dev/shm" if os.path.isdir("/dev/shm") else None))
    shutil.copytree(HERE.parent / "checker_py", folder / "tests" / "checker_py")
    shutil.copytree(CHECKER, folder / "verify" / "checker", ignore=shutil.ignore_patterns("__pycache__", "*.cc", "*.h"))
    (folder / "verify" / "checker" / mutant[0].relative_to(CHECKER)).write_text(mutant[4])
    return folder


def judge_python(mutant, cases, options):
    """The number of the first case with another verdict, or None; in a process of its own, which loses the modules that it has loaded."""
    folder = tree_with(mutant)
    program = folder / "verify" / "checker" / "veritope_check.py"
    try:
        sys.path[:] = [p for p in sys.path if pathlib.Path(p).resolve() != CHECKER.resolve()]
        sys.dont_write_bytecode = True
        try:
            module = attacks.load_checker(program)
            for i, (files, expected) in enumerate(cases):
                if attacks.condition_of(*module.check(*files)) != expected:
                    return i
        except Exception:
            return 0
        if options.kind == "python_patches":
            return 0 if not options.corpus_only and patch_tests_fail(folder / "tests" / "checker_py", {}) else None
        return 0 if unit_tests_fail(program) else None
    finally:
        shutil.rmtree(folder)


def tests_fail(tests, names, env):
    return any(subprocess.run([sys.executable, str(tests / (name + ".py")), "--failfast"], env=dict(os.environ, **env),
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode for name in names if (tests / (name + ".py")).exists())


def patch_tests_fail(tests, env):
    return tests_fail(tests, PATCH_TESTS, env)


def mesh_tests_fail(tests, env):
    return tests_fail(tests, MESH_TESTS, env)


def unit_tests_of_patches_fail(program):
    return patch_tests_fail(HERE.parent / "checker", {"VERITOPE_CHECK": str(program)})


def unit_tests_fail(program):
    return mesh_tests_fail(HERE.parent / "checker_py", {"VERITOPE_CHECK_PY": str(program)})


def unit_tests_of_cpp_fail(program):
    return mesh_tests_fail(HERE.parent / "checker", {"VERITOPE_CHECK": str(program)})


def fails_unchanged(objects, options):
    with tempfile.TemporaryDirectory() as d:
        program = pathlib.Path(d) / "check"
        subprocess.run([options.compiler, *objects, "-o", str(program)], check=True)
        return options.unit_tests_fail(program)


def judge_cpp(mutant, objects, cases, options):
    """As judge_python, for a C++ file: compiles, links, runs; 'build' if it does not compile."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="mutant", dir="/dev/shm" if os.path.isdir("/dev/shm") else None))
    try:
        alone = folder / "checker"
        shutil.copytree(CHECKER, alone, ignore=shutil.ignore_patterns("__pycache__", "*.py"))
        (alone / mutant[0].relative_to(CHECKER)).write_text(mutant[4])
        sources = [mutant[0]] if mutant[0].suffix == ".cc" else [p for p in cpp_sources() if p.name in options.users[mutant[0].name]]
        compiler = [options.compiler, "-std=c++11", "-O1", "-w"]
        built = []
        for s in sources:
            built.append(str(folder / (s.name + ".o")))
            if subprocess.run(compiler + ["-c", str(alone / s.relative_to(CHECKER)), "-o", built[-1]], stderr=subprocess.DEVNULL).returncode:
                return "build"
        rest = [o for o in objects if pathlib.Path(o).name[:-2] not in {s.name for s in sources}]
        if subprocess.run(compiler + built + rest + ["-o", str(folder / "check")], stderr=subprocess.DEVNULL).returncode:
            return "build"
        paths, last = [folder / name for name in ("model", "cert", "answers")], None
        for i, (files, expected) in enumerate(cases):
            for path, data in zip(paths, files):
                if data is not last:
                    path.write_bytes(data)
            last = files[0]
            r = subprocess.run([str(folder / "check"), *map(str, paths[:len(files)])], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=20)
            found = attacks.condition_of(r.returncode, r.stdout.decode("latin-1")) if r.returncode in (0, 1) and r.stdout else "exit %d" % r.returncode
            if found != expected:
                return i
        return 0 if options.unit_tests_fail(folder / "check") else None
    except (subprocess.TimeoutExpired, ValueError, IndexError):
        return "time"
    finally:
        shutil.rmtree(folder)


def in_child(job):
    """Forks; the child exits 0 (killed), 1 (survived), 2 (does not build); a time-out is a kill, too."""
    pid = os.fork()
    if pid == 0:
        code = 3
        try:
            signal.setitimer(signal.ITIMER_PROF, CPU_LIMIT)
            signal.alarm(LIMIT)
            found = job()
            code = 1 if found is None else 2 if found == "build" else 0
        finally:
            os._exit(code)
    return pid


def run(kind, options):
    patches = kind.endswith("_patches")
    cases = patch_corpus() if patches else corpus()
    print("%d cases" % len(cases))
    options.unit_tests_fail = (lambda program: False) if options.corpus_only else unit_tests_of_patches_fail if patches else unit_tests_of_cpp_fail
    # Else every mutant would count as killed.
    if kind == "python" and unit_tests_fail(attacks.CHECKER_PY):
        sys.exit("checker_mutants: the unit tests fail on the checker itself")
    if kind.startswith("python"):
        folders = ("patches", "collar") if patches else ("mesh", "common", "veritope_checker")
        files = [f for f in sorted(CHECKER.rglob("*.py")) if f.parent.name in folders and f.name not in NO_CONDITIONS]
        found = [m for f in files for m in mutants(f, "import ")]
        def job(m):
            return judge_python(m, cases, options)
    else:
        files = [f for f in cpp_sources() + sorted(CHECKER.rglob("*.h")) if is_about(f, patches)]
        found = [m for f in files for m in mutants(f)]
        objects = build_objects(options, files)
        if fails_unchanged(objects, options):
            sys.exit("checker_mutants: the unit tests fail on the checker itself")
        if patches:
            cases = agreed(cases, objects, options)
        def job(m):
            return judge_cpp(m, objects, cases, options)
    known, keys = equivalents(), {key_of(m) for m in found}
    stale = [k for k in known if k[0] in {m[0].name for m in found} and k not in keys]
    if stale:
        sys.exit("checker_mutants: equivalent.diff lists what is no mutant: %s" % (stale[0],))
    if options.sample and options.sample < len(found):
        found = random.Random(options.seed).sample(found, options.sample)
    return execute(found, job, options.jobs)


def is_about(f, patches):
    """Does a C++ file hold conditions of the claims about patches, or of those about meshes?"""
    if f.suffix == ".cc":
        return f.parent.name in (("patches", "collar") if patches else ("mesh",))
    return f.name not in NOT_CONDITIONS and any(s.name in users_of(f.name) and is_about(s, patches) for s in cpp_sources())


def cpp_sources():
    return sorted(CHECKER.rglob("*.cc"))


def agreed(cases, objects, options):
    """The cases without those that only the C++ checker has a limit for."""
    with tempfile.TemporaryDirectory() as d:
        subprocess.run([options.compiler, *objects, "-o", os.path.join(d, "check")], check=True)
        native = attacks.Native(os.path.join(d, "check"))
        same = [c for c in cases if attacks.condition_of(*native.check(*c[0])) == c[1]]
        native.close()
    print("%d cases in which the checkers agree" % len(same))
    return same


def build_objects(options, files):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="objects"))
    options.users = {}
    for f in files:
        if f.suffix == ".h":
            options.users[f.name] = users_of(f.name)
    out = []
    for s in cpp_sources():
        o = folder / (s.name + ".o")
        subprocess.run([options.compiler, "-std=c++11", "-O1", "-c", str(s), "-o", str(o)], check=True)
        out.append(str(o))
    return out


def users_of(header):
    """The .cc files that include a header, directly or through others."""
    names, grown = {header}, True
    texts = {p.name: p.read_text() for p in CHECKER.rglob("*") if p.suffix in (".h", ".cc")}
    while grown:
        more = {n for n, t in texts.items() if any(re.search(r'#include "(\S*/)?%s"' % re.escape(h), t) for h in names)} - names
        names, grown = names | more, bool(more)
    return {n for n in names if n.endswith(".cc")}


def execute(found, job, jobs):
    running, results, queue = {}, [], list(found)
    while queue or running:
        while queue and len(running) < jobs:
            m = queue.pop(0)
            running[in_child(lambda: job(m))] = m
        pid, status = os.wait()
        if pid in running:
            code = os.waitstatus_to_exitcode(status)
            results.append((running.pop(pid), "survived" if code == 1 else "build" if code == 2 else "killed"))
            if len(results) % 50 == 0:
                print("%d of %d mutants" % (len(results), len(found)), file=sys.stderr, flush=True)
    return results


def main(argv):
    a = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    a.add_argument("kind", choices=("python", "cpp", "python_patches", "cpp_patches"))
    a.add_argument("--sample", type=int, default=0)
    a.add_argument("--seed", type=int, default=1)
    a.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    a.add_argument("--compiler", default="g++")
    a.add_argument("--corpus-only", action="store_true")
    a.add_argument("--show", action="store_true", help="print the text of surviving lines")
    options, start = a.parse_args(argv), time.monotonic()
    results = run(options.kind, options)
    known, wrong, count = equivalents(), 0, collections.Counter()
    for mutant, verdict in sorted(results, key=lambda r: (str(r[0][0]), r[0][1])):
        is_known = key_of(mutant) in known
        wrong += is_known and verdict == "killed"
        count["equivalent" if is_known and verdict == "survived" else verdict] += 1
        if is_known and verdict == "killed" or not is_known and verdict == "survived":
            print("%s %s:%d %s" % ("NOT EQUIVALENT" if is_known else "SURVIVED", mutant[0].name, mutant[1], mutant[2]))
            if options.show:
                print("@ %s: \n  %s\n- %s\n+ %s" % key_of(mutant))
    real = count["killed"] + count["survived"]
    for name, value, goal in (("mutants_" + options.kind, real, None), ("mutants_equivalent_" + options.kind, count["equivalent"], None),
                              ("mutants_killed_" + options.kind, count["killed"], real),
                              ("mutation_score_percent_" + options.kind, round(100 * count["killed"] / max(real, 1), 2), 95),
                              ("seconds", round(time.monotonic() - start, 1), None)):
        print(json.dumps({"name": name, "value": value, "goal": goal}))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
