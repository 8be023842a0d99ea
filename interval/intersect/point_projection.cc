// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/point_projection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "interval/relations.h"
#include "interval/solvers/bernstein_system.h"
#include "interval/solvers/piecewise_roots.h"
#include "interval/solvers/spline_pieces.h"
#include "interval/upward.h"

namespace veritope {
namespace {

constexpr int kHessianPrecision = 256;

// The equations of critical points. With Q = P - C w of the homogeneous P, w, they are the derivatives of |Q / w|^2 / 2
// times w^3 (times 1 for polynomials), which is positive.
template <std::size_t N>
class DistanceEquations {
 public:
  DistanceEquations(const ExactPieces<N>& map, std::span<const Rational> point)
      : map_(map), point_(point) {}

  std::vector<ExactPolynomial<N>> operator()(const std::array<std::size_t, N>& cell) const {
    const Bezier<Rational, N>& piece = map_.at(cell);
    const std::vector<ExactPolynomial<N>> q = differences(piece);
    std::vector<ExactPolynomial<N>> out;
    for (std::size_t a = 0; a < N; ++a) {
      const Rational scale = Rational(1) / (map_.breaks[a][cell[a] + 1] - map_.breaks[a][cell[a]]);
      ExactPolynomial<N> slope = dot(q, a);
      if (piece.is_rational()) {
        const ExactPolynomial<N> w = scalar(piece, piece.num_components() - 1);
        ExactPolynomial<N> square = product(q[0], q[0]);
        for (std::size_t k = 1; k < q.size(); ++k) square = plus(square, product(q[k], q[k]));
        slope = plus(product(w, slope), product(derivative(w, a), square), Rational(-1));
      }
      for (Rational& c : slope.coefficients()) c *= scale;
      out.push_back(std::move(slope));
    }
    return out;
  }

 private:
  std::vector<ExactPolynomial<N>> differences(const Bezier<Rational, N>& piece) const {
    std::vector<ExactPolynomial<N>> out;
    for (std::size_t k = 0; k < point_.size(); ++k) {
      ExactPolynomial<N> q = scalar(piece, static_cast<int>(k));
      for (std::size_t i = 0; i < q.coefficients().size(); ++i)
        q.coefficients()[i] -= piece.is_rational()
                                   ? point_[k] * piece.component(piece.num_components() - 1)[i]
                                   : point_[k];
      out.push_back(std::move(q));
    }
    return out;
  }
  static ExactPolynomial<N> dot(const std::vector<ExactPolynomial<N>>& q, std::size_t axis) {
    ExactPolynomial<N> out = product(q[0], derivative(q[0], axis));
    for (std::size_t k = 1; k < q.size(); ++k)
      out = plus(out, product(q[k], derivative(q[k], axis)));
    return out;
  }

  const ExactPieces<N>& map_;
  std::span<const Rational> point_;
};

Interval distance_between(const std::vector<Interval>& a, std::span<const Rational> b) {
  Interval sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum += sqr(a[k] - enclose(b[k]));
  return sqrt(sum);
}

// Decides by the signs of the Jacobian matrix of the equations over a box around the root.
template <std::size_t N>
CriticalKind kind_at(const PiecewiseEquations<N>& system, const ExactBox<N>& box) {
  IntervalMatrix<N> j;
  for (auto& row : j) row.fill(Interval::empty());
  Grid<N> cells;
  for (std::size_t a = 0; a < N; ++a) cells.size[a] = system.breaks[a].size() - 1;
  ExactBox<N> wide = box;
  for (ExactInterval& s : wide.side)
    if (s.lo == s.hi) s.hi += Rational::power_of_two(-100);
  for (std::size_t i = 0; i < cells.count(); ++i) {
    std::array<std::size_t, N> cell;
    std::size_t rest = i;
    for (std::size_t a = N; a-- > 0; rest /= cells.size[a]) cell[a] = rest % cells.size[a];
    if (!touches(system.place(cell), wide)) continue;
    const auto list = system.equations(cell);
    for (std::size_t r = 0; r < N; ++r) {
      const auto local =
          enclosed_on(list[r], seen_from(wide, system.place(cell)), kHessianPrecision);
      for (std::size_t a = 0; a < N; ++a) {
        Interval hull_of_slopes = Interval::empty();
        const Grid<N> grid = local.grid();
        const std::size_t stride = grid.stride(a);
        grid.for_each_line(a, [&](std::size_t first) {
          for (std::size_t k = 0; k + 1 < grid.size[a]; ++k)
            hull_of_slopes = hull(hull_of_slopes, local.coefficients()[first + (k + 1) * stride] -
                                                      local.coefficients()[first + k * stride]);
        });
        const Interval degree(static_cast<double>(local.degree(a)));
        j[r][a] = hull(j[r][a], local.degree(a) == 0 ? Interval() : degree * hull_of_slopes);
      }
    }
  }
  const Sign3 first = j[0][0].sign();
  if (N == 1)
    return first == Sign3::kPositive   ? CriticalKind::kMinimum
           : first == Sign3::kNegative ? CriticalKind::kMaximum
                                       : CriticalKind::kUndecided;
  const Sign3 det = (j[0][0] * j[N - 1][N - 1] - j[0][N - 1] * j[N - 1][0]).sign();
  if (det == Sign3::kNegative) return CriticalKind::kSaddle;
  if (det != Sign3::kPositive) return CriticalKind::kUndecided;
  return first == Sign3::kPositive   ? CriticalKind::kMinimum
         : first == Sign3::kNegative ? CriticalKind::kMaximum
                                     : CriticalKind::kUndecided;
}

// Puts points of a part with M free axes into the N parameters of the map.
template <std::size_t N>
struct Held {
  std::array<std::optional<Rational>, N> value;

