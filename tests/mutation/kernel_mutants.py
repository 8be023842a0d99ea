#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Would the quick tests notice a broken kernel?  Source-level mutants of a layer's decisions.

    python3 tests/mutation/kernel_mutants.py LAYER [--build build-mutants] [--only FILES] [--sample N] [--jobs J] [--fast] [--again FILE] [--list]

Every mutant is one small change: a constant halved, doubled or zeroed, a comparison turned round or moved by its boundary, a condition
of an `if` held to be true or false. All of them are compiled at once: in ONE copy of the layer each place asks for the number of the mutant
that is switched on (the variable VT_MUTANT of the environment), so a mutant costs no compiler. Every test is run once alone without a mutant and
notes which places it reaches and what it costs; a mutant is then shown to the tests that reach its place, cheapest first, until one fails.

A mutant is killed if a test fails, crashes or runs for far too long. kernel_equivalent.txt lists mutants that are no mistakes, each with
the reason; they are run, too: one that is killed, or that no line of the layer gives any more, ends the run with exit 1. Its rules for
places that only propose (what is searched first, and for how long) excuse survivors; what the tests notice there counts as killed.
Prints JSON lines for ./dev soak; survivors as text in between. It configures --build, without batches of
files, unless that is done, and builds the layer's test binary there.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EQUIVALENT = pathlib.Path(__file__).resolve().parent / "kernel_equivalent.txt"

# files: what is mutated. tests: sources that are compiled against it (after the sources themselves); binary: whose libraries are linked.
LAYERS = {
    "pieces": {
        "files": ["solids/pieces/*.cc", "solids/pieces/*.h"],
        "tests": ["tests/solids/piece_net_bound_test.cc", "tests/solids/piece_decisions_test.cc", "tests/solids/exact_piece_test.cc",
                  "tests/solids/surface_form_test.cc", "tests/solids/piece_forest_test.cc", "tests/solids/piece_forest_frame_test.cc",
                  "tests/solids/piece_forest_memory_test.cc", "tests/solids/find_pieces_test.cc", "tests/solids/patch_volume_test.cc",
                  "tests/solids/box_hierarchy_test.cc", "tests/solids/star_zeros_test.cc",
                  "tests/support/piece_bound_subjects.cc"],
        "binary": "solids_quick",
        "filter": "*",
    },
    # The conditions D1 to D4, the search for what satisfies them, and on what they stand: dyadic intervals, equality of sides.
    "side_witness": {
        "files": ["verify/certify/side_witness.cc", "verify/certify/side_search.cc", "solids/patches/patch_sides.cc",
                  "solids/patches/patch_sides.h", "verify/certify/crossing_witness.h"],
        "tests": ["tests/certify/side_witness_test.cc", "tests/solids/patch_sides_test.cc"],
        "binary": "certify_quick",
        "filter": "*",
    },
    # The conditions X1 to X3, the solver that proposes what satisfies them, which pieces are searched, and how a sheet is
    # restricted to its rectangle and raised to one degree.
    "crossing": {
        "files": ["verify/certify/crossing_witness.cc", "verify/certify/crossing_witness.h", "verify/certify/miranda_internal.h",
                  "verify/certify/crossing_search.cc", "verify/certify/crossing_solver.cc", "verify/certify/sheet_tangents_internal.h",
                  "verify/certify/piece_neighbours.cc", "splines/restriction.h", "splines/bezier_degree.h"],
        "tests": ["tests/certify/crossing_test.cc", "tests/certify/crossing_solver_test.cc"],
        "binary": "certify_quick",
        "filter": "*",
    },
    # The conditions M1 and M2, and which places are one point of a surface.
    "meeting": {
        "files": ["verify/certify/meeting_witness.cc", "verify/certify/patch_place.cc", "verify/certify/affine_patch.cc"],
        "tests": ["tests/certify/meeting_witness_test.cc", "tests/certify/patch_place_test.cc", "tests/certify/contact_solver_test.cc"],
        "binary": "certify_quick",
        "filter": "*",
    },
    # Proved arcs, what of them lies in both domains, and the cover of all common points by them.
    "tubes": {
        "files": ["interval/intersect/intersection_tube.cc", "interval/intersect/intersection_clip.cc",
                  "interval/intersect/intersection_search.cc"],
        "tests": ["tests/interval/intersection_tube_test.cc", "tests/interval/intersection_clip_test.cc",
                  "tests/interval/surface_intersection_test.cc"],
        "binary": "interval_quick",
        "filter": "IntersectionTube*:IntersectionClusters*:IntersectionClip*:SurfaceIntersection*:IntersectionCurve.Gaps*",
    },
}

