# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Reference prover for small meshes, honest by default and able to lie in one chosen place.

It shares no code with the checkers: its own exact geometry (integers and fractions), its own walk
over the box tree, its own truth oracle.  Attack generators use it to make certificates of which
everything is right (hashes, counts, order of codes, quantities) except the one false claim.
"""
import hashlib
import json
import math
import random
import struct
from fractions import Fraction

READING_RULE = """Reading rule v1: vertices with equal coordinates are one vertex, -0 equals +0, \
unless as_indexed is true (STL: always one); vertex ids count first occurrences in file order; \
polygons are fans from their first vertex; decimals round to the nearest binary64, ties to even; \
binary floats are widened exactly; normals, colours, texture, lines, groups and attribute bytes \
are ignored; unreferenced vertices are ignored; all solid blocks of an ASCII STL are one model; \
the file is refused unless it yields at least one triangle, finite coordinates and indices in \
range."""
STAR_TABLE = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1),
              (0, 1, 1), (0, 1, -1), (1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1)]
FORMATS = ("stl", "obj", "ply", "off")


# ---------------------------------------------------------------- vectors

def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def neg(a):
    return (-a[0], -a[1], -a[2])


def to_i32(d, limit=(1 << 31) - 1):
    """The direction d scaled down (rounding) until its components fit, or None if zero."""
    big = max(abs(c) for c in d)
    if big == 0:
        return None
    if big <= limit:
        return tuple(int(c) for c in d)
    return tuple(int(c * limit // big) for c in d)


# ---------------------------------------------------------------- models and their readings

class Model:
    """What a file says: positions (floats), triangles, file format, merged or as indexed."""

    def __init__(self, points, tris, fmt="off", as_indexed=False, variant=0):
        self.points = [tuple(float(c) for c in p) for p in points]
        self.tris = [tuple(t) for t in tris]
        self.fmt, self.as_indexed, self.variant = fmt, as_indexed, variant

    def copy(self, **changes):
        m = Model(self.points, self.tris, self.fmt, self.as_indexed, self.variant)
        for key, value in changes.items():
            setattr(m, key, value)
        return m

    def encode(self):
        return {"stl": encode_stl, "obj": encode_obj, "ply": encode_ply, "off": encode_off}[self.fmt](self)

    def reading(self):
        """(points, triangles) by the reading rule, computed from this object, not from the bytes."""
        points, tris = self.points, self.tris
        if self.fmt == "stl":
            points = [points[v] for t in tris for v in t]
            tris = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(tris))]
        if self.as_indexed and self.fmt != "stl":
            return points, tris
        rank, ids = {}, []
        for p in points:
            ids.append(rank.setdefault(p, len(rank)))
        return list(rank), [tuple(ids[v] for v in t) for t in tris]


def is_f32(points):
    try:
        return all(struct.unpack("<f", struct.pack("<f", c))[0] == c for p in points for c in p)
    except OverflowError:
        return False


def encode_stl(m):
    corners = [[m.points[v] for v in t] for t in m.tris]
    if m.variant % 3 and is_f32(m.points):
        out = [b"x" * 80 + struct.pack("<I", len(corners))]
        for t in corners:
            out.append(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 7))
        return b"".join(out)
    lines = ["solid s"]
    for t in corners:
        lines += ["facet normal 0 0 1", " outer loop"]
        lines += ["  vertex %r %r %r" % p for p in t] + [" endloop", "endfacet"]
    return "\n".join(lines + ["endsolid s", ""]).encode()


def encode_obj(m):
    lines = ["# obj", "o thing"] + ["v %r %r %r" % p for p in m.points]
    n = len(m.points)
    for t in m.tris:
        if m.variant % 3 == 1:
            lines.append("f " + " ".join("%d" % (v - n) for v in t))
        elif m.variant % 3 == 2:
            lines.append("f " + " ".join("%d//1" % (v + 1) for v in t))
        else:
            lines.append("f " + " ".join("%d" % (v + 1) for v in t))
    return "\n".join(lines + [""]).encode()


def encode_off(m):
    lines = ["OFF", "%d %d 0" % (len(m.points), len(m.tris))] + ["%r %r %r" % p for p in m.points]
    return "\n".join(lines + ["3 %d %d %d" % t for t in m.tris] + [""]).encode()


def encode_ply(m):
    kind = m.variant % 3
    f32 = is_f32(m.points)
    head = ["ply", "format %s 1.0" % ("ascii", "binary_little_endian", "binary_big_endian")[kind],
            "comment forge", "element vertex %d" % len(m.points)]
    head += ["property %s %s" % ("float" if f32 else "double", c) for c in "xyz"]
    head += ["element face %d" % len(m.tris), "property list uchar int vertex_indices", "end_header", ""]
    head = "\n".join(head).encode()
    if kind == 0:
        body = "".join(["%r %r %r\n" % p for p in m.points] + ["3 %d %d %d\n" % t for t in m.tris])
        return head + body.encode()
    e = "<" if kind == 1 else ">"
    return head + b"".join([struct.pack(e + ("3f" if f32 else "3d"), *p) for p in m.points] +
                           [struct.pack(e + "B3i", 3, *t) for t in m.tris])


class Mesh:
    """A reading with exact integer coordinates."""

    def __init__(self, points, tris):
        self.floats, self.tris = points, tris
        exact = [[Fraction(c) for c in p] for p in points]
        unit = max([c.denominator for p in exact for c in p])
        ints = [tuple(int(c * unit) for c in p) for p in exact]
        g = math.gcd(*[c for p in ints for c in p]) or 1
        g &= -g
        self.p = [(x // g, y // g, z // g) for x, y, z in ints]
        self.unit = Fraction(g, unit)
        self.n = [cross(sub(self.p[b], self.p[a]), sub(self.p[c], self.p[a])) for a, b, c in tris]
        self.box = [tuple((min(self.p[a][k], self.p[b][k], self.p[c][k]),
                           max(self.p[a][k], self.p[b][k], self.p[c][k])) for k in range(3))
                    for a, b, c in tris]
        self.at = {}
        for f, t in enumerate(tris):
            for v in set(t):
                self.at.setdefault(v, []).append(f)
        self.codes = {}                                   # (a, b) -> honest chain, a cache

    def apart(self, a, b):
        return any(x[1] < y[0] or y[1] < x[0] for x, y in zip(self.box[a], self.box[b]))


def mesh_of(model):
    return Mesh(*model.reading())


# ---------------------------------------------------------------- truth: which rules a mesh breaks

def barycentric(mesh, f, p):
    """Barycentric coordinates (fractions) of a point in the plane of f, or None if not in f."""
    a, b, c = (mesh.p[v] for v in mesh.tris[f])
    n = mesh.n[f]
    k = max(range(3), key=lambda i: abs(n[i]))
    i, j = (k + 1) % 3, (k + 2) % 3

    def area(u, v):
        return (u[i] - p[i]) * (v[j] - p[j]) - (u[j] - p[j]) * (v[i] - p[i])

    w = [Fraction(area(b, c)) / n[k], Fraction(area(c, a)) / n[k], Fraction(area(a, b)) / n[k]]
    return w if min(w) >= 0 else None


def edge_points(mesh, f, g):
    """The extreme points of f and g's intersection that lie on edges of f (fractions)."""
    n, o = mesh.n[g], mesh.p[mesh.tris[g][0]]
    t = [mesh.p[v] for v in mesh.tris[f]]
    h = [dot(n, sub(p, o)) for p in t]
    for i in range(3):
        s, e, hs, he = t[i], t[(i + 1) % 3], h[i], h[(i + 1) % 3]
        if hs == 0 and mesh.tris[f][i] not in mesh.tris[g]:      # a common vertex proves nothing
            yield s
        if hs * he < 0:
            u = Fraction(hs, hs - he)
            yield tuple(s[k] + u * (e[k] - s[k]) for k in range(3))
        elif hs == 0 == he:
            yield from coplanar_crossings(mesh, s, e, g)


