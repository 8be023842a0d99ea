// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "splines/binomial.h"

namespace veritope {
namespace internal {

std::uint64_t hash_step(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}
std::uint64_t hash_step(std::uint64_t hash, const Rational& value) {
  for (const Integer* part : {&value.numerator(), &value.denominator()})
    hash = hash_step(hash_step(hash, part->low_bits()), part->bit_length());
  return hash_step(hash, static_cast<std::uint64_t>(to_int(value.sign()) + 1));
}
std::strong_ordering order_of_parts(const Rational& a, const Rational& b) {
  const auto order = a.numerator() <=> b.numerator();
  return order != 0 ? order : a.denominator() <=> b.denominator();
}

}  // namespace internal

namespace {

// Whether rounding leaves no doubt that the last difference is not 0. Bound: of the n + 3 roundings of a term none is
// above 2^-52 of the sum of the terms' sizes in any rounding mode, and n < 4096; numbers that underflow are below
// 2^-900 of it.
template <typename At>
bool surely_has_last_difference(std::size_t count, At at) {
  const int n = static_cast<int>(count) - 1;
  double sum = 0, size = 0;
  for (int i = 0; i <= n; ++i) {
    const double term =
        nearest_double(Rational(binomial(n, i))) * nearest_double(at(static_cast<std::size_t>(i)));
    sum += (n - i) % 2 == 0 ? term : -term;
    size += std::abs(term);
  }
  return size > 0x1p-100 && std::isfinite(size) && std::abs(sum) > 0x1p-40 * size;
}

// True if the coefficient of t^n, up to a factor the last difference of `count` numbers, is not 0.
template <typename At>
bool has_last_difference(std::size_t count, At at) {
  const int n = static_cast<int>(count) - 1;
  if (n == 1) return !(at(0) == at(1));
  if (n < 4096 && surely_has_last_difference(count, at)) return true;
  Rational sum;
  for (int i = 0; i <= n; ++i) {
    const Rational term = Rational(binomial(n, i)) * at(static_cast<std::size_t>(i));
    if ((n - i) % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
  }
  return sum.sign() != Sign::kZero;
}
bool has_full_degree(const Patch::Curve& curve) {
  for (int c = 0; c < curve.num_components(); ++c) {
    const auto b = curve.component(c);
    if (has_last_difference(b.size(), [&](std::size_t i) -> const Rational& { return b[i]; }))
      return true;
  }
  return false;
}

// Undoes one elevation: b_i = (i a_(i-1) + (n - i) a_i) / n. REQUIRES n >= 1 and not has_full_degree(curve).
Patch::Curve lowered(const Patch::Curve& curve) {
  const int n = curve.degree(0);
  Patch::Curve out({n - 1}, curve.num_components(), curve.is_rational());
  for (int c = 0; c < curve.num_components(); ++c) {
    const auto from = curve.component(c);
    const auto to = out.component(c);
    to[0] = from[0];
    for (std::size_t i = 1; i < to.size(); ++i) {
      const auto left = static_cast<std::int64_t>(i), right = n - left;
      to[i] = (Rational(n) * from[i] - Rational(left) * to[i - 1]) / Rational(right);
    }
  }
  return out;
}

// x, y, z (w) of each control point.
std::vector<Rational> by_points(const Patch::Curve& curve) {
  std::vector<Rational> out;
  const auto count = curve.component(0).size();
  out.reserve(count * static_cast<std::size_t>(curve.num_components()));
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < curve.num_components(); ++c) out.push_back(curve.component(c)[i]);
  return out;
}
std::vector<Rational> backwards(const std::vector<Rational>& values, std::size_t width) {
  std::vector<Rational> out;
  out.reserve(values.size());
  for (std::size_t i = values.size(); i > 0; i -= width)
    out.insert(out.end(), values.begin() + static_cast<std::ptrdiff_t>(i - width),
               values.begin() + static_cast<std::ptrdiff_t>(i));
  return out;
}

// Divides by the absolute value of the first weight that is not 0 or, if all weights are 0, of the first number that is
// not 0.
void normalise(std::vector<Rational>& values, std::size_t width) {
  const Rational* factor = nullptr;
  for (std::size_t i = 3; i < values.size() && factor == nullptr; i += width)
    if (values[i].sign() != Sign::kZero) factor = &values[i];
  for (std::size_t i = 0; i < values.size() && factor == nullptr; ++i)
    if (values[i].sign() != Sign::kZero) factor = &values[i];
  if (factor == nullptr) return;
  const Rational by = abs(*factor);
  if (by == Rational(1)) return;
  for (Rational& v : values) v /= by;
}

bool all_weights_are_one(const std::vector<Rational>& values) {
  for (std::size_t i = 3; i < values.size(); i += 4)
    if (!(values[i] == Rational(1))) return false;
  return true;
}
void drop_weights(std::vector<Rational>& values) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % 4 != 3) std::swap(values[to++], values[i]);
  values.resize(to);
}

}  // namespace

Patch::Curve internal::with_least_degree(Patch::Curve curve) {
  while (curve.degree(0) > 0 && !has_full_degree(curve)) curve = lowered(curve);
  return curve;
}

std::strong_ordering operator<=>(const CanonicalCurve& a, const CanonicalCurve& b) {
  if (a.width != b.width) return a.width <=> b.width;
  if (a.values.size() != b.values.size()) return a.values.size() <=> b.values.size();
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (const auto order = internal::order_of_parts(a.values[i], b.values[i]); order != 0)
      return order;
  return std::strong_ordering::equal;
}

