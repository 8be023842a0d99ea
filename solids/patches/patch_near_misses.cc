// SPDX-License-Identifier: LGPL-3.0-or-later
// Open sides that nearly fit another side, and by how much they differ.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "robust/binary64.h"
#include "solids/patches/patch_complex_internal.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"

namespace veritope::internal {
namespace {

constexpr double kReach = 0x1p-16;        // of the largest coordinate
constexpr std::size_t kMaxCompared = 32;  // sides after each in the order of the search

constexpr double kDirection[] = {0.83, 0.47,
                                 0.31};  // two ends within `reach` are within 2 `reach` along it

struct OpenSide {
  double key;  // the middle of its ends along a direction that few models have
  PatchSide side;
  std::array<Point3d, 2> ends;
};
struct Difference {
  double distance;
  bool is_one_ulp;
};

bool is_near(const Point3d& a, const Point3d& b, double reach) {
  for (std::size_t c = 0; c < 3; ++c)
    if (!(std::fabs(a[c] - b[c]) <= reach)) return false;
  return true;
}

bool are_neighbours(const Rational& a, const Rational& b) {
  const double x = nearest_double(a), y = nearest_double(b);
  return x == y || std::nextafter(x, y) == y;
}

// The differences of the control points' coordinates, and of weights divided by the first weight. REQUIRES the same
// degree, weights not 0.
Difference difference(const Patch::Curve& a, const Patch::Curve& b) {
  Rational most;
  bool is_one_ulp = true;
  const auto take = [&](const Rational& x, const Rational& y) {
    const Rational d = abs(x - y);
    if (most < d) most = d;
    is_one_ulp = is_one_ulp && are_neighbours(x, y);
  };
  const auto weight = [](const Patch::Curve& c, std::size_t i) {
    return c.is_rational() ? c.component(3)[i] : Rational(1);
  };
  for (std::size_t i = 0; i < a.component(0).size(); ++i) {
    const Rational v = weight(a, i), w = weight(b, i);
    for (int c = 0; c < 3; ++c) take(a.component(c)[i] / v, b.component(c)[i] / w);
    take(v / weight(a, 0), w / weight(b, 0));
  }
  return {nearest_double(most), is_one_ulp};
}

bool has_points(const Patch::Curve& curve) {
  if (!curve.is_rational()) return true;
  const auto w = curve.component(3);
  return std::none_of(w.begin(), w.end(),
                      [](const Rational& v) { return v.sign() == Sign::kZero; });
}

Difference least_difference(const Patch::Curve& a, const Patch::Curve& b) {
  const int degree = std::max(a.degree(0), b.degree(0));
  const Patch::Curve x = elevate(a, 0, degree - a.degree(0)),
                     y = elevate(b, 0, degree - b.degree(0));
  if (!has_points(x) || !has_points(y))  // weights of both signs, 0 after elevation
    return {std::numeric_limits<double>::infinity(), false};
  const Difference forward = difference(x, y), backward = difference(x, reversed(y, 0));
  return backward.distance < forward.distance ? backward : forward;
}

std::vector<OpenSide> with_ends(std::span<const Patch> patches, std::span<const PatchSide> open) {
  std::vector<OpenSide> out;
  for (const PatchSide s : open) {
    const Patch& patch = patches[s.patch];
    if (!has_points(patch.side(s.side))) continue;
    const auto a = approx_point(patch.corner(s.side)),
               b = approx_point(patch.corner((s.side + 1) % patch.num_sides()));
    double key = 0;
    for (std::size_t c = 0; c < 3; ++c) key += kDirection[c] * (a[c] / 2 + b[c] / 2);
    if (veritope::is_finite(key)) out.push_back({key, s, {a, b}});
  }
  std::sort(out.begin(), out.end(), [](const OpenSide& a, const OpenSide& b) {
    return a.key != b.key ? a.key < b.key : a.side < b.side;
  });
  return out;
}

bool may_fit(const OpenSide& a, const OpenSide& b, double reach) {
  return (is_near(a.ends[0], b.ends[0], reach) && is_near(a.ends[1], b.ends[1], reach)) ||
         (is_near(a.ends[0], b.ends[1], reach) && is_near(a.ends[1], b.ends[0], reach));
}

}  // namespace

void find_near_misses(std::span<const Patch> patches, std::span<const PatchSide> open,
                      std::vector<PatchFinding>& out) {
  const std::vector<OpenSide> sides = with_ends(patches, open);
  double scale = 0;
  for (const OpenSide& s : sides)
    for (const auto& end : s.ends)
      for (const double v : end) scale = std::max(scale, std::fabs(v));
  const double reach = scale * kReach;
  struct Best {
    Difference difference{std::numeric_limits<double>::infinity(), false};
    std::size_t other = 0;
  };
  std::vector<Best> best(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < std::min(sides.size(), i + 1 + kMaxCompared) &&
                                sides[j].key - sides[i].key <= 2 * reach;
         ++j) {
      if (!may_fit(sides[i], sides[j], reach)) continue;
      const auto curve = [&](std::size_t n) {
        return patches[sides[n].side.patch].side(sides[n].side.side);
      };
      const Difference d = least_difference(curve(i), curve(j));
      if (d.distance < best[i].difference.distance) best[i] = {d, j};
      if (d.distance < best[j].difference.distance) best[j] = {d, i};
    }
  std::set<std::pair<PatchSide, PatchSide>> seen;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (std::isinf(best[i].difference.distance)) continue;
    const auto pair = std::minmax(sides[i].side, sides[best[i].other].side);
    if (!seen.insert(pair).second) continue;
    PatchFinding& f = out.emplace_back();
    f.defect = PatchDefect::kNearMiss;
    f.sides = {pair.first, pair.second};
    f.distance = best[i].difference.distance;
    f.is_one_ulp = best[i].difference.is_one_ulp;
  }
}

}  // namespace veritope::internal
