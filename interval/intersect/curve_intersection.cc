// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/curve_intersection.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/solvers/piecewise_roots.h"
#include "interval/solvers/spline_pieces.h"
#include "interval/upward.h"

namespace veritope {
namespace {

// Component c of a piece in K variables as a polynomial in N variables, of which the piece's own are those from `first`
// on; the constant 1 for the weight of a map that has none.
template <std::size_t N, std::size_t K>
ExactPolynomial<N> lifted(const Bezier<Rational, K>& piece, int c, std::size_t first) {
  std::array<int, N> degrees{};
  const bool is_one = c == piece.dimension() && !piece.is_rational();
  if (!is_one)
    for (std::size_t a = 0; a < K; ++a) degrees[first + a] = piece.degree(a);
  ExactPolynomial<N> out(degrees, 1, false);
  if (is_one) {
    out.coefficients()[0] = Rational(1);
  } else {  // the other axes have one coefficient, so the order stays
    std::copy(piece.component(c).begin(), piece.component(c).end(), out.coefficients().begin());
  }
  return out;
}

// w_b a - w_a b of two pieces, component by component: zero where the points are equal.
template <std::size_t N, std::size_t K, std::size_t L>
std::vector<ExactPolynomial<N>> difference(const Bezier<Rational, K>& a,
                                           const Bezier<Rational, L>& b) {
  const auto wa = lifted<N>(a, a.dimension(), 0), wb = lifted<N>(b, b.dimension(), K);
  std::vector<ExactPolynomial<N>> out;
  for (int c = 0; c < a.dimension(); ++c)
    out.push_back(
        plus(product(lifted<N>(a, c, 0), wb), product(lifted<N>(b, c, K), wa), Rational(-1)));
  return out;
}

template <std::size_t K, std::size_t L>
std::pair<std::array<std::size_t, K>, std::array<std::size_t, L>> cells_of(
    const std::array<std::size_t, K + L>& cell) {
  std::pair<std::array<std::size_t, K>, std::array<std::size_t, L>> out;
  std::copy(cell.begin(), cell.begin() + K, out.first.begin());
  std::copy(cell.begin() + K, cell.end(), out.second.begin());
  return out;
}

template <std::size_t N>
std::vector<std::vector<Interval>> hulls_of(const ExactPieces<N>& map) {
  const ScopedUpward upward;
  std::vector<std::vector<Interval>> out;
  for (const auto& piece : map.pieces) out.push_back(hull_of(enclosed(piece)));
  return out;
}

// Appends what was found on another pair of parts.
template <std::size_t N>
void append(RootReport<N>& to, RootReport<N> from) {
  to.effort.boxes += from.effort.boxes, to.effort.frames += from.effort.frames;
  to.effort.precision = std::max(to.effort.precision, from.effort.precision);
  std::move(from.roots.begin(), from.roots.end(), std::back_inserter(to.roots));
  std::move(from.clusters.begin(), from.clusters.end(), std::back_inserter(to.clusters));
}

template <std::size_t K, std::size_t L>
Result<RootReport<K + L>> meet(const ExactPieces<K>& a, const ExactPieces<L>& b,
                               const SolverOptions& options) {
  constexpr std::size_t N = K + L;
  PiecewiseEquations<N> system;
  std::copy(a.breaks.begin(), a.breaks.end(), system.breaks.begin());
  std::copy(b.breaks.begin(), b.breaks.end(), system.breaks.begin() + K);
  const auto hulls_a = hulls_of(a), hulls_b = hulls_of(b);
  system.is_free = [&](const std::array<std::size_t, N>& cell) {
    const auto [i, j] = cells_of<K, L>(cell);
    const auto &p = hulls_a[a.grid().at(i)], &q = hulls_b[b.grid().at(j)];
    for (std::size_t c = 0; c < p.size(); ++c)
      if (is_disjoint(p[c], q[c])) return true;
    return false;
  };
  system.equations = [&](const std::array<std::size_t, N>& cell) {
    const auto [i, j] = cells_of<K, L>(cell);
    return difference<N>(a.at(i), b.at(j));
  };
  return piecewise_roots<N>(system, options);
}

template <std::size_t K, std::size_t L>
Status check(const BSpline<Rational, K>& a, const BSpline<Rational, L>& b, int dimension) {
  if (a.dimension() != dimension || b.dimension() != dimension)
    return Error{Code::kBadArgument,
                 {},
                 "maps of dimensions " + std::to_string(a.dimension()) + " and " +
                     std::to_string(b.dimension()) + ", not " + std::to_string(dimension)};
  if (const Status status = check_weights(a); !status) return status;
  return check_weights(b);
}

template <std::size_t K, std::size_t L>
Result<RootReport<K + L>> intersect(const BSpline<Rational, K>& a, const BSpline<Rational, L>& b,
                                    const SolverOptions& options) {
  if (const Status status = check(a, b, static_cast<int>(K + L)); !status) return status.error();
  RootReport<K + L> out;
  for (const auto& p : connected_parts(a))
    for (const auto& q : connected_parts(b)) {
      SolverOptions rest = options;
      rest.max_boxes -= std::min(rest.max_boxes, out.effort.boxes);
      auto found = meet(p, q, rest);
      if (!found) return found.error();
      append(out, *std::move(found));
    }
  return out;
}

// R . (P' w - P w') of one curve, which is R . (P / w)' times w^2.
ExactPolynomial<2> along(const std::vector<ExactPolynomial<2>>& r, const Bezier<Rational, 1>& piece,
                         std::size_t axis) {
  const auto w = lifted<2>(piece, piece.dimension(), axis);
  ExactPolynomial<2> out({0, 0}, 1, false);
  for (int c = 0; c < piece.dimension(); ++c) {
    const auto p = lifted<2>(piece, c, axis);
    const auto tangent =
        plus(product(derivative(p, axis), w), product(p, derivative(w, axis)), Rational(-1));
    out = plus(out, product(r[static_cast<std::size_t>(c)], tangent));
  }
  return out;
}

Result<RootReport<2>> chords_of(const ExactPieces<1>& a, const ExactPieces<1>& b,
                                const SolverOptions& options) {
  PiecewiseEquations<2> system;
  system.breaks = {a.breaks[0], b.breaks[0]};
  system.equations = [&](const std::array<std::size_t, 2>& cell) {
    const auto &p = a.at({cell[0]}), &q = b.at({cell[1]});
    const auto r = difference<2>(p, q);
    std::vector<ExactPolynomial<2>> out{along(r, p, 0), along(r, q, 1)};
    for (std::size_t k = 0; k < 2; ++k) {  // derivatives by the global parameter: continuous
      const Rational width = system.breaks[k][cell[k] + 1] - system.breaks[k][cell[k]];
      for (Rational& c : out[k].coefficients()) c /= width;
    }
    return out;
  };
  return piecewise_roots<2>(system, options);
}

}  // namespace

Result<RootReport<2>> intersect_curves(const BSpline<Rational, 1>& a, const BSpline<Rational, 1>& b,
                                       const SolverOptions& options) {
  return intersect(a, b, options);
}
Result<RootReport<3>> intersect_curve_surface(const BSpline<Rational, 1>& curve,
                                              const BSpline<Rational, 2>& surface,
                                              const SolverOptions& options) {
  return intersect(curve, surface, options);
}

Result<NormalChords> normal_chords(const BSpline<Rational, 1>& a, const BSpline<Rational, 1>& b,
                                   const SolverOptions& options) {
  if (const Status status = check(a, b, a.dimension()); !status) return status.error();
  NormalChords out;
  for (const auto& p : smooth_parts(a))
    for (const auto& q : smooth_parts(b)) {
      SolverOptions rest = options;
      rest.max_boxes -= std::min(rest.max_boxes, out.effort.boxes);
      const auto found = chords_of(p.pieces, q.pieces, rest);
      if (!found) return found.error();
      out.effort.boxes += found->effort.boxes, out.effort.frames += found->effort.frames;
      out.effort.precision = std::max(out.effort.precision, found->effort.precision);
      out.clusters.insert(out.clusters.end(), found->clusters.begin(), found->clusters.end());
      const ScopedUpward upward;
      for (const IsolatedRoot<2>& root : found->roots) {
        const auto x = points_of(p.pieces, ExactBox<1>{{root.box[0]}});
        const auto y = points_of(q.pieces, ExactBox<1>{{root.box[1]}});
        Interval square;
        for (std::size_t c = 0; c < x.size(); ++c) square += sqr(x[c] - y[c]);
        out.chords.push_back({root, sqrt(square)});
      }
    }
  return out;
}

}  // namespace veritope