def coplanar_crossings(mesh, s, e, g):
    n = mesh.n[g]
    t = [mesh.p[v] for v in mesh.tris[g]]
    for i in range(3):
        a, b = t[i], t[(i + 1) % 3]
        m = cross(n, sub(b, a))                           # in the plane, across the edge a b
        hs, he = dot(m, sub(s, a)), dot(m, sub(e, a))
        if hs * he < 0:
            u = Fraction(hs, hs - he)
            yield tuple(s[k] + u * (e[k] - s[k]) for k in range(3))


def degenerate(mesh, f):
    return len(set(mesh.tris[f])) < 3 or mesh.n[f] == (0, 0, 0)


def crossing_witness(mesh, f, g):
    """(f, g, w, x) with integer weights as rule M7 wants them, or None if f, g meet properly."""
    if mesh.apart(f, g):
        return None
    for a, b in ((f, g), (g, f)):
        h = [dot(mesh.n[b], sub(mesh.p[v], mesh.p[mesh.tris[b][0]])) for v in mesh.tris[a]]
        if min(h) > 0 or max(h) < 0:
            return None                                   # a is on one side of b's plane
    for a, b in ((f, g), (g, f)):
        for p in edge_points(mesh, a, b):
            wf, wg = barycentric(mesh, a, p), barycentric(mesh, b, p)
            if wf is None or wg is None:
                continue
            for (s, ws), (t, wt) in (((a, wf), (b, wg)), ((b, wg), (a, wf))):
                if any(w > 0 and v not in mesh.tris[t] for w, v in zip(ws, mesh.tris[s])):
                    return s, t, integers(ws), integers(wt)
    return None