SWITCH = r"""
#pragma once
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
// Which mutant is switched on, and which places were reached.
namespace vt {
inline unsigned char reached[1 << 16];
inline int active() {
  static const int number = [] {
    if (std::getenv("VT_REACHED"))
      std::atexit([] {
        std::FILE* f = std::fopen(std::getenv("VT_REACHED"), "w");
        for (int i = 0; i < 1 << 16; ++i)
          if (reached[i]) std::fprintf(f, "%d\n", i);
        std::fclose(f);
      });
    const char* text = std::getenv("VT_MUTANT");
    return text ? std::atoi(text) : -1;
  }();
  return number;
}
// The change that is switched on at the place whose first mutant is `base`; -1: none.
inline int change(int base, int n) {
  const int d = active() - base;
  reached[base] = 1;
  return d >= 0 && d < n ? d : -1;
}
template <typename T>
T number(int base, T v) {
  switch (change(base, 3)) {
    case 0: return v / 2;
    case 1: return v * 2;
    case 2: return T(0);
    default: return v;
  }
}
inline bool condition(int base, bool v) {
  const int d = change(base, 2);
  return d < 0 ? v : d == 0;
}
template <typename T>
struct Left {
  const T& v;
  int d;
};
// An ordering (of <=>) can be compared with a literal 0 only.
template <typename T>
inline constexpr bool is_ordering = std::is_convertible_v<T, std::partial_ordering>;
// a < b becomes a < Lt{base} > b, and so on: operators of the same rank, so that operands need no parsing.
struct Lt { int base; };
struct Le { int base; };
struct Gt { int base; };
struct Ge { int base; };
struct Eq { int base; };
struct Ne { int base; };
#define VT_RELATION(Tag, op1, op2, op, weak)                                                              \
  template <typename T> struct Left##Tag : Left<T> {};                                                    \
  template <typename T> Left##Tag<T> operator op1(const T& a, Tag t) { return {{a, change(t.base, 2)}}; }  \
  template <typename T, typename U> bool operator op2(Left##Tag<T> l, const U& b) {                       \
    if constexpr (is_ordering<T>)                                                                          \
      return l.d < 0 ? l.v op 0 : l.d == 0 ? !(l.v op 0) : l.v weak 0;                                     \
    else                                                                                                   \
      return l.d < 0 ? static_cast<bool>(l.v op b) : l.d == 0 ? !(l.v op b) : static_cast<bool>(l.v weak b); \
  }
VT_RELATION(Lt, <, >, <, <=)
VT_RELATION(Le, <, >, <=, <)
VT_RELATION(Gt, >, <, >, >=)
VT_RELATION(Ge, >, <, >=, >)
#undef VT_RELATION
#define VT_EQUALITY(Tag, op)                                                                                     \
  template <typename T> struct Left##Tag : Left<T> {};                                                           \
  template <typename T> Left##Tag<T> operator op(const T& a, Tag t) { return {{a, change(t.base, 1)}}; }          \
  template <typename T, typename U> bool operator op(Left##Tag<T> l, const U& b) {                               \
    if constexpr (is_ordering<T>)                                                                                \
      return (l.v op 0) == (l.d < 0);                                                                            \
    else                                                                                                         \
      return (l.v op b) == (l.d < 0);                                                                            \
  }
VT_EQUALITY(Eq, ==)
VT_EQUALITY(Ne, !=)
#undef VT_EQUALITY
}  // namespace vt
"""

