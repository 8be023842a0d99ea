#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs the rows of bench/bench.txt and bench/soak.txt; the head of each table says what a row is.

usage: experiments.py bench [NAME]   writes build/bench/NAME.json for each benchmark, or for the one named
       experiments.py soak [NAME]    prints one JSON line a figure

Called by ./dev, which builds the programs first. Exit: 0 all commands succeeded, 1 one failed, 2 usage or missing data.
"""
import json
import os
import pathlib
import platform
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def refuse(message):
    """Ends the program: wrong usage, or a row that does not follow the rules at the head of its table."""
    print(message, file=sys.stderr)
    sys.exit(2)


class Experiment:
    """One row: NAME [+tag...] | description | command."""

    def __init__(self, line, where):
        fields = [field.strip() for field in line.split("|", 2)]
        if len(fields) != 3 or not all(fields):
            refuse(f"{where}: a row is NAME [+data] [+extra] | description | command")
        self.name, *tags = fields[0].split()
        self.needs = {tag[1:] for tag in tags}
        if not self.needs <= {"data", "extra"} or any(tag[0] != "+" for tag in tags):
            refuse(f"{where}: unknown tag in {fields[0]!r}")
        self.description, self.command = fields[1:]


def read_table(path):
    """The experiments of a table by name, in its order."""
    rows = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            row = Experiment(line, f"{path.name}:{number}")
            if row.name in rows:
                refuse(f"{path.name}:{number}: {row.name} is there twice")
            rows[row.name] = row
    return rows


def run(experiment):
    """Yields the JSON objects that the command prints; other lines go to stderr. Raises CalledProcessError at the
    end."""
    print(f"== {experiment.name}: {experiment.description}", file=sys.stderr, flush=True)
    with subprocess.Popen(["bash", "-c", experiment.command], cwd=ROOT, stdout=subprocess.PIPE, text=True) as child:
        for line in child.stdout:
            row = parse_object(line)
            if row is None:
                sys.stderr.write(line)
            else:
                yield row
    if child.returncode != 0:
        raise subprocess.CalledProcessError(child.returncode, experiment.command)


def parse_object(line):
    if not line.startswith("{"):
        return None
    try:
        return json.loads(line)
    except ValueError:
        return None


def add_ratio(row):
    """The row with ratio = ours/peer; None where there is no peer."""
    missing = {"row", "ours", "unit"} - row.keys()
    if missing:
        refuse(f"benchmark row {row} lacks {', '.join(sorted(missing))}")
    peer = row.setdefault("peer", None)
    row.setdefault("ratio", round(row["ours"] / peer, 4) if peer else None)
    return row


def machine():
    """One line: processor, cores, memory, system."""
    cpu, memory = platform.processor() or platform.machine(), ""
    try:
        for line in open("/proc/cpuinfo"):
            if line.startswith("model name"):
                cpu = line.split(":", 1)[1].strip()
                break
        kilobytes = int(open("/proc/meminfo").readline().split()[1])
        memory = f", {kilobytes / 2**20:.0f} GiB"
    except (OSError, ValueError, IndexError):
        pass
    return f"{cpu}, {os.cpu_count()} cores{memory}, {platform.system()} {platform.release()}"


def commit():
    """Short id of the checked-out commit, "-dirty" appended if tracked files differ from it."""
    try:
        return subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"], cwd=ROOT,
                              capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def bench(experiment):
    rows = [add_ratio(row) for row in run(experiment)]
    for row in rows:
        against = "" if row["peer"] is None else f"  peer {row['peer']:g}  ratio {row['ratio']:g}"
        print(f"{row['row']:<40} {row['ours']:>12g} {row['unit']}{against}")
    target = ROOT / "build" / "bench" / f"{experiment.name}.json"
    target.parent.mkdir(parents=True, exist_ok=True)
    report = {"machine": machine(), "commit": commit(), "rows": rows}
    target.write_text(json.dumps(report, indent=1) + "\n")
    print(f"wrote {target.relative_to(ROOT)}", flush=True)


def soak(experiment):
    for figure in run(experiment):
        figure.setdefault("command", f"./dev soak {experiment.name}")
        print(json.dumps(figure), flush=True)


def main(arguments):
    actions = {"bench": bench, "soak": soak}
    if not 1 <= len(arguments) <= 2 or arguments[0] not in actions:
        refuse(__doc__)
    kind = arguments[0]
    table = read_table(ROOT / "bench" / f"{kind}.txt")
    wanted = arguments[1:] or list(table)
    if not set(wanted) <= table.keys():
        names = "".join(f"\n  {row.name:<16} {row.description}" for row in table.values())
        print(f"no experiment {wanted[0]!r} in bench/{kind}.txt; there are:{names or ' none'}", file=sys.stderr)
        return 2
    status = 0
    for name in wanted:
        status = max(status, attempt(actions[kind], table[name]))
    return status


def attempt(action, experiment):
    """Runs one experiment; returns its exit status."""
    data = os.environ.get("VERITOPE_DATA", str(ROOT.parent / "shared" / "data"))
    if "data" in experiment.needs and not os.path.isdir(data):
        print(f"{experiment.name}: not run: it needs the real models, and VERITOPE_DATA={data} is no folder",
              file=sys.stderr)
        return 2
    try:
        action(experiment)
    except subprocess.CalledProcessError as error:
        print(f"{experiment.name}: exit status {error.returncode} of: {experiment.command}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