def integers(weights):
    d = math.lcm(*[Fraction(w).denominator for w in weights])
    return [int(w * d) for w in weights]


def edge_uses(mesh):
    """Triangles by directed edge; a triangle of fewer than three vertices has no edge."""
    uses = {}
    for f, t in enumerate(mesh.tris):
        for i in range(3) if len(set(t)) == 3 else ():
            uses.setdefault((t[i], t[(i + 1) % 3]), []).append(f)
    return uses


def shells(mesh):
    """Lists of triangles connected through edges, by least triangle."""
    owner = {}
    for f, t in enumerate(mesh.tris):
        for i in range(3):
            owner.setdefault(frozenset((t[i], t[(i + 1) % 3])), []).append(f)
    seen, out = set(), []
    for f in range(len(mesh.tris)):
        if f in seen:
            continue
        group, todo = [], [f]
        seen.add(f)
        while todo:
            g = todo.pop()
            group.append(g)
            t = mesh.tris[g]
            for i in range(3):
                for h in owner[frozenset((t[i], t[(i + 1) % 3]))]:
                    if h not in seen:
                        seen.add(h)
                        todo.append(h)
        out.append(sorted(group))
    return out


def winding(mesh, faces, p, rng):
    """Winding number of the faces around p (not on them) by a random ray; fractions allowed."""
    while True:
        d = tuple(rng.randint(-10 ** 6, 10 ** 6) for _ in range(3))
        total, clear = 0, any(d)
        for f in faces:
            n, (a, b, c) = mesh.n[f], (mesh.p[v] for v in mesh.tris[f])
            s = [dot(d, cross(sub(u, p), sub(v, p))) for u, v in ((a, b), (b, c), (c, a))]
            nd = dot(n, d)
            if min(s) < 0 < max(s):
                continue                                  # the line misses the triangle
            if nd == 0 or 0 in s:
                clear = False                             # it may touch an edge: another ray
                break
            if dot(n, sub(a, p)) * nd > 0:
                total += 1 if nd > 0 else -1
        if clear:
            return total


