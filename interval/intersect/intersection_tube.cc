// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/intersection_tube.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/box_geometry.h"
#include "robust/dyadic.h"

namespace veritope {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;
using Matrix3 = std::array<std::array<Interval, 3>, 3>;
using Vector = std::array<Interval, 3>;
/// The columns S1_u, S1_v, -S2_s, -S2_t.
using Columns = std::array<Box3, 4>;

using internal::approx_middle, internal::approx_radius;
Interval around(double c, double r) { return Interval::from_bounds(-(-c + r), c + r); }

template <typename Number>
Number determinant(const std::array<Number, 3>& a, const std::array<Number, 3>& b,
                   const std::array<Number, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <typename Number, typename Convert>
Number determinant_as(const Matrix& m, Convert convert) {
  const auto row = [&](std::size_t i) {
    return std::array<Number, 3>{convert(m[i][0]), convert(m[i][1]), convert(m[i][2])};
  };
  return determinant(row(0), row(1), row(2));
}
/// By intervals, or exactly where they contain 0.
Sign sign_of_determinant(const Matrix& m) {
  const Sign3 sign = sign_of(determinant_as<Interval>(m, [](double v) { return Interval(v); }));
  if (is_certain(sign)) return to_sign(sign);
  return sign_of(determinant_as<Dyadic>(m, Dyadic::from_double));
}

/// The other three parameters, in order.
std::array<int, 3> others(int pivot) {
  std::array<int, 3> out{};
  int n = 0;
  for (int i = 0; i < 4; ++i)
    if (i != pivot) out[static_cast<std::size_t>(n++)] = i;
  return out;
}

/// The inverse of the matrix with these columns; false if it is singular in doubles.
bool invert(const std::array<std::array<double, 3>, 3>& columns, Matrix* out) {
  const auto& [a, b, c] = columns;
  const double det = determinant(a, b, c);
  if (!(std::abs(det) > 0) || !std::isfinite(1 / det)) return false;
  const auto cross = [&](const auto& p, const auto& q) {
    return std::array<double, 3>{(p[1] * q[2] - p[2] * q[1]) / det,
                                 (p[2] * q[0] - p[0] * q[2]) / det,
                                 (p[0] * q[1] - p[1] * q[0]) / det};
  };
  *out = {cross(b, c), cross(c, a), cross(a, b)};
  for (const auto& row : *out)
    for (const double v : row)
      if (!std::isfinite(v)) return false;
  return true;
}

Vector times(const Matrix& m, const Box3& v) {
  Vector out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = Interval(m[i][0]) * v[0] + Interval(m[i][1]) * v[1] + Interval(m[i][2]) * v[2];
  return out;
}

Columns columns_of(const Box3& du, const Box3& dv, const Box3& ds, const Box3& dt) {
  const auto negated = [](const Box3& b) { return Box3(-b[0], -b[1], -b[2]); };
  return {du, dv, negated(ds), negated(dt)};
}

Columns columns_over(const EnclosedSurface& s1, const EnclosedSurface& s2, const Box4& x) {
  constexpr auto kOnly = EnclosedSurface::Want::kDerivatives;
  const auto a = s1.range(x[0], x[1], kOnly), b = s2.range(x[2], x[3], kOnly);
  return columns_of(a.du, a.dv, b.du, b.dv);
}

bool is_bounded(const Columns& columns) {
  for (const Box3& column : columns)
    for (const Interval& side : column)
      if (!is_common(side)) return false;
  return true;
}

Box3 gap_at(const EnclosedSurface& s1, const EnclosedSurface& s2, const Point4& x) {
  return s1.point(x[0], x[1]) - s2.point(x[2], x[3]);
}

/// The gap in MPFR intervals from exact coefficients, for use where cancellation leaves too little of gap_at.
Box3 precise_gap_at(const EnclosedSurface& s1, const EnclosedSurface& s2, const Point4& x) {
  constexpr int kPrecision = 160;
  const auto p = s1.precise_point(x[0], x[1], kPrecision),
             q = s2.precise_point(x[2], x[3], kPrecision);
  Box3 out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = (p[c] / p[3] - q[c] / q[3]).to_interval();
  return out;
}

/// The system in the coordinates z of the tube's offset, at a center.
struct Linear {
  Matrix3 excess;  // I - C J_z
  Vector drift;    // C (J_w + J_z slope)
};
Linear linearise(const IntersectionTube& tube, const Columns& columns) {
  Linear out;
  const auto rest = others(tube.pivot);
  Box3 along = columns[static_cast<std::size_t>(tube.pivot)];
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& column = columns[static_cast<std::size_t>(rest[j])];
    along = along + Interval(tube.slope[static_cast<std::size_t>(rest[j])]) * column;
    const Vector product = times(tube.inverse, column);
    for (std::size_t i = 0; i < 3; ++i)
      out.excess[i][j] = i == j ? Interval(1.0) - product[i] : -product[i];
  }
  out.drift = times(tube.inverse, along);
  return out;
}

/// -C F(center) - drift (w - w0) + excess z: where all solutions with offset z over w have their offset.
Vector image(const Linear& linear, const Vector& newton, const Interval& w, const Vector& z) {
  Vector out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = -newton[i] - linear.drift[i] * w + linear.excess[i][0] * z[0] +
             linear.excess[i][1] * z[1] + linear.excess[i][2] * z[2];
  return out;
}

/// Moves the center by the offsets' middles and takes them off.
void recenter(IntersectionTube* tube, Vector* z) {
  const auto rest = others(tube->pivot);
  for (std::size_t i = 0; i < 3; ++i) {
    double& c = tube->center[static_cast<std::size_t>(rest[i])];
    const double moved = c + approx_middle((*z)[i]);
    (*z)[i] = (*z)[i] + (Interval(c) - Interval(moved));
    c = moved;
  }
}

void set_offset(IntersectionTube* tube, const Vector& z) {
  const auto rest = others(tube->pivot);
  for (std::size_t i = 0; i < 3; ++i) tube->offset[static_cast<std::size_t>(rest[i])] = z[i];
}

/// T2 requires less than 1. A number close to 1 would leave the derivatives without a useful bound.
constexpr double kMostContraction = 0.999;

/// Checks T2 (THEORY, TUBE-1), with the radii of z as weights, and bounds the derivatives of the arc: they satisfy
/// dz/dw = -drift + excess dz/dw. Returns false if T2 is not proved. Any positive radii may be used.
bool set_derivative(const Linear& linear, const Vector& z, IntersectionTube* tube) {
  double contraction = 0, largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) sum += mag(linear.excess[i][j]) * approx_radius(z[j]);
    const double r = approx_radius(z[i]);
    if (!(sum / r < kMostContraction)) return false;  // also if it is not a number
    contraction = std::max(contraction, sum / r);
    largest = std::max(largest, mag(linear.drift[i]) / r);
  }
  if (!std::isfinite(largest)) return false;
  // All operations round upward; writing the denominator as -(x - 1) makes it round downward.
  const double bound = largest / -(contraction - 1);
  const auto rest = others(tube->pivot);
  Vector rate;
  for (std::size_t i = 0; i < 3; ++i) {
    const double b = bound * approx_radius(z[i]) * 1.0000001;
    rate[i] = Interval::from_bounds(-b, b);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(rest[i]);
    Interval dz = -linear.drift[i];
    for (std::size_t j = 0; j < 3; ++j) dz = dz + linear.excess[i][j] * rate[j];
    tube->derivative[k] = Interval(tube->slope[k]) + intersection(dz, rate[i]);
  }
  tube->derivative[static_cast<std::size_t>(tube->pivot)] = Interval(1.0);
  tube->excess = linear.excess;
  return true;
}

