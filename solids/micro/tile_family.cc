// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/tile_family.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "solids/micro/power_form_internal.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_product.h"
#include "splines/binomial.h"

namespace veritope {
namespace {

using Coefficients = std::vector<Rational>;  // of 1, x, x^2, ...

// The polynomial c(lo + (hi - lo) s) in Bernstein form over 0 <= s <= 1, in the degree of the list.
Coefficients bernstein_over(const Coefficients& c, const Rational& lo, const Rational& hi) {
  Coefficients power(c.size());               // of s
  for (std::size_t k = c.size(); k-- > 0;) {  // Horner: power = power (lo + (hi - lo) s) + c_k
    Coefficients next(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
      next[i] += power[i] * lo;
      if (i + 1 < c.size()) next[i + 1] += power[i] * (hi - lo);
    }
    next[0] += c[k];
    power = std::move(next);
  }
  const auto n = static_cast<int>(c.size()) - 1;
  Coefficients out(c.size());
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= i; ++k)
      out[static_cast<std::size_t>(i)] +=
          power[static_cast<std::size_t>(k)] * Rational(binomial(i, k)) / Rational(binomial(n, k));
  return out;
}

Rational wall_number(std::int32_t k) { return Rational(k) * Rational::power_of_two(-kWallBits); }

}  // namespace

std::vector<Rational> internal::powers_of(const std::vector<Rational>& b) {
  const auto n = static_cast<int>(b.size()) - 1;
  std::vector<Rational> out(b.size());
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= k; ++i) {
      const Rational term =
          Rational(binomial(n, k)) * Rational(binomial(k, i)) * b[static_cast<std::size_t>(i)];
      if ((k - i) % 2 == 0)
        out[static_cast<std::size_t>(k)] += term;
      else
        out[static_cast<std::size_t>(k)] -= term;
    }
  return out;
}

BezierVolume<Rational> family_of(const TilePatch& patch,
                                 const std::optional<std::array<std::int32_t, 2>>& range) {
  const bool is_fixed = patch.points.size() == 1 || (*range)[0] == (*range)[1];
  const int degree = is_fixed ? 0 : static_cast<int>(patch.points.size()) - 1;
  const std::vector<TilePoint> fixed =
      is_fixed ? points_at(patch, range.has_value() ? (*range)[0] : 0) : std::vector<TilePoint>();
  std::vector<Rational> all;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < patch.num_points(); ++i) {
      if (is_fixed) {
        all.push_back(fixed[i][c]);
        continue;
      }
      Coefficients powers;
      for (const auto& list : patch.points) powers.push_back(list[i][c]);
      for (Rational& x : bernstein_over(powers, wall_number((*range)[0]), wall_number((*range)[1])))
        all.push_back(std::move(x));
    }
  return {{patch.degrees[0], patch.degrees[1], degree}, 3, false, std::move(all)};
}

BezierVolume<Rational> star_product(const BezierVolume<Rational>& family, const TilePoint& a) {
  std::vector<Rational> shifted;
  for (int c = 0; c < 3; ++c)
    for (const Rational& x : family.component(c))
      shifted.push_back(x - a[static_cast<std::size_t>(c)]);
  const BezierVolume<Rational> from_a(family.degrees(), 3, false, std::move(shifted));
  return dot(cross(derivative(from_a, 0), derivative(from_a, 1)), from_a);
}

BezierVolume<Rational> height_over(const BezierVolume<Rational>& family, int wall) {
  const auto x = family.component(wall / 2);
  std::vector<Rational> h(x.begin(), x.end());
  if (wall % 2 == 1)
    for (Rational& r : h) r = Rational(1) - r;
  return {family.degrees(), 1, false, std::move(h)};
}

std::string side_key(const TilePatch& patch, std::size_t side, bool is_backwards) {
  const auto n = static_cast<std::size_t>(tile_side_degree(patch.degrees, side)) + 1;
  std::vector<std::array<Coefficients, 3>> by_power;  // of t
  for (const auto& list : patch.points) {
    std::array<Coefficients, 3>& xyz = by_power.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < n; ++i)
        xyz[c].push_back(
            list[tile_side_index(patch.degrees, side, is_backwards ? n - 1 - i : i)][c]);
      xyz[c] = internal::powers_of(xyz[c]);
    }
  }
  bool is_point = true;
  std::string text;
  for (std::size_t k = 0; k < by_power.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < n; ++i) {
        const Rational& x = by_power[k][c][i];
        if (x.sign() == Sign::kZero) continue;
        is_point = is_point && i == 0;
        const std::string wall = k == 0 ? "" : "w" + std::to_string(*patch.wall);
        text += wall + "t" + std::to_string(k) + "xyz"[c] + std::to_string(i) + "=" +
                x.to_string() + ";";
      }
  return is_point ? "" : text;
}

}  // namespace veritope
