# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim mesh-valid-1: docs/certificates/mesh.md, sections 3 to 6."""
import struct
from fractions import Fraction

from ..common.errors import Reject
from ..common.vectors import cross, dot, sub
from .mesh_model import TOO_MUCH_WORK, Body, directed_edges, line_stabs, read_mesh, shells_of, sign

DIRECTIONS = (None, (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1),
              (0, 1, 1), (0, 1, -1), (1, 1, 1), (1, 1, -1), (1, -1, 1), (1, -1, -1))

def check(claim, statement, body, model, skip):
    mesh, body = read_mesh(statement, model), Body(body)
    body.header(claim.magic, mesh.points, mesh.triangles)
    prove(ValidBody(body, mesh), mesh, statement, {}, skip)

def prove(cert, mesh, statement, found, skip):
    """Tests V1 to V11.  found: quantities that are known already."""
    found = {**found, **proved(cert, mesh, skip).quantities}
    for key in sorted(found):
        if statement[key] != found[key] and "V11" not in skip:
            raise Reject("V11", "%s: stated %s, computed %s" % (key, statement[key], found[key]))

def proved(cert, mesh, skip):
    """Tests V1 to V10; returns the Nesting, with the quantities and the depths of shells."""
    for condition, holds in (("V1", v1_order), ("V2", v2_distinct), ("V3", v3_not_degenerate),
                             ("V4", v4_edges), ("V5", v5_no_duplicates), ("V6", v6_one_cycle),
                             ("V7", v7_stars)):
        why = holds(cert, mesh)
        if why and condition not in skip:
            raise Reject(condition, why)
    walk = Walk(cert, mesh, skip)
    walk.run()                                                                  # V8, V9
    nesting = Nesting(cert, mesh, walk, skip)
    nesting.test()                                                              # V10
    return nesting

class ValidBody:
    """Reads the fields of section 3 after F and V: B1."""

    def __init__(self, body, mesh):
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
    """Tests a direction: 0 if it fails, 1 if it holds, or the open pair (P', Q')."""
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

    def test(self):
        self.depths = depths = []
        for s, volume in enumerate(self.six_volumes):
            depths.append(self.depth(s))
            if sign(volume) != (-1 if depths[s] % 2 else 1):
                self.fail("shell %d of depth %d has no volume or the wrong side out" % (s, depths[s]))
        num_vertices, num_faces = sum(map(len, self.vertices)), len(self.mesh.triangles)
        volume = Fraction(sum(self.six_volumes), 6) * self.mesh.unit ** 3
        self.quantities = {
                "vertices": sum(1 for fan_at_v in self.mesh.fans if fan_at_v),
                "edges": self.cert.edges, "faces": num_faces, "shells": len(depths),
                "bodies": sum(1 for depth in depths if depth % 2 == 0),
                "genus": (2 * len(depths) - num_vertices + self.cert.edges - num_faces) // 2,
                "volume": "%d/%d" % (volume.numerator, volume.denominator)}
