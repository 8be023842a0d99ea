// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "interval/numeric.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_ray_plan_internal.h"
#include "solids/dms/dms_table.h"
#include "splines/dms_spline.h"

namespace veritope::internal {
namespace {

// Bounds of errors are sums of products of a few numbers that are not negative. Each operation loses at most a part
// 2^-53 of its result, or 2^-1074 by underflow.
double paid(double bound) { return bound * (1 + 0x1p-40) + 0x1p-1000; }

template <Ring R>
using GridVectors = std::array<std::array<R, 3>, 3>;  // right, down, along

// The barycentric coordinate m is the sum over k of row[m][k] (1, i, j, s)_k.
struct GridFrame {
  std::array<KnotNumber, 4> knots{};
  Interval volume, height;
  std::array<std::array<Interval, 4>, 4> row;
};

template <Ring R>
std::array<std::array<R, 4>, 4> rows_of(const SimplexFrame<R>& frame,
                                        const GridVectors<R>& vectors) {
  std::array<std::array<R, 4>, 4> rows;
  for (std::size_t m = 0; m < 4; ++m) {
    const auto& l = frame.lambda[m];
    rows[m][0] = l[0];
    for (std::size_t k = 0; k < 3; ++k)
      rows[m][k + 1] = l[1] * vectors[k][0] + l[2] * vectors[k][1] + l[3] * vectors[k][2];
  }
  return rows;
}

GridVectors<Rational> exact_vectors(const DmsRayGrid& grid) {
  GridVectors<Rational> out;
  const std::array<const Point3d*, 3> from{&grid.right, &grid.down, &grid.along};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 3; ++c) out[k][c] = Rational::from_double((*from[k])[c]);
  return out;
}

bool has_sign(const Interval& a) { return a.sign() != Sign3::kUncertain; }

// Where rays meet the hull of knots.
struct HullRange {
  std::array<Interval, 3> side;  // columns, rows, t
};

class GridFrames {
 public:
  explicit GridFrames(const DmsRayGrid& grid) : exact_(exact_vectors(grid)) {
    for (std::size_t c = 0; c < 3; ++c) {
      origin_[c] = Rational::from_double(grid.origin[c]);
      enclosed_origin_[c] = Interval(grid.origin[c]);
    }
    const DmsPoint normal = cross_product(exact_[0], exact_[1]);
    inverse_ = frame_in_ring<Interval>(
        simplex_frame<Rational>({0, 1, 2, 3}, {DmsPoint{}, exact_[0], exact_[1], exact_[2]},
                                dot_product(normal, exact_[2]).sign()));
  }

  HullRange range(std::span<const ExactPoint3* const> points) const {
    const ScopedUpward upward;
    HullRange out;
    out.side.fill(Interval::empty());
    for (const ExactPoint3* p : points) {
      std::array<Interval, 3> at;
      for (std::size_t c = 0; c < 3; ++c) at[c] = p->enclosure()[c] - enclosed_origin_[c];
      const std::array<Interval, 4> found = inverse_.barycentric(at);
      for (std::size_t k = 0; k < 3; ++k)
        out.side[k] = out.side[k].is_empty() ? found[k + 1] : span_of(out.side[k], found[k + 1]);
    }
    return out;
  }
  // The frames of one plan are relative to its centre.
  void set_centre(const RayPlan& plan) {
    const std::array<double, 3> at{plan.centre_column, plan.centre_row, plan.centre};
    centre_ = origin_;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = 0; c < 3; ++c) centre_[c] += Rational::from_double(at[k]) * exact_[k][c];
    vectors_ = exact_;
    for (Rational& x : vectors_[2]) x *= Rational::from_double(plan.radius);
    for (std::size_t c = 0; c < 3; ++c) {
      enclosed_centre_[c] = enclose(centre_[c]);
      for (std::size_t k = 0; k < 3; ++k) enclosed_[k][c] = enclose(vectors_[k][c]);
    }
  }
  // The frame of four points; the orientation is not zero. Enclosures are as narrow as doubles allow.
  GridFrame frame(const std::array<KnotNumber, 4>& knots,
                  const std::array<const ExactPoint3*, 4>& points, Sign orientation) const {
    GridFrame out;
    out.knots = knots;
    if (!enclose_frame(points, orientation, out)) exact_frame(points, orientation, out);
    return out;
  }

