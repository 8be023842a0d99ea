// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/pair_codes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "predicates/orient3d.h"
#include "robust/binary64.h"
#include "robust/integer.h"

namespace veritope {
namespace {

constexpr std::uint8_t kNegate = 32, kFollows = 64;
constexpr int kNumAxes = 17;
constexpr int kMaxCodes = 4;

template <typename T>
using Vec = std::array<T, 3>;

template <typename T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Two facets with corners of any number type.
template <typename T>
struct Pair {
  std::array<Vec<T>, 3> a, b;

  static Vec<T> edge(const std::array<Vec<T>, 3>& t, int i) {
    return t[static_cast<std::size_t>((i + 1) % 3)] - t[static_cast<std::size_t>(i)];
  }
  static Vec<T> normal(const std::array<Vec<T>, 3>& t) { return cross(t[1] - t[0], t[2] - t[0]); }
  Vec<T> axis(int index) const {
    if (index == 0) return normal(a);
    if (index == 1) return normal(b);
    if (index <= 10) return cross(edge(a, (index - 2) / 3), edge(b, (index - 2) % 3));
    if (index <= 13) return cross(normal(a), edge(a, index - 11));
    return cross(normal(b), edge(b, index - 14));
  }
};

struct Ids {
  std::array<std::uint32_t, 3> a, b;
};

// Supporting planes: +1 if all corners of u that t does not have lie strictly on the positive side of t's plane, -1 on
// the negative side, 0 otherwise. Exact.
int side_of_plane_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t,
                     const std::array<std::uint32_t, 3>& u) {
  int side = 0;
  for (std::uint32_t v : u) {
    if (std::find(t.begin(), t.end(), v) != t.end()) continue;
    const int s = to_int(orient3d(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], mesh.positions[v]));
    if (s == 0 || (side != 0 && s != side)) return 0;
    side = s;
  }
  return side;
}

// Corners as multiples of one power of two.
Pair<Integer> to_integers(const TriangleMesh& mesh, const Ids& ids) {
  int unit = std::numeric_limits<int>::max();
  const auto each = [&](auto&& use) {
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        use(mesh.positions[ids.a[i]][k], i, k, false);
        use(mesh.positions[ids.b[i]][k], i, k, true);
      }
  };
  each([&](double v, std::size_t, int, bool) {
    const Binary64 s = split(v);
    if (s.mantissa == 0) return;
    unit = std::min(unit, s.exponent + std::countr_zero(static_cast<std::uint64_t>(s.mantissa)));
  });
  Pair<Integer> out;
  each([&](double v, std::size_t i, int k, bool second) {
    const Binary64 s = split(v);
    Integer value(s.mantissa);
    if (s.mantissa != 0) {
      if (s.exponent >= unit) value.shift_left(static_cast<std::uint64_t>(s.exponent - unit));
      else value.shift_right(static_cast<std::uint64_t>(unit - s.exponent));
    }
    (second ? out.b : out.a)[i][static_cast<std::size_t>(k)] = std::move(value);
  });
  return out;
}

// Subsets of the corners of a and b, as bits.
struct Subsets {
  unsigned a = 7, b = 7;
  bool operator==(const Subsets&) const = default;
};

enum class Outcome { kFails, kHolds, kOpen };

class ExactSearch {
 public:
  ExactSearch(const TriangleMesh& mesh, const Ids& ids) : ids_(ids), pair_(to_integers(mesh, ids)) {
    rank_axes(mesh);
  }

  bool search(const Subsets& from, std::vector<std::uint8_t>& codes, int depth) const {
    std::vector<std::pair<std::uint8_t, Subsets>> open;
    for (std::uint8_t code : ranked_) {
      Subsets rest;
      switch (test(code, from, rest)) {
        case Outcome::kFails: break;
        case Outcome::kHolds: codes.push_back(code); return true;
        case Outcome::kOpen:
          if (!(rest == from)) open.emplace_back(code, rest);
      }
    }
    if (depth + 1 >= kMaxCodes) return false;
    for (const auto& [code, rest] : open) {
      codes.push_back(code | kFollows);
      if (search(rest, codes, depth + 1)) return true;
      codes.pop_back();
    }
    return false;
  }

