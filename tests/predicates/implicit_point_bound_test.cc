// SPDX-License-Identifier: LGPL-3.0-or-later
// The constants of predicates/implicit_point.h against docs/bounds/implicit_point.md: derivation
// rerun in exact rationals.
#include "predicates/implicit_formulas.h"
#include "predicates/implicit_point.h"
#include "robust/base/random.h"
#include "tests/predicates/bound_derivation.h"

namespace veritope {
namespace {

using bounds::Polynomial;
using bounds::RoundingCount;
using bounds::UnderflowCount;
using formulas::Triple;

template <typename T>
Triple<T> same(const T& t) {
  return {t, t, t};
}
template <typename T>
formulas::PlaneVectors<T> plane_of(const T& v, const T& w, const T& g) {
  return {same(v), same(w), same(g)};
}
// The error that the filter computes, without the constants: implicit_point.cc.
template <typename T>
T magnitude(const T& scale, const T& mv, const T& mw, const T& reach, const T& me) {
  return (scale * (mv * mw)) * (reach + me);
}

// In any rounding mode an operation is off by less than one unit in the last place.
Rational unit_roundoff() { return Rational(2) * bounds::unit_roundoff(); }

// bounds::expect_tight with that unit: `terms` times ((1 + u)^k - 1) (1 + u) / (1 - u)^(m + 2).
void expect_tight(double constant, int det_roundings, int magnitude_roundings,
                  const Rational& terms) {
  const Rational up = Rational(1) + unit_roundoff(), down = Rational(1) - unit_roundoff();
  const auto derived = [&](int roundings) {
    return terms * (bounds::power(up, roundings) - Rational(1)) * up /
           bounds::power(down, magnitude_roundings + 2);
  };
  EXPECT_EQ(constant, round_up(derived(det_roundings)));
  EXPECT_GT(derived(det_roundings + 1), Rational::from_double(constant));
  EXPECT_GT(Rational::from_double(constant),
            derived(det_roundings - 1) * (Rational(1) + Rational::power_of_two(-20)));
}

TEST(ImplicitPointBound, RelativeConstantsFollowFromTheRoundings) {
  const RoundingCount x, d = x - x;
  const auto line = formulas::line_plane(same(d), same(d), same(d), same(d));
  const auto planes =
      formulas::three_planes(plane_of(d, d, x), plane_of(d, d, d), plane_of(d, d, d));
  const int k_line = formulas::orientation(line, same(d), same(d), same(d)).roundings - 1;
  const int k_planes = formulas::orientation(planes, same(d), same(d), same(d)).roundings - 1;
  EXPECT_EQ(k_line, 17);
  EXPECT_EQ(k_planes, 27);
  const int m_line = magnitude(d * (d * d), d, d, d, d).roundings;
  const int m_planes = magnitude(((d * d) * (d * d)) * (d * d), d, d, d + d, d).roundings;
  expect_tight(internal::kLinePlaneRel, k_line, m_line, Rational(36));
  expect_tight(internal::kThreePlanesRel, k_planes, m_planes, Rational(288));
  // This constant also bounds the denominator's error, which has fewer terms and roundings.
  EXPECT_LE(line.denominator.roundings, k_line);
  EXPECT_LE(planes.denominator.roundings, k_planes);
}

// What implicit_predicates.cc makes intervals of: numerators within scale * reach, the denominator within
// scale, for the same constants. In the place of factor * ((1 + u)^k - 1) of the whole determinant.
TEST(ImplicitPointBound, TheConstantsAlsoBoundTheErrorsOfTheLayer) {
  const RoundingCount x, d = x - x;
  const auto line = formulas::line_plane(same(d), same(d), same(d), same(d));
  const auto planes =
      formulas::three_planes(plane_of(d, d, x), plane_of(d, d, d), plane_of(d, d, d));
  const auto needed = [](int terms, const RoundingCount& value, const RoundingCount& product) {
    const Rational up = Rational(1) + unit_roundoff(), down = Rational(1) - unit_roundoff();
    return Rational(terms) * (bounds::power(up, value.roundings) - Rational(1)) /
           bounds::power(down, product.roundings + 1);
  };
  const auto line_scale = d * (d * d), planes_scale = ((d * d) * (d * d)) * (d * d);
  const Rational line_rel = Rational::from_double(internal::kLinePlaneRel),
                 planes_rel = Rational::from_double(internal::kThreePlanesRel);
  EXPECT_LE(needed(6, line.numerator.x, line_scale * d), line_rel);
  EXPECT_LE(needed(6, line.denominator, line_scale), line_rel);
  EXPECT_LE(needed(48, planes.numerator.x, planes_scale * (d + d)), planes_rel);
  EXPECT_LE(needed(48, planes.denominator, planes_scale), planes_rel);
}

// A ring of absolute values: differences become sums.
struct Magnitude {
  Rational v;
  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) { return {a.v + b.v}; }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return {a.v + b.v}; }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return {a.v * b.v}; }
};

