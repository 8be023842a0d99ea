// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_iso_form.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "interval/upward.h"

namespace veritope {
namespace {

constexpr int kTurns = 100;
constexpr std::array<DmsCorners, 11> kSimplices = {15, 7, 11, 13, 14, 3, 5, 9, 6, 10, 12};

int sign_as_int(const Interval& x) {
  const Sign3 sign = x.sign();
  return sign == Sign3::kPositive ? 1 : sign == Sign3::kNegative ? -1 : 0;
}
double middle_of(const Interval& x) { return x.lo() / 2 + x.hi() / 2; }

using Slope = DmsIsoSlopes::Slope;
using Direction = DmsIsoSlopes::Direction;

double product(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length_of(const Direction& a) { return std::sqrt(product(a, a)); }
Interval along(const Slope& s, const Direction& e) {
  return s[0] * Interval(e[0]) + s[1] * Interval(e[1]) + s[2] * Interval(e[2]);
}
Direction middle_of(const Slope& s) { return {middle_of(s[0]), middle_of(s[1]), middle_of(s[2])}; }

}  // namespace

// What the rests add on a simplex. N_γ is at least the least of its limits at the corners (DMS-4.L2). So the sum is
// `sure`, an affine function, and `open` times a value in the hull of zero and the rests.
struct DmsIsoRule::Mixture {
  std::array<Interval, 4> sure{};  // at the corners of the cell
  double open = 0;
};

// Under a live ScopedUpward.
DmsIsoRule::Mixture DmsIsoRule::mixture(const DmsIsoForm& form, DmsCorners corners) {
  Mixture out;
  Interval sum(0.0);
  for (std::size_t s = 0; s < form.supports.size(); ++s) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < 4; ++m)
      if ((corners >> m & 1) != 0) least = std::min(least, form.shares[4 * s + m]);
    if (!(least > 0)) continue;
    const Interval share(least);
    sum = sum + share;
    for (std::size_t m = 0; m < 4; ++m) out.sure[m] = out.sure[m] + form.rests[4 * s + m] * share;
  }
  if (!form.supports.empty()) out.open = std::max(0.0, (Interval(1.0) - sum).hi());
  return out;
}

Interval DmsIsoSlopes::range(std::size_t k) const {
  const auto hull = [k](Interval x, const std::vector<Slope>& all) {
    for (const Slope& s : all)
      x = Interval::from_bounds(std::min(x.lo(), s[k].lo()), std::max(x.hi(), s[k].hi()));
    return x;
  };
  return hull(polynomial.front()[k], polynomial) + hull(Interval(0.0), rests);
}

std::optional<Direction> DmsIsoSlopes::guess_direction(bool may_be_zero) const {
  std::vector<Direction> steps, moves;
  Direction e{};
  // Numbers near 1, whose squares are in range.
  double most = 0;
  for (const auto* list : {&polynomial, &rests})
    for (const Slope& slope : *list)
      for (const double x : middle_of(slope)) most = std::max(most, std::abs(x));
  const int exponent = most > 0 && std::isfinite(most) ? std::ilogb(most) : 0;
  const auto scaled = [&](const Slope& slope) {
    Direction out = middle_of(slope);
    for (double& x : out) x = std::ldexp(x, -exponent);
    return out;
  };
  for (const Slope& slope : polynomial) {
    const Direction step = scaled(slope);
    const double length = length_of(step);
    if (may_be_zero && length == 0) continue;
    if (!std::isfinite(length) || (rests.empty() && !(length > 0))) return std::nullopt;
    steps.push_back(step);
    for (std::size_t k = 0; k < 3 && length > 0; ++k) e[k] += step[k] / length;
  }
  if (steps.empty()) return std::nullopt;
  for (const Slope& slope : rests) moves.push_back(scaled(slope));
  for (double& x : e) x /= static_cast<double>(steps.size());
  for (int turn = 0; turn < kTurns; ++turn) {
    Direction against{};  // the rest that is most against it
    for (const Direction& move : moves)
      if (product(move, e) < product(against, e)) against = move;
    Direction worst{};
    double least = std::numeric_limits<double>::infinity();  // of cosines, times |e|
    for (const Direction& step : steps) {
      Direction unit{step[0] + against[0], step[1] + against[1], step[2] + against[2]};
      const double length = length_of(unit);
      if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
      for (double& x : unit) x /= length;
      const double cosine = product(unit, e);
      if (cosine < least) least = cosine, worst = unit;
    }
    if (least > 0.01 * length_of(e)) return e;
    for (std::size_t k = 0; k < 3; ++k) e[k] += 0.5 * worst[k];
  }
  return e;
}