 private:
  // The widest computed gap comes first: a guess that saves exact tests.
  void rank_axes(const TriangleMesh& mesh) {
    Pair<double> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d &u = mesh.positions[ids_.a[i]], &v = mesh.positions[ids_.b[i]], &o = mesh.positions[ids_.a[0]];
      p.a[i] = {u.x - o.x, u.y - o.y, u.z - o.z};
      p.b[i] = {v.x - o.x, v.y - o.y, v.z - o.z};
    }
    std::vector<std::pair<double, std::uint8_t>> gaps;
    for (int axis = 0; axis < kNumAxes; ++axis) {
      const Vec<double> d = p.axis(axis);
      const double size = std::sqrt(dot(d, d));
      double a_lo = dot(d, p.a[0]), a_hi = a_lo, b_lo = dot(d, p.b[0]), b_hi = b_lo;
      for (std::size_t i = 1; i < 3; ++i) {
        const double u = dot(d, p.a[i]), v = dot(d, p.b[i]);
        a_lo = std::min(a_lo, u), a_hi = std::max(a_hi, u);
        b_lo = std::min(b_lo, v), b_hi = std::max(b_hi, v);
      }
      const auto rank = [&](double gap) { return size > 0 && std::isfinite(gap) ? -gap / size : 0.0; };
      gaps.emplace_back(rank(b_lo - a_hi), static_cast<std::uint8_t>(axis));
      gaps.emplace_back(rank(a_lo - b_hi), static_cast<std::uint8_t>(axis | kNegate));
    }
    std::sort(gaps.begin(), gaps.end());
    for (const auto& g : gaps) ranked_.push_back(g.second);
  }

  Outcome test(std::uint8_t code, const Subsets& from, Subsets& rest) const {
    Vec<Integer> d = pair_.axis(code & 31);
    if ((code & kNegate) != 0)
      for (Integer& c : d) c.negate();
    std::array<Integer, 3> a, b;
    std::optional<Integer> most, least;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((from.a >> i & 1u) != 0) {
        a[i] = dot(d, pair_.a[i]);
        if (!most || a[i] > *most) most = a[i];
      }
      if ((from.b >> i & 1u) != 0) {
        b[i] = dot(d, pair_.b[i]);
        if (!least || b[i] < *least) least = b[i];
      }
    }
    if (*most != *least) return *most < *least ? Outcome::kHolds : Outcome::kFails;
    rest = {0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      if ((from.a >> i & 1u) != 0 && a[i] == *most) rest.a |= 1u << i;
      if ((from.b >> i & 1u) != 0 && b[i] == *least) rest.b |= 1u << i;
    }
    return spans_simplex(rest) ? Outcome::kHolds : Outcome::kOpen;
  }

  // Whether there are at most two vertices, or three that are not collinear.
  bool spans_simplex(const Subsets& s) const {
    std::vector<std::pair<std::uint32_t, const Vec<Integer>*>> points;
    const auto add = [&](std::uint32_t id, const Vec<Integer>& p) {
      for (const auto& q : points)
        if (q.first == id) return;
      points.emplace_back(id, &p);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      if ((s.a >> i & 1u) != 0) add(ids_.a[i], pair_.a[i]);
      if ((s.b >> i & 1u) != 0) add(ids_.b[i], pair_.b[i]);
    }
    if (points.size() != 3) return points.size() < 3;
    const Vec<Integer> n = cross(*points[1].second - *points[0].second, *points[2].second - *points[0].second);
    return !n[0].is_zero() || !n[1].is_zero() || !n[2].is_zero();
  }

  Ids ids_;
  Pair<Integer> pair_;
  std::vector<std::uint8_t> ranked_;
};

}  // namespace

// Codes 0 and 1: with d the normal of t, t lies in a plane d.x = c, and the corners of u that t does not have lie
// strictly beyond it. The contact is spanned by corners of t, which are not collinear.
std::vector<std::uint8_t> find_pair_codes(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Ids ids{mesh.faces[a], mesh.faces[b]};
  if (const int side = side_of_plane_of(mesh, ids.a, ids.b); side != 0)
    return {static_cast<std::uint8_t>(side > 0 ? 0 : kNegate)};
  if (const int side = side_of_plane_of(mesh, ids.b, ids.a); side != 0)
    return {static_cast<std::uint8_t>(side < 0 ? 1 : 1 | kNegate)};
  std::vector<std::uint8_t> codes;
  ExactSearch(mesh, ids).search({}, codes, 0);
  return codes;
}

}  // namespace veritope