class Truth:
    """All that is the case about a mesh: the rules it breaks and its quantities."""

    def __init__(self, mesh, pairs=True, limit=3):
        self.mesh, self.broken = mesh, set()
        self.flat = [f for f in range(len(mesh.tris)) if degenerate(mesh, f)]
        self.uses = edge_uses(mesh)
        self.shells = shells(mesh)
        self.crossings = []
        sets = [frozenset(t) for t in mesh.tris]
        used = sorted(mesh.at)
        if self.flat:
            self.broken.add("M1")
        whole = [s for s in sets if len(s) == 3]
        if len(set(whole)) < len(whole):
            self.broken.add("M2")
        for (a, b), faces in self.uses.items():
            both = len(faces) + len(self.uses.get((b, a), []))
            if both != 2:
                self.broken.add("M3" if both == 1 else "M4")
            elif len(faces) == 2:
                self.broken.add("M5")
        if any(fans_at(mesh, v) > 1 for v in used):
            self.broken.add("M6")
        if len({mesh.floats[v] for v in used}) < len(used):
            self.broken.add("V2")
        if pairs:
            self.find_crossings(limit)
        if self.crossings:
            self.broken.add("M7")
        self.six_volumes = [sum(dot(mesh.p[mesh.tris[f][0]], mesh.n[f]) for f in s) for s in self.shells]

    def find_crossings(self, limit):
        box, flat, open_ = self.mesh.box, set(self.flat), []
        for f in sorted((f for f in range(len(self.mesh.tris)) if f not in flat), key=lambda f: box[f][0]):
            open_ = [g for g in open_ if box[g][0][1] >= box[f][0][0]]     # sweep along x
            for g in open_:
                w = crossing_witness(self.mesh, min(f, g), max(f, g))
                if w:
                    self.crossings.append(w)
                    if len(self.crossings) >= limit:
                        return
            open_.append(f)

    def depths(self, rng):
        """How many other shells are around each shell (for embedded closed meshes)."""
        m = self.mesh
        return [sum(winding(m, o, m.p[m.tris[s[0]][0]], rng) != 0 for o in self.shells if o is not s)
                for s in self.shells]

    def nested(self, rng):
        """Adds M8 (some shell is oriented the wrong way) if the mesh breaks nothing else."""
        if not self.broken:
            for d, v in zip(self.depths(rng), self.six_volumes):
                if v == 0 or (v > 0) != (d % 2 == 0):
                    self.broken.add("M8")
        return self.broken


def fans_at(mesh, v):
    """Number of classes of the triangles at v connected through common edges at v; a collapsed one is at no vertex."""
    groups = []
    for f in (f for f in mesh.at[v] if len(set(mesh.tris[f])) == 3):
        ends = set(mesh.tris[f]) - {v}
        joined = [g for g in groups if g & ends]
        groups = [g for g in groups if not g & ends] + [ends.union(*joined)]
    return len(groups)


# ---------------------------------------------------------------- hints of an honest certificate

def axis_vectors(mesh, a, b):
    pa, pb = ([mesh.p[v] for v in mesh.tris[f]] for f in (a, b))
    ea, eb = ([sub(q[(i + 1) % 3], q[i]) for i in range(3)] for q in (pa, pb))
    out = [mesh.n[a], mesh.n[b]] + [cross(u, v) for u in ea for v in eb]
    return out + [cross(mesh.n[a], u) for u in ea] + [cross(mesh.n[b], u) for u in eb]


def apply_axis(mesh, d, ps, qs):
    """(gap, P', Q'): gap = min over Q - max over P; the vertices of contact."""
    sp, sq = [dot(d, mesh.p[v]) for v in ps], [dot(d, mesh.p[v]) for v in qs]
    hi, lo = max(sp), min(sq)
    return lo - hi, [v for v, s in zip(ps, sp) if s == hi], [v for v, s in zip(qs, sq) if s == lo]


def closes(mesh, ps, qs):
    k = sorted(set(ps) | set(qs))
    if len(k) == 3:
        return cross(sub(mesh.p[k[1]], mesh.p[k[0]]), sub(mesh.p[k[2]], mesh.p[k[0]])) != (0, 0, 0)
    return len(k) < 3


def chain(mesh, a, b, rng=None):
    """A list of code bytes that proves that a and b meet properly, or None (complete search)."""
    key = (a, b)
    if key not in mesh.codes or rng:
        axes = [(d, c) for c, d in enumerate(axis_vectors(mesh, a, b)) if any(d)]
        axes += [(neg(d), c + 32) for d, c in axes]
        if rng:
            rng.shuffle(axes)
        mesh.codes[key] = chain_from(mesh, axes, list(mesh.tris[a]), list(mesh.tris[b]), 4)
    return mesh.codes[key]


