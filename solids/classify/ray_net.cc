// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/ray_net_internal.h"

#include <algorithm>
#include <cmath>

#include "solids/pieces/exact_piece.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {
PlaneNormal normal_of(const Point3d& a, const Point3d& b) {
  Point3d n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  double most = 0;
  for (const double x : n) most = std::max(most, std::abs(x));
  if (!(most > 0) || !std::isfinite(most)) return {};
  for (double& x : n) x = std::nearbyint(x / most * 0x1p20);
  return n;
}

// ---- doubles

RoundedNet::RoundedNet(const TensorForm& form, NetPool& pool)
    : form_(form), pool_(pool), values_(pool.take(3 * form.count())) {}

RoundedNet::RoundedNet(const TensorForm& form, const RayPoint& point, NetPool& pool)
    : RoundedNet(form, pool) {
  const std::size_t n = count();
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = point.rounded()[k];
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double m = form.rounded[k][i], w = form.rounded[3][i];
      values_[k * n + i] = relative_to_centre(m, w, c);
      size = std::max(size, std::abs(m) + std::abs(w * c));
    }
    error_[k] = relative_bound(size);
  }
  find_ends();
}

void RoundedNet::find_ends() {
  for (std::size_t k = 0; k < 3; ++k) {
    const double* const v = component(k);
    double lo = v[0], hi = v[0];
    for (std::size_t i = 1; i < count(); ++i) {
      lo = v[i] < lo ? v[i] : lo;
      hi = v[i] > hi ? v[i] : hi;
    }
    ends_[k] = {lo, hi};
  }
}

CommonSign RoundedNet::side(const PlaneNormal& n) const {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    error += std::abs(n[k]) * error_[k];
    size += std::abs(n[k]) * RoundedNet::size(k);
  }
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (std::size_t i = 0; i < count(); ++i) {
    const double v = plane_value(n, component(0)[i], component(1)[i], component(2)[i]);
    lo = v < lo ? v : lo;
    hi = v > hi ? v : hi;
  }
  return common_sign(lo, hi, plane_bound(error, size));
}

PlaneNormal RoundedNet::normal() const {
  return mean_normal(form_, [this](std::size_t i) { return at(i); });
}

double RoundedNet::length(std::size_t axis) const {
  return approx_length(form_, axis, [this](std::size_t i) { return at(i); });
}

bool RoundedNet::is_exhausted() const {
  for (std::size_t k = 0; k < 3; ++k)
    if (size(k) > 8 * error_[k]) return false;
  return true;
}

RoundedNet RoundedNet::halve(std::size_t axis) {
  RoundedNet right(form_, pool_);
  const int degree = form_.degrees[axis];
  const std::size_t stride = form_.stride(axis), across = form_.stride(1 - axis);
  for (std::size_t k = 0; k < 3; ++k) {
    for (int line = 0; line <= form_.degrees[1 - axis]; ++line) {
      const std::size_t first = k * count() + static_cast<std::size_t>(line) * across;
      split_keeping_left(values_ + first, stride, degree, right.values_ + first, stride,
                         kHalfBlend);
    }
    error_[k] = right.error_[k] = error_after_halving(error_[k], size(k), degree);
  }
  find_ends();
  right.find_ends();
  return right;
}

RoundedNet::Curve RoundedNet::curve(std::uint32_t side, std::size_t along, bool is_reversed) const {
  Curve out;
  const std::size_t axis = axis_of_side(side), stride = form_.stride(axis),
                    first = form_.first_of_side(side);
  out.degree = form_.degrees[axis];
  const auto n = static_cast<std::size_t>(out.degree);
  const double* const p = component((along + 1) % 3);
  const double* const q = component((along + 2) % 3);
  for (std::size_t i = 0; i <= n; ++i) {
    const std::size_t from = first + (is_reversed ? n - i : i) * stride;
    out.at[0][i] = p[from];
    out.at[1][i] = q[from];
  }
  out.error = {error_[(along + 1) % 3], error_[(along + 2) % 3]};
  return out;
}

