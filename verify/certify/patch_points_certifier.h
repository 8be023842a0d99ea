// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_points_certifier.h: the certificate of classified points of a spline model: for each point off
// it the direction in which the model ends soonest, for each point on it a patch with parameters.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "robust/base/result.h"
#include "solids/classify/patch_classifier.h"
#include "verify/certify/file_patches.h"
#include "verify/format/points_certificate.h"

namespace veritope {

/// Gathers the codes of the certificate, batch by batch, in the order of the answers.
class PatchPointsCertifier {
 public:
  /// Both must outlive this. REQUIRES that the classifier is that of the patches' complex.
  PatchPointsCertifier(const FilePatches& patches, const PatchClassifier& classifier);
  PatchPointsCertifier(PatchPointsCertifier&&) noexcept;
  ~PatchPointsCertifier();

  /// Adds points with their answers.
  /// @param exact  the points that binary64 does not have, by their number in `points`
  void add(std::span<const Vec3d> points, std::span<const std::pair<std::size_t, ExactPoint>> exact,
           std::span<const PointAnswer> answers);

  /// The certificate; empties this. `answers` says what was written; its numbers of points are set here.
  /// @error kOverLimit if points lie at irrational parameters, or if checkers do not accept so many patches, or knots
  /// of such length
  Result<certificate::Bytes> finish(const certificate::Subject& subject,
                                    certificate::AnswersSubject answers);

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace veritope
