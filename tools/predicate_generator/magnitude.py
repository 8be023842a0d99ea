# SPDX-License-Identifier: LGPL-3.0-or-later
"""S: the formula with absolute values of its terms, written with what the determinant has computed already."""


def is_monomial(node):
    """Whether S computes the absolute value of its computed value: products round alike whatever the signs."""
    return node.is_leaf or node.kind == "integer" or (node.kind in ("*", "sqr") and all(map(is_monomial, node.args)))


def is_own_magnitude(node):
    """Whether it is never negative, and S computes the same value for it."""
    if node.kind == "integer":
        return True
    if node.kind == "sqr":
        return is_monomial(node.args[0])
    return node.kind in "+*" and all(map(is_own_magnitude, node.args))
