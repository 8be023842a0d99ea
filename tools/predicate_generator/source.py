# SPDX-License-Identifier: LGPL-3.0-or-later
"""The .cc of a predicate: lattice, interval and integer tiers."""
from .budget import ONE_LIMB, TWO_LIMBS, budget, leaf_power, short_bits
from .cpp import wrapped
from .expression import polynomial_of
from .header import GENERATED, leaf_in_inputs


def groups_of(formula):
    """[(scale, power, [inputs])] in the order of their first input."""
    groups = {}
    for name in formula.inputs:
        groups.setdefault(formula.scale_of[name], []).append(name)
    return [(scale, power, inputs) for (scale, power), inputs in groups.items()]


def variable(scale, power):
    return f"{scale}_" if power == 1 else f"{scale}_{power}_"


def scaled_struct(formula, names, groups):
    scales = list(dict.fromkeys(scale for scale, _, _ in groups))
    members = [f"  std::array<Binary64, {len(inputs)}> {variable(scale, power)};" for scale, power, inputs in groups]
    members += [f"  CommonScale {scale}_scale;" for scale in scales]
    values = [wrapped(f"  s_.{variable(scale, power)} = odd_parts<{len(inputs)}>(",
                      ["{" + inputs[0], *inputs[1:-1], inputs[-1] + "}"]
                      if len(inputs) > 1 else ["{" + inputs[0] + "}"], ");", 6) for scale, power, inputs in groups]
    values += [f"  s_.{scale}_scale.include<{power}>(s_.{variable(scale, power)});" for scale, power, _ in groups]
    return "\n".join(["// Each scale of the inputs has a power of two of its own.",
                      "struct Scaled {", *members, "};", "",
                      wrapped("Scaled scaled(", names.parameters(), ") {", 6), "  Scaled s_;", *values,
                      "  return s_;", "}"])


def lattice_function(formula, names, groups):
    place = {}
    for scale, power, inputs in groups:
        place.update({name: f"{variable(scale, power)}[{i}]" for i, name in enumerate(inputs)})
    arrays = [f"  std::array<Bounded<{power if power > 1 else ''}{' * ' if power > 1 else ''}Bits>, {len(inputs)}> "
              f"{variable(scale, power)};"
              for scale, power, inputs in groups]
    puts = [f"put<{power}, Bits>(s_.{scale}_scale, s_.{variable(scale, power)}, {variable(scale, power)})"
            for scale, power, inputs in groups]
    tests = "".join(f"  if (!{p}) return Sign3::kUncertain;\n" for p in puts)
    leaves, write = formula.leaves, names.leaves()
    lines = [f"  const auto {names.leaf(node)} = {leaf_in_inputs(node, place.get)};" for node in leaves]
    short, shortened = short_bits(formula), []
    if short:
        fits = " &&\n        ".join(f"fits<{short * leaf_power(formula, node)}>({names.leaf(node)})" for node in leaves)
        call = [f"narrowed<{short * leaf_power(formula, node)}>({names.leaf(node)})" for node in leaves]
        shortened = ["  if constexpr (Bits == kOneLimbBits) {", f"    if ({fits}) {{",
                     wrapped(f"      const auto det_ = formulas::{formula.name}_det(", call, ");", 10),
                     f"      static_assert(decltype(det_)::kBits == {budget(formula, short, True)});",
                     "      return to_sign3(sign_of(det_));", "    }", "  }"]
    return "\n".join(["// The sign, if the inputs fit a lattice of that many bits.", "template <int Bits>",
                      "Sign3 on_lattice(const Scaled& s_) {", *arrays, tests.rstrip("\n"), *lines, *shortened,
                      wrapped(f"  const auto det_ = formulas::{formula.name}_det(", write, ");", 6),
                      "  static_assert(decltype(det_)::kBits ==",
                      f"                (Bits == kOneLimbBits ? {budget(formula, ONE_LIMB, False)} : "
                      f"{budget(formula, TWO_LIMBS, False)}));",
                      "  return to_sign3(sign_of(det_));", "}"])


