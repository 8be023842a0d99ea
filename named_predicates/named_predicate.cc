// SPDX-License-Identifier: LGPL-3.0-or-later
#include "named_predicates/named_predicate.h"

#include <utility>

#include "named_predicates/generated_cases.h"
#include "named_predicates/implicit_names.h"
#include "predicates/compare_along.h"
#include "predicates/formulas.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/side_of_plane.h"
#include "robust/rational.h"

namespace veritope {
namespace {

// The vector whose first coordinate is operand i.
Vec2d flat(const Operands& v, std::size_t i) { return {v[i], v[i + 1]}; }
Vec3d solid(const Operands& v, std::size_t i) { return {v[i], v[i + 1], v[i + 2]}; }

Sign decide_orient2d(const Operands& v, TierCounts* tally) {
  return orient2d(flat(v, 0), flat(v, 2), flat(v, 4), tally);
}
Sign decide_orient3d(const Operands& v, TierCounts* tally) {
  return orient3d(solid(v, 0), solid(v, 3), solid(v, 6), solid(v, 9), tally);
}
Sign decide_in_circle(const Operands& v, TierCounts* tally) {
  return in_circle(flat(v, 0), flat(v, 2), flat(v, 4), flat(v, 6), tally);
}
Sign decide_in_sphere(const Operands& v, TierCounts* tally) {
  return in_sphere(solid(v, 0), solid(v, 3), solid(v, 6), solid(v, 9), solid(v, 12), tally);
}
Sign decide_side_of_plane(const Operands& v, TierCounts* tally) {
  return side_of_plane({solid(v, 0), v[3]}, solid(v, 4), tally);
}
Sign decide_compare_along(const Operands& v, TierCounts* tally) {
  return compare_along(solid(v, 0), solid(v, 3), solid(v, 6), tally);
}

template <template <typename> typename Formula, std::size_t... I>
Formula<Rational> over_rationals(const Operands& v, std::index_sequence<I...>) {
  return Formula<Rational>(Rational::from_double(v[I])...);
}

template <template <typename> typename Formula, std::size_t NumOperands>
Sign by_formula(const Operands& v) {
  return over_rationals<Formula>(v, std::make_index_sequence<NumOperands>()).det().sign();
}

Sign orient3d_by_formula(const Operands& v) {
  const auto plane = over_rationals<formulas::Plane3>(v, std::make_index_sequence<9>());
  const auto from_a = [&](std::size_t axis) {
    return Rational::from_double(v[9 + axis]) - Rational::from_double(v[axis]);
  };
  return plane.det(from_a(0), from_a(1), from_a(2)).sign();
}

constexpr NamedPredicate kPredicates[] = {
    {"orient2d", "a b c", 2, 6, decide_orient2d, by_formula<formulas::Orient2d, 6>},
    {"orient3d", "a b c d", 3, 12, decide_orient3d, orient3d_by_formula},
    {"in_circle", "a b c d", 2, 8, decide_in_circle, by_formula<formulas::InCircle, 8>},
    {"in_sphere", "a b c d e", 3, 15, decide_in_sphere, by_formula<formulas::InSphere, 15>},
    {"side_of_plane", "normal offset p", 3, 7, decide_side_of_plane,
     by_formula<formulas::SideOfPlane, 7>},
    {"compare_along", "direction p q", 3, 9, decide_compare_along,
     by_formula<formulas::CompareAlong, 9>},
    {"power_circle", "a wa b wb c wc d wd", 2, 12, decide_power_circle,
     by_generated_formula<12, formulas::power_circle_of<Rational>>},
    {"power_sphere", "a wa b wb c wc d wd e we", 3, 20, decide_power_sphere,
     by_generated_formula<20, formulas::power_sphere_of<Rational>>},
    {"power_edge2d", "a wa b wb d wd", 2, 9, decide_edge<2, power_edge2d>,
     by_generated_formula<9, formulas::power_edge2d_of<Rational>>},
    {"power_edge3d", "a wa b wb d wd", 3, 12, decide_edge<3, power_edge3d>,
     by_generated_formula<12, formulas::power_edge3d_of<Rational>>},
    {"compare_distance2d", "p a b", 2, 6, decide_three<2, compare_distance2d>,
     by_generated_formula<6, formulas::compare_distance2d_of<Rational>>},
    {"compare_distance3d", "p a b", 3, 9, decide_three<3, compare_distance3d>,
     by_generated_formula<9, formulas::compare_distance3d_of<Rational>>},
    {"side_of_bisector2d", "a b p", 2, 6, decide_three<2, side_of_bisector2d>,
     side_of_bisector_by_formula<2>},
    {"side_of_bisector3d", "a b p", 3, 9, decide_three<3, side_of_bisector3d>,
     side_of_bisector_by_formula<3>},
    {"compare_lengths2d", "a b c d", 2, 8, decide_four<2, compare_lengths2d>,
     by_generated_formula<8, formulas::compare_lengths2d_of<Rational>>},
    {"compare_lengths3d", "a b c d", 3, 12, decide_four<3, compare_lengths3d>,
     by_generated_formula<12, formulas::compare_lengths3d_of<Rational>>},
    {"order_along_line2d", "a b p q", 2, 8, decide_four<2, order_along_line2d>,
     by_generated_formula<8, formulas::order_along_line2d_of<Rational>>},
    {"order_along_line3d", "a b p q", 3, 12, decide_four<3, order_along_line3d>,
     by_generated_formula<12, formulas::order_along_line3d_of<Rational>>},
    {"order_on_circle", "c p q r", 2, 8, decide_four<2, order_on_circle>,
     order_on_circle_by_formula},
};

}  // namespace

std::span<const NamedPredicate> named_predicates() { return kPredicates; }

const NamedPredicate* predicate_from_name(std::string_view name) {
  for (const auto& predicates : {named_predicates(), implicit_predicates()}) {
    for (const NamedPredicate& predicate : predicates) {
      if (predicate.name == name) return &predicate;
    }
  }
  return nullptr;
}

std::string predicate_names() {
  std::string names;
  for (const auto& predicates : {named_predicates(), implicit_predicates()}) {
    for (const NamedPredicate& predicate : predicates) {
      names += (names.empty() ? "" : ", ") + std::string(predicate.name);
    }
  }
  return names;
}

std::string tiers_text(const TierCounts& tiers) {
  constexpr std::array<const char*, kNumTiers> kNames = {"filter", "lattice", "interval", "exact"};
  std::string text;
  for (std::size_t i = 0; i < kNumTiers; ++i) {
    text += (text.empty() ? "" : ", ") + std::string(kNames[i]) + " " +
            std::to_string(tiers.decided[i]);
  }
  return text;
}

}  // namespace veritope