/// Along n1 x n2 or against it. REQUIRES T2, by which the determinant of the Jacobian has the sign of that of the
/// `inverse` on the whole tube (THEORY, TUBE-1.DIRECTION).
int direction_of(const IntersectionTube& tube) {
  const Sign sign = sign_of_determinant(tube.inverse);
  VT_CHECK(sign != Sign::kZero, "the matrix of a contraction is singular");
  return (sign == Sign::kPositive) == (tube.pivot % 2 == 0) ? -1 : 1;
}

/// Inverts the matrix of the columns' middles, the pivot's left out; false if doubles hold no inverse.
bool choose_inverse(const Columns& columns, IntersectionTube* tube) {
  const auto rest = others(tube->pivot);
  std::array<std::array<double, 3>, 3> kept{};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t c = 0; c < 3; ++c)
      kept[j][c] = approx_middle(columns[static_cast<std::size_t>(rest[j])][c]);
  return invert(kept, &tube->inverse);
}

/// The arc's direction where the columns have their middles.
void choose_slope(const Columns& columns, IntersectionTube* tube) {
  const auto rest = others(tube->pivot);
  tube->slope[static_cast<std::size_t>(tube->pivot)] = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    double s = 0;
    for (std::size_t c = 0; c < 3; ++c)
      s -= tube->inverse[i][c] * approx_middle(columns[static_cast<std::size_t>(tube->pivot)][c]);
    tube->slope[static_cast<std::size_t>(rest[i])] = s;
  }
}

