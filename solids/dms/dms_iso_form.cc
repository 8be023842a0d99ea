// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_iso_form.h"

#include <algorithm>
#include <cmath>

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

// The derivatives of a term along the edges from the first corner.
using Slope = std::array<Interval, 3>;
using Direction = std::array<double, 3>;

double product(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// Whether all terms grow along the direction. Under a live ScopedUpward.
bool all_grow(const std::vector<Slope>& slopes, const Direction& e) {
  return std::all_of(slopes.begin(), slopes.end(), [&](const Slope& s) {
    const Interval along = s[0] * Interval(e[0]) + s[1] * Interval(e[1]) + s[2] * Interval(e[2]);
    return along.sign() == Sign3::kPositive;
  });
}
// A polynomial's value by its Bernstein coefficients.
double bernstein_value(std::vector<double> b, double t) {
  for (std::size_t left = b.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k) b[k] += t * (b[k + 1] - b[k]);
  return b[0];
}
// Where it changes its sign, if it has unlike ones at 0 and 1.
std::optional<double> sign_change(const std::vector<double>& b) {
  if (!(b.front() * b.back() < 0)) return std::nullopt;
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double t = (low + high) / 2;
    (bernstein_value(b, t) * b.front() > 0 ? low : high) = t;
  }
  return (low + high) / 2;
}
// Some 34 bits of the distance from the nearer end.
Rational few_bits(double t) {
  const double near = std::max(std::min(t, 1 - t), 0x1p-40);
  const double unit = std::ldexp(1.0, std::ilogb(near) - 34),
               rounded = std::round(near / unit) * unit;
  const Rational distance = Rational::from_double(rounded);
  return t < 0.5 ? distance : Rational(1) - distance;
}

// A direction along which all terms grow: the mean of their directions, turned to the one that is most against it.
// Nothing is proved here.
std::optional<Direction> guess_direction(const std::vector<Slope>& slopes) {
  std::vector<Direction> units;
  Direction e{};
  for (const Slope& slope : slopes) {
    Direction unit{middle_of(slope[0]), middle_of(slope[1]), middle_of(slope[2])};
    const double length = std::sqrt(product(unit, unit));
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) e[k] += unit[k] /= length;
    units.push_back(unit);
  }
  for (double& x : e) x /= static_cast<double>(units.size());
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto worst = std::min_element(
        units.begin(), units.end(),
        [&](const Direction& a, const Direction& b) { return product(a, e) < product(b, e); });
    if (product(*worst, e) > 0.01 * std::sqrt(product(e, e))) return e;
    for (std::size_t k = 0; k < 3; ++k) e[k] += 0.5 * (*worst)[k];
  }
  return e;
}

}  // namespace

DmsIsoRule::DmsIsoRule(int degree) : degree_(degree) {
  for_each_tetrahedral_index(degree - 1, [&](const TetrahedralIndex& gamma) {
    std::array<std::size_t, 4> places{};
    DmsCorners used = 0;
    for (std::size_t m = 0; m < 4; ++m) {
      places[m] = tetrahedral_index(raised(gamma, m));
      if (gamma[m] > 0) used |= 1u << m;
    }
    raised_.push_back(places);
    used_.push_back(used);
  });
}

// The terms that count on the simplex: those of a polynomial on a face are of its corners alone.
std::vector<DmsIsoRule::Row> DmsIsoRule::rows(const DmsIsoForm& form, DmsCorners corners) const {
  std::vector<Row> out;
  const std::size_t count = form.is_polynomial ? raised_.size() : form.supports.size();
  for (std::size_t r = 0; r < count; ++r) {
    if (form.is_polynomial && (used_[r] & ~corners) != 0) continue;
    Row& row = out.emplace_back();
    for (std::size_t m = 0; m < 4; ++m)
      row[m] = &form.numbers[form.is_polynomial ? raised_[r][m] : 4 * r + m];
  }
  return out;
}

Interval DmsIsoRule::at_corner(const DmsIsoForm& form, std::size_t corner) {
  if (form.is_polynomial) {
    // x^n of the corner: the last index of its row.
    const std::size_t last = form.numbers.size() - 1;
    if (corner == 0) return form.numbers[0];
    if (corner == 3) return form.numbers[last];
    int n = 1;
    while (num_tetrahedral_indices(n) < form.numbers.size()) ++n;
    TetrahedralIndex index{};
    index[corner] = n;
    return form.numbers[tetrahedral_index(index)];
  }
  Interval hull = Interval::empty();
  for (std::size_t s = 0; s < form.supports.size(); ++s) {
    const Interval& x = form.numbers[4 * s + corner];
    hull = s == 0 ? x
                  : Interval::from_bounds(std::min(hull.lo(), x.lo()), std::max(hull.hi(), x.hi()));
  }
  return hull;
}

std::vector<Interval> DmsIsoRule::along_edge(const DmsIsoForm& form, std::size_t edge) const {
  std::vector<Interval> out;
  for (int k = 0; k <= degree_; ++k) {
    TetrahedralIndex index{};
    index[kDmsEdges[edge][0]] = degree_ - k;
    index[kDmsEdges[edge][1]] = k;
    out.push_back(form.numbers[tetrahedral_index(index)]);
  }
  return out;
}

int DmsIsoRule::sign_on(const DmsIsoForm& form, DmsCorners corners) const {
  int sign = 0;
  for (const Row& row : rows(form, corners))
    for (std::size_t m = 0; m < 4; ++m) {
      if ((corners >> m & 1) == 0) continue;
      const int s = sign_as_int(*row[m]);
      if (s == 0 || s * sign < 0) return 0;
      sign = s;
    }
  return sign;
}