CanonicalCurve directed_form(const Patch::Curve& curve) {
  CanonicalCurve out{curve.is_rational() ? std::size_t{4} : std::size_t{3}, {}, {}};
  out.values = by_points(internal::with_least_degree(curve));
  if (!curve.is_rational()) return out;
  normalise(out.values, 4);
  if (all_weights_are_one(out.values)) {
    drop_weights(out.values);
    out.width = 3;
  }
  return out;
}
CanonicalCurve run_backwards(const CanonicalCurve& directed) {
  CanonicalCurve out{directed.width, backwards(directed.values, directed.width), Travel::kForward};
  if (out.width == 4) normalise(out.values, 4);
  return out;
}

CanonicalCurve canonical(const Patch::Curve& curve) {
  CanonicalCurve forward = directed_form(curve), backward = run_backwards(forward);
  const auto order = forward <=> backward;
  forward.travel = order == 0 ? Travel::kBoth : Travel::kForward;
  backward.travel = Travel::kBackward;
  return order > 0 ? backward : forward;
}

bool is_collapsed(const Patch::Curve& curve) {
  const auto count = curve.component(0).size();
  if (curve.is_rational())
    for (const Rational& w : curve.component(3))
      if (w.sign() == Sign::kZero) return false;
  for (int c = 0; c < 3; ++c) {
    const auto b = curve.component(c);
    for (std::size_t i = 1; i < count; ++i) {
      if (!curve.is_rational()) {
        if (!(b[i] == b[0])) return false;
      } else if (!(b[i] * curve.component(3)[0] == b[0] * curve.component(3)[i])) {
        return false;
      }
    }
  }
  return true;
}

namespace internal {

SideForm::SideForm(const Patch& patch, std::uint32_t side) {
  point_at(patch, side);
  is_collapsed_ = is_one_point();
  if (is_collapsed_ || make_in_place()) return;
  CanonicalCurve form = canonical(patch.side(side));
  travel_ = form.travel;
  width_ = form.width;
  owned_ = std::move(form.values);
  values_.clear();
  for (const Rational& v : owned_) values_.push_back(&v);
}

void SideForm::point_at(const Patch& patch, std::uint32_t side) {
  width_ = patch.is_rational() ? 4 : 3;
  const std::size_t count = patch.side_length(side);
  values_.reserve(width_ * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < width_; ++c)
      values_.push_back(&patch.component(static_cast<int>(c))[patch.side_index(side, i)]);
}

bool SideForm::is_one_point() const {
  if (width_ == 4)
    for (std::size_t i = 0; i < num_points(); ++i)
      if (at(i, 3).sign() == Sign::kZero) return false;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 1; i < num_points(); ++i)
      if (width_ == 3 ? !(at(i, c) == at(0, c)) : !(at(i, c) * at(0, 3) == at(0, c) * at(i, 3)))
        return false;
  return true;
}

// Does what canonical does, for all but rare cases. Returns false, and does nothing, if the degree can be lowered,
// weights are equal or 0, or the ends are one point.
bool SideForm::make_in_place() {
  const std::size_t last = num_points() - 1;
  bool has_full_degree = false;
  for (std::size_t c = 0; c < width_ && !has_full_degree; ++c)
    has_full_degree = has_last_difference(
        num_points(), [&](std::size_t i) -> const Rational& { return at(i, c); });
  if (!has_full_degree) return false;
  Rational first_weight(1), last_weight(1);
  if (width_ == 4) {
    bool differ = false;
    for (std::size_t i = 0; i <= last; ++i) differ = differ || !(at(i, 3) == at(0, 3));
    first_weight = abs(at(0, 3)), last_weight = abs(at(last, 3));
    if (!differ || first_weight.sign() == Sign::kZero || last_weight.sign() == Sign::kZero)
      return false;
  }
  const bool is_plain = first_weight == Rational(1) && last_weight == Rational(1);
  auto order = std::strong_ordering::equal;
  for (std::size_t c = 0; c < 3 && order == 0; ++c)
    order = is_plain ? order_of_parts(at(0, c), at(last, c))
                     : order_of_parts(at(0, c) / first_weight, at(last, c) / last_weight);
  if (order == 0) return false;
  travel_ = order < 0 ? Travel::kForward : Travel::kBackward;
  if (order > 0) {
    std::reverse(values_.begin(), values_.end());
    for (std::size_t i = 0; i < values_.size(); i += width_)
      std::reverse(values_.begin() + static_cast<std::ptrdiff_t>(i),
                   values_.begin() + static_cast<std::ptrdiff_t>(i + width_));
  }
  divide(order < 0 ? first_weight : last_weight);
  return true;
}

void SideForm::divide(const Rational& by) {
  if (by == Rational(1)) return;
  owned_.reserve(values_.size());
  for (const Rational*& v : values_) {
    owned_.push_back(*v / by);
    v = &owned_.back();
  }
}

std::uint64_t SideForm::hash() const {
  std::uint64_t hash = hash_step(width_, values_.size());
  for (const Rational* v : values_) hash = hash_step(hash, *v);
  return hash;
}

std::strong_ordering operator<=>(const SideForm& a, const SideForm& b) {
  if (a.width_ != b.width_) return a.width_ <=> b.width_;
  if (a.values_.size() != b.values_.size()) return a.values_.size() <=> b.values_.size();
  for (std::size_t i = 0; i < a.values_.size(); ++i)
    if (const auto order = order_of_parts(*a.values_[i], *b.values_[i]); order != 0) return order;
  return std::strong_ordering::equal;
}

}  // namespace internal

std::uint64_t hash_of(const CanonicalCurve& curve) {
  std::uint64_t hash = internal::hash_step(curve.width, curve.values.size());
  for (const Rational& v : curve.values) hash = internal::hash_step(hash, v);
  return hash;
}

}  // namespace veritope
