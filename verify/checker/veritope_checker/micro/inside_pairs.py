# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Descents of pairs of nodes (docs/certificates/micro-inside.md, section 8, and microstructure.md, section 7b).

A node has a box, its greatest side `size`, a level and halves; a block of cells, or of patches, has the level -1."""
from .inside_parts import halves_of

def boxes_miss(box, other):
    a, b, c, d, e, f = box
    g, h, i, j, k, l = other
    return a > h or g > b or c > j or i > d or e > l or k > f

def descends(one, other, parts, most_level, see, are_apart):
    """Does the descent end? are_apart(x, y): whether a pair whose boxes meet is dropped; see(x): counts it, x the node
    of a part.  The larger node is halved, and no node of most_level."""
    todo = [(one, other)]
    while todo:
        x, y = todo.pop()
        if boxes_miss(x.box, y.box):
            continue
        see(x)
        if are_apart(x, y):
            continue
        if y.level == most_level or x.level != most_level and not y.size > x.size:
            if x.level == most_level:
                return False
            todo += [(kid, y) for kid in halves_of(x, parts)]
        else:
            todo += [(x, kid) for kid in halves_of(y, parts)]
    return True

def part_along(vectors, one, other):
    """Does one of the vectors part what has extent() and slack()?"""
    margin = one.slack() + other.slack()
    for vector in vectors:
        (a, b), (c, d) = one.extent(*vector), other.extent(*vector)
        if b + margin < c or d + margin < a:
            return True
    return False
