// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/points_certifier.h: the certificate of classified points of a mesh: for each point off it a direction
// in which few facets stand, for each point on it the facet.
#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "io/mesh/read_mesh.h"
#include "robust/base/result.h"
#include "solids/classify/point_answer.h"
#include "verify/format/points_certificate.h"

namespace veritope {

/// Gathers the codes of the certificate, batch by batch, in the order of the answers.
class PointsCertifier {
 public:
  /// The file's mesh must outlive this. REQUIRES at least one face.
  PointsCertifier(const MeshFile& file, unsigned jobs);
  PointsCertifier(PointsCertifier&&) noexcept;
  ~PointsCertifier();

  /// Adds points with their answers. `points` are rounded to binary64, where they have other coordinates: they only
  /// serve to choose directions.
  void add(std::span<const Vec3d> points, std::span<const PointAnswer> answers);

  /// The certificate; empties this. `answers` says what was written; its numbers of points are set here.
  /// @error kOverLimit if checkers may not spend as much work as the points need
  Result<certificate::Bytes> finish(const certificate::Subject& subject,
                                    certificate::AnswersSubject answers);

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace veritope
