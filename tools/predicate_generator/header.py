# SPDX-License-Identifier: LGPL-3.0-or-later
"""The header of a predicate: contract, formula, filter."""
from .bounds import FLOOR
from .cpp import camel, comment, det_lines, flat, magnitude_lines, statement, wrapped
from .expression import polynomial_of

GENERATED = "// Made by tools/generate_predicates.py from {source}: do not edit."


def law_text(formula, law):
    kind, mapping, factor = law
    if kind == "translate":
        points = [name for name, dimension in formula.arguments if dimension]
        what = "all points move" if sorted(mapping) == sorted(points) else " and ".join(mapping) + " move"
        return f"it does not change when {what} by the same vector exactly"
    pairs = [f"{a} and {b}" for a, b in mapping.items() if a < b]
    return f"swapping {', '.join(pairs)} {'negates it' if factor < 0 else 'does not change it'}"


def contract(formula):
    texts = formula.texts
    laws = [law_text(formula, law) for law in formula.laws]
    if formula.is_homogeneous() and len(formula.scales()) == 1:
        powers = {power for _, power in formula.scale_of.values()}
        laws.append("it does not change when " + ("all coordinates are scaled by one power of two" if powers == {1} else
                                                  "lengths are scaled by a power of two and weights by its square"))
    lines = [comment(f"The exact sign of {texts['claim']}" + (" Laws:" if laws else ""))]
    lines += [comment(f"({i}) {law}{';' if i < len(laws) else '.'}", "///   ", "") for i, law in enumerate(laws, 1)]
    if "zero" in texts:
        lines.append(comment(f"Degenerate input: {texts['zero']}"))
    lines.append("/// REQUIRES finite numbers; all are allowed, the subnormal and the largest included.")
    degree = polynomial_of(formula.sign).degree()
    lines.append(f"/// @cost a polynomial of degree {degree} in binary64 where the filter decides" +
                 ("" if formula.is_homogeneous() else "; the last tier uses the heap"))
    return "\n".join(lines)


def leaf_in_inputs(node, name_of):
    return " - ".join(name_of(a.name) for a in node.args) if node.args else name_of(node.name)


def functions(formula, names):
    """The templates over any ring."""
    name, leaves = formula.name, names.leaves()
    det, sign = det_lines(formula, names)
    magnitude, size = magnitude_lines(formula, names)
    parameters = [f"const auto& {leaf}" for leaf in leaves]
    index = {i: f"v[{k}]" for k, i in enumerate(formula.inputs)}
    calls = [leaf_in_inputs(node, index.get) for node in formula.leaves]

    def returned(expression):
        return statement("result", expression).replace("const auto result =", "return", 1)

    parts = [comment("The polynomial, of the differences of the inputs that it is made of."),
             wrapped(f"constexpr auto {name}_det(", parameters, ") {"), *det, returned(sign), "}",
             comment("The sum of its absolute terms; no term of det exceeds its term after rounding."),
             "template <typename Abs>",
             wrapped(f"constexpr auto {name}_magnitude(", ["[[maybe_unused]] Abs abs", *parameters], ") {"), *magnitude,
             returned(size), "}",
             comment("The polynomial of the inputs, in the order of the arguments."),
             "template <typename T>",
             f"constexpr T {name}_of(const std::array<T, {len(formula.inputs)}>& v) {{",
             wrapped(f"  return {name}_det(", calls, ");", 6), "}"]
    return "\n".join(parts)


ABS = "[](FilterReal v) -> FilterReal { return std::abs(static_cast<double>(v)); }"


def by_largest(formula):
    """Whether S is computed from the largest difference of each axis, and the largest of the numbers, instead of each
    one."""
    return formula.texts.get("bound") == "largest"


def largest_name(leaf):
    name = (leaf.args or (leaf,))[0].name
    return f"largest_{name[-1]}_" if "." in name else "largest_number_"


def error_function(formula, names, bound):
    """The error bound of the determinant as a function of the differences."""
    name, leaves, const = formula.name, names.leaves(), "k" + camel(formula.name)
    lines = [wrapped(f"inline double {name}_error(",
                     [f"FilterReal {leaf}" for leaf in leaves] + ["double floor_"], ") {")]
    if by_largest(formula):
        of, members = {}, {}
        for node, leaf in zip(formula.leaves, leaves):
            of[leaf] = largest_name(node)
            members.setdefault(of[leaf], []).append(leaf)
        lines += [wrapped(f"  const FilterReal {group} = largest_of(", inside, ");", 6)
                  for group, inside in members.items()]
        terms, leaves = [of[leaf] for leaf in leaves], list(members)
    else:
        terms = leaves
    lines.append(wrapped(f"  const FilterReal magnitude_ = formulas::{name}_magnitude(", [ABS, *terms], ");", 6))
    if bound.degree:
        power = "size_" if bound.degree == 1 else f"power_of<{bound.degree}>(size_)"
        lines += [wrapped("  const FilterReal size_ = largest_of(", leaves, ");", 6),
                  f"  return FilterReal({const}Rel) * magnitude_ +",
                  f"         (FilterReal({const}Eta) * {power} + FilterReal(floor_));", "}"]
    else:
        lines += [f"  return FilterReal({const}Rel) * magnitude_ + FilterReal(floor_);", "}"]
    return "\n".join(lines)


