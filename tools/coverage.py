#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Branch and line coverage of predicates/ and verify/checker/ by all tests.

usage: coverage.py BUILD_FOLDER      a build of the preset coverage; ./dev coverage makes it

Prints one JSON line a figure. A branch is one outcome, true or false, of one condition of the source; it counts as
taken if any instantiation took it. Outcomes that no test took are listed on stderr and in BUILD_FOLDER/uncovered.txt.
Not counted: conditions that are constant, those inside VT_CHECK and VT_SLOW_CHECK (a bug of ours: no input reaches the
other side), and lines with a comment "NOT COVERED: reason"; how many of these there are is the figure's key "argued".
Exit: 0 measured, 1 a test failed or the measurement did.
"""
import bisect
import collections
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = {"predicates": "predicates/", "checker": "verify/checker/"}
MARK = "NOT COVERED: "


def run_tests(build):
    """Runs the tests with counters that start at zero; returns whether all passed."""
    for counters in (build / "profiles").glob("*.profraw"):
        counters.unlink()
    tiers = ["-L", "^(quick|standard|full)$", "-LE", "^infra$"]
    command = ["ctest", "--test-dir", build, *tiers, "-j", "2", "--output-on-failure", "--no-tests=error"]
    return subprocess.run(command, stdout=sys.stderr).returncode == 0


def measure(build):
    """{path: llvm-cov's reports of the file, one for each program that has it}. Program by program: one call for all of
    them would count a function once, as the first program has it, and compilers make different code for it in different
    programs."""
    profile = build / "coverage.profdata"
    counters = sorted((build / "profiles").glob("*.profraw"))
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", *counters, "-o", profile], check=True, stdout=sys.stderr)
    programs = sorted(path for folder in ("bin", "tests") for path in (build / folder).iterdir()
                      if path.is_file() and path.open("rb").read(4) == b"\x7fELF")
    sources = [ROOT / part for part in PARTS.values()]
    reports = collections.defaultdict(list)
    for program in programs:
        done = subprocess.run(["llvm-cov-14", "export", "-format=text", f"-instr-profile={profile}", program, *sources],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        for file in json.loads(done.stdout)["data"][0]["files"] if done.returncode == 0 else ():
            reports[str(pathlib.Path(file["filename"]).relative_to(ROOT))].append(file)
    return reports


def count_at(segments, place):
    """The number of times that the code at (line, column) ran."""
    index = bisect.bisect_right(segments, place, key=lambda segment: (segment[0], segment[1])) - 1
    return segments[index][2] if index >= 0 and segments[index][3] else 0


def conditions(files):
    """{(line, column): [times true, times false]} without the constant ones."""
    found = collections.defaultdict(lambda: [0, 0])
    for file in files:
        for line, column, _, _, true, false, *_ in file["branches"]:
            counts = found[line, column]
            counts[0] += true
            counts[1] += false
    # Neither outcome occurred although the place was reached: the compiler knew the value.
    return {place: counts for place, counts in found.items()
            if any(counts) or all(count_at(file["segments"], place) == 0 for file in files)}


def lines_run(file):
    """{line: whether it ran} of the lines that have code: as llvm-cov counts them, from the regions that begin on a
    line or reach into it."""
    lines, count, has_code = {}, 0, False
    segments = sorted((s for s in file["segments"]), key=lambda s: (s[0], s[1]))
    at = 0
    for line in range(segments[0][0], segments[-1][0] + 1) if segments else ():
        most = count if has_code else None
        while at < len(segments) and segments[at][0] == line:
            _, _, count, has_code, is_entry, *_ = segments[at]
            if has_code and is_entry:
                most = max(most or 0, count)
            at += 1
        if most is not None:
            lines[line] = most > 0
    return lines


class Part:
    """The figures of one folder."""

    def __init__(self):
        self.branches = self.branches_taken = self.lines = self.lines_run = self.argued = 0
        self.missed = []

    def add(self, path, files):
        text = (ROOT / path).read_text().splitlines()
        for (line, column), counts in sorted(conditions(files).items()):
            if MARK in text[line - 1]:
                self.argued += 1
                continue
            self.branches += 2
            self.branches_taken += sum(count > 0 for count in counts)
            never = [outcome for outcome, count in zip(("true", "false"), counts) if count == 0]
            if never:
                self.missed.append(f"{path}:{line}:{column}: never {' nor '.join(never)}")
        lines = collections.defaultdict(bool)
        for file in files:
            for line, has_run in lines_run(file).items():
                lines[line] |= has_run
        lines = {line: has_run for line, has_run in lines.items() if MARK not in text[line - 1]}
        self.lines += len(lines)
        self.lines_run += sum(lines.values())
        self.missed += [f"{path}:{line}: never run" for line, has_run in sorted(lines.items()) if not has_run]


def percent(some, all_of_them):
    return round(100 * some / all_of_them, 3) if all_of_them else 100.0


def report(name, part):
    figures = [
        {"name": f"coverage_branches_{name}", "value": percent(part.branches_taken, part.branches),
         "goal": "100 %, or each exception argued", "branches": part.branches, "argued": part.argued},
        {"name": f"coverage_lines_{name}", "value": percent(part.lines_run, part.lines), "goal": "100 %",
         "lines": part.lines},
    ]
    for figure in figures:
        print(json.dumps({**figure, "command": "./dev coverage"}))


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    build = pathlib.Path(arguments[0]).resolve()
    passed = run_tests(build)
    files = measure(build)
    missed = ""
    for name, folder in PARTS.items():
        part = Part()
        for path in sorted(files):
            if path.startswith(folder):
                part.add(path, files[path])
        report(name, part)
        missed += "".join(line + "\n" for line in part.missed)
    (build / "uncovered.txt").write_text(missed)
    sys.stderr.write(missed)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
