// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/volume_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/spline_view.h"
#include "render/spline_view_internal.h"
#include "render/volume_net_internal.h"
#include "robust/base/entity_error.h"

namespace veritope {
namespace {

const ExactVolume& volume_at(const SplineModel& model, std::size_t i) {
  return std::get<ExactVolume>(model.entities[i].shape);
}

bool is_trimmed(const SplineEntity& entity) {
  return std::holds_alternative<TrimmedSurface>(entity.shape);
}

// Six times the volume that the triangles enclose, relative to a corner.
double signed_volume(const ViewPart& part) {
  double sum = 0;
  if (part.points.empty()) return sum;
  const Point3d& o = part.points[0];
  for (const auto& t : part.triangles) {
    std::array<Point3d, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) d[i][k] = part.points[t[i]][k] - o[k];
    sum += d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
           d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  }
  return sum;
}

void orient_outward(ViewPart& part) {
  std::erase_if(part.triangles, [&](const auto& t) {
    const auto &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
    return a == b || b == c || c == a;
  });
  if (signed_volume(part) < 0)
    for (auto& t : part.triangles) std::swap(t[1], t[2]);
}

void move_by(const Point3d& offset, std::vector<Point3d>& points) {
  for (Point3d& p : points)
    for (std::size_t k = 0; k < 3; ++k) p[k] += offset[k];
}

Result<ViewPart> part_of(const SplineModel& model, std::size_t i, const VolumeLayout& layout,
                         double chord, bool has_nets) {
  SplineModel alone;
  alone.entities.push_back({model.entities[i].shape, {}, {}, {}});
  Result<std::vector<Tessellation>> drawn = tessellate(alone, {chord});
  if (!drawn) {
    Error error = drawn.error();
    error.place.entity = i;
    return error;
  }
  ViewPart out;
  out.name = "cell_" + std::to_string(i);
  out.colour = cell_colour(i);
  out.points = std::move(drawn->front().points);
  out.triangles = std::move(drawn->front().triangles);
  orient_outward(out);
  if (has_nets) {
    out.net_points = internal::rounded_net(volume_at(model, i));
    out.net_lines = internal::net_lines(volume_at(model, i));
  }
  move_by(layout.offsets[i], out.points);
  move_by(layout.offsets[i], out.net_points);
  return out;
}

}  // namespace

namespace internal {

std::vector<Point3d> rounded_net(const ExactVolume& volume) {
  std::vector<Point3d> out(volume.component(0).size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational& x = volume.component(static_cast<int>(k))[i];
      out[i][k] = volume.is_rational() ? nearest_double(x / volume.component(volume.dimension())[i])
                                       : nearest_double(x);
    }
  return out;
}

std::vector<std::array<std::uint32_t, 2>> net_lines(const ExactVolume& volume) {
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a) grid.size[a] = volume.axis(a).num_control();
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < grid.count(); ++i)
      if (grid.index_of(i)[a] + 1 < grid.size[a])
        out.push_back(
            {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + grid.stride(a))});
  return out;
}

}  // namespace internal

Colour cell_colour(std::uint64_t cell) {
  constexpr std::array<Colour, 10> kColours = {{{86, 140, 200},
                                                {242, 150, 50},
                                                {96, 176, 90},
                                                {222, 92, 94},
                                                {240, 208, 80},
                                                {170, 120, 190},
                                                {100, 195, 190},
                                                {245, 160, 180},
                                                {165, 125, 100},
                                                {175, 175, 175}}};
  const Colour c = kColours[cell % kColours.size()];
  const std::uint64_t shade = cell / kColours.size() % 3;  // as it is, lighter, darker
  const auto shaded = [shade](std::uint8_t x) {
    return static_cast<std::uint8_t>(shade == 0 ? x : shade == 1 ? (x + 255) / 2 : x * 2 / 3);
  };
  return {shaded(c.red), shaded(c.green), shaded(c.blue)};
}

Status check_is_volumes(const SplineModel& model) {
  if (model.entities.empty()) return Error{Code::kEmpty, {}, "the file has no volumes"};
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    const SplineEntity& entity = model.entities[i];
    const auto* const volume = std::get_if<ExactVolume>(&entity.shape);
    if (volume == nullptr)
      return error_at_entity(Code::kBadArgument, i,
                             std::string("a ") + spline_kind_name(entity) +
                                 (is_trimmed(entity) ? " surface" : "") + ", not a volume");
    if (volume->dimension() < 3)
      return error_at_entity(
          Code::kBadArgument, i,
          "a volume with " + std::to_string(volume->dimension()) + " coordinates, not in space");
  }
  return ok_status();
}

Result<VolumeLayout> volume_layout(const SplineModel& model, double explode) {
  const std::size_t n = model.entities.size();
  std::vector<Box3d> boxes(n, empty_box());
  Box3d all = empty_box();
  Point3d mean{};
  for (std::size_t i = 0; i < n; ++i) {
    for (const Point3d& p : internal::rounded_net(volume_at(model, i))) add(p, &boxes[i]);
    if (!is_finite(boxes[i]))
      return error_at_entity(Code::kNotFinite, i, "a coordinate is too large for binary64");
    all = hull(all, boxes[i]);
    const Point3d centre = approx_centre(boxes[i]);
    for (std::size_t k = 0; k < 3; ++k) mean[k] += centre[k] / static_cast<double>(n);
  }
  VolumeLayout out;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = all.hi[k] / 2 - all.lo[k] / 2;
    square += side * side;
  }
  out.diagonal = 2 * std::sqrt(square);
  out.box = empty_box();
  for (std::size_t i = 0; i < n; ++i) {
    Point3d& offset = out.offsets.emplace_back();
    const Point3d centre = approx_centre(boxes[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      offset[k] = explode == 0 ? 0 : explode * (centre[k] - mean[k]);
      boxes[i].lo[k] += offset[k], boxes[i].hi[k] += offset[k];
    }
    if (!is_finite(boxes[i]))
      return error_at_entity(Code::kNotFinite, i, "it would be moved beyond binary64");
    out.box = hull(out.box, boxes[i]);
  }
  return out;
}

Result<std::vector<ViewPart>> volume_parts(const SplineModel& model, const VolumeLayout& layout,
                                           const VolumeViewOptions& options) {
  double chord = options.chord.value_or(layout.diagonal * options.fineness);
  if (!std::isfinite(chord) || !(chord > 0)) chord = 1;
  std::vector<ViewPart> out;
  std::size_t points = 0;
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    Result<ViewPart> part = part_of(model, i, layout, chord, options.has_nets);
    if (!part) return part.error();
    points += part->points.size() + part->net_points.size();
    if (points > options.max_points)
      return error_at_entity(Code::kOverLimit, i,
                             "the cells up to this one give more than " +
                                 std::to_string(options.max_points) +
                                 " points; a larger chord gives fewer");
    out.push_back(std::move(*part));
  }
  return out;
}

}  // namespace veritope