RELATION = {"<": ("Lt", "<", ">", "<="), "<=": ("Le", "<", ">", "<"), ">": ("Gt", ">", "<", ">="), ">=": ("Ge", ">", "<", ">"),
            "==": ("Eq", "==", "==", None), "!=": ("Ne", "!=", "!=", None)}
OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
DOUBLE = r"0x[0-9a-f.]+p[+-]?\d+|\b\d+\.\d+(?:e[+-]?\d+)?|\b\d+e[+-]?\d+"
FACTOR = r"(?<![\w.])\d+(?= \* )|(?<=\* )\d+(?![\w.])"

Mutant = collections.namedtuple("Mutant", "number file line what place text")  # place: the how manieth of its kind in the line


def masked(text):
    """The text with comments, strings and characters blanked out."""
    blank = lambda m: re.sub(r"[^\n]", " ", m.group(0))
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'", blank, text, flags=re.S)


def closing(code, at):
    """The place of the parenthesis that closes the one at `at`."""
    depth = 0
    for i in range(at, len(code)):
        depth += (code[i] == "(") - (code[i] == ")")
        if depth == 0:
            return i
    return len(code)


def ranges_of(code, word):
    return [(m.end() - 1, closing(code, m.end() - 1)) for m in re.finditer(r"\b%s \(" % word, code)]


class Instrumented:
    """One file with its places switched; places on lines that did not compile are left alone."""

    def __init__(self, path, first, refused):
        self.path, self.mutants, edits = path, [], []
        text = (ROOT / path).read_text()
        code = masked(text)
        lines = text.split("\n")
        headers = ranges_of(code, "for")
        counts = collections.Counter()

        def line_of(at):
            return code.count("\n", 0, at) + 1

        def is_open(at):
            line = line_of(at)
            source = lines[line - 1]
            return (line not in refused and not source.lstrip().startswith("#") and "static_assert" not in source and
                    not any(a < at < b for a, b in headers))

        def add(at, whats):
            line, base = line_of(at), first + len(self.mutants)
            for what in whats:
                counts[line, what] += 1
                self.mutants.append(Mutant(base + whats.index(what), path, line, what, counts[line, what], lines[line - 1].strip()))
            return base

        for m in re.finditer(r" (<=|>=|==|!=|<|>) ", code):
            if is_open(m.start()):
                tag, one, two, weak = RELATION[m.group(1)]
                base = add(m.start(), ["%s to %s" % (m.group(1), x) for x in (OPPOSITE[m.group(1)], weak) if x])
                edits.append((m.start(), m.end(), " %s vt::%s{%d} %s " % (one, tag, base, two)))
        for m in re.finditer(DOUBLE + "|" + FACTOR, code):
            if is_open(m.start()) and float.fromhex(m.group(0)) != 0 if "x" in m.group(0) else is_open(m.start()) and float(m.group(0)) != 0:
                base = add(m.start(), [m.group(0) + " " + x for x in ("halved", "doubled", "zeroed")])
                edits.append((m.start(), m.end(), "vt::number(%d, %s)" % (base, m.group(0))))
        for a, b in ranges_of(code, "if"):
            inside = code[a + 1:b]
            if is_open(a) and ";" not in inside and not re.match(r"(const|auto)\b", inside) and "{" not in inside:
                base = add(a, ["condition true", "condition false"])
                edits += [(a + 1, a + 1, "vt::condition(%d, static_cast<bool>(" % base), (b, b, "))")]
        # Numbers that are asked for are not known to the compiler.
        for m in re.finditer(r"\bconstexpr (?=double\b|Interval\b)", code):
            if line_of(m.start()) not in refused:
                edits.append((m.start(), m.end(), "const "))
        edits.sort(key=lambda e: (e[0], e[1]))
        out, at = [], 0
        for start, end, new in edits:
            out += [text[at:start], new]
            at = end
        # The switch goes in front of everything, without moving a line.
        self.text = '#include "vt_switch.h" ' + "\n" + "#line 1 \"%s\"\n" % path + "".join(out) + text[at:]


