// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "solids/micro/bridge/sweep_proposals_internal.h"

namespace veritope::internal {
namespace {

// Where a curve ends: at the point of the surface that is nearest to a point of the cap's normal, `ahead` times the
// distance of the surface, or the arm, from the cap; or where a ray along the cage's line meets the surface, or one
// of the rays around the normal: those where the surface is nearly parallel to the cap.
enum class SweepAim : std::uint8_t { kDistances, kArms, kAxis, kRays };
// Its middle point is that of algorithm 4 (kFull); or it lies along the normal, as far off as alpha times the way of
// the end along it (kNormal), or halfway to the end (kStraight). `ahead` is the number of the ray if it is one of
// these.
enum class SweepLead : std::uint8_t { kFull, kNormal, kStraight };
struct SweepShape {
  SweepAim aim;
  double ahead;
  SweepLead lead;
};
// The first one is that of algorithm 4, with `ahead` = alpha.
constexpr std::array<SweepShape, kSweepTries> kSweepShapes = {{
    {SweepAim::kDistances, 0, SweepLead::kFull},
    {SweepAim::kArms, 1.2, SweepLead::kNormal},
    {SweepAim::kRays, 0, SweepLead::kNormal},
    {SweepAim::kArms, 0.5, SweepLead::kNormal},
    {SweepAim::kRays, 1, SweepLead::kNormal},
    {SweepAim::kAxis, 0, SweepLead::kStraight},
    {SweepAim::kRays, 2, SweepLead::kNormal},
    {SweepAim::kRays, 0, SweepLead::kStraight},
    {SweepAim::kRays, 3, SweepLead::kNormal},
    {SweepAim::kDistances, 0, SweepLead::kStraight},
    {SweepAim::kRays, 4, SweepLead::kNormal},
    {SweepAim::kRays, 1, SweepLead::kStraight},
    {SweepAim::kRays, 5, SweepLead::kNormal},
    {SweepAim::kRays, 2, SweepLead::kStraight},
    {SweepAim::kRays, 6, SweepLead::kNormal},
    {SweepAim::kRays, 3, SweepLead::kStraight},
}};
// The cap ends at this part of the skin from the surface, where it is nearest.
constexpr double kLeastDepth = 0.1;
// How far the middle point may go along the normal, of the end's way.
constexpr double kMostLead = 0.8;
// Rays around the normal, by their slopes.
constexpr std::array<double, 4> kRaySlopes = {0, 0.35, 0.75, 1.3};
constexpr int kRaysOfSlope = 8;  // of each slope
constexpr double kFullTurn = 6.28318530717959;
constexpr int kMostRaySteps = 48, kMostCuts = 24;

Rational dyadic_number(double x, int bits) {
  return Rational::from_double(std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits));
}

}  // namespace

SweepProposals::SweepProposals(const SkinProjection& skin, const BridgeOptions& options,
                               const SpaceCap& cap)
    : skin_(skin), options_(options), cap_(cap), distance_(approx_distance(skin, cap.middle)) {}

// Steps along a ray from the cap's middle, none longer than the distance from the surface.
std::optional<Point3d> SweepProposals::hit_along(const Point3d& direction) const {
  double far = 0;
  for (int step = 0; step < kMostRaySteps; ++step) {
    const Point3d at = sum_of(cap_.middle, far, direction);
    const double distance = approx_distance(skin_, at);
    if (distance <= 1e-3 * options_.skin || distance <= 1e-6 * far) return at;
    far += distance;
  }
  return std::nullopt;
}

// How much nearer to a plane with this normal one sample is than another one.
double SweepProposals::tilt(const Point3d& normal) const {
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (const Point3d& p : cap_.samples) {
    lo = std::min(lo, dot_product(normal, p));
    hi = std::max(hi, dot_product(normal, p));
  }
  return hi - lo;
}

