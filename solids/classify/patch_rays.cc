// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_rays_internal.h"

#include <algorithm>

#include "solids/classify/sheet_net_internal.h"

namespace veritope::internal {
namespace {

constexpr int kRoundedLevels = 46;  // of 2^48 parameters
constexpr std::size_t kRoundedVisits = std::size_t{1} << 14;
constexpr std::size_t kExactVisits = std::size_t{1} << 20;
constexpr std::size_t kMostOpen = 4;
// On symmetric models some half-lines pass through ends of curves, so several are tried.
constexpr std::array<std::array<double, 2>, 3> kTurns{
    {{1, 0}, {0.8125, 0.59375}, {-0.375, 0.90625}}};

template <typename Net>
RayCount finish(RayDescent<Net>& descent, std::size_t num_turns) {
  RayCount out;
  if (descent.is_over_limit()) return out;
  if (!descent.open().empty()) {
    out.state = RayCount::State::kOpen;
    out.open = descent.open();
    return out;
  }
  for (std::size_t t = 0; t < num_turns; ++t)
    if (auto windings = descent.windings(kTurns[t])) {
      out.state = RayCount::State::kCounted;
      out.windings = std::move(*windings);
      return out;
    }
  return out;
}

}  // namespace

PatchRays::PatchRays(const PatchComplex& complex)
    : complex_(complex), scale_(scale_of(complex)), hull_(empty_box()) {
  std::vector<Box3d> boxes;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) {
    forms_.emplace_back(complex, p, scale_);
    boxes.push_back(tight_hull(forms_.back()));
    hull_ = veritope::hull(hull_, boxes.back());
  }
  boxes_ = BoxHierarchy(boxes);
}

std::uint64_t PatchRays::bytes() const {
  std::uint64_t sum = 0;
  for (const TensorForm& f : forms_)
    sum += sizeof(TensorForm) + 4 * f.count() * (sizeof(double) + sizeof(Integer));
  return sum;
}

AxisRay PatchRays::ray_from(const RayPoint& point) const {
  AxisRay out;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k)
    for (const bool is_upward : {true, false}) {
      const double c = point.rounded()[k];
      const double distance = is_upward ? hull_.hi[k] - c : c - hull_.lo[k];
      if (distance < least) least = distance, out = {k, is_upward};
    }
  return out;
}

template <typename Visit>
void PatchRays::visit_patches(const RayPoint& point, const AxisRay& ray, std::uint32_t shell,
                              Visit visit) const {
  const Box3d& q = point.box();
  const auto may_meet = [&](const Box3d& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_along = k == ray.axis;
      if (box.hi[k] < q.lo[k] && !(is_along && !ray.is_upward)) return false;
      if (box.lo[k] > q.hi[k] && !(is_along && ray.is_upward)) return false;
    }
    return true;
  };
  boxes_.visit(may_meet, [&](std::uint32_t patch) {
    if (shell == PatchComplex::kNone || complex_.shell(patch) == shell) visit(patch);
  });
}

RayCount PatchRays::count_rounded(const RayPoint& point, const AxisRay& ray,
                                  std::uint32_t shell) const {
  thread_local NetPool pool;
  RayDescent<RoundedNet> descent(complex_, ray, {kRoundedLevels, kRoundedVisits, kMostOpen});
  visit_patches(point, ray, shell, [&](std::uint32_t patch) {
    descent.add_patch(patch, RoundedNet(forms_[patch], point, pool));
  });
  return finish(descent, kTurns.size());
}

RayCount PatchRays::count_exactly(const RayPoint& point, const AxisRay& ray, int levels,
                                  std::uint32_t shell) const {
  RayDescent<ExactNet> descent(complex_, ray, {levels, kExactVisits, kMostOpen});
  visit_patches(point, ray, shell, [&](std::uint32_t patch) {
    descent.add_patch(patch, ExactNet(forms_[patch], point));
  });
  return finish(descent, 1);
}

}  // namespace veritope::internal