/// Chooses the pivot: the parameter along which the arc is longest in the box's own scale. False if the surfaces
/// are tangential in doubles.
bool choose_chart(const Box4& x, const Columns& columns, IntersectionTube* tube) {
  std::array<std::array<double, 3>, 4> middles{};
  std::array<double, 4> norm{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double r = approx_radius(x[k]);
    for (std::size_t c = 0; c < 3; ++c) middles[k][c] = approx_middle(columns[k][c]) * r;
    norm[k] = std::sqrt(middles[k][0] * middles[k][0] + middles[k][1] * middles[k][1] +
                        middles[k][2] * middles[k][2]);
  }
  double best = 0;
  for (int k = 0; k < 4; ++k) {
    const auto rest = others(k);
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(rest[i]); };
    const double minor = std::abs(determinant(middles[at(0)], middles[at(1)], middles[at(2)]));
    if (minor > best) best = minor, tube->pivot = k;
  }
  const double scale = std::max({norm[0], norm[1], norm[2], norm[3]});
  if (!(best > 1e-14 * scale * scale * scale)) return false;
  if (!choose_inverse(columns, tube)) return false;
  for (std::size_t k = 0; k < 4; ++k) tube->center[k] = approx_middle(x[k]);
  choose_slope(columns, tube);
  return true;
}

Vector newton_step(const EnclosedSurface& s1, const EnclosedSurface& s2,
                   const IntersectionTube& tube) {
  return times(tube.inverse, gap_at(s1, s2, tube.center));
}

/// Whether THEORY, TUBE-1 proves the arc in the tube with its present center, slope, range and offset z; sets what is
/// known of it. Both hypotheses are needed. T1 (the image of z lies in z, borders included) proves that a point exists
/// for every w. T2 proves that it is the only one, and bounds the derivatives. Strict inclusion would imply T2; beside
/// T2 it would add nothing. If T1 fails, z becomes its image.
/// REQUIRES that z contains 0 and the range contains the center's w: the mean value theorem starts from the center.
bool prove(const EnclosedSurface& s1, const EnclosedSurface& s2, IntersectionTube* tube,
           Vector* z) {
  const Interval range = Interval::from_bounds(tube->w_lo, tube->w_hi);
  const Interval w = range - Interval(tube->center[static_cast<std::size_t>(tube->pivot)]);
  set_offset(tube, *z);
  const Columns columns = columns_over(s1, s2, tube->over(range));
  if (!is_bounded(columns)) return false;
  const Linear linear = linearise(*tube, columns);
  const Vector k = image(linear, newton_step(s1, s2, *tube), w, *z);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_subset(k[i], (*z)[i])) continue;
    *z = k;
    return false;
  }
  if (!set_derivative(linear, *z, tube)) return false;
  tube->direction = direction_of(*tube);
  return true;
}

/// How far Jacobians over x are from the chart's, in x's own scale: below 1 a tube of that size may be proved. Measured
/// on random bicubics: one in three is at 0.5, one in ten at 1.2.
double spread_of(const Linear& linear, const Box4& x, int pivot) {
  const auto rest = others(pivot);
  double excess = 0, drift = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double r = approx_radius(x[static_cast<std::size_t>(rest[i])]);
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j)
      sum += mag(linear.excess[i][j]) * approx_radius(x[static_cast<std::size_t>(rest[j])]);
    excess = std::max(excess, sum / r);
    drift = std::max(drift,
                     mag(linear.drift[i]) * approx_radius(x[static_cast<std::size_t>(pivot)]) / r);
  }
  return excess + drift;
}
constexpr double kHopeless = 1.0;

}  // namespace

Box4 IntersectionTube::over(const Interval& w) const {
  const Interval step = w - Interval(center[static_cast<std::size_t>(pivot)]);
  Box4 out;
  for (std::size_t i = 0; i < 4; ++i)
    out[i] = static_cast<int>(i) == pivot
                 ? w
                 : Interval(center[i]) + Interval(slope[i]) * step + offset[i];
  return out;
}

bool IntersectionTube::contains(const Box4& x) const {
  const Interval& w = x[static_cast<std::size_t>(pivot)];
  if (!is_subset(w, Interval::from_bounds(w_lo, w_hi))) return false;
  const Interval step = w - Interval(center[static_cast<std::size_t>(pivot)]);
  for (std::size_t i = 0; i < 4; ++i) {
    if (static_cast<int>(i) == pivot) continue;
    if (!is_subset(x[i] - Interval(center[i]) - Interval(slope[i]) * step, offset[i])) return false;
  }
  return true;
}