namespace {

// A curve of which the sides of two axes count: crossings of the half-line where the second coordinate is 0 and the
// first is positive.
class TurnedCurve {
 public:
  TurnedCurve(const RoundedNet::Curve& curve, const std::array<double, 2>& turn)
      : degree_(curve.degree), at_(curve.at), error_(curve.error) {
    if (turn[1] == 0 && turn[0] == 1) return;
    double size = 0;
    for (int i = 0; i <= degree_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double x = at_[0][k], y = at_[1][k];
      size = std::max({size, std::abs(x), std::abs(y)});
      const auto xy = turned(turn[0], turn[1], x, y);
      at_[0][k] = xy[0];
      at_[1][k] = xy[1];
    }
    error_[0] = error_[1] = turn_bound(std::max(error_[0], error_[1]), size, turn);
  }

  // The winding of the part between two parameters, which halvings of [begin, end] reach.
  std::optional<int> winding(std::uint64_t begin, std::uint64_t end, std::uint64_t from,
                             std::uint64_t to, int halvings) {
    if (end <= from || to <= begin) return 0;
    if (from <= begin && end <= to) {
      const CommonSign x = sign(0), y = sign(1);
      if (y == CommonSign::kPositive || y == CommonSign::kNegative || x == CommonSign::kNegative)
        return 0;
      if (x == CommonSign::kPositive) {
        const auto up_at_begin = is_up(0), up_at_end = is_up(static_cast<std::size_t>(degree_));
        if (!up_at_begin || !up_at_end) return std::nullopt;
        return int{*up_at_end} - int{*up_at_begin};
      }
      if (halvings == 0) return std::nullopt;
      --halvings;
    }
    TurnedCurve right = *this;
    halve(right);
    const std::uint64_t middle = begin + (end - begin) / 2;
    const auto a = winding(begin, middle, from, to, halvings);
    if (!a) return std::nullopt;
    const auto b = right.winding(middle, end, from, to, halvings);
    if (!b) return std::nullopt;
    return *a + *b;
  }

 private:
  CommonSign sign(std::size_t k) const {
    double lo = at_[k][0], hi = lo;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(degree_); ++i) {
      lo = std::min(lo, at_[k][i]);
      hi = std::max(hi, at_[k][i]);
    }
    return common_sign(lo, hi, error_[k]);
  }
  std::optional<bool> is_up(std::size_t i) const {
    if (is_surely_positive(at_[1][i], error_[1])) return true;
    if (is_surely_negative(at_[1][i], error_[1])) return false;
    return std::nullopt;
  }
  void halve(TurnedCurve& right) {
    for (std::size_t k = 0; k < 2; ++k) {
      double size = 0;
      for (std::size_t i = 0; i <= static_cast<std::size_t>(degree_); ++i)
        size = std::max(size, std::abs(at_[k][i]));
      error_[k] = right.error_[k] = error_after_halving(error_[k], size, degree_);
      split_keeping_left(at_[k].data(), 1, degree_, right.at_[k].data(), 1, kHalfBlend);
    }
  }

  int degree_;
  std::array<std::array<double, kMostCoefficients>, 2> at_;
  std::array<double, 2> error_;
};

constexpr int kMostHalvings = 40;

}  // namespace

std::optional<int> RoundedNet::winding(Curve curve, Parameter begin, Parameter end, Parameter from,
                                       Parameter to, const std::array<double, 2>& turn) {
  return TurnedCurve(curve, turn).winding(begin, end, from, to, kMostHalvings);
}

// ---- integers

