#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Branch and line coverage of predicates/ and verify/checker/ by the quick and the full tests.

usage: coverage.py BUILD_FOLDER      a build of the preset coverage; ./dev coverage makes it

Prints one JSON line a figure. Branches that no test took are listed on stderr and in BUILD_FOLDER/uncovered.txt. Not counted: branches
that the compiler adds for exceptions, the failing side of VT_CHECK and VT_SLOW_CHECK (a bug of ours: no input reaches it), and lines
that carry GCOVR_EXCL_BR_LINE, whose comment must argue why; they are counted in the figure's key "argued".
Exit: 0 measured, 1 a test failed or gcovr did.
"""
import collections
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = {"predicates": "predicates/", "checker": "verify/checker/"}
MARK = "GCOVR_EXCL_BR_LINE"


def run_tests(build):
    """Whether all passed. The counters start at zero."""
    for counters in build.rglob("*.gcda"):
        counters.unlink()
    command = ["ctest", "--test-dir", build, "-L", "^(quick|full)$", "-LE", "^infra$", "-j", "2", "--output-on-failure", "--no-tests=error"]
    return subprocess.run(command, stdout=sys.stderr).returncode == 0


def measure(build):
    """gcovr's report, a list of files with their lines."""
    filters = [option for part in PARTS.values() for option in ("--filter", part)]
    report = build / "coverage.json"
    subprocess.run(["gcovr", "--root", ROOT, "--object-directory", build, *filters, "--exclude-throw-branches",
                    "--exclude-unreachable-branches", "--exclude-branches-by-pattern", r".*\bVT_(SLOW_)?CHECK\(.*",
                    "--json", report, build], cwd=ROOT, check=True, stdout=sys.stderr)
    return json.loads(report.read_text())["files"]


def count(lines):
    """Counter of branches, branches_taken, lines, lines_run; list of (line number, untaken branches)."""
    total, untaken = collections.Counter(), []
    for line in lines:
        if line.get("gcovr/noncode"):
            continue
        branches = line.get("branches", [])
        taken = sum(branch["count"] > 0 for branch in branches)
        total.update(branches=len(branches), branches_taken=taken, lines=1, lines_run=line["count"] > 0)
        if taken < len(branches):
            untaken.append((line["line_number"], len(branches) - taken))
    return total, untaken


def argued(part):
    return sum(path.read_text().count(MARK) for pattern in ("*.h", "*.cc") for path in (ROOT / part).rglob(pattern))


def percent(some, all_of_them):
    return round(100 * some / all_of_them, 3) if all_of_them else 100.0


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    build = pathlib.Path(arguments[0]).resolve()
    passed = run_tests(build)
    files = measure(build)
    missed = []
    for name, part in PARTS.items():
        total = collections.Counter()
        for file in sorted(files, key=lambda file: file["file"]):
            if file["file"].startswith(part):
                of_file, untaken = count(file["lines"])
                total += of_file
                missed += [f"{file['file']}:{line}: {branches} branches untaken" for line, branches in untaken]
        print(json.dumps({"name": f"coverage_branches_{name}", "value": percent(total["branches_taken"], total["branches"]),
                          "goal": "100 %, or each exception argued", "branches": total["branches"], "argued": argued(part),
                          "command": "./dev coverage"}))
        print(json.dumps({"name": f"coverage_lines_{name}", "value": percent(total["lines_run"], total["lines"]),
                          "goal": "100 %", "lines": total["lines"], "command": "./dev coverage"}))
    text = "".join(line + "\n" for line in missed)
    (build / "uncovered.txt").write_text(text)
    sys.stderr.write(text)
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
