// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/patch_classifier.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "solids/classify/flat_place_internal.h"
#include "solids/classify/patch_foot_internal.h"
#include "solids/classify/patch_octree_internal.h"
#include "solids/classify/patch_rays.h"

namespace veritope {

using namespace internal;

namespace {

constexpr std::size_t kChunkOfPatchPoints = 256;
constexpr int kBitsOfCondition =
    24;  // by which parameters are worse known than the point's distance
constexpr std::size_t kMostFeet = 32;
constexpr int kFirstRefined = 160, kMostBits = 2560;
constexpr int kBitsOfBox = 130;  // the width of a box of parameters
constexpr int kFirstBits = 36;  // how far the middles of the smallest rounded pieces can be trusted

AlgebraicPair as_algebraic(const std::array<Rational, 2>& uv) {
  AlgebraicPair out;
  for (std::size_t k = 0; k < 2; ++k)
    out.numbers[k] = {{-uv[k].numerator(), uv[k].denominator()}, uv[k], uv[k]};
  return out;
}

}  // namespace

class PatchClassifier::Body {
 public:
  Body(const PatchComplex& complex, bool is_valid, bool has_shells, int levels)
      : complex_(complex),
        rays_(complex),
        is_valid_(is_valid),
        has_shells_(has_shells),
        depths_(find_depths()),
        octree_(
            rays_, [this](const RayPoint& q) { return label_at(q); }, levels) {}

  template <typename Point>
  PointAnswer classify(const Point& p, std::optional<OnPatch>* where,
                       Search search = Search::kShort) const {
    if (where != nullptr) where->reset();
    const RayPoint q(p, rays_.scale());
    if (!meets(q.box(), rays_.hull())) return {};
    if (const RegionLabel* const label = octree_.find(q)) return answer(*label);
    return by_ray(q, where, search);
  }

  Value3 value(const Box3d& box) const {
    // Both ends divided, and rounded outward where that is not exact.
    const RayPoint lo({box.lo[0], box.lo[1], box.lo[2]}, rays_.scale()),
        hi({box.hi[0], box.hi[1], box.hi[2]}, rays_.scale());
    const Box3d divided{lo.box().lo, hi.box().hi};
    if (!meets(divided, rays_.hull())) return Value3::kZero;
    if (const auto known = octree_.value(divided)) return *known;
    if (!rays_.misses(divided)) return Value3::kMixed;
    const PointAnswer a = classify(Vec3d{box.lo[0], box.lo[1], box.lo[2]}, nullptr);
    if (!a.is_decided || a.is_on()) return Value3::kMixed;
    return to_value(a.winding != 0);
  }
  Box3d box() const {
    Box3d out;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational unit = Rational::power_of_two(rays_.scale());
      out.lo[k] = round_down(Rational::from_double(rays_.hull().lo[k]) * unit);
      out.hi[k] = round_up(Rational::from_double(rays_.hull().hi[k]) * unit);
    }
    return out;
  }

  LookupSize lookup() const {
    LookupSize out = octree_.size();
    out.bytes += rays_.bytes();
    return out;
  }

  const std::vector<std::uint32_t>& depths() const { return depths_; }

  // The label at a point; nothing if it is not known to be off the surface.
  std::optional<RegionLabel> label_at(const RayPoint& q) const {
    const RayCount count = count_rounded(q);
    if (count.state != RayCount::State::kCounted) return std::nullopt;
    return label_of(count.windings);
  }

 private:
  RayCount count_rounded(const RayPoint& q) const {
    return rays_.count_rounded(q, rays_.ray_from(q));
  }

  std::vector<std::uint32_t> find_depths() const {
    if (!has_shells_) return {};
    std::vector<std::uint32_t> out(complex_.shells().size());
    if (out.size() < 2) return out;
    for (std::uint32_t s = 0; s < out.size(); ++s) {
      const auto corner = point_of(complex_.patch(complex_.shells()[s].first_patch).corner(0));
      const RayPoint q(*corner, rays_.scale());
      for (std::uint32_t t = 0; t < out.size(); ++t)
        if (t != s && is_around(t, q)) ++out[s];
    }
    return out;
  }
  bool is_around(std::uint32_t shell, const RayPoint& q) const {
    const AxisRay ray = rays_.ray_from(q);
    RayCount count = rays_.count_rounded(q, ray, shell);
    // Shells of a valid model have a positive distance.
    for (int levels = 64; count.state != RayCount::State::kCounted; levels *= 2) {
      VT_CHECK(levels < (1 << 16), "two shells of a valid model are closer than 2^-65536");
      count = rays_.count_exactly(q, ray, levels, shell);
    }
    return !count.windings.empty();
  }

