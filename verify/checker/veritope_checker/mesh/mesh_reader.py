# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Meshes as docs/certificates/reading-rule-1.md reads them, section by section."""
import math
import re
import struct

from ..common.errors import Refused

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
        if n < 0:
            raise Refused("off: a face with %d corners" % n)
        if len(words) <= n:
            raise Refused("off: a face with fewer corners than it announces")
        triangles += fan([index(integer(w), num_vertices) for w in words[1:n + 1]])
    return points, triangles

PLY_TYPES = {b"char": "b", b"int8": "b", b"uchar": "B", b"uint8": "B", b"short": "h", b"int16": "h",
             b"ushort": "H", b"uint16": "H", b"int": "i", b"int32": "i", b"uint": "I",
             b"uint32": "I", b"float": "f", b"float32": "f", b"double": "d", b"float64": "d"}
SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "f": 4, "d": 8}

class PlyBody:
    """The values after the header: ASCII tokens, or packed numbers if an endianness is given."""

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
    """For each instance, the values of the wanted properties (those of a list as a sequence)."""
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
