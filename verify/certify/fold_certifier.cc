// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/fold_certifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "io/read_model.h"
#include "io/splines/boundary_faces.h"
#include "io/splines/write_splines.h"
#include "robust/base/check.h"
#include "splines/bspline_domain.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/parameter_text.h"
#include "verify/certify/stand_in.h"
#include "verify/certify/volume_fold.h"
#include "verify/format/volume_folded_certificate.h"

namespace veritope {
namespace {

bool has_only_volumes(const SplineFile& file) {
  return !file.beyond_default_limits && !uncovered_shapes(file) &&
         std::all_of(file.model.entities.begin(), file.model.entities.end(),
                     [](const SplineEntity& e) {
                       const auto* const volume = std::get_if<ExactVolume>(&e.shape);
                       return volume != nullptr && volume->dimension() == 3;
                     });
}

// The volumes on their domains, with clamped axes.
SplineModel clamped(const SplineModel& model) {
  SplineModel out;
  for (const SplineEntity& entity : model.entities) {
    const auto& volume = std::get<ExactVolume>(entity.shape);
    std::array<Rational, 3> begin, end;
    for (std::size_t a = 0; a < 3; ++a) {
      begin[a] = volume.axis(a).domain_begin();
      end[a] = volume.axis(a).domain_end();
    }
    out.entities.push_back({restricted(volume, begin, end).value(), {}, {}, entity.place});
  }
  return out;
}

std::string triple_text(const std::array<Rational, 3>& t) {
  return "(" + number_text(t[0]) + ", " + number_text(t[1]) + ", " + number_text(t[2]) + ")";
}

EntityPart part_at(std::uint64_t entity, const std::array<Rational, 3>& parameters) {
  EntityPart out;
  out.entity = entity;
  out.is_of_volume = true;
  for (const Rational& t : parameters) out.parameters.push_back({round_down(t), round_up(t)});
  return out;
}

Finding finding_of(const ExactVolume& volume, const VolumeFold& fold) {
  Finding out;
  out.code = "volume-folded";
  std::array<FoldPoint, 2> points;
  for (std::size_t i = 0; i < 2; ++i) {
    points[i].parameters = parameters_at(volume, fold.places[i]);
    points[i].point = RationalPoint{point_at(volume, fold.places[i])};
    points[i].sign = i == 0 ? Sign::kPositive : Sign::kNegative;
    out.place.parts.push_back(part_at(fold.entity, points[i].parameters));
  }
  out.message = entity_text(fold.entity) +
                ": the volume folds: its map keeps the orientation of space at " +
                triple_text(points[0].parameters) + " and reverses it at " +
                triple_text(points[1].parameters);
  const std::array<Rational, 3>& p = points[0].point.at;
  const Point3d near = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
  if (std::isfinite(near[0]) && std::isfinite(near[1]) && std::isfinite(near[2]))
    out.place.near = near;
  out.witness.fold = std::move(points);
  return out;
}

certificate::VolumeFoldedBody body_of(const SplineModel& model, const VolumeFold& fold) {
  certificate::VolumeFoldedBody out;
  out.volumes = static_cast<std::uint32_t>(model.entities.size());
  out.entity = fold.entity;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational& t = fold.places[i].at[a];
      out.points[i][a] = {fold.places[i].piece[a],
                          {t.numerator().low_bits(), t.denominator().low_bits()}};
    }
  return out;
}

Certified certified_fold(const SplineFile& file, const VolumeFold& fold,
                         const CertifyOptions& options) {
  const auto& volume = std::get<ExactVolume>(file.model.entities[fold.entity].shape);
  VT_CHECK(jacobian_sign(volume, fold.places[0]) > 0 && jacobian_sign(volume, fold.places[1]) < 0,
           "the two points of a fold are a proof");
  internal::enter(Phase::kCertifying, options);
  Certified out;
  out.facts.emplace<PatchFacts>();
  out.verdict = Verdict::kInvalid;
  out.findings = {finding_of(volume, fold)};
  out.certificate =
      certificate::encode(subject_of(file, options.tool, false), body_of(file.model, fold));
  out.claim = certificate::kVolumeFoldedClaim;
  return out;
}

bool can_be_certified(const SplineModel& model, const VolumeFold& fold) {
  const auto& volume = std::get<ExactVolume>(model.entities[fold.entity].shape);
  return are_clamped_volumes(model) && fits_certificate(volume, fold.places[0]) &&
         fits_certificate(volume, fold.places[1]);
}

std::optional<Certified> certify_copy(const SplineFile& file, const VolumeFold& fold,
                                      const CertifyOptions& options) {
  const std::string bytes = spline_json_bytes(clamped(file.model));
  const Result<SplineFile> copy = read_spline_bytes(
      {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "copy.vjson", {});
  if (!copy || copy->beyond_default_limits || !can_be_certified(copy->model, fold))
    return std::nullopt;
  Certified out = certified_fold(*copy, fold, options);
  const std::size_t n = file.model.entities.size();
  out.copy = {bytes, copy->sha256, "its " + std::to_string(n) + (n == 1 ? " volume" : " volumes")};
  return out;
}

}  // namespace

std::optional<Certified> certify_fold(const SplineFile& file, const CertifyOptions& options) {
  if (file.model.entities.empty() || !has_only_volumes(file)) return std::nullopt;
  internal::enter(Phase::kDeciding, options);
  const std::optional<VolumeFold> fold = find_fold(file.model);
  if (!fold) return std::nullopt;
  if (is_read_by_checkers(file) && are_clamped_volumes(file.model)) {
    if (!can_be_certified(file.model, *fold)) return std::nullopt;
    return certified_fold(file, *fold, options);
  }
  return certify_copy(file, *fold, options);
}

}  // namespace veritope
