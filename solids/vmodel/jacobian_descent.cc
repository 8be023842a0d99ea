// SPDX-License-Identifier: LGPL-3.0-or-later
// Steps downhill on rounded coefficients of N, where halving a piece has come near a place at which
// N is hardly negative.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "robust/base/fp_guard.h"
#include "solids/vmodel/jacobian_tree_internal.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

using DescentPoint = std::array<double, 3>;
using DescentNet = Bezier<double, 3>;

constexpr int kMostDescentSteps = 60;
constexpr double kDescentUnit = 0x1p-32;  // of the point that is returned

// N and its first and second derivatives.
class DescentLandscape {
 public:
  explicit DescentLandscape(DescentNet values) : values_(std::move(values)) {
    for (std::size_t a = 0; a < 3; ++a) slopes_.push_back(derivative(values_, a));
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b <= a; ++b) bends_.push_back(derivative(slopes_[a], b));
  }
  double height(const DescentPoint& at) const { return evaluate(values_, at)[0]; }

  // The step to the lowest point of the quadratic model whose second derivatives are raised by `damping`; nothing if
  // that model has no lowest point.
  std::optional<DescentPoint> step(const DescentPoint& at, double damping) const {
    double m[3][4];
    for (std::size_t a = 0, n = 0; a < 3; ++a) {
      for (std::size_t b = 0; b <= a; ++b, ++n) m[a][b] = m[b][a] = evaluate(bends_[n], at)[0];
      m[a][a] += damping;
      m[a][3] = -evaluate(slopes_[a], at)[0];
    }
    for (std::size_t k = 0; k < 3; ++k) {  // a positive definite matrix has positive pivots
      if (!(m[k][k] > 0)) return std::nullopt;
      for (std::size_t i = k + 1; i < 3; ++i) {
        const double factor = m[i][k] / m[k][k];
        for (std::size_t j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
      }
    }
    DescentPoint out;
    for (std::size_t k = 3; k-- > 0;) {
      out[k] = m[k][3];
      for (std::size_t j = k + 1; j < 3; ++j) out[k] -= m[k][j] * out[j];
      out[k] /= m[k][k];
    }
    return out;
  }

 private:
  DescentNet values_;
  std::vector<DescentNet> slopes_, bends_;
};

}  // namespace

std::optional<std::array<Rational, 3>> low_point(const RoundedJacobian& net, int sign,
                                                 const DyadicBox& near) {
  const ScopedDefaultFp nearest;
  double greatest = 0;
  for (const double x : net.values) greatest = std::max(greatest, std::abs(x));
  if (!(greatest > 0 && greatest < 0x1p1000)) return std::nullopt;
  std::array<int, 3> degrees;
  for (std::size_t a = 0; a < 3; ++a) degrees[a] = static_cast<int>(net.grid.size[a]) - 1;
  std::vector<double> values = net.values;
  for (double& x : values) x *= sign / greatest;
  const DescentLandscape landscape(DescentNet(degrees, 1, false, std::move(values)));
  DescentPoint at;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto ends = near.along(a);
    at[a] = nearest_double((ends[0] + ends[1]) / Rational(2));
  }
  double height = landscape.height(at), damping = 0x1p-20;
  for (int n = 0; n < kMostDescentSteps && damping < 0x1p60; ++n) {
    DescentPoint next = at;
    const auto step = landscape.step(at, damping);
    for (std::size_t a = 0; step && a < 3; ++a)
      next[a] = std::clamp(at[a] + (*step)[a], kDescentUnit, 1 - kDescentUnit);
    const double there = landscape.height(next);
    if (step && there < height) {
      at = next, height = there;
      damping *= 0x1p-4;
    } else {
      damping *= 0x1p4;
    }
  }
  std::array<Rational, 3> out;
  for (std::size_t a = 0; a < 3; ++a)
    out[a] = Rational::from_double(std::nearbyint(at[a] / kDescentUnit) * kDescentUnit);
  return out;
}

}  // namespace veritope::internal
