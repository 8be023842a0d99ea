// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_tables.cc: rounded pieces and their bounds, docs/bounds/fast_spline.md.
#include <cmath>

#include "splines/fast_spline.h"
#include "splines/fast_spline_tables_internal.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

Rational exactly(double x) { return Rational::from_double(x); }
Rational larger(const Rational& a, const Rational& b) { return a < b ? b : a; }

// (1 + u)^k - 1 <= k u / (1 - k u), of few digits.
Rational rounding_error(int roundings) {
  const Rational ku = Rational(roundings) * Rational::power_of_two(-53);
  return exactly(round_up(ku / (Rational(1) - ku)));
}

// Sizes and errors of one component of one piece.
struct Component {
  Rational conversion;               // max |exact - rounded|
  Rational size;                     // max |rounded|
  std::vector<Rational> difference;  // for each axis: max |difference of exact neighbours|
};

template <std::size_t N>
Component measure(const Bezier<Rational, N>& piece, int c, std::vector<double>& rounded) {
  Component out;
  rounded.clear();
  double size = 0;
  for (const Rational& exact : piece.component(c)) {
    rounded.push_back(nearest_double(exact));
    size = std::max(size, std::abs(rounded.back()));
    out.conversion = larger(out.conversion, abs(exact - exactly(rounded.back())));
  }
  out.conversion = exactly(round_up(out.conversion));
  out.size = exactly(size);
  const Grid<N> grid = piece.grid();
  for (std::size_t a = 0; a < N; ++a) {
    const std::size_t stride = grid.stride(a);
    double most = 0;
    grid.for_each_line(a, [&](std::size_t first) {
      for (std::size_t i = 1; i < grid.size[a]; ++i)
        most = std::max(most,
                        std::abs(rounded[first + i * stride] - rounded[first + (i - 1) * stride]));
    });
    // The difference is rounded once, in any mode; the factor pays for that. A difference does not underflow.
    out.difference.push_back(exactly(round_up(exactly(most) * exactly(0x1.0000000000002p0))) +
                             Rational(2) * out.conversion);
  }
  return out;
}

template <std::size_t N>
class BoundMaker {
 public:
  explicit BoundMaker(const std::array<FastAxisStorage, N>& axes) : axes_(axes) {
    for (std::size_t a = 0; a < N; ++a) degrees_[a] = axes[a].degree;
    value_ = rounding_error(fast_value_roundings(degrees_));
    for (std::size_t a = 0; a < N; ++a)
      partial_[a] = rounding_error(fast_partial_roundings(degrees_, a));
  }
  // docs/bounds/fast_spline.md, 4.
  double value(const Component& c, const std::array<std::size_t, N>& cell) const {
    Rational sum = value_ * c.size + c.conversion + underflow(c);
    for (std::size_t a = 0; a < N; ++a)
      sum += axes_[a].error[cell[a]] * Rational(degrees_[a]) * c.difference[a];
    return round_up(sum);
  }
  // docs/bounds/fast_spline.md, 5.
  double partial(const Component& c, std::size_t axis,
                 const std::array<std::size_t, N>& cell) const {
    const Rational u = Rational::power_of_two(-53), &g = c.difference[axis];
    Rational sum =
        partial_[axis] * Rational(2) * c.size + Rational(2) * c.conversion + underflow(c);
    for (std::size_t b = 0; b < N; ++b) {
      const Rational second =
          b == axis ? Rational(2 * (degrees_[b] - 1)) * g
                    : Rational(2 * degrees_[b]) * (g < c.difference[b] ? g : c.difference[b]);
      sum += axes_[b].error[cell[b]] * second;
    }
    const Rational scale = exactly(axes_[axis].slope_scale[cell[axis]]);
    return round_up(scale * (Rational(1) + u) * sum +
                    g * (exactly(axes_[axis].scale_error[cell[axis]]) + u * scale) +
                    Rational::power_of_two(-1073));
  }

 private:
  static Rational underflow(const Component& c) {
    return Rational::power_of_two(-1040) * (Rational(1) + c.size);
  }
  const std::array<FastAxisStorage, N>& axes_;
  std::array<int, N> degrees_{};
  Rational value_;
  std::array<Rational, N> partial_;
};

Error over_limit(const std::string& what) { return Error{Code::kOverLimit, {}, what}; }

// The map with all components scaled by a power of two, so that the largest weight is in (1/4, 1).
template <std::size_t N>
Result<BSpline<Rational, N>> with_limits(BSpline<Rational, N> map) {
  const Rational limit = exactly(kFastLimit);
  std::size_t pieces = 1, each = static_cast<std::size_t>(map.num_components() + 3) / 4;
  for (const auto& axis : map.axes()) {
    pieces *= axis.num_control() - static_cast<std::size_t>(axis.degree);
    each *= static_cast<std::size_t>(axis.degree) + 1;
    if (pieces > kFastMaxCoefficients || each > kFastMaxCoefficients / pieces)
      return over_limit("the spline has more than 2^26 coefficients in its pieces");
  }
  if (map.is_rational()) {
    const auto weights = map.component(map.num_components() - 1);
    Rational most = weights[0], least = most;
    for (const Rational& w : weights) {
      if (w.sign() != Sign::kPositive)
        return Error{Code::kBadArgument, {}, "weight " + w.to_string() + " is not positive"};
      most = larger(most, w), least = w < least ? w : least;
    }
    if (least < most * exactly(kFastWeightRatio))
      return over_limit("weights from " + least.to_string() + " to " + most.to_string() +
                        " differ by more than 2^40: too much for fast evaluation");
    // 2^(bits - 1) <= |integer| < 2^bits.
    const auto exponent = static_cast<std::int64_t>(most.numerator().bit_length()) -
                          static_cast<std::int64_t>(most.denominator().bit_length()) + 1;
    const Rational scale = Rational::power_of_two(-exponent);
    for (Rational& v : map.coefficients()) v *= scale;
  }
  for (const Rational& v : map.coefficients())
    if (abs(v) > limit)
      return over_limit("coefficient " + v.to_string() +
                        " is beyond 2^200: too large for fast evaluation");
  return map;
}