def commands(build):
    return {c["file"]: c["command"] for c in json.loads((build / "compile_commands.json").read_text())}


def compile_all(layer, build, scratch, jobs):
    """(program, mutants): places that a compiler refuses are taken out until everything compiles."""
    paths = sorted({str(p.relative_to(ROOT)) for pattern in layer["files"] for p in ROOT.glob(pattern)})
    tests = [t for t in layer["tests"] if (ROOT / t).is_file()]
    known, refused = commands(build), collections.defaultdict(set)
    todo = [p for p in paths if p.endswith(".cc")] + tests
    (scratch / "vt_switch.h").write_text(SWITCH)
    done = set()
    for _ in range(12):
        mutants = []
        for path in paths:
            made = Instrumented(path, len(mutants), refused[path])
            mutants += made.mutants
            target = scratch / path
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.is_file() or target.read_text() != made.text:
                target.write_text(made.text)
                done.clear() if path.endswith(".h") else done.discard(path)
        # Numbers of later places move when one is taken out: everything is compiled again, but only what was refused is tried first.

        def build_one(path):
            words = shlex.split(known[str(ROOT / path)])
            source = scratch / path if (scratch / path).is_file() else ROOT / path
            out = scratch / (path.replace("/", "_") + ".o")
            at = words.index("-o")
            words[at + 1] = str(out)
            words[words.index("-c") + 1] = str(source)
            words = (["ccache"] if shutil.which("ccache") else []) + words[:1] + ["-I" + str(scratch)] + [w for w in words[1:] if w != "-Werror"] + ["-O1", "-w", "-D_GLIBCXX_ASSERTIONS"]
            run = subprocess.run(words, cwd=build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 env=dict(os.environ, CCACHE_SLOPPINESS="pch_defines,time_macros"))
            return path, run

        failed, before = False, {(name, line) for name in refused for line in refused[name]}
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            for path, run in pool.map(build_one, [p for p in todo if p not in done]):
                if run.returncode == 0:
                    done.add(path)
                    continue
                failed = True
                found = re.findall(r"((?:[a-z_]+/)+[\w.]+):(\d+):", run.stdout)
                named = {(name, int(line)) for name, line in found if name in paths}
                # Another file may have named the same lines in this round.
                if named <= before:
                    sys.exit("kernel_mutants: %s does not compile:\n%s" % (path, run.stdout[:3000]))
                for name, line in named:
                    refused[name].add(line)
        if not failed:
            break
    else:
        sys.exit("kernel_mutants: some file does not compile")
    last = subprocess.run(["ninja", "-C", str(build), "-t", "commands", layer["binary"]], stdout=subprocess.PIPE, text=True, check=True)
    link = shlex.split(last.stdout.strip().split("\n")[-1].replace("&&", " ").replace(" : ", " "))
    libraries = [w for w in link if w.endswith((".a", ".so")) or w.startswith(("-l", "-L", "-Wl", "-pthread"))]
    program = scratch / "mutants"
    objects = [str(scratch / (p.replace("/", "_") + ".o")) for p in todo]
    subprocess.run(["c++", *objects, "-Wl,--start-group", *libraries, "-Wl,--end-group", "-o", str(program)], cwd=build, check=True)
    return program, mutants


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run_tests(program, tests, cpu, **env):
    """The exit status of the tests; a mutant that takes more CPU than that is killed by the limit."""
    def limits():
        limited()
        resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))
    return subprocess.run([str(program), "--gtest_filter=" + tests, "--gtest_fail_fast", "--gtest_brief=1"], preexec_fn=limits,
                          env=dict(os.environ, **env), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=3600).returncode


Test = collections.namedtuple("Test", "seconds name reached")  # CPU seconds; numbers of the first mutants of the places