def wide_lines(formula):
    """The exact tier: integers of any exponents on the stack."""
    degrees, total = scale_degrees(formula), budget(formula, 0, False)
    values = [f"wide<T, {formula.scale_of[name][1]}>({name})" for name in formula.inputs]
    values[0], values[-1] = "{" + values[0], values[-1] + "}"
    return [f"  using T = Wide<degree_limbs({sum(degrees.values())}, {total})>;",
            wrapped(f"  return formulas::{formula.name}_of<T>(", values, ").sign();", 6), "}"]


def scale_degrees(formula):
    """{scale: the polynomial's degree in it}"""
    degrees = {}
    for monomial in polynomial_of(formula.sign).terms:
        for scale in formula.scales():
            d = sum(e * formula.scale_of[name][1] for name, e in monomial if formula.scale_of[name][0] == scale)
            degrees[scale] = max(degrees.get(scale, 0), d)
    return degrees


def write_source(formula, names, place):
    name, args, arguments = formula.name, names.parameters(), ", ".join(names.arguments())
    groups = groups_of(formula)
    homogeneous = formula.is_homogeneous()
    inputs = list(formula.inputs)
    inputs[0], inputs[-1] = "{" + inputs[0], inputs[-1] + "}"
    if homogeneous:
        helpers = "\n\n".join([scaled_struct(formula, names, groups), lattice_function(formula, names, groups)])
        exact = [wrapped(f"Sign3 {name}_lattice(", args, ") noexcept {", 6),
                 f"  const Scaled s_ = scaled({arguments});",
                 "  const Sign3 sign_ = on_lattice<kOneLimbBits>(s_);",
                 "  return is_certain(sign_) ? sign_ : on_lattice<kTwoLimbBits>(s_);", "}", "",
                 wrapped(f"Sign {name}_exact(", args, ") noexcept {", 6), *wide_lines(formula)]
        tiers = [f"tally, [&] {{ return {name}_lattice({arguments}); }},",
                 f"[&] {{ return {name}_interval({arguments}); }},",
                 f"[&] {{ return {name}_exact({arguments}); }});"]
        first = 1
    else:
        helpers = "// No scaling makes integers of the inputs: there is no lattice tier.\n" \
                  f"constexpr std::size_t kAfterLattice = static_cast<std::size_t>(Tier::kInterval);"
        exact = [wrapped(f"Sign {name}_exact(", args, ") noexcept {", 6),
                 wrapped(f"  const auto v_ = dyadics<{len(inputs)}>(", inputs, ");", 6),
                 f"  return formulas::{name}_of<Dyadic>(v_).sign();", "}"]
        tiers = [f"tally, [&] {{ return {name}_interval({arguments}); }},",
                 f"[&] {{ return {name}_exact({arguments}); }});"]
        first = "kAfterLattice"
    body = "\n".join(exact)
    return f"""// SPDX-License-Identifier: LGPL-3.0-or-later
{GENERATED.format(source=place.formula)}
// clang-format off
#include "{place.include}"

#include "interval/interval.h"

namespace veritope::internal {{
namespace {{

{helpers}

}}  // namespace

{body}

{wrapped(f'Sign3 {name}_interval(', args, ') noexcept {', 6)}
{wrapped(f'  const std::array<double, {len(inputs)}> v_ = ' + '{', [i.strip('{}') for i in inputs], '};', 6)}
  std::array<Interval, {len(inputs)}> w_;
  for (std::size_t i_ = 0; i_ < v_.size(); ++i_) w_[i_] = Interval(v_[i_]);
  const ScopedUpward upward_;
  return formulas::{name}_of<Interval>(w_).sign();
}}

{wrapped(f'Sign {name}_after_filter(', [*args, 'TierCounts* tally'], ') noexcept {', 6)}
  return cascade<{first}>(
      {(chr(10) + '      ').join(tiers)}
}}

}}  // namespace veritope::internal
"""
