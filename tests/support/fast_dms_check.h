// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/fast_dms_check.h: FastDms beside DmsEvaluator: for tests and soak experiments.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "solids/dms/fast/fast_dms.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {

/// Points as FastDms takes them.
struct FastDmsPoints {
  std::vector<Vec3d> at;
  std::vector<std::pair<std::size_t, DmsPoint>> exact;

  DmsPoint operator[](std::size_t i) const {
    for (const auto& [k, p] : exact)
      if (k == i) return p;
    return {Rational::from_double(at[i].x), Rational::from_double(at[i].y),
            Rational::from_double(at[i].z)};
  }
  /// As it is, or rounded to binary64 numbers.
  void add(const DmsPoint& p, bool is_exact) {
    if (is_exact) exact.emplace_back(at.size(), p);
    at.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
  }
};

/// Every other point is rounded, and half of those are moved by an ulp or two: near planes, not on them.
inline FastDmsPoints draw_fast_dms_points(Random& random, const DmsModel& model, std::size_t n) {
  FastDmsPoints out;
  for (std::size_t i = 0; i < n; ++i) {
    out.add(draw_dms_point(random, model), i % 2 == 0);
    if (i % 4 != 1) continue;
    Vec3d& p = out.at.back();
    for (double* c : {&p.x, &p.y, &p.z})
      *c += static_cast<double>(random.between(-2, 2)) * 0x1p-52 * *c;
  }
  return out;
}

struct FastDmsResults {
  std::vector<double> value, value_bound, gradient, gradient_bound;
  std::vector<std::uint32_t> tetrahedron;

  FastDmsResults(FastDms& fast, const FastDmsPoints& points, bool with_gradient = true)
      : value(points.at.size() * fast.num_components()),
        value_bound(value.size()),
        gradient(with_gradient ? 3 * value.size() : 0),
        gradient_bound(gradient.size()),
        tetrahedron(points.at.size()) {
    FastDmsOutput out{value.data(), value_bound.data(), nullptr, nullptr, tetrahedron.data()};
    if (with_gradient) out.gradient = gradient.data(), out.gradient_bound = gradient_bound.data();
    fast.evaluate(points.at, out, points.exact);
  }
};

/// What is wrong with the results; empty if all tetrahedra are those of rule H and all bounds hold. `greatest` becomes
/// the greatest share of a bound that was needed by a number with a bound above 2^-52 of its size.
inline std::string check_fast_dms(const DmsModel& model, const FastDmsPoints& points,
                                  const FastDmsResults& results, double& greatest) {
  DmsEvaluator evaluator(model);
  const std::size_t k = model.num_components();
  const auto check = [&](const Rational& exact, double x, double bound) {
    Rational off = exact - Rational::from_double(x);
    if (off.sign() == Sign::kNegative) off.negate();
    if (off > Rational::from_double(bound)) return false;
    if (bound > 0x1p-52 * std::abs(x))
      greatest = std::max(greatest, nearest_double(off / Rational::from_double(bound)));
    return true;
  };
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    const std::string where = "point " + std::to_string(i) + " " + text_of(points[i]) + ": ";
    const auto place = evaluator.locate(points[i]);
    if (results.tetrahedron[i] != (place ? place->tetrahedron : FastDms::kNoTetrahedron))
      return where + "tetrahedron " + std::to_string(results.tetrahedron[i]);
    if (!place) continue;
    const DmsValue value = evaluator.evaluate(*place);
    for (std::size_t c = 0; c < k; ++c) {
      if (!check(value.value[c], results.value[i * k + c], results.value_bound[i * k + c]))
        return where + "component " + std::to_string(c);
      for (std::size_t a = 0; a < 3 && !results.gradient.empty(); ++a)
        if (!check(value.gradient[c][a], results.gradient[3 * (i * k + c) + a],
                   results.gradient_bound[3 * (i * k + c) + a]))
          return where + "derivative " + std::to_string(a) + " of component " + std::to_string(c);
    }
  }
  return "";
}

/// A model of draw_dms: as it is, with separate control points, squeezed to a domain far from the origin, or scaled by
/// 2^-300 or 2^300, domain and control points.
inline RandomDms draw_fast_dms(std::uint64_t seed, int max_degree) {
  RandomDms out = draw_dms(seed, max_degree);
  const auto kind = seed % 8;
  if (kind == 1 || kind == 5) out.model = internal::separated(out.model);
  const auto scaled_by = [&](const Rational& by, const Rational& shift) {
    for (DmsCloud& cloud : out.model.clouds)
      for (DmsPoint& knot : cloud)
        for (Rational& c : knot) c = c * by + shift;
  };
  if (kind == 2) scaled_by(Rational::power_of_two(-10), Rational(1'000'003) / Rational(3));
  if (kind == 3 || kind == 7) {
    const Rational by = Rational::power_of_two(kind == 3 ? -300 : 300);
    scaled_by(by, {});
    for (Rational& c : out.model.control.values) c *= by;
  }
  out.text += ", kind " + std::to_string(kind);
  return out;
}

}  // namespace veritope