  template <std::size_t M>
  ExactBox<N> extended(const ExactBox<M>& free) const {
    ExactBox<N> out;
    std::size_t next = 0;
    for (std::size_t a = 0; a < N; ++a)
      out[a] = value[a] ? ExactInterval{*value[a], *value[a]} : free[next++];
    return out;
  }
  std::array<bool, N> flags() const {
    std::array<bool, N> out;
    for (std::size_t a = 0; a < N; ++a) out[a] = value[a].has_value();
    return out;
  }
};

template <std::size_t N>
ExactBox<N> point_box(const std::array<Rational, N>& point) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = {point[i], point[i]};
  return out;
}

template <std::size_t N>
class Projector {
 public:
  Projector(std::span<const Rational> point, const SolverOptions& options)
      : point_(point), options_(options) {}

  Status add(const SmoothPart<N>& part) {
    if (const Status status = solve<N>(part.pieces, {}); !status) return status;
    if constexpr (N == 1) {
      for (const bool high : {false, true})
        if (high || part.is_first[0]) add_end(part.pieces, high);
    } else {
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (const bool high : {false, true}) {
          if (!high && !part.is_first[axis]) continue;
          if (const Status status = add_border(part, axis, high); !status) return status;
        }
    }
    return ok_status();
  }
  Projection<N> finish() {
    Projection<N>& out = out_;
    drop_repeated();
    double low = HUGE_VAL, high = HUGE_VAL;
    for (const auto& p : out.points) {
      low = std::min(low, p.distance.lo());
      // A point that is perhaps outside of the domain bounds nothing from above.
      if (p.place != RootPlace::kAtBoundary) high = std::min(high, p.distance.hi());
    }
    for (const auto& r : out.open)
      low = std::min(low, r.distance.lo()), high = std::min(high, r.distance.hi());
    out.least_distance = Interval::from_bounds(low, high);
    bool is_open = false;
    for (const auto& r : out.open) is_open = is_open || r.distance.lo() <= high;
    for (std::size_t i = 0; i < out.points.size(); ++i)
      if (out.points[i].distance.lo() <= high) out.nearest.push_back(i);
    if (!is_open && out.nearest.size() == 1 &&
        out.points[out.nearest[0]].place != RootPlace::kAtBoundary)
      out.certified_nearest = out.nearest[0];
    return std::move(out_);
  }

 private:
  // Parts come before their borders and corners: the first of equals has the fewest held axes.
  void drop_repeated() {
    std::vector<CriticalPoint<N>> kept;
    for (CriticalPoint<N>& p : out_.points) {
      const bool is_known = p.exact && std::any_of(kept.begin(), kept.end(), [&](const auto& k) {
                              return k.exact == p.exact;
                            });
      if (!is_known) kept.push_back(std::move(p));
    }
    out_.points = std::move(kept);
  }

