# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Certificates of invalid simplex-spline solids as Python values, for tests that forge them."""
import hashlib
import json
import struct

import dms_files as files

KINDS = ("tet-reversed", "tet-face-overused", "cloud-degenerate", "cloud-no-core", "cloud-inside", "jacobian", "jacobian-zero", "M4", "M6",
         "M7", "M9", "meeting", "crossing", "covering")
# v: varint, b: one byte, r: rational, z: zigzag, p: list of planes
PIECE = "vb" + "r" * 9 + "p"
LEAF = "v" + "r" * 12 + "p"
LAYOUTS = {0: "v", 1: "vbvb", 2: "vbbbb", 5: "rrr", 6: LEAF, 7: "vv", 8: "v", 9: "vbvb" + "r" * 6, 10: "vvrrr",
           11: "r" * 6, 12: 2 * PIECE + "v" * 12 + "z" * 9, 13: LEAF + "rrr"}
WITH_PLANES = (5, 6, 11, 12, 13)


def read_fields(cursor, layout):
    take = {"v": cursor.varint, "b": lambda: cursor.take(1)[0], "r": cursor.rational, "z": cursor.zigzag, "p": cursor.planes}
    return [[token, take[token]()] for token in layout]


def written(token, value):
    if token == "p":
        return files.varint(len(value)) + b"".join(files.rational(x) for plane in value for x in plane)
    return {"v": files.varint, "b": lambda n: bytes([n]), "r": files.rational, "z": files.zigzag}[token](value)


class Body:
    """kind; fields: [token, value] each, in the order of the page; planes: of each face of the boundary, or None."""

    def __init__(self, data):
        c = files.Cursor(data)
        self.magic = c.take(4)
        self.tetrahedra, self.kind = c.u32(), c.take(1)[0]
        self.fields = read_fields(c, LAYOUTS.get(self.kind, "vb" if self.kind == 3 else "vbbbbv"))
        if self.kind == 3:
            for _ in range(self.fields[1][1]):
                self.fields += read_fields(c, "bbbbbr")
        if self.kind == 4:
            self.fields += read_fields(c, "r" * (3 + sum(value for _, value in self.fields[2:5])))
        self.planes = [c.planes() for _ in range(c.u32())] if self.kind in WITH_PLANES else None
        assert c.at == len(data)

    def encode(self):
        out = self.magic + struct.pack("<IB", self.tetrahedra, self.kind) + b"".join(written(*field) for field in self.fields)
        if self.planes is None:
            return out
        return out + struct.pack("<I", len(self.planes)) + b"".join(written("p", planes) for planes in self.planes)


class Proof:
    """A model and its certificate, either of which may be changed."""

    def __init__(self, data, certificate):
        line, body = certificate.split(b"\n", 1)
        self.data, self.statement, self.body = data, json.loads(line), Body(body)

    def certificate(self, body=None, **values):
        """With all hashes right, and the finding of the body."""
        body = self.body.encode() if body is None else body
        named = {"finding": KINDS[self.body.kind], "tetrahedra": self.body.tetrahedra}
        statement = {**self.statement, "subject_sha256": hashlib.sha256(self.data).hexdigest(),
                     "subject_bytes": len(self.data), "body_sha256": hashlib.sha256(body).hexdigest(), **named, **values}
        return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body
