# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The bridges, sweeps and materials of a microstructure's file (docs/formats/micro-files.md)."""
from math import prod

from ..common.errors import Refused
from ..patches.star_box_read import members, number, texts, typed, whole

MAX_BRIDGES, MAX_MATERIALS, MAX_DEGREE, MAX_BITS, MAX_VALUE = 1 << 22, 16, 7, 2304, (1 << 52) - 1

class Start:
    """The wall of a cell at which a bridge or a sweep starts."""

    def __init__(self, grid, cell, wall):
        self.grid, self.cell, self.wall = grid, cell, wall

    def place(self):
        return self.grid, self.cell, self.wall

class Bridge(Start):
    """points: (p + 1)(q + 1) * 3, the third axis fastest."""

    def __init__(self, grid, cell, wall, volume, degrees, points):
        super().__init__(grid, cell, wall)
        self.volume, self.degrees, self.points = volume, degrees, points

    def of_list(self, k):
        """The points with this index along the third axis, the second one fastest."""
        return self.points[k::3]

class Sweep(Start):
    """axis: the vectors e and f."""

    def __init__(self, grid, cell, wall, axis):
        super().__init__(grid, cell, wall)
        self.axis = axis

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
    return in_order([read_bridge(bridge, grids, num_volumes) for bridge in a_list(bridges, 0, MAX_BRIDGES)])

def read_sweeps(sweeps, grids, bridges):
    """bridges: of the file, which has none if it has sweeps."""
    return in_order([read_sweep(sweep, grids) for sweep in a_list(sweeps, 0, 0 if bridges else MAX_BRIDGES)])

def in_order(found):
    if any(a.place() >= b.place() for a, b in zip(found, found[1:])):
        raise Refused("bridges or sweeps are not in ascending order of grid, cell and wall")
    return found

def check_start(grid, cell, wall, grids):
    """Whether the tile has the cap is not tested here: that is R2 or Q1."""
    whole(grid, 0, len(grids) - 1)
    whole(cell, 0, grids[grid].num_cells - 1)
    whole(wall, 0, 5)
    if not grids[grid].cells[cell]:
        raise Refused("a bridge or a sweep starts at cell %d of grid %d, which holds no tile" % (cell, grid))

def read_bridge(bridge, grids, num_volumes):
    """Whether the volume is the right one is not tested here: that is R2."""
    grid, cell, wall, volume, degrees, points = members(bridge, "grid", "cell", "wall", "volume", "degrees", "points")
    check_start(grid, cell, wall, grids)
    whole(volume, 0, num_volumes - 1)
    p, q = [whole(d, 1, MAX_DEGREE) for d in a_list(degrees, 2, 2)]
    n = 3 * (p + 1) * (q + 1)
    return Bridge(grid, cell, wall, volume, (p, q), [read_vector(point) for point in a_list(points, n, n)])

def read_sweep(sweep, grids):
    grid, cell, wall, axis = members(sweep, "grid", "cell", "wall", "axis")
    check_start(grid, cell, wall, grids)
    return Sweep(grid, cell, wall, [read_vector(vector) for vector in a_list(axis, 2, 2)])

def read_vector(vector):
    return [coordinate(c, MAX_BITS) for c in a_list(vector, 3, 3)]

def check_materials(materials, grids):
    for material in a_list(materials, 0, MAX_MATERIALS):
        name, values = members(material, "name", "values")
        texts([typed(name, str)])
        for grid, of_grid in zip(grids, a_list(values, len(grids), len(grids))):
            count = prod(n + 1 for n in grid.counts)
            if set(map(type, a_list(of_grid, count, count))) != {int} or max(map(abs, of_grid)) > MAX_VALUE:
                raise Refused("a value of a material is no integer below 2^52 in absolute value")
