# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Writes bodies and certificates of vmodel-invalid-1, whatever they say: tests only. A number is a rational or (n, d); a point is (cell,
three (span, number)), an interval (span, e, a, b), a box (cell, three intervals), an arc (cell, face, side, interval)."""
import copy
import hashlib
import json
from fractions import Fraction as Q

import model_texts as texts
import star_box_forge as forge
from volume_folded_forge import made_rational

KINDS = ("flat", "left-handed", "singular", "overlap", "curve-nonmanifold", "point-nonmanifold")
WHOLE = (0, 0, 0, 1)                                      # an interval: the first span


def cell_and(cell, at):
    return forge.varint(cell) + b"".join(forge.varint(n) for numbers in at for n in numbers)


def encode_point(point):
    return cell_and(point[0], [(k, *(t if isinstance(t, tuple) else (Q(t).numerator, Q(t).denominator))) for k, t in point[1]])


def encode_arc(arc):
    cell, face, side, interval = arc
    return forge.varint(cell) + bytes([face, side]) + b"".join(map(forge.varint, interval))


class Invalid:
    """Everything that a certificate says. parts: flat: cell, spans; left-handed, singular: point; overlap: A, B, and Y if B is a box;
    curve-nonmanifold: three arcs; point-nonmanifold: cell, corner."""
    claim, magic, tail = "vmodel-invalid-1", b"VTVI", b""

    def __init__(self, maps, kind, *parts, subject_format="vjson"):
        self.maps, self.kind, self.parts, self.subject_format = maps, kind, parts, subject_format
        self.number, self.count, self.values, self.text = KINDS.index(kind), len(maps), {}, None

    def changed(self, **fields):
        out = copy.copy(self)
        out.values = dict(self.values)
        if "maps" in fields or "subject_format" in fields:
            out.text = None
        for key, value in fields.items():
            setattr(out, key, value)
        return out

    def body(self):
        return self.magic + forge.u32(self.count) + bytes([self.number]) + self.finding() + self.tail

    def finding(self):
        if self.kind == "flat":
            return cell_and(self.parts[0], [self.parts[1]])
        if self.kind == "overlap" and len(self.parts) == 3:
            a, b, y = self.parts
            return encode_point(a) + b"\1" + cell_and(*b) + b"".join(forge.zigzag(c) for row in y for c in row)
        if self.kind == "curve-nonmanifold":
            return b"".join(map(encode_arc, self.parts))
        if self.kind == "point-nonmanifold":
            return forge.varint(self.parts[0]) + bytes([self.parts[1]])
        return b"\0".join(map(encode_point, self.parts))

    def model(self):
        if self.text is None:
            maps = [made_rational(m) for m in self.maps] if self.subject_format == "mfem" else self.maps
            self.text = texts.WRITERS[self.subject_format](maps)
        return self.text

    def certificate(self, model=None):
        model, body = self.model() if model is None else model, self.body()
        statement = {"certificate": "veritope-certificate-1", "tool": "vmodel_invalid_forge", "claim": self.claim,
                     "subject_sha256": hashlib.sha256(model).hexdigest(), "subject_bytes": len(model), "subject_format": self.subject_format,
                     "body_sha256": hashlib.sha256(body).hexdigest(), "finding": self.kind, "cells": len(self.maps), **self.values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body
