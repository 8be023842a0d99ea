# SPDX-License-Identifier: Apache-2.0 OR MIT
"""A tile that star boxes show to be embedded (docs/certificates/microstructure.md, section 4, proof 1): F3."""
from fractions import Fraction

from ..patches.star_box_2_check import Checker2
from ..patches.star_box_read import Entity

def test_boxes(tile, data, statement):
    """tile: fail(condition, why), extent, patches, skip; data: a body of star-box-2."""
    if tile.extent is not None:
        tile.fail("F3", "a tile with a range has star boxes")
    checker = Checker2(b"VTS2", statement, data, [surface_of(patch) for patch in tile.patches], tile.skip)
    checker.make_patches()
    numbers = checker.numbers()
    if any(checker.cert.flags) or any(breaks != [[0, 1], [0, 1]] for breaks in checker.cert.breaks):
        tile.fail("F3", "a patch of a tile is reversed, or has added breaks")
    if (numbers["shells"], numbers["bodies"]) != (1, 1):
        tile.fail("F3", "a tile has %d shells and %d bodies" % (numbers["shells"], numbers["bodies"]))

def surface_of(patch):
    surface, (p, q) = Entity("surface"), patch.degrees
    surface.degrees, surface.dimension = patch.degrees, 3
    surface.knots = [[Fraction(t) for t in (0, 1) for _ in range(n + 1)] for n in patch.degrees]
    points = [[*point, Fraction(1)] for point in patch.at_number(0)]
    surface.rows = [points[i * (q + 1):(i + 1) * (q + 1)] for i in range(p + 1)]
    return surface
