// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/fold_certifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "robust/base/check.h"
#include "verify/certify/certify_kinds_internal.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/parameter_text.h"
#include "verify/certify/volume_fold.h"
#include "verify/certify/volume_subject.h"
#include "verify/format/volume_folded_certificate.h"

namespace veritope {
namespace {

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
  out.code = "folded";
  std::array<FoldPoint, 2> points;
  for (std::size_t i = 0; i < 2; ++i) {
    points[i].parameters = parameters_at(volume, fold.places[i]);
    points[i].point = RationalPoint{point_at(volume, fold.places[i])};
    points[i].sign = i == 0 ? Sign::kPositive : Sign::kNegative;
    out.place.parts.push_back(part_at(fold.entity, points[i].parameters));
    out.witness.cells.push_back({fold.entity, {}, points[i].parameters, {}});
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

// Whether fractions of pieces are as short as bodies hold them.
bool has_short_numbers(const FoldPlace& place) {
  return std::all_of(place.at.begin(), place.at.end(), [](const Rational& t) {
    return std::max(t.numerator().bit_length(), t.denominator().bit_length()) < 63;
  });
}
bool can_be_certified(const SplineModel& model, const VolumeFold& fold) {
  const auto& volume = std::get<ExactVolume>(model.entities[fold.entity].shape);
  return std::all_of(fold.places.begin(), fold.places.end(), [&](const FoldPlace& place) {
    return has_short_numbers(place) && fits_certificate(volume, place);
  });
}

}  // namespace

Finding fold_finding(const SplineFile& file, const VolumeFold& fold) {
  return finding_of(std::get<ExactVolume>(file.model.entities[fold.entity].shape), fold);
}

std::optional<Certified> certify_fold(const SplineFile& file, const CertifyOptions& options) {
  if (!has_only_volumes(file)) return std::nullopt;
  internal::enter(Phase::kDeciding, options);
  const std::optional<VolumeFold> fold = find_fold(file.model);
  if (!fold) return std::nullopt;
  return certify_fold_at(file, *fold, options);
}

std::optional<Certified> certify_fold_at(const SplineFile& file, const VolumeFold& fold,
                                         const CertifyOptions& options) {
  const std::optional<VolumeSubject> subject = volume_subject_of(file);
  if (!subject || !can_be_certified(subject->file(file).model, fold)) return std::nullopt;
  Certified out = certified_fold(subject->file(file), fold, options);
  out.copy = subject->certified_copy();
  return out;
}

}  // namespace veritope
