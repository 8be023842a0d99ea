// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/enclosed_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "interval/enclosure/net_internal.h"
#include "interval/ring_numbers.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using internal::Cut;
using internal::NetShape;

std::string cell_name(std::size_t i, std::size_t j) {
  return "piece (" + std::to_string(i) + ", " + std::to_string(j) + ")";
}

/// Reports what is wrong with a piece's coefficients, if anything is.
Result<bool> check_piece(const BezierSurface<Rational>& piece, const std::string& name) {
  const Rational most = Rational::power_of_two(300);
  for (const Rational& v : piece.coefficients())
    if (most < abs(v)) return Error{Code::kOverLimit, {}, name + " has a coefficient beyond 2^300"};
  if (piece.is_rational())
    for (const Rational& w : piece.component(3))
      if (w.sign() != Sign::kPositive)
        return bad_argument(name + " has the weight " + w.to_string() + ", which is not positive");
  return true;
}

/// The control points of a piece's border along `axis`, at its begin or end.
std::vector<Rational> border(const BezierSurface<Rational>& piece, std::size_t axis, bool at_end) {
  const Grid<2> grid = piece.grid();
  std::vector<Rational> out;
  for (int c = 0; c < piece.num_components(); ++c)
    for (std::size_t k = 0; k < grid.size[1 - axis]; ++k) {
      std::array<std::size_t, 2> index{};
      index[axis] = at_end ? grid.size[axis] - 1 : 0;
      index[1 - axis] = k;
      out.push_back(piece.component(c)[grid.at(index)]);
    }
  return out;
}

/// Differences of neighbours times the degree: the derivative by the local parameter.
void append_derivative(const Interval* net, const NetShape& shape, std::size_t axis,
                       std::vector<Interval>* out) {
  const std::size_t rows = shape.rows - (axis == 0 ? 1 : 0);
  const std::size_t columns = shape.columns - (axis == 1 ? 1 : 0);
  const std::size_t step = axis == 0 ? shape.columns : 1;
  const Interval degree(static_cast<double>(axis == 0 ? rows : columns));
  for (std::size_t c = 0; c < shape.components; ++c)
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const Interval* p = net + c * shape.count() + i * shape.columns + j;
        out->push_back(degree * (p[step] - p[0]));
      }
}

constexpr std::size_t kStackNet = 4 * 8 * 8;

/// A copy of a net to work on: on the stack up to degree 7.
class WorkNet {
 public:
  WorkNet(const Interval* from, std::size_t size) {
    if (size > kStackNet) heap_.resize(size);
    data_ = size > kStackNet ? heap_.data() : reinterpret_cast<Interval*>(stack_);
    std::uninitialized_copy(from, from + size, data_);
  }
  WorkNet(const WorkNet&) = delete;
  WorkNet& operator=(const WorkNet&) = delete;
  Interval* data() { return data_; }

 private:
  alignas(Interval) std::byte stack_[kStackNet * sizeof(Interval)];
  std::vector<Interval> heap_;
  Interval* data_;
};

}  // namespace

Result<EnclosedSurface> EnclosedSurface::make(const BSpline<Rational, 2>& surface) {
  if (surface.dimension() != 3)
    return bad_argument("the surface lies in dimension " + std::to_string(surface.dimension()) +
                        ", not in space");
  const auto pieces = bezier_pieces(surface);
  EnclosedSurface out;
  out.num_components_ = surface.num_components();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    out.degrees_[axis] = static_cast<std::size_t>(surface.axis(axis).degree);
    out.knots_[axis] = pieces.breaks[axis];
    for (const Rational& k : pieces.breaks[axis]) {
      const double rounded = nearest_double(k);
      if (!std::isfinite(rounded))
        return bad_argument("the knot " + k.to_string() + " is too large");
      if (!out.breaks_[axis].empty() && !(out.breaks_[axis].back() < rounded))
        return bad_argument("the knot " + k.to_string() +
                            " and the one before it are the same binary64 number");
      out.breaks_[axis].push_back(rounded);
    }
  }
  const NetShape shape{out.degrees_[0] + 1, out.degrees_[1] + 1,
                       static_cast<std::size_t>(out.num_components_)};
  for (std::size_t i = 0; i < out.num_spans(0); ++i)
    for (std::size_t j = 0; j < out.num_spans(1); ++j) {
      const auto& piece = pieces.at({i, j});
      if (auto checked = check_piece(piece, cell_name(i, j)); !checked) return checked.error();
      if ((i > 0 && border(piece, 0, false) != border(pieces.at({i - 1, j}), 0, true)) ||
          (j > 0 && border(piece, 1, false) != border(pieces.at({i, j - 1}), 1, true)))
        return bad_argument(cell_name(i, j) + " does not meet the one before it along a knot");
      const std::size_t first = out.nets_.size();
      for (const Rational& v : piece.coefficients()) {
        out.exact_.push_back(v);
        out.nets_.push_back(enclose(v));
      }
      append_derivative(out.nets_.data() + first, shape, 0, &out.du_);
      append_derivative(out.nets_.data() + first, shape, 1, &out.dv_);
    }
  return out;
}

