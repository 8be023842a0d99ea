// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_iso_cut.cc: where cells of an isosurface are cut (solids/dms/dms_iso_form.h). In binary64: nothing is
// proved of the places.
#include <algorithm>
#include <cmath>

#include "interval/upward.h"
#include "robust/simplest.h"
#include "solids/dms/dms_iso_form.h"

namespace veritope {
namespace {

constexpr double kTouch = 0x1p-30;  // of the greatest coefficient
constexpr std::array<DmsCorners, 4> kFaces = {7, 11, 13, 14};

double centre_of(const Interval& x) { return x.lo() / 2 + x.hi() / 2; }

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

// The fraction of least denominator beside a number, if it is not near an end.
std::optional<Rational> simplest_near(double t) {
  const Rational middle = Rational::from_double(t), near = Rational::power_of_two(-36);
  if (middle <= near || middle >= Rational(1) - near) return std::nullopt;
  return simplest_between(middle - near, middle + near);
}

// p on a face, in binary64: coefficients by the powers of the second and the third corner's coordinates u and v.
class FaceNet {
 public:
  FaceNet(const DmsIsoForm& form, int degree, DmsCorners face) : degree_(degree) {
    for (std::size_t m = 0, k = 0; m < 4; ++m)
      if ((face >> m & 1) != 0) corners_[k++] = m;
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        TetrahedralIndex index{};
        index[corners_[0]] = degree - a - b;
        index[corners_[1]] = a;
        index[corners_[2]] = b;
        net_.push_back(centre_of(form.coefficients[tetrahedral_index(index)]));
        size_ = std::max(size_, std::abs(net_.back()));
      }
  }
  const std::array<std::size_t, 3>& corners() const { return corners_; }

