// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/distance.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <string>
#include <utility>

#include "interval/box_geometry.h"
#include "interval/relations.h"
#include "interval/solvers/spline_pieces.h"
#include "interval/upward.h"
#include "robust/base/box3d.h"

namespace veritope {
namespace {

using Vector = std::array<Interval, 3>;

using internal::approx_middle;

// A part of a piece with its control points.
struct Part {
  Bezier<Interval, 2> map;
  std::vector<Vector> control;
  Point3d centre{};  // next to the mean of the control points
  Vector hull;

  explicit Part(Bezier<Interval, 2> m) : map(std::move(m)) {
    const std::size_t count = map.grid().count();
    hull.fill(Interval::empty());
    for (std::size_t i = 0; i < count; ++i) {
      control.push_back(control_point(i));
      for (std::size_t k = 0; k < 3; ++k) {
        hull[k] = veritope::hull(hull[k], control.back()[k]);
        centre[k] += approx_middle(control.back()[k]) / static_cast<double>(count);
      }
    }
  }
  Vector control_point(std::size_t i) const {
    Vector out;
    for (int c = 0; c < map.dimension(); ++c) {
      out[static_cast<std::size_t>(c)] = map.component(c)[i];
      if (map.is_rational())
        out[static_cast<std::size_t>(c)] =
            map.component(c)[i] / map.component(map.num_components() - 1)[i];
    }
    return out;
  }
  double size() const {
    double out = 0;
    for (const Interval& h : hull) out = std::max(out, h.hi() - h.lo());
    return out;
  }
  // The axis along which the control polygons are longest; only axes of positive degree count.
  std::size_t long_axis() const {
    std::array<double, 2> length{-1, -1};
    const Grid<2> grid = map.grid();
    for (std::size_t a = 0; a < 2; ++a) {
      if (map.degree(a) == 0) continue;
      const std::size_t stride = grid.stride(a);
      grid.for_each_line(a, [&](std::size_t first) {
        double sum = 0;
        for (std::size_t i = 1; i < grid.size[a]; ++i)
          for (std::size_t k = 0; k < 3; ++k)
            sum += std::abs(approx_middle(control[first + i * stride][k]) -
                            approx_middle(control[first + (i - 1) * stride][k]));
        length[a] = std::max(length[a], sum);
      });
    }
    return length[1] > length[0] ? 1 : 0;
  }
  bool is_point() const { return map.degree(0) == 0 && map.degree(1) == 0; }
};
using PartPtr = std::shared_ptr<const Part>;

std::pair<PartPtr, PartPtr> halved(const Part& part) {
  const std::size_t axis = part.long_axis();
  std::pair<Bezier<Interval, 2>, Bezier<Interval, 2>> out(part.map, part.map);
  const Grid<2> grid = part.map.grid();
  const std::size_t stride = grid.stride(axis), degree = grid.size[axis] - 1;
  for (int c = 0; c < part.map.num_components(); ++c) {
    Interval* const left = out.first.component(c).data();
    Interval* const right = out.second.component(c).data();
    grid.for_each_line(axis, [&](std::size_t first) {
      for (std::size_t level = 1; level <= degree; ++level) {
        for (std::size_t i = 0; i <= degree - level; ++i)
          right[first + i * stride] =
              Interval(0.5) * (right[first + i * stride] + right[first + (i + 1) * stride]);
        left[first + level * stride] = right[first];
      }
    });
  }
  return {std::make_shared<const Part>(std::move(out.first)),
          std::make_shared<const Part>(std::move(out.second))};
}

// The hull of f over control points: convex combinations stay inside for linear f.
template <typename F>
Interval hull_over(const Part& part, F f) {
  Interval out = Interval::empty();
  for (const Vector& v : part.control) out = hull(out, f(v));
  return out;
}

// Encloses |y - x|^2 for all x in a, y in b. With the difference d of the centres, |v|^2 |d|^2 = (v.d)^2 + |v x d|^2,
// and both are linear in v = y - x. Where the parts are small, v is nearly d: the error is of second order.
Interval squared_distances(const Part& a, const Part& b) {
  Interval boxes;
  for (std::size_t k = 0; k < 3; ++k) boxes += sqr(b.hull[k] - a.hull[k]);
  std::array<Interval, 3> d;
  Interval length;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = Interval(b.centre[k] - a.centre[k]);
    length += sqr(d[k]);
  }
  if (length.sign() != Sign3::kPositive || !is_common(length)) return boxes;
  const auto difference = [&](auto f) { return hull_over(b, f) - hull_over(a, f); };
  Interval sum =
      sqr(difference([&](const Vector& v) { return v[0] * d[0] + v[1] * d[1] + v[2] * d[2]; }));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    sum += sqr(difference([&](const Vector& v) { return v[i] * d[j] - v[j] * d[i]; }));
  }
  return intersection(boxes, sum / length);
}

