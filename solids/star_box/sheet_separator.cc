// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/sheet_separator.h"

#include <array>

#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/pieces/surface_form.h"
#include "solids/star_box/node_points_internal.h"

namespace veritope {
namespace {

using Form = internal::ScaledForm<Interval>;
using Forms = std::array<Form, 4>;  // w y1, w y2, w y3, w

Forms forms_of(PieceForest& forest, PieceForest::Id id, const SheetSeparator& q) {
  const internal::NodePoints points(forest, id);
  const FormShape& shape = points.form().shape;
  const Interval per_unit(1 / q.unit);  // exact
  std::array<Interval, 3> shift;
  for (std::size_t c = 0; c < 3; ++c)
    shift[c] = Interval(points.form().origin[c]) - Interval(q.origin[c]);
  std::array<std::vector<Interval>, 4> y;
  for (std::vector<Interval>& v : y) v.reserve(points.count());
  for (std::size_t i = 0; i < points.count(); ++i) {
    const Interval w = points.weight(i);
    for (std::size_t c = 0; c < 3; ++c)
      y[c].push_back((points.value(c, i) + shift[c] * w) * per_unit);
    y[3].push_back(w);
  }
  return {Form::from_bernstein(shape, y[0].data()), Form::from_bernstein(shape, y[1].data()),
          Form::from_bernstein(shape, y[2].data()), Form::from_bernstein(shape, y[3].data())};
}

// One polynomial in y1, y2, y3 made homogeneous by w: by Horner's rule in y1, then y2, then y3.
class Composition {
 public:
  Composition(const Forms& y, const SheetSeparator& q) : y_(y), q_(q) {}

  Form run() { return below(0, q_.degree); }

 private:
  // The part that the next coefficients are of: homogeneous of degree `left` in y_[axis], ..., y_[3].
  Form below(std::size_t axis, int left) {
    if (axis == 3) return power_of_weight(left, next());
    // The coefficients come with the least power of y_[axis] first.
    std::vector<Form> parts;
    for (int a = 0; a <= left; ++a) parts.push_back(below(axis + 1, left - a));
    Form sum = parts.back();
    for (int a = left; a-- > 0;) {
      sum = sum * y_[axis];
      sum += parts[static_cast<std::size_t>(a)];
    }
    return sum;
  }
  Interval next() { return Interval(static_cast<double>(q_.coefficients[next_++])); }

  Form power_of_weight(int power, const Interval& factor) {
    const FormShape& s = y_[3].shape();
    Form out = Form::from_bernstein(FormShape{s.is_triangle, 0, 0}, &factor);
    for (int k = 0; k < power; ++k) out = out * y_[3];
    return out;
  }

  const Forms& y_;
  const SheetSeparator& q_;
  std::size_t next_ = 0;
};

}  // namespace

Sign3 separator_sign(PieceForest& forest, PieceForest::Id id, const SheetSeparator& separator) {
  VT_CHECK(separator.coefficients.size() == SheetSeparator::num_coefficients(separator.degree),
           "a separator without all its coefficients");
  const ScopedUpward upward;
  const Forms y = forms_of(forest, id, separator);
  // Each coefficient times binomials.
  const Form q = Composition(y, separator).run();
  bool is_positive = true, is_negative = true;
  q.visit([&](int a, int b, std::size_t) {
    const Sign3 s = q.at(a, b).sign();
    is_positive = is_positive && s == Sign3::kPositive;
    is_negative = is_negative && s == Sign3::kNegative;
  });
  return is_positive ? Sign3::kPositive : is_negative ? Sign3::kNegative : Sign3::kUncertain;
}

}  // namespace veritope
