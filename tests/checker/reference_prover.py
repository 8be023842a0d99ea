# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A slow, simple prover for tests of the checkers (docs/certificates/mesh.md, version 1).

It reads a model, searches a certificate by trying everything, and returns it in parts, so that a
test can bend one part before encoding. All decisions are made with Python integers. It believes
that files follow the reading rule; refusing bad files is the checker's business.

    python3 reference_prover.py MODEL OUT [--format F] [--as-indexed] [--identity-order]
                                [--no-separators]
"""
import argparse
import hashlib
import json
import os
import re
import struct
import sys
from fractions import Fraction

RULE_TEXT = (
    "Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, unless "
    "as_indexed is true (STL: always one); vertex ids count first occurrences in file order; "
    "polygons are fans from their first vertex; decimals round to the nearest binary64, ties to "
    "even; binary floats are widened exactly; normals, colours, texture, lines, groups and "
    "attribute bytes are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII "
    "STL are one model; the file is refused unless it yields at least one triangle, finite "
    "coordinates and indices in range.")

STAR_TABLE = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1),
              (0, 1, 1), (0, 1, -1), (1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1)]


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sign(x):
    return (x > 0) - (x < 0)


# ---- Reading ---------------------------------------------------------------------------------

def fan(ids):
    return [(ids[0], ids[i], ids[i + 1]) for i in range(1, len(ids) - 1)]


def read_stl(data):
    n = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else 0
    words = data.removeprefix(b"\xef\xbb\xbf").split(None, 1)
    exact = len(data) >= 84 and len(data) == 84 + 50 * n
    points = []
    if exact or not words or words[0].lower() != b"solid":
        for i in range(n):
            v = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
            points += [v[0:3], v[3:6], v[6:9]]
    else:
        points = [tuple(map(float, m.groups())) for m in re.finditer(
            rb"(?i)\bvertex\s+(\S+)\s+(\S+)\s+(\S+)", data)]
    return points, [(i, i + 1, i + 2) for i in range(0, len(points), 3)]


def read_obj(data):
    text = data.decode("latin-1").replace("\\\r\n", "").replace("\\\n", "").replace("\\\r", "")
    points, faces = [], []
    for line in re.split("[\r\n]", text):
        w = line.split("#")[0].split()
        if w and w[0] == "v":
            points.append(tuple(map(float, w[1:4])))
        elif w and w[0] in ("f", "fo"):
            ids = [int(c.split("/")[0]) for c in w[1:]]
            faces += fan([i - 1 if i > 0 else len(points) + i for i in ids])
    return points, faces


def read_off(data):
    lines = [x.split("#")[0].split() for x in re.split("[\r\n]", data.decode("latin-1"))]
    flat = [w for w in lines if w]
    if len(flat[0]) == 1:
        flat.pop(0)
    else:
        flat[0].pop(0)
    nv, nf = int(flat[0][0]), int(flat[0][1])
    points = [tuple(map(float, w[:3])) for w in flat[1:1 + nv]]
    faces = []
    for w in flat[1 + nv:1 + nv + nf]:
        faces += fan([int(c) for c in w[1:1 + int(w[0])]])
    return points, faces


PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h",
             "ushort": "H", "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I",
             "float": "f", "float32": "f", "double": "d", "float64": "d"}


def read_ply(data):
    eol = b"\r\n" if data[3:5] == b"\r\n" else data[3:4]
    end = data.index(b"end_header" + eol)
    body = end + len(b"end_header" + eol)
    kind, elements = "", []
    for line in data[:end].decode("latin-1").split(eol.decode()):
        w = line.split()
        if w[:1] == ["format"]:
            kind = w[1]
        elif w[:1] == ["element"]:
            elements.append((w[1], int(w[2]), []))
        elif w[:1] == ["property"]:
            elements[-1][2].append(w[1:])
    tokens, place = None, [body]
    if kind == "ascii":
        tokens = iter(data[body:].split())

    def value(kind_name):
        if tokens is not None:
            t = next(tokens)
            return float(t) if PLY_TYPES[kind_name] in "fd" or b"." in t else int(t)
        c = ("<" if "little" in kind else ">") + PLY_TYPES[kind_name]
        v = struct.unpack_from(c, data, place[0])[0]
        place[0] += struct.calcsize(c)
        return v

    points, faces = [], []
    for name, count, properties in elements:
        for _ in range(count):
            point = {}
            for p in properties:
                if p[0] == "list":
                    ids = [value(p[2]) for _ in range(value(p[1]))]
                    if name == "face" and p[3] in ("vertex_indices", "vertex_index"):
                        faces += fan(ids)
                    if name == "tristrips":
                        for s in ",".join(map(str, ids)).split(",-1"):
                            s = [int(c) for c in s.split(",") if c]
                            for k in range(len(s) - 2):
                                a, b, c = s[k + k % 2], s[k + 1 - k % 2], s[k + 2]
                                if len({a, b, c}) == 3:
                                    faces.append((a, b, c))
                else:
                    point[p[1]] = value(p[0])
            if name == "vertex":
                points.append((float(point["x"]), float(point["y"]), float(point["z"])))
    return points, faces


class Model:
    """points: binary64 triples; faces: id triples; ints: the points as integers times 2^E."""

    def __init__(self, data, fmt, as_indexed=False):
        self.data, self.format, self.as_indexed = data, fmt, as_indexed
        read = {"stl": read_stl, "obj": read_obj, "ply": read_ply, "off": read_off}[fmt]
        if fmt != "stl" and data.startswith(b"\xef\xbb\xbf"):
            points, faces = read(data[3:])
        else:
            points, faces = read(data)
        if as_indexed and fmt != "stl":
            self.points = [tuple(c + 0.0 for c in p) for p in points]
            self.faces = faces
        else:
            ids, new = {}, []
            for p in points:
                new.append(ids.setdefault(tuple(c + 0.0 for c in p), len(ids)))
            self.points = list(ids)
            self.faces = [tuple(new[v] for v in f) for f in faces]
        used = {v for f in self.faces for v in f}
        ratios = {v: [c.as_integer_ratio() for c in self.points[v]] for v in used}
        down = max((d for r in ratios.values() for _, d in r), default=1)
        big = [[n * (down // d) for n, d in ratios[v]] if v in used else [0, 0, 0]
               for v in range(len(self.points))]
        up = 0
        for p in big:
            for c in p:
                up |= c
        up = up & -up or 1
        self.ints = [tuple(c // up for c in p) for p in big]
        self.unit = Fraction(up, down)

    def normal(self, f):
        a, b, c = (self.ints[v] for v in self.faces[f])
        return cross(sub(b, a), sub(c, a))

    def shells(self):
        """The shell of each face, and the number of shells."""
        parent = list(range(len(self.faces)))

        def root(f):
            while parent[f] != f:
                parent[f] = parent[parent[f]]
                f = parent[f]
            return f

        seen = {}
        for f, t in enumerate(self.faces):
            for i in range(3):
                g = seen.setdefault(frozenset((t[i], t[(i + 1) % 3])), f)
                a, b = root(f), root(g)
                parent[max(a, b)] = min(a, b)
        number, out = {}, []
        for f in range(len(self.faces)):
            out.append(number.setdefault(root(f), len(number)))
        return out, len(number)


def load(path, fmt=None, as_indexed=False):
    with open(path, "rb") as file:
        data = file.read()
    return Model(data, fmt or os.path.splitext(path)[1][1:].lower(), as_indexed)


# ---- Encoding --------------------------------------------------------------------------------

def u32(*values):
    return struct.pack("<%dI" % len(values), *values)


def varint(v):
    out = bytearray()
    while v > 127:
        out.append(v & 127 | 128)
        v >>= 7
    out.append(v)
    return bytes(out)


def zigzag(z):
    return varint(2 * z if z >= 0 else -2 * z - 1)


def natural(n):
    b = n.to_bytes((n.bit_length() + 7) // 8, "little")
    return u32(len(b)) + b


def statement_of(model, body, claim, extra):
    s = {"certificate": "veritope-certificate-1", "tool": "reference prover", "claim": claim,
         "subject_sha256": hashlib.sha256(model.data).hexdigest(),
         "subject_bytes": len(model.data), "subject_format": model.format,
         "reading_rule": RULE_TEXT, "as_indexed": model.as_indexed,
         "body_sha256": hashlib.sha256(body).hexdigest()}
    s.update(extra)
    return s


def file_of(statement, body):
    return json.dumps(statement, separators=(",", ":")).encode() + b"\n" + body


class Valid:
    """The parts of a mesh-valid-1 certificate."""

    def __init__(self, model):
        self.model = model
        self.faces, self.vertices = len(model.faces), len(model.points)
        self.order = list(range(self.faces))
        self.stars = [0] * self.vertices
        self.vectors = []       # for the codes 14, in order
        self.separators = []    # (gap, (dx, dy, dz))
        self.codes = []
        self.nesting = []
        self.quantities = {}

    def body(self):
        out = b"VTMV" + u32(self.faces, self.vertices, *self.order) + bytes(self.stars)
        out += u32(len(self.vectors))
        for d in self.vectors:
            out += struct.pack("<3i", *d)
        out += u32(len(self.separators))
        for gap, d in self.separators:
            out += varint(gap) + b"".join(zigzag(c) for c in d)
        return out + u32(len(self.codes)) + bytes(self.codes) + bytes(self.nesting)

    def encode(self, body=None, **changes):
        body = self.body() if body is None else body
        s = statement_of(self.model, body, "mesh-valid-1", self.quantities)
        s.update(changes)
        return file_of(s, body)


class Invalid:
    """The parts of a mesh-invalid-1 certificate; witnesses are (rule, bytes of its fields)."""

    def __init__(self, model, witnesses):
        self.model, self.witnesses = model, sorted(witnesses, key=lambda w: w[0])

    def body(self):
        return (b"VTMI" + u32(len(self.model.faces), len(self.model.points), len(self.witnesses)) +
                b"".join(bytes([rule]) + fields for rule, fields in self.witnesses))

    def encode(self, body=None, **changes):
        body = self.body() if body is None else body
        rules = " ".join("M%d" % r for r in sorted({r for r, _ in self.witnesses}))
        s = statement_of(self.model, body, "mesh-invalid-1", {"rules": rules})
        s.update(changes)
        return file_of(s, body)


# ---- Valid -----------------------------------------------------------------------------------

def star_holds(model, v, faces, d):
    """Section 4 for vertex v with its faces and direction d."""
    if not faces or d == (0, 0, 0):
        return False
    g = (0, d[2], -d[1]) if d[1] or d[2] else (0, 0, 1)
    x, s, turns = model.ints, 0, 0
    for f in faces:
        t = model.faces[f]
        i = t.index(v)
        p, q = sub(x[t[(i + 1) % 3]], x[v]), sub(x[t[(i + 2) % 3]], x[v])
        k = sign(dot(cross(p, q), d))
        if k == 0 or k == -s:
            return False
        s = k
        if s < 0:
            p, q = q, p
        turns += dot(g, p) >= 0 and dot(g, q) < 0
    return turns == 1


def star_vector(model, faces):
    """A guess: the sum of the unit normals, plus those again that it does not see from the front."""
    normals = []
    for f in faces:
        n = model.normal(f)
        size = max(abs(c) for c in n) or 1
        n = [float(Fraction(c, size)) for c in n]
        length = sum(c * c for c in n) ** 0.5 or 1
        normals.append([c / length for c in n])
    d = [sum(n[k] for n in normals) for k in range(3)]
    for _ in range(100):
        worst = min(normals, key=lambda n: dot(n, d))
        if dot(worst, d) > 0.01 * max(abs(c) for c in d):
            break
        d = [x + c for x, c in zip(d, worst)]
    size = max(abs(c) for c in d) or 1
    return tuple(round(c / size * 2 ** 20) for c in d)


def find_star(model, v, faces):
    """(code, vector or None)."""
    for i, d in enumerate(STAR_TABLE):
        if star_holds(model, v, faces, d):
            return i + 1, None
    d = star_vector(model, faces)
    return (14, d) if star_holds(model, v, faces, d) else (0, None)


def test(model, d, p, q):
    """The test of section 5: (True, False or None for open, P', Q')."""
    x = model.ints
    dp, dq = [dot(d, x[v]) for v in p], [dot(d, x[v]) for v in q]
    most, least = max(dp), min(dq)
    if most != least:
        return most < least, p, q
    p = list(dict.fromkeys(v for v, c in zip(p, dp) if c == most))
    q = list(dict.fromkeys(v for v, c in zip(q, dq) if c == least))
    k = list(set(p) | set(q))
    if len(k) <= 2:
        return True, p, q
    if len(k) == 3 and any(cross(sub(x[k[1]], x[k[0]]), sub(x[k[2]], x[k[0]]))):
        return True, p, q
    return None, p, q


def axes(model, a, b):
    """The 17 axes of a leaf pair."""
    x = model.ints
    out, edges = [model.normal(a), model.normal(b)], []
    for f in (a, b):
        t = [x[v] for v in model.faces[f]]
        edges.append([sub(t[1], t[0]), sub(t[2], t[1]), sub(t[0], t[2])])
    out += [cross(e, f) for e in edges[0] for f in edges[1]]
    out += [cross(out[0], e) for e in edges[0]]
    return out + [cross(out[1], e) for e in edges[1]]


def find_codes(model, a, b, depth=3):
    """Code bytes that separate triangles a and b, or None."""
    directions = [(i, s) for i in range(17) for s in (1, -1)]
    axis = axes(model, a, b)

    def search(p, q, left):
        still_open = []
        for i, s in directions:
            d = tuple(s * c for c in axis[i])
            answer, p2, q2 = test(model, d, p, q)
            code = i | (32 if s < 0 else 0)
            if answer:
                return [code]
            if answer is None and (len(p2), len(q2)) != (len(p), len(q)):
                still_open.append((code, p2, q2))
        for code, p2, q2 in still_open if left else []:
            rest = search(p2, q2, left - 1)
            if rest:
                return [code | 64] + rest
        return None

    return search(list(model.faces[a]), list(model.faces[b]), depth)


class Tree:
    """The walk of section 5; on_leaf and on_node are asked at steps 4 and 3."""

    def __init__(self, model, order, stars):
        self.model, self.order = model, order
        self.node = {}
        self.star = stars
        if order:
            self.build(0, len(order))

    def build(self, lo, hi):
        if hi - lo == 1:
            t = self.model.faces[self.order[lo]]
            pts = [self.model.points[v] for v in t]
            box = tuple((min(p[k] for p in pts), max(p[k] for p in pts)) for k in range(3))
            common = frozenset(v for v in t if self.star[v])
        else:
            m = lo + (hi - lo) // 2
            ba, ca = self.build(lo, m)
            bb, cb = self.build(m, hi)
            box = tuple((min(i[0], j[0]), max(i[1], j[1])) for i, j in zip(ba, bb))
            common = ca & cb
        self.node[lo, hi] = box, common
        return box, common

    def walk(self, on_node, on_leaf):
        if self.order:
            self.self_pairs((0, len(self.order)), on_node, on_leaf)

    def self_pairs(self, r, on_node, on_leaf):
        lo, hi = r
        if hi - lo == 1:
            return
        m = lo + (hi - lo) // 2
        self.self_pairs((lo, m), on_node, on_leaf)
        self.self_pairs((m, hi), on_node, on_leaf)
        self.cross_pairs((lo, m), (m, hi), on_node, on_leaf)

    def cross_pairs(self, a, b, on_node, on_leaf):
        stack = [(a, b)]
        node = self.node
        while stack:
            a, b = stack.pop()
            (box, common), (other_box, other_common) = node[a], node[b]
            if any(i[1] < j[0] or j[1] < i[0] for i, j in zip(box, other_box)):
                continue
            if not common.isdisjoint(other_common):
                continue
            if on_node(a, b):
                continue
            na, nb = a[1] - a[0], b[1] - b[0]
            if na == 1 and nb == 1:
                on_leaf(self.order[a[0]], self.order[b[0]])
            elif na >= nb:
                m = a[0] + na // 2
                stack += [((m, a[1]), b), ((a[0], m), b)]
            else:
                m = b[0] + nb // 2
                stack += [(a, (m, b[1])), (a, (b[0], m))]


def stab(model, p4, f, u, up):
    """The stab rule for the point p4 / 4: (stabbed, t, nu)."""
    t = [tuple(4 * c for c in model.ints[v]) for v in model.faces[f]]
    p, q = (u + 1) % 3, (u + 2) % 3
    count = 0
    for i in range(3):
        lo, hi = sorted((t[i], t[(i + 1) % 3]), key=lambda x: x[q])
        if lo[q] <= p4[q] < hi[q]:
            count += (hi[p] - lo[p]) * (p4[q] - lo[q]) - (hi[q] - lo[q]) * (p4[p] - lo[p]) > 0
    if count % 2 == 0:
        return False, None, 0
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    side, nu = dot(n, sub(t[0], p4)), sign(n[u])
    return (sign(side) == nu) == up, side, nu


def nesting_depth(model, shell, s, code):
    u, up = code // 2, code % 2 == 0
    vs = {v for f, t in enumerate(model.faces) if shell[f] == s for v in t}
    v = min(vs, key=lambda i: (-model.ints[i][u] if up else model.ints[i][u], i))
    p4 = tuple(4 * c for c in model.ints[v])
    stabs = {}
    for f in range(len(model.faces)):
        if shell[f] != s and stab(model, p4, f, u, up)[0]:
            stabs[shell[f]] = stabs.get(shell[f], 0) + 1
    return sum(n % 2 for n in stabs.values())


def morton_order(model):
    if not model.faces:
        return []
    lo = [min(p[k] for p in model.points) for k in range(3)]
    hi = [max(p[k] for p in model.points) for k in range(3)]

    def code(f):
        out = 0
        for k in range(3):
            c = sum(model.points[v][k] / 3 for v in model.faces[f])
            width = hi[k] / 2 - lo[k] / 2
            cell = int((c / 2 - lo[k] / 2) / width * 1023) if width > 0 else 0
            for bit in range(10):
                out |= (max(0, min(1023, cell)) >> bit & 1) << (3 * bit + k)
        return out

    return sorted(range(len(model.faces)), key=lambda f: (code(f), f))


def quantities(model, shells, bodies):
    used = {v for t in model.faces for v in t}
    edges = {frozenset((t[i], t[(i + 1) % 3])) for t in model.faces for i in range(3)}
    total = 0
    for t in model.faces:
        a, b, c = (model.ints[v] for v in t)
        total += dot(cross(a, b), c)
    volume = abs(Fraction(total, 6) * model.unit ** 3)  # of no solid: a statement can't say so
    return {"vertices": len(used), "edges": len(edges), "faces": len(model.faces),
            "shells": shells, "bodies": bodies,
            "genus": max(0, 2 * shells - len(used) + len(edges) - len(model.faces)) // 2,
            "volume": "%d/%d" % (volume.numerator, volume.denominator)}


def prove_valid(model, morton=True, separators=True, propose=None):
    """A Valid for a model that is a solid; parts that cannot be found stay away (the checker will
    name the condition). propose(a, b) may offer a direction for two ranges of positions."""
    cert = Valid(model)
    if morton:
        cert.order = morton_order(model)
    at = [[] for _ in model.points]
    for f, t in enumerate(model.faces):
        for v in dict.fromkeys(t):
            at[v].append(f)
    for v, faces in enumerate(at):
        if faces:
            cert.stars[v], d = find_star(model, v, faces)
            if d is not None:
                cert.vectors.append(d)
    tree = Tree(model, cert.order, cert.stars)
    state = {"k": 0, "last": -1}

    def directions(a, b):
        if propose is not None:
            d = propose(a, b)
            return [d] if d is not None else []
        if not separators or (b[1] - b[0] == 1 and a[1] - a[0] == 1) or a[1] - a[0] > 64:
            return []
        return [tuple(s * c for c in d) for d in STAR_TABLE for s in (1, -1)]

    def on_node(a, b):
        k, state["k"] = state["k"], state["k"] + 1
        for d in directions(a, b):
            p, q = ([v for i in range(*r) for v in model.faces[cert.order[i]]] for r in (a, b))
            if test(model, d, p, q)[0]:
                cert.separators.append((k - state["last"] - 1, d))
                state["last"] = k
                return True
        return False

    def on_leaf(f, g):
        cert.codes += find_codes(model, f, g) or []

    tree.walk(on_node, on_leaf)
    shell, shells = model.shells()
    bodies = 0
    for s in range(shells):
        vol = sum(dot(cross(*(model.ints[v] for v in t[:2])), model.ints[t[2]])
                  for f, t in enumerate(model.faces) if shell[f] == s)
        if shells > 1:
            depth = 0
            for code in range(6):
                depth = nesting_depth(model, shell, s, code)
                if (vol > 0) == (depth % 2 == 0):
                    break
            cert.nesting.append(code)
            bodies += depth % 2 == 0
        else:
            bodies += 1
    cert.quantities = quantities(model, shells, bodies)
    return cert


# ---- Invalid ---------------------------------------------------------------------------------

def edge_uses(model):
    uses = {}
    for t in model.faces:
        for i in range(3):
            a, b = t[i], t[(i + 1) % 3]
            if len(set(t)) == 3:  # else it has no edge
                uses.setdefault((min(a, b), max(a, b)), []).append((a, b))
    return uses


def fans(model, v):
    groups = []
    for t in model.faces:
        if v in t and len(set(t)) == 3:
            rest = list(t)
            rest.remove(v)
            touching = [g for g in groups if not g.isdisjoint(rest)]
            groups = [g for g in groups if g not in touching] + [set(rest).union(*touching)]
    return len(groups)


def meeting_point(model, f, g):
    """Weights (w, x) of an improper common point of two non-degenerate triangles, or None. Tries
    the ends of the intersection: corners in triangles and edges through triangles."""
    pf, pg = ([model.ints[v] for v in model.faces[h]] for h in (f, g))
    for swap, (s, t) in ((False, (pf, pg)), (True, (pg, pf))):
        n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
        h = [dot(n, sub(c, t[0])) for c in s]
        ends = [([1 if j == i else 0 for j in range(3)]) for i in range(3) if h[i] == 0]
        for i in range(3):
            j = (i + 1) % 3
            if h[i] * h[j] < 0:
                w = [0, 0, 0]
                w[i], w[j] = abs(h[j]), abs(h[i])
                ends.append(w)
        for w in ends:
            total = sum(w)
            point = [sum(w[i] * s[i][k] for i in range(3)) for k in range(3)]  # times total
            # Barycentric coordinates of point / total in t, by areas against n.
            x = []
            for i in range(3):
                b, c = t[(i + 1) % 3], t[(i + 2) % 3]
                x.append(dot(n, cross(sub(c, b), sub(point, tuple(total * k for k in b)))))
            if min(x) < 0 or sum(x) == 0:
                continue
            a, b = (w, x) if not swap else (x, w)
            if any(a[i] and model.faces[f][i] not in model.faces[g] for i in range(3)):
                return a, b
    return None


def winding(model, f, u):
    n = model.normal(f)
    if n[u] == 0:
        return 0
    a, b, c = (model.ints[v] for v in model.faces[f])
    p4 = tuple(2 * a[k] + b[k] + c[k] for k in range(3))
    total = 0
    for g in range(len(model.faces)):
        if g != f:
            hit, side, nu = stab(model, p4, g, u, n[u] > 0)
            if side == 0:
                return 0
            total += hit * nu * sign(n[u])
    return total


def find_witnesses(model):
    """At least one witness of every rule that brute force finds broken."""
    out = []
    n = len(model.faces)
    flat = [len(set(t)) < 3 or not any(model.normal(f)) for f, t in enumerate(model.faces)]
    out += [(1, u32(f)) for f in range(n) if flat[f]]
    seen = {}
    for f, t in enumerate(model.faces):
        g = seen.setdefault(frozenset(t), f)
        if g != f and len(set(t)) == 3:
            out.append((2, u32(g, f)))
    for (a, b), uses in sorted(edge_uses(model).items()):
        if len(uses) == 1:
            out.append((3, u32(a, b)))
        elif len(uses) > 2:
            out.append((4, u32(a, b)))
        elif uses[0] == uses[1]:
            out.append((5, u32(*uses[0])))
    out += [(6, u32(v)) for v in range(len(model.points)) if fans(model, v) > 1]
    pts = model.points
    boxes = [[(min(pts[v][k] for v in t), max(pts[v][k] for v in t)) for k in range(3)]
             for t in model.faces]
    for f in range(n):
        for g in range(f + 1, n):
            if flat[f] or flat[g] or any(i[1] < j[0] or j[1] < i[0]
                                         for i, j in zip(boxes[f], boxes[g])):
                continue
            found = meeting_point(model, f, g)
            if found:
                out.append((7, u32(f, g) + b"".join(natural(w) for w in found[0] + found[1])))
    if not any(r in (1, 3, 4, 5, 7) for r, _ in out):
        for f in range(n):
            for u in range(3):
                if winding(model, f, u):
                    out.append((8, u32(f) + bytes([u])))
                    return out
    return out


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("model")
    parser.add_argument("out")
    parser.add_argument("--format")
    parser.add_argument("--as-indexed", action="store_true")
    parser.add_argument("--identity-order", action="store_true")
    parser.add_argument("--no-separators", action="store_true")
    parser.add_argument("--invalid", action="store_true")
    args = parser.parse_args()
    model = load(args.model, args.format, args.as_indexed)
    if args.invalid:
        cert = Invalid(model, find_witnesses(model))
    else:
        cert = prove_valid(model, not args.identity_order, not args.no_separators)
    with open(args.out, "wb") as file:
        file.write(cert.encode())
    return 0


if __name__ == "__main__":
    sys.exit(main())