bool EnclosedSurface::has_exact_knots() const {
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < breaks_[axis].size(); ++i)
      if (Rational::from_double(breaks_[axis][i]) != knots_[axis][i]) return false;
  return true;
}

std::size_t EnclosedSurface::span_of(std::size_t axis, double parameter) const {
  const auto& b = breaks_[axis];
  const auto above = std::upper_bound(b.begin() + 1, b.end() - 1, parameter);
  return static_cast<std::size_t>(above - b.begin()) - 1;
}

Interval EnclosedSurface::local(std::size_t axis, std::size_t span, double parameter) const {
  const double a = breaks_[axis][span], b = breaks_[axis][span + 1];
  if (parameter == a) return Interval();
  if (parameter == b) return Interval(1.0);
  return (Interval(parameter) - Interval(a)) / (Interval(b) - Interval(a));
}

Box3 EnclosedSurface::point(double u, double v) const {
  const std::size_t i = span_of(0, u), j = span_of(1, v);
  return point_at(i, j, local(0, i, u), local(1, j, v));
}

Box3 EnclosedSurface::point_of_piece(std::size_t i, std::size_t j, const Interval& u,
                                     const Interval& v) const {
  const auto in_span = [&](std::size_t axis, std::size_t span, const Interval& x) {
    const Interval a(breaks_[axis][span]), b(breaks_[axis][span + 1]);
    return (x - a) / (b - a);
  };
  return point_at(i, j, in_span(0, i, u), in_span(1, j, v));
}

std::array<MpInterval, 4> EnclosedSurface::precise_point(double u, double v, int precision) const {
  const std::size_t i = span_of(0, u), j = span_of(1, v);
  const auto number = [&](double x) { return MpInterval(Rational::from_double(x), precision); };
  const auto in_span = [&](std::size_t axis, std::size_t span, double x) {
    const MpInterval a = number(breaks_[axis][span]), b = number(breaks_[axis][span + 1]);
    return (number(x) - a) / (b - a);
  };
  const MpInterval tu = in_span(0, i, u), tv = in_span(1, j, v), one = number(1);
  const internal::AffineBlend<MpInterval> cut_u{one - tu, tu}, cut_v{one - tv, tv};
  const auto value_of = [](std::vector<MpInterval>* line, const auto& cut) {
    internal::keep_right(line->data(), 1, static_cast<int>(line->size()) - 1, cut);
    return line->front();
  };
  const std::size_t rows = degrees_[0] + 1, columns = degrees_[1] + 1;
  const Rational* const net = exact_.data() + (i * num_spans(1) + j) * net_size();
  std::array<MpInterval, 4> out{one, one, one, one};
  for (std::size_t c = 0; c < static_cast<std::size_t>(num_components_); ++c) {
    std::vector<MpInterval> ends;
    for (std::size_t row = 0; row < rows; ++row) {
      std::vector<MpInterval> line;
      for (std::size_t k = 0; k < columns; ++k)
        line.emplace_back(net[c * net_count() + row * columns + k], precision);
      ends.push_back(value_of(&line, cut_v));
    }
    out[c] = value_of(&ends, cut_u);
  }
  return out;
}

Interval EnclosedSurface::weight_of_piece(std::size_t i, std::size_t j, const Interval& u,
                                          const Interval& v) const {
  if (!is_rational()) return Interval(1.0);
  const NetShape shape{degrees_[0] + 1, degrees_[1] + 1, 1};
  WorkNet net(piece(i, j) + 3 * net_count(), shape.size());
  internal::restrict_net(net.data(), shape, Cut(local(0, i, u.lo()), local(0, i, u.hi())),
                         Cut(local(1, j, v.lo()), local(1, j, v.hi())));
  return internal::hull_of(net.data(), net_count());
}

