# SPDX-License-Identifier: LGPL-3.0-or-later
"""Bit budgets, as robust/bounded.h counts them: |v| <= terms * 2^bits."""
from .expression import post_order

ONE_LIMB, TWO_LIMBS, SHORTEST, INT128 = 60, 124, 12, 126


def bits_of_terms(terms):
    return max(terms - 1, 0).bit_length()


def leaf_power(formula, leaf):
    inputs = leaf.args if leaf.args else (leaf,)
    return max(formula.scale_of[i.name][1] for i in inputs)


def budget(formula, bits, differences):
    """kBits of the sign's polynomial, for inputs (differences: leaves) of at most 2^bits."""
    found = {}
    for node in post_order([formula.sign]):
        if node.is_leaf:
            found[id(node)] = (leaf_power(formula, node) * bits, 2 if node.kind == "-" and not differences else 1)
            continue
        if node.kind == "integer":
            found[id(node)] = (0, node.value)
            continue
        a, b = found[id(node.args[0])], found[id(node.args[-1])]
        if node.kind in "+-":
            top = max(a[0], b[0])
            found[id(node)] = (top, sum(((t - 1) >> (top - p)) + 1 for p, t in (a, b)))
        else:
            found[id(node)] = (a[0] + b[0], a[1] * b[1])
    bits, terms = found[id(formula.sign)]
    return bits + bits_of_terms(terms)


def short_bits(formula):
    """The most bits of a difference of power 1 with which the polynomial fits 128 bits; None if it always does, or if
    that is too few."""
    if budget(formula, ONE_LIMB, False) <= INT128:
        return None
    for bits in range(ONE_LIMB - 2, SHORTEST - 1, -1):
        if budget(formula, bits, True) <= INT128:
            return bits
    return None