// Encloses one value of |y - x|^2, at corners of the parts, which are control points.
Interval some_squared_distance(const Part& a, const Part& b) {
  Interval sum;
  for (std::size_t k = 0; k < 3; ++k) sum += sqr(b.control[0][k] - a.control[0][k]);
  return sum;
}

// Finds the least distance by best-first search, and the greatest by the same search on -|y - x|^2.
class DistanceSearch {
 public:
  DistanceSearch(const DistanceOptions& options, bool greatest)
      : options_(options), sign_(greatest ? -1.0 : 1.0) {}

  void add(PartPtr a, PartPtr b) {
    ++pairs_;
    const Interval all = signed_of(squared_distances(*a, *b));
    const Interval some = signed_of(some_squared_distance(*a, *b));
    best_ = std::min({best_, some.hi()});
    if (all.lo() <= best_) queue_.push({all.lo(), std::move(a), std::move(b)});
  }
  DistanceEnclosure run() {
    DistanceEnclosure out;
    if (queue_.empty()) {
      out.distance = Interval::empty();
      out.is_as_asked = true;
      return out;
    }
    for (;;) {
      out.distance = enclosure();
      out.is_as_asked = is_narrow(out.distance);
      if (out.is_as_asked || pairs_ >= options_.max_pairs || !split_first()) break;
    }
    out.pairs = pairs_;
    return out;
  }

 private:
  struct Pair {
    double low;
    PartPtr a, b;
    bool operator<(const Pair& other) const { return other.low < low; }
  };
  Interval signed_of(const Interval& a) const { return sign_ < 0 ? -a : a; }

  // The least value lies between the least lower bound and the best value.
  Interval enclosure() const {
    const double low = std::min(queue_.empty() ? best_ : queue_.top().low, best_);
    return sqrt(signed_of(Interval::from_bounds(low, best_)));
  }
  bool is_narrow(const Interval& d) const {
    const double width = d.hi() - d.lo();
    return width <= options_.absolute_width || width <= options_.relative_width * d.hi();
  }
  bool split_first() {
    if (queue_.empty()) return false;
    const Pair first = queue_.top();
    if (first.a->is_point() && first.b->is_point()) return false;
    queue_.pop();
    const bool first_one =
        first.b->is_point() || (!first.a->is_point() && first.a->size() >= first.b->size());
    const auto [left, right] = halved(first_one ? *first.a : *first.b);
    for (const PartPtr& part : {left, right}) first_one ? add(part, first.b) : add(first.a, part);
    return true;
  }

  const DistanceOptions& options_;
  double sign_, best_ = HUGE_VAL;
  std::priority_queue<Pair> queue_;
  std::uint64_t pairs_ = 0;
};

std::vector<PartPtr> parts_of(const Shape& shape) {
  std::vector<PartPtr> out;
  for (const Shape::Piece& piece : shape.pieces()) out.push_back(std::make_shared<Part>(piece.map));
  return out;
}

Status check(const DistanceOptions& options) {
  if (options.relative_width > 0 && options.absolute_width > 0) return ok_status();
  return Error{Code::kBadArgument, {}, "a width asked for is not positive"};
}

Result<DistanceEnclosure> distance(const Shape& a, const Shape& b, const DistanceOptions& options,
                                   bool greatest) {
  if (const Status status = check(options); !status) return status.error();
  if (a.dimension() != b.dimension())
    return Error{Code::kBadArgument,
                 {},
                 "shapes of dimensions " + std::to_string(a.dimension()) + " and " +
                     std::to_string(b.dimension())};
  const ScopedUpward upward;
  DistanceSearch search(options, greatest);
  const auto first = parts_of(a), second = parts_of(b);
  for (const PartPtr& p : first)
    for (const PartPtr& q : second) search.add(p, q);
  return search.run();
}

Bezier<Interval, 2> as_surface(const Bezier<Interval, 2>& map) { return map; }
Bezier<Interval, 2> as_surface(const Bezier<Interval, 1>& map) {
  const auto c = map.coefficients();
  return Bezier<Interval, 2>({map.degree(0), 0}, map.num_components(), map.is_rational(),
                             std::vector<Interval>(c.begin(), c.end()));
}