Box3 EnclosedSurface::point_at(std::size_t i, std::size_t j, const Interval& tu,
                               const Interval& tv) const {
  const NetShape shape{degrees_[0] + 1, degrees_[1] + 1, static_cast<std::size_t>(num_components_)};
  WorkNet net(piece(i, j), shape.size());
  // Inside the piece all factors are positive or zero, and products are cheap.
  const bool is_inside = tu.lo() >= 0 && tu.hi() <= 1 && tv.lo() >= 0 && tv.hi() <= 1;
  const Interval one(1.0);
  const Interval su = one - tu, sv = one - tv;
  Interval values[4];
  for (std::size_t c = 0; c < shape.components; ++c) {
    Interval* const block = net.data() + c * shape.count();
    internal::with_blend(is_inside, sv, tv, [&](const auto& blend) {
      for (std::size_t k = 0; k < shape.rows; ++k)
        internal::keep_right(block + k * shape.columns, 1, static_cast<int>(shape.columns) - 1,
                             blend);
    });
    internal::with_blend(is_inside, su, tu, [&](const auto& blend) {
      internal::keep_right(block, shape.columns, static_cast<int>(shape.rows) - 1, blend);
    });
    values[c] = block[0];
  }
  if (!is_rational()) return Box3(values[0], values[1], values[2]);
  return Box3(values[0] / values[3], values[1] / values[3], values[2] / values[3]);
}

Box3 EnclosedSurface::hull_of_net(const Interval* net) const {
  const std::size_t n = net_count();
  Box3 out;
  if (!is_rational()) {
    for (std::size_t c = 0; c < 3; ++c) out[c] = internal::hull_of(net + c * n, n);
    return out;
  }
  out = Box3::empty();
  for (std::size_t k = 0; k < n; ++k) {
    const Interval& w = net[3 * n + k];
    if (w.sign() != Sign3::kPositive) return Box3::entire();
    out = hull(out, Box3(net[k] / w, net[n + k] / w, net[2 * n + k] / w));
  }
  return out;
}

EnclosedSurface::Range EnclosedSurface::range_of_piece(std::size_t i, std::size_t j,
                                                       const Interval& u, const Interval& v,
                                                       Want want) const {
  const std::size_t components = static_cast<std::size_t>(num_components_);
  const std::size_t number = i * num_spans(1) + j;
  const Cut cut_u(local(0, i, u.lo()), local(0, i, u.hi()));
  const Cut cut_v(local(1, j, v.lo()), local(1, j, v.hi()));
  const NetShape shape{degrees_[0] + 1, degrees_[1] + 1, components};
  const NetShape shape_u{degrees_[0], degrees_[1] + 1, components};
  const NetShape shape_v{degrees_[0] + 1, degrees_[1], components};
  WorkNet net_u(du_.data() + number * shape_u.size(), shape_u.size());
  WorkNet net_v(dv_.data() + number * shape_v.size(), shape_v.size());
  internal::restrict_net(net_u.data(), shape_u, cut_u, cut_v);
  internal::restrict_net(net_v.data(), shape_v, cut_u, cut_v);
  Range out;
  out.point = Box3::empty();
  const bool needs_points = want == Want::kAll || is_rational();
  WorkNet net(piece(i, j), needs_points ? shape.size() : 0);
  if (needs_points) {
    internal::restrict_net(net.data(), shape, cut_u, cut_v);
    out.point = hull_of_net(net.data());
  }
  const Interval length_u = Interval(breaks_[0][i + 1]) - Interval(breaks_[0][i]);
  const Interval length_v = Interval(breaks_[1][j + 1]) - Interval(breaks_[1][j]);
  Interval by_u[4], by_v[4];
  for (std::size_t c = 0; c < components; ++c) {
    by_u[c] = internal::hull_of(net_u.data() + c * shape_u.count(), shape_u.count());
    by_v[c] = internal::hull_of(net_v.data() + c * shape_v.count(), shape_v.count());
  }
  Interval weight(1.0);
  if (is_rational()) weight = internal::hull_of(net.data() + 3 * shape.count(), shape.count());
  for (std::size_t c = 0; c < 3; ++c) {
    if (is_rational()) {
      if (weight.sign() != Sign3::kPositive) {
        out.du[c] = out.dv[c] = Interval::entire();
        continue;
      }
      by_u[c] = (by_u[c] - out.point[c] * by_u[3]) / weight;
      by_v[c] = (by_v[c] - out.point[c] * by_v[3]) / weight;
    }
    out.du[c] = by_u[c] / length_u;
    out.dv[c] = by_v[c] / length_v;
  }
  return out;
}

