# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of a V-model (docs/certificates/vmodel.md, sections 2, 4 and 5) without its last part."""
from collections import namedtuple
from math import prod

from ..common.errors import Reject
from ..patches.star_box_read import Body

MAX_CELLS, MAX_PIECES, MAX_DEGREE, MAX_HALVINGS = 1 << 20, 1 << 24, 15, 64
MAGIC = b"VTVM"

# What a body says about a piece: the numbers of its zeros, and the symbols of its tree in preorder.
Entry = namedtuple("Entry", "zeros tree")
PLAIN = Entry((), (0,))

class Certificate:
    """flags, breaks (three lists a cell), codes (six a cell), entries (by the numbers of pieces; of others, PLAIN),
    rest: the bytes of the last part."""

    def __init__(self, data, volumes):
        body = Body(data)
        if body.bytes(4) != MAGIC or body.count(10) != len(volumes):
            raise Reject("B1", "magic, or another number of entities")
        self.flags = [body.u8(1) for _ in volumes]
        self.breaks = [[read_breaks(body, volume, axis) for axis in range(3)] for volume in volumes]
        self.codes = [read_code(body, f, 6 * len(volumes)) for f in range(6 * len(volumes))]
        self.num_pieces = sum(prod(len(b) - 1 for b in cell) for cell in self.breaks)
        if len(volumes) > MAX_CELLS or self.num_pieces > MAX_PIECES:
            raise Reject("B2", "too many cells or pieces")
        for n, volume in enumerate(volumes):
            if max(volume.degrees) > MAX_DEGREE:
                raise Reject("B2", "cell %d has a degree over %d" % (n, MAX_DEGREE))
        self.entries = read_entries(body, self.num_pieces)
        self.rest = body.bytes(body.left())

def read_breaks(body, volume, axis):
    """The breaks of an axis: its knots and those of the body."""
    count = body.varint()
    if 2 * count > body.left():
        raise Reject("B1", "more breaks than the body has room for")
    added, knots = [body.rational() for _ in range(count)], set(volume.knots[axis])
    if any(a >= b for a, b in zip(added, added[1:])) or not knots.isdisjoint(added):
        raise Reject("B1", "added breaks do not ascend, or are knots")
    if added and not min(knots) < added[0] <= added[-1] < max(knots):
        raise Reject("B1", "an added break is not in the domain")
    return sorted(knots | set(added))

def read_code(body, face, count):
    """0 to 2, or (the face with a higher number that is named, the symmetry)."""
    code = body.varint()
    if code < 3:
        return code
    other = face + 1 + (code - 3) // 8
    if other >= count:
        raise Reject("B1", "face %d does not exist" % other)
    return other, (code - 3) % 8

def read_entries(body, num_pieces):
    entries, piece, count = {}, 0, body.varint()
    if 3 * count > body.left():
        raise Reject("B1", "more determinants than the body has room for")
    for _ in range(count):
        piece += body.varint()
        if piece >= num_pieces:
            raise Reject("B1", "there is no piece %d" % piece)
        zeros = body.varint()
        if zeros >> 26:
            raise Reject("B1", "a zero that is no face, edge or corner")
        entries[piece] = Entry([s for s in range(26) if zeros >> s & 1], read_tree(body))
        piece += 1
    return entries

def read_tree(body):
    tree, levels = [], [0]
    while levels:
        level, symbol = levels.pop(), body.u8(3)
        if symbol and level == MAX_HALVINGS:
            raise Reject("B1", "a tree of determinants is too deep")
        tree.append(symbol)
        if symbol:
            levels += [level + 1] * 2
    return tree