 private:
  static Interval span_of(const Interval& a, const Interval& b) {
    return Interval::from_bounds(std::min(a.lo(), b.lo()), std::max(a.hi(), b.hi()));
  }
  bool enclose_frame(const std::array<const ExactPoint3*, 4>& points, Sign orientation,
                     GridFrame& out) const {
    const ScopedUpward upward;
    std::array<std::array<Interval, 3>, 4> at;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c)
        at[m][c] = points[m]->enclosure()[c] - enclosed_centre_[c];
    const SimplexFrame<Interval> frame = simplex_frame<Interval>(out.knots, at, orientation);
    if (!has_sign(frame.volume) || !(wid(frame.height) <= 0x1p-40 * mid(frame.height)))
      return false;
    out.volume = frame.volume;
    out.height = frame.height;
    out.row = rows_of(frame, enclosed_);
    return std::all_of(out.row.begin(), out.row.end(),
                       [](const auto& row) { return has_sign(row[3]); });
  }
  void exact_frame(const std::array<const ExactPoint3*, 4>& points, Sign orientation,
                   GridFrame& out) const {
    std::array<DmsPoint, 4> at;
    for (std::size_t m = 0; m < 4; ++m) at[m] = difference(points[m]->at(), centre_);
    const SimplexFrame<Rational> frame = simplex_frame<Rational>(out.knots, at, orientation);
    out.volume = enclose(frame.volume);
    out.height = enclose(frame.height);
    const auto rows = rows_of(frame, vectors_);
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t k = 0; k < 4; ++k) out.row[m][k] = enclose(rows[m][k]);
  }

  GridVectors<Rational> exact_, vectors_;
  GridVectors<Interval> enclosed_;
  DmsPoint origin_, centre_;
  std::array<Interval, 3> enclosed_origin_, enclosed_centre_;
  SimplexFrame<Interval> inverse_;
};

// The plan of one tetrahedron.
class RayPlanBuilder {
 public:
  RayPlanBuilder(const DmsModel& model, const DmsRayGrid& grid, GridFrames& frames, DmsTable& table,
                 std::uint32_t t)
      : model_(model), grid_(grid), frames_(frames), table_(table), tetrahedron_(t) {}

  // Nothing if all rays miss the knots.
  std::optional<RayPlan> build() {
    if (!set_range()) return std::nullopt;
    frames_.set_centre(plan_);
    const auto w = table_.knots().tetrahedron({0, 0, 0, 0});
    VT_CHECK(add_set(KnotSet{w[0], w[1], w[2], w[3]}) == 0,
             "the tetrahedron of the domain is not degenerate");
    for_each_tetrahedral_index(model_.condition_degree(),
                               [&](const TetrahedralIndex& gamma) { add_term(gamma); });
    for (RayNode& node : plan_.nodes)  // nodes follow all cells
      for (std::int32_t& child : node.child)
        if (child < -1) child = static_cast<std::int32_t>(plan_.cells.size()) - 2 - child;
    for (RayTerm& term : plan_.terms)
      if (term.set < -1) term.set = static_cast<std::int32_t>(plan_.cells.size()) - 2 - term.set;
    return std::move(plan_);
  }

 private:
  // Null if the four knots are in one plane.
  const GridFrame* frame_of(const std::array<KnotNumber, 4>& four) {
    const auto [place, is_new] = known_.try_emplace(four);
    if (is_new) {
      const std::array<const ExactPoint3*, 4> points{&table_.point(four[0]), &table_.point(four[1]),
                                                     &table_.point(four[2]),
                                                     &table_.point(four[3])};
      const Sign s = orient3d(*points[0], *points[1], *points[2], *points[3]);
      if (s != Sign::kZero) place->second = frames_.frame(four, points, s);
    }
    return place->second ? &*place->second : nullptr;
  }

