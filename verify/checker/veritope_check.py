#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""veritope_check.py MODEL CERT: does this certificate prove its claim about this model?

Written from docs/certificates/reading-rule-1.md and docs/certificates/mesh.md (version 1) alone.
Python 3.9 or later, standard library only, one file: copy it where you need it. The claims about patches
(docs/certificates/star-box.md, patch-invalid.md, collar.md) need star_box_*.py, patch_invalid_check.py and
collar_*.py beside it; the claims about meshes do not.

Prints `ACCEPT <claim>` (exit 0) or `REJECT <condition>: <why>` (exit 1).  Exit 2: usage; 3: out of
memory; 4: a file cannot be opened, the reading rule refuses the model, or the answer cannot be
printed; 5: a bug of this program.
All decisions are taken on Python integers.  A float only ever holds a coordinate: it is read,
compared and turned into its exact ratio, never added or multiplied.
"""
import hashlib
import importlib
import math
import os
import re
import struct
import sys
from fractions import Fraction

VERSION = ("veritope_check.py 1 (mesh-valid-1, mesh-invalid-1, star-box-1, star-box-turned-1, patch-invalid-1, collar-1;"
           " reading rule v1)")
READING_RULE = (
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless"
    " as_indexed is true (STL: always one); vertex ids count first occurrences in file order;"
    " polygons are fans from their first vertex; decimals round to the nearest binary64, ties to"
    " even; binary floats are widened exactly; normals, colours, texture, lines, groups and"
    " attribute bytes are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII"
    " STL are one model; the file is refused unless it yields at least one triangle, finite"
    " coordinates and indices in range.")

class Refused(Exception):
    """The reading rule refuses the model: exit 4."""

class Reject(Exception):
    """A condition of the certificate pages fails: exit 1."""

    def __init__(self, condition, why):
        super().__init__(condition, why)
        self.condition, self.why = condition, why


# ---------------------------------------------------------------- reading rule, section 1

NUMBER = re.compile(rb"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
INTEGER = re.compile(rb"[+-]?[0-9]+")
WORD = re.compile(rb"[^ \t\x0b\x0c]+")                   # between blanks
TOKEN = re.compile(rb"[^ \t\x0b\x0c\r\n]+")              # between blanks and line ends
REST_OF_LINE = re.compile(rb"[^\r\n]*")
FOREIGN = (b"\xff\xfe", b"\xfe\xff", b"\x00\x00\xfe\xff", b"\x1f\x8b", b"PK\x03\x04",
           b"PK\x05\x06", b"BZh", b"\xfd7zXZ", b"\x28\xb5\x2f\xfd", b"version https://git-lfs")

MAX_TRIANGLES, MAX_VERTICES = 1 << 30, (1 << 32) - 1

def decimal(token):
    """The binary64 nearest to a decimal; float() rounds correctly once the grammar is checked."""
    if not NUMBER.fullmatch(token):
        raise Refused("not a decimal number: %r" % token[:40])
    return finite(float(token))

def finite(value):
    if not math.isfinite(value):
        raise Refused("a coordinate is not finite")
    return value

def integer(token):
    if not INTEGER.fullmatch(token):
        raise Refused("not an integer: %r" % token[:40])
    digits = token.lstrip(b"+-").lstrip(b"0")
    value = int(digits or b"0") if len(digits) < 30 else 10 ** 30      # beyond every valid range
    return -value if token[:1] == b"-" else value

def index(value, num_vertices):
    if not 0 <= value < num_vertices:
        raise Refused("index %d is out of range (%d vertices)" % (value, num_vertices))
    return value

def without_mark(data):
    return data[3:] if data[:3] == b"\xef\xbb\xbf" else data

def fan(corners):
    if len(corners) < 3:
        raise Refused("a face has %d corners" % len(corners))
    return [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]

def read_model(data, fmt, as_indexed):
    """(points, triangles): float triples by id, and id triples in file order."""
    if not data:
        raise Refused("the file is empty")
    if data.startswith(FOREIGN):
        raise Refused("UTF-16/32 text, compressed data or a git-lfs pointer")
    points, triangles = {"stl": read_stl, "obj": read_obj, "ply": read_ply, "off": read_off}[fmt](data)
    if not triangles:
        raise Refused("no triangle")
    if len(triangles) > MAX_TRIANGLES or len(points) >= MAX_VERTICES:
        raise Refused("over a limit of this checker: 2^30 triangles")
    points = [(x or 0.0, y or 0.0, z or 0.0) for x, y, z in points]      # every zero is +0
    if as_indexed and fmt != "stl":
        return points, triangles
    ids, distinct, pack = {}, [], struct.Struct("<3d").pack
    merged = []
    for p in points:
        key = pack(*p)                                      # bytes have a keyed hash, floats have not: a file could
        merged.append(ids.setdefault(key, len(distinct)))   # be made of points of one hash
        if merged[-1] == len(distinct):
            distinct.append(p)
    return distinct, [(merged[a], merged[b], merged[c]) for a, b, c in triangles]


# ---------------------------------------------------------------- reading rule, sections 2 to 5

def read_stl(data):
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else None
    if count is None or len(data) != 84 + 50 * count:
        text = without_mark(data)
        first = TOKEN.search(text)
        if first and first.group().lower() == b"solid":
            return read_ascii_stl(text)
        if count is None or len(data) < 84 + 50 * count:
            raise Refused("stl: the binary body is truncated")
    corners = []
    for c in struct.iter_unpack("<12x9f2x", data[84:84 + 50 * count]):
        corners += ((c[0], c[1], c[2]), (c[3], c[4], c[5]), (c[6], c[7], c[8]))
    for c in corners:
        finite(c[0]), finite(c[1]), finite(c[2])
    return corners, [(i, i + 1, i + 2) for i in range(0, len(corners), 3)]

def read_ascii_stl(text):
    corners, pos = [], 0

    def take(*wanted):
        nonlocal pos
        m = TOKEN.search(text, pos)
        if not m or wanted and m.group().lower() not in wanted:
            raise Refused("stl: %r where %r belongs" % (m and m.group()[:40], wanted))
        pos = m.end()
        return m.group().lower()

    while TOKEN.search(text, pos):
        take(b"solid")
        pos = REST_OF_LINE.match(text, pos).end()
        while take(b"facet", b"endsolid") == b"facet":
            normal = 0
            while take(*(b"outer",) * (normal == 4)) != b"outer":
                normal += 1
            take(b"loop")
            for _ in range(3):
                take(b"vertex")
                corners.append((decimal(take()), decimal(take()), decimal(take())))
            take(b"endloop")
            take(b"endfacet")
        pos = REST_OF_LINE.match(text, pos).end()
    return corners, [(i, i + 1, i + 2) for i in range(0, len(corners), 3)]

def read_obj(data):
    points, faces = [], []
    text = re.sub(rb"\\(\r\n|\r|\n)", b"", without_mark(data))
    for line in re.split(rb"[\r\n]", text):
        words = line.partition(b"#")[0].split()
        if not words:
            continue
        if words[0] == b"v":
            if len(words) < 4:
                raise Refused("obj: a vertex with fewer than three coordinates")
            points.append((decimal(words[1]), decimal(words[2]), decimal(words[3])))
        elif words[0] in (b"f", b"fo"):
            corners = [integer(w.partition(b"/")[0]) for w in words[1:]]
            if 0 in corners:
                raise Refused("obj: index 0")
            faces.append([i - 1 if i > 0 else index(len(points) + i, len(points)) for i in corners])
    triangles = []
    for corners in faces:
        triangles += fan([index(i, len(points)) for i in corners])
    return points, triangles

def read_off(data):
    lines = re.split(rb"[\r\n]", without_mark(data))
    rows = [words for words in (line.partition(b"#")[0].split() for line in lines) if words]
    head, at = [], 0
    while at < len(rows) and len(head) < 3:
        head += rows[at]
        at += 1
    if len(head) < 3 or not re.fullmatch(rb"(ST)?C?N?OFF", head[0]):
        raise Refused("off: no OFF header with two counts")
    num_vertices, num_faces = integer(head[1]), integer(head[2])
    if num_vertices < 0 or num_faces < 0 or num_vertices + num_faces > len(rows) - at:
        raise Refused("off: more lines announced than there are")
    points, triangles = [], []
    for words in rows[at:at + num_vertices]:
        if len(words) < 3:
            raise Refused("off: a vertex with fewer than three coordinates")
        points.append((decimal(words[0]), decimal(words[1]), decimal(words[2])))
    for words in rows[at + num_vertices:at + num_vertices + num_faces]:
        n = integer(words[0])
        if len(words) <= n:
            raise Refused("off: a face with fewer corners than it announces")
        triangles += fan([index(integer(w), num_vertices) for w in words[1:n + 1]])
    return points, triangles

PLY_TYPES = {b"char": "b", b"int8": "b", b"uchar": "B", b"uint8": "B", b"short": "h", b"int16": "h",
             b"ushort": "H", b"uint16": "H", b"int": "i", b"int32": "i", b"uint": "I",
             b"uint32": "I", b"float": "f", b"float32": "f", b"double": "d", b"float64": "d"}
SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "f": 4, "d": 8}

class PlyBody:
    """The values behind the header: ASCII tokens, or packed numbers if an endianness is given."""

    def __init__(self, data, endian):
        self.data, self.endian, self.pos = data if endian else data.split(), endian, 0

    def many(self, n, kind):
        at, self.pos = self.pos, self.pos + n * (SIZES[kind] if self.endian else 1)
        if self.pos > len(self.data):
            raise Refused("ply: the body is truncated")
        if not self.endian:
            return self.data[at:self.pos]
        return struct.unpack_from("%s%d%s" % (self.endian, n, kind), self.data, at)

    def integer(self, value):
        return value if self.endian else integer(value)

    def decimal(self, value):
        return finite(float(value)) if self.endian else decimal(value)

def ply_header(data):
    """(format, elements, offset of the body); element = (name, count, [(name, count type, type)])"""
    first = re.match(rb"ply(\r\n|\r|\n)", data)
    if not first:
        raise Refused("ply: the first line is not `ply`")
    pos, line_end, fmt, elements = first.end(), first.group(1), None, []
    while True:
        end = data.find(line_end, pos)
        line, pos = data[pos:end], end + len(line_end)
        if end < 0 or b"\r" in line or b"\n" in line:
            raise Refused("ply: no end_header, or a header line that ends otherwise than the first")
        words = WORD.findall(line)
        if not words or fmt and words[0] in (b"comment", b"obj_info"):
            continue
        if not fmt:
            if len(words) != 3 or words[0] != b"format" or words[2] != b"1.0" or words[1] not in (
                    b"ascii", b"binary_little_endian", b"binary_big_endian"):
                raise Refused("ply: no known format after `ply`")
            fmt = words[1]
        elif words == [b"end_header"]:
            return fmt, elements, pos
        elif words[0] == b"element" and len(words) == 3:
            elements.append((words[1], integer(words[2]), []))
            if elements[-1][1] < 0:
                raise Refused("ply: a negative count")
        elif words[0] == b"property" and elements and len(words) == 3 and words[1] in PLY_TYPES:
            elements[-1][2].append((words[2], None, PLY_TYPES[words[1]]))
        elif words[:2] == [b"property", b"list"] and elements and len(words) == 5 and (
                PLY_TYPES.get(words[2], "f") not in "fd" and words[3] in PLY_TYPES):
            elements[-1][2].append((words[4], PLY_TYPES[words[2]], PLY_TYPES[words[3]]))
        else:
            raise Refused("ply: header line %r" % b" ".join(words)[:60])

def ply_rows(body, element, wanted):
    """For each instance the values of the wanted properties (a list's values as a sequence)."""
    rows, (_, count, properties) = [], element
    for _ in range(count if properties else 0):
        values = []
        for _, count_kind, kind in properties:
            n = body.integer(body.many(1, count_kind)[0]) if count_kind else 1
            if n < 0:
                raise Refused("ply: a negative list count")
            v = body.many(n, kind)
            values.append(v if count_kind else v[0])
        if wanted:
            rows.append([values[k] for k in wanted])
    return rows

def ply_property(element, names, is_list):
    found = [k for k, p in enumerate(element[2]) if p[0] in names and bool(p[1]) == is_list]
    if len(found) != 1 or is_list and element[2][found[0]][2] in "fd":
        raise Refused("ply: element %r needs one property %r" % (element[0], names))
    return found[0]

def read_ply(data):
    data = without_mark(data)
    fmt, elements, pos = ply_header(data)
    names = [e[0] for e in elements]
    if names.count(b"vertex") != 1 or names.count(b"face") > 1 or names.count(b"tristrips") > 1:
        raise Refused("ply: not one element vertex, or several of face or tristrips")
    body = PlyBody(data[pos:], {b"ascii": "", b"binary_little_endian": "<"}.get(fmt, ">"))
    wanted = {b"vertex": lambda e: [ply_property(e, (c,), False) for c in (b"x", b"y", b"z")],
              b"face": lambda e: [ply_property(e, (b"vertex_indices", b"vertex_index"), True)]}
    wanted[b"tristrips"] = wanted[b"face"]
    wanted = [wanted.get(e[0], lambda e: [])(e) for e in elements]
    points, polygons = [], []
    for element, want in zip(elements, wanted):
        rows = ply_rows(body, element, want)
        if element[0] == b"vertex":
            points = [tuple(map(body.decimal, row)) for row in rows]
        else:
            polygons += [(element[0], list(map(body.integer, row[0]))) for row in rows]
    triangles, n = [], len(points)
    for kind, values in polygons:
        for v in values:
            if not (0 <= v < n or v == -1 and kind == b"tristrips"):
                raise Refused("ply: index %d is out of range" % v)
        triangles += fan(values) if kind == b"face" else strip(values)
    return points, triangles

def strip(values):
    triangles, start = [], 0
    for end in [i for i, v in enumerate(values) if v == -1] + [len(values)]:
        s, start = values[start:end], end + 1
        for k in range(len(s) - 2):
            t = (s[k + 1], s[k], s[k + 2]) if k % 2 else (s[k], s[k + 1], s[k + 2])
            if len(set(t)) == 3:
                triangles.append(t)
    return triangles


# ---------------------------------------------------------------- mesh.md, section 1: the statement

MEMBER = re.compile(r'"([^"\\]*)":(?:"([^"\\]*)"|(0|[1-9][0-9]*)|(true|false))')
HEX64 = r"[0-9a-f]{64}"
COMMON_KEYS = {"certificate": "veritope-certificate-1", "tool": r".{0,200}",
               "subject_sha256": HEX64, "subject_bytes": int, "body_sha256": HEX64}
MESH_KEYS = {"claim": ".*", "subject_format": "stl|obj|ply|off", "reading_rule": r".*", "as_indexed": bool}
PATCH_KEYS = {"claim": ".*", "subject_format": "vjson", "patches": int, "flipped": int}
STAR_KEYS = {**PATCH_KEYS, "edges": int, "vertices": int, "shells": int, "bodies": int, "genus": int, "boxes": int}
CLAIM_KEYS = {
    "mesh-valid-1": {**MESH_KEYS, "vertices": int, "edges": int, "faces": int, "shells": int, "bodies": int,
                     "genus": int, "volume": r"(0|[1-9][0-9]*)/[1-9][0-9]*"},   # lowest terms: V11
    "mesh-invalid-1": {**MESH_KEYS, "rules": r"M[1-9]( M[1-9])*"},
    "star-box-1": STAR_KEYS,
    "star-box-turned-1": {**STAR_KEYS, "winding": int},
    "collar-1": {**STAR_KEYS, "cells": int},
    "patch-invalid-1": {**PATCH_KEYS, "finding": "crossing|side", "same": int, "opposite": int}}
PATCH_MODULES = {"star-box-1": "star_box_check", "star-box-turned-1": "star_box_check", "collar-1": "collar_check",
                 "patch-invalid-1": "patch_invalid_check"}

def parse_statement(cert):
    """(statement, body): S1."""
    end = cert.find(b"\n")
    if not 0 <= end <= 65536:
        raise Reject("S1", "no line feed in the first 64 KiB")
    if any(not 32 <= b <= 126 for b in cert[:end]):
        raise Reject("S1", "a byte that is not printable ASCII")
    line, statement, pos = cert[:end].decode("ascii"), {}, 1
    if not re.fullmatch(r"\{.*\}", line):
        raise Reject("S1", "not a JSON object")
    while True:
        m = MEMBER.match(line, pos)
        if not m or m.group(1) in statement or m.end() >= len(line):
            raise Reject("S1", "not a flat JSON object, or a key twice, at byte %d" % pos)
        key, text, number, boolean = m.groups()
        if number and (len(number) > 20 or int(number) >= 1 << 64):
            raise Reject("S1", "%s is too large" % key)
        statement[key] = text if text is not None else int(number) if number else boolean == "true"
        pos = m.end() + 1
        if line[m.end()] != ",":
            break
    if line[m.end()] != "}" or pos != len(line):
        raise Reject("S1", "text after a member at byte %d" % m.end())
    check_keys(statement)
    return statement, cert[end + 1:]

def check_keys(statement):
    if statement.get("claim") not in CLAIM_KEYS:
        raise Reject("S1", "an unknown claim, or none")
    keys = {**COMMON_KEYS, **CLAIM_KEYS[statement["claim"]]}
    if set(keys) != set(statement):
        raise Reject("S1", "keys missing or unknown: %s" % sorted(set(keys) ^ set(statement)))
    for key, rule in keys.items():
        value = statement[key]
        good = (type(value) is rule if isinstance(rule, type) else
                type(value) is str and re.fullmatch(rule, value))
        if not good:
            raise Reject("S1", "value of %s" % key)
    rules = statement.get("rules", "").split(" ")
    if rules != sorted(set(rules)):
        raise Reject("S1", "rules are not ascending")

def check(model_bytes, cert_bytes):
    """(exit code, line to print) for a model and a certificate given as bytes."""
    return _check(model_bytes, cert_bytes, frozenset())

def _check(model_bytes, cert_bytes, skip):
    """check() with some conditions disabled: for tests only, main() has no way to reach it."""
    try:
        statement, body = parse_statement(cert_bytes)
        if statement.get("reading_rule", READING_RULE) != READING_RULE:
            raise Reject("S2", "another reading rule")
        if (statement["subject_bytes"] != len(model_bytes) or
                statement["subject_sha256"] != hashlib.sha256(model_bytes).hexdigest()):
            raise Reject("S3", "the certificate is about another file")
        if statement["body_sha256"] != hashlib.sha256(body).hexdigest():
            raise Reject("S4", "the body is not the one that the statement names")
        if statement["claim"] in PATCH_MODULES:
            return check_patches(statement, body, model_bytes, skip)
        mesh = Mesh(*read_model(model_bytes, statement["subject_format"], statement["as_indexed"]))
        decide = check_valid if statement["claim"] == "mesh-valid-1" else check_invalid
        decide(statement, Body(body), mesh, skip)
    except Refused as e:
        return 4, "ERROR: the model is refused: %s" % e
    except Reject as e:
        return 1, "REJECT %s: %s" % (e.condition, e.why)
    except MemoryError:
        return 3, "ERROR: out of memory"
    except Exception as e:                                  # our bug: never an ACCEPT
        return 5, "BUG: %s: %s" % (type(e).__name__, e)
    return 0, "ACCEPT " + statement["claim"]

def check_patches(statement, body, model_bytes, skip):
    name = PATCH_MODULES[statement["claim"]]
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    try:
        module = importlib.import_module(name)
    except ImportError as e:
        return 4, "ERROR: the files of %s.py are not beside veritope_check.py: %s" % (name, e)
    finally:
        del sys.path[0]
    return module.check(statement, body, model_bytes, skip)

class Body:
    """A cursor over the body; running out of bytes is B1."""

    def __init__(self, data):
        self.data, self.pos = data, 0

    def bytes(self, n):
        if n > len(self.data) - self.pos:
            raise Reject("B1", "the body ends too early")
        self.pos += n
        return self.data[self.pos - n:self.pos]

    def u8(self):
        return self.bytes(1)[0]

    def u32(self):
        return int.from_bytes(self.bytes(4), "little")

    def count(self, least_size):
        n = self.u32()
        if n * least_size > len(self.data) - self.pos:
            raise Reject("B1", "a count is larger than the body")
        return n

    def array(self, n, kind):
        return list(struct.unpack("<%d%s" % (n, kind), self.bytes(n * struct.calcsize("<" + kind))))

    def varint(self):
        value = shift = 0
        while True:
            byte = self.u8()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                if value >= 1 << 64 or byte == 0 and shift > 7:
                    raise Reject("B1", "a varint is too large or not in shortest form")
                return value
            if shift >= 70:
                raise Reject("B1", "a varint is too long")

    def zigzag(self):
        z = self.varint()
        z = -(z + 1 >> 1) if z & 1 else z >> 1
        if abs(z) >= 1 << 31:
            raise Reject("B1", "a separator component is too large")
        return z

    def header(self, magic, mesh):
        if self.bytes(4) != magic:
            raise Reject("B1", "magic")
        if self.u32() != len(mesh.triangles) or self.u32() != len(mesh.points):
            raise Reject("B1", "F or V differs from the model's")

    def work(self, mesh):
        """How many units of work the certificate may ask for."""
        return 1000 * (len(mesh.triangles) + len(self.data))

    def end(self):
        if self.pos != len(self.data):
            raise Reject("B1", "bytes after the end of the body")

class Mesh:
    """floats: coordinates for comparisons; points: the same as integers, times 2^-E = 1/unit."""

    def __init__(self, floats, triangles):
        self.floats, self.triangles = floats, triangles
        ratios = [[c.as_integer_ratio() for c in p] for p in floats]
        common = max(d for p in ratios for _, d in p)
        scaled = [[n * (common // d) for n, d in p] for p in ratios]
        bits = 0
        for p in scaled:
            bits |= p[0] | p[1] | p[2]
        low = max(bits & -bits, 1)                          # greatest common power of two
        self.points = [(x // low, y // low, z // low) for x, y, z in scaled]
        self.unit = Fraction(low, common)
        self.normals = [cross(sub(self.points[b], self.points[a]), sub(self.points[c], self.points[a]))
                        for a, b, c in triangles]
        self.fans = [[] for _ in floats]                    # at each vertex v: (f, p, q), f = (v, p, q)
        for f, (a, b, c) in enumerate(triangles):
            self.fans[a].append((f, b, c))
            self.fans[b].append((f, c, a))
            self.fans[c].append((f, a, b))

    def corners(self, f):
        return [self.points[v] for v in self.triangles[f]]

def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]

def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

def sign(x):
    return (x > 0) - (x < 0)

def collapsed(t):
    return t[0] == t[1] or t[1] == t[2] or t[2] == t[0]

def directed_edges(triangles):
    """How often each directed edge occurs."""
    count = {}
    for a, b, c in triangles:
        for edge in ((a, b), (b, c), (c, a)):
            count[edge] = count.get(edge, 0) + 1
    return count

def shells_of(triangles):
    """(shell number of each triangle, number of undirected edges)"""
    parent, first = list(range(len(triangles))), {}

    def root(f):
        while parent[f] != f:
            parent[f] = f = parent[parent[f]]
        return f

    for f, (a, b, c) in enumerate(triangles):
        for u, v in ((a, b), (b, c), (c, a)):
            g = first.setdefault((u, v) if u < v else (v, u), f)
            if g != f:
                r, s = root(f), root(g)
                parent[max(r, s)] = min(r, s)
    numbers = {}
    return [numbers.setdefault(root(f), len(numbers)) for f in range(len(triangles))], len(first)

def line_stabs(t, v, u):
    """Section 6: does the line along axis u through v, moved by (e, e^2), stab triangle t?"""
    p, q = (u + 1) % 3, (u + 2) % 3
    vp, vq, odd = v[p], v[q], False
    for l, h in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
        if l[q] > h[q]:
            l, h = h, l
        if l[q] <= vq < h[q] and (h[p] - l[p]) * (vq - l[q]) - (h[q] - l[q]) * (vp - l[p]) > 0:
            odd = not odd
    return odd


# ---------------------------------------------------------------- mesh.md, sections 3 to 6: valid

DIRECTIONS = (None, (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1),
              (0, 1, 1), (0, 1, -1), (1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1))
TOO_MUCH_WORK = "more work than the certificate's size allows"

def check_valid(statement, body, mesh, skip):
    cert = ValidBody(body, mesh)
    for condition, holds in (("V1", v1_order), ("V2", v2_distinct), ("V3", v3_not_degenerate),
                             ("V4", v4_edges), ("V5", v5_no_duplicates), ("V6", v6_one_cycle),
                             ("V7", v7_stars)):
        why = holds(cert, mesh)
        if why and condition not in skip:
            raise Reject(condition, why)
    walk = Walk(cert, mesh, skip)
    walk.run()                                                                  # V8, V9
    found = Nesting(cert, mesh, walk, skip).quantities()                        # V10
    for key in sorted(found):
        if statement[key] != found[key] and "V11" not in skip:
            raise Reject("V11", "%s: stated %s, computed %s" % (key, statement[key], found[key]))

class ValidBody:
    """The fields of section 3: B1."""

    def __init__(self, body, mesh):
        body.header(b"VTMV", mesh)
        self.work = body.work(mesh)
        self.order = body.array(len(mesh.triangles), "I")
        self.stars = list(body.bytes(len(mesh.points)))
        if max(self.stars) > 14:
            raise Reject("B1", "a star code is above 14")
        at = body.array(3 * body.count(12), "i")
        if len(at) != 3 * self.stars.count(14):
            raise Reject("B1", "not one star vector for each star code 14")
        vectors = iter(zip(at[::3], at[1::3], at[2::3]))
        self.star_directions = [next(vectors) if c == 14 else DIRECTIONS[c] for c in self.stars]
        self.separators, k = [], -1
        for _ in range(body.count(4)):
            k += 1 + body.varint()
            self.separators.append((k, (body.zigzag(), body.zigzag(), body.zigzag())))
        self.codes = body.bytes(body.count(1))
        self.shell_of, self.edges = shells_of(mesh.triangles)
        self.num_shells = max(self.shell_of) + 1
        self.nesting = body.bytes(self.num_shells) if self.num_shells > 1 else b""
        if any(c > 5 for c in self.nesting):
            raise Reject("B1", "a nesting code is above 5")
        body.end()

def v1_order(cert, mesh):
    if sorted(cert.order) != list(range(len(mesh.triangles))):
        return "order is not a permutation"

def v2_distinct(cert, mesh):
    seen = {}
    for v, fan_at_v in enumerate(mesh.fans):
        if fan_at_v and seen.setdefault(mesh.floats[v], v) != v:
            return "vertices %d and %d have equal coordinates" % (seen[mesh.floats[v]], v)

def v3_not_degenerate(cert, mesh):
    if (0, 0, 0) in mesh.normals:                           # so it is if two of the ids are equal
        return "triangle %d is degenerate" % mesh.normals.index((0, 0, 0))

def v4_edges(cert, mesh):
    count = directed_edges(mesh.triangles)
    for (a, b), n in count.items():
        if n != 1 or (b, a) not in count:
            return "directed edge (%d, %d): %d, its reverse: %d" % (a, b, n, count.get((b, a), 0))

def v5_no_duplicates(cert, mesh):
    seen = {}
    for f, t in enumerate(mesh.triangles):
        if seen.setdefault(tuple(sorted(t)), f) != f:
            return "triangles %d and %d have the same vertices" % (seen[tuple(sorted(t))], f)

def v6_one_cycle(cert, mesh):
    for v, fan_at_v in enumerate(mesh.fans):
        link = {}                                           # p -> the q with a triangle v, p, q
        for _, p, q in fan_at_v:
            link.setdefault(p, []).append(q)
            link.setdefault(q, []).append(p)
        if not link:
            continue
        if any(len(ends) != 2 for ends in link.values()):
            return "the triangles at vertex %d form no cycle" % v
        start = here = fan_at_v[0][1]
        before, steps = link[start][1], 0
        while steps == 0 or here != start:
            a, b = link[here]
            before, here, steps = here, (b if a == before else a), steps + 1
        if steps != len(link):
            return "the triangles at vertex %d form several cycles" % v

def v7_stars(cert, mesh):
    points, normals = mesh.points, mesh.normals
    for v, d in enumerate(cert.star_directions):
        if d is None:
            continue
        dx, dy, dz = d
        gy, gz = (dz, -dy) if dy or dz else (0, 1)
        _, vy, vz = points[v]
        s = turns = 0
        for f, p, q in mesh.fans[v]:
            nx, ny, nz = normals[f]
            nd = nx * dx + ny * dy + nz * dz
            if not nd or s and (nd > 0) != (s > 0):
                return "vertex %d: normals do not all point to one side" % v        # (a)
            s = nd
            if nd < 0:
                p, q = q, p
            _, py, pz = points[p]
            if gy * (py - vy) + gz * (pz - vz) >= 0:
                _, qy, qz = points[q]
                if gy * (qy - vy) + gz * (qz - vz) < 0:
                    turns += 1
        if turns != 1:                                      # (b); unreferenced: 0
            return "vertex %d: its triangles turn %d times around it" % (v, turns)

def compare(d, ps, qs, points):
    """Test of a direction: 0 it fails, 1 it holds, or the open pair (P', Q')."""
    dx, dy, dz = d
    up = [dx * x + dy * y + dz * z for x, y, z in map(points.__getitem__, ps)]
    uq = [dx * x + dy * y + dz * z for x, y, z in map(points.__getitem__, qs)]
    hi, lo = max(up), min(uq)
    if hi != lo:
        return 1 if hi < lo else 0
    p2 = [i for i, s in zip(ps, up) if s == hi]
    q2 = [i for i, s in zip(qs, uq) if s == lo]
    k = list(set(p2 + q2))
    if len(k) <= 2 or len(k) == 3 and any(cross(sub(points[k[1]], points[k[0]]),
                                                sub(points[k[2]], points[k[0]]))):
        return 1
    return p2, q2

class Walk:
    """Section 5.  Node i of the tree has the children 2i and 2i + 1; the root is 1."""

    def __init__(self, cert, mesh, skip):
        self.cert, self.mesh, self.skip, self.used_codes = cert, mesh, skip, 0
        self.wrong = {"V8": None, "V9": None}               # the first failure of each
        nodes = 2 << (len(cert.order) - 1).bit_length()
        self.first, self.size, self.common = [0] * nodes, [0] * nodes, [frozenset()] * nodes
        self.boxes = [([None] * nodes, [None] * nodes) for _ in range(3)]
        self.size[1] = len(cert.order)
        for i in range(1, nodes // 2):
            n, half = self.size[i], self.size[i] // 2
            if n > 1:
                self.first[2 * i], self.size[2 * i] = self.first[i], half
                self.first[2 * i + 1], self.size[2 * i + 1] = self.first[i] + half, n - half
        for i in range(nodes - 1, 0, -1):
            if self.size[i] == 1:
                t = mesh.triangles[cert.order[self.first[i]]]
                self.common[i] = frozenset(v for v in t if cert.stars[v])
                for (least, greatest), c in zip(self.boxes, zip(*[mesh.floats[v] for v in t])):
                    least[i], greatest[i] = min(c), max(c)
            elif self.size[i]:
                self.common[i] = self.common[2 * i] & self.common[2 * i + 1]
                for least, greatest in self.boxes:
                    least[i] = min(least[2 * i], least[2 * i + 1])
                    greatest[i] = max(greatest[2 * i], greatest[2 * i + 1])

    def run(self):
        todo, nodes = [1], []
        while todo:                                         # self(N): left, right, then N itself
            i = todo.pop()
            if self.size[i] > 1:
                nodes.append(i)
                todo += (2 * i, 2 * i + 1)
        self.cross_all(reversed(nodes))
        if not self.wrong["V9"] and self.used_codes != len(self.cert.codes):
            self.wrong["V9"] = "a code is not used"
        for condition in ("V8", "V9"):
            if self.wrong[condition] and condition not in self.skip:
                raise Reject(condition, self.wrong[condition])

    def cross_all(self, nodes):
        size, common = self.size, self.common
        (x0, x1), (y0, y1), (z0, z1) = self.boxes
        separators = iter(self.cert.separators)
        index, d = next(separators, (-1, None))             # the next unused separator
        reached, work = 0, self.cert.work
        for node in nodes:
            stack = [2 * node, 2 * node + 1]
            while stack:
                b, a = stack.pop(), stack.pop()
                work -= 1
                if work < 0:
                    raise Reject("B1", TOO_MUCH_WORK)
                if (x1[a] < x0[b] or x1[b] < x0[a] or y1[a] < y0[b] or y1[b] < y0[a] or
                        z1[a] < z0[b] or z1[b] < z0[a]):                        # step 1
                    continue
                if common[a] and not common[a].isdisjoint(common[b]):           # step 2
                    continue
                if reached == index:                                            # step 3
                    work -= size[a] + size[b]
                    self.separator(d, a, b)
                    index, d = next(separators, (-1, None))
                elif size[a] == 1 == size[b]:                                   # step 4
                    self.leaf_pair(self.cert.order[self.first[a]], self.cert.order[self.first[b]])
                elif size[a] >= size[b]:                                        # step 5
                    stack += (2 * a + 1, b, 2 * a, b)
                else:
                    stack += (a, 2 * b + 1, a, 2 * b)
                reached += 1
        if work < 0:
            raise Reject("B1", TOO_MUCH_WORK)
        if d is not None and not self.wrong["V8"]:
            self.wrong["V8"] = "a separator is not used"

    def separator(self, d, a, b):
        ps, qs = [list({v for f in self.cert.order[self.first[n]:self.first[n] + self.size[n]]
                        for v in self.mesh.triangles[f]}) for n in (a, b)]
        if not self.wrong["V8"] and compare(d, ps, qs, self.mesh.points) != 1:
            self.wrong["V8"] = "separator %s does not hold" % (d,)

    def axis(self, code, a, b):
        na, nb = self.mesh.normals[a], self.mesh.normals[b]
        ea, eb = [[sub(t[i - 2], t[i]) for i in range(3)] for t in (self.mesh.corners(a), self.mesh.corners(b))]
        if code < 2:
            return (na, nb)[code]
        if code < 11:
            return cross(ea[(code - 2) // 3], eb[(code - 2) % 3])
        return cross(na, ea[code - 11]) if code < 14 else cross(nb, eb[code - 14])

    def leaf_pair(self, a, b):
        if not self.wrong["V9"] and not self.codes_hold(a, b):
            self.wrong["V9"] = "triangles %d and %d are not shown to meet properly" % (a, b)

    def codes_hold(self, a, b):
        pair = self.mesh.triangles[a], self.mesh.triangles[b]
        for _ in range(4):                                  # at most four bytes
            if self.used_codes == len(self.cert.codes):
                return False
            code = self.cert.codes[self.used_codes]
            self.used_codes += 1
            if code & 128 or code & 31 > 16:
                return False
            d = self.axis(code & 31, a, b)
            if code & 32:
                d = -d[0], -d[1], -d[2]
            result = compare(d, pair[0], pair[1], self.mesh.points)
            if result in (0, 1) or not code & 64:
                return result == 1 and not code & 64
            pair = result
        return False

class Nesting:
    """Section 6: V10 and the quantities.  walk: the box tree."""

    def __init__(self, cert, mesh, walk, skip):
        self.cert, self.mesh, self.walk, self.skip, self.work = cert, mesh, walk, skip, cert.work
        self.faces = [[] for _ in range(cert.num_shells)]
        for f, s in enumerate(cert.shell_of):
            self.faces[s].append(f)
        self.vertices = [{v for f in faces for v in mesh.triangles[f]} for faces in self.faces]
        self.six_volumes = [sum(dot(mesh.points[mesh.triangles[f][0]], mesh.normals[f]) for f in faces)
                            for faces in self.faces]

    def fail(self, why):
        if "V10" not in self.skip:
            raise Reject("V10", why)

    def depth(self, s):
        if len(self.faces) == 1:
            return 0
        u, minus = divmod(self.cert.nesting[s], 2)
        extreme = (min if minus else max)(self.mesh.points[v][u] for v in self.vertices[s])
        v = min(v for v in self.vertices[s] if self.mesh.points[v][u] == extreme)
        odd = set()                                         # the shells stabbed an odd number of times
        for f in self.leaves(v, u, minus):
            if self.cert.shell_of[f] != s and self.stabs(f, v, u, minus):
                odd ^= {self.cert.shell_of[f]}
        return len(odd)

    def leaves(self, v, u, minus):
        """The triangles of the leaves that the ray from v reaches: ray(root)."""
        at, walk = self.mesh.floats[v], self.walk
        vu, vp, vq = at[u], at[(u + 1) % 3], at[(u + 2) % 3]
        (lo, hi), (plo, phi), (qlo, qhi) = [walk.boxes[(u + k) % 3] for k in range(3)]
        stack = [1]
        while stack:
            i = stack.pop()
            self.work -= 1
            if self.work < 0:
                raise Reject("B1", TOO_MUCH_WORK)
            if (plo[i] <= vp < phi[i] and qlo[i] <= vq < qhi[i] and
                    (lo[i] <= vu if minus else hi[i] >= vu)):
                if walk.size[i] == 1:
                    yield self.cert.order[walk.first[i]]
                else:
                    stack += (2 * i + 1, 2 * i)

    def stabs(self, f, v, u, minus):
        mesh, at = self.mesh, self.mesh.points[v]
        corners = mesh.corners(f)
        if not line_stabs(corners, at, u):
            return False
        t = dot(mesh.normals[f], sub(corners[0], at))
        if t == 0:
            self.fail("the ray from vertex %d starts in triangle %d" % (v, f))
        return sign(t) == (-sign(mesh.normals[f][u]) if minus else sign(mesh.normals[f][u]))

    def quantities(self):
        depths = []
        for s, volume in enumerate(self.six_volumes):
            depths.append(self.depth(s))
            if sign(volume) != (-1 if depths[s] % 2 else 1):
                self.fail("shell %d of depth %d has no volume or the wrong side out" % (s, depths[s]))
        num_vertices, num_faces = sum(map(len, self.vertices)), len(self.mesh.triangles)
        volume = Fraction(sum(self.six_volumes), 6) * self.mesh.unit ** 3
        return {"vertices": sum(1 for fan_at_v in self.mesh.fans if fan_at_v),
                "edges": self.cert.edges, "faces": num_faces, "shells": len(depths),
                "bodies": sum(1 for depth in depths if depth % 2 == 0),
                "genus": (2 * len(depths) - num_vertices + self.cert.edges - num_faces) // 2,
                "volume": "%d/%d" % (volume.numerator, volume.denominator)}


# ---------------------------------------------------------------- mesh.md, section 7: invalid

INVALID_FIELDS = {1: "f", 2: "ff", 3: "vv", 4: "vv", 5: "vv", 6: "v", 7: "ffnnnnnn", 8: "fu", 9: "fu"}

def check_invalid(statement, body, mesh, skip):
    witnesses, last = [], 0
    body.header(b"VTMI", mesh)
    count = body.u32()
    if not 1 <= count <= len(body.data):
        raise Reject("B1", "no witness, or a count larger than the body")
    for _ in range(count):
        rule = body.u8()
        if rule not in INVALID_FIELDS or rule < last:
            raise Reject("B1", "an unknown rule, or rules not ascending")
        witnesses.append((rule, [read_field(body, mesh, kind) for kind in INVALID_FIELDS[rule]]))
        last = rule
    body.end()
    allowed = body.work(mesh)
    directed = directed_edges([t for t in mesh.triangles if not collapsed(t)])
    for fan_at_v in mesh.fans:                              # such triangles are at no vertex
        fan_at_v[:] = [entry for entry in fan_at_v if not collapsed(mesh.triangles[entry[0]])]
    holds = {1: i1_degenerate, 2: i2_duplicate, 3: i3_boundary, 4: i4_crowded, 5: i5_misoriented,
             6: i6_fans, 7: i7_intersection, 8: i8_winding, 9: i8_winding}
    for rule, fields in witnesses:
        allowed -= work_of(rule, mesh, fields)
        if allowed < 0:
            raise Reject("B1", TOO_MUCH_WORK)
        if not holds[rule](mesh, directed, *fields) and "I%d" % rule not in skip:
            raise Reject("I%d" % rule, "witness %s of rule M%d proves nothing" % (fields[:2], rule))
    rules = " ".join("M%d" % r for r in sorted({r for r, _ in witnesses}))
    if statement["rules"] != rules and "I10" not in skip:
        raise Reject("I10", "the statement lists %s, the witnesses %s" % (statement["rules"], rules))

def work_of(rule, mesh, fields):
    """What section 7 counts for a witness."""
    if rule in (3, 4, 5, 6):
        return min(len(mesh.fans[v]) for v in fields)
    return len(mesh.triangles) if rule > 7 else 0

def read_field(body, mesh, kind):
    if kind == "n":
        size = body.u32()
        if size > 4096:
            raise Reject("B1", "a natural number of %d bytes" % size)
        data = body.bytes(size)
        if data and data[-1] == 0:
            raise Reject("B1", "a natural number with a leading zero")
        return int.from_bytes(data, "little")
    value = body.u8() if kind == "u" else body.u32()
    if value >= {"u": 3, "f": len(mesh.triangles), "v": len(mesh.points)}[kind]:
        raise Reject("B1", "an index is out of range")
    return value

def i1_degenerate(mesh, _, f):
    return mesh.normals[f] == (0, 0, 0)                     # so it is if two of the ids are equal

def i2_duplicate(mesh, _, f, g):
    f_set = set(mesh.triangles[f])
    return f != g and len(f_set) == 3 and f_set == set(mesh.triangles[g])

def uses(directed, a, b):
    return directed.get((a, b), 0) + directed.get((b, a), 0)

def i3_boundary(_, directed, a, b):
    return uses(directed, a, b) == 1

def i4_crowded(_, directed, a, b):
    return uses(directed, a, b) >= 3

def i5_misoriented(_, directed, a, b):
    return uses(directed, a, b) == 2 == directed.get((a, b), 0)

def i6_fans(mesh, _, v):
    neighbours = {}                                         # in the link of v: paths and circles of its edges p q
    for _, p, q in mesh.fans[v]:
        neighbours.setdefault(p, []).append(q)
        neighbours.setdefault(q, []).append(p)
    reached = {next(iter(neighbours))} if neighbours else set()
    todo = list(reached)
    while todo:
        for q in neighbours[todo.pop()]:
            if q not in reached:
                reached.add(q)
                todo.append(q)
    return len(reached) < len(neighbours)

def i7_intersection(mesh, _, f, g, *weights):
    if f == g or (0, 0, 0) in (mesh.normals[f], mesh.normals[g]):
        return False
    w, x = weights[:3], weights[3:]
    if sum(w) == 0 or sum(x) == 0:
        return False
    for at_f, at_g in zip(zip(*mesh.corners(f)), zip(*mesh.corners(g))):            # x, y, z
        if sum(x) * dot(w, at_f) != sum(w) * dot(x, at_g):
            return False
    return any(w[i] > 0 and mesh.triangles[f][i] not in mesh.triangles[g] for i in range(3))

def i8_winding(mesh, _, f, u):
    outward = sign(mesh.normals[f][u])
    if outward == 0:
        return False
    at = [2 * a + b + c for a, b, c in zip(*mesh.corners(f))]                       # 4 P
    w = 0
    for g in range(len(mesh.triangles)):
        corners = [[4 * c for c in p] for p in mesh.corners(g)]
        if g != f and line_stabs(corners, at, u):
            t = dot(mesh.normals[g], sub(corners[0], at))
            if t == 0:
                return False
            if sign(t) == sign(mesh.normals[g][u]) * outward:
                w += sign(mesh.normals[g][u]) * outward
    return w != 0


# ---------------------------------------------------------------- command line

def main(argv):
    if argv[1:] in (["--help"], ["-h"], ["--version"]):
        return say(VERSION if argv[1] == "--version" else __doc__.strip(), 0)
    if len(argv) != 3 or any(a.startswith("--") for a in argv[1:]):
        print("usage: veritope_check.py MODEL CERT", file=sys.stderr)
        return 2
    try:
        data = []
        for name in argv[1:]:
            with open(name, "rb") as file:
                data.append(file.read())
    except OSError as e:
        return say("ERROR: %s" % e, 4)
    except MemoryError:
        return say("ERROR: out of memory", 3)
    code, message = check(data[0], data[1])
    return say(message, code)

def say(message, code):
    """The exit code; an answer that is not printed is none."""
    try:
        print(message, file=sys.stdout if code < 2 else sys.stderr, flush=True)
        return code
    except OSError:
        os._exit(4)                                         # not even the interpreter's own flush

if __name__ == "__main__":
    sys.exit(main(sys.argv))
