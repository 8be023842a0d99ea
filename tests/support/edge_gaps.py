# SPDX-License-Identifier: LGPL-3.0-or-later
"""Gaps of edges by their definition (docs/rules/M3.md), in rationals: for tests and for bench/soak_gaps.py."""


def squared_distance(edge, other):
    """The square of the greatest distance of an end of an edge from another edge."""
    def of_point(p):
        u = [b - a for a, b in zip(*other)]
        w = [c - a for c, a in zip(p, other[0])]
        t = min(max(sum(a * b for a, b in zip(u, w)) / sum(a * a for a in u), 0), 1)
        return sum((a - t * b) ** 2 for a, b in zip(w, u))
    return max(map(of_point, edge))
