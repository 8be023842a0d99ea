# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker beside the Python one: after judge(), all that the Python tests ask is asked of both, and exit code and condition must
agree. VERITOPE_CHECK names the program."""
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "checker_py"), str(ROOT / "verify" / "checker")]
from veritope_checker import program as vc                # noqa: E402

CHECK = os.environ["VERITOPE_CHECK"]
FOLDER = tempfile.TemporaryDirectory()                    # gone at exit
in_python = vc._check


def condition(line):
    return line.split(":")[0].split(" ")[0 if line.startswith("ACCEPT") else -1].strip()


def in_cpp(*given, beside=None, solid=None):
    """(exit code, condition or ACCEPT, all that was printed) for a model, a certificate and, if its claim is about one, an answers file.
    beside: the files that the model names, by their paths. solid: the file of --model."""
    with tempfile.TemporaryDirectory() if beside else contextlib.nullcontext(FOLDER.name) as folder:
        for name, data in (beside or {}).items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        return run_in(folder, given, solid)


def run_in(folder, given, solid=None):
    paths = [os.path.join(folder, name) for name in ("model", "certificate", "answers")][:len(given)]
    for path, data in zip(paths, given):
        with open(path, "wb") as file:
            file.write(data)
    if solid is not None:
        pathlib.Path(folder, "solid").write_bytes(solid)
        paths += ["--model", os.path.join(folder, "solid")]
    r = subprocess.run([CHECK, *paths], capture_output=True, text=True, timeout=300, check=False)
    return r.returncode, condition(r.stdout), r.stdout + r.stderr


def both(model, certificate, skip=frozenset(), answers=None, files=None, second=None):
    """files, second: as check() has them; the reader of files knows its `contents`."""
    code, line = in_python(model, certificate, skip, answers, files, second)
    if not skip:
        other = in_cpp(model, certificate, *(() if answers is None else (answers,)),
                       beside=files and files[1].contents, solid=second)
        assert other[0] > 1 or other[2].count("\n") == 1, other    # one line, and nothing on stderr
        if "too far away" in other[2]:                    # the limit of the C++ checker (star-box.md, section 8)
            assert other[:2] == (1, "B1"), other
        elif (code, "" if code == 4 else condition(line)) != other[:2]:
            raise AssertionError("Python: %d, %s; C++: %s" % (code, line, other))
    return code, line


def judge(module):
    """module: veritope_checker.program, as the tests know it."""
    module._check = both                                  # check() calls it, too
