// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/generated/subject.h: a generated predicate as data, so that one body of tests
// serves all of them, and the underflow part of the bound tests.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "predicates/generated/scaling.h"
#include "robust/base/sign.h"
#include "robust/base/fp_state.h"
#include "robust/cascade.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope::bounds {

template <int N>
RoundingCount multiple(const RoundingCount& x) {
  return {x.roundings + 1};
}
template <int N>
UnderflowCount multiple(const UnderflowCount& x) {
  UnderflowCount n;
  n.size = Polynomial::constant(Rational(N));
  n.unit = x.unit;
  return n * x;
}

}  // namespace veritope::bounds

namespace veritope::generated {

inline constexpr std::size_t kMostOperands = 24;
using Operands = std::array<double, kMostOperands>;  ///< what is not needed is ignored

/// Moves the operands: operand i becomes operand order[i] (all in their places if empty), or each
/// with an axis moves along it; factor is what becomes of the sign.
struct Law {
  int factor;
  std::vector<std::size_t> order;
  std::vector<int> axes;  ///< of a translation; -1: stays
};
struct Example {
  Operands operands;
  Sign sign;
};
struct Subject {
  const char* name;
  std::vector<int> axes;    ///< 0, 1, 2 of coordinates, -1 of numbers
  std::vector<int> powers;  ///< when lengths are scaled
  bool has_lattice;         ///< and the sign keeps when its inputs are scaled
  Sign (*decide)(const Operands&, TierCounts*);
  Sign3 (*filter)(const Operands&);
  Sign3 (*lattice)(const Operands&);
  Sign3 (*interval)(const Operands&);
  Sign (*exact)(const Operands&);
  Sign (*by_formula)(const Operands&);  ///< over rationals: no tier
  std::vector<Law> laws;
  std::vector<Example> examples;
};

inline std::vector<Subject>& subjects() {
  static std::vector<Subject> all;
  return all;
}
inline bool add(Subject subject) {
  subjects().push_back(std::move(subject));
  return true;
}

/// docs/bounds/README.md, 4: m bounds every difference; the filter adds eta m^Degree + its floor.
template <int Degree>
void expect_underflow_paid(const bounds::UnderflowCount& value, const bounds::UnderflowCount& sum,
                           const bounds::UnderflowCount& m, double rel, double eta) {
  const Rational kRel = Rational::from_double(rel), kEta = Rational::from_double(eta);
  const Rational less = Rational(1) - Rational::power_of_two(-48);
  Rational total;
  for (const auto& [exponent, c] : value.error.coefficient) {
    EXPECT_LE(exponent[0], Degree);
    total += c;
  }
  for (const auto& [exponent, c] : sum.error.coefficient) total += kRel * c;
  if constexpr (Degree > 0) {
    // m^Degree as computed is at least m^Degree (1 - u)^(Degree - 1) minus what it lost.
    const auto power = internal::power_of<Degree>(m);
    for (const auto& [exponent, c] : power.error.coefficient) total += kEta * c;
    EXPECT_LE(total, kEta * less);
  }
  EXPECT_LE(total + Rational(4) * m.unit, Rational::from_double(kFilterFloor) * less);
}

/// The error grows with each difference alone, be all the others zero.
template <int Degree, std::size_t N, typename Error>
void expect_size_counts_every(double eta, Error error) {
  for (std::size_t i = 0; i < N; ++i) {
    for (const double far : {0x1p200, -0x1p200}) {
      std::array<double, N> v{};
      v[i] = far;
      EXPECT_GE(error(v), eta * internal::power_of<Degree>(0x1p200)) << "difference " << i;
    }
  }
}

}  // namespace veritope::generated