  // Inside of the face, with a value near 0: by Newton's method from its middle.
  std::optional<std::array<double, 2>> find_critical_point() const {
    double u = 1.0 / 3, v = 1.0 / 3;
    for (int step = 0; step < kSteps; ++step) {
      const std::array<double, 6> c = quadratic_at(u, v);
      const double w = 1 - u - v;
      const double d0 = w * c[0] + u * c[3] + v * c[1], d1 = w * c[3] + u * c[5] + v * c[4],
                   d2 = w * c[1] + u * c[4] + v * c[2];
      const double uu = c[5] - 2 * c[3] + c[0], uv = c[4] - c[3] - c[1] + c[0],
                   vv = c[2] - 2 * c[1] + c[0], det = (degree_ - 1) * (uu * vv - uv * uv);
      const double du = (vv * (d1 - d0) - uv * (d2 - d0)) / det,
                   dv = (uu * (d2 - d0) - uv * (d1 - d0)) / det;
      if (!std::isfinite(du) || !std::isfinite(dv)) return std::nullopt;
      if (std::abs(du) + std::abs(dv) < kConverged) {
        const bool is_inside = std::min({u, v, w}) > kConverged;
        const bool is_level = std::abs(w * d0 + u * d1 + v * d2) <= kTouch * size_;
        return is_inside && is_level ? std::optional(std::array{u, v}) : std::nullopt;
      }
      u -= du, v -= dv;
      if (std::min({u, v, 1 - u - v}) < -1) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  static constexpr int kSteps = 12;
  static constexpr double kConverged = 0x1p-40;

  // The coefficients of de Casteljau's last step but two, (a, b) in the order 00, 01, 02, 10, 11, 20.
  std::array<double, 6> quadratic_at(double u, double v) const {
    std::vector<double> net = net_;
    for (int n = degree_; n > 2; --n) {
      std::vector<double> next;
      const auto at = [&](int a, int b) {
        return net[static_cast<std::size_t>(a * (n + 1) - a * (a - 1) / 2 + b)];
      };
      for (int a = 0; a < n; ++a)
        for (int b = 0; a + b < n; ++b)
          next.push_back((1 - u - v) * at(a, b) + u * at(a + 1, b) + v * at(a, b + 1));
      net = std::move(next);
    }
    return {net[0], net[1], net[2], net[3], net[4], net[5]};
  }

  int degree_;
  std::array<std::size_t, 3> corners_{};
  std::vector<double> net_;
  double size_ = 0;
};

}  // namespace

std::size_t DmsIsoRule::widest_edge(const DmsIsoForm& form, DmsCorners corners) const {
  std::size_t found = 0;
  double most = -1;
  const ScopedUpward upward;
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
    const auto [i, j] = kDmsEdges[e];
    if ((corners >> i & 1) == 0 || (corners >> j & 1) == 0) continue;
    double low = 0, high = 0;
    bool is_first = true;
    for (std::size_t r = 0; r < raised_.size(); ++r) {
      if ((used_[r] & ~corners) != 0) continue;
      const double slope =
          centre_of(form.coefficients[raised_[r][j]]) - centre_of(form.coefficients[raised_[r][i]]);
      low = is_first ? slope : std::min(low, slope);
      high = is_first ? slope : std::max(high, slope);
      is_first = false;
    }
    // How much the N_γ change along the edge, times how much their r_γ do in the cell.
    double rest = 0;
    for (std::size_t s = 0; s < form.supports.size(); ++s) {
      const Interval* r = &form.rests[4 * s];
      double change = 0;
      for (std::size_t m = 1; m < 4; ++m)
        change = std::max(change, std::abs(centre_of(r[m]) - centre_of(r[0])));
      rest += change * std::abs(form.shares[4 * s + i] - form.shares[4 * s + j]);
    }
    const double varies = high - low + rest;
    if (varies > most) most = varies, found = e;
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
  if (!form.is_polynomial() || degree_ < 2) return middle;
  std::vector<double> values, slopes;
  for (const Interval& x : along_edge(form, edge)) values.push_back(centre_of(x));
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

// Where the level may touch an edge or a face, as far as binary64 sees: no cut elsewhere ever decides the parts.
std::optional<DmsIsoCut> DmsIsoRule::find_touch(const DmsIsoForm& form, DmsCorners corners) const {
  if (!form.is_polynomial() || degree_ < 2) return std::nullopt;
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
    const DmsCorners ends = 1u << kDmsEdges[e][0] | 1u << kDmsEdges[e][1];
    if ((ends & ~corners) != 0) continue;
    if (auto touch = touch_of_edge(form, e)) return touch;
  }
  for (const DmsCorners face : kFaces)
    if ((face & ~corners) == 0)
      if (auto touch = touch_of_face(form, face)) return touch;
  return std::nullopt;
}

std::optional<DmsIsoCut> DmsIsoRule::touch_of_edge(const DmsIsoForm& form, std::size_t edge) const {
  std::vector<double> values, slopes;
  double size = 0;
  for (const Interval& x : along_edge(form, edge)) {
    values.push_back(centre_of(x));
    size = std::max(size, std::abs(values.back()));
  }
  for (std::size_t k = 0; k + 1 < values.size(); ++k) slopes.push_back(values[k + 1] - values[k]);
  const auto extremum = sign_change(slopes);
  if (!extremum || std::abs(bernstein_value(values, *extremum)) > kTouch * size)
    return std::nullopt;
  const auto place = simplest_near(*extremum);
  return place ? std::optional(DmsIsoCut{edge, *place, true, true}) : std::nullopt;
}

// Where to cut a side of the face, so that the new edge goes through the place.
std::optional<DmsIsoCut> DmsIsoRule::touch_of_face(const DmsIsoForm& form, DmsCorners face) const {
  const FaceNet net(form, degree_, face);
  const auto at = net.find_critical_point();
  if (!at) return std::nullopt;
  const auto [u, v] = *at;
  const auto place = simplest_near(v / (u + v));
  if (!place) return std::nullopt;
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e)
    if (kDmsEdges[e][0] == net.corners()[1] && kDmsEdges[e][1] == net.corners()[2])
      return DmsIsoCut{e, *place, true, true};
  return std::nullopt;
}

// With `extrema_first` an edge with an extremum on which g - c is not proved to keep its sign. Where there is not any,
// the edge along which the derivative varies most.
DmsIsoCut DmsIsoRule::choose_cut(const DmsIsoForm& form, DmsCorners corners,
                                 bool extrema_first) const {
  if (const auto touch = find_touch(form, corners)) return *touch;
  for (std::size_t e = 0; extrema_first && e < kDmsEdges.size(); ++e) {
    const DmsCorners ends = 1u << kDmsEdges[e][0] | 1u << kDmsEdges[e][1];
    if ((ends & ~corners) != 0 || sign_on(form, ends) != 0) continue;
    DmsIsoCut cut = cut_of_edge(form, e, true);
    if (cut.is_extremum) return cut;
  }
  return cut_of_edge(form, widest_edge(form, corners), extrema_first);
}

}  // namespace veritope
