# SPDX-License-Identifier: LGPL-3.0-or-later
"""The page of a predicate's bound."""
import math
import textwrap

from .bounds import FLOOR, U, derived_rel, roundings
from .cpp import Writer, camel
from .expression import post_order
from .header import by_largest, hexadecimal, leaf_in_inputs


def paragraph(text):
    return textwrap.fill(text, 150, break_long_words=False, break_on_hyphens=False)


def formula_lines(formula, names, error):
    write, done = Writer(names), set()
    used = {id(node) for node in post_order([formula.sign])}
    lines = []
    for leaf in formula.leaves:
        lines.append((names.leaf(leaf), leaf_in_inputs(leaf, lambda name: name)))
    for name, node in formula.definitions:
        if id(node) in used and not node.is_leaf and id(node) not in done:
            done.add(id(node))
            lines.append((names.of[id(node)], write.value(node, open_it=True)[0]))
    lines.append(("det", write.value(formula.sign, open_it=True)[0]))
    width = max(len(name) for name, _ in lines)
    lines += [("S", "the same with "
               + ("the largest |.| of the differences on each axis, and of the numbers," if by_largest(formula)
                  else "|.| of the differences") + " and + for -"), ("E", error)]
    return "\n".join(f"    {name:{width}} = {text}" for name, text in lines if name != text)


def write_page(formula, names, bound, place):
    name, count = camel(formula.name), roundings(formula.sign)
    steps, done = [], set()
    for label, node in formula.definitions:
        if id(node) in count and not node.is_leaf and id(node) not in done:
            done.add(id(node))
            steps.append(f"{names.of[id(node)]} {count[id(node)]}")
    first, second = series(bound.k, bound.k_magnitude)
    error = "kRel S + 2^-900"
    if bound.degree:
        power = "size" if bound.degree == 1 else f"size^{bound.degree}"
        error = f"kRel S + (kEta {power} + 2^-900), size = the largest of the differences"
    above = "README.md" if place.test else "Veritope's docs/bounds/README.md"
    readme = f"[README]({above})" if place.test else above
    k_text = f"Without the last addition k = {bound.k}" if formula.sign.is_sum else f"All in all k = {bound.k}"
    if bound.degree:
        underflow = (f"Let m be the largest difference. A product that underflows errs by 2^-1075 (2^-1022 if it is "
                     f"flushed to zero) and is multiplied by further "
                     f"differences: the error is a polynomial in m of degree {bound.degree}, and m^j <= 1 + "
                     f"m^{bound.degree} for j <= {bound.degree}. "
                     f"`k{name}Eta` = 2^{FLOOR} times m^{bound.degree}, computed from left to right, and the floor "
                     f"2^{FLOOR} pay if each is at least "
                     "the sum of the coefficients, what S and the power of m may have lost included.")
    else:
        underflow = (f"Each product errs by at most 2^-1075 (2^-1022 if it is flushed to zero) whatever its factors "
                     f"are, and is multiplied by none. The floor "
                     f"2^{FLOOR} pays.")
    script = place.script
    roundings_text = f"**Roundings** ({readme}, 2). " + (", ".join(steps) + ". " if steps else "") + \
        f"{k_text}. S: {bound.k_magnitude}."
    relative = (f"**Relative constant.** ((1+u)^{bound.k} - 1)(1+u)/(1-u)^{bound.k_magnitude + 2} = "
                f"{first}u + {second}u^2 + O(u^3). `k{name}Rel` = {hexadecimal(bound.rel)}.")
    largest = ("**Largest differences.** S is monotone in each difference, and so is every rounded operation of it: S "
               "of the largest ones is not less than that of the tuple, rounding included, and all that follows holds "
               "for it.")
    overflow = "**Overflow.** README, 5: |det| <= S holds after rounding, operation by operation, and S is part of " + \
        "E." + (f" If m^{bound.degree} overflows, E is infinite." if bound.degree > 1 else "")
    proof = "**Proof.** " + (f"[{script}]({script}), " if place.test else f"`{script}`, ") + "by Gappa" + \
        (" ([what it proves](gappa/README.md))." if place.test else ".")
    return f"""# {formula.name}

Made by `tools/generate_predicates.py` from `{place.formula}`.

{formula_lines(formula, names, error)}

{paragraph(roundings_text)}

{paragraph(relative)}

{paragraph(largest) + chr(10) * 2 if by_largest(formula) else ""}{paragraph("**Underflow.** " + underflow)}

{paragraph(overflow)}

{paragraph(proof)}
{(chr(10) + "Test: `" + place.test + "`." + chr(10)) if place.test else ""}"""


def series(k, k_magnitude):
    """Coefficients of u and u^2 of derived_rel."""
    n = k_magnitude + 2
    second = k * (k - 1) // 2 + k + k * n
    assert math.isclose(float((derived_rel(k, k_magnitude) - k * U) / U**2), second, rel_tol=1e-9)
    return k, second
