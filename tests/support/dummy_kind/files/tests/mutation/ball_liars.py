# SPDX-License-Identifier: LGPL-3.0-or-later
"""Certificates about balls that lie, with right hashes: pairs of a model and a certificate."""
import hashlib
import json
import struct


def model_of(radius):
    return b"ball\ncentre 0 0 0\nradius %s\n" % radius.encode()


def certificate(model, claim, radius, number, magic=None):
    """number: the radius of the body, (digits, decimals)."""
    body = magic or {"ball-1": b"VTBL", "ball-invalid-1": b"VTBN"}[claim]
    body += struct.pack("<qB", 0, 0) * 3 + struct.pack("<qB", *number)
    statement = {"certificate": "veritope-certificate-1", "tool": "liar", "claim": claim, "subject_format": "ball",
                 "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "radius": radius,
                 "body_sha256": hashlib.sha256(body).hexdigest()}
    return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


def lies(claim):
    """(the first condition that fails, model, certificate)"""
    false, true = ("-2", "2") if claim == "ball-1" else ("2", "-2")
    yield "P3", model_of(false), certificate(model_of(false), claim, false, (int(false), 0))
    yield "P1", model_of(false), certificate(model_of(false), claim, false, (int(true), 0))
    yield "P1", model_of(true), certificate(model_of(true), claim, true, (10 * int(true), 1))
    yield "P2", model_of(true), certificate(model_of(true), claim, "7", (int(true), 0))
    yield "B1", model_of(true), certificate(model_of(true), claim, true, (int(true), 0), b"VTMV")
    if claim == "ball-1":
        yield "P3", model_of("0"), certificate(model_of("0"), claim, "0", (0, 0))


def lies_of(claim):
    """For tests/claims_table_test.py."""
    return lambda rng: ((model, lie) for _, model, lie in lies(claim))
