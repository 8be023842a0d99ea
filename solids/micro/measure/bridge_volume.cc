// SPDX-License-Identifier: LGPL-3.0-or-later
// The divergence theorem in the parameters: the integral of J over a bridge is that of G over its boundary, times the
// component of the normal along the axis of G. A part of a face in one cell between knots has a polynomial there, for
// which a Gauss rule is exact; what crosses a knot is halved again and again.
#include "solids/micro/measure/bridge_volume_internal.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "interval/numeric.h"
#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge_faces.h"
#include "solids/micro/measure/bridge_primitive_internal.h"
#include "solids/micro/measure/node_basis_internal.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

// Parts of faces of one bridge.
constexpr std::size_t kMostFaceParts = 4096;
constexpr int kMostFaceLevel = 80;
constexpr std::size_t kBridgesInChunk = 16;

// Tables of nodes, by degrees of faces and of integrands.
class NodeTables {
 public:
  const NodeBasis& of(int degree, std::size_t integrand) {
    const auto [at, is_new] = known_.try_emplace({degree, integrand});
    if (is_new) at->second = node_basis(degree, integrand);
    return at->second;
  }

 private:
  std::map<std::pair<int, std::size_t>, NodeBasis> known_;
};

// A part of a face in the box of the bridge, brought to [0, 1]^3, and the integral over it.
struct FacePart {
  BezierSurface<Interval> net{{1, 1}, 3, false};
  int level = 0;
  bool crosses_knot = false;
  Interval value;
};
struct IsMoreCertain {
  bool operator()(const FacePart& a, const FacePart& b) const {
    return wid(a.value) < wid(b.value);
  }
};

Box3 box_of_net(const BezierSurface<Interval>& net) {
  Box3 out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto x = net.component(static_cast<int>(a));
    out[a] = x[0];
    for (const Interval& c : x) out[a] = hull(out[a], c);
  }
  return out;
}
// The greatest absolute value of a coordinate's derivative.
Interval slope_bound(const BezierSurface<Interval>& net, std::size_t component, std::size_t axis) {
  const auto x = net.component(static_cast<int>(component));
  const Grid<2> grid = net.grid();
  double most = 0;
  grid.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i + 1 < grid.size[axis]; ++i)
      most = std::max(
          most, mag(x[first + (i + 1) * grid.stride(axis)] - x[first + i * grid.stride(axis)]));
  });
  return Interval::from_bounds(0, most) * Interval(static_cast<double>(net.degree(axis)));
}

// The box of a bridge's net.
std::array<TilePoint, 2> corners_of(const MicroBridge& bridge) {
  std::array<TilePoint, 2> out = {bridge.points.front(), bridge.points.front()};
  for (const TilePoint& p : bridge.points)
    for (std::size_t a = 0; a < 3; ++a) {
      out[0][a] = std::min(out[0][a], p[a]);
      out[1][a] = std::max(out[1][a], p[a]);
    }
  return out;
}
bool may_cross_knot(const VVolume& volume, const MicroBridge& bridge) {
  const auto [lo, hi] = corners_of(bridge);
  for (std::size_t a = 0; a < 3; ++a)
    for (const Rational& t : volume.axis(a).knots)
      if (lo[a] < t && t < hi[a]) return true;
  return false;
}

class OneBridge {
 public:
  OneBridge(const Microstructure& micro, const MicroBridge& bridge, SpanDeterminants& determinants,
            NodeTables& tables)
      : bridge_(bridge),
        corners_(corners_of(bridge)),
        primitive_(micro.cage[bridge.volume], bridge.volume, corners_[0], corners_[1],
                   determinants),
        tables_(tables) {}

