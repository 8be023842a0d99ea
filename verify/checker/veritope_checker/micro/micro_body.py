# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of a microstructure (docs/certificates/microstructure.md, section 2): B1 and B2."""
from math import lcm
from operator import mul

from ..common.errors import Reject
from ..patches.star_box_read import Body

MAGIC, MAX_COEFFICIENTS, MAX_BITS = b"VTMS", 1 << 18, 64
MAX_PATCH_BITS, MAX_WORK, MAX_BRIDGE_WORK = 4096, 1 << 27, 1 << 36
MAX_BRIDGE_BITS, BYTES_OF_BRIDGE, BYTES_OF_SWEEP = 8192, 19, 22

class Star:
    """Proof 0: the tile is star-shaped about the centre; exit: a number of a patch."""

    def __init__(self, body):
        self.centre, self.exit = [body.rational() for _ in range(3)], body.varint()

class Boxes:
    """Proof 1; data: a body of star-box-2."""

    def __init__(self, body):
        self.data = body.bytes(int.from_bytes(body.bytes(4), "little"))

class BridgeHint:
    """matrix: three rows; cuts: s_1 to s_(m - 1)."""

    def __init__(self, body):
        entries = [body.rational() for _ in range(9)]
        self.matrix = [entries[i:i + 3] for i in (0, 3, 6)]
        count = body.u8()
        if count == 0 or 2 * (count - 1) > body.left():
            raise Reject("B1", "a bridge has no slices, or more than the body has room for")
        self.cuts = [body.rational() for _ in range(count - 1)]
        if any(a >= b for a, b in zip([0, *self.cuts], [*self.cuts, 1])):
            raise Reject("B1", "the slices of a bridge do not ascend from 0 to 1")

class SweepHint:
    """matrix: three rows; depth, speed: d and l."""

    def __init__(self, body):
        entries = [body.rational() for _ in range(9)]
        self.matrix = [entries[i:i + 3] for i in (0, 3, 6)]
        self.depth, self.speed = body.rational(), body.rational()
        if not 0 < self.depth <= 1 or self.speed <= 0:
            raise Reject("B1", "a depth is not above 0 and at most 1, or a speed is not positive")

class Certificate:
    """proofs: Star or Boxes, of each tile; bridges: a BridgeHint each; sweeps: a SweepHint each; cage: the bytes of the
    last part."""

    def __init__(self, data, model):
        body = Body(data)
        bytes_each = BYTES_OF_SWEEP if model.sweeps else BYTES_OF_BRIDGE
        if (body.bytes(4) != MAGIC or body.count(5) != len(model.tiles)
                or body.count(bytes_each) != len(model.bridges) + len(model.sweeps)):
            raise Reject("B1", "magic, or another number of tiles, bridges or sweeps")
        self.proofs = [(Boxes if body.u8(1) else Star)(body) for _ in model.tiles]
        for (_, patches), proof in zip(model.tiles, self.proofs):
            if type(proof) is Star and proof.exit >= len(patches):
                raise Reject("B1", "an exit is no patch of its tile")
        self.bridges = [BridgeHint(body) for _ in model.bridges]
        self.sweeps = [SweepHint(body) for _ in model.sweeps]
        self.cage = body.bytes(body.left())

    def why_too_long(self, model):
        """Why B2 does not hold, or None."""
        patches = [patch for _, of_tile in model.tiles for patch in of_tile]
        sizes = [9 * patch.degrees[0] * patch.degrees[1] * (3 * len(patch.lists) - 2) for patch in patches]
        if sum(sizes) > MAX_COEFFICIENTS:
            return "the tiles have more than %d coefficients" % MAX_COEFFICIENTS
        bits = [bits_of([point for points in patch.lists for point in points], MAX_PATCH_BITS) for patch in patches]
        if max(bits) > MAX_PATCH_BITS or sum(map(mul, sizes, bits)) > MAX_WORK:
            return "the numbers of the tiles are too long"
        if any(not 0 < c < 1 for proof in self.proofs if type(proof) is Star for c in proof.centre):
            return "a centre is not inside the cube"
        hints = [c for proof in self.proofs if type(proof) is Star for c in proof.centre]
        hints += [c for bridge in self.bridges for c in (*sum(bridge.matrix, []), *bridge.cuts)]
        hints += [c for sweep in self.sweeps for c in (*sum(sweep.matrix, []), sweep.depth, sweep.speed)]
        if any(max(abs(c.numerator), c.denominator) >> MAX_BITS for c in hints):
            return "a number of the body is too long"
        if sum(map(cost_of, model.bridges)) > MAX_BRIDGE_WORK:
            return "the numbers of the bridges are too long"

def bits_of(points, most):
    """The bits of the longest of the numbers as integers with their least common denominator, and of that; more than
    `most` if that has more."""
    numbers, common = [c for point in points for c in point], 1
    for c in numbers:
        common = lcm(common, c.denominator)
        if common.bit_length() > most:
            return most + 1
    return max([common, *[abs(c.numerator) * (common // c.denominator) for c in numbers]]).bit_length()

def cost_of(bridge):
    p, q = bridge.degrees
    bits = bits_of(bridge.points, MAX_BRIDGE_BITS)
    return (p + 1) * (q + 1) * (1 + bits) ** 2 >> 6 if bits <= MAX_BRIDGE_BITS else MAX_BRIDGE_WORK + 1
