// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/patch_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/pieces/find_pieces.h"
#include "solids/pieces/volume_remainder_internal.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Form = internal::ScaledForm<Interval>;

constexpr int kMostOrder = 9;  // of the polynomial for 1 / w^3
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
  // REQUIRES upward rounding.
  Integrator(PieceForest& forest, const Point3d& centre, double tolerance)
      : forest_(forest), centre_(centre), tolerance_(tolerance) {
    for (int order = 0; order <= kMostOrder; ++order) nodes_.emplace_back(order);
  }

  // The integral of n·(S - centre) du dv over a whole patch.
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
    const Weight w = weight_of(form, id);
    const double most = magnitude(g);
    const double enough = std::max(tolerance_, rounding(w, most));
    int order = 1;
    while (order < kMostOrder && !(2 * rest(w, most, order) <= enough)) ++order;
    const bool is_near = 2 * rest(w, most, order) <= enough;
    // If the order suffices for a node, rounding does not add less on parts of the node.
    if (is_near || node.level >= kMaxLevel || !forest_.may_split(id))
      return area * over_cubed_weight(form, g, w, order, rest(w, most, order));
    forest_.limit_memory(PieceForest::kNetMemory);
    const Id first = forest_.children(id);
    Interval sum;
    for (Id k = 0; k < 4; ++k) sum += over(first + k);
    return sum;
  }

  // w^3 n·(S - centre) on the node, with the patch's own derivatives.
  std::vector<Interval> height_form(Id id) {
    const PieceForest::Node& node = forest_.node(id);
    const PieceForest::Form& form = forest_.form(node.patch);
    const std::size_t n = form.determinant.count();
    const double* const net = forest_.approx_determinants(id);
    std::vector<Interval> sum = enclosures(net, n, forest_.determinant_error(id, 0));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<Interval> g =
          enclosures(net + (k + 1) * n, n, forest_.determinant_error(id, k + 1));
      const Interval c = Interval(centre_[k]) - Interval(form.origin[k]);
      for (std::size_t i = 0; i < n; ++i) sum[i] += c * g[i];
    }
    return sum;
  }

  // w = m (1 + x), |x| <= d; d = 1 if the weight may be 0.
  struct Weight {
    std::vector<Interval> x;
    Interval m{1.0};
    double d = 1;
  };
  Weight weight_of(const PieceForest::Form& form, Id id) {
    const std::size_t n = form.shape.count();
    Weight out;
    out.x = enclosures(forest_.control(id) + 3 * n, n, forest_.control_error(id, 3));
    Interval range = out.x[0];
    for (const Interval& v : out.x) range = hull(range, v);
    if (!(range.lo() > 0)) return out;
    out.m = Interval(mid(range));
    Interval distance;
    for (Interval& v : out.x) {
      v = v / out.m - Interval(1.0);
      distance = hull(distance, v);
    }
    out.d = std::min(1.0, mag(distance));
    return out;
  }
  static double magnitude(const std::vector<Interval>& g) {
    double most = 0;
    for (const Interval& v : g) most = std::max(most, mag(v));
    return most;
  }

  // Bounds what interpolation of that order loses of the mean of g / w^3.
  double rest(const Weight& w, double most, int order) const {
    const double product = nodes_[static_cast<std::size_t>(order)].product;
    return internal::volume_remainder(order, product, w.d, most, w.m);
  }

  // Approximates from below what rounding adds to the mean of g / w^3 in any case.
  static double rounding(const Weight& w, double most) {
    const double m = w.m.lo();
    return 0x1p-48 * most / (m * m * m);
  }

  // The mean of g / w^3: Newton's form of the interpolant.
  Interval over_cubed_weight(const PieceForest::Form& form, const std::vector<Interval>& g,
                             const Weight& w, int order, double rest) const {
    if (!std::isfinite(rest)) return Interval::entire();
    Form product = Form::from_bernstein(form.determinant, g.data());
    Interval sum, first, second, all(1.0);  // of the y: their sum, h_2, their product
    std::vector<Interval> factor(w.x.size());
    for (int k = 0;; ++k) {
      const double c = nodes_[static_cast<std::size_t>(order)].nodes[static_cast<std::size_t>(k)];
      const Interval node = Interval(w.d) * Interval(c);
      const Interval y = Interval(1.0) / (Interval(1.0) + node);
      first += y, second += y * first, all = all * y;
      const Interval term = second * all * mean(product.to_bernstein());
      sum = k % 2 == 0 ? sum + term : sum - term;
      if (k == order) break;
      for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = w.x[i] - node;
      product = product * Form::from_bernstein(form.shape, factor.data());
    }
    return sum / (w.m * w.m * w.m) + Interval::from_bounds(-rest, rest);
  }

  PieceForest& forest_;
  Point3d centre_;
  double tolerance_;
  std::vector<internal::InterpolationNodes> nodes_;  // by order
};

}  // namespace

std::vector<Interval> shell_volumes(PieceForest& forest, double tolerance) {
  const ScopedUpward upward;
  const PatchComplex& complex = forest.complex();
  // The volume is a third of the sum over the patches of a closed shell, whatever the centre is: seen from the middle,
  // summands are smallest.
  const Box3d all = hull_of_roots(forest);
  const bool is_bounded = std::isfinite(extent(all));
  const double size = is_bounded ? 0.5 * extent(all) : 1;
  Integrator integrator(
      forest, is_bounded ? approx_centre(all) : Point3d{},
      tolerance * 3 * size * size * size / static_cast<double>(forest.num_patches()));
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
