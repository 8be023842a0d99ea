// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/volumes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "robust/base/entity_error.h"
#include "splines/bspline_components.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

bool is_clamped_axis(const ExactVolume::Axis& axis) {
  return axis.knots.front() == axis.domain_begin() && axis.knots.back() == axis.domain_end();
}

bool has_attribute(const SplineEntity& entity) {
  const auto* const volume = std::get_if<ExactVolume>(&entity.shape);
  return volume != nullptr && volume->dimension() > 3;
}

}  // namespace

bool has_attributes(const SplineModel& model) {
  return std::any_of(model.entities.begin(), model.entities.end(), has_attribute);
}

SplineModel without_attributes(const SplineModel& model) {
  SplineModel out = model;
  for (SplineEntity& entity : out.entities)
    if (has_attribute(entity))
      entity.shape = first_coordinates(std::get<ExactVolume>(entity.shape), 3);
  return out;
}

Result<std::vector<ExactVolume>> volumes_of(const SplineFile& file) {
  for (const LeftOut& l : file.left_out)
    if (l.is_geometry)
      return bad_argument("shapes of the file are not read: " + l.what + " (" +
                          std::to_string(l.count) + ")");
  std::vector<ExactVolume> out;
  const auto& entities = file.model.entities;
  if (entities.empty()) return Error{Code::kEmpty, {}, "the file has no volumes"};
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const auto* const volume = std::get_if<ExactVolume>(&entities[i].shape);
    if (volume == nullptr)
      return error_at_entity(Code::kBadArgument, i,
                             std::string("a ") + spline_kind_name(entities[i]) + ", not a volume");
    out.push_back(*volume);
    for (std::size_t a = 0; a < 3; ++a)
      if (!is_clamped_axis(volume->axis(a))) out.back() = clamped(out.back(), a);
  }
  return out;
}

}  // namespace veritope
