// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/expression_points_certifier.h: the certificate of classified points of an expression: for each point
// what is known of the solids on which the answer depends.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "solids/expression/expression_classifier.h"
#include "verify/certify/certificate_entities.h"
#include "verify/format/points_certificate.h"

namespace veritope {

/// A variable of an expression: a solid, or a box.
struct ExpressionSolid {
  std::shared_ptr<const Operand> operand;
  /// Around the checkers' triangles, or control points: points off it need no proof. A box is its own.
  ExactBox<3> box;
  std::uint64_t bytes = 0;              ///< of its file
  std::vector<StarBoxEntity> entities;  ///< of a spline model
  bool is_by_faces = false;             ///< its patches are boundary faces of volumes
};

/// Gathers the codes of the certificate, batch by batch, in the order of the answers.
class ExpressionPointsCertifier {
 public:
  /// @param solids      by the number of the variable; those that are no boxes in the order in which their files are
  ///                    first named
  /// @param num_leaves  occurrences of operands that are no expressions
  ExpressionPointsCertifier(const Formula& formula, std::vector<ExpressionSolid> solids,
                            std::uint64_t num_leaves, unsigned jobs);
  ExpressionPointsCertifier(ExpressionPointsCertifier&&) noexcept;
  ~ExpressionPointsCertifier();

  /// Adds points with their words.
  /// @param exact  the points that binary64 does not have, by their number in `points`, where they are rounded
  void add(std::span<const Vec3d> points, std::span<const std::pair<std::size_t, ExactPoint>> exact,
           std::span<const PointWord> words);
  /// Decided points of which the certificate says nothing: curved walls meet there, or too many flat ones.
  std::uint64_t num_uncovered() const;

  /// The certificate; empties this. `answers` says what was written; its numbers of points are set here.
  /// @error kOverLimit if checkers may not spend as much work as the points need, or do not accept so many patches, or
  /// knots of such length
  Result<certificate::Bytes> finish(certificate::Subject subject,
                                    certificate::AnswersSubject answers);

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace veritope
