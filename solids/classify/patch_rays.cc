// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/classify/flat_place_internal.h"
#include "solids/classify/ray_descent_internal.h"
#include "solids/classify/sheet_net_internal.h"

namespace veritope {

using namespace internal;

namespace {

constexpr int kRoundedLevels = 46;  // of 2^48 parameters
constexpr std::size_t kRoundedVisits = std::size_t{1} << 14;
constexpr std::size_t kExactVisits = std::size_t{1} << 17;
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

namespace {

std::vector<TensorForm> forms_of(const PatchComplex& complex, int scale) {
  std::vector<TensorForm> out;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p) out.emplace_back(complex, p, scale);
  return out;
}

}  // namespace

PatchRays::PatchRays(const PatchComplex& complex, int scale)
    : PatchRays(forms_of(complex, scale), scale) {}
PatchRays::PatchRays(const PatchComplex& complex) : PatchRays(complex, scale_of(complex)) {}

PatchRays::PatchRays(std::vector<TensorForm> forms, int scale)
    : scale_(scale), forms_(std::move(forms)), hull_(empty_box()) {
  for (const TensorForm& form : forms_) {
    boxes_of_patches_.push_back(tight_hull(form));
    hull_ = veritope::hull(hull_, boxes_of_patches_.back());
  }
  boxes_ = BoxHierarchy(boxes_of_patches_);
}

std::uint64_t PatchRays::bytes() const {
  std::uint64_t sum = 0;
  for (const TensorForm& f : forms_)
    sum += sizeof(TensorForm) + 4 * f.count() * (sizeof(double) + sizeof(Integer));
  return sum;
}

namespace {

// Pieces of one patch against a box.
class BoxDescent {
 public:
  explicit BoxDescent(const Box3d& box) : box_(box) {}
  bool misses(SheetNet net, int halvings = kMostHalvingsOfFlat) {
    const Box3d hull = net.hull();
    if (!meets(hull, box_)) return true;
    const Slab slab = slab_of(net);
    if (slab.is_beside_box) return true;
    if (slab.is_thin) --halvings;
    // A piece inside of the box, or small or flat beside it, that is not known to miss it.
    if (is_inside(hull, box_) || extent(hull) < extent(box_) / 16 || halvings < 0 ||
        --pieces_left_ < 0)
      return false;
    SheetNet right = net.halve(net.length(0) >= net.length(1) ? 0 : 1);
    return misses(std::move(net), halvings) && misses(std::move(right), halvings);
  }

 private:
  // A piece in the plane of the box, so to speak, misses it only beyond its own border, and after some halvings only if
  // it is as near to the border as that.
  static constexpr int kMostHalvingsOfFlat = 16;
  static constexpr double kThin = 64;

  // The space between two planes across the piece's mean normal that holds the piece.
  struct Slab {
    bool is_beside_box = false;  // misses the box
    bool is_thin = false;        // not much thicker than the box, or than rounding: halves are hardly farther from it
  };
  Slab slab_of(const SheetNet& net) const {
    const Point3d n = net.normal();
    const auto range = net.range_along(n);
    double least = 0, most = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = n[k] * box_.lo[k], b = n[k] * box_.hi[k];
      least += std::min(a, b);
      most += std::max(a, b);
      size += std::max(std::abs(a), std::abs(b));
    }
    const double bound = plane_bound(0, size);
    return {least - bound > range[1] || most + bound < range[0],
            range[1] - range[0] <= kThin * (most - least + bound)};
  }

  const Box3d& box_;
  int pieces_left_ = 1000;
};

}  // namespace

bool PatchRays::misses(const Box3d& box) const {
  BoxDescent descent(box);
  bool misses = true;
  boxes_.visit([&](const Box3d& b) { return misses && meets(b, box); },
               [&](std::uint32_t patch) { misses = descent.misses(SheetNet(forms_[patch])); });
  return misses;
}