  Status add_border(const SmoothPart<N>& part, std::size_t axis, bool high) requires(N == 2) {
    const ExactPieces<1> edge = border(part.pieces, axis, high);
    Held<2> held;
    held.value[axis] = high ? part.pieces.breaks[axis].back() : part.pieces.breaks[axis].front();
    if (const Status status = solve<1>(edge, held); !status) return status;
    if (axis != 0) return ok_status();
    for (const bool end : {false, true}) {
      if (!end && !part.is_first[1]) continue;
      held.value[1] = end ? edge.breaks[0].back() : edge.breaks[0].front();
      add_corner(edge, ExactBox<1>{{ExactInterval{*held.value[1], *held.value[1]}}}, held);
    }
    return ok_status();
  }
  void add_end(const ExactPieces<1>& curve, bool high) requires(N == 1) {
    Held<1> held;
    held.value[0] = high ? curve.breaks[0].back() : curve.breaks[0].front();
    add_corner(curve, ExactBox<1>{{ExactInterval{*held.value[0], *held.value[0]}}}, held);
  }
  void add_corner(const ExactPieces<1>& curve, const ExactBox<1>& at, const Held<N>& held) {
    const ScopedUpward upward;
    CriticalPoint<N> p;
    p.parameters = held.extended(ExactBox<0>{});
    p.exact = p.parameters.middle();
    p.is_held = held.flags();
    p.kind = CriticalKind::kMinimum;
    p.point = points_of(curve, at);
    p.distance = distance_between(p.point, point_);
    out_.points.push_back(std::move(p));
  }

  template <std::size_t M>
  Status solve(const ExactPieces<M>& map, const Held<N>& held) {
    PiecewiseEquations<M> system;
    system.breaks = map.breaks;
    const DistanceEquations<M> equations(map, point_);
    system.equations = equations;
    SolverOptions options = options_;
    options.max_boxes -= std::min(options.max_boxes, out_.effort.boxes);
    const auto report = piecewise_roots<M>(system, options);
    if (!report) return report.error();
    const ScopedUpward upward;
    out_.effort.boxes += report->effort.boxes, out_.effort.frames += report->effort.frames;
    out_.effort.precision = std::max(out_.effort.precision, report->effort.precision);
    for (const IsolatedRoot<M>& root : report->roots) {
      CriticalPoint<N> p;
      p.parameters = held.extended(root.box);
      if (root.exact) p.exact = held.extended(point_box(*root.exact)).middle();
      p.is_held = held.flags();
      p.place = root.place;
      p.kind = kind_at(system, root.box);
      p.point = points_of(map, root.box);
      p.distance = distance_between(p.point, point_);
      out_.points.push_back(std::move(p));
    }
    for (const RootCluster<M>& cluster : report->clusters)
      out_.open.push_back({held.extended(cluster.box), cluster.reason,
                           distance_between(points_of(map, cluster.box), point_)});
    return ok_status();
  }

  std::span<const Rational> point_;
  const SolverOptions& options_;
  Projection<N> out_;
};

}  // namespace

template <std::size_t N>
Result<Projection<N>> project_point(std::span<const Rational> point,
                                    const BSpline<Rational, N>& map, const SolverOptions& options) {
  if (static_cast<int>(point.size()) != map.dimension() || point.empty())
    return Error{Code::kBadArgument,
                 {},
                 "a point of dimension " + std::to_string(point.size()) + ", a map of dimension " +
                     std::to_string(map.dimension())};
  if (const Status status = check_weights(map); !status) return status.error();
  Projector<N> projector(point, options);
  for (const SmoothPart<N>& part : smooth_parts(map))
    if (const Status status = projector.add(part); !status) return status.error();
  return projector.finish();
}

template Result<Projection<1>> project_point(std::span<const Rational>, const BSpline<Rational, 1>&,
                                             const SolverOptions&);
template Result<Projection<2>> project_point(std::span<const Rational>, const BSpline<Rational, 2>&,
                                             const SolverOptions&);

const char* critical_kind_name(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::kMinimum: return "minimum";
    case CriticalKind::kSaddle: return "saddle";
    case CriticalKind::kMaximum: return "maximum";
    case CriticalKind::kUndecided: return "undecided";
  }
  return "undecided";
}
const char* open_reason_name(OpenReason reason) {
  switch (reason) {
    case OpenReason::kNarrow: return "narrow";
    case OpenReason::kPrecision: return "precision";
    case OpenReason::kBudget: return "budget";
    case OpenReason::kZeroEquation: return "zero-equation";
  }
  return "budget";
}

}  // namespace veritope