namespace {

// a + b: the cut at 1/2, twice as large.
struct SumBlend {
  void into_first(Integer& a, const Integer& b) const { a += b; }
  void into_second(const Integer& a, Integer& b) const { b += a; }
};

// Both halves of a line of coefficients, times 2^degree. The first half stays.
void halve_line(Integer* left, Integer* right, std::size_t stride, int degree) {
  split_keeping_left(left, stride, degree, right, stride, SumBlend());
  for (int i = 0; i <= degree; ++i) {
    left[static_cast<std::size_t>(i) * stride].shift_left(static_cast<std::uint64_t>(degree - i));
    right[static_cast<std::size_t>(i) * stride].shift_left(static_cast<std::uint64_t>(i));
  }
}

template <typename Lines>
void remove_powers_of_two(Lines& lines) {
  std::uint64_t common = ~std::uint64_t{0};
  for (const auto& line : lines)
    for (const Integer& x : line)
      if (!x.is_zero()) {
        common = std::min(common, x.trailing_zeros());
        if (common == 0) return;
      }
  if (common == ~std::uint64_t{0}) return;
  for (auto& line : lines)
    for (Integer& x : line) x.shift_right(common);
}

CommonSign common_sign_of(const std::vector<Integer>& values) {
  const Sign first = values.front().sign();
  if (first == Sign::kZero) return CommonSign::kMixed;
  for (const Integer& x : values)
    if (x.sign() != first) return CommonSign::kMixed;
  return first == Sign::kPositive ? CommonSign::kPositive : CommonSign::kNegative;
}

using ExactCurve = std::array<std::vector<Integer>, 2>;

// Crossings of the half-line from below, by the signs of all coefficients: values that are 0 count as up. The curve
// misses the origin, so that halving ends.
std::optional<int> exact_winding_of(const ExactCurve& curve, int halvings) {
  const CommonSign x = common_sign_of(curve[0]);
  const auto is_negative = [](const Integer& v) { return v.sign() == Sign::kNegative; };
  const auto is_positive = [](const Integer& v) { return v.sign() == Sign::kPositive; };
  const auto below = std::count_if(curve[1].begin(), curve[1].end(), is_negative);
  if (below == 0 || below == static_cast<std::ptrdiff_t>(curve[1].size()) ||
      x == CommonSign::kNegative || std::none_of(curve[0].begin(), curve[0].end(), is_positive))
    return 0;
  if (std::none_of(curve[0].begin(), curve[0].end(), is_negative))
    return int{!is_negative(curve[1].back())} - int{!is_negative(curve[1].front())};
  if (halvings == 0) return std::nullopt;
  ExactCurve left = curve, right = curve;
  const int degree = static_cast<int>(curve[0].size()) - 1;
  for (std::size_t k = 0; k < 2; ++k) halve_line(left[k].data(), right[k].data(), 1, degree);
  remove_powers_of_two(left);
  remove_powers_of_two(right);
  const auto a = exact_winding_of(left, halvings - 1);
  if (!a) return std::nullopt;
  const auto b = exact_winding_of(right, halvings - 1);
  if (!b) return std::nullopt;
  return *a + *b;
}

constexpr int kMostExactHalvings = 1 << 14;

}  // namespace

void restrict_to(std::vector<Integer>& line, const Dyadic& begin, const Dyadic& end,
                 const Dyadic& from, const Dyadic& to) {
  std::int64_t least = 0;
  for (const Dyadic* t : {&begin, &end, &from, &to}) least = std::min(least, t->exponent());
  const auto scaled = [&](const Dyadic& t) {
    return t.mantissa() << static_cast<std::uint64_t>(t.exponent() - least);
  };
  const Integer b = scaled(begin), e = scaled(end), f = scaled(from), t = scaled(to);
  const int degree = static_cast<int>(line.size()) - 1;
  const AffineBlend<Integer> at_from{e - f, f - b}, at_to{e - t, t - b};
  std::vector<Integer> out, work;
  for (int r = 0; r <= degree; ++r) {
    work = line;
    for (int step = 0; step < degree; ++step)
      blend_forward(work.data(), 1, degree - step, step < r ? at_to : at_from);
    out.push_back(work.front());
  }
  line = std::move(out);
}

