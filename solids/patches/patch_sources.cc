// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_sources.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "robust/base/entity_error.h"
#include "robust/binary64.h"
#include "solids/patches/finite_points_internal.h"
#include "solids/patches/patch_knots.h"
#include "solids/patches/patch_net.h"
#include "splines/bezier_domain.h"
#include "splines/bspline_domain.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

template <typename Map>
Patch made(Map map, PatchOrigin origin) {
  return make_patch(std::move(map), origin).value();
}
PatchOrigin facet(std::size_t number) { return {PatchOrigin::Kind::kFacet, number, {}}; }

Patch::Triangle flat(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  std::vector<Rational> values;
  for (const auto coordinate : {&Vec3d::x, &Vec3d::y, &Vec3d::z})
    for (const Vec3d* p : {&a, &b, &c}) values.push_back(Rational::from_double(p->*coordinate));
  return {1, 3, false, std::move(values)};
}

Patch::Triangle exact(const BezierTriangle<double>& map) {
  std::vector<Rational> values;
  for (const double v : map.coefficients()) values.push_back(Rational::from_double(v));
  return {map.degree(), map.num_components(), map.is_rational(), std::move(values)};
}

}  // namespace

Result<PatchInput> patches_of(const TriangleMesh& mesh) {
  if (mesh.faces.size() > kMaxPatches)
    return Error{Code::kOverLimit, {}, std::to_string(mesh.faces.size()) + " facets"};
  PatchInput out;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::array<Vec3d, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = mesh.faces[f][i];
      if (v >= mesh.positions.size()) {
        Error error{Code::kIndexOutOfRange,
                    {},
                    "vertex " + std::to_string(v) + " of " + std::to_string(mesh.positions.size())};
        error.place.face = f;
        return error;
      }
      p[i] = mesh.positions[v];
    }
    if (internal::is_finite(p[0]) && internal::is_finite(p[1]) && internal::is_finite(p[2])) {
      out.patches.push_back(made(flat(p[0], p[1], p[2]), facet(f)));
    } else {
      PatchFinding& finding = out.findings.emplace_back();
      finding.defect = PatchDefect::kNotFinite;
      finding.facet = f;
    }
  }
  return out;
}

std::vector<Patch> patches_of(const PnMesh<Rational>& mesh) {
  std::vector<Patch> out;
  for (std::size_t f = 0; f < mesh.num_faces(); ++f) out.push_back(made(mesh.points(f), facet(f)));
  return out;
}
std::vector<Patch> patches_of(const PnMesh<double>& mesh) {
  std::vector<Patch> out;
  for (std::size_t f = 0; f < mesh.num_faces(); ++f)
    out.push_back(made(exact(mesh.points(f)), facet(f)));
  return out;
}

namespace {

using Surface = BSplineSurface<Rational>;

Status check_surface(const Surface& surface, std::uint64_t number) {
  if (surface.dimension() != 3)
    return error_at_entity(
        Code::kBadArgument, number,
        std::to_string(surface.dimension()) + " coordinates; a patch lies in space");
  for (const auto& axis : surface.axes()) {
    if (axis.degree < 1)
      return error_at_entity(Code::kBadArgument, number,
                             "a patch of degree " + std::to_string(axis.degree) + " is no surface");
    if (axis.degree > kMaxSplineDegree)
      return error_at_entity(Code::kOverLimit, number,
                             "degree " + std::to_string(axis.degree) + "; at most " +
                                 std::to_string(kMaxSplineDegree) + " are read");
  }
  return ok_status();
}

// The breaks of a clamped surface's axes in its parameters.
using Breaks = std::array<std::vector<Rational>, 2>;
Breaks own_breaks(const Surface& surface, const CommonBreaks& breaks, std::size_t number) {
  Breaks out;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& knots = surface.axis(axis);
    const Rational &begin = knots.domain_begin(), &end = knots.domain_end();
    for (const Rational& t : breaks.of(number, axis))
      out[axis].push_back(begin + t * (end - begin));
  }
  return out;
}

Status check_count(const CommonBreaks& breaks, std::span<const std::uint64_t> numbers) {
  std::size_t count = 0;
  for (std::size_t s = 0; s < breaks.list_of.size(); ++s) {
    const Grid<2> cells{{breaks.of(s, 0).size() - 1, breaks.of(s, 1).size() - 1}};
    const auto more = cells.count_up_to(kMaxPatches - count);
    if (!more)
      return error_at_entity(
          Code::kOverLimit, numbers.empty() ? s : numbers[s],
          "with this surface there are over " + std::to_string(kMaxPatches) + " pieces");
    count += *more;
  }
  return ok_status();
}

