# SPDX-License-Identifier: LGPL-3.0-or-later
"""Laws of a formula file, checked as identities of polynomials."""
from .expression import Polynomial, polynomial_of
from .formula import inputs_of

FACTORS = {"negates": -1, "keeps": 1}


def read_laws(formula, fail):
    """[(kind, {argument: argument}, factor)]: "permute" and "translate". Calls fail for a law that does not hold."""
    found = []
    for line, column, text in formula.laws:
        what, _, effect = text.partition(":")
        words = what.split()
        if effect.strip() not in FACTORS or not words or words[0] not in ("swap", "translate"):
            fail("expected: law swap A B[, C D...] : negates|keeps, or law translate [A B ...] : keeps", column, line)
        factor = FACTORS[effect.strip()]
        if words[0] == "translate":
            found.append(translation(formula, words[1:], factor, lambda message: fail(message, column, line)))
        else:
            found.append(exchange(formula, what.split(None, 1)[1] if len(words) > 1 else "", factor,
                                  lambda message: fail(message, column, line)))
    return found


def exchange(formula, text, factor, fail):
    dimension, mapping = dict(formula.arguments), {}
    for pair in text.split(","):
        names = pair.split()
        are_new = all(name in dimension and name not in mapping for name in names)
        if len(names) != 2 or names[0] == names[1] or not are_new:
            fail(f"two arguments expected that occur once, but there is {pair.strip()!r}")
        if dimension[names[0]] != dimension[names[1]]:
            fail(f"{names[0]} and {names[1]} have different dimensions")
        mapping.update({names[0]: names[1], names[1]: names[0]})
    rename = {}
    for a, b in mapping.items():
        rename.update(zip(inputs_of(a, dimension[a]), inputs_of(b, dimension[b])))
    changed = polynomial_of(formula.sign, rename=rename)
    if changed.combine(polynomial_of(formula.sign), -factor).terms:
        fail(f"this law does not hold: swapping {text.strip()} does not {'negate' if factor < 0 else 'keep'} the "
             f"sign's polynomial")
    return "permute", mapping, factor


def translation(formula, names, factor, fail):
    """All points, or the arguments named, move by one vector."""
    dimension = dict(formula.arguments)
    names = names or [name for name, d in formula.arguments if d]
    if factor != 1 or not all(dimension.get(name) for name in names):
        fail("a translation of points keeps the sign, or is no law")
    values = {}
    for name in names:
        for i in inputs_of(name, dimension[name]):
            values[i] = Polynomial({((i, 1),): 1, (("shift" + i[-2:], 1),): 1})
    if polynomial_of(formula.sign, values=values).combine(polynomial_of(formula.sign), -1).terms:
        fail(f"this law does not hold: moving {' '.join(names)} by one vector changes the sign's polynomial")
    return "translate", {name: name for name in names}, 1