bool IntersectionTube::contains(const IntersectionTube& other) const {
  if (other.w_lo >= other.w_hi) return false;
  const auto p = static_cast<std::size_t>(pivot);
  const Interval w_other = Interval::from_bounds(other.w_lo, other.w_hi);
  if (other.pivot != pivot) return contains(other.over(w_other));
  if (!is_subset(w_other, Interval::from_bounds(w_lo, w_hi))) return false;
  const Interval between = Interval(center[p]) - Interval(other.center[p]);
  const Interval step = w_other - Interval(center[p]);
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == p) continue;
    const Interval slope_apart = Interval(other.slope[i]) - Interval(slope[i]);
    const Interval apart = Interval(other.center[i]) - Interval(center[i]) +
                           Interval(other.slope[i]) * between + slope_apart * step +
                           other.offset[i];
    if (!is_subset(apart, offset[i])) return false;
  }
  return true;
}

Contraction contract(const EnclosedSurface& s1, const EnclosedSurface& s2, const Box4& x,
                     const Box3& du, const Box3& dv, const Box3& ds, const Box3& dt,
                     IntersectionTube* region) {
  IntersectionTube& tube = *region;
  const Columns columns = columns_of(du, dv, ds, dt);
  if (!is_bounded(columns) || !choose_chart(x, columns, &tube)) return Contraction::kUnknown;
  const auto rest = others(tube.pivot);
  const auto pivot = static_cast<std::size_t>(tube.pivot);
  const Linear linear = linearise(tube, columns);
  const Interval w = x[pivot] - Interval(tube.center[pivot]);
  Vector z;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(rest[i]);
    z[i] = x[k] - Interval(tube.center[k]) - Interval(tube.slope[k]) * w;
  }
  const Vector k = image(linear, newton_step(s1, s2, tube), w, z);
  double shrink = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval met = intersection(z[i], k[i]);
    if (met.is_empty()) return Contraction::kEmpty;
    shrink =
        std::max(shrink, approx_radius(met) / approx_radius(x[static_cast<std::size_t>(rest[i])]));
    z[i] = met;
  }
  if (shrink > 1.5 || spread_of(linear, x, tube.pivot) > kHopeless) return Contraction::kUnknown;
  recenter(&tube, &z);
  set_offset(&tube, z);
  tube.w_lo = x[pivot].lo(), tube.w_hi = x[pivot].hi();
  // What a box of the same size would leave at least.
  for (std::size_t i = 0; i < 3; ++i) {
    const auto j = static_cast<std::size_t>(rest[i]);
    tube.derivative[j] = around(0, 0.01 * approx_radius(x[j]));
  }
  return Contraction::kSlanted;
}

std::optional<IntersectionTube> find_tube(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                          const IntersectionTube& region, double reach) {
  const auto rest = others(region.pivot);
  IntersectionTube tube = region;
  const double more = reach * (region.w_hi - region.w_lo);
  tube.w_lo = region.w_lo - more, tube.w_hi = region.w_hi + more;
  Vector covered, z;
  for (std::size_t i = 0; i < 3; ++i)
    z[i] = covered[i] = region.offset[static_cast<std::size_t>(rest[i])];
  for (int attempt = 0; attempt < 2; ++attempt) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double r = std::max({-z[i].lo(), z[i].hi(), -covered[i].lo(), covered[i].hi()});
      z[i] = around(0, 1.25 * r + region.derivative[static_cast<std::size_t>(rest[i])].hi());
    }
    if (prove(s1, s2, &tube, &z)) return tube;
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_common(z[i])) return std::nullopt;
  }
  return std::nullopt;
}

namespace {

/// Krawczyk's operator at w about the middle of x: all solutions in x lie in the result, too. `local` has an
/// approximate inverse, and its excess over x.
Box4 contracted(const EnclosedSurface& s1, const EnclosedSurface& s2, const IntersectionTube& tube,
                double w, const Box4& x, const IntersectionTube& local, bool is_precise) {
  const auto rest = others(tube.pivot);
  Point4 center{};
  for (std::size_t i = 0; i < 4; ++i) center[i] = approx_middle(x[i]);
  center[static_cast<std::size_t>(tube.pivot)] = w;
  const Vector newton =
      times(local.inverse, is_precise ? precise_gap_at(s1, s2, center) : gap_at(s1, s2, center));
  Box4 out = x;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(rest[i]);
    Interval moved = Interval(center[k]) - newton[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const auto l = static_cast<std::size_t>(rest[j]);
      moved = moved + local.excess[i][j] * (x[l] - Interval(center[l]));
    }
    out[k] = intersection(x[k], moved);
  }
  VT_CHECK(!out.is_empty(), "the arc of a proved tube has vanished");
  return out;
}

