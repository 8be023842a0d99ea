# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Many lies out of one about a microstructure, in a hundredth of the time: in another cage, in cells of other sizes, with its patches in another
order and with other first corners. A lie stays one, by the same condition, and its numbers are those that it had."""
import functools
import json
import random
from fractions import Fraction as Q

import vmodel_liars
import vmodel_models as models

CAGES, POOL = ("cube", "bent", "rational", "mirrored"), 64


class Fixed:
    """A cage whose file and proof are written once. maps, codes: as those of a plan of vmodel_forge.py."""

    def __init__(self, plan):
        plan = plan.changed(subject_format="vjson", text=None)
        self.maps, self.codes, self.written, self.proof = plan.maps, plan.codes, plan.model(), plan.body()

    def model(self):
        return self.written

    def body(self):
        return self.proof


@functools.lru_cache(POOL)
def cage(k):
    """One volume with the parameters [0, 1]^3, moved, turned and scaled."""
    rng = random.Random(k)
    return Fixed(vmodel_liars.placed(models.honest(CAGES[k % len(CAGES)]), rng))


class Written:
    """The text of a tile whose patches can be turned and brought into another order."""

    def __init__(self, tile):
        self.head = "{\"name\": %s, \"range\": %s, \"patches\": [\n" % (json.dumps(tile.name), json.dumps(tile.extent))
        self.turned = [[text_of(patch) for patch in four_turns(patch)] for patch in tile.patches]
        self.order = list(range(len(self.turned)))
        self.turns = [0] * len(self.turned)

    def shuffled(self, rng):
        new = object.__new__(Written)
        new.head, new.turned, new.order = self.head, self.turned, list(self.order)
        rng.shuffle(new.order)
        new.turns = [rng.randrange(4) for _ in self.order]
        return new

    def json(self):
        return self.head + ",\n".join(self.turned[n][self.turns[n]] for n in self.order) + "]}"


def four_turns(patch):
    """S(u, v), S(v, 1 - u) and so on."""
    found = [patch]
    for _ in range(3):
        wall, (p, q), lists = found[-1]
        found.append((wall, (q, p), [[points[b * (q + 1) + q - a] for a in range(q + 1) for b in range(p + 1)] for points in lists]))
    return found


def text_of(patch):
    wall, degrees, lists = patch
    return "{\"wall\": %s, \"degrees\": [%d, %d], \"points\": %s}" % (
        "null" if wall is None else wall, *degrees, json.dumps([[[str(c) for c in p] for p in points] for points in lists]))


def can_move(lie):
    """Its cage is one volume without breaks whose faces are all in the border."""
    maps = lie.cage.maps
    return len(maps) == 1 and not any(lie.cage.codes) and all(t[0] == 0 and t[-1] == 1 and len(set(t)) == 2 for t in maps[0].knots)


def other_breaks(breaks, rng):
    """Other places; both ends of the volume stay ends."""
    inner = [t for t in breaks if 0 < t < 1]
    places = sorted(Q(i, 64) for i in rng.sample(range(1, 64), len(inner)))
    return [Q(0)] * (breaks[0] == 0) + places + [Q(1)] * (breaks[-1] == 1)


def variants(lie, rng, n):
    """n of them. REQUIRES: no method of lie was replaced, but its fields alone."""
    proofs = getattr(lie, "proofs", [None] * len(lie.tiles))
    tiles = [tile if proof else Written(tile) for tile, proof in zip(lie.tiles, proofs)]
    moves, has_bridges = can_move(lie) and not getattr(lie, "sweeps", ()), bool(getattr(lie, "bridges", ()))
    for _ in range(n):
        new = [tile.shuffled(rng) if isinstance(tile, Written) else tile for tile in tiles]
        fields = {"tiles": new, "hints": [(centre, tile.order.index(exit) if isinstance(tile, Written) and exit < len(tile.order) else exit)
                                          for (centre, exit), tile in zip(lie.hints, new)]}
        if moves:
            fields["cage"] = cage(rng.randrange(POOL))
            if not has_bridges and len(lie.grids) == 1:
                fields["grids"] = [(0, [other_breaks(b, rng) for b in lie.grids[0][1]])]
        yield lie.changed(**fields)