  // A cell, -2 minus the number of a node, or -1.
  std::int32_t add_set(const KnotSet& set) {
    const auto found = sets_.find(set);
    if (found != sets_.end()) return found->second;
    const std::int32_t number = set.size() == 4 ? add_cell(set) : add_node(set);
    sets_.emplace(set, number);
    return number;
  }
  std::int32_t add_node(const KnotSet& set) {
    const auto four = four_independent(set, [&](const auto& f) { return frame_of(f) != nullptr; });
    if (!four) return -1;
    RayNode node;
    node.degree = static_cast<int>(set.size()) - 4;
    bool is_zero = true;
    for (std::size_t m = 0; m < 4; ++m) {
      node.child[m] = add_set(set.without((*four)[m]));
      is_zero = is_zero && node.child[m] == -1;
    }
    if (is_zero) return -1;
    node.coordinate = coordinates_of(*frame_of(*four));
    plan_.nodes.push_back(std::move(node));
    return -1 - static_cast<std::int32_t>(plan_.nodes.size());
  }
  std::int32_t add_cell(const KnotSet& set) {
    const GridFrame* const frame = frame_of({set[0], set[1], set[2], set[3]});
    if (frame == nullptr) return -1;
    plan_.cells.push_back(cell_of(*frame));
    return static_cast<std::int32_t>(plan_.cells.size()) - 1;
  }

  void add_term(const TetrahedralIndex& gamma) {
    RayTerm term;
    term.set = add_set(table_.knots().up_to(gamma));
    if (term.set == -1) return;
    std::array<KnotNumber, 4> w = table_.knots().tetrahedron(gamma);
    const GridFrame* const frame = frame_of(w);
    VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
    const MidRad volume = mid_rad(frame->volume);
    term.volume = volume.mid;
    term.volume_error = volume.rad;
    term.coordinate = coordinates_of(*frame);
    for (std::size_t m = 0; m < 4; ++m)
      term.control[m] = static_cast<std::uint32_t>(
          control_of(model_, tetrahedron_, model_.control.is_separate ? gamma : raised(gamma, m)));
    plan_.terms.push_back(term);
  }

  // Two products and two sums round less than 5 u of the sum of absolute values.
  RayNumber number_of(const Interval& at, const Interval& right, const Interval& down) const {
    const MidRad a = mid_rad(at), r = mid_rad(right), d = mid_rad(down);
    const double size =
        std::abs(a.mid) + std::abs(r.mid) * most_columns_ + std::abs(d.mid) * most_rows_;
    return {a.mid, r.mid, d.mid,
            paid(a.rad + r.rad * most_columns_ + d.rad * most_rows_ + 5 * kRayUnit * size)};
  }
  std::array<RayCoordinate, 4> coordinates_of(const GridFrame& frame) const {
    std::array<RayCoordinate, 4> out;
    for (std::size_t m = 0; m < 4; ++m) {
      const auto& row = frame.row[m];
      const MidRad along = mid_rad(row[3]);
      out[m] = {number_of(row[0], row[1], row[2]), along.mid, along.rad};
    }
    return out;
  }
  // Where the coordinate is zero.
  RayNumber crossing_of(const std::array<Interval, 4>& row) const {
    std::array<Interval, 3> t;
    {
      const ScopedUpward upward;
      for (std::size_t k = 0; k < 3; ++k) t[k] = -(row[k] / row[3]);
    }
    return number_of(t[0], t[1], t[2]);
  }
  RayCell cell_of(const GridFrame& frame) const {
    RayCell cell;
    std::array<std::vector<RayNumber>, 3> faces;  // entering, leaving, parallel
    for (const auto& row : frame.row) {
      const Sign3 sign = row[3].sign();
      if (sign == Sign3::kZero)
        faces[2].push_back(number_of(row[0], row[1], row[2]));
      else
        faces[sign == Sign3::kPositive ? 0 : 1].push_back(crossing_of(row));
    }
    auto place = cell.face.begin();
    for (const auto& list : faces) place = std::copy(list.begin(), list.end(), place);
    cell.num_in = static_cast<std::uint8_t>(faces[0].size());
    cell.num_out = static_cast<std::uint8_t>(faces[1].size());
    const MidRad height = mid_rad(frame.height);
    cell.height = height.mid;
    cell.height_error = height.rad;
    return cell;
  }

