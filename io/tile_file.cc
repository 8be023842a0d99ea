// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/tile_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/splines/boundary_faces.h"
#include "io/splines/patch_model.h"
#include "io/splines/volumes.h"
#include "io/tile_facets_internal.h"
#include "solids/micro/micro_validity.h"
#include "splines/bezier_triangle.h"

namespace veritope {
namespace {

constexpr const char* kPolygonsOfFile = "polygons";  // LeftOut::what

Error over_tile_limit(std::uint64_t count, const std::string& what, std::uint64_t most) {
  return Error{
      Code::kOverLimit,
      {},
      "the tile has " + std::to_string(count) + what + ", more than " + std::to_string(most)};
}
Error too_many_tile_patches(std::uint64_t count) {
  return over_tile_limit(count, " patches", kMaxTilePatches);
}

// The point of a tensor patch or triangle with this number.
TilePoint control_point(const Patch& patch, std::size_t i) {
  return {patch.component(0)[i], patch.component(1)[i], patch.component(2)[i]};
}

// The points of a curve in Bernstein form, in a degree that is not less.
std::vector<TilePoint> elevated_points(std::vector<TilePoint> points, std::size_t degree) {
  while (points.size() <= degree) {
    const auto n = static_cast<std::int64_t>(points.size());
    std::vector<TilePoint> next = {points.front()};
    for (std::int64_t i = 1; i < n; ++i) {
      const Rational share = Rational(Integer(i)) / Rational(Integer(n));
      TilePoint p;
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = share * points[static_cast<std::size_t>(i - 1)][c] +
               (Rational(1) - share) * points[static_cast<std::size_t>(i)][c];
      next.push_back(std::move(p));
    }
    next.push_back(points.back());
    points = std::move(next);
  }
  return points;
}

// A triangle of degree n is the patch whose side u = 0 is its corner 0: row i of the degree n consists of the
// coefficients of u^(n - i), as a curve from the side of corner 1 to that of corner 2.
TilePatch tile_patch_of_triangle(const Patch& patch) {
  const int n = patch.triangle().degree();
  TilePatch out;
  out.degrees = {n, n};
  auto& points = out.points.emplace_back();
  for (int row = 0; row <= n; ++row) {
    std::vector<TilePoint> curve;
    for (int k = 0; k <= row; ++k)
      curve.push_back(control_point(patch, triangle_index(row - k, k)));
    for (TilePoint& p : elevated_points(std::move(curve), static_cast<std::size_t>(n)))
      points.push_back(std::move(p));
  }
  return out;
}

Result<TilePatch> tile_patch_of(const Patch& patch, const std::string& where) {
  if (patch.is_rational())
    return bad_argument(where + " is rational; the patches of tiles are polynomial");
  if (patch.max_degree() > kMaxTileDegree)
    return Error{Code::kOverLimit,
                 {},
                 where + " has the degree " + std::to_string(patch.max_degree()) +
                     "; tiles have degrees up to " + std::to_string(kMaxTileDegree)};
  if (patch.is_triangle()) return tile_patch_of_triangle(patch);
  TilePatch out;
  out.degrees = patch.tensor().degrees();
  auto& points = out.points.emplace_back();
  for (std::size_t i = 0; i < patch.num_control(); ++i) points.push_back(control_point(patch, i));
  return out;
}

// Whether a patch, turned so that another corner comes first, is another one: the least text of its turns.
std::string oriented_key(const TilePatch& patch, bool is_reversed) {
  const std::vector<TilePoint>& points = patch.points.front();
  std::string least;
  for (unsigned turn = 0; turn < 4; ++turn) {
    // The points in rows from a corner, first along one of its sides: turns keep the hand, exchanged axes do not.
    const bool is_swapped = (turn % 2 == 1) != is_reversed;
    const int p = patch.degrees[is_swapped ? 1 : 0], q = patch.degrees[is_swapped ? 0 : 1];
    std::string text = std::to_string(p) + "," + std::to_string(q);
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        const int a = turn == 1 || turn == 2 ? p - i : i, b = turn >= 2 ? q - j : j;
        const int row = is_swapped ? b : a, column = is_swapped ? a : b;
        for (const Rational& x :
             points[static_cast<std::size_t>(row * (patch.degrees[1] + 1) + column)])
          text += ";" + x.to_string();
      }
    if (turn == 0 || text < least) least = std::move(text);
  }
  return least;
}

// Leaves out pairs of equal patches with opposite normals.
std::vector<TilePatch> without_inner_walls(std::vector<TilePatch> patches) {
  std::map<std::string, std::vector<std::size_t>> open;
  std::vector<bool> is_inner(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto at = open.find(oriented_key(patches[i], true));
    if (at != open.end() && !at->second.empty()) {
      is_inner[i] = is_inner[at->second.back()] = true;
      at->second.pop_back();
    } else {
      open[oriented_key(patches[i], false)].push_back(i);
    }
  }
  std::vector<TilePatch> out;
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (!is_inner[i]) out.push_back(std::move(patches[i]));
  return out;
}

Result<std::vector<Patch>> tile_patches_of(const SplineFile& file, bool has_polygons) {
  for (const LeftOut& left : file.left_out)
    if (left.is_geometry && !(has_polygons && left.what == kPolygonsOfFile))
      return bad_argument("the file has " + left.what +
                          ", which are no part of a tile: surfaces, triangles and volumes are");
  SplineModel volumes, others;
  const SplineModel plain =
      has_attributes(file.model) ? without_attributes(file.model) : file.model;
  for (std::size_t e = 0; e < plain.entities.size(); ++e) {
    const SplineEntity& entity = plain.entities[e];
    if (std::holds_alternative<ExactVolume>(entity.shape))
      volumes.entities.push_back(entity);
    else if (std::holds_alternative<ExactSurface>(entity.shape) ||
             std::holds_alternative<ExactTriangle>(entity.shape))
      others.entities.push_back(entity);
    else
      return bad_argument("entity " + std::to_string(e) + " is a " + spline_kind_name(entity) +
                          "; tiles are made of surfaces, triangles and volumes");
  }
  std::vector<Patch> out;
  if (!volumes.entities.empty()) {
    Result<BoundaryFaces> faces = boundary_faces(volumes);
    if (!faces) return faces.error();
    for (SplineEntity& face : faces->model.entities) others.entities.push_back(std::move(face));
  }
  if (others.entities.empty() && has_polygons) return std::vector<Patch>();
  if (others.entities.empty()) return Error{Code::kEmpty, {}, "the file has no surface"};
  Result<PatchSource> source = patch_source(others);
  if (!source) return source.error();
  if (!source->foreign.empty())
    return bad_argument("the file has " + to_string(source->foreign[0]));
  return std::move(source->patches);
}

struct TileParts {
  std::vector<TilePatch> curved;
  std::vector<internal::TileFacet> facets;
};

std::optional<Error> add_splines(const SplineFile& file, bool has_polygons, TileParts& parts) {
  Result<std::vector<Patch>> patches = tile_patches_of(file, has_polygons);
  if (!patches) return patches.error();
  if (patches->size() > 2 * kMaxTilePatches) return too_many_tile_patches(patches->size());
  for (const Patch& patch : *patches) {
    Result<TilePatch> made = tile_patch_of(patch, to_string(patch.origin()));
    if (!made) return made.error();
    if (patch.is_flat_triangle()) {
      const std::vector<TilePoint>& p = made->points.front();
      parts.facets.push_back({{p[0], p[2], p[3]}, std::nullopt});
    } else {
      parts.curved.push_back(std::move(*made));
    }
  }
  return std::nullopt;
}

std::optional<Error> add_mesh(const MeshFile& file, TileParts& parts) {
  if (file.mesh.faces.size() > 2 * kMaxTilePatches)
    return over_tile_limit(file.mesh.faces.size(), " triangles", 2 * kMaxTilePatches);
  for (std::size_t f = 0; f < file.mesh.faces.size(); ++f) {
    internal::TileFacet& facet = parts.facets.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d& p = file.mesh.positions[file.mesh.faces[f][c]];
      facet.corners[c] = {Rational::from_double(p.x), Rational::from_double(p.y),
                          Rational::from_double(p.z)};
    }
    if (!file.polygon_of_face.empty()) facet.polygon = file.polygon_of_face[f];
  }
  return std::nullopt;
}

}  // namespace

