// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/separating_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robust/base/fp_state.h"
#include "robust/base/fp_strict.h"

VT_PRECISE_BEGIN
namespace veritope {
namespace {

constexpr std::uint8_t kOtherWay = 32;

struct Arrow {
  double x, y, z;
};
Arrow operator-(const Arrow& a, const Arrow& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Arrow outer(const Arrow& a, const Arrow& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double inner(const Arrow& a, const Arrow& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double size_of(const Arrow& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
Arrow arrow(const Vec3d& from, const Vec3d& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

// Two facets, seen from the first corner of the first one.
class AxisSearch {
 public:
  AxisSearch(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& a,
             const std::array<std::uint32_t, 3>& b) {
    const Vec3d& origin = mesh.positions[a[0]];
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      a_[i] = arrow(origin, mesh.positions[a[i]]);
      b_[i] = arrow(origin, mesh.positions[b[i]]);
      size = std::max({size, size_of(a_[i]), size_of(b_[i])});
    }
    is_in_range_ = internal::kAxisLeastSize <= size && size <= internal::kAxisMostSize;
    least_gap_ = internal::kAxisRel * (size * size * size);
    least_cubic_gap_ = internal::kAxisCubicRel * (size * size) * (size * size);
  }

  std::optional<std::uint8_t> find() const {
    if (!is_in_range_) return std::nullopt;
    const std::array<Arrow, 3> e = edges(a_), f = edges(b_);
    const Arrow m = outer(a_[1], a_[2]), n = outer(b_[1] - b_[0], b_[2] - b_[0]);
    std::uint8_t axis = 0;
    if (const int way = way_along(m, least_gap_); way != 0) return code(axis, way);
    ++axis;
    if (const int way = way_along(n, least_gap_); way != 0) return code(axis, way);
    for (const Arrow& edge : e)
      for (const Arrow& other : f) {
        ++axis;
        if (const int way = way_along(outer(edge, other), least_gap_); way != 0)
          return code(axis, way);
      }
    for (const Arrow& edge : e) {
      ++axis;
      if (const int way = way_along(outer(m, edge), least_cubic_gap_); way != 0)
        return code(axis, way);
    }
    for (const Arrow& edge : f) {
      ++axis;
      if (const int way = way_along(outer(n, edge), least_cubic_gap_); way != 0)
        return code(axis, way);
    }
    return std::nullopt;
  }

 private:
  static std::array<Arrow, 3> edges(const std::array<Arrow, 3>& t) {
    return {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  }
  static std::uint8_t code(std::uint8_t axis, int way) {
    return way > 0 ? axis : static_cast<std::uint8_t>(axis | kOtherWay);
  }
  // 1: d.p < d.q for all p of a, q of b; -1: d.p > d.q; 0: neither is certain.
  int way_along(const Arrow& d, double least) const {
    const double p1 = inner(d, a_[1]), p2 = inner(d, a_[2]);
    const double q0 = inner(d, b_[0]), q1 = inner(d, b_[1]), q2 = inner(d, b_[2]);
    const double p_low = std::min({0.0, p1, p2}), p_high = std::max({0.0, p1, p2});
    const double q_low = std::min({q0, q1, q2}), q_high = std::max({q0, q1, q2});
    if (q_low - p_high > least) return 1;
    return p_low - q_high > least ? -1 : 0;
  }

  std::array<Arrow, 3> a_, b_;
  double least_gap_ = 0, least_cubic_gap_ = 0;
  bool is_in_range_ = false;
};

bool have_common_vertex(const std::array<std::uint32_t, 3>& a,
                        const std::array<std::uint32_t, 3>& b) {
  for (const std::uint32_t v : a)
    if (v == b[0] || v == b[1] || v == b[2]) return true;
  return false;
}

}  // namespace

std::optional<std::uint8_t> separating_axis(const TriangleMesh& mesh, std::uint32_t a,
                                            std::uint32_t b) {
  if (!kFiltersAreCompiled || !filters_are_sound()) return std::nullopt;
  const auto &s = mesh.faces[a], &t = mesh.faces[b];
  if (have_common_vertex(s, t)) return std::nullopt;
  return AxisSearch(mesh, s, t).find();
}

}  // namespace veritope
VT_PRECISE_END
