// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_model.h"

#include <algorithm>

namespace veritope {
namespace {

template <std::size_t N>
constexpr std::size_t num_parameters(const BSpline<Rational, N>&) {
  return N;
}

}  // namespace

const char* spline_kind_name(const SplineEntity& entity) {
  constexpr std::array kNames = {"curve", "surface", "volume", "trimmed", "model", "triangle"};
  static_assert(kNames.size() == std::variant_size_v<decltype(entity.shape)>);
  return kNames[entity.shape.index()];
}

std::array<std::uint64_t, 3> count_splines(const SplineModel& model) {
  std::array<std::uint64_t, 3> counts{};
  for (const SplineEntity& entity : model.entities)
    for_each_spline(entity, [&](const auto& spline) { ++counts[num_parameters(spline) - 1]; });
  return counts;
}

std::uint64_t count_triangles(const SplineModel& model) {
  return static_cast<std::uint64_t>(std::count_if(
      model.entities.begin(), model.entities.end(),
      [](const SplineEntity& e) { return std::holds_alternative<ExactTriangle>(e.shape); }));
}

}  // namespace veritope
