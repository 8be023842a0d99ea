// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/synthesis/cage_around.h"

#include <memory>
#include <utility>
#include <vector>

#include "solids/classify/patch_classifier.h"
#include "solids/vmodel/v_faces.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

constexpr int kFirstRounds = 2, kLastRounds = 5;
constexpr std::size_t kMostParts = 100'000;
constexpr int kSamples = 8;  // along an axis of a patch

// The border of a cage, proved to bound a solid: a point is inside iff it is off the border and its winding number is
// not 0.
class CageBorder {
 public:
  static Result<CageBorder> of(const VModel& cage) {
    Result<std::vector<Patch>> patches = patches_of(border_of(cage));
    if (!patches) return patches.error();
    Result<PatchComplex> complex = make_patch_complex(std::move(*patches), PatchOrientation::kKeep);
    if (!complex) return complex.error();
    CageBorder out;
    out.complex_ = std::make_unique<const PatchComplex>(std::move(*complex));
    if (out.complex_->is_closed_oriented_surface())
      out.classifier_.emplace(PatchClassifier::of_valid_model(*out.complex_));
    return out;
  }
  // False only for a point on the border or outside.
  template <typename Point>
  bool may_contain(const Point& point) const {
    if (!classifier_) return true;
    const PointAnswer answer = classifier_->classify(point);
    return !answer.is_decided || (!answer.is_on() && answer.winding != 0);
  }

 private:
  std::unique_ptr<const PatchComplex> complex_;
  std::optional<PatchClassifier> classifier_;
};

// A point of the patch, on a grid of parameters, which the border does not contain.
std::optional<PatchPoint> point_outside(const CageBorder& border, const Patch& patch) {
  const Patch::Tensor map =
      patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; j <= kSamples; ++j) {
      const auto p = point_of(evaluate<Rational, 2>(
          map, {Rational(i) / Rational(kSamples), Rational(j) / Rational(kSamples)}));
      if (p && !border.may_contain(*p)) return p;
    }
  return std::nullopt;
}

std::size_t num_parts(std::span<const Patch> patches, int rounds) {
  std::size_t out = 0;
  for (const Patch& p : patches) out += num_content_parts(p, rounds);
  return out;
}

// The patch of which a part of the content is one.
std::uint32_t owner_of(std::size_t part, std::span<const Patch> patches, int rounds) {
  std::uint32_t out = 0;
  for (std::size_t end = num_content_parts(patches[0], rounds); end <= part;)
    end += num_content_parts(patches[++out], rounds);
  return out;
}

}  // namespace

Result<std::optional<CageEscape>> find_escape(const VModel& cage, const TriangleMesh& mesh) {
  const std::optional<CageGap> gap = find_gap(cage, content_of(mesh));
  if (!gap) return std::optional<CageEscape>();
  CageEscape out{static_cast<std::uint32_t>(gap->part), std::nullopt, gap->face};
  const Result<CageBorder> border = CageBorder::of(cage);
  if (!border) return border.error();
  for (const std::uint32_t v : mesh.faces[out.triangle])
    if (!border->may_contain(mesh.positions[v])) {
      out.vertex = v;
      break;
    }
  return std::optional(out);
}

Result<std::optional<PatchEscape>> find_escape(const VModel& cage, std::span<const Patch> patches) {
  std::optional<CageBorder> border;
  PatchEscape out;
  for (int rounds = kFirstRounds; rounds <= kLastRounds; ++rounds) {
    if (rounds > kFirstRounds && num_parts(patches, rounds) > kMostParts) break;
    const std::optional<CageGap> gap = find_gap(cage, content_of(patches, rounds));
    if (!gap) return std::optional<PatchEscape>();
    if (!border) {
      Result<CageBorder> made = CageBorder::of(cage);
      if (!made) return made.error();
      border.emplace(std::move(*made));
    }
    out = {owner_of(gap->part, patches, rounds), std::nullopt, gap->face};
    out.point = point_outside(*border, patches[out.patch]);
    if (out.point) break;
  }
  return std::optional(out);
}

}  // namespace veritope
