// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/patch_volume.h"

#include <algorithm>
#include <cmath>

#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Form = internal::ScaledForm<Interval>;

constexpr int kOrder = 5;  // of the polynomial for 1 / w^3
constexpr int kMaxLevel = 8;

// Each coefficient within `error` of its number.
std::vector<Interval> enclosures(const double* net, std::size_t n, double error) {
  std::vector<Interval> out;
  const Interval around = Interval::from_bounds(-error, error);
  for (std::size_t i = 0; i < n; ++i) out.push_back(Interval(net[i]) + around);
  return out;
}

Interval mean(const std::vector<Interval>& coefficients) {
  Interval sum;
  for (const Interval& c : coefficients) sum += c;
  return sum / Interval(static_cast<double>(coefficients.size()));
}

class Integrator {
 public:
  Integrator(PieceForest& forest, double tolerance) : forest_(forest), tolerance_(tolerance) {}

  // Of n·S du dv over a whole patch.
  Interval over_patch(std::uint32_t patch) {
    const PieceForest::Form& form = forest_.form(patch);
    Interval sum;
    for (Id r = 0; r < form.num_roots; ++r) sum += over(form.first_root + r);
    // The means are over domains of area 1, that of a triangle is 1/2.
    return form.shape.is_triangle ? sum * Interval(0.5) : sum;
  }

 private:
  // The integral in units of the patch's whole domain.
  Interval over(Id id) {
    const PieceForest::Node node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    const int halvings = form.root_bits[0] + form.root_bits[1] + 2 * node.level;
    const Interval area(std::ldexp(1.0, -halvings));
    const std::vector<Interval> g = height_form(id);
    if (!form.is_rational) return area * mean(g);
    const Interval part = area * over_cubed_weight(form, g, id);
    if (wid(part) <= tolerance_ * area.hi() || node.level >= kMaxLevel) return part;
    const Id first = forest_.children(id);
    Interval sum;
    for (Id k = 0; k < 4; ++k) sum += over(first + k);
    return sum;
  }

  // w^3 n·S on the node, with the patch's own derivatives: the determinants at c = 0, which lies at -origin.
  std::vector<Interval> height_form(Id id) {
    const PieceForest::Node& node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    const std::size_t n = form.determinant.count();
    const double* const net = forest_.approx_determinants(id);
    std::vector<Interval> sum = enclosures(net, n, forest_.determinant_error(id, 0));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<Interval> g =
          enclosures(net + (k + 1) * n, n, forest_.determinant_error(id, k + 1));
      const Interval c(-form.origin[k]);
      for (std::size_t i = 0; i < n; ++i) sum[i] += c * g[i];
    }
    return sum;
  }

  // The mean of g / w^3. With x = w / m - 1, |x| <= d < 1: (1 + x)^-3 = sum C(k + 2, 2) (-x)^k, and the terms behind order K add up to at most
  // C(K + 3, 2) d^(K + 1) / (1 - d)^3, since C(K + 3 + j, 2) <= C(K + 3, 2) C(j + 2, 2).
  Interval over_cubed_weight(const PieceForest::Form& form, const std::vector<Interval>& g, Id id) {
    const std::size_t n = form.shape.count();
    std::vector<Interval> w =
        enclosures(forest_.control(id) + 3 * n, n, forest_.control_error(id, 3));
    Interval range = w[0];
    for (const Interval& v : w) range = hull(range, v);
    if (!(range.lo() > 0)) return Interval::entire();
    const Interval middle(mid(range));
    Interval distance;
    for (Interval& v : w) {
      v = v / middle - Interval(1.0);
      distance = hull(distance, v);
    }
    const Interval d(mag(distance)), one(1.0);
    if (!(d.hi() < 0.5)) return Interval::entire();
    const Form x = Form::from_bernstein(form.shape, w.data());
    Form product = Form::from_bernstein(form.determinant, g.data());
    Interval sum = mean(product.to_bernstein());
    Interval most;
    for (const Interval& v : g) most = hull(most, Interval(mag(v)));
    for (int k = 1; k <= kOrder; ++k) {
      product = product * x;
      const Interval c((k + 2) * (k + 1) / 2.0);
      const Interval term = c * mean(product.to_bernstein());
      sum = k % 2 == 0 ? sum + term : sum - term;
    }
    Interval rest((kOrder + 3) * (kOrder + 2) / 2.0);
    for (int k = 0; k <= kOrder; ++k) rest = rest * d;
    rest = rest / ((one - d) * (one - d) * (one - d)) * Interval(most.hi());
    sum += Interval::from_bounds(-rest.hi(), rest.hi());
    return sum / (middle * middle * middle);
  }

  PieceForest& forest_;
  double tolerance_;
};

}  // namespace

std::vector<Interval> shell_volumes(PieceForest& forest, double tolerance) {
  const ScopedUpward upward;
  const PatchComplex& complex = forest.complex();
  // Coordinates are about 1: n·S du dv over all patches is about 1, too.
  Integrator integrator(forest, tolerance / static_cast<double>(forest.num_patches()));
  std::vector<Interval> out(complex.shells().size());
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p)
    out[complex.shell(p)] += integrator.over_patch(p);
  const auto& scales = forest.frame().scale;
  const int scale = -(scales[0] + scales[1] + scales[2]);
  for (Interval& v : out) {
    v = v / Interval(3.0);
    for (int left = scale; left != 0;) {  // in steps that are powers of two in range
      const int step = std::clamp(left, -512, 512);
      v = v * Interval(std::ldexp(1.0, step));
      left -= step;
    }
  }
  return out;
}

}  // namespace veritope
