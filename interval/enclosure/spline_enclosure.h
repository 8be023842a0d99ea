// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/spline_enclosure.h: boxes around the values and derivatives of a spline over a box of parameters.
// Proofs: docs/THEORY.md, ENCLOSE-1. Design, orders of convergence: docs/design/0011-enclosures.md.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// How an enclosure is made. All contain what they enclose; the last is the intersection of the others.
/// Excess over the exact range, for exact nets and boxes of width d inside of one cell:
///   hull       value O(d^2), derivatives of polynomial maps O(d^2), of rational maps O(d); normal and curvatures O(d)
///   mean value O(d^2) where the slopes are bounded; entire where they are not (umbilics: principal curvatures)
enum class EnclosureForm { kHull, kMeanValue, kBoth };

namespace internal {
template <std::size_t N>
struct EnclosureData;
}

/// A spline cut into Bezier pieces, with the pieces of its derivatives up to an order, found exactly and rounded
/// outward. For rational maps these are derivatives of points, not of homogeneous coordinates. With control boxes
/// (BSpline<Interval, N>) the enclosures contain the values of every spline whose points lie in the boxes.
/// The enclosure over a box across knots is the hull over its cells; at a break it contains the one-sided derivatives
/// of both sides. Functions set the rounding mode themselves. Copies share their data.
template <std::size_t N>
class SplineEnclosure {
 public:
  static constexpr int kMaxOrder = 3;
  /// max_order: the highest order that will be requested; the mean-value form needs one more than its quantity.
  /// @error kBadArgument for an order outside [0, 3], or a weight that is not positive.
  static Result<SplineEnclosure> prepare(const BSpline<Rational, N>& map, int max_order);
  static Result<SplineEnclosure> prepare(const BSpline<Interval, N>& map, int max_order);

  int dimension() const;
  int max_order() const;
  /// The largest box of binary64 numbers in the domain.
  Box<N> domain() const;

  /// Encloses the values, one interval for each coordinate.
  /// @error kBadArgument for a box that is empty or leaves the domain, or an order that was not prepared for.
  Result<std::vector<Interval>> value(const Box<N>& at,
                                      EnclosureForm form = EnclosureForm::kBoth) const {
    return derivative({}, at, form);
  }
  /// order[a]: how many times to differentiate by parameter a.
  Result<std::vector<Interval>> derivative(const std::array<int, N>& order, const Box<N>& at,
                                           EnclosureForm form = EnclosureForm::kBoth) const;

  const internal::EnclosureData<N>& data() const { return *data_; }

 private:
  explicit SplineEnclosure(std::shared_ptr<const internal::EnclosureData<N>> data)
      : data_(std::move(data)) {}
  std::shared_ptr<const internal::EnclosureData<N>> data_;
};

extern template class SplineEnclosure<1>;
extern template class SplineEnclosure<2>;
extern template class SplineEnclosure<3>;

}  // namespace veritope
