// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_model.h: what a spline file holds: exact curves, surfaces, trimmed surfaces, volumes, models of
// faces and Bezier triangles.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robust/base/result.h"
#include "splines/bezier_triangle.h"
#include "splines/bspline.h"

namespace veritope {

using ExactCurve = BSplineCurve<Rational>;
using ExactSurface = BSplineSurface<Rational>;
using ExactVolume = BSplineVolume<Rational>;
using ExactTriangle = BezierTriangle<Rational>;

/// A piece of a trimming loop. Either curve may be missing; `omitted` then says why the file's was not used.
struct TrimCurve {
  std::optional<ExactCurve>
      parameter;                    ///< in the surface's (u, v); a third coordinate has no meaning
  std::optional<ExactCurve> space;  ///< the file's claim of the same curve in space
  std::string omitted;              ///< a remark; empty: nothing was left out
  friend bool operator==(const TrimCurve& a, const TrimCurve& b) {
    return a.parameter == b.parameter && a.space == b.space;
  }
};
using TrimLoop = std::vector<TrimCurve>;

/// A surface and its trimming loops as the file has them: they need not be closed, oriented or disjoint.
struct TrimmedSurface {
  ExactSurface surface;
  std::vector<TrimLoop> loops;
  friend bool operator==(const TrimmedSurface&, const TrimmedSurface&) = default;
};

/// A surface of a model; its loops name segments, from 1, negative where they are passed in
/// reverse.
struct BrepFace {
  ExactSurface surface;
  std::vector<std::vector<std::int64_t>> loops;
  friend bool operator==(const BrepFace&, const BrepFace&) = default;
};
/// A trimming curve that up to two faces share: its image in each, and in space.
struct BrepSegment {
  std::array<std::uint64_t, 2> faces{};  ///< from 1; 0: none
  std::array<std::optional<ExactCurve>, 2> parameter;
  std::optional<ExactCurve> space;
  friend bool operator==(const BrepSegment&, const BrepSegment&) = default;
};
struct SplineBrep {
  std::vector<BrepFace> faces;
  std::vector<BrepSegment> segments;
  friend bool operator==(const SplineBrep&, const SplineBrep&) = default;
};

/// A node of the file's tree of named objects.
struct SplineGroup {
  std::string name;                     ///< UTF-8; may be empty
  std::vector<std::string> attributes;  ///< the file's text of each, UTF-8
  std::optional<std::size_t> parent;    ///< a lower index
  friend bool operator==(const SplineGroup&, const SplineGroup&) = default;
};

struct SplineEntity {
  std::variant<ExactCurve, ExactSurface, ExactVolume, TrimmedSurface, SplineBrep, ExactTriangle>
      shape;
  std::vector<std::string> attributes;
  std::optional<std::size_t> group;
  Place place;  ///< where the file has it; no part of the model
  friend bool operator==(const SplineEntity& a, const SplineEntity& b) {
    return a.shape == b.shape && a.attributes == b.attributes && a.group == b.group;
  }
};

/// All splines and triangles are exact, of degree 1 to kMaxSplineDegree, weights > 0, and every index is in range.
struct SplineModel {
  std::vector<SplineGroup> groups;
  std::vector<SplineEntity> entities;
  friend bool operator==(const SplineModel&, const SplineModel&) = default;
};

/// "curve", "surface", "volume", "trimmed", "model", "triangle".
const char* spline_kind_name(const SplineEntity& entity);

/// Calls visit(spline) for every curve, surface and volume, those of trimming included, in file order; not for
/// triangles, which have no axes.
template <typename Visit>
void for_each_spline(const SplineEntity& entity, Visit visit);

/// The number of splines with one, two and three parameters, those of trimming included.
std::array<std::uint64_t, 3> count_splines(const SplineModel& model);

/// The number of entities that are Bezier triangles.
std::uint64_t count_triangles(const SplineModel& model);

// ---- bodies

template <typename Visit>
void for_each_spline(const SplineEntity& entity, Visit visit) {
  const auto optionally = [&](const std::optional<ExactCurve>& curve) {
    if (curve) visit(*curve);
  };
  if (const auto* trimmed = std::get_if<TrimmedSurface>(&entity.shape)) {
    visit(trimmed->surface);
    for (const TrimLoop& loop : trimmed->loops)
      for (const TrimCurve& piece : loop) optionally(piece.parameter), optionally(piece.space);
  } else if (const auto* brep = std::get_if<SplineBrep>(&entity.shape)) {
    for (const BrepFace& face : brep->faces) visit(face.surface);
    for (const BrepSegment& s : brep->segments)
      optionally(s.parameter[0]), optionally(s.parameter[1]), optionally(s.space);
  } else if (const auto* curve = std::get_if<ExactCurve>(&entity.shape)) {
    visit(*curve);
  } else if (const auto* surface = std::get_if<ExactSurface>(&entity.shape)) {
    visit(*surface);
  } else if (const auto* volume = std::get_if<ExactVolume>(&entity.shape)) {
    visit(*volume);
  }
}

}  // namespace veritope