bool has_polygons_and_splines(const ModelFile& file) {
  const auto* const splines = std::get_if<SplineFile>(&file);
  return splines != nullptr && splines->format == SplineFormat::kItd &&
         std::any_of(splines->left_out.begin(), splines->left_out.end(),
                     [](const LeftOut& l) { return l.what == kPolygonsOfFile; });
}

Result<MicroTile> tile_of(const ModelFile& file, const std::string& name, TileFacets facets,
                          const MeshFile* polygons) {
  TileParts parts;
  std::optional<Error> error =
      bad_argument(std::string("the file is ") + title_of(kind_of(file)) + ", not a tile");
  if (const auto* const mesh = std::get_if<MeshFile>(&file))
    error = add_mesh(*mesh, parts);
  else if (const auto* const splines = std::get_if<SplineFile>(&file))
    error = add_splines(*splines, polygons != nullptr, parts);
  if (!error && polygons != nullptr) error = add_mesh(*polygons, parts);
  if (error) return *error;
  // Other patches keep their sides whole, so that those of triangles cannot be cut.
  if (!parts.curved.empty()) facets = TileFacets::kFewest;
  MicroTile out;
  out.name = name;
  out.patches = std::move(parts.curved);
  for (TilePatch& p : internal::patches_of_facets(parts.facets, facets))
    out.patches.push_back(std::move(p));
  out.patches = without_inner_walls(std::move(out.patches));
  if (out.patches.size() > kMaxTilePatches) return too_many_tile_patches(out.patches.size());
  if (Status status = check_tile(out, 0); !status) return status.error();
  return out;
}

}  // namespace veritope
