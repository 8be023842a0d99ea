# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The reader of microstructures (docs/formats/micro-files.md). Numbers become integers or fractions."""
import re
from array import array
from bisect import bisect_left
from itertools import combinations, compress
from math import prod

from ..common.errors import Refused
from ..patches.model_faces import checked
from ..patches.model_json_volumes import volumes_of
from ..patches.star_box_read import members, number, read_json, texts, typed, whole
from .micro_read_bridges import a_list, check_materials, coordinate, read_bridges, read_sweeps

KEYS = ("format", "model", "cage", "grids", "tiles", "cells", "walls", "bridges", "sweeps", "materials")
MAY_LACK = frozenset(("bridges", "sweeps", "materials"))
MAX_VOLUMES, MAX_GRIDS, MAX_GRIDS_OF_VOLUME, MAX_TILES, MAX_PATCHES, MAX_LISTS = 65536, 65536, 4096, 15, 1024, 4
MAX_DEGREE, MAX_CELLS, MAX_NUMBER, MAX_BITS, MAX_BREAK_BITS = 7, 1 << 27, 1 << 20, 128, 2048

class Grid:
    """volume: its number; breaks: of the three axes; counts: of intervals; cells: a byte each, 0 or 1 + its tile;
    walls: three arrays of numbers, or None if no tile has a range."""

    def __init__(self, volume, breaks):
        self.volume, self.breaks, self.counts = volume, breaks, [len(b) - 1 for b in breaks]
        self.num_cells, self.cells, self.walls = prod(self.counts), b"", None

    def stride(self, axis):
        return prod(self.counts[axis + 1:])

    def blocks(self, axis):
        """(first cell, first wall across the axis) of the parts in which cells that follow each other along the axis
        are stride(axis) apart, as their walls are; a part has counts[axis] * stride(axis) cells."""
        step = self.stride(axis)
        for n in range(self.num_cells // (self.counts[axis] * step)):
            yield n * self.counts[axis] * step, n * (self.counts[axis] + 1) * step

    def index(self, cell):
        _, n, m = self.counts
        return cell // (n * m), cell // m % n, cell % m

    def number(self, cell, wall):
        """The number of a wall of a cell."""
        axis, end = wall // 2, wall % 2
        step = self.stride(axis)
        block, rest = divmod(cell, step * self.counts[axis])
        return self.walls[axis][block * step * (self.counts[axis] + 1) + rest + end * step]

class Patch:
    """wall: a number or None; lists: of the powers of t, points with the second parameter fastest."""

    def __init__(self, wall, degrees, lists):
        self.wall, self.degrees, self.lists = wall, degrees, lists

class Microstructure:
    """cage: volumes; grids; tiles: (range or None, patches) each; bridges; sweeps. Materials are checked, not kept."""

    def __init__(self, data):
        top = typed(read_json(data, integer), dict)
        keys = tuple(key for key in KEYS if key in top or key not in MAY_LACK)
        form, model, cage, grids, tiles, cells, walls = members(top, *keys)[:7]
        if form != "veritope-micro-1" or tuple(top) != keys:
            raise Refused("not veritope-micro-1, or its keys are in another order")
        check_model(model)
        if len(typed(typed(cage, dict).get("entities"), list)) > MAX_VOLUMES:
            raise Refused("more than %d volumes" % MAX_VOLUMES)
        self.cage = [volume for volume, _ in checked(volumes_of(cage))]
        self.grids = [read_grid(grid, self.cage) for grid in a_list(grids, 0, MAX_GRIDS)]
        check_grids(self.grids)
        self.tiles = [read_tile(tile) for tile in a_list(tiles, 1, MAX_TILES)]
        for grid, strings in zip(self.grids, a_list(cells, len(self.grids), len(self.grids))):
            grid.cells = read_cells(grid, strings, len(self.tiles))
        has_numbers = any(extent for extent, _ in self.tiles)
        walls = a_list(walls, 0, len(self.grids) if has_numbers else 0)
        if has_numbers and len(walls) != len(self.grids):
            raise Refused("walls of %d grids" % len(walls))
        for grid, lists in zip(self.grids, walls):
            grid.walls = read_walls(grid, lists)
        self.bridges = read_bridges(top.get("bridges", []), self.grids, len(self.cage))
        self.sweeps = read_sweeps(top.get("sweeps", []), self.grids, self.bridges)
        check_materials(top.get("materials", []), self.grids)

def integer(text):
    """The values of materials have up to 16 digits and a sign."""
    if len(text) > 17 or text == "-0":
        raise Refused("too large, or 0 with a sign: %s" % text[:20])
    return int(text)

def check_model(model):
    if model is not None:
        name, digest = members(model, "name", "sha256")
        texts([name])
        if not re.fullmatch("[0-9a-f]{64}", typed(digest, str)):
            raise Refused("sha256 is not 64 digits")

def read_grid(grid, cage):
    volume, breaks = members(grid, "volume", "breaks")
    whole(volume, 0, len(cage) - 1)
    breaks = [[number(t) for t in typed(b, list)] for b in a_list(breaks, 3, 3)]
    for axis, b in enumerate(breaks):
        knots = cage[volume].knots[axis]
        if len(b) < 2 or any(s >= t for s, t in zip(b, b[1:])) or b[0] < knots[0] or b[-1] > knots[-1]:
            raise Refused("breaks do not rise, or leave the domain")
        if any(max(abs(t.numerator), t.denominator) >> MAX_BREAK_BITS for t in b):
            raise Refused("a break has a part of more than %d bits" % MAX_BREAK_BITS)
        inner = [t for n, t in enumerate(knots) if b[0] < t < b[-1] and t != knots[n - 1]]
        places = iter(b)
        if not all(t in places for t in inner):             # both rise
            raise Refused("a knot is not one of the breaks")
    return Grid(volume, breaks)

def check_grids(grids):
    if sum(grid.num_cells for grid in grids) > MAX_CELLS:
        raise Refused("more than %d cells" % MAX_CELLS)
    if any(g.volume > h.volume for g, h in zip(grids, grids[1:])):
        raise Refused("the volumes of grids do not rise")
    start = 0
    for n, grid in enumerate(grids):
        if n + 1 == len(grids) or grids[n + 1].volume != grid.volume:
            if n + 1 - start > MAX_GRIDS_OF_VOLUME:
                raise Refused("more than %d grids of volume %d" % (MAX_GRIDS_OF_VOLUME, grid.volume))
            for g, h in combinations(ranked(grids[start:n + 1]), 2):
                if all(a < d and c < b for (a, b), (c, d) in zip(g, h)):
                    raise Refused("two grids of volume %d overlap" % grid.volume)
            start = n + 1

def ranked(grids):
    """The boxes of grids; integers stand for their places."""
    axes = []
    for axis in range(3):
        order = sorted(t for g in grids for t in (g.breaks[axis][0], g.breaks[axis][-1]))
        axes.append([(bisect_left(order, g.breaks[axis][0]), bisect_left(order, g.breaks[axis][-1])) for g in grids])
    return list(zip(*axes))

def read_tile(tile):
    name, extent, patches = members(tile, "name", "range", "patches")
    texts([name])
    if extent is not None:
        lo, hi = a_list(extent, 2, 2)
        extent = whole(lo, 0, MAX_NUMBER), whole(hi, lo, MAX_NUMBER)
    patches = [read_patch(patch) for patch in a_list(patches, 1, MAX_PATCHES)]
    if (extent is None) != all(patch.wall is None for patch in patches):
        raise Refused("range is null though a patch names a wall, or the reverse")
    return extent, patches

def read_patch(patch):
    wall, degrees, lists = members(patch, "wall", "degrees", "points")
    if wall is not None:
        whole(wall, 0, 5)
    p, q = [whole(d, 1, MAX_DEGREE) for d in a_list(degrees, 2, 2)]
    n = (p + 1) * (q + 1)
    a_list(lists, 1, MAX_LISTS if wall is not None else 1)
    return Patch(wall, (p, q), [[[coordinate(c, MAX_BITS) for c in a_list(point, 3, 3)]
                                 for point in a_list(points, n, n)] for points in lists])

def read_cells(grid, strings, num_tiles):
    """A byte for each cell."""
    digits, taken, cells = -(-grid.num_cells // 4), 0, 0
    for tile, text in enumerate(a_list(strings, num_tiles, num_tiles)):
        if len(typed(text, str)) != digits or not re.fullmatch("[0-9a-f]*", text):
            raise Refused("the cells of a tile are not %d hexadecimal digits" % digits)
        bits = int(text, 16)
        if bits & taken or bits & (1 << 4 * digits - grid.num_cells) - 1:
            raise Refused("a cell holds two tiles, or does not exist")
        taken |= bits
        of_tile = format(bits, "0%db" % (4 * digits)).encode().translate(bytes.maketrans(b"01", bytes([0, tile + 1])))
        cells |= int.from_bytes(of_tile, "big")
    return cells.to_bytes(4 * digits, "big")[:grid.num_cells]

def read_walls(grid, lists):
    """The three arrays."""
    found = []
    for axis, values in enumerate(a_list(lists, 3, 3)):
        step, n = grid.stride(axis), grid.counts[axis]
        count = grid.num_cells // n * (n + 1)
        kinds = set(map(type, a_list(values, count, count)))
        if kinds != {int} or not 0 <= min(values) <= max(values) <= MAX_NUMBER:
            raise Refused("a number of a wall is no integer from 0 to %d" % MAX_NUMBER)
        for cell, wall in grid.blocks(axis):
            held, none = grid.cells[cell:cell + n * step], bytes(step)
            if not all(held):
                beside = (not (a or b) for a, b in zip(held + none, none + held))
                if any(compress(values[wall:wall + (n + 1) * step], beside)):
                    raise Refused("a wall beside which there is no tile has a number")
        found.append(array("l", values))
    return found