// The points (not homogeneous) of control row `end` of an axis, of the first and last pieces along it, cell by cell.
template <std::size_t N>
std::vector<std::vector<Rational>> border_points(const ExactPieces<N>& all, std::size_t axis,
                                                 bool end) {
  std::vector<std::vector<Rational>> out;
  const Grid<N> cells = all.grid();
  for (std::size_t i = 0; i < cells.count(); ++i) {
    const auto of = [](const Grid<N>& grid, std::size_t offset, std::size_t a) {
      return offset / grid.stride(a) % grid.size[a];
    };
    if (of(cells, i, axis) != (end ? cells.size[axis] - 1 : 0)) continue;
    const Bezier<Rational, N>& piece = all.pieces[i];
    const Grid<N> grid = piece.grid();
    for (std::size_t o = 0; o < grid.count(); ++o) {
      if (of(grid, o, axis) != (end ? grid.size[axis] - 1 : 0)) continue;
      std::vector<Rational> point;
      for (int c = 0; c < piece.num_components(); ++c) point.push_back(piece.component(c)[o]);
      if (piece.is_rational())
        for (int c = 0; c < piece.dimension(); ++c)
          point[static_cast<std::size_t>(c)] /= point.back();
      out.push_back(std::move(point));
    }
  }
  return out;
}

}  // namespace

Result<Shape> Shape::point(std::span<const Rational> coordinates) {
  if (coordinates.empty() || coordinates.size() > 3)
    return Error{Code::kBadArgument,
                 {},
                 "a point of dimension " + std::to_string(coordinates.size()) + ", not 1 to 3"};
  Shape out;
  out.dimension_ = static_cast<int>(coordinates.size());
  Bezier<Interval, 2> map({0, 0}, out.dimension_, false);
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    map.coefficients()[k] = enclose(coordinates[k]);
  out.pieces_.push_back({std::move(map), {}});
  return out;
}

template <std::size_t N>
Result<Shape> Shape::of_pieces(const BSpline<Rational, N>& map) {
  if (map.dimension() < 1 || map.dimension() > 3)
    return Error{Code::kBadArgument,
                 {},
                 "a map of dimension " + std::to_string(map.dimension()) + ", not 1 to 3"};
  if (const Status status = check_weights(map); !status) return status.error();
  const ExactPieces<N> all = bezier_pieces(map);
  const Grid<N> grid = all.grid();
  Shape out;
  out.dimension_ = map.dimension();
  for (std::size_t a = 0; a < N; ++a) {
    out.cells_[a] = grid.size[a];
    const auto low = border_points(all, a, false), high = border_points(all, a, true);
    out.is_closed_[a] = low == high;
    for (const bool end : {false, true}) {
      const auto& row = end ? high : low;
      const std::size_t axes = static_cast<std::size_t>(map.dimension());
      out.is_collapsed_[a][end ? 1 : 0] =
          N > 1 && std::all_of(row.begin(), row.end(), [&](const auto& p) {
            return std::equal(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(axes),
                              row[0].begin());
          });
    }
  }
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    Piece piece{as_surface(enclosed(all.pieces[i])), {}};
    std::size_t rest = i;
    for (std::size_t a = N; a-- > 0; rest /= grid.size[a]) piece.cell[a] = rest % grid.size[a];
    out.pieces_.push_back(std::move(piece));
  }
  return out;
}
Result<Shape> Shape::of(const BSpline<Rational, 1>& curve) { return of_pieces(curve); }
Result<Shape> Shape::of(const BSpline<Rational, 2>& surface) { return of_pieces(surface); }

bool Shape::are_neighbours(const Piece& a, const Piece& b) const {
  bool touch = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t low = std::min(a.cell[k], b.cell[k]), high = std::max(a.cell[k], b.cell[k]);
    const bool over_seam = is_closed_[k] && low == 0 && high + 1 == cells_[k];
    touch = touch && (high - low <= 1 || over_seam);
    for (const bool end : {false, true}) {
      const std::size_t row = end ? cells_[k] - 1 : 0;
      if (is_collapsed_[k][end ? 1 : 0] && a.cell[k] == row && b.cell[k] == row) return true;
    }
  }
  return touch;
}

Result<DistanceEnclosure> least_distance(const Shape& a, const Shape& b,
                                         const DistanceOptions& options) {
  return distance(a, b, options, false);
}
Result<DistanceEnclosure> greatest_distance(const Shape& a, const Shape& b,
                                            const DistanceOptions& options) {
  return distance(a, b, options, true);
}
Result<DistanceEnclosure> least_self_distance(const Shape& shape, const DistanceOptions& options) {
  if (const Status status = check(options); !status) return status.error();
  const ScopedUpward upward;
  DistanceSearch search(options, false);
  const auto parts = parts_of(shape);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!shape.are_neighbours(shape.pieces()[i], shape.pieces()[j]))
        search.add(parts[i], parts[j]);
  return search.run();
}

}  // namespace veritope