  Interval volume(double enough) {
    for (const BezierSurface<Rational>& face : free_faces(bridge_)) start(face);
    start(covering_face(bridge_));
    double open = 0;
    for (const FacePart& part : crossing_) open += wid(part.value);
    std::make_heap(crossing_.begin(), crossing_.end(), IsMoreCertain());
    for (std::size_t parts = 0; parts < kMostFaceParts && !crossing_.empty() && open > enough;
         parts += 2) {
      std::pop_heap(crossing_.begin(), crossing_.end(), IsMoreCertain());
      const FacePart part = std::move(crossing_.back());
      crossing_.pop_back();
      open -= wid(part.value);
      if (part.level >= kMostFaceLevel) {
        sum_ += part.value;
        continue;
      }
      auto halves = split(part.net, longer_axis(part.net), Interval(0.5));
      open += add(std::move(halves.first), part.level + 1);
      open += add(std::move(halves.second), part.level + 1);
    }
    for (const FacePart& part : crossing_) sum_ += part.value;
    return sum_;
  }

 private:
  // The longer axis of a part, approximately: it is bent little.
  static std::size_t longer_axis(const BezierSurface<Interval>& net) {
    double most[2] = {0, 0};
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t c = 0; c < 3; ++c)
        most[axis] = std::max(most[axis], slope_bound(net, c, axis).hi());
    return most[1] > most[0] ? 1 : 0;
  }

  void start(const BezierSurface<Rational>& face) {
    BezierSurface<Interval> net(face.degrees(), 3, false);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto x = face.component(static_cast<int>(a));
      const Rational length = corners_[1][a] - corners_[0][a];
      for (std::size_t i = 0; i < x.size(); ++i)
        net.component(static_cast<int>(a))[i] = enclose((x[i] - corners_[0][a]) / length);
    }
    add(std::move(net), 0);
    std::make_heap(crossing_.begin(), crossing_.end(), IsMoreCertain());
  }
  // Returns the width of what is not finished.
  double add(BezierSurface<Interval> net, int level) {
    FacePart part{std::move(net), level, false, {}};
    integrate(part);
    if (!part.crosses_knot) {
      sum_ += part.value;
      return 0;
    }
    const double width = wid(part.value);
    crossing_.push_back(std::move(part));
    std::push_heap(crossing_.begin(), crossing_.end(), IsMoreCertain());
    return width;
  }

  void integrate(FacePart& part) {
    const Box3 box = box_of_net(part.net);
    const BridgePrimitive::CellRange range = primitive_.cells_of(box);
    const std::size_t a = primitive_.axis();
    std::size_t count = 1;
    for (const auto& r : range) count *= r[1] - r[0] + 1;
    BridgePrimitive::CellNumber cell = {range[0][0], range[1][0], range[2][0]};
    if (count == 1) {
      part.value = integral(part.net, [&](const Box3& y) { return primitive_.near(cell, y); }) +
                   up_to(primitive_.error(cell)) * size_bound(part.net);
      return;
    }
    part.crosses_knot = true;
    if (count == 2 && range[a][1] == range[a][0] + 1) {
      part.value = across(part.net, box, cell);
      return;
    }
    // Anything between the values in all of the cells.
    Interval values = Interval::empty();
    for (cell[0] = range[0][0]; cell[0] <= range[0][1]; ++cell[0])
      for (cell[1] = range[1][0]; cell[1] <= range[1][1]; ++cell[1])
        for (cell[2] = range[2][0]; cell[2] <= range[2][1]; ++cell[2])
          values = hull(values, primitive_.near(cell, box) + up_to(primitive_.error(cell)));
    const MidRad m = mid_rad(values);
    part.value = integral(part.net, [&](const Box3&) { return Interval(m.mid); }) +
                 up_to(m.rad) * size_bound(part.net);
  }
  // Between two cells along the axis G is its value at the cut, plus the distance from the cut times a value of J.
  Interval across(const BezierSurface<Interval>& net, const Box3& box,
                  const BridgePrimitive::CellNumber& below) {
    const std::size_t a = primitive_.axis();
    BridgePrimitive::CellNumber above = below;
    ++above[a];
    const Interval& cut = primitive_.cut(a, above[a]);
    const MidRad j =
        mid_rad(hull(primitive_.determinant(below, box), primitive_.determinant(above, box)));
    const Interval value = integral(net, [&](const Box3& y) {
      return primitive_.near_begin(above, y) + (y[a] - cut) * Interval(j.mid);
    });
    const double error = std::max(primitive_.error(below), primitive_.error(above));
    return value + up_to((Interval::from_bounds(0, error) +
                          Interval::from_bounds(0, j.rad) * Interval(mag(box[a] - cut)))
                             .hi()) *
                       size_bound(net);
  }

  static Interval up_to(double x) { return Interval::from_bounds(-x, x); }
  // A bound of the normal's component along the axis.
  Interval size_bound(const BezierSurface<Interval>& net) const {
    const std::size_t b = (primitive_.axis() + 1) % 3, c = (primitive_.axis() + 2) % 3;
    return slope_bound(net, b, 0) * slope_bound(net, c, 1) +
           slope_bound(net, c, 0) * slope_bound(net, b, 1);
  }

  // The integral of g times the normal's component along the axis, for g of a degree up to that of G.
  template <typename Function>
  Interval integral(const BezierSurface<Interval>& net, Function g) {
    const auto integrand = [&](int degree) {
      return (primitive_.order() + 3) * static_cast<std::size_t>(degree) - 1;
    };
    const NodeBasis &first = tables_.of(net.degree(0), integrand(net.degree(0))),
                    &second = tables_.of(net.degree(1), integrand(net.degree(1)));
    const std::size_t b = (primitive_.axis() + 1) % 3, c = (primitive_.axis() + 2) % 3;
    const Grid<2> grid = net.grid();
    std::vector<Box3> line(grid.size[1]), slope_line(grid.size[1]);
    Interval sum;
    for (std::size_t m = 0; m < first.weights.size(); ++m) {
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t a = 0; a < 3; ++a) {
          const auto x = net.component(static_cast<int>(a));
          line[j][a] = slope_line[j][a] = Interval();
          for (std::size_t i = 0; i < grid.size[0]; ++i) {
            line[j][a] += first.value[m][i] * x[i * grid.size[1] + j];
            slope_line[j][a] += first.slope[m][i] * x[i * grid.size[1] + j];
          }
        }
      for (std::size_t n = 0; n < second.weights.size(); ++n) {
        Box3 y, along_s, along_t;
        for (std::size_t a = 0; a < 3; ++a) {
          y[a] = along_s[a] = along_t[a] = Interval();
          for (std::size_t j = 0; j < grid.size[1]; ++j) {
            y[a] += second.value[n][j] * line[j][a];
            along_s[a] += second.value[n][j] * slope_line[j][a];
            along_t[a] += second.slope[n][j] * line[j][a];
          }
        }
        const Interval normal = along_s[b] * along_t[c] - along_s[c] * along_t[b];
        sum += first.weights[m] * second.weights[n] * normal * g(y);
      }
    }
    return sum;
  }

  const MicroBridge& bridge_;
  std::array<TilePoint, 2> corners_;
  BridgePrimitive primitive_;
  NodeTables& tables_;
  std::vector<FacePart> crossing_;  // a heap
  Interval sum_;
};

}  // namespace

Interval volume_of_bridges(const Microstructure& micro, const std::vector<int>& hands,
                           double enough, unsigned jobs) {
  SpanDeterminants determinants(micro);
  const auto crossing =
      std::count_if(micro.bridges.begin(), micro.bridges.end(),
                    [&](const MicroBridge& b) { return may_cross_knot(micro.cage[b.volume], b); });
  if (crossing > 0) enough /= static_cast<double>(crossing);
  const std::size_t count = micro.bridges.size();
  std::vector<Interval> sums(num_chunks(count, kBridgesInChunk));
  parallel_for(count, kBridgesInChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 const ScopedUpward upward;
                 NodeTables tables;
                 for (std::size_t i = begin; i < end; ++i) {
                   const MicroBridge& b = micro.bridges[i];
                   sums[chunk] += Interval(static_cast<double>(hands[b.volume])) *
                                  OneBridge(micro, b, determinants, tables).volume(enough);
                 }
               });
  const ScopedUpward upward;
  Interval out;
  for (const Interval& s : sums) out += s;
  return out;
}

}  // namespace veritope::internal