constexpr int kMostSteps = 16;

bool is_narrow_in(const IntersectionTube& tube, const Box4& x) {
  for (std::size_t i = 0; i < 4; ++i)
    if (approx_radius(x[i]) > 0x1p-10 * approx_radius(tube.offset[i])) return false;
  return true;
}

/// The least quotient of the sides' widths.
double shrinkage(const Box4& now, const Box4& before) {
  double out = 1;
  for (std::size_t i = 0; i < 4; ++i)
    if (approx_radius(before[i]) > 0)
      out = std::min(out, approx_radius(now[i]) / approx_radius(before[i]));
  return out;
}

}  // namespace

Box4 locate(const EnclosedSurface& s1, const EnclosedSurface& s2, const IntersectionTube& tube,
            double w, Point4* slope) {
  Box4 x = tube.over(Interval(w));
  IntersectionTube local = tube;
  bool is_local = false, is_precise = false;
  for (int step = 0; step < kMostSteps; ++step) {
    const Box4 next = contracted(s1, s2, tube, w, x, local, is_precise);
    const double shrunk = shrinkage(next, x);
    x = next;
    if (shrunk < 0.05) continue;
    if (is_local && shrunk > 0.5) {
      if (is_precise || is_narrow_in(tube, x)) break;
      is_precise = true;  // close to tangential: rounding is large beside the tube
    }
    // The Jacobians in use are too far apart: those of this box.
    const Columns columns = columns_over(s1, s2, x);
    if (!is_bounded(columns) || !choose_inverse(columns, &local)) break;
    local.excess = linearise(local, columns).excess;
    is_local = true;
  }
  if (slope != nullptr) {
    const Columns columns = columns_over(s1, s2, x);
    if (is_bounded(columns) && choose_inverse(columns, &local)) choose_slope(columns, &local);
  }
  if (slope != nullptr) *slope = local.slope;
  return x;
}

Box4 derivative_over(const IntersectionTube& tube, const Box3& du, const Box3& dv, const Box3& ds,
                     const Box3& dt) {
  const Columns columns = columns_of(du, dv, ds, dt);
  IntersectionTube local = tube;
  if (!is_bounded(columns) || !choose_inverse(columns, &local)) return tube.derivative;
  choose_slope(columns, &local);
  const Linear linear = linearise(local, columns);
  Vector scale;  // any positive radii will do
  for (std::size_t i = 0; i < 3; ++i) scale[i] = around(0, mag(linear.drift[i]) + 0x1p-60);
  if (!set_derivative(linear, scale, &local)) return tube.derivative;
  return intersection(local.derivative, tube.derivative);
}

std::optional<IntersectionTube> shortened(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                          const IntersectionTube& tube, double w_lo, double w_hi) {
  const double w = w_lo + 0.5 * (w_hi - w_lo);
  const Box4 at = locate(s1, s2, tube, w);
  IntersectionTube out = tube;
  out.w_lo = w_lo, out.w_hi = w_hi;
  const Columns columns = columns_over(s1, s2, at);
  if (!is_bounded(columns) || !choose_inverse(columns, &out)) return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i)
    out.center[i] = static_cast<int>(i) == tube.pivot ? w : approx_middle(at[i]);
  choose_slope(columns, &out);
  const auto rest = others(tube.pivot);
  const double half = 0.5 * (w_hi - w_lo);
  Vector z;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(rest[i]);
    z[i] = around(0, 0.25 * approx_radius(tube.derivative[k]) * half + 2 * approx_radius(at[k]));
  }
  for (int attempt = 0; attempt < 4; ++attempt) {
    // Wide enough for the boxes of single points, also in parameters that are linear along the arc.
    const double part = 0.1 * half / (0.5 * (tube.w_hi - tube.w_lo));
    for (std::size_t i = 0; i < 3; ++i)
      z[i] = around(0, 1.25 * std::max(-z[i].lo(), z[i].hi()) +
                           part * approx_radius(tube.offset[static_cast<std::size_t>(rest[i])]));
    if (prove(s1, s2, &out, &z)) return out;
    for (const Interval& side : z)
      if (!is_common(side)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace veritope