bool DmsIsoRule::is_monotone_on(const DmsIsoForm& form, DmsCorners corners) const {
  const ScopedUpward upward;
  std::vector<std::size_t> chosen;
  for (std::size_t m = 0; m < 4; ++m)
    if ((corners >> m & 1) != 0) chosen.push_back(m);
  std::vector<Slope> slopes;
  for (const Row& row : rows(form, corners)) {
    Slope slope;
    for (std::size_t k = 1; k < chosen.size(); ++k)
      slope[k - 1] = *row[chosen[k]] - *row[chosen[0]];
    slopes.push_back(slope);
  }
  if (slopes.empty()) return false;
  const auto e = guess_direction(slopes);
  return e && all_grow(slopes, *e);
}

std::optional<DmsCorners> DmsIsoRule::find_open(const DmsIsoForm& form) const {
  for (const DmsCorners simplex : kSimplices)
    if (sign_on(form, simplex) == 0 && !is_monotone_on(form, simplex)) return simplex;
  return std::nullopt;
}

std::size_t DmsIsoRule::widest_edge(const DmsIsoForm& form, DmsCorners corners) const {
  std::size_t found = 0;
  double most = -1;
  const std::vector<Row> all = rows(form, corners);
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
    const auto [i, j] = kDmsEdges[e];
    if ((corners >> i & 1) == 0 || (corners >> j & 1) == 0) continue;
    double low = 0, high = 0;
    for (std::size_t r = 0; r < all.size(); ++r) {
      const double slope = middle_of(*all[r][j]) - middle_of(*all[r][i]);
      low = r == 0 ? slope : std::min(low, slope);
      high = r == 0 ? slope : std::max(high, slope);
    }
    if (high - low > most) most = high - low, found = e;
  }
  return found;
}

// Where g has an extremum along the edge that is not near an end; with `extrema_first`, one where g - c has another
// sign than at an end, if the level is not much farther from that end. Near such an end halfway between it and the
// level; else the middle.
DmsIsoCut DmsIsoRule::cut_of_edge(const DmsIsoForm& form, std::size_t edge,
                                  bool extrema_first) const {
  constexpr double kMuchFarther = 64, kNearEnd = 1.0 / 16, kNearLevel = 1.0 / 4, kFlat = 1.0 / 16;
  const DmsIsoCut middle{edge, Rational(1) / Rational(2), false};
  if (!form.is_polynomial || degree_ < 2) return middle;
  std::vector<double> values, slopes;
  for (const Interval& x : along_edge(form, edge)) values.push_back(middle_of(x));
  for (std::size_t k = 0; k + 1 < values.size(); ++k) slopes.push_back(values[k + 1] - values[k]);
  const auto extremum = sign_change(slopes), level = sign_change(values);
  const double most = extremum ? bernstein_value(values, *extremum) : 0;
  const double from_end = extremum ? std::min(*extremum, 1 - *extremum) : 0;
  if (!extrema_first && from_end > kNearEnd) return {edge, few_bits(*extremum), true};
  if (extrema_first && extremum && (most * values.front() < 0 || most * values.back() < 0)) {
    const double to_level = !level ? 1 : *extremum < 0.5 ? *level : 1 - *level;
    if (kMuchFarther * from_end > to_level) return {edge, few_bits(*extremum), true};
  }
  if (!level) return middle;
  const bool is_flat_at_0 = std::abs(slopes.front()) < kFlat * std::abs(slopes.back());
  const bool is_flat_at_1 = std::abs(slopes.back()) < kFlat * std::abs(slopes.front());
  if (is_flat_at_0 && *level < kNearLevel) return {edge, few_bits(*level / 2), false};
  if (is_flat_at_1 && *level > 1 - kNearLevel) return {edge, few_bits((1 + *level) / 2), false};
  return middle;
}

// With `extrema_first` an edge with an extremum on which g - c is not proved to keep its sign. Where there is not any,
// the edge along which the derivative varies most.
DmsIsoCut DmsIsoRule::choose_cut(const DmsIsoForm& form, DmsCorners corners,
                                 bool extrema_first) const {
  for (std::size_t e = 0; extrema_first && e < kDmsEdges.size(); ++e) {
    const DmsCorners ends = 1u << kDmsEdges[e][0] | 1u << kDmsEdges[e][1];
    if ((ends & ~corners) != 0 || sign_on(form, ends) != 0) continue;
    DmsIsoCut cut = cut_of_edge(form, e, true);
    if (cut.is_extremum) return cut;
  }
  return cut_of_edge(form, widest_edge(form, corners), extrema_first);
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
  if (!form.is_polynomial) {
    for (std::size_t s = 0; s < form.supports.size(); ++s)
      first.numbers[4 * s + j] = second.numbers[4 * s + i] =
          mix(form.numbers[4 * s + i], form.numbers[4 * s + j]);
    return {std::move(first), std::move(second)};
  }
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
      b.push_back(form.numbers[places.back()]);
    }
    for (std::size_t step = 0; step < places.size(); ++step) {
      first.numbers[places[step]] = b[0];
      second.numbers[places[places.size() - 1 - step]] = b[places.size() - 1 - step];
      for (std::size_t s = 0; s + step + 1 < places.size(); ++s) b[s] = mix(b[s], b[s + 1]);
    }
  });
  return {std::move(first), std::move(second)};
}

}  // namespace veritope
