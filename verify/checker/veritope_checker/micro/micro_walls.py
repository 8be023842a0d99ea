# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The cells of grids and the walls that meet (docs/certificates/microstructure.md, section 6): G1, G2, T4."""
from array import array
from bisect import bisect_right
from functools import lru_cache
from itertools import compress
from math import prod

from ..common.errors import Reject
from ..vmodel.vmodel_glue import parts
from ..vmodel.vmodel_pieces import OTHERS
from .micro_caps import UNPLACED

MAX_MEETINGS = 1 << 24

# ---------------------------------------------------------------- G1, G2

def test_cells(grids, tiles, is_collapsed, skip):
    """is_collapsed(grid, wall): whether the end of the grid lies in a collapsed face."""
    for grid in grids:
        collapsed = [w for w in range(6) if is_collapsed(grid, w)]
        wrong = [(cell, "G1") for cell in out_of_range(grid, tiles)] if "G1" not in skip else []
        if "G2" not in skip:
            wrong += [(cell, "G2") for w in collapsed for cell in border(grid, w) if grid.cells[cell]
                      and tiles[grid.cells[cell] - 1].in_wall[w]]
        if wrong:
            cell, condition = min(wrong)
            raise Reject(condition, "cell %d of a grid in volume %d" % (cell, grid.volume))

def out_of_range(grid, tiles):
    """The first cell for each tile and wall."""
    for n, tile in enumerate(tiles):
        held = grid.cells.translate(bytes(k == n + 1 for k in range(256)))
        for wall in sorted({patch.wall for patch in tile.patches} - {None}) if any(held) else ():
            axis, end, (lo, hi) = wall // 2, wall % 2, tile.extent
            step = grid.stride(axis)
            for cell, first in grid.blocks(axis):
                length = step * grid.counts[axis]
                numbers, first = grid.walls[axis], first + end * step
                found = compress(numbers[first:first + length], held[cell:cell + length])
                if not all(lo <= k <= hi for k in found):
                    yield next(c for c in range(cell, cell + length) if held[c]
                               and not lo <= numbers[first + c - cell] <= hi)
                    break