def chain_from(mesh, axes, ps, qs, left):
    opened = []
    for d, code in axes:
        gap, p2, q2 = apply_axis(mesh, d, ps, qs)
        if gap > 0 or gap == 0 and closes(mesh, p2, q2):
            return [code]
        if gap == 0 and len(p2) + len(q2) < len(ps) + len(qs):
            opened.append((p2, q2, code))
    for p2, q2, code in opened if left > 1 else ():
        rest = chain_from(mesh, axes, p2, q2, left - 1)
        if rest:
            return [code + 64] + rest
    return None


def detour(mesh, a, b, rng):
    """A valid chain that starts with open bytes although it need not, or None if no test is open."""
    axes = [(d, c) for c, d in enumerate(axis_vectors(mesh, a, b))]
    axes += [(neg(d), c + 32) for d, c in axes]
    ps, qs, out = list(mesh.tris[a]), list(mesh.tris[b]), []
    for left in (3, 2, 1)[:rng.choice((1, 1, 2, 3))]:
        steps = [(c, apply_axis(mesh, d, ps, qs)) for d, c in axes]
        steps = [(c, p, q) for c, (gap, p, q) in steps if gap == 0 and not closes(mesh, p, q)]
        if not steps:
            break
        code, p, q = rng.choice(steps)
        rest = chain_from(mesh, axes, p, q, left)
        if rest is None:
            break
        out, ps, qs = out + [code + 64], p, q
    return out + chain_from(mesh, axes, ps, qs, 4 - len(out)) if out else None


def star_holds(mesh, v, d):
    g = (0, d[2], -d[1]) if d[1] or d[2] else (0, 0, 1)
    turns, side = 0, 0
    for f in mesh.at[v]:
        nd = dot(mesh.n[f], d)
        if nd == 0 or side * nd < 0:
            return False
        side = nd
        t = mesh.tris[f]
        i = t.index(v)
        p, q = t[(i + 1) % 3], t[(i + 2) % 3]
        if nd < 0:
            p, q = q, p
        turns += dot(g, sub(mesh.p[p], mesh.p[v])) >= 0 > dot(g, sub(mesh.p[q], mesh.p[v]))
    return turns == 1


def star(mesh, v, rng=None):
    """A table code 1..13, a vector, or None."""
    if fans_at(mesh, v) != 1 or len(mesh.at[v]) < 3:
        return None
    table = list(range(1, 14))
    if rng:
        rng.shuffle(table)
    for code in table:
        if star_holds(mesh, v, STAR_TABLE[code - 1]):
            return code
    total = [sum(mesh.n[f][k] for f in mesh.at[v]) for k in range(3)]
    for d in (total, mean_normal(mesh, v)):
        d = to_i32(d)
        if d and star_holds(mesh, v, d):
            return d
    return None


def mean_normal(mesh, v):
    """Sum of the unit normals at v, scaled: a hint only, so floating point will do."""
    out = [0.0, 0.0, 0.0]
    for f in mesh.at[v]:
        n = mesh.n[f]
        shift = max(max(abs(c).bit_length() for c in n) - 60, 0)
        n = [float(c >> shift) for c in n]
        size = math.sqrt(sum(c * c for c in n)) or 1.0
        out = [o + c / size for o, c in zip(out, n)]
    return [int(c * 2 ** 28) for c in out]


def kd_order(mesh, faces=None):
    faces = list(range(len(mesh.tris))) if faces is None else faces
    if len(faces) < 2:
        return faces
    mid = [[sum(mesh.box[f][k]) for k in range(3)] for f in faces]
    spread = [max(m[k] for m in mid) - min(m[k] for m in mid) for k in range(3)]
    k = spread.index(max(spread))
    faces = sorted(faces, key=lambda f: (sum(mesh.box[f][k]), f))
    half = len(faces) // 2
    return kd_order(mesh, faces[:half]) + kd_order(mesh, faces[half:])


