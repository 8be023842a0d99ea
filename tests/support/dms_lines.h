// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_lines.h: integrals along segments by their definition, cut at all triangles of three knots and
// interpolated between cuts: what DmsLineIntegrator is compared with. And segments at special places.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_line.h"
#include "tests/support/random_dms.h"

namespace veritope {

/// The integral over [0, 1] of the polynomial of degree n that has these values at (k + 1) / (n + 2), k = 0, ..., n.
inline Rational integral_of_values(const std::vector<Rational>& values) {
  const std::size_t n = values.size() - 1;
  const auto node = [&](std::size_t k) {
    return Rational(static_cast<long>(k + 1)) / Rational(static_cast<long>(n + 2));
  };
  Rational sum;
  for (std::size_t k = 0; k <= n; ++k) {
    // Lagrange's polynomial of the node, by its coefficients.
    std::vector<Rational> p{Rational(1)};
    for (std::size_t j = 0; j <= n; ++j) {
      if (j == k) continue;
      const Rational width = node(k) - node(j);
      std::vector<Rational> next(p.size() + 1);
      for (std::size_t i = 0; i < p.size(); ++i) {
        next[i + 1] += p[i] / width;
        next[i] -= p[i] * node(j) / width;
      }
      p = std::move(next);
    }
    Rational weight;
    for (std::size_t i = 0; i < p.size(); ++i) weight += p[i] / Rational(static_cast<long>(i + 1));
    sum += weight * values[k];
  }
  return sum;
}

inline DmsPoint point_on(const DmsLine& line, const Rational& t) {
  DmsPoint out = line.from;
  for (std::size_t c = 0; c < 3; ++c) out[c] += t * (line.to[c] - line.from[c]);
  return out;
}

/// Whether a point of the plane of three points is in their closed triangle.
inline bool is_in_triangle(const std::array<const DmsPoint*, 3>& corners, const DmsPoint& u) {
  const DmsPoint normal =
      cross_product(difference(*corners[1], *corners[0]), difference(*corners[2], *corners[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    const DmsPoint &a = *corners[i], &b = *corners[(i + 1) % 3];
    if (dot_product(normal, cross_product(difference(b, a), difference(u, a))).sign() ==
        Sign::kNegative)
      return false;
  }
  return true;
}

/// Where the segment crosses triangles of three knots of one tetrahedron in whose planes it does not lie, and 0 and 1;
/// ascending.
inline std::vector<Rational> cuts_of(const DmsModel& model, const DmsLine& line) {
  std::vector<Rational> cuts{0, 1};
  for (const auto& t : model.tetrahedra) {
    std::vector<DmsPoint> knots;
    for (const std::uint32_t v : t)
      for (const DmsPoint& knot : model.clouds[v])
        if (std::find(knots.begin(), knots.end(), knot) == knots.end()) knots.push_back(knot);
    for (std::size_t a = 0; a < knots.size(); ++a)
      for (std::size_t b = a + 1; b < knots.size(); ++b)
        for (std::size_t c = b + 1; c < knots.size(); ++c) {
          const Rational from = simplex_oracle::volume6(knots[a], knots[b], knots[c], line.from),
                         to = simplex_oracle::volume6(knots[a], knots[b], knots[c], line.to);
          if (from.sign() == to.sign() || from == to) continue;
          const Rational at = from / (from - to);
          if (Rational(0) < at && at < Rational(1) &&
              is_in_triangle({&knots[a], &knots[b], &knots[c]}, point_on(line, at)))
            cuts.push_back(at);
        }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

/// The integrals of all components over t in [0, 1], over the closed domain, by values between cuts.
inline std::vector<Rational> integrals_by_cuts(const DmsModel& model, DmsEvaluator& evaluator,
                                               const DmsLine& line) {
  std::vector<Rational> sums(model.num_components());
  const std::vector<Rational> cuts = cuts_of(model, line);
  const auto n = static_cast<long>(model.degree);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Rational width = cuts[i + 1] - cuts[i];
    std::vector<std::vector<Rational>> values(model.num_components());
    for (long k = 0; k <= n; ++k) {
      const auto place =
          evaluator.locate(point_on(line, cuts[i] + width * Rational(k + 1) / Rational(n + 2)));
      if (!place) break;
      const DmsValue value = evaluator.evaluate(*place);
      for (std::size_t c = 0; c < values.size(); ++c) values[c].push_back(value.value[c]);
    }
    for (std::size_t c = 0; c < values.size(); ++c)
      if (values[c].size() == static_cast<std::size_t>(n) + 1)
        sums[c] += width * integral_of_values(values[c]);
  }
  return sums;
}

/// A segment through the domain: between two of its points, which may be special ones, or beyond them on their line,
/// which may begin and end outside; one in eight is a point.
inline DmsLine draw_dms_line(Random& random, const DmsModel& model) {
  DmsLine line{draw_dms_point(random, model), draw_dms_point(random, model)};
  if (random.below(8) == 0) line.to = line.from;
  const Rational before = Rational(static_cast<long>(random.below(4))) / Rational(2),
                 after = Rational(static_cast<long>(random.below(4))) / Rational(2);
  const DmsLine whole = line;
  line.from = point_on(whole, -before);
  line.to = point_on(whole, Rational(1) + after);
  return line;
}

inline std::string text_of(const DmsLine& line) {
  return text_of(line.from) + " " + text_of(line.to);
}

}  // namespace veritope
