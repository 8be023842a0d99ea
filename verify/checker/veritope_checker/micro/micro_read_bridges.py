# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The bridges and materials of a microstructure's file (docs/formats/micro-files.md)."""
from math import prod

from ..common.errors import Refused
from ..patches.star_box_read import members, number, texts, typed, whole

MAX_BRIDGES, MAX_MATERIALS, MAX_DEGREE, MAX_BITS, MAX_VALUE = 1 << 22, 16, 7, 2304, (1 << 52) - 1

class Bridge:
    """points: (p + 1)(q + 1) * 3, the third axis fastest."""

    def __init__(self, grid, cell, wall, volume, degrees, points):
        self.grid, self.cell, self.wall, self.volume = grid, cell, wall, volume
        self.degrees, self.points = degrees, points

    def place(self):
        return self.grid, self.cell, self.wall

    def of_list(self, k):
        """The points with this index along the third axis, the second one fastest."""
        return self.points[k::3]

def a_list(value, least, most):
    if not least <= len(typed(value, list)) <= most:
        raise Refused("a list of %d where %d to %d belong" % (len(value), least, most))
    return value

def coordinate(text, most_bits):
    value = number(text)
    if max(abs(value.numerator), value.denominator) >> most_bits:
        raise Refused("a coordinate has a part of more than %d bits" % most_bits)
    return value

def read_bridges(bridges, grids, num_volumes):
    found = [read_bridge(bridge, grids, num_volumes) for bridge in a_list(bridges, 0, MAX_BRIDGES)]
    if any(a.place() >= b.place() for a, b in zip(found, found[1:])):
        raise Refused("the bridges are not in ascending order of grid, cell and wall")
    return found

def read_bridge(bridge, grids, num_volumes):
    """Whether the tile has the cap, and whether the volume is the right one, is not tested here: that is R2."""
    grid, cell, wall, volume, degrees, points = members(bridge, "grid", "cell", "wall", "volume", "degrees", "points")
    whole(grid, 0, len(grids) - 1)
    whole(cell, 0, grids[grid].num_cells - 1)
    whole(wall, 0, 5)
    whole(volume, 0, num_volumes - 1)
    if not grids[grid].cells[cell]:
        raise Refused("a bridge starts at cell %d of grid %d, which holds no tile" % (cell, grid))
    p, q = [whole(d, 1, MAX_DEGREE) for d in a_list(degrees, 2, 2)]
    n = 3 * (p + 1) * (q + 1)
    return Bridge(grid, cell, wall, volume, (p, q),
                  [[coordinate(c, MAX_BITS) for c in a_list(point, 3, 3)] for point in a_list(points, n, n)])

def check_materials(materials, grids):
    for material in a_list(materials, 0, MAX_MATERIALS):
        name, values = members(material, "name", "values")
        texts([typed(name, str)])
        for grid, of_grid in zip(grids, a_list(values, len(grids), len(grids))):
            count = prod(n + 1 for n in grid.counts)
            if set(map(type, a_list(of_grid, count, count))) != {int} or max(map(abs, of_grid)) > MAX_VALUE:
                raise Refused("a value of a material is no integer below 2^52 in absolute value")
