// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/patch_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/pieces/find_pieces.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Form = internal::ScaledForm<Interval>;

constexpr int kMostOrder = 9;  // of the polynomial for 1 / w^3
constexpr int kMaxLevel = 8;
constexpr std::size_t kMemory = std::size_t{1} << 26;  // bytes, of the nets of pieces
constexpr double kPi = std::numbers::pi;

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

// Nodes for a polynomial of degree K on [-1, 1], near the zeros of Chebyshev's T_{K+1}. std::cos is not
// trusted: `product` bounds |(t - c_0) ... (t - c_K)| for |t| <= 1 from the nodes as they are, by the sum of its
// coefficients' magnitudes in T_0, ..., T_{K+1} (2 t T_k = T_{k+1} + T_{|k-1|}). It is 2^-K at the zeros themselves.
struct InterpolationNodes {
  explicit InterpolationNodes(int order) {
    std::vector<Interval> sum{Interval(1.0)};
    for (int k = 0; k <= order; ++k) {
      const double c = std::cos((2 * k + 1) * kPi / (2 * order + 2));
      nodes.push_back(std::clamp(c, -1.0, 1.0));
      sum = times_difference(sum, Interval(nodes.back()));
    }
    Interval bound;
    for (const Interval& c : sum) bound += Interval(mag(c));
    product = bound.hi();
  }

  // (t - c) times a sum of Chebyshev polynomials.
  static std::vector<Interval> times_difference(const std::vector<Interval>& sum,
                                                const Interval& c) {
    std::vector<Interval> out(sum.size() + 1);
    const Interval half(0.5);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      out[k] -= c * sum[k];
      out[k + 1] += half * sum[k];
      out[k == 0 ? 1 : k - 1] += half * sum[k];
    }
    return out;
  }

  std::vector<double> nodes;
  double product = 0;
};

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
    if (is_near || node.level >= kMaxLevel)
      return area * over_cubed_weight(form, g, w, order, rest(w, most, order));
    forest_.limit_memory(kMemory);
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

  // f = (1 + x)^-3 is interpolated at x_j = d c_j, j = 0 .. K. The divided differences of f are
  // (-1)^k h_2(y_0, ..., y_k) y_0 ... y_k, y_j = 1 / (1 + x_j), h_2 the sum of all C(k + 2, 2) products of two (by
  // induction on k, as for 1 / (1 + x), where h_0 = 1 stands for h_2). The error at x is the divided difference of x_0,
  // ..., x_K, x times the product of all x - x_j, which is at most d^(K + 1) times that of the nodes. Since every y is
  // at most 1 / (1 - d), it is at most  C(K + 3, 2) (1 - d)^-(K + 4) d^(K + 1) product. The result times |g| / m^3
  // bounds what the mean of g / w^3 loses.
  double rest(const Weight& w, double most, int order) const {
    if (!(w.d < 0.5)) return std::numeric_limits<double>::infinity();
    const Interval d(w.d), y = Interval(1.0) / (Interval(1.0) - d);
    Interval out((order + 3) * (order + 2) / 2.0);
    out = out * Interval(nodes_[static_cast<std::size_t>(order)].product) * Interval(most);
    out = out * d * y * y * y * y / (w.m * w.m * w.m);
    for (int k = 0; k < order; ++k) out = out * d * y;
    return out.hi();
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
  std::vector<InterpolationNodes> nodes_;  // by order
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