def separator(mesh, va, vb, rng):
    """A direction (i32) that separates two vertex sets, or None; tries the obvious ones."""
    ca = [sum(mesh.p[v][k] for v in va) * len(vb) for k in range(3)]
    cb = [sum(mesh.p[v][k] for v in vb) * len(va) for k in range(3)]
    tries = [sub(cb, ca)] + [tuple(s if k == i else 0 for k in range(3)) for i in range(3) for s in (1, -1)]
    tries += [tuple(rng.randint(-9, 9) for _ in range(3)) for _ in range(3)]
    for d in tries:
        d = to_i32(d)
        if d and separates(mesh, d, va, vb):
            return d
    return None


def separates(mesh, d, va, vb):
    gap, p2, q2 = apply_axis(mesh, d, va, vb)
    return gap > 0 or gap == 0 and closes(mesh, p2, q2)


# ---------------------------------------------------------------- encoding

def varint(n):
    out = []
    while n > 127:
        out.append(n & 127 | 128)
        n >>= 7
    return bytes(out + [n])


def zigzag(z):
    return varint(2 * z if z >= 0 else -2 * z - 1)


def natural(n):
    size = (n.bit_length() + 7) // 8
    return struct.pack("<I", size) + n.to_bytes(size, "little")


def certificate(model_bytes, model, claim, body, values):
    s = {"certificate": "veritope-certificate-1", "tool": "forge", "claim": claim,
         "subject_sha256": hashlib.sha256(model_bytes).hexdigest(), "subject_bytes": len(model_bytes),
         "subject_format": model.fmt, "reading_rule": READING_RULE, "as_indexed": model.as_indexed,
         "body_sha256": hashlib.sha256(body).hexdigest()}
    s.update(values)
    return json.dumps(s, separators=(",", ":")).encode() + b"\n" + body