def filter_lines(formula, names):
    name, leaves = formula.name, names.leaves()
    lines = [f"  const FilterReal {names.leaf(node)} = {leaf_in_inputs(node, 'FilterReal({})'.format)};"
             for node in formula.leaves
             if not (node.kind == "input" and names.leaf(node) == node.name)]
    values = [names.leaf(node) if node.args or names.leaf(node) != node.name else f"FilterReal({node.name})"
              for node in formula.leaves]
    lines += [wrapped(f"  const FilterReal det_ = formulas::{name}_det(", values, ");", 6),
              "  return sign_beyond(det_, [&](double floor_) {",
              wrapped(f"    return internal::{name}_error(", [*leaves, "floor_"], ");", 8), "  });"]
    return "\n".join(lines)


def write_header(formula, names, bound, place):
    """place: paths for the comments and #includes."""
    name, const = formula.name, "k" + camel(formula.name)
    args = names.parameters()
    vec = any(dimension for _, dimension in formula.arguments)
    homogeneous = formula.is_homogeneous()
    tiers = ["Sign3 {}_lattice("] if homogeneous else []
    tiers += ["Sign3 {}_interval(", "Sign {}_exact("]
    declarations = [wrapped(t.format(name), args, ") noexcept;", 6) for t in tiers]
    declarations.append(wrapped(f"Sign {name}_after_filter(", [*args, "TierCounts* tally"], ") noexcept;", 6))
    constants = [f"inline constexpr double {const}Rel = {hexadecimal(bound.rel)};"]
    if bound.degree:
        constants.append(f"inline constexpr double {const}Eta = 0x1p{FLOOR};")
    underflow = "underflow, S = the sum of the absolute terms" + \
        (", of the largest difference on each axis" if by_largest(formula) else "") + ", u = 2^-53."
    derived = f"Derived  {place.page}, and again in {place.test}." if place.test else f"Derived  {place.page}."
    return f"""// SPDX-License-Identifier: LGPL-3.0-or-later
// {place.header}: {formula.texts['question']}
{GENERATED.format(source=place.formula)}
{f"// Source: {formula.texts['source']}." + chr(10) if 'source' in formula.texts else ''}// Bound: {place.page}.
// clang-format off
#pragma once
#include <array>
#include <cmath>

#include "predicates/formulas.h"
#include "predicates/generated/scaling.h"
{'#include "predicates/vec.h"' + chr(10) if vec else ''}#include "robust/base/fp_strict.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"
#include "robust/filter.h"

VT_PRECISE_BEGIN
namespace veritope {{

{contract(formula)}
{wrapped(f'Sign {name}(', [*args, 'TierCounts* tally = nullptr'], ') noexcept;', 6)}

/// First tier. Never zero: a sign or uncertain.
/// Claim    a certain answer is the exact sign.
{comment(f"Bound    |det - exact| <= ({bound.k}u + O(u^2)) S + {underflow}", '/// ', '         ')}
{comment(derived, '/// ', '         ')}
/// Needs    round to nearest, gradual underflow; elsewhere it is uncertain (robust/base/fp_guard.h).
{wrapped(f'Sign3 {name}_filter(', args, ') noexcept;', 6)}

namespace internal {{
{chr(10).join(constants)}

{chr(10).join(declarations)}
}}  // namespace internal

namespace formulas {{
{functions(formula, names)}
}}  // namespace formulas

{write_bodies(formula, names, bound)}
}}  // namespace veritope
VT_PRECISE_END
"""


def write_bodies(formula, names, bound):
    """What stands below the declarations."""
    name, args, arguments = formula.name, names.parameters(), names.arguments()
    return f"""// Bodies.

namespace internal {{
{error_function(formula, names, bound)}
}}  // namespace internal

{wrapped(f'inline Sign3 {name}_filter(', args, ') noexcept {', 6)}
{filter_lines(formula, names)}
}}

{wrapped(f'inline Sign {name}(', [*args, 'TierCounts* tally'], ') noexcept {', 6)}
  return cascade(
      tally, [&]() VT_TIER {{ return {name}_filter({', '.join(arguments)}); }},
      [&](TierCounts* rest_)
          VT_TIER {{ return internal::{name}_after_filter({', '.join(arguments)}, rest_); }});
}}
"""


def hexadecimal(value):
    """As in the code by hand: 0x1.8000000000007p-52."""
    text = float(value).hex()
    mantissa, exponent = text.split("p")
    return mantissa.rstrip("0").rstrip(".") + "p" + exponent
