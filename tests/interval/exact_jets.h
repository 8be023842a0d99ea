// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/exact_jets.h: derivatives, normals and curvatures of a Bezier piece at a point, in rationals.
#pragma once
#include <array>
#include <map>
#include <vector>

#include "interval/box.h"
#include "tests/splines/exact_map.h"

namespace veritope::exact_jets {

/// The binary64 numbers next to an exact one, or to all of a short range around an irrational one.
struct Bracket {
  double below, above;
  explicit Bracket(const Rational& x) : below(round_down(x)), above(round_up(x)) {}
  Bracket(const Rational& lo, const Rational& hi) : below(round_down(lo)), above(round_up(hi)) {}
};
/// For an exact number: is it a member? A number between neighbours is in [lo, hi] iff both neighbours are, for doubles
/// lo, hi. For a range: false only if some number of it, up to one spacing of doubles, is not a member.
inline bool holds(const Interval& a, const Bracket& x, bool is_exact = true) {
  if (a.is_empty()) return false;
  return is_exact ? a.lo() <= x.below && x.above <= a.hi() : a.lo() <= x.above && x.below <= a.hi();
}

/// All derivatives up to an order of the points of a (rational) piece whose cell has the given lengths.
template <std::size_t N>
class PieceJets {
 public:
  using Index = std::array<int, N>;
  PieceJets(const Bezier<Rational, N>& piece, const std::array<Rational, N>& lengths, int order) {
    maps_.emplace(Index{}, piece);
    for (int step = 0; step < order; ++step) {
      const auto before = maps_;
      for (const auto& [index, map] : before)
        for (std::size_t a = 0; a < N; ++a) {
          Index next = index;
          ++next[a];
          if (!maps_.contains(next))
            maps_.emplace(next, exact_map::differentiated(map, a, lengths[a]));
        }
    }
  }
  std::map<Index, std::vector<Rational>> at(const std::array<Rational, N>& local) const {
    std::map<Index, std::vector<Rational>> x, out;
    for (const auto& [index, map] : maps_) x[index] = evaluate(map, local);
    if (!maps_.begin()->second.is_rational()) return x;
    // Lexicographic order: every smaller index comes first.
    for (const auto& [index, values] : x) {
      std::vector<Rational> s(values.begin(), values.end() - 1);
      for (const auto& [below, known] : out) {
        Index rest;
        Rational times(1);
        bool is_below = true;
        for (std::size_t a = 0; a < N; ++a) {
          rest[a] = index[a] - below[a];
          is_below = is_below && rest[a] >= 0;
          for (int k = 0; is_below && k < rest[a]; ++k)
            times *= Rational(index[a] - k) / Rational(k + 1);
        }
        if (!is_below) continue;
        for (std::size_t c = 0; c < s.size(); ++c) s[c] -= times * known[c] * x[rest].back();
      }
      for (Rational& v : s) v /= x[Index{}].back();
      out[index] = std::move(s);
    }
    return out;
  }

 private:
  std::map<Index, Bezier<Rational, N>> maps_;
};

using Vector = std::array<Rational, 3>;
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// v rounded to about 106 bits.
inline Rational cut(const Rational& v, bool up) {
  const Rational high = Rational::from_double(round_down(v)), rest = v - high;
  return high + Rational::from_double(up ? round_up(rest) : round_down(rest));
}
/// lo <= root of x <= hi, hi - lo below 2^-80 of the root. REQUIRES x >= 0, of ordinary size.
inline std::pair<Rational, Rational> root(const Rational& x) {
  if (x.sign() == Sign::kZero) return {Rational(), Rational()};
  // Newton's iterates lie above the root, also after rounding up; a quotient by one is below.
  const Rational above = cut(x, true), one(1);
  Rational r = above < one ? one : above;
  for (Rational next = r;; r = next) {
    next = cut((r + above / r) / Rational(2), true);
    if (!(next < r * (one - Rational::power_of_two(-90)))) break;
  }
  return {cut(cut(x, false) / r, false), r};
}

struct Shape {
  Vector normal;
  Rational gauss;                                                    // if normal is not zero
  std::pair<Rational, Rational> mean, principal_min, principal_max;  // brackets
};
inline Shape shape_of(const std::map<std::array<int, 2>, std::vector<Rational>>& jets) {
  const auto d = [&](int u, int v) {
    const auto& x = jets.at({u, v});
    return Vector{x[0], x[1], x[2]};
  };
  Shape out;
  const Vector u = d(1, 0), v = d(0, 1), n = out.normal = cross(u, v);
  const Rational n2 = dot(n, n);
  if (n2.sign() == Sign::kZero) return out;
  const Rational e = dot(d(2, 0), n), f = dot(d(1, 1), n), g = dot(d(0, 2), n);
  out.gauss = (e * g - f * f) / (n2 * n2);
  const Rational top =
      (e * dot(v, v) - Rational(2) * f * dot(u, v) + g * dot(u, u)) / (Rational(2) * n2);
  const auto size = root(n2);
  const std::pair<Rational, Rational> ends = std::minmax({top / size.first, top / size.second});
  out.mean = ends;
  // H^2 - K = top^2 / n2 - K exactly.
  const auto spread = root(top * top / n2 - out.gauss);
  out.principal_min = {ends.first - spread.second, ends.second - spread.first};
  out.principal_max = {ends.first + spread.first, ends.second + spread.second};
  return out;
}

}  // namespace veritope::exact_jets