bool DmsIsoSlopes::all_grow_along(const Direction& e, bool may_be_zero) const {
  double least = 0;
  for (const Slope& slope : rests) {
    const double low = along(slope, e).lo();
    if (std::isnan(low)) return false;
    least = std::min(least, low);
  }
  return std::all_of(polynomial.begin(), polynomial.end(), [&](const Slope& slope) {
    const double low = (along(slope, e) + Interval(least)).lo();
    return may_be_zero ? low >= 0 : low > 0;
  });
}

DmsIsoRule::DmsIsoRule(int degree) : degree_(degree) {
  const auto corners_of = [](const TetrahedralIndex& index) {
    DmsCorners used = 0;
    for (std::size_t m = 0; m < 4; ++m)
      if (index[m] > 0) used |= 1u << m;
    return used;
  };
  for_each_tetrahedral_index(degree - 1, [&](const TetrahedralIndex& gamma) {
    std::array<std::size_t, 4> places{};
    for (std::size_t m = 0; m < 4; ++m) places[m] = tetrahedral_index(raised(gamma, m));
    raised_.push_back(places);
    used_.push_back(corners_of(gamma));
  });
  for_each_tetrahedral_index(
      degree, [&](const TetrahedralIndex& beta) { with_.push_back(corners_of(beta)); });
}

// Those that count on the simplex: a polynomial's on a face are of its corners alone.
DmsIsoSlopes DmsIsoRule::slopes(const DmsIsoForm& form, DmsCorners corners,
                                std::size_t first) const {
  std::vector<std::size_t> chosen{first};
  for (std::size_t m = 0; m < 4; ++m)
    if (m != first && (corners >> m & 1) != 0) chosen.push_back(m);
  const Mixture mix = mixture(form, corners);
  DmsIsoSlopes out;
  out.size = chosen.size() - 1;
  for (std::size_t r = 0; r < raised_.size(); ++r) {
    if ((used_[r] & ~corners) != 0) continue;
    Slope& slope = out.polynomial.emplace_back();
    for (std::size_t k = 1; k < chosen.size(); ++k) {
      const std::size_t i = chosen[0], j = chosen[k];
      slope[k - 1] = form.coefficients[raised_[r][j]] - form.coefficients[raised_[r][i]];
      if (!form.is_polynomial()) slope[k - 1] = slope[k - 1] + (mix.sure[j] - mix.sure[i]);
    }
  }
  for (std::size_t s = 0; s < form.supports.size() && mix.open > 0; ++s) {
    Slope& slope = out.rests.emplace_back();
    for (std::size_t k = 1; k < chosen.size(); ++k)
      slope[k - 1] = Interval::nonnegative_multiple(
          form.rests[4 * s + chosen[k]] - form.rests[4 * s + chosen[0]], Interval(mix.open));
  }
  return out;
}

Interval DmsIsoRule::at_corner(const DmsIsoForm& form, std::size_t corner) const {
  TetrahedralIndex index{};
  index[corner] = degree_;
  const ScopedUpward upward;
  const Interval& value = form.coefficients[tetrahedral_index(index)];
  return form.is_polynomial() ? value : value + rest_on(form, 1u << corner);
}

// Bounds the sum of all N_γ r_γ on the simplex.
Interval DmsIsoRule::rest_on(const DmsIsoForm& form, DmsCorners corners) {
  const Mixture mix = mixture(form, corners);
  double low = 0, high = 0;
  for (std::size_t r = 0; r < form.rests.size(); ++r) {
    if ((corners >> (r % 4) & 1) == 0) continue;
    low = std::min(low, form.rests[r].lo());
    high = std::max(high, form.rests[r].hi());
  }
  const Interval open =
      Interval::nonnegative_multiple(Interval::from_bounds(low, high), Interval(mix.open));
  Interval sure = Interval::empty();
  for (std::size_t m = 0; m < 4; ++m) {
    if ((corners >> m & 1) == 0) continue;
    const Interval& x = mix.sure[m];
    sure = sure.is_empty()
               ? x
               : Interval::from_bounds(std::min(sure.lo(), x.lo()), std::max(sure.hi(), x.hi()));
  }
  return sure + open;
}

std::vector<Interval> DmsIsoRule::along_edge(const DmsIsoForm& form, std::size_t edge) const {
  std::vector<Interval> out;
  for (int k = 0; k <= degree_; ++k) {
    TetrahedralIndex index{};
    index[kDmsEdges[edge][0]] = degree_ - k;
    index[kDmsEdges[edge][1]] = k;
    out.push_back(form.coefficients[tetrahedral_index(index)]);
  }
  return out;
}

