// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/named_predicate.h"

#include <utility>

#include "cli/implicit_names.h"
#include "predicates/compare_along.h"
#include "predicates/formulas.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/side_of_plane.h"
#include "robust/rational.h"

namespace veritope::cli {
namespace {

// The vector that begins at operand i.
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

}  // namespace veritope::cli
