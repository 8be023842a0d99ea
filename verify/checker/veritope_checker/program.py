# SPDX-License-Identifier: Apache-2.0 OR MIT
"""veritope_check.py MODEL CERT [ANSWERS] [--model M]: does this certificate prove its claim about this model?

Written from docs/certificates/ and docs/formats/spline-json.md alone.  Python 3.9 or later, standard library only: the
file veritope_check.py and the folder veritope_checker beside it; copy both where you need them.

ANSWERS is the file with the answers that a certificate of points-1 is about, M the model that a certificate of
micro-inside-1 is about; other claims have no such file.

Prints `ACCEPT <claim>` (exit 0) or `REJECT <condition>: <why>` (exit 1).  Exit 2: usage; 3: out of
memory; 4: a file cannot be opened, the reading rule refuses the model, or the answer cannot be
printed; 5: a bug of this program.  --claims prints the claims that it decides, with the keys of their statements.
All decisions are taken on Python integers and fractions.
"""
import importlib
import os
import stat
import sys

from .claims import CLAIMS, lines
from .common.errors import Refused, Reject
from .common.statement import read_statement

VERSION = "veritope_check.py 1 (%s; reading rule v1)" % ", ".join(CLAIMS)

def check(model_bytes, cert_bytes, answers=None, files=None, second=None):
    """(exit code, line to print) for a model and a certificate given as bytes.  answers: the third file, or None.
    files: the name of the model's file, and what reads the file of a name; for a model that names others.  second: the
    file of --model, or None."""
    return _check(model_bytes, cert_bytes, frozenset(), answers, files, second)

def _check(model_bytes, cert_bytes, skip, answers=None, files=None, second=None):
    """check() with some conditions disabled: for tests only, main() has no way to reach it."""
    try:
        statement, body = read_statement(CLAIMS, cert_bytes, model_bytes)
        claim = CLAIMS[statement["claim"]]
        if claim.about_answers != (answers is not None):
            return 2, "ERROR: a certificate of %s needs %s" % (
                claim.name, "its answers file as the third argument" if claim.about_answers else "no third argument")
        if claim.about_model != (second is not None):
            return 2, "ERROR: a certificate of %s needs %s" % (
                claim.name, "its model as --model" if claim.about_model else "no --model")
        try:
            module = importlib.import_module("." + claim.module, __package__)
        except ImportError as e:
            name = claim.module.split(".")[-1]
            return 4, "ERROR: the files of %s.py are not beside veritope_check.py: %s" % (name, e)
        about = () if answers is None else (answers, files or ("", read_named))
        about += () if second is None else (second,)
        said = module.check(claim, statement, body, model_bytes, skip, *about)
    except Refused as e:
        return 4, "ERROR: the model is refused: %s" % e
    except Reject as e:
        return 1, "REJECT %s: %s" % (e.condition, e.why)
    except MemoryError:
        return 3, "ERROR: out of memory"
    except Exception as e:                                  # our bug: never an ACCEPT
        return 5, "BUG: %s: %s" % (type(e).__name__, e)
    return 0, "ACCEPT %s%s" % (statement["claim"], ": " + said if said else "")

def read_file(name):
    """The bytes; None of what is no regular file."""
    if not stat.S_ISREG(os.stat(name).st_mode):             # the opening of a FIFO waits for a writer
        return None
    with open(name, "rb") as file:
        return file.read()

def read_named(name):
    """The bytes of a file that a model names."""
    try:
        data = read_file(name)
    except (OSError, ValueError) as e:
        raise Refused("%r: %s" % (name, e))
    if data is None:
        raise Refused("%r is not a regular file" % name)
    return data


# ---------------------------------------------------------------- command line

def main(argv):
    if argv[1:] in (["--help"], ["-h"]):
        return say(__doc__.strip(), 0)
    if argv[1:] == ["--version"]:
        return say(VERSION, 0)
    if argv[1:] == ["--claims"]:
        return say("\n".join(lines()), 0)
    names, second = without_model(argv[1:])
    if len(names) not in (2, 3) or any(a.startswith("--") for a in names + second):
        print("usage: veritope_check.py MODEL CERT [ANSWERS] [--model M]", file=sys.stderr)
        return 2
    try:
        data = [read_file(name) for name in names + second]
        if None in data:
            return say("ERROR: %s: is not a regular file" % (names + second)[data.index(None)], 4)
    except OSError as e:
        return say("ERROR: %s" % e, 4)
    except MemoryError:
        return say("ERROR: out of memory", 3)
    answers = data[2] if len(names) == 3 else None
    code, message = check(data[0], data[1], answers, (argv[1], read_named), data[-1] if second else None)
    return say(message, code)

def without_model(arguments):
    """(the arguments without --model M, [M] or []).  The option follows MODEL CERT; elsewhere it is left in place."""
    if "--model" in arguments[2:-1]:
        at = arguments.index("--model", 2)
        return arguments[:at] + arguments[at + 2:], [arguments[at + 1]]
    return arguments, []

def say(message, code):
    """Prints the answer; the exit code. An answer that cannot be printed does not count."""
    try:
        print(message, file=sys.stdout if code < 2 else sys.stderr, flush=True)
        return code
    except OSError:
        os._exit(4)                                         # not even the interpreter's own flush
