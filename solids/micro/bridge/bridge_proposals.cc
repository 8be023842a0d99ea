// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "interval/box_geometry.h"
#include "solids/micro/bridge/bridge_proposals_internal.h"
#include "solids/micro/bridge/plain_vectors_internal.h"

namespace veritope::internal {
namespace {

// Where the end of a bridge is looked for: at the point of the surface that is nearest to a point of the cap's normal,
// `ahead` times the distance of the surface, or times the arm, from the cap; or along the line of the parameters.
enum class Aim : std::uint8_t { kDistances, kArms, kLine };
// The end has `size` times the size of the cap, turns by the part `turn` towards the tangent plane of the surface, and
// lies at `depth` times the skin from the surface, which counts as at most the cap's distance, and kMostDepth arms.
// The second list is `lead` times as far off as in algorithm 4.
struct EndShape {
  std::size_t target;
  double size, turn, depth, lead;
};
struct Target {
  Aim aim;
  double ahead;
};
// The first one is that of algorithm 4, with `ahead` = alpha.
constexpr std::array<Target, kBridgeTargets> kTargets = {{{Aim::kDistances, 0},
                                                          {Aim::kArms, 0.3},
                                                          {Aim::kArms, 0.7},
                                                          {Aim::kArms, 1.2},
                                                          {Aim::kArms, 2},
                                                          {Aim::kLine, 0}}};
constexpr std::array<EndShape, kBridgeTries> kEndShapes = {{
    {0, 1, 1, 0.25, 1},
    {2, 1, 1, 0.25, 1},
    {5, 1, 1, 0.25, 1},
    {3, 1, 1, 0.25, 1},
    {0, 0.6, 1, 0.25, 1},
    {1, 0.6, 1, 0.25, 0.6},
    {2, 0.6, 0.8, 0.4, 1},
    {3, 0.6, 0.8, 0.4, 1},
    {5, 0.6, 0.6, 0.4, 1},
    {4, 0.7, 0.8, 0.4, 1},
    {0, 0.4, 1, 0.2, 0.6},
    {1, 0.4, 0.7, 0.4, 0.4},
    {2, 0.4, 0.5, 0.4, 0.6},
    {3, 0.4, 0.5, 0.4, 1},
    {5, 0.4, 0.3, 0.6, 0.6},
    {2, 0.25, 0, 0.6, 0.6},
}};
constexpr double kMostDepth = 0.6;
constexpr int kMostMarchSteps = 32;

// v turned by the part `turn` of the rotation that takes the unit vector a to the unit vector b.
Point3d turned(const Point3d& v, const Point3d& a, const Point3d& b, double turn) {
  Point3d k = cross_product(a, b);
  const double sine = size_of(k), angle = turn * std::atan2(sine, dot_product(a, b));
  if (!(sine > 1e-12)) return v;
  k = unit_vector(k);
  const double c = std::cos(angle), s = std::sin(angle);
  const Point3d across = cross_product(k, v);
  const double along = dot_product(k, v) * (1 - c);
  Point3d out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = c * v[i] + s * across[i] + along * k[i];
  return out;
}

// The parameters whose image, by the linear map with these columns, is v.
Point3d pulled_back(const std::array<Point3d, 3>& columns, const Point3d& v) {
  const auto det = [](const Point3d& a, const Point3d& b, const Point3d& c) {
    return dot_product(a, cross_product(b, c));
  };
  const double whole = det(columns[0], columns[1], columns[2]);
  return {det(v, columns[1], columns[2]) / whole, det(columns[0], v, columns[2]) / whole,
          det(columns[0], columns[1], v) / whole};
}
Point3d pushed_forward(const std::array<Point3d, 3>& columns, const Point3d& o) {
  Point3d out{};
  for (std::size_t a = 0; a < 3; ++a) out = sum_of(out, o[a], columns[a]);
  return out;
}

Point3d nearest_point(const TilePoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}
Rational dyadic(double x, int bits) {
  return Rational::from_double(std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits));
}

}  // namespace