// The hits of rays at which the cap would be within the skin, those nearest to the normal first.
const std::vector<Point3d>& SweepProposals::hits() {
  if (hits_) return *hits_;
  hits_.emplace();
  Point3d across = cross_product(cap_.normal, {1, 0, 0});
  if (std::abs(cap_.normal[0]) > 0.8) across = cross_product(cap_.normal, {0, 1, 0});
  across = unit_vector(across);
  const Point3d other = cross_product(cap_.normal, across);
  for (const double slope : kRaySlopes)
    for (int ray = 0; ray < (slope > 0 ? kRaysOfSlope : 1); ++ray) {
      const double angle = kFullTurn * ray / kRaysOfSlope;
      const Point3d way = sum_of(sum_of(cap_.normal, slope * std::cos(angle), across),
                                 slope * std::sin(angle), other);
      const auto hit = hit_along(unit_vector(way));
      if (hit && tilt(skin_.project(*hit).normal) < (1 - kLeastDepth) * options_.skin)
        hits_->push_back(*hit);
    }
  return *hits_;
}

std::optional<Point3d> SweepProposals::end_of(std::size_t aim, double ahead) {
  switch (static_cast<SweepAim>(aim)) {
    case SweepAim::kAxis: return hit_along(cap_.axis);
    case SweepAim::kRays: {
      const auto number = static_cast<std::size_t>(ahead);
      return number < hits().size() ? std::optional(hits()[number]) : std::nullopt;
    }
    case SweepAim::kArms: ahead *= cap_.arm; break;
    case SweepAim::kDistances: ahead = options_.alpha * distance_; break;
  }
  return skin_.project(sum_of(cap_.middle, ahead, cap_.normal)).at;
}

std::optional<SweepProposals::Curve> SweepProposals::curve(int index) {
  const SweepShape& shape = kSweepShapes[static_cast<std::size_t>(index)];
  const auto end = end_of(static_cast<std::size_t>(shape.aim), shape.ahead);
  if (!end) return std::nullopt;
  Curve out;
  out.end = sum_of(*end, -1, cap_.middle);
  const double way = dot_product(out.end, cap_.normal);
  if (shape.lead == SweepLead::kFull)
    out.middle = sum_of({}, options_.alpha * distance_, cap_.normal);
  else if (shape.lead == SweepLead::kNormal)
    out.middle = sum_of({}, std::min(options_.alpha, kMostLead) * way, cap_.normal);
  else
    out.middle = sum_of({}, 0.5, out.end);
  return drawn_back(out, kLeastDepth * std::min(options_.skin, distance_));
}

// The least and the greatest depth of a sample that is moved by the offset.
std::array<double, 2> SweepProposals::depths(const Point3d& offset) const {
  std::array<double, 2> out = {HUGE_VAL, -HUGE_VAL};
  for (const Point3d& p : cap_.samples) {
    const double depth = approx_depth(skin_, sum_of(p, 1, offset));
    out = {std::min(out[0], depth), std::max(out[1], depth)};
  }
  return out;
}

// The part of the curve up to the parameter at which the samples are at least at the depth. Each step back is as long
// as what is missing, and no point comes nearer to the surface by more than the step.
std::optional<SweepProposals::Curve> SweepProposals::drawn_back(const Curve& whole,
                                                                double depth) const {
  double t = 1;
  for (int cut = 0; cut < kMostCuts; ++cut) {
    const Point3d at = sum_of(sum_of({}, 2 * t * (1 - t), whole.middle), t * t, whole.end);
    const auto [least, greatest] = depths(at);
    const double missing = depth - least;
    if (missing <= 0.05 * depth) {
      if (!(greatest < options_.skin)) return std::nullopt;
      Curve out;
      out.middle = sum_of({}, t, whole.middle);
      out.end = at;
      return out;
    }
    const Point3d slope = sum_of(sum_of({}, 2 * (1 - 2 * t), whole.middle), 2 * t, whole.end);
    t -= missing / size_of(slope);
    if (!(t > 0.05)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<MicroSweep> SweepProposals::propose(int index) {
  const std::optional<Curve> found = curve(index);
  if (!found) return std::nullopt;
  const int bits = 24 - std::ilogb(cap_.arm);
  MicroSweep out;
  out.cap = cap_.cap;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(found->middle[c]) || !std::isfinite(found->end[c])) return std::nullopt;
    out.axis[0][c] = dyadic_number(found->middle[c], bits);
    out.axis[1][c] = dyadic_number(found->end[c], bits);
  }
  return out;
}

}  // namespace veritope::internal