TEST(ImplicitPointBound, TheProductsOfTheLargestDifferencesBoundTheSumOfTheAbsoluteTerms) {
  Random random(12);
  const auto draw = [&] { return Magnitude{Rational::from_double(random.unit() + 0x1p-30)}; };
  for (int i = 0; i < 50; ++i) {
    const Magnitude mu = draw(), v1 = draw(), w1 = draw(), v2 = draw(), w2 = draw(), v3 = draw(),
                    w3 = draw(), g2 = draw(), g3 = draw(), e = draw(), qv = draw(), qw = draw();
    const auto line = formulas::line_plane(same(mu), same(v1), same(w1), same(g2));
    EXPECT_EQ(formulas::orientation(line, same(e), same(qv), same(qw)).v,
              Rational(36) * magnitude(mu * (v1 * w1), qv, qw, g2, e).v);
    EXPECT_EQ(line.denominator.v, Rational(6) * (mu * (v1 * w1)).v);
    EXPECT_EQ(line.numerator.x.v, Rational(6) * (mu * (v1 * w1) * g2).v);
    const auto planes = formulas::three_planes(plane_of(v1, w1, Magnitude{}), plane_of(v2, w2, g2),
                                               plane_of(v3, w3, g3));
    const Magnitude scale = ((v1 * w1) * (v2 * w2)) * (v3 * w3);
    EXPECT_EQ(formulas::orientation(planes, same(e), same(qv), same(qw)).v,
              Rational(288) * magnitude(scale, qv, qw, g2 + g3, e).v);
    EXPECT_EQ(planes.denominator.v, Rational(48) * scale.v);
    EXPECT_EQ(planes.numerator.x.v, Rational(48) * (scale * (g2 + g3)).v);
  }
}

// What the integers compute is what the filter computes.
TEST(ImplicitPointFormulas, TheShortFormsAreTheSameNumbers) {
  Random random(13);
  const auto draw = [&] { return Rational::from_double(random.unit() - 0.5); };
  const auto triple = [&]() -> Triple<Rational> { return {draw(), draw(), draw()}; };
  for (int i = 0; i < 50; ++i) {
    const auto u = triple(), e = triple(), v = triple(), w = triple();
    const formulas::PlaneVectors<Rational> one{triple(), triple(), {}},
        two{triple(), triple(), triple()}, three{triple(), triple(), triple()};
    EXPECT_EQ(formulas::line_plane_orientation(u, two.v, two.w, two.g, e, v, w),
              formulas::orientation(formulas::line_plane(u, two.v, two.w, two.g), e, v, w));
    EXPECT_EQ(formulas::three_planes_orientation(one, two, three, e, v, w),
              formulas::orientation(formulas::three_planes(one, two, three), e, v, w));
  }
}

// With no difference above 2^100, what underflow does is less than 2^-200, with FTZ and DAZ, too.
TEST(ImplicitPointBound, TheAbsoluteConstantPaysForUnderflowAndForFlushing) {
  for (const Rational& unit : {bounds::underflow_unit(), bounds::flush_unit()}) {
    UnderflowCount d = UnderflowCount::bounded_by(0, unit);
    // A difference of numbers that DAZ reads as zero, or that FTZ makes zero.
    d.error = Polynomial::constant(Rational(3) * bounds::flush_unit());
    const auto line = formulas::line_plane(same(d), same(d), same(d), same(d));
    const auto planes =
        formulas::three_planes(plane_of(d, d, d), plane_of(d, d, d), plane_of(d, d, d));
    const Rational reach = Rational::from_double(internal::kImplicitReach);
    const auto at_reach = [&](const Polynomial& p) {
      Rational sum;
      for (const auto& [exponent, c] : p.coefficient) sum += c * bounds::power(reach, exponent[0]);
      return sum;
    };
    const Rational abs =
        Rational::from_double(internal::kImplicitAbs) * (Rational(1) - Rational::power_of_two(-48));
    const auto missing = [&](const UnderflowCount& scale, double rel) {
      // rel * scale may underflow, too, and is then multiplied by differences.
      const UnderflowCount one = UnderflowCount::bounded_by(1, unit);
      Polynomial lost = magnitude(one, d, d, d + d, d).size;
      Rational amplified;
      for (const auto& [exponent, c] : lost.coefficient)
        amplified += c * bounds::power(reach, exponent[0]);
      return Rational::from_double(rel) * at_reach(magnitude(scale, d, d, d + d, d).error) +
             unit * amplified;
    };
    EXPECT_LE(at_reach(formulas::orientation(line, same(d), same(d), same(d)).error) +
                  missing(d * (d * d), internal::kLinePlaneRel) + Rational(4) * unit,
              abs);
    EXPECT_LE(at_reach(formulas::orientation(planes, same(d), same(d), same(d)).error) +
                  missing(((d * d) * (d * d)) * (d * d), internal::kThreePlanesRel) +
                  Rational(4) * unit,
              abs);
    EXPECT_LE(at_reach(planes.denominator.error), abs);
    // The errors of the layer alone, and of rel * scale * reach.
    EXPECT_LE(at_reach(planes.numerator.x.error) +
                  missing(((d * d) * (d * d)) * (d * d), internal::kThreePlanesRel),
              abs);
    EXPECT_LE(at_reach(line.numerator.x.error) + missing(d * (d * d), internal::kLinePlaneRel),
              abs);
  }
}

}  // namespace
}  // namespace veritope
