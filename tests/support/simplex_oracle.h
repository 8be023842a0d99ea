// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/simplex_oracle.h: rule H and the volumes of fibres, in rationals and by their definitions: what tests of
// simplex splines compare with. It shares nothing with predicates/.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robust/rational.h"
#include "splines/simplex_spline.h"

namespace veritope::simplex_oracle {

using Point = std::array<Rational, 3>;

inline std::string text(const Point& p) {
  return p[0].to_string() + "," + p[1].to_string() + "," + p[2].to_string();
}
inline Point plus(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point times(const Rational& t, const Point& a) { return {t * a[0], t * a[1], t * a[2]}; }
/// det(b - a, c - a, e - a)
inline Rational volume6(const Point& a, const Point& b, const Point& c, const Point& e) {
  const Point p = minus(b, a), q = minus(c, a), r = minus(e, a);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

/// The path of rule H: coefficients of ε^0, ε^1, ...
using Path = std::vector<Point>;

/// u + (ε, ε², ε³)
inline Path axes_path(const Point& u) { return {u, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }
/// u + ε(g - u) + (ε², ε³, ε⁴)
inline Path inward_path(const Point& u, const Point& g) {
  return {u, minus(g, u), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}
inline Point at(const Path& path, const Rational& eps) {
  Point sum{};
  for (std::size_t i = path.size(); i-- > 0;) sum = plus(times(eps, sum), path[i]);
  return sum;
}
/// The sign of det(b - a, c - a, x(ε) - a) for all small ε > 0: that of its first coefficient that is not zero.
inline Sign side(const Point& a, const Point& b, const Point& c, const Path& path) {
  const Rational at_zero = volume6(a, b, c, path[0]);
  if (at_zero.sign() != Sign::kZero) return at_zero.sign();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Sign s = volume6(a, b, c, plus(a, path[i])).sign();
    if (s != Sign::kZero) return s;
  }
  return Sign::kZero;
}
inline bool contains(const std::array<Point, 4>& t, const Path& path) {
  const Sign s = volume6(t[0], t[1], t[2], t[3]).sign();
  return s != Sign::kZero && side(t[1], t[2], t[3], path) == -s &&
         side(t[0], t[3], t[2], path) == -s && side(t[0], t[1], t[3], path) == -s &&
         side(t[0], t[2], t[1], path) == -s;
}

/// Answers for SimplexSplines<Rational> about a list of knots. pick(n) chooses one of n independent quadruples.
class Answers {
 public:
  Answers(std::vector<Point> knots, Path path) : knots_(std::move(knots)), path_(std::move(path)) {}

  void set_pick(std::size_t (*pick)(std::size_t)) { pick_ = pick; }
  const Path& path() const { return path_; }
  const std::vector<Point>& knots() const { return knots_; }

  const SimplexFrame<Rational>* frame(const KnotSet& set) {
    std::vector<std::array<KnotNumber, 4>> found;
    for (std::size_t i = 0; i < set.size(); ++i)
      for (std::size_t j = i + 1; j < set.size(); ++j)
        for (std::size_t k = j + 1; k < set.size(); ++k)
          for (std::size_t l = k + 1; l < set.size(); ++l) {
            const std::array<KnotNumber, 4> w{set[i], set[j], set[k], set[l]};
            if (frame_of(w) == nullptr) continue;
            if (pick_ == nullptr) return frame_of(w);
            found.push_back(w);
          }
    return found.empty() ? nullptr : frame_of(found[pick_(found.size())]);
  }
  bool contains(const SimplexFrame<Rational>& f) const {
    return simplex_oracle::contains(points_of(f.knots), path_);
  }

 private:
  std::array<Point, 4> points_of(const std::array<KnotNumber, 4>& w) const {
    return {knots_[w[0]], knots_[w[1]], knots_[w[2]], knots_[w[3]]};
  }
  const SimplexFrame<Rational>* frame_of(const std::array<KnotNumber, 4>& w) {
    auto [place, is_new] = frames_.try_emplace(w);
    if (is_new) {
      const auto p = points_of(w);
      const Sign s = volume6(p[0], p[1], p[2], p[3]).sign();
      if (s != Sign::kZero) place->second = simplex_frame<Rational>(w, p, s);
    }
    return place->second ? &*place->second : nullptr;
  }

  std::vector<Point> knots_;
  Path path_;
  std::size_t (*pick_)(std::size_t) = nullptr;
  std::map<std::array<KnotNumber, 4>, std::optional<SimplexFrame<Rational>>> frames_;
};

/// A half-space of R^k: sum of a[i] f[i] <= b.
struct HalfSpace {
  std::vector<Rational> a;
  Rational b;
};

/// The volume of a bounded polytope whose half-spaces have different boundaries, by its faces' volumes [Lasserre]:
/// k vol(P) = sum over the half-spaces of b_i / |a_i| vol(face i), each face projected along an axis.
inline Rational polytope_volume(const std::vector<HalfSpace>& spaces, std::size_t k) {
  if (k == 0) return 1;
  if (k == 1) {
    std::optional<Rational> low, high;
    for (const HalfSpace& h : spaces) {
      const Sign s = h.a[0].sign();
      if (s == Sign::kZero) {
        if (h.b.sign() == Sign::kNegative) return 0;
        continue;
      }
      const Rational t = h.b / h.a[0];
      if (s == Sign::kPositive && (!high || t < *high)) high = t;
      if (s == Sign::kNegative && (!low || t > *low)) low = t;
    }
    return low && high && *low < *high ? Rational(*high - *low) : Rational(0);
  }
  Rational sum;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    std::size_t axis = 0;
    while (axis < k && spaces[i].a[axis].sign() == Sign::kZero) ++axis;
    if (axis == k) {
      if (spaces[i].b.sign() == Sign::kNegative) return 0;
      continue;
    }
    // f[axis] = (b - the other terms) / pivot in all the others
    const Rational& pivot = spaces[i].a[axis];
    std::vector<HalfSpace> face;
    for (std::size_t j = 0; j < spaces.size(); ++j) {
      if (j == i) continue;
      const Rational factor = spaces[j].a[axis] / pivot;
      HalfSpace cut{{}, spaces[j].b - factor * spaces[i].b};
      for (std::size_t c = 0; c < k; ++c)
        if (c != axis) cut.a.push_back(spaces[j].a[c] - factor * spaces[i].a[c]);
      face.push_back(std::move(cut));
    }
    sum += spaces[i].b / veritope::abs(pivot) * polytope_volume(face, k - 1);
  }
  return sum / Rational(static_cast<long>(k));
}

/// M(u|V) of degree k by its definition as the volume of the fibre of a lifted simplex: k! / |d(W)| times the volume of
/// the weights f >= 0 of the knots outside of W that leave W no negative weight at u.
/// REQUIRES that u lies on no plane through three knots, and that the first four knots are affinely independent.
inline Rational fibre_volume(const std::vector<Point>& v, const Point& u) {
  const Rational d = volume6(v[0], v[1], v[2], v[3]);
  const auto lambda = [&](std::size_t m, const Point& p) {
    std::array<Point, 4> w{v[0], v[1], v[2], v[3]};
    w[m] = p;
    return Rational(volume6(w[0], w[1], w[2], w[3]) / d);
  };
  const std::size_t k = v.size() - 4;
  std::vector<HalfSpace> spaces;
  for (std::size_t j = 0; j < k; ++j) {
    spaces.push_back({std::vector<Rational>(k), 0});
    spaces.back().a[j] = -1;
  }
  for (std::size_t m = 0; m < 4; ++m) {
    spaces.push_back({{}, lambda(m, u)});
    for (std::size_t j = 0; j < k; ++j) spaces.back().a.push_back(lambda(m, v[4 + j]));
  }
  Rational factorial(1);
  for (std::size_t i = 2; i <= k; ++i) factorial *= Rational(static_cast<long>(i));
  return factorial / veritope::abs(d) * polytope_volume(spaces, k);
}

}  // namespace veritope::simplex_oracle