  RegionLabel label_of(const ShellWindings& windings) const {
    RegionLabel out{0, kNowhere};
    for (const auto& [shell, winding] : windings) {
      out.winding += winding;
      if (has_shells_ && (out.chain == kNowhere || depths_[shell] > depths_[out.chain]))
        out.chain = shell;
    }
    return out;
  }
  PointAnswer answer(const RegionLabel& label) const {
    return {label.winding, kNowhere, label.chain, true};
  }

  struct Foot {
    std::uint32_t patch;
    PatchFoot search;
  };
  void add_feet(const std::vector<OpenPiece>& pieces, const RayPoint& q,
                std::vector<Foot>& feet) const {
    for (const OpenPiece& piece : pieces)
      feet.push_back({piece.patch, PatchFoot(rays_.form(piece.patch), q, piece.middle)});
  }

  // What flat patches near a point say.
  struct FlatPatches {
    std::vector<std::uint32_t> settled;  // the point is off them
    std::vector<std::uint32_t> off;      // those in whose planes it is
    std::optional<AlgebraicPair>
        border;  // its parameters, if it is on the border of the patch that holds it
  };
  static bool is_in(const std::vector<std::uint32_t>& patches, std::uint32_t patch) {
    return std::find(patches.begin(), patches.end(), patch) != patches.end();
  }

  // The first flat patch of the pieces that holds the point: POINT-4.
  std::optional<std::uint32_t> look_at_flat(const std::vector<OpenPiece>& pieces, const RayPoint& q,
                                            FlatPatches& out) const {
    const RayPoint::Fractions fractions = q.fractions();
    for (const OpenPiece& piece : pieces) {
      const TensorForm& form = rays_.form(piece.patch);
      if (!form.plane || is_in(out.settled, piece.patch)) continue;
      const bool is_in_plane = side_of(*form.plane, fractions) == 0;
      if (is_in_plane) {
        FlatPlace::OfBorder border = FlatPlace(form, q).border();
        out.border = std::move(border.parameters);
        if (out.border || border.winding != 0) return piece.patch;
        if (!is_valid_) continue;
        out.off.push_back(piece.patch);
      }
      out.settled.push_back(piece.patch);
    }
    return std::nullopt;
  }

  // The parameters of a point inside of a flat patch: numbers that are known, otherwise a box.
  AlgebraicPair parameters_inside(std::uint32_t patch, const RayPoint& q, std::vector<Foot>& feet,
                                  Search search) const {
    AlgebraicPair out;
    for (AlgebraicNumber& number : out.numbers) number = {{}, 0, 1};
    std::erase_if(feet, [&](const Foot& foot) { return foot.patch != patch; });
    const int most = search == Search::kLong ? 4 * kFirstRefined : kFirstRefined;
    for (int bits = kFirstRefined; bits <= most; bits *= 4)
      for (Foot& foot : feet) {
        if (!foot.search.refine(bits)) continue;
        if (auto uv = foot.search.exact_parameters(bits - kBitsOfCondition))
          return as_algebraic(*uv);
        if (auto uv = foot.search.irrational_parameters(bits - kBitsOfCondition))
          return std::move(*uv);
      }
    const FlatPlace place(rays_.form(patch), q);
    const Dyadic reach(1, -kBitsOfBox), zero(0), one(1);
    for (const Foot& foot : feet) {
      std::array<Dyadic, 2> lo, hi;
      for (std::size_t k = 0; k < 2; ++k) {
        lo[k] = std::max(foot.search.parameters()[k] - reach, zero);
        hi[k] = std::min(foot.search.parameters()[k] + reach, one);
      }
      if (!(lo[0] < hi[0]) || !(lo[1] < hi[1]) || !place.is_inside(lo, hi)) continue;
      for (std::size_t k = 0; k < 2; ++k)
        out.numbers[k] = {{}, lo[k].to_rational(), hi[k].to_rational()};
      return out;
    }
    return out;
  }

