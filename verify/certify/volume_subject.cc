// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/volume_subject.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/read_model.h"
#include "io/splines/boundary_faces.h"
#include "io/splines/write_splines.h"
#include "splines/bspline_domain.h"
#include "verify/certify/stand_in.h"

namespace veritope {
namespace {

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

}  // namespace

bool has_only_volumes(const SplineFile& file) {
  return !file.model.entities.empty() && !file.beyond_default_limits && !uncovered_shapes(file) &&
         std::all_of(file.model.entities.begin(), file.model.entities.end(),
                     [](const SplineEntity& e) {
                       const auto* const volume = std::get_if<ExactVolume>(&e.shape);
                       return volume != nullptr && volume->dimension() == 3;
                     });
}

std::optional<CertifiedCopy> VolumeSubject::certified_copy() const {
  if (!copy) return std::nullopt;
  const std::size_t n = copy->model.entities.size();
  return CertifiedCopy{bytes, copy->sha256,
                       "its " + std::to_string(n) + (n == 1 ? " volume" : " volumes")};
}

std::optional<VolumeSubject> volume_subject_of(const SplineFile& file) {
  if (is_read_by_checkers(file) && are_clamped_volumes(file.model)) return VolumeSubject{};
  VolumeSubject out;
  out.bytes = spline_json_bytes(clamped(file.model));
  Result<SplineFile> copy = read_spline_bytes(
      {reinterpret_cast<const unsigned char*>(out.bytes.data()), out.bytes.size()}, "copy.vjson",
      {});
  if (!copy || copy->beyond_default_limits || !are_clamped_volumes(copy->model))
    return std::nullopt;
  out.copy = std::move(*copy);
  return out;
}

}  // namespace veritope