def lies_in_face(grid, wall, volumes):
    """Is the end of the grid that of its volume?"""
    knots = volumes[grid.volume].knots[wall // 2]
    return grid.breaks[wall // 2][-(wall % 2)] == knots[-(wall % 2)]

def face_of_wall(grid, cell, wall, volumes):
    """The number of the face of the volume in which a wall of a cell lies, or None."""
    axis, end = wall // 2, wall % 2
    at_end = grid.index(cell)[axis] == end * (grid.counts[axis] - 1)
    return 6 * grid.volume + wall if at_end and lies_in_face(grid, wall, volumes) else None

def border(grid, wall):
    """The cells at an end of the grid."""
    axis = wall // 2
    step, n = grid.stride(axis), grid.counts[axis]
    for cell, _ in grid.blocks(axis):
        first = cell + wall % 2 * (n - 1) * step
        yield from range(first, first + step)


# ---------------------------------------------------------------- walls that meet

class Meetings:
    """The pairs of cells that have equal caps.  first, second: cells, counted over all grids; matches[kinds[n]]: what
    pair n has in common."""

    def __init__(self, grids, caps):
        self.grids, self.caps, self.count = grids, caps, 0
        self.first, self.second, self.kinds, self.matches, self.number_of = array("L"), array("L"), array("L"), [], {}
        self.base = [0]
        for grid in grids:
            self.base.append(self.base[-1] + grid.num_cells)

    def find(self, volumes, codes):
        for n, grid in enumerate(self.grids):
            for axis in range(3):
                self.in_grid(n, grid, axis)
        sheets = [(n, wall) for n in range(len(self.grids)) for wall in range(6)]
        planes, faces = {}, {}
        for n, wall in sheets:
            grid = self.grids[n]
            t = grid.breaks[wall // 2][-(wall % 2)]
            plane = grid.volume, wall // 2, "%x/%x" % (t.numerator, t.denominator)
            planes.setdefault(plane, ([], []))[wall % 2].append(n)
            if lies_in_face(grid, wall, volumes):
                faces.setdefault(6 * grid.volume + wall, []).append(n)
        for (_, axis, _), (begin, end) in planes.items():
            for n in end:
                for m in begin:
                    self.in_plane((n, 2 * axis + 1), (m, 2 * axis), 0, lambda grid, a: self.grids[grid].breaks[a])
        breaks_of = self.in_face(volumes)
        for f, code in enumerate(codes):
            if type(code) is tuple:
                for n in faces.get(f, ()):
                    for m in faces.get(code[0], ()):
                        self.in_plane((n, f % 6), (m, code[0] % 6), code[1], breaks_of)

    def in_face(self, volumes):
        """The function of a grid and an axis that brings the grid's breaks to [0, 1] over the domain."""
        @lru_cache(None)
        def breaks_of(grid, axis):
            knots = volumes[self.grids[grid].volume].knots[axis]
            return parts([knots[0], *self.grids[grid].breaks[axis], knots[-1]])[1:-1]
        return breaks_of

    def see(self, cell, other, match):
        if match.pairs:
            kind = self.number_of.setdefault(match.key, len(self.matches))
            if kind == len(self.matches):
                self.matches.append(match)
            self.first.append(cell)
            self.second.append(other)
            self.kinds.append(kind)

    def in_grid(self, n, grid, axis):
        """Neighbours along the axis."""
        base, step, length, families = self.base[n], grid.stride(axis), grid.counts[axis] * grid.stride(axis), {}
        for cell, _ in grid.blocks(axis):
            beside = zip(grid.cells[cell:cell + length - step], grid.cells[cell + step:cell + length])
            for c, pair in enumerate(beside, cell):
                if not (pair[0] and pair[1]):
                    continue
                if pair not in families:
                    families[pair] = self.caps.family(pair[0] - 1, 2 * axis + 1, pair[1] - 1, 2 * axis, UNPLACED)
                match = families[pair]
                if match is None:
                    match = self.caps.match(pair[0] - 1, 2 * axis + 1, (grid, c),
                                            pair[1] - 1, 2 * axis, (grid, c + step))
                if match.pairs:
                    self.see(base + c, base + c + step, match)

    def in_plane(self, one, other, symmetry, breaks_of):
        """Two ends of grids, (grid, wall); the symmetry takes the parameters of the first to those of the second."""
        (n, wall), (m, other_wall) = one, other
        grid, next_grid, exchanged = self.grids[n], self.grids[m], symmetry & 1
        axes, others, overlaps = OTHERS[wall // 2], OTHERS[other_wall // 2], []
        for k in (0, 1):
            theirs = breaks_of(m, others[k ^ exchanged])
            reverse = bool(symmetry & (4 if k ^ exchanged else 2))
            overlaps.append(self.overlaps(breaks_of(n, axes[k]), theirs, reverse))
        if not overlaps[0] or not overlaps[1]:
            return
        self.count += prod(sum(map(len, of_axis.values())) for of_axis in overlaps)
        if self.count > MAX_MEETINGS:
            raise Reject("T4", "more than %d pairs of walls meet" % MAX_MEETINGS)
        start = wall % 2 * (grid.counts[wall // 2] - 1) * grid.stride(wall // 2)
        next_start = other_wall % 2 * (next_grid.counts[other_wall // 2] - 1) * next_grid.stride(other_wall // 2)
        steps, next_steps = [grid.stride(a) for a in axes], [next_grid.stride(others[k ^ exchanged]) for k in (0, 1)]
        for i, beside_i in overlaps[0].items():
            for j, beside_j in overlaps[1].items():
                cell = start + i * steps[0] + j * steps[1]
                tile = grid.cells[cell]
                for k, place_k in beside_i if tile else ():
                    for l, place_l in beside_j:
                        next_cell = next_start + k * next_steps[0] + l * next_steps[1]
                        if next_grid.cells[next_cell]:
                            self.see(self.base[n] + cell, self.base[m] + next_cell, self.caps.match(
                                tile - 1, wall, (grid, cell), next_grid.cells[next_cell] - 1, other_wall,
                                (next_grid, next_cell), (exchanged, place_k, place_l)))

    def overlaps(self, ours, theirs, reverse):
        """{interval: [(interval of theirs that overlaps it, its place)]}"""
        found, count = {}, len(theirs) - 1
        if reverse:
            theirs = [1 - t for t in reversed(theirs)]
        first = max(0, bisect_right(ours, theirs[0]) - 1)
        for i in range(first, len(ours) - 1):
            lo, hi = ours[i:i + 2]
            if lo >= theirs[-1]:
                break
            n = max(0, bisect_right(theirs, lo) - 1)
            while n < count and theirs[n] < hi:
                size = (theirs[n + 1] - theirs[n]) / (hi - lo)
                place = (self.caps.place(-size, (theirs[n + 1] - lo) / (hi - lo)) if reverse else
                         self.caps.place(size, (theirs[n] - lo) / (hi - lo)))
                found.setdefault(i, []).append((count - 1 - n if reverse else n, place))
                n += 1
        return found