int DmsIsoRule::sign_on(const DmsIsoForm& form, DmsCorners corners, DmsCorners zeros) const {
  const ScopedUpward upward;
  const Interval rest = form.is_polynomial() ? Interval(0.0) : rest_on(form, corners);
  int sign = 0;
  for (std::size_t b = 0; b < form.coefficients.size(); ++b) {
    if ((with_[b] & ~corners) != 0) continue;
    const Interval x = form.coefficients[b] + rest;
    const int s = (zeros & corners) != 0 && x.lo() >= 0 ? 1 : sign_as_int(x);
    if (s == 0 || s * sign < 0) return 0;
    sign = s;
  }
  return sign;
}

// By the value at a corner and the slopes from there to the others: tighter than hulls of values where the N_γ of rests
// far from 0 are not known to be small.
int DmsIsoRule::sign_by_slopes(const DmsIsoForm& form, DmsCorners corners) const {
  const ScopedUpward upward;
  for (std::size_t m = 0; m < 4; ++m) {
    if ((corners >> m & 1) == 0) continue;
    const Interval value = at_corner(form, m);
    const DmsIsoSlopes from_m = slopes(form, corners, m);
    double low = 0, high = 0;
    for (std::size_t k = 0; k < from_m.size; ++k) {
      const Interval x = from_m.range(k);
      low = std::min(low, x.lo());
      high = std::max(high, x.hi());
    }
    const int sign = sign_as_int(value + Interval::from_bounds(low, high));
    if (sign != 0) return sign;
  }
  return 0;
}

bool DmsIsoRule::is_monotone_on(const DmsIsoForm& form, DmsCorners corners,
                                DmsCorners zeros) const {
  const ScopedUpward upward;
  const auto first = static_cast<std::size_t>(std::countr_zero(corners));
  DmsIsoSlopes all = slopes(form, corners, first);
  const auto e = all.guess_direction();
  if (e && all.all_grow_along(*e)) return true;
  if ((zeros & corners) == 0) return false;
  Slope grows{};  // the sum of the coordinates of zeros
  for (std::size_t m = first + 1, k = 0; m < 4; ++m)
    if ((corners >> m & 1) != 0)
      grows[k++] = Interval(static_cast<double>(zeros >> m & 1) - (zeros >> first & 1));
  all.polynomial.push_back(grows);
  const auto weak = all.guess_direction(true);
  return weak && all.all_grow_along(*weak, true) && along(grows, *weak).lo() > 0;
}

std::optional<DmsCorners> DmsIsoRule::find_open(const DmsIsoForm& form, DmsCorners zeros) const {
  for (const DmsCorners simplex : kSimplices)
    if (sign_on(form, simplex, zeros) == 0 && !is_monotone_on(form, simplex, zeros) &&
        (form.is_polynomial() || sign_by_slopes(form, simplex) == 0))
      return simplex;
  return std::nullopt;
}

std::pair<DmsIsoForm, DmsIsoForm> DmsIsoRule::cut(const DmsIsoForm& form, std::size_t edge,
                                                  const Rational& t) const {
  const Interval far = enclose(t), near = enclose(Rational(1) - t);
  const ScopedUpward upward;
  const std::size_t i = kDmsEdges[edge][0], j = kDmsEdges[edge][1];
  const auto mix = [&](const Interval& a, const Interval& b) {
    return Interval::nonnegative_multiple(a, near) + Interval::nonnegative_multiple(b, far);
  };
  DmsIsoForm first = form, second = form;
  for (std::size_t s = 0; s < form.supports.size(); ++s)
    first.rests[4 * s + j] = second.rests[4 * s + i] =
        mix(form.rests[4 * s + i], form.rests[4 * s + j]),
                        first.shares[4 * s + j] = second.shares[4 * s + i] = 0;
  for_each_tetrahedral_index(degree_, [&](const TetrahedralIndex& start) {
    if (start[j] != 0) return;
    // de Casteljau along the coefficients (r, 0), (r - 1, 1), ..., (0, r) of the two corners.
    const int r = start[i];
    std::vector<std::size_t> places;
    std::vector<Interval> b;
    for (int s = 0; s <= r; ++s) {
      TetrahedralIndex index = start;
      index[i] = r - s;
      index[j] = s;
      places.push_back(tetrahedral_index(index));
      b.push_back(form.coefficients[places.back()]);
    }
    for (std::size_t step = 0; step < places.size(); ++step) {
      first.coefficients[places[step]] = b[0];
      second.coefficients[places[places.size() - 1 - step]] = b[places.size() - 1 - step];
      for (std::size_t s = 0; s + step + 1 < places.size(); ++s) b[s] = mix(b[s], b[s + 1]);
    }
  });
  return {std::move(first), std::move(second)};
}

}  // namespace veritope