  PointAnswer by_ray(const RayPoint& q, std::optional<OnPatch>* where, Search search) const {
    RayCount count = count_rounded(q);
    if (count.state == RayCount::State::kCounted) return answer(label_of(count.windings));
    if (count.state == RayCount::State::kLost)
      count = rays_.count_exactly(q, rays_.ray_from(q), 48);
    if (count.state == RayCount::State::kCounted) return answer(label_of(count.windings));
    std::vector<Foot> feet;
    for (const OpenPiece& piece : count.open)
      if (auto uv = PatchFoot::at_collapsed_side(rays_.form(piece.patch), q))
        return on(piece.patch, as_algebraic(*uv), where);
    add_feet(count.open, q, feet);
    for (const Foot& foot : feet)
      if (auto uv = foot.search.exact_parameters(kFirstBits))
        return on(foot.patch, as_algebraic(*uv), where);
    FlatPatches flat;
    if (const auto patch = look_at_flat(count.open, q, flat)) {
      if (where != nullptr && !flat.border)
        flat.border = parameters_inside(*patch, q, feet, search);
      return on(*patch, flat.border ? std::move(*flat.border) : AlgebraicPair(), where);
    }
    std::erase_if(feet, [&](const Foot& foot) { return is_in(flat.settled, foot.patch); });
    const AxisRay ray = rays_.ray_from(q, flat.off);
    for (int bits = kFirstRefined; bits <= kMostBits; bits *= 4) {
      bool may_be_on = false;
      for (Foot& foot : feet) {
        if (!foot.search.refine(bits)) continue;
        may_be_on = true;
        if (auto uv = foot.search.exact_parameters(bits - kBitsOfCondition))
          return on(foot.patch, as_algebraic(*uv), where);
        if (auto uv = foot.search.irrational_parameters(bits - kBitsOfCondition))
          return on(foot.patch, std::move(*uv), where);
      }
      const RayCount exact =
          rays_.count_exactly(q, ray, may_be_on ? bits / 4 : bits, PatchComplex::kNone, flat.off);
      if (exact.state == RayCount::State::kCounted) return answer(label_of(exact.windings));
      // Where doubles say little, as far from the origin, integers know better where to search.
      if (feet.size() < kMostFeet) add_feet(exact.open, q, feet);
    }
    PointAnswer out;
    out.is_decided = false;
    return out;
  }

  PointAnswer on(std::uint32_t patch, AlgebraicPair uv, std::optional<OnPatch>* where) const {
    if (where != nullptr) *where = OnPatch{patch, std::move(uv)};
    return {0, patch, has_shells_ ? complex_.shell(patch) : kNowhere, true};
  }

  const PatchComplex& complex_;
  PatchRays rays_;
  bool is_valid_, has_shells_;
  std::vector<std::uint32_t> depths_;
  PatchOctree octree_;
};

PatchClassifier::PatchClassifier(std::unique_ptr<const Body> body) : body_(std::move(body)) {}
PatchClassifier::PatchClassifier(PatchClassifier&&) noexcept = default;
PatchClassifier::~PatchClassifier() = default;

PatchClassifier PatchClassifier::make(const PatchComplex& complex, bool has_shells, int levels) {
  VT_CHECK(complex.is_closed_oriented_surface(), "points need a closed oriented surface");
  const ScopedDefaultFp nearest;
  return PatchClassifier(std::make_unique<const Body>(complex, has_shells, has_shells, levels));
}

PatchClassifier PatchClassifier::of_valid_model(const PatchComplex& complex, int levels) {
  VT_CHECK(complex.is_closed_oriented_surface(), "points need a closed oriented surface");
  const ScopedDefaultFp nearest;
  return PatchClassifier(std::make_unique<const Body>(complex, true, false, levels));
}

PointAnswer PatchClassifier::classify(const Vec3d& point, std::optional<OnPatch>* where,
                                      Search search) const {
  const ScopedDefaultFp nearest;
  return body_->classify(point, where, search);
}
PointAnswer PatchClassifier::classify(const ExactPoint& point, std::optional<OnPatch>* where,
                                      Search search) const {
  const ScopedDefaultFp nearest;
  return body_->classify(point, where, search);
}

void PatchClassifier::classify(std::span<const Vec3d> points, std::span<PointAnswer> answers,
                               unsigned jobs) const {
  parallel_for(points.size(), kChunkOfPatchPoints, jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 const ScopedDefaultFp nearest;
                 for (std::size_t i = begin; i < end; ++i)
                   answers[i] = body_->classify(points[i], nullptr);
               });
}

Value3 PatchClassifier::value(const Box3d& box) const {
  const ScopedDefaultFp nearest;
  return body_->value(box);
}
Box3d PatchClassifier::box() const { return body_->box(); }
const std::vector<std::uint32_t>& PatchClassifier::depths() const { return body_->depths(); }

LookupSize PatchClassifier::lookup() const { return body_->lookup(); }

}  // namespace veritope