def measured_tests(program, pattern, scratch):
    """Every test alone without a mutant, cheapest first."""
    listed = subprocess.run([str(program), "--gtest_list_tests", "--gtest_filter=" + pattern], stdout=subprocess.PIPE, text=True, check=True)
    suite, out = "", []
    for row in listed.stdout.split("\n"):
        word = row.split("#")[0].strip()
        if not row.startswith(" "):
            suite = word
            continue
        used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        if word and run_tests(program, suite + word, 600, VT_REACHED=str(scratch / "reached")) != 0:
            sys.exit("kernel_mutants: %s fails without a mutant" % (suite + word))
        if word:
            reached = {int(n) for n in (scratch / "reached").read_text().split()}
            out.append(Test(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - used, suite + word, reached))
    return sorted(out)


def equivalents():
    """{(file, what, place, text): reason} of kernel_equivalent.txt: FILE | WHAT | PLACE | LINE | REASON."""
    return {tuple(k): reason for *k, reason in rows_of_equivalents() if k[1] not in RULES}


def rules():
    """[(file, kind, text, reason)] of kernel_equivalent.txt: FILE | line or function | proposes | LINE or NAME | REASON."""
    return [(file, kind, text, reason) for file, kind, _, text, reason in rows_of_equivalents() if kind in RULES]


RULES = ("line", "function")
COSTLY = 0.6  # CPU seconds: tests that take longer are not run for places that only propose


def rows_of_equivalents():
    for row in EQUIVALENT.read_text().split("\n"):
        if row.strip() and not row.startswith("#"):
            file, what, place, rest = [f.strip() for f in row.split(" | ", 3)]
            text, reason = [f.strip() for f in rest.rsplit(" | ", 1)]
            yield file, what, place if what in RULES else int(place), text, reason


def lines_of_function(code, name):
    """The numbers of the lines of all definitions of this function: from its name at the margin's side of a body to the body's end."""
    out = set()
    for m in re.finditer(r"(?<![\w.>:])(?:\w+::)*%s\(" % re.escape(name), code):
        head = closing(code, m.end() - 1)
        body = re.match(r"\)[\w\s]*(?::[^;{}]*(?:\{[^{}]*\}[^;{}]*)*)?\{", code[head:])
        if not body:
            continue
        depth, at = 1, head + body.end()
        while depth and at < len(code):
            depth += (code[at] == "{") - (code[at] == "}")
            at += 1
        out |= set(range(code.count("\n", 0, m.start()) + 1, code.count("\n", 0, at) + 2))
    return out


def excused(mutants):
    """({number: reason} of mutants at places that only propose, rules that excuse none of these files' mutants)."""
    out, idle = {}, []
    for file, kind, text, reason in rules():
        here = [m for m in mutants if m.file == file]
        lines = lines_of_function(masked((ROOT / file).read_text()), text) if kind == "function" else ()
        found = [m.number for m in here if (m.line in lines if kind == "function" else m.text == text)]
        out.update(dict.fromkeys(found, reason))
        if here and not found:
            idle.append((file, kind, text))
    return out, idle


def key_of(m):
    return m.file, m.what, m.place, m.text


