// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "solids/micro/bridge/sweep_proposals_internal.h"

namespace veritope::internal {
namespace {

// Where a curve ends: at the point of the surface that is nearest to a point of the cap's normal, `ahead` times the
// distance of the surface, or the arm, from the cap; or where a ray along the normal, or along the cage's line, meets
// the surface.
enum class SweepAim : std::uint8_t { kDistances, kArms, kNormal, kAxis };
// Its middle point lies `lead` times as far off as in algorithm 4, along the normal; or, if lead is 0, halfway to the
// end. It is cut off where the cap is at `depth` times the skin from the surface.
struct SweepShape {
  SweepAim aim;
  double ahead, lead, depth;
};
// The first one is that of algorithm 4, with `ahead` = alpha.
constexpr std::array<SweepShape, kSweepTries> kSweepShapes = {{
    {SweepAim::kDistances, 0, 1, 0.1},
    {SweepAim::kNormal, 0, 0, 0.1},
    {SweepAim::kArms, 0.7, 0, 0.1},
    {SweepAim::kAxis, 0, 0, 0.1},
    {SweepAim::kArms, 1.2, 1, 0.1},
    {SweepAim::kDistances, 0, 0, 0.1},
    {SweepAim::kArms, 2, 0, 0.1},
    {SweepAim::kArms, 0.3, 0, 0.1},
    {SweepAim::kArms, 1.2, 0, 0.1},
    {SweepAim::kDistances, 0, 0.4, 0.1},
    {SweepAim::kArms, 0.7, 0.4, 0.1},
    {SweepAim::kArms, 3, 0, 0.1},
    {SweepAim::kNormal, 0, 0, 0.02},
    {SweepAim::kArms, 0.7, 0, 0.02},
    {SweepAim::kAxis, 0, 0, 0.02},
    {SweepAim::kDistances, 0, 0, 0.02},
}};
constexpr int kMostRaySteps = 48, kMostCuts = 24;
constexpr double kMostDepthArms = 0.2;

Rational dyadic_number(double x, int bits) {
  return Rational::from_double(std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits));
}

}  // namespace

SweepProposals::SweepProposals(const MeshSkin& skin, const BridgeOptions& options,
                               const SpaceCap& cap)
    : skin_(skin), options_(options), cap_(cap), distance_(skin.distance(cap.middle)) {}

// Steps along a ray from the cap's middle, none longer than the distance from the surface.
std::optional<Point3d> SweepProposals::hit_along(const Point3d& direction) const {
  double far = 0;
  for (int step = 0; step < kMostRaySteps; ++step) {
    const Point3d at = sum_of(cap_.middle, far, direction);
    const double distance = skin_.distance(at);
    if (distance <= 1e-3 * options_.skin || distance <= 1e-6 * far) return at;
    far += distance;
  }
  return std::nullopt;
}

std::optional<SweepProposals::Curve> SweepProposals::curve(int index) const {
  const SweepShape& shape = kSweepShapes[static_cast<std::size_t>(index)];
  std::optional<Point3d> end;
  if (shape.aim == SweepAim::kNormal || shape.aim == SweepAim::kAxis) {
    end = hit_along(shape.aim == SweepAim::kNormal ? cap_.normal : cap_.axis);
  } else {
    const double ahead =
        shape.aim == SweepAim::kArms ? shape.ahead * cap_.arm : options_.alpha * distance_;
    end = skin_.nearest(sum_of(cap_.middle, ahead, cap_.normal)).at;
  }
  if (!end) return std::nullopt;
  Curve out;
  out.end = sum_of(*end, -1, cap_.middle);
  const double reach = index == 0 ? distance_ : size_of(out.end);
  if (shape.lead > 0)
    out.middle = sum_of({}, shape.lead * options_.alpha * reach, cap_.normal);
  else
    out.middle = sum_of({}, 0.5, out.end);
  return drawn_back(out, shape.depth * std::min(options_.skin, kMostDepthArms * distance_));
}

double SweepProposals::least_depth(const Point3d& offset) const {
  double out = HUGE_VAL;
  for (const Point3d& p : cap_.samples) out = std::min(out, skin_.depth(sum_of(p, 1, offset)));
  return out;
}

// The part of the curve up to the parameter at which the samples are at least at the depth. Each step back is as long as
// what is missing, and no point comes nearer to the surface by more than the step.
std::optional<SweepProposals::Curve> SweepProposals::drawn_back(const Curve& whole,
                                                                double depth) const {
  double t = 1;
  for (int cut = 0; cut < kMostCuts; ++cut) {
    const Point3d at = sum_of(sum_of({}, 2 * t * (1 - t), whole.middle), t * t, whole.end);
    const double missing = depth - least_depth(at);
    if (missing <= 0.05 * depth) {
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

std::optional<MicroSweep> SweepProposals::propose(int index) const {
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