std::optional<int> ExactNet::winding(const Curve& curve, const Parameter& begin,
                                     const Parameter& end, const Parameter& from,
                                     const Parameter& to, const std::array<double, 2>&) {
  if (from == begin && to == end) return exact_winding_of(curve.at, kMostExactHalvings);
  ExactCurve part = curve.at;
  for (auto& line : part) restrict_to(line, begin, end, from, to);
  remove_powers_of_two(part);
  return exact_winding_of(part, kMostExactHalvings);
}

std::array<std::vector<Integer>, 3> relative_coefficients(const TensorForm& form,
                                                          const RayPoint& point) {
  const RayPoint::Fractions q = point.fractions();
  std::array<std::vector<Integer>, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < form.count(); ++i) {
      Integer x = form.exact[k][i] * q.denominator;
      x.subtract_product(form.exact[3][i], q.numerators[k]);
      out[k].push_back(std::move(x));
    }
  return out;
}

ExactNet::ExactNet(const TensorForm& form, const RayPoint& point)
    : form_(form), values_(relative_coefficients(form, point)) {}

CommonSign ExactNet::sign(std::size_t k) const { return common_sign_of(values_[k]); }

CommonSign ExactNet::side(const PlaneNormal& n) const {
  std::array<Integer, 3> normal;
  for (std::size_t k = 0; k < 3; ++k) normal[k] = Integer(static_cast<std::int64_t>(n[k]));
  Sign common = Sign::kZero;
  for (std::size_t i = 0; i < form_.count(); ++i) {
    Integer v = normal[0] * values_[0][i];
    v.add_product(normal[1], values_[1][i]);
    v.add_product(normal[2], values_[2][i]);
    const Sign s = v.sign();
    if (s == Sign::kZero || (i > 0 && s != common)) return CommonSign::kMixed;
    common = s;
  }
  return common == Sign::kPositive ? CommonSign::kPositive : CommonSign::kNegative;
}

const std::vector<Point3d>& ExactNet::shape() const {
  if (!shape_.empty()) return shape_;
  const std::size_t n = form_.count();
  std::array<std::vector<Integer>, 3> from_first;
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      from_first[k].push_back(values_[k][i] - values_[k][0]);
      bits = std::max(bits, from_first[k].back().bit_length());
    }
  shape_.resize(n);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (bits > 60) from_first[k][i].shift_right(bits - 60);
      shape_[i][k] = static_cast<double>(from_first[k][i].to_int64());
    }
  return shape_;
}

PlaneNormal ExactNet::normal() const {
  return mean_normal(form_, [this](std::size_t i) { return shape()[i]; });
}

double ExactNet::length(std::size_t axis) const {
  return approx_length(form_, axis, [this](std::size_t i) { return shape()[i]; });
}

ExactNet ExactNet::halve(std::size_t axis) {
  ExactNet right(form_);
  shape_.clear();
  right.values_ = values_;
  const std::size_t stride = form_.stride(axis), across = form_.stride(1 - axis);
  for (std::size_t k = 0; k < 3; ++k)
    for (int line = 0; line <= form_.degrees[1 - axis]; ++line) {
      const std::size_t first = static_cast<std::size_t>(line) * across;
      halve_line(values_[k].data() + first, right.values_[k].data() + first, stride,
                 form_.degrees[axis]);
    }
  remove_powers_of_two(values_);
  remove_powers_of_two(right.values_);
  return right;
}

ExactNet::Curve ExactNet::curve(std::uint32_t side, std::size_t along, bool is_reversed) const {
  Curve out;
  const std::size_t axis = axis_of_side(side), stride = form_.stride(axis),
                    first = form_.first_of_side(side);
  const auto n = static_cast<std::size_t>(form_.degrees[axis]);
  for (std::size_t i = 0; i <= n; ++i) {
    const std::size_t from = first + (is_reversed ? n - i : i) * stride;
    out.at[0].push_back(values_[(along + 1) % 3][from]);
    out.at[1].push_back(values_[(along + 2) % 3][from]);
  }
  return out;
}

}  // namespace veritope::internal