// The surface with a knot at each of the breaks. REQUIRES a clamped axis.
Surface cut_at(const Surface& surface, std::size_t axis, const std::vector<Rational>& breaks) {
  const auto& knots = surface.axis(axis).knots;
  std::vector<Rational> missing;
  std::set_difference(breaks.begin(), breaks.end(), knots.begin(), knots.end(),
                      std::back_inserter(missing));
  return refine(surface, axis, missing);
}

}  // namespace

Result<SurfacePieces> pieces_of(std::span<const BSplineSurface<Rational>> surfaces,
                                std::span<const std::uint64_t> numbers) {
  VT_CHECK(numbers.empty() || numbers.size() == surfaces.size(), "a number for each surface");
  const auto number = [&](std::size_t s) { return numbers.empty() ? s : numbers[s]; };
  if (surfaces.size() > kMaxPatches)
    return Error{Code::kOverLimit, {}, std::to_string(surfaces.size()) + " surfaces"};
  std::vector<Surface> clamp;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (Status ok = check_surface(surfaces[s], number(s)); !ok) return ok.error();
    clamp.push_back(clamped(clamped(surfaces[s], 0), 1));
  }
  const CommonBreaks breaks = common_breaks(clamp);
  if (Status ok = check_count(breaks, numbers); !ok) return ok.error();
  SurfacePieces out;
  for (std::size_t s = 0; s < clamp.size(); ++s) {
    const Breaks& at = out.breaks.emplace_back(own_breaks(clamp[s], breaks, s));
    auto cut = bezier_pieces(cut_at(cut_at(clamp[s], 0, at[0]), 1, at[1]));
    const Grid<2> cells = cut.grid();
    for (std::size_t i = 0; i < cells.count(); ++i) {
      const auto span = cells.index_of(i);
      out.patches.push_back(
          made(std::move(cut.pieces[i]),
               {PatchOrigin::Kind::kSurface,
                number(s),
                {static_cast<std::uint32_t>(span[0]), static_cast<std::uint32_t>(span[1])}}));
    }
  }
  return out;
}

Result<std::vector<Patch>> patches_of(std::span<const BSplineSurface<Rational>> surfaces) {
  Result<SurfacePieces> pieces = pieces_of(surfaces);
  if (!pieces) return pieces.error();
  return std::move(pieces->patches);
}

namespace {

// The faces without the walls between volumes, which are faces that occur twice, with opposite normals.
std::vector<Patch> without_walls(std::vector<Patch> faces) {
  std::vector<std::pair<CanonicalNet, std::size_t>> nets;
  for (std::size_t f = 0; f < faces.size(); ++f) nets.emplace_back(canonical_net(faces[f]), f);
  std::sort(nets.begin(), nets.end(), [](const auto& a, const auto& b) {
    const auto order = a.first <=> b.first;
    return order != 0 ? order < 0 : a.second < b.second;
  });
  std::vector<bool> is_wall(faces.size(), false);
  for (std::size_t i = 0; i < nets.size();) {
    std::size_t end = i + 1;
    while (end < nets.size() && (nets[end].first <=> nets[i].first) == 0) ++end;
    if (end == i + 2 && nets[i].first.is_reversed != nets[i + 1].first.is_reversed)
      is_wall[nets[i].second] = is_wall[nets[i + 1].second] = true;
    i = end;
  }
  std::vector<Patch> out;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (!is_wall[f]) out.push_back(std::move(faces[f]));
  return out;
}

}  // namespace

Result<std::vector<Patch>> faces_of(std::span<const BezierVolume<Rational>> volumes) {
  std::vector<Patch> out;
  for (std::size_t v = 0; v < volumes.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int end : {0, 1}) {
        // The rest of the axes in their order: dS/du x dS/dv points along +axis for axes 0 and 2, and along -axis for
        // axis 1.
        Result<Patch> face = make_patch(
            boundary(volumes[v], axis, end),
            {PatchOrigin::Kind::kSurface, 6 * v + 2 * axis + static_cast<std::size_t>(end), {}});
        if (!face) return face.error();
        out.push_back((axis == 1) == (end == 1) ? reversed(*face) : std::move(*face));
      }
  return without_walls(std::move(out));
}

}  // namespace veritope
