# SPDX-License-Identifier: LGPL-3.0-or-later
"""The tests of a predicate: what depends on it. tests/predicates/generated/subject.h has what they share."""
from .cpp import camel, wrapped
from .formula import AXES
from .header import GENERATED, law_text

HAND = {  # name: header, object, det, magnitude; @ are the operands
    "orient2d": ("predicates/formulas.h", "formulas::Orient2d<double>(@)", "f.det()", "f.magnitude(kAbs)"),
    "orient3d": ("predicates/orient3d.h",
                 "formulas::Plane3<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8])",
                 "f.det(v[9] - v[0], v[10] - v[1], v[11] - v[2])",
                 "f.magnitude(v[9] - v[0], v[10] - v[1], v[11] - v[2], kAbs)"),
    "in_circle": ("predicates/formulas.h", "formulas::InCircle<double>(@)", "f.det()", "f.magnitude(kAbs)"),
    "in_sphere": ("predicates/formulas.h", "formulas::InSphere<double>(@)", "f.det()", "f.magnitude(kAbs)"),
    "side_of_plane": ("predicates/formulas.h", "formulas::SideOfPlane<double>(@)", "f.det()", "f.magnitude(kAbs)"),
    "compare_along": ("predicates/formulas.h", "formulas::CompareAlong<double>(@)", "f.det()", "f.magnitude(kAbs)"),
    "normal_along": ("solids/polyhedron/normal_along.h",
                     "formulas::NormalAlong<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], kAbs)",
                     "f.det(v[9], v[10], v[11])", "f.magnitude(v[9], v[10], v[11], kAbs)"),
    "separator": ("solids/polyhedron/separator.h", "0",
                  "formulas::dot3(v[0], v[1], v[2], v[6], v[7], v[8]) - formulas::dot3(v[0], v[1], v[2], v[3], v[4], "
                  "v[5])", ""),
    "separator_ray": ("solids/polyhedron/separator.h", "0",
                      "formulas::dot3(v[0], v[1], v[2], v[6] - v[3], v[7] - v[4], v[8] - v[5])", ""),
    "implicit_line_plane": ("predicates/implicit_formulas.h",
                            "formulas::line_plane(from(3, 0), from(9, 6), from(12, 6), from(6, 0))",
                            "formulas::orientation(f, from(0, 15), from(18, 15), from(21, 15))", ""),
    "implicit_three_planes": ("predicates/implicit_formulas.h",
                              "formulas::three_planes<double>({from(3, 0), from(6, 0), {}}, {from(12, 9), from(15, 9), "
                              "from(9, 0)}, "
                              "{from(21, 18), from(24, 18), from(18, 0)})",
                              "formulas::orientation(f, from(0, 27), from(30, 27), from(33, 27))", ""),
}


def call_of(formula):
    """The arguments, from an array v of the numbers."""
    parts, at = [], 0
    for _, dimension in formula.arguments:
        count = dimension or 1
        values = [f"v[{i}]" for i in range(at, at + count)]
        parts.append("{" + ", ".join(values) + "}" if dimension else values[0])
        at += count
    return parts


def laws_text(formula):
    rows = []
    first = {name: formula.inputs.index(name + ".x" if dimension else name) for name, dimension in formula.arguments}
    for kind, mapping, factor in formula.laws:
        if kind == "permute":
            order = []
            for name, dimension in formula.arguments:
                begin = first[mapping.get(name, name)]
                order += range(begin, begin + (dimension or 1))
            rows.append(f"{{{factor}, {{{', '.join(map(str, order))}}}, {{}}}}")
        else:
            axes = []
            for name, dimension in formula.arguments:
                axes += [str(i) if name in mapping else "-1" for i in range(dimension)] or ["-1"]
            rows.append(f"{{1, {{}}, {{{', '.join(axes)}}}}}")
    return rows


def examples_of(formula):
    return [f"{{{{{', '.join(numbers)}}}, Sign::{('kNegative', 'kZero', 'kPositive')[sign + 1]}}}"
            for _, _, numbers, sign in formula.examples]


