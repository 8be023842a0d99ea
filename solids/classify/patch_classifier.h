// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_classifier.h: is a point in, on or out of a closed complex of patches? Exactly.
// Theory: docs/THEORY.md, POINT-3 and POINT-4.  Design: docs/design/0056-points-of-patches.md.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/box3d.h"
#include "solids/classify/algebraic_number.h"
#include "solids/classify/lookup_size.h"
#include "solids/classify/point_answer.h"
#include "solids/classify/value3.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// Where a point lies on a patch: exactly, its map takes the parameters to the point.
struct OnPatch {
  std::uint32_t patch = 0;
  /// (u, v) of a tensor patch; for a triangle those of S(u, v) = map(1 - u, u (1 - v), u v), whose map has barycentric
  /// coordinates.
  AlgebraicPair parameters;
};

/// Answers for points with respect to one complex. Immutable: threads may share it.
/// The winding number is that of the closed oriented surface. PointAnswer::facet is the number of a patch: if the point
/// lies on several, one of them, always the same.
class PatchClassifier {
 public:
  /// @param has_shells  the model is valid: answers name the innermost shell around a point
  /// @param levels  of the look-up's octree, whose root is two to four times as large as the model: each one more makes
  ///                it four times as large, and points near the surface faster
  /// REQUIRES a closed oriented surface: complex.is_closed_oriented_surface(). It must outlive the classifier.
  /// @cost  near-linear in the patches, and in the cells that the surface meets: 0.1 to 1 s for 8 levels
  static PatchClassifier make(const PatchComplex& complex, bool has_shells, int levels = kLevels);
  static PatchClassifier make(PatchComplex&&, bool, int = 0) = delete;
  /// For a valid model whose shells do not matter.
  static PatchClassifier of_valid_model(const PatchComplex& complex, int levels = kLevels);
  static PatchClassifier of_valid_model(PatchComplex&&, int = 0) = delete;
  static constexpr int kLevels = 8;

  PatchClassifier(PatchClassifier&&) noexcept;
  ~PatchClassifier();

  /// How long polynomials of parameters inside of a flat patch are searched for, once the answer is known: with 160
  /// bits, or with 640, too, which takes 1 to 100 ms.
  enum class Search { kShort, kLong };

  /// Undecided only for a point at which 2560 bits, or the limit of work (131,072 pieces), do not tell whether it is on
  /// the surface: never because of a flat patch of a valid model alone, unless two of them are in axis-parallel planes
  /// and closer to the point than that. REQUIRES finite coordinates.
  /// @param where  set if the point is on the surface; inside of a flat patch, polynomials of the parameters may be
  ///               unknown, and there is a box that holds them
  PointAnswer classify(const Vec3d& point, std::optional<OnPatch>* where = nullptr,
                       Search search = Search::kShort) const;
  PointAnswer classify(const ExactPoint& point, std::optional<OnPatch>* where = nullptr,
                       Search search = Search::kShort) const;
  /// All at once, by `jobs` threads; the answers do not depend on their number. REQUIRES equal sizes.
  void classify(std::span<const Vec3d> points, std::span<PointAnswer> answers, unsigned jobs) const;

  /// 0 or 1 if no hull of a small piece meets the closed box and its points have the winding number 0, or another one;
  /// otherwise mixed, also if only the surface or a hull touches the box. REQUIRES a finite box that is not empty.
  /// @cost  some 100 pieces, or those that are near the box's border
  Value3 value(const Box3d& box) const;
  /// A box around the surface; infinite where binary64 ends.
  Box3d box() const;

  /// For each shell how many others are around it; empty unless answers name shells.
  const std::vector<std::uint32_t>& depths() const;

  LookupSize lookup() const;

  class Body;

 private:
  explicit PatchClassifier(std::unique_ptr<const Body> body);
  std::unique_ptr<const Body> body_;
};

}  // namespace veritope
