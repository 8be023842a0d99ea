#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What whole commands cost: veritope certify, both checkers, certificate sizes, malformed files. One JSON row a line,
medians of 7.

usage: bench_command.py BIN_FOLDER   (with veritope, veritope-check, write_model)
"""
import json
import os
import pathlib
import statistics
import sys
import tempfile
import time

RUNS = 7
ROOT = pathlib.Path(__file__).resolve().parent.parent
DATA = pathlib.Path(os.environ.get("VERITOPE_DATA", ROOT / "../shared/data")) / "mesh"
BIN = pathlib.Path(sys.argv[1]).resolve()
PYTHON_CHECKER = ROOT / "verify/checker/veritope_check.py"


def run(command, wanted):
    """(seconds, peak bytes) of one command, whose exit status must be `wanted`."""
    null = os.open(os.devnull, os.O_RDWR)
    start = time.perf_counter()
    pid = os.posix_spawn(str(command[0]), [str(c) for c in command], os.environ,
                         file_actions=[(os.POSIX_SPAWN_DUP2, null, 1), (os.POSIX_SPAWN_DUP2, null, 2)])
    _, status, usage = os.wait4(pid, 0)
    seconds = time.perf_counter() - start
    os.close(null)
    if os.waitstatus_to_exitcode(status) != wanted:
        sys.exit(f"{' '.join(map(str, command))}: exit status {os.waitstatus_to_exitcode(status)}, not {wanted}")
    return seconds, usage.ru_maxrss * 1024


def row(name, ours, unit, **more):
    print(json.dumps({"row": name, "ours": round(ours, 6), "peer": None, "unit": unit, **more}), flush=True)


def median_seconds(command, wanted=0, runs=RUNS):
    return statistics.median(run(command, wanted)[0] for _ in range(runs))


def facets(path):
    with open(path, "rb") as f:
        for line in f:
            if line.startswith(b"element face"):
                return int(line.split()[2])
    raise ValueError(path)


def certificate_rows(name, model, folder, python_runs):
    """Whole command, both checkers and the certificate's size for one model."""
    certificate = folder / (name + ".cert")
    n = facets(model)
    certify = [BIN / "veritope", "certify", model, "--certificate", certificate, "--quiet"]
    seconds = median_seconds([*certify, "--no-check"])
    row(f"whole_command_{name}", seconds, "s", ns_per_facet=round(seconds / n * 1e9))
    seconds = median_seconds([*certify, "--no-check", "--jobs", "1"])
    row(f"whole_command_{name}_one_thread", seconds, "s", ns_per_facet=round(seconds / n * 1e9))
    row(f"certificate_{name}", certificate.stat().st_size / n, "bytes/facet")
    seconds = median_seconds([BIN / "veritope-check", model, certificate])
    row(f"checker_cpp_{name}", seconds, "s", us_per_facet=round(seconds / n * 1e6, 3))
    if python_runs:
        seconds = median_seconds([sys.executable, PYTHON_CHECKER, model, certificate], runs=python_runs)
        row(f"checker_python_{name}", seconds, "s", us_per_facet=round(seconds / n * 1e6, 3))


def malformed_rows():
    """The slowest and the largest refusal of the malformed files, beside an empty run of the program."""
    worst, largest, count = (0, ""), (0, ""), 0
    for path in sorted((DATA / "malformed").iterdir()):
        runs = [run([BIN / "veritope", "certify", path], 4) for _ in range(3)]
        worst = max(worst, (statistics.median(r[0] for r in runs), path.name))
        largest = max(largest, (max(r[1] for r in runs), path.name))
        count += 1
    row("malformed_slowest", worst[0] * 1000, "ms", file=worst[1], files=count)
    row("malformed_largest", largest[0] / 1e6, "MB", file=largest[1], files=count)


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        certificate_rows("blade199k", DATA / "solid1/vtk-data__turbineblade.ply", folder, 3)
        for name, python_runs in (("bunny70k", 0), ("loop279k", 0), ("loop1115k", 0), ("sliver20k", 3),
                                  ("sliver80k", 0),
                                  ("sliver20k_rim", 0), ("sliver20k_zigzag", 0), ("plate80k_rim", 0)):
            model = folder / (name + ".ply")
            run([BIN / "write_model", name, model], 0)
            certificate_rows(name, model, folder, python_runs)
            model.unlink()
    malformed_rows()


main()