bool PatchRays::misses(const Box3d& box, std::uint32_t first, std::uint32_t last) const {
  BoxDescent descent(box);
  for (std::uint32_t p = first; p < last; ++p)
    if (meets(boxes_of_patches_[p], box) && !descent.misses(SheetNet(forms_[p]))) return false;
  return true;
}

AxisRay PatchRays::ray_from(const RayPoint& point, std::span<const std::uint32_t> off) const {
  AxisRay out;
  double least = std::numeric_limits<double>::infinity();
  bool is_across = false;
  for (std::size_t k = 0; k < 3; ++k)
    for (const bool is_upward : {true, false}) {
      const double c = point.rounded()[k];
      const double distance = is_upward ? hull_.hi[k] - c : c - hull_.lo[k];
      const AxisRay ray{k, is_upward};
      const bool passes = std::all_of(off.begin(), off.end(), [&](std::uint32_t patch) {
        return passes_through(*forms_[patch].plane, ray);
      });
      if (passes < is_across || (passes == is_across && !(distance < least))) continue;
      least = distance;
      is_across = passes;
      out = ray;
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
    if (shell == PatchComplex::kNone || forms_[patch].shell == shell) visit(patch);
  });
}

RayCount PatchRays::count_rounded(const RayPoint& point, const AxisRay& ray,
                                  std::uint32_t shell) const {
  thread_local NetPool pool;
  RayDescent<RoundedNet> descent(ray, {kRoundedLevels, kRoundedVisits, kMostOpen});
  visit_patches(point, ray, shell, [&](std::uint32_t patch) {
    descent.add_patch(patch, RoundedNet(forms_[patch], point, pool));
  });
  return finish(descent, kTurns.size());
}

namespace {

// How a flat patch lies to the line of the ray: it meets it in one point of the plane, if at all.
RayPlace place_of_patch(const TensorForm& form, const RayPoint::Fractions& q, const AxisRay& ray,
                        bool is_known_off) {
  if (!form.plane) return RayPlace::kUnknown;
  const Sign side = side_of(*form.plane, q);
  if (side != 0) return place_beside(*form.plane, side, ray);
  return is_known_off && passes_through(*form.plane, ray) ? RayPlace::kMissesRay
                                                          : RayPlace::kUnknown;
}

}  // namespace

RayCount PatchRays::count_exactly(const RayPoint& point, const AxisRay& ray, int levels,
                                  std::uint32_t shell, std::span<const std::uint32_t> off) const {
  RayDescent<ExactNet> descent(ray, {levels, kExactVisits, kMostOpen});
  const RayPoint::Fractions q = point.fractions();
  visit_patches(point, ray, shell, [&](std::uint32_t patch) {
    const bool is_known_off = std::find(off.begin(), off.end(), patch) != off.end();
    descent.add_patch(patch, ExactNet(forms_[patch], point),
                      place_of_patch(forms_[patch], q, ray, is_known_off));
  });
  return finish(descent, 1);
}

RayCount PatchRays::count_some(const RayPoint& point, std::uint32_t first, std::uint32_t last,
                               int levels) const {
  const AxisRay ray = ray_from(point);
  thread_local NetPool pool;
  RayDescent<RoundedNet> rounded(ray, {kRoundedLevels, kRoundedVisits, kMostOpen});
  for (std::uint32_t p = first; p < last; ++p)
    rounded.add_patch(p, RoundedNet(forms_[p], point, pool));
  RayCount out = finish(rounded, kTurns.size());
  if (out.state == RayCount::State::kCounted) return out;
  RayDescent<ExactNet> exact(ray, {levels, kExactVisits, kMostOpen});
  const RayPoint::Fractions q = point.fractions();
  for (std::uint32_t p = first; p < last; ++p)
    exact.add_patch(p, ExactNet(forms_[p], point), place_of_patch(forms_[p], q, ray, false));
  return finish(exact, 1);
}

}  // namespace veritope