  bool set_range() {
    std::vector<const ExactPoint3*> points;
    const auto degree = static_cast<std::size_t>(model_.condition_degree());
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t i = 0; i <= degree; ++i)
        points.push_back(&table_.point(table_.knots().number[m][i]));
    const HullRange range = frames_.range(points);
    std::tie(plan_.first_column, plan_.end_column) = whole_range(range.side[0], grid_.columns);
    std::tie(plan_.first_row, plan_.end_row) = whole_range(range.side[1], grid_.rows);
    const double first = std::max(0.0, range.side[2].lo()),
                 last = std::min(1.0, range.side[2].hi());
    if (plan_.first_column >= plan_.end_column || plan_.first_row >= plan_.end_row ||
        !(first <= last))
      return false;
    most_columns_ = 1 + (plan_.end_column - plan_.first_column) / 2;
    most_rows_ = 1 + (plan_.end_row - plan_.first_row) / 2;
    plan_.centre_column = plan_.first_column + (plan_.end_column - plan_.first_column) / 2;
    plan_.centre_row = plan_.first_row + (plan_.end_row - plan_.first_row) / 2;
    plan_.centre = 0.5 * (first + last);
    plan_.radius = std::max(0.5 * (last - first) * 1.001, 0x1p-40);
    return true;
  }
  static std::pair<std::uint32_t, std::uint32_t> whole_range(const Interval& a, std::size_t size) {
    const auto whole = static_cast<double>(size);
    return {static_cast<std::uint32_t>(std::clamp(std::ceil(a.lo()), 0.0, whole)),
            static_cast<std::uint32_t>(std::clamp(std::floor(a.hi()) + 1, 0.0, whole))};
  }

  const DmsModel& model_;
  const DmsRayGrid& grid_;
  GridFrames& frames_;
  DmsTable& table_;
  const std::uint32_t tetrahedron_;
  std::map<std::array<KnotNumber, 4>, std::optional<GridFrame>> known_;
  std::unordered_map<KnotSet, std::int32_t, KnotSetHash> sets_;
  double most_columns_ = 1, most_rows_ = 1;  // from the centre of the range
  RayPlan plan_;
};

}  // namespace

RayClip clip_ray(const RayCell& cell, double i, double j, RaySpan& span) {
  double a = span.begin, b = span.end, most_a = a, least_b = b;
  const std::size_t out = cell.num_in, rest = out + cell.num_out;
  for (std::size_t f = 0; f < out; ++f) {
    const double t = cell.face[f].on(i, j);
    a = std::max(a, t);
    most_a = std::max(most_a, t + cell.face[f].error);
  }
  for (std::size_t f = out; f < rest; ++f) {
    const double t = cell.face[f].on(i, j);
    b = std::min(b, t);
    least_b = std::min(least_b, t - cell.face[f].error);
  }
  // The true bound a is at most most_a, and at least a minus the error of the face that gave a, which is at most
  // most_a - a; so with b.
  const double slack =
      1.0000001 * ((most_a - a) + (b - least_b)) + 8 * kRayUnit * (2 + std::abs(a) + std::abs(b));
  if (a - b > slack) return RayClip::kMiss;
  for (std::size_t f = rest; f < 4; ++f) {
    const double value = cell.face[f].on(i, j);
    if (value < -cell.face[f].error) return RayClip::kMiss;
    if (!(value > cell.face[f].error)) return RayClip::kUnsure;
  }
  span = {a, std::max(a, b), slack};
  return RayClip::kHit;
}

std::vector<RayPlan> make_ray_plans(const DmsModel& model, DmsEvaluator& evaluator,
                                    const DmsRayGrid& grid) {
  GridFrames frames(grid);
  std::vector<RayPlan> plans;
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
    if (auto plan = RayPlanBuilder(model, grid, frames, evaluator.table(t), t).build())
      plans.push_back(std::move(*plan));
  return plans;
}

}  // namespace veritope::internal