template <typename OnPiece>
void EnclosedSurface::on_pieces(const Interval& u, const Interval& v, OnPiece on_piece) const {
  const std::size_t last_i = num_spans(0) - 1, last_j = num_spans(1) - 1;
  // A rectangle that ends on a knot needs nothing of the next piece: its derivatives are those of its own side.
  const auto last_span = [&](std::size_t axis, std::size_t first, double hi) {
    const std::size_t span = span_of(axis, hi);
    return std::max(first, span > 0 && hi == breaks_[axis][span] ? span - 1 : span);
  };
  const auto part = [&](std::size_t axis, std::size_t span, std::size_t last, const Interval& x) {
    const double lo = span == 0 ? x.lo() : std::max(x.lo(), breaks_[axis][span]);
    const double hi = span == last ? x.hi() : std::min(x.hi(), breaks_[axis][span + 1]);
    return Interval::from_bounds(lo, hi);
  };
  const std::size_t i0 = span_of(0, u.lo()), i1 = last_span(0, i0, u.hi());
  const std::size_t j0 = span_of(1, v.lo()), j1 = last_span(1, j0, v.hi());
  for (std::size_t i = i0; i <= i1; ++i)
    for (std::size_t j = j0; j <= j1; ++j)
      on_piece(i, j, part(0, i, last_i, u), part(1, j, last_j, v));
}

EnclosedSurface::Range EnclosedSurface::range(const Interval& u, const Interval& v,
                                              Want want) const {
  Range all{Box3::empty(), Box3::empty(), Box3::empty()};
  on_pieces(u, v,
            [&](std::size_t i, std::size_t j, const Interval& part_u, const Interval& part_v) {
              const Range one = range_of_piece(i, j, part_u, part_v, want);
              all.point = hull(all.point, one.point);
              all.du = hull(all.du, one.du);
              all.dv = hull(all.dv, one.dv);
            });
  return all;
}

EnclosedSurface::SecondRange EnclosedSurface::second_range(const Interval& u,
                                                           const Interval& v) const {
  SecondRange all{Box3::empty(), Box3::empty(), Box3::empty()};
  const auto components = static_cast<std::size_t>(num_components_);
  on_pieces(
      u, v, [&](std::size_t i, std::size_t j, const Interval& part_u, const Interval& part_v) {
        const Cut cut_u(local(0, i, part_u.lo()), local(0, i, part_u.hi()));
        const Cut cut_v(local(1, j, part_v.lo()), local(1, j, part_v.hi()));
        const Interval length_u = Interval(breaks_[0][i + 1]) - Interval(breaks_[0][i]);
        const Interval length_v = Interval(breaks_[1][j + 1]) - Interval(breaks_[1][j]);
        // Hulls of the derivative of order (a, b), homogeneous, by the true parameters.
        const auto derivative = [&](int a, int b) {
          NetShape shape{degrees_[0] + 1, degrees_[1] + 1, components};
          std::vector<Interval> net(piece(i, j), piece(i, j) + shape.size()), next;
          std::array<Interval, 4> out{};
          Interval scale(1.0);
          for (int k = 0; k < a + b; ++k) {
            const std::size_t axis = k < a ? 0 : 1;
            std::size_t& size = axis == 0 ? shape.rows : shape.columns;
            if (size == 1) return out;  // the polynomial is of lower degree
            next.clear();
            append_derivative(net.data(), shape, axis, &next);
            net.swap(next);
            --size;
            scale = scale * (axis == 0 ? length_u : length_v);
          }
          internal::restrict_net(net.data(), shape, cut_u, cut_v);
          for (std::size_t c = 0; c < components; ++c)
            out[c] = internal::hull_of(net.data() + c * shape.count(), shape.count()) / scale;
          return out;
        };
        auto uu = derivative(2, 0), uv = derivative(1, 1), vv = derivative(0, 2);
        if (is_rational()) {
          // (S w)'' = S'' w + S' w' + S' w' + S w''.
          const Range first = range_of_piece(i, j, part_u, part_v);
          const auto du = derivative(1, 0), dv = derivative(0, 1), value = derivative(0, 0);
          for (std::size_t c = 0; c < 3; ++c) {
            uu[c] =
                (uu[c] - Interval(2.0) * first.du[c] * du[3] - first.point[c] * uu[3]) / value[3];
            uv[c] = (uv[c] - first.du[c] * dv[3] - first.dv[c] * du[3] - first.point[c] * uv[3]) /
                    value[3];
            vv[c] =
                (vv[c] - Interval(2.0) * first.dv[c] * dv[3] - first.point[c] * vv[3]) / value[3];
          }
        }
        all.duu = hull(all.duu, Box3(uu[0], uu[1], uu[2]));
        all.duv = hull(all.duv, Box3(uv[0], uv[1], uv[2]));
        all.dvv = hull(all.dvv, Box3(vv[0], vv[1], vv[2]));
      });
  return all;
}

Interval EnclosedSurface::true_parameter(std::size_t axis, const Interval& working) const {
  const auto at = [&](double x) {
    const std::size_t span = span_of(axis, x);
    const Rational& a = knots_[axis][span];
    return enclose(a) + local(axis, span, x) * enclose(knots_[axis][span + 1] - a);
  };
  return hull(at(working.lo()), at(working.hi()));
}

}  // namespace veritope
