// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patch_sides.h"

#include <algorithm>
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

// The coefficient of t^n, up to a factor, is not 0: the last difference of `count` numbers.
template <typename At>
bool has_last_difference(std::size_t count, At at) {
  const int n = static_cast<int>(count) - 1;
  if (n == 1) return !(at(0) == at(1));
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

// Divides by the absolute value of the first weight that is not 0; if there is none, of the first number that is not 0.
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
  if (!patch.is_rational() && borrow(patch, side)) return;
  const Patch::Curve curve = patch.side(side);
  is_collapsed_ = veritope::is_collapsed(curve);
  if (is_collapsed_) return;
  CanonicalCurve form = canonical(curve);
  travel_ = form.travel;
  width_ = form.width;
  owned_ = std::move(form.values);
  for (const Rational& v : owned_) values_.push_back(&v);
}

// Of a polynomial side: false if its degree can be lowered.
bool SideForm::borrow(const Patch& patch, std::uint32_t side) {
  const std::size_t count = patch.side_length(side);
  values_.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < 3; ++c) values_.push_back(&patch.component(c)[patch.side_index(side, i)]);
  bool is_one_point = true, has_full_degree = false;
  for (std::size_t c = 0; c < 3 && !has_full_degree; ++c) {
    const auto at = [&](std::size_t i) -> const Rational& { return *values_[3 * i + c]; };
    for (std::size_t i = 1; i < count; ++i) is_one_point = is_one_point && at(i) == at(0);
    if (!is_one_point) has_full_degree = has_last_difference(count, at);
  }
  is_collapsed_ = is_one_point;
  if (is_one_point || !has_full_degree) {
    values_.clear();
    return is_one_point;
  }
  auto order = std::strong_ordering::equal;
  for (std::size_t i = 0; i < values_.size() && order == 0; ++i)
    order = order_of_parts(*values_[i], *values_[values_.size() - 3 - i / 3 * 3 + i % 3]);
  travel_ = order == 0 ? Travel::kBoth : order < 0 ? Travel::kForward : Travel::kBackward;
  if (order > 0) {
    std::reverse(values_.begin(), values_.end());
    for (std::size_t i = 0; i < values_.size(); i += 3) std::swap(values_[i], values_[i + 2]);
  }
  return true;
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
