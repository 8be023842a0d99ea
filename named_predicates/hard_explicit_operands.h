// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/hard_explicit_operands.h: operands of the predicates on explicit points that are hard to decide:
// half of them from hard_points.h unchanged; the others are changed so that the answer is zero, exactly where the
// numbers allow it and nearly elsewhere.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "named_predicates/hard_points.h"
#include "named_predicates/named_predicate.h"

namespace veritope {

// Half of the cases are of kinds that are exactly zero, the others of any kind.
inline generate::Kind hard_kind(bool is_flat, Random& random) {
  using generate::Kind;
  if (random.below(2) == 0) return static_cast<Kind>(random.below(generate::kNumKinds));
  const bool is_scaled = random.below(2) == 0;
  if (is_flat) return is_scaled ? Kind::kScaledFlat : Kind::kFlat;
  return is_scaled ? Kind::kScaledRound : Kind::kRound;
}

inline double finite(double v) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return v != v ? 0 : (v > kMost ? kMost : (v < -kMost ? -kMost : v));
}

/// `to` plus a vector as long as that from a to b, rounded: x and y are exchanged, and one sign is changed. Without z
/// (dimension 2) the vector is at a right angle.
inline Vec3d turned(const Vec3d& to, const Vec3d& a, const Vec3d& b, int dimension = 2) {
  const double dz = dimension == 3 ? b.z - a.z : 0;
  return {finite(to.x - (b.y - a.y)), finite(to.y + (b.x - a.x)), finite(to.z - dz)};
}
inline double square_distance(const Vec3d& a, const Vec3d& b, int dimension) {
  const double dx = a.x - b.x, dy = a.y - b.y, dz = dimension == 3 ? a.z - b.z : 0;
  return finite((dx * dx + dy * dy) + dz * dz);
}

/// Weights that give all points the same power with respect to `centre`; or equal weights; or any.
inline std::vector<double> hard_weights(const generate::Points& p, std::size_t n, int dimension,
                                        Random& random) {
  std::vector<double> w(n);
  const std::uint64_t way = random.below(n == 3 ? 2 : 3);
  const Vec3d& centre = p[4];
  for (std::size_t i = 0; i < n; ++i)
    w[i] = way == 0 ? p[0].x : (way == 2 ? square_distance(p[i], centre, dimension) : p[i].z);
  return w;
}

/// Changes points of the predicate `name` so that the answer is zero, or nearly zero.
inline void make_tied(std::string_view name, int dimension, generate::Points& p) {
  if (name.starts_with("compare_distance")) p[2] = turned(p[0], p[0], p[1], dimension);
  if (name.starts_with("side_of_bisector")) {
    p[1] = turned(p[2], p[2], p[0], dimension);
  }
  if (name.starts_with("compare_lengths")) p[3] = turned(p[2], p[0], p[1], dimension);
  if (name.starts_with("order_along_line")) p[3] = turned(p[2], p[0], p[1]);
  if (name == "compare_along") p[2] = turned(p[1], {0, 0, 0}, p[0]);
  if (name == "order_on_circle" && p[0].x < p[1].x) p[3] = p[2];
  if (name.starts_with("power_edge")) p[1] = turned(p[2], p[2], p[0]);
}

/// REQUIRES a predicate on explicit points.
inline Operands hard_operands(const NamedPredicate& predicate, Random& random) {
  const std::string_view name = predicate.name;
  const bool is_round = name.starts_with("in_") || name.starts_with("power_");
  generate::Points p = generate::points(hard_kind(!is_round, random), random);
  const bool is_tied = random.below(4) != 0;
  if (is_tied) make_tied(name, predicate.dimension, p);
  Operands operands{};
  double* next = operands.data();
  const auto put = [&](const Vec3d& v) {
    for (int axis = 0; axis < predicate.dimension; ++axis) *next++ = v[axis];
  };
  if (name == "side_of_plane") {
    if (is_tied && random.below(2) == 0) p[1] = turned({0, 0, 0}, {0, 0, 0}, p[0]);
    const double offset = -((p[0].x * p[1].x + p[0].y * p[1].y) + p[0].z * p[1].z);
    put(p[0]), *next++ = is_tied ? finite(offset) : p[2].x, put(p[1]);
  } else if (name.starts_with("power_")) {
    const std::size_t n =
        predicate.num_operands / static_cast<std::size_t>(predicate.dimension + 1);
    const std::vector<double> w = hard_weights(p, n, predicate.dimension, random);
    for (std::size_t i = 0; i < n; ++i) put(p[i]), *next++ = w[i];
  } else {
    for (std::size_t at = 0, i = 0; at < predicate.num_operands; at += predicate.dimension)
      put(p[i++]);
  }
  return operands;
}

}  // namespace veritope
