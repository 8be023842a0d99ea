// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/in_sphere.h against docs/bounds/in_sphere.md: derivation rerun in
// exact rationals.
#include "predicates/in_sphere.h"

#include <array>

#include "robust/base/random.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;

constexpr int kTerms = 24;

TEST(InSphereBound, RelativeConstantFollowsFromTheRoundings) {
  const RoundingCount x;
  const formulas::InSphere<RoundingCount> f(x, x, x, x, x, x, x, x, x, x, x, x, x, x, x);
  EXPECT_EQ(f.det().roundings - 1, 15);
  const formulas::InSphereBox<RoundingCount> box(x - x, x - x, x - x);
  EXPECT_EQ(box.magnitude().roundings, 11);
  bounds::expect_tight(internal::kInSphereRel, f.det().roundings - 1, box.magnitude().roundings,
                       Rational(kTerms));
}

TEST(InSphereBound, TheBoxBoundsTheSumOfTheAbsoluteTerms) {
  Random random(11);
  const auto abs = [](const Rational& v) { return v.sign() == Sign::kNegative ? -v : v; };
  const auto draw = [&] { return Rational::from_double(random.unit() - 0.5); };
  for (int i = 0; i < 200; ++i) {
    std::array<Rational, 12> d;
    Rational x, y, z;
    for (int k = 0; k < 12; ++k) {
      d[k] = draw();
      Rational& most = k % 3 == 0 ? x : (k % 3 == 1 ? y : z);
      if (abs(d[k]) > most) most = abs(d[k]);
    }
    const Rational o;
    const Rational bound = Rational(kTerms) * formulas::InSphereBox<Rational>(x, y, z).magnitude();
    EXPECT_LE((formulas::InSphere<Rational>(d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8],
                                            d[9], d[10], d[11], o, o, o)
                   .magnitude(abs)),
              bound);
    // 24 is the number of terms: no less will do.
    EXPECT_EQ(
        (formulas::InSphere<Rational>(x, y, z, x, y, z, x, y, z, x, y, z, o, o, o).magnitude(abs)),
        bound);
  }
}

TEST(InSphereBound, AbsoluteConstantsPayForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    // m bounds every difference: set the last point to zero, so that the constructor's differences
    // add no bound of their own.
    const UnderflowCount m = UnderflowCount::bounded_by(0, unit);
    UnderflowCount zero;
    zero.unit = unit;
    const formulas::InSphere<UnderflowCount> f(m, m, m, m, m, m, m, m, m, m, m, m, zero, zero,
                                               zero);
    const formulas::InSphereBox<UnderflowCount> box(m, m, m);
    const Polynomial error = f.det().error, missing = box.magnitude().error,
                     lost = box.size().error;
    // size() >= m^4 (1 - u)^12 - lost, and m^j <= 1 + m^4 for j <= 3.
    Rational sum;
    const Rational rel = Rational::from_double(internal::kInSphereRel),
                   eta = Rational::from_double(internal::kInSphereEta);
    for (int j = 0; j <= 4; ++j) sum += error.at(j) + rel * missing.at(j) + eta * lost.at(j);
    for (const auto& [exponent, c] : error.coefficient) EXPECT_LE(exponent[0], 3);
    for (const auto& [exponent, c] : missing.coefficient) EXPECT_LE(exponent[0], 3);
    const Rational less = Rational(1) - Rational::power_of_two(-48);
    EXPECT_LE(sum, eta * less);
    EXPECT_LE(sum + Rational(4) * unit, Rational::from_double(kFilterFloor) * less);
  }
}

TEST(InSphereBound, SizeCountsEveryAxis) {
  const auto symbol = [](int i) { return UnderflowCount::bounded_by(i, bounds::underflow_unit()); };
  const Polynomial size =
      formulas::InSphereBox<UnderflowCount>(symbol(0), symbol(1), symbol(2)).size().size;
  EXPECT_GE(size.at(4, 0, 0), Rational(1));
  EXPECT_GE(size.at(0, 4, 0), Rational(1));
  EXPECT_GE(size.at(0, 0, 4), Rational(1));
}

}  // namespace
}  // namespace veritope