template <std::size_t N>
Status add_piece(const Bezier<Rational, N>& piece, const BoundMaker<N>& bound,
                 const std::array<std::size_t, N>& cell, FastStorage<N>& out) {
  const auto components = static_cast<std::size_t>(out.num_components);
  const std::size_t blocks = (components + 3) / 4, from = out.coefficients.size();
  out.coefficients.resize(from + blocks * out.num_coefficients);
  std::vector<double> rounded;
  std::vector<Component> measured;
  for (std::size_t c = 0; c < components; ++c) {
    measured.push_back(measure(piece, static_cast<int>(c), rounded));
    FastLane* const to = out.coefficients.data() + from + (c / 4) * out.num_coefficients;
    for (std::size_t i = 0; i < rounded.size(); ++i) to[i].v[c % 4] = rounded[i];
  }
  for (std::size_t k = 0; k <= N; ++k)
    for (const Component& c : measured)
      out.bounds.push_back(k == 0 ? bound.value(c, cell) : bound.partial(c, k - 1, cell));
  if (!out.is_rational) return ok_status();
  Rational least = piece.component(out.num_components - 1)[0];
  for (const Rational& w : piece.component(out.num_components - 1)) least = w < least ? w : least;
  const double error = bound.value(measured.back(), cell);
  if (exactly(error) > least)
    return over_limit(
        "a span holds so few binary64 numbers that its weights are not known: too short for fast "
        "evaluation");
  out.inverse_weight.push_back(round_up(Rational(1) / least));
  return ok_status();
}

}  // namespace

template <std::size_t N>
Result<FastStorage<N>> make_fast_storage(const BSpline<Rational, N>& map) {
  auto limited = with_limits(map);
  if (!limited) return limited.error();
  const BezierPieces<Rational, N> pieces = bezier_pieces(std::move(*limited));
  FastStorage<N> out;
  out.num_components = map.num_components(), out.is_rational = map.is_rational();
  for (std::size_t a = 0; a < N; ++a) {
    auto axis = make_fast_axis(map.axis(a).degree, pieces.breaks[a]);
    if (!axis) return axis.error();
    out.axes[a] = std::move(*axis);
  }
  out.num_coefficients = pieces.pieces.front().grid().count();
  const BoundMaker<N> bound(out.axes);
  const Grid<N> cells = pieces.grid();
  for (std::size_t number = 0; number < pieces.pieces.size(); ++number) {
    std::array<std::size_t, N> cell;
    std::size_t rest = number;
    for (std::size_t a = N; a-- > 0; rest /= cells.size[a]) cell[a] = rest % cells.size[a];
    if (const Status s = add_piece(pieces.pieces[number], bound, cell, out); !s) return s.error();
  }
  return out;
}

template <std::size_t N>
Result<BSpline<Rational, N>> exact_bspline(const BSpline<double, N>& map) {
  std::array<KnotAxis<Rational>, N> axes;
  const auto not_finite = [](const char* what, std::size_t i) {
    return Error{
        Code::kNotFinite, {}, std::string(what) + " " + std::to_string(i) + " is not finite"};
  };
  for (std::size_t a = 0; a < N; ++a) {
    std::vector<Rational> knots;
    for (const double k : map.axis(a).knots) {
      if (!std::isfinite(k)) return not_finite("knot", knots.size());
      knots.push_back(exactly(k));
    }
    auto axis = make_knot_axis(map.axis(a).degree, std::move(knots));
    if (!axis) return axis.error();
    axes[a] = std::move(*axis);
  }
  std::vector<Rational> coefficients;
  for (const double v : map.coefficients()) {
    if (!std::isfinite(v)) return not_finite("coefficient", coefficients.size());
    coefficients.push_back(exactly(v));
  }
  return BSpline<Rational, N>(std::move(axes), map.num_components(), map.is_rational(),
                              std::move(coefficients));
}

template <std::size_t N>
FastSplineTables FastStorage<N>::tables() const {
  FastSplineTables t{};
  for (std::size_t a = 0; a < N; ++a) {
    const FastAxisStorage& axis = axes[a];
    t.axis[a] = {axis.breaks.data(),      axis.origin.data(), axis.rate.data(),
                 axis.slope_scale.data(), axis.first.data(),  axis.per_bucket,
                 axis.breaks.size() - 1,  axis.buckets,       axis.degree};
  }
  t.coefficients = coefficients.data()->v;
  t.bounds = bounds.data();
  t.inverse_weight = is_rational ? inverse_weight.data() : nullptr;
  t.num_coefficients = num_coefficients, t.num_components = num_components;
  return t;
}

template struct FastStorage<1>;
template struct FastStorage<2>;
template struct FastStorage<3>;
template Result<FastStorage<1>> make_fast_storage(const BSpline<Rational, 1>&);
template Result<FastStorage<2>> make_fast_storage(const BSpline<Rational, 2>&);
template Result<FastStorage<3>> make_fast_storage(const BSpline<Rational, 3>&);
template Result<BSpline<Rational, 1>> exact_bspline(const BSpline<double, 1>&);
template Result<BSpline<Rational, 2>> exact_bspline(const BSpline<double, 2>&);
template Result<BSpline<Rational, 3>> exact_bspline(const BSpline<double, 3>&);

}  // namespace veritope::internal