class Plan:
    """Everything a mesh-valid-1 body is made of; a liar changes parts of it.

    stars: vertex -> code or vector; pair(a, b) -> code bytes; cut(A, B, k) -> separator or None
    (A, B: lists of triangles; k: how often step 3 was reached); extra_*: appended at the end.
    """

    claim = "mesh-valid-1"

    def __init__(self, mesh, rng, honest_stars=0.7):
        self.mesh, self.rng = mesh, rng
        self.order = kd_order(mesh)
        self.stars = {}
        for v in mesh.at:
            if rng.random() < honest_stars:
                s = star(mesh, v, rng)
                if s is not None:
                    self.stars[v] = s
        self.shells = shells(mesh)
        self.nesting = [rng.randrange(6) for _ in self.shells] if len(self.shells) > 1 else []
        self.forced = {}                                  # frozenset of two triangles -> bytes
        self.cut = None
        self.detours = 0                                  # share of pairs with needlessly long chains
        self.extra_codes, self.extra_separators = b"", []
        self.values = {}                                  # statement quantities to lie about

    def copy(self):
        p = Plan.__new__(Plan)
        p.__dict__.update(self.__dict__)
        p.order, p.stars, p.nesting = list(self.order), dict(self.stars), list(self.nesting)
        p.forced, p.values = dict(self.forced), dict(self.values)
        return p

    def pair(self, a, b):
        forced = self.forced.get(frozenset((a, b)))
        if forced is not None:
            return forced
        if self.detours and self.rng.random() < self.detours:
            longer = detour(self.mesh, a, b, self.rng)
            if longer:
                return bytes(longer)
        return bytes(chain(self.mesh, a, b) or [0])       # no honest chain: any byte

    def walk(self):
        """(separators as (index, d), codes) in the order in which the checker wants them."""
        mesh, order, reached = self.mesh, self.order, 0
        separators, codes = [], []
        boxes, common = {}, {}

        def node(lo, hi):
            if (lo, hi) in boxes:
                return
            if hi - lo == 1:
                f = order[lo]
                boxes[lo, hi] = mesh.box[f]
                common[lo, hi] = {v for v in mesh.tris[f] if v in self.stars}
                return
            m = lo + (hi - lo) // 2
            node(lo, m), node(m, hi)
            boxes[lo, hi] = tuple((min(x[0], y[0]), max(x[1], y[1]))
                                  for x, y in zip(boxes[lo, m], boxes[m, hi]))
            common[lo, hi] = common[lo, m] & common[m, hi]

        def meet(a, b):
            nonlocal reached
            for x, y in zip(boxes[a], boxes[b]):
                if x[1] < y[0] or y[1] < x[0]:
                    return
            if common[a] & common[b]:
                return
            k, reached = reached, reached + 1
            if self.cut:
                d = self.cut(order[a[0]:a[1]], order[b[0]:b[1]], k)
                if d is not None:
                    separators.append((k, d))
                    return
            na, nb = a[1] - a[0], b[1] - b[0]
            if na == 1 == nb:
                codes.append(self.pair(order[a[0]], order[b[0]]))
            elif na >= nb:
                m = a[0] + na // 2
                meet((a[0], m), b), meet((m, a[1]), b)
            else:
                m = b[0] + nb // 2
                meet(a, (b[0], m)), meet(a, (m, b[1]))

        def self_(lo, hi):
            if hi - lo > 1:
                m = lo + (hi - lo) // 2
                self_(lo, m), self_(m, hi), meet((lo, m), (m, hi))

        node(0, len(order))
        self_(0, len(order))
        self.reached = reached
        return separators, b"".join(codes)

    def body(self):
        mesh = self.mesh
        codes, vectors = bytearray(len(mesh.p)), []
        for v in sorted(self.stars):
            s = self.stars[v]
            codes[v] = s if isinstance(s, int) else 14
            if not isinstance(s, int):
                vectors.append(struct.pack("<iii", *s))
        separators, pairs = self.walk()
        separators, pairs = separators + self.extra_separators, pairs + self.extra_codes
        out = [b"VTMV", struct.pack("<II", len(mesh.tris), len(mesh.p)),
               struct.pack("<%dI" % len(self.order), *self.order), bytes(codes),
               struct.pack("<I", len(vectors)), *vectors, struct.pack("<I", len(separators))]
        last = -1
        for k, d in separators:
            out.append(varint(k - last - 1) + zigzag(d[0]) + zigzag(d[1]) + zigzag(d[2]))
            last = k
        return b"".join(out + [struct.pack("<I", len(pairs)), pairs, bytes(self.nesting)])

    def quantities(self):
        """The page's formulas, also for meshes that are not valid (but a volume has no sign)."""
        mesh = self.mesh
        edges = {frozenset((t[i], t[(i + 1) % 3])) for t in mesh.tris for i in range(3)}
        vs = sum(len({v for f in s for v in mesh.tris[f]}) for s in self.shells)
        six = sum(dot(mesh.p[mesh.tris[f][0]], mesh.n[f]) for f in range(len(mesh.tris)))
        volume = Fraction(abs(six), 6) * mesh.unit ** 3
        bodies = sum(sum(dot(mesh.p[mesh.tris[f][0]], mesh.n[f]) for f in s) > 0 for s in self.shells)
        out = {"vertices": len(mesh.at), "edges": len(edges), "faces": len(mesh.tris),
               "shells": len(self.shells), "bodies": bodies,
               "genus": max((2 * len(self.shells) - vs + len(edges) - len(mesh.tris)) // 2, 0),
               "volume": "%d/%d" % (volume.numerator, volume.denominator)}
        out.update(self.values)
        return out

    def certificate(self, model_bytes, model):
        return certificate(model_bytes, model, self.claim, self.body(), self.quantities())

    def unproved(self):
        """Leaf pairs of the walk for which no chain of codes exists."""
        bad = []
        self.pair = lambda a, b: bad.append((a, b)) or b"" if chain(self.mesh, a, b) is None else b""
        self.walk()
        del self.pair
        return bad


# ---------------------------------------------------------------- mesh-reversed-1

class ReversedPlan(Plan):
    """flips: the numbers of the triangles that the body reverses.  mesh: as the file has it; self.mesh is what the flips make of it."""
    claim = "mesh-reversed-1"

    def __init__(self, mesh, flips, rng, honest_stars=0.7):
        super().__init__(Mesh(mesh.floats, [(a, c, b) if f in flips else (a, b, c) for f, (a, b, c) in enumerate(mesh.tris)]), rng, honest_stars)
        self.flips = set(flips)

    def body(self):
        return reversed_body(super().body(), self.flips, len(self.mesh.tris))

    def quantities(self):
        return {**super().quantities(), **reversed_counts(self), **self.values}


def reversed_body(body, flips, n):
    """The body of mesh-reversed-1 that a body of mesh-valid-1 about n triangles becomes."""
    return b"VTMR" + body[4:12] + sum(1 << f for f in flips).to_bytes((n + 7) // 8, "little") + body[12:]


def reversed_counts(plan):
    return {"reversed": len(plan.flips), "reversed_shells": sum(plan.flips.issuperset(shell) for shell in plan.shells)}


# ---------------------------------------------------------------- mesh-invalid-1

def invalid_body(mesh, witnesses):
    """witnesses: (rule, field, ...) with u32 fields; M7: (7, f, g, w, x); M8, M9: (8, f, axis)."""
    out = [b"VTMI", struct.pack("<III", len(mesh.tris), len(mesh.p), len(witnesses))]
    for w in witnesses:
        out.append(bytes([w[0]]))
        if w[0] == 7:
            out += [struct.pack("<II", w[1], w[2])] + [natural(x) for x in list(w[3]) + list(w[4])]
        elif w[0] > 7:
            out.append(struct.pack("<IB", w[1], w[2]))
        else:
            out.append(struct.pack("<%dI" % (len(w) - 1), *w[1:]))
    return b"".join(out)


def invalid_certificate(model_bytes, model, mesh, witnesses, rules=None):
    if rules is None:
        rules = sorted({"M%d" % w[0] for w in witnesses})
    return certificate(model_bytes, model, "mesh-invalid-1", invalid_body(mesh, witnesses),
                       {"rules": " ".join(rules)})


def stab_sum(mesh, f, u):
    """w of rules M8 and M9, or None if the witness is not allowed (own formulation: fractions)."""
    nu = mesh.n[f][u]
    if nu == 0:
        return None
    p, q = (u + 1) % 3, (u + 2) % 3
    a, b, c = (mesh.p[v] for v in mesh.tris[f])
    x = [Fraction(2 * a[k] + b[k] + c[k], 4) for k in range(3)]
    total = 0
    for g, t in enumerate(mesh.tris):
        if g == f:
            continue
        odd = 0
        for i in range(3):
            s, e = mesh.p[t[i]], mesh.p[t[(i + 1) % 3]]
            if (s[q] <= x[q]) != (e[q] <= x[q]):
                odd ^= s[p] + Fraction((x[q] - s[q]) * (e[p] - s[p]), e[q] - s[q]) > x[p]
        if odd:
            h = dot(mesh.n[g], sub(mesh.p[t[0]], x)) / mesh.n[g][u]     # signed distance along u
            if h == 0:
                return None
            if (h > 0) == (nu > 0):
                total += 1 if (mesh.n[g][u] > 0) == (nu > 0) else -1
    return total


def true_witnesses(truth, rng):
    """Honest witnesses for the rules that a mesh breaks (M8/M9 only if a stab shows it)."""
    mesh, out = truth.mesh, {}
    for f in truth.flat:
        out.setdefault(1, (1, f))
    first = {}
    for f, t in enumerate(mesh.tris):
        g = first.setdefault(frozenset(t), f)
        if g != f and len(set(t)) == 3:
            out.setdefault(2, (2, g, f))
    for (a, b), faces in truth.uses.items():
        both = len(faces) + len(truth.uses.get((b, a), []))
        if a == b:
            continue
        if both == 1:
            out.setdefault(3, (3, b, a) if rng.random() < .5 else (3, a, b))
        elif both > 2:
            out.setdefault(4, (4, a, b))
        elif len(faces) == 2:
            out.setdefault(5, (5, a, b))
    for v in mesh.at:
        if fans_at(mesh, v) > 1:
            out.setdefault(6, (6, v))
    if truth.crossings:
        out[7] = (7,) + tuple(rng.choice(truth.crossings))
    faces = list(range(len(mesh.tris)))
    rng.shuffle(faces)
    for f in faces[:6]:
        for u in range(3):
            if stab_sum(mesh, f, u):
                out.setdefault(8, (8, f, u))
    return out