def main(argv):
    a = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    a.add_argument("layer", choices=sorted(LAYERS))
    a.add_argument("--build", type=pathlib.Path, default=ROOT / "build-mutants")
    a.add_argument("--sample", type=int, default=0)
    a.add_argument("--seed", type=int, default=1)
    a.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    a.add_argument("--only", default="", help="mutants of files whose path matches this expression")
    a.add_argument("--fast", action="store_true", help="without the tests that take long: what survives must be run again")
    a.add_argument("--again", type=pathlib.Path, help="only the mutants that an earlier output in this file names")
    a.add_argument("--list", action="store_true", help="every mutant and what became of it")
    options, start = a.parse_args(argv), time.monotonic()
    layer, build = LAYERS[options.layer], options.build.resolve()
    scratch = build / "kernel_mutants" / options.layer
    scratch.mkdir(parents=True, exist_ok=True)
    if not (build / "CMakeCache.txt").is_file():
        # A batch would hold the file that is replaced beside others, which may have its functions inlined.
        subprocess.run(["cmake", "--preset", "release", "-B", str(build), "-DVERITOPE_UNITY=OFF"], check=True, cwd=ROOT, stdout=sys.stderr)
    subprocess.run(["cmake", "--build", str(build), "--target", layer["binary"]], check=True, stdout=sys.stderr)
    program, mutants = compile_all(layer, build, scratch, options.jobs)
    tests = measured_tests(program, layer["filter"], scratch)
    first = {}  # of the place of each mutant; mutants of one place follow each other
    for m in mutants:
        first[m.number] = first[m.number - 1] if m.number > 0 and same_place(m, mutants, first[m.number - 1]) else m.number
    reached = {m.number for m in mutants if any(first[m.number] in t.reached for t in tests)}
    print("%d mutants, %d of them reached by tests that take %.1f s" % (len(mutants), len(reached), sum(t.seconds for t in tests)), flush=True)
    known, keys = equivalents(), {key_of(m) for m in mutants}
    proposals, idle = excused(mutants)
    stale = [k for k in known if k[0] in {m.file for m in mutants} and k not in keys] + idle
    if stale:
        sys.exit("kernel_mutants: kernel_equivalent.txt lists what is no mutant: %s" % (stale[0],))
    chosen = [m for m in mutants if re.search(options.only, m.file)]
    if options.again:
        chosen = [m for m in chosen if any(row.endswith("%s | %d | %s" % (m.what, m.place, m.text)) for row in options.again.read_text().split("\n"))]
    if options.sample and options.sample < len(chosen):
        chosen = sorted(random.Random(options.seed).sample(chosen, options.sample))

    def judge(m):
        """The test that notices the mutant."""
        for test in tests if m.number in reached else ():
            if test.seconds > COSTLY and (options.fast or m.number in proposals):
                break
            if first[m.number] in test.reached and run_tests(program, test.name, int(20 * test.seconds) + 10, VT_MUTANT=str(m.number)) != 0:
                return m, test.name
        return m, None

    count, wrong = collections.Counter(), 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for m, killer in pool.map(judge, chosen):
            is_known = key_of(m) in known
            wrong += is_known and killer is not None
            kind = ("killed" if killer else "equivalent" if is_known else "proposes" if m.number in proposals else "survived")
            count[kind] += 1
            if options.list or is_known == (killer is not None) and kind != "proposes":
                word = "NOT EQUIVALENT" if is_known and killer else kind if kind != "survived" else "SURVIVED" if m.number in reached else "NOT REACHED"
                print("%s %s:%d | %s | %d | %s%s" % (word, m.file, m.line, m.what, m.place, m.text, " | by " + killer if killer and options.list else ""), flush=True)
    real = count["killed"] + count["survived"]
    score = count["killed"] / max(real, 1)
    for name, value, goal in (("kernel_mutants_" + options.layer, real, ">= 200"),
                              ("kernel_mutants_equivalent_" + options.layer, count["equivalent"], "each with its reason"),
                              ("kernel_mutants_proposals_" + options.layer, count["proposes"], "places that decide nothing, each with its reason"),
                              ("kernel_mutants_survived_" + options.layer, count["survived"], "<= 5 %"),
                              ("kernel_mutation_score_" + options.layer, round(score, 4), ">= 0.95"),
                              ("kernel_mutants_seconds_" + options.layer, round(time.monotonic() - start, 1), "")):
        print(json.dumps({"name": name, "value": value, "goal": goal}))
    return 1 if wrong or score < 0.95 else 0


def same_place(m, mutants, base):
    """Does mutant m belong to the place whose first mutant is `base`?"""
    if base < 0:
        return False
    first = mutants[base]
    n = 2 if first.what.startswith(("< ", "<= ", "> ", ">= ", "condition")) else 1 if first.what.startswith(("==", "!=")) else 3
    return m.number < base + n


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
