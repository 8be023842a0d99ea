// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_restriction.h"

#include <utility>

#include "splines/composition_integer.h"
#include "splines/dms_spline.h"

namespace veritope {

DmsRestriction::DmsRestriction(int degree, const std::array<DmsPoint, 4>& corners,
                               std::span<const std::vector<Rational>> components)
    : degree_(degree), origin_(corners[0]) {
  // The affine map that takes the corners to (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1).
  std::array<DmsPoint, 4> unit;
  for (std::size_t m = 1; m < 4; ++m) unit[m][m - 1] = Rational(1);
  to_unit_ = linear_part(corners, unit);
  for (const std::vector<Rational>& c : components) {
    internal::ClearedNumbers numbers = internal::cleared(c);
    components_.push_back({std::move(numbers.numerators), std::move(numbers.denominator)});
  }
}

const DmsRestriction::Weights& DmsRestriction::weights(const DmsPoint& point) {
  const auto [at, is_new] = weights_.try_emplace(point);
  if (!is_new) return at->second;
  const DmsPoint d = difference(point, origin_);
  std::array<Rational, 4> share{Rational(1)};
  for (std::size_t m = 1; m < 4; ++m) {
    for (std::size_t c = 0; c < 3; ++c) share[m] += to_unit_[3 * (m - 1) + c] * d[c];
    share[0] -= share[m];
  }
  internal::ClearedNumbers numbers = internal::cleared(share);
  for (std::size_t m = 0; m < 4; ++m)
    at->second.numerators[m] = std::move(numbers.numerators[m]);
  at->second.denominator = std::move(numbers.denominator);
  return at->second;
}

// `net` has the blossom at the corners that `index` counts; further ones follow in ascending order.
void DmsRestriction::blossom(const Polynomial& net, TetrahedralIndex index, std::size_t first,
                             const Corners& corners, std::vector<double>& out) const {
  const int left = degree_ - (index[0] + index[1] + index[2] + index[3]);
  if (left == 0) {
    out[tetrahedral_index(index)] = nearest_quotient(net.numerators[0], net.denominator);
    return;
  }
  for (std::size_t m = first; m < 4; ++m) {
    const Weights& w = *corners[m];
    Polynomial lower{{}, net.denominator * w.denominator};
    for_each_tetrahedral_index(left - 1, [&](const TetrahedralIndex& gamma) {
      Integer& sum = lower.numerators.emplace_back();
      for (std::size_t k = 0; k < 4; ++k)
        sum.add_product(net.numerators[tetrahedral_index(raised(gamma, k))], w.numerators[k]);
    });
    blossom(lower, raised(index, m), m, corners, out);
  }
}

std::vector<std::vector<double>> DmsRestriction::on(const std::array<DmsPoint, 4>& corners) {
  Corners at{};
  for (std::size_t m = 0; m < 4; ++m) at[m] = &weights(corners[m]);
  std::vector<std::vector<double>> out;
  for (const Polynomial& p : components_)
    blossom(p, {}, 0, at, out.emplace_back(p.numerators.size()));
  return out;
}

}  // namespace veritope