BridgeProposals::BridgeProposals(const SkinProjection& projection, const VolumeSpace& space,
                                 const BridgeOptions& options, const OpenCap& cap)
    : projection_(projection),
      space_(space),
      options_(options),
      cap_(cap),
      start_(space.place(cap.middle)) {
  if (!start_) return;
  const std::size_t a = cap.front.axis, b = (a + 1) % 3, c = (a + 2) % 3;
  axis_ = start_->partial[a];
  if (!cap.front.is_upward)
    for (double& x : axis_) x = -x;
  normal_ = unit_vector(cross_product(start_->partial[b], start_->partial[c]));
  if (dot_product(normal_, axis_) < 0)
    for (double& x : normal_) x = -x;
  distance_ = distance_to(start_->image);
}

double BridgeProposals::distance_to(const Point3d& p) const {
  return std::sqrt(std::max(0.0, approx_middle(projection_.squared_distance(exact_point(p)))));
}

std::optional<BridgeProposals::End> BridgeProposals::find_end(std::size_t target) const {
  const Target& to = kTargets[target];
  const double ahead = to.aim == Aim::kArms ? to.ahead * cap_.arm : options_.alpha * distance_;
  Point3d from = sum_of(start_->image, ahead, normal_);
  if (to.aim == Aim::kLine) {
    const auto here = end_of_line();
    if (!here) return std::nullopt;
    from = *here;
  }
  const SkinPoint skin = projection_.project(from);
  End out{skin.at, skin.normal, size_of(sum_of(skin.at, -1, start_->image))};
  if (target == 0) out.reach = distance_;
  return out;
}

// Steps along the line of the parameters that begins at the cap, each shorter than the distance from the surface.
std::optional<Point3d> BridgeProposals::end_of_line() const {
  double distance = distance_;
  ApproxPlace here = *start_;
  for (int step = 0; step < kMostMarchSteps && distance > options_.skin / 16; ++step) {
    Point3d to = here.at;
    const double length = size_of(here.partial[cap_.front.axis]);
    to[cap_.front.axis] += (cap_.front.is_upward ? 1 : -1) * 0.9 * distance / length;
    const std::optional<ApproxPlace> next = space_.place(to);
    if (!next) return std::nullopt;
    here = *next;
    distance = distance_to(here.image);
  }
  return here.image;
}

const std::optional<BridgeProposals::End>& BridgeProposals::end_of(std::size_t target) {
  auto& known = ends_[target];
  if (!known) known = find_end(target);
  return *known;
}

std::optional<MicroBridge> BridgeProposals::propose(int index) {
  if (!start_) return std::nullopt;
  const EndShape& how = kEndShapes[static_cast<std::size_t>(index)];
  const std::optional<End>& end = end_of(how.target);
  if (!end) return std::nullopt;
  const double depth = how.depth * std::min({options_.skin, kMostDepth * cap_.arm, distance_});
  const Point3d goal = sum_of(end->surface, -depth, end->normal);
  const auto place = space_.preimage(goal, start_->at);
  if (!place) return std::nullopt;
  return shape(*end, *place, how.size, how.turn, how.lead);
}

MicroBridge BridgeProposals::shape(const End& end, const ApproxPlace& place, double size,
                                   double turn, double lead) const {
  const std::size_t axis = cap_.front.axis;
  const int bits = 24 - std::ilogb(cap_.cell_size);
  Rational mu = dyadic(lead * options_.alpha * end.reach / size_of(axis_), bits);
  if (!cap_.front.is_upward) mu.negate();
  MicroBridge out;
  out.cap = cap_.cap;
  out.volume = cap_.front.volume;
  out.degrees = cap_.surface.degrees();
  const std::size_t count = cap_.surface.grid().count();
  for (std::size_t i = 0; i < count; ++i) {
    TilePoint row;
    for (std::size_t c = 0; c < 3; ++c) row[c] = cap_.surface.component(static_cast<int>(c))[i];
    out.points.push_back(row);
    Point3d offset = sum_of(nearest_point(row), -1, cap_.middle);
    row[axis] += mu;
    out.points.push_back(row);
    for (double& x : offset) x *= size;
    const Point3d in_space = pushed_forward(start_->partial, offset);
    offset = pulled_back(place.partial, turned(in_space, normal_, end.normal, turn));
    for (std::size_t c = 0; c < 3; ++c) row[c] = dyadic(place.at[c] + offset[c], bits);
    out.points.push_back(row);
  }
  return out;
}

}  // namespace veritope::internal
