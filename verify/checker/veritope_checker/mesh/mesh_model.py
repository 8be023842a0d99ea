# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What both claims about meshes compute from a model, and the cursor over a body.

A float only ever holds a coordinate: it is read, compared and converted to its exact ratio, never added or
multiplied."""
import struct
from fractions import Fraction

from . import mesh_reader
from ..common.errors import Reject
from ..common.vectors import cross, sub

TOO_MUCH_WORK = "more work than the certificate's size allows"

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

    def header(self, magic, points, triangles):
        if self.bytes(4) != magic:
            raise Reject("B1", "magic")
        if self.u32() != len(triangles) or self.u32() != len(points):
            raise Reject("B1", "F or V differs from the model's")

    def work(self, mesh):
        """The number of units of work that the certificate may take."""
        return 1000 * (len(mesh.triangles) + len(self.data))

    def end(self):
        if self.pos != len(self.data):
            raise Reject("B1", "bytes after the end of the body")

def integers_of(floats):
    """(the coordinates as integers, times 2^-E; the fraction 2^E)"""
    ratios = [[c.as_integer_ratio() for c in p] for p in floats]
    common = max(d for p in ratios for _, d in p)
    scaled = [[n * (common // d) for n, d in p] for p in ratios]
    bits = 0
    for p in scaled:
        bits |= p[0] | p[1] | p[2]
    low = max(bits & -bits, 1)                              # greatest common power of two
    return [(x // low, y // low, z // low) for x, y, z in scaled], Fraction(low, common)

class Mesh:
    """floats: coordinates for comparisons; points: the same coordinates as integers, times 2^-E = 1/unit."""

    def __init__(self, floats, triangles):
        self.floats, self.triangles = floats, triangles
        self.points, self.unit = integers_of(floats)
        self.normals = [cross(sub(self.points[b], self.points[a]), sub(self.points[c], self.points[a]))
                        for a, b, c in triangles]
        self.fans = [[] for _ in floats]                    # at each vertex v: (f, p, q), f = (v, p, q)
        for f, (a, b, c) in enumerate(triangles):
            self.fans[a].append((f, b, c))
            self.fans[b].append((f, c, a))
            self.fans[c].append((f, a, b))

    def corners(self, f):
        return [self.points[v] for v in self.triangles[f]]

def read_mesh(statement, data):
    return Mesh(*mesh_reader.read_model(data, statement["subject_format"], statement["as_indexed"]))

def sign(x):
    return (x > 0) - (x < 0)

def collapsed(t):
    return t[0] == t[1] or t[1] == t[2] or t[2] == t[0]

def directed_edges(triangles):
    """The number of occurrences of each directed edge."""
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
    """Section 6: whether the line along axis u through v, moved by (e, e^2), stabs triangle t."""
    p, q = (u + 1) % 3, (u + 2) % 3
    vp, vq, odd = v[p], v[q], False
    for l, h in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
        if l[q] > h[q]:
            l, h = h, l
        if l[q] <= vq < h[q] and (h[p] - l[p]) * (vq - l[q]) - (h[q] - l[q]) * (vp - l[p]) > 0:
            odd = not odd
    return odd