def write_test(formula, names, bound, place):
    name, type_name, n = formula.name, camel(formula.name), len(formula.inputs)
    arguments = ", ".join(call_of(formula))
    axes = [str(AXES.index(i[-1])) if "." in i else "-1" for i in formula.inputs]
    powers = [str(formula.scale_of[i][1]) for i in formula.inputs]
    lattice = f"internal::{name}_lattice({arguments})" if formula.is_homogeneous() else "Sign3::kUncertain"
    examples = examples_of(formula)
    kinds = ["d" if leaf.args else "x" for leaf in formula.leaves]
    symbols = ["m"] * len(kinds)
    eta = f"internal::k{type_name}Eta" if bound.degree else "0"
    subtract = " - 1" if formula.sign.is_sum else ""
    return f"""// SPDX-License-Identifier: LGPL-3.0-or-later
{GENERATED.format(source=place.formula)}
// clang-format off
#include "predicates/generated/{name}.h"
#include "tests/predicates/generated/subject.h"

namespace veritope {{
namespace {{

using generated::Operands;

Sign by_formula(const Operands& v) {{
  std::array<Rational, {n}> w;
  for (std::size_t i = 0; i < {n}; ++i) w[i] = Rational::from_double(v[i]);
  return formulas::{name}_of<Rational>(w).sign();
}}

const bool kRegistered = generated::add({{
    .name = "{name}",
    .axes = {{{', '.join(axes)}}},
    .powers = {{{', '.join(powers)}}},
    .has_lattice = {str(formula.is_homogeneous()).lower()},
    .decide = [](const Operands& v, TierCounts* tally) {{ return {name}({arguments}, tally); }},
    .filter = [](const Operands& v) {{ return {name}_filter({arguments}); }},
    .lattice = [](const Operands& v) {{ return {lattice}; }},
    .interval = [](const Operands& v) {{ return internal::{name}_interval({arguments}); }},
    .exact = [](const Operands& v) {{ return internal::{name}_exact({arguments}); }},
    .by_formula = by_formula,
    .laws = {{{', '.join(laws_text(formula))}}},
    .examples = {{{(', ' + chr(10) + '                 ').join(examples)}}},
}});

TEST({type_name}Bound, ConstantsFollowFromTheFormula) {{
  [[maybe_unused]] const bounds::RoundingCount x, d = x - x;
{wrapped(f'  const auto det = formulas::{name}_det(', kinds, ');', 6)}
{wrapped(f'  const auto magnitude = formulas::{name}_magnitude(', ['bounds::kSame', *kinds], ');', 6)}
  EXPECT_EQ(det.roundings{subtract}, {bound.k});
  bounds::expect_tight(internal::k{type_name}Rel, det.roundings{subtract}, magnitude.roundings);
  for (const Rational& unit : {{bounds::underflow_unit(), bounds::flush_unit()}}) {{
    const auto m = bounds::UnderflowCount::bounded_by(0, unit);
{wrapped(f'    const auto value = formulas::{name}_det(', symbols, ');', 8)}
{wrapped(f'    const auto sum = formulas::{name}_magnitude(', ['bounds::kSame', *symbols], ');', 8)}
    generated::expect_underflow_paid<{bound.degree}>(value, sum, m, internal::k{type_name}Rel, {eta});
  }}
}}

{size_test(formula, bound)}}}  // namespace
}}  // namespace veritope
"""


def size_test(formula, bound):
    if not bound.degree:
        return ""
    name, n = formula.name, len(formula.leaves)
    call = ", ".join(f"v[{i}]" for i in range(n))
    return f"""TEST({camel(name)}Bound, TheErrorCountsEveryDifference) {{
  generated::expect_size_counts_every<{bound.degree}, {n}>(internal::k{camel(name)}Eta, [](const auto& v) {{
    return internal::{name}_error({call}, kFilterFloor);
  }});
}}

"""


def write_same_formulas_test(formulas):
    from .cpp import Names
    from .header import functions
    templates, checks = [], []
    for formula in formulas:
        header, make, det, magnitude = HAND[formula.name]
        n = len(formula.inputs)
        templates.append(functions(formula, Names(formula)))
        made = make.replace("@", ", ".join(f"v[{i}]" for i in range(n)))
        leaves = ", ".join(f"v[{formula.inputs.index(a.args[0].name)}] - v[{formula.inputs.index(a.args[1].name)}]"
                           if a.args else
                           f"v[{formula.inputs.index(a.name)}]" for a in formula.leaves)
        second = f"""
    expect_same({magnitude}, page::{formula.name}_magnitude(kAbs, {leaves}));""" if magnitude else ""
        checks.append(f"""TEST(SameFormulas, {camel(formula.name)}) {{
  on_random_operands<{n}>([](const auto& v) {{
    [[maybe_unused]] const auto from = [&](int to, int base) {{ return difference(v, to, base); }};
    [[maybe_unused]] const auto f = {made};
    expect_same({det}, page::{formula.name}_of<double>(v));{second}
  }});
}}""")
    headers = sorted({HAND[formula.name][0] for formula in formulas})
    return f"""// SPDX-License-Identifier: LGPL-3.0-or-later
// The formulas of docs/bounds/gappa/*.formula, from which the proofs are made, and those of the code: the same doubles.
// Made by tools/generate_predicates.py from docs/bounds/gappa/*.formula: do not edit.
// clang-format off
{chr(10).join(f'#include "{header}"' for header in headers)}
#include "tests/predicates/generated/same_formulas.h"

namespace veritope::page {{
using formulas::sqr;

{(chr(10) * 2).join(templates)}
}}  // namespace veritope::page

namespace veritope {{
namespace {{

{(chr(10) * 2).join(checks)}

}}  // namespace
}}  // namespace veritope
"""
