# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of a simplex-spline solid (docs/certificates/dms-solid.md, section 2): B1 and B2."""
from fractions import Fraction

from ..common.errors import Reject
from ..patches.star_box_read import Body

MAGIC, MAX_LEVELS, MAX_DEGREE = b"VTDM", 64, 6
MAX_BITS, MAX_MODEL_BITS, MAX_WORD_BITS = 1024, 256, 64
POINT, LEAF, PLANE, TILE, FACE = 6, 20, 8, 4, 2             # least sizes, in bytes
OF_KIND_P = 13

class Leaf:
    """is_p: its kind; matrix: three rows; planes: (vector, number) each."""

    def __init__(self, body, is_p):
        self.is_p, self.matrix = is_p, read_matrix(body)
        self.planes = read_planes(body)

class Tile:
    """corners: three numbers of points."""

    def __init__(self, body, num_points):
        self.corners = [body.varint() for _ in range(3)]
        if max(self.corners) >= num_points:
            raise Reject("B1", "a tile has a point that does not exist")
        self.planes = read_planes(body)

class SolidCertificate:
    """What the certificates of all versions have. trees: of each tetrahedron, in preorder, a Leaf or (edge, t); planes:
    of each face of the boundary; domain: bytes."""

    def why_too_long(self, model):
        """Why B2 does not hold, or None."""
        why = why_model_too_long(model)
        if not why and (is_long(self.words(), MAX_WORD_BITS) or is_long(self.numbers(), MAX_BITS)):
            why = "a number of the body is too long"
        return why

    def nodes(self):
        return (node for tree in self.trees for node in tree)

    def words(self):
        """Lists of the numbers with the lower limit: those of all nodes."""
        for node in self.nodes():
            yield from node.matrix if type(node) is Leaf else [[node[1]]]

    def numbers(self):
        """Lists of the other numbers: all planes."""
        return ([*vector, c] for planes in self.holders() for vector, c in planes)

    def holders(self):
        """All lists of planes."""
        yield from (node.planes for node in self.nodes() if type(node) is Leaf)
        yield from self.planes

class Certificate(SolidCertificate):
    """points: added ones; tiles: of each face of the boundary; surface: bytes."""

    def __init__(self, data, model):
        body = Body(data)
        if body.bytes(4) != MAGIC or body.count(LEAF) != len(model.tetrahedra):
            raise Reject("B1", "magic, or another number of tetrahedra")
        num_faces = body.count(FACE)
        self.points = [[body.rational() for _ in range(3)] for _ in range(body.count(POINT))]
        self.trees = [read_tree(body) for _ in model.tetrahedra]
        self.planes = [read_planes(body) for _ in range(num_faces)]
        num_points = len(model.clouds) + len(self.points)
        self.tiles = [[Tile(body, num_points) for _ in range(counted(body, TILE))] for _ in range(num_faces)]
        self.domain, self.surface = read_part(body), read_part(body)
        body.end()

    def numbers(self):
        yield from self.points
        yield from super().numbers()

    def holders(self):
        yield from super().holders()
        yield from (tile.planes for tiles in self.tiles for tile in tiles)

def why_model_too_long(model):
    if model.degree > MAX_DEGREE:
        return "the degree is above %d" % MAX_DEGREE
    if is_long([*(knot for cloud in model.clouds for knot in cloud), *model.control.values()], MAX_MODEL_BITS):
        return "a number of the model is too long"
    return None

def is_long(lists, most):
    return any(max(abs(c.numerator), c.denominator) >> most for numbers in lists for c in numbers)

def read_part(body):
    return body.bytes(int.from_bytes(body.bytes(4), "little"))

def read_matrix(body):
    """Three rows."""
    return [[body.rational() for _ in range(3)] for _ in range(3)]

def counted(body, size):
    n = body.varint()
    if n * size > body.left():
        raise Reject("B1", "a count is larger than the body")
    return n

def read_planes(body):
    planes = []
    for _ in range(counted(body, PLANE)):
        vector, c = [body.rational() for _ in range(3)], body.rational()
        if not any(vector):
            raise Reject("B1", "a plane without a direction")
        planes.append((vector, c))
    return planes

def read_tree(body):
    tree, levels = [], [0]
    while levels:
        level, symbol = levels.pop(), body.u8(OF_KIND_P)
        if symbol >= 12:
            tree.append(Leaf(body, symbol == OF_KIND_P))
            continue
        t = body.rational() if symbol >= 6 else Fraction(1, 2)
        if level == MAX_LEVELS or not 0 < t < 1:
            raise Reject("B1", "a tree is too deep, or an edge is cut at one of its ends")
        tree.append((symbol % 6, t))
        levels += [level + 1] * 2
    return tree
