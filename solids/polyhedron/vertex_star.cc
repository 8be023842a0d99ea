// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/vertex_star.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "predicates/compare_along.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/chunk_internal.h"
#include "solids/polyhedron/normal_along.h"

namespace veritope {
namespace {

using internal::kChunk;

struct Fan {
  const TriangleMesh& mesh;
  std::span<const std::uint32_t> corners;
  const Vec3d& centre;

  // Facet i as (centre, p, q).
  std::pair<const Vec3d&, const Vec3d&> rim(std::size_t i) const {
    const auto& f = mesh.faces[corner_face(corners[i])];
    const std::uint32_t k = corner_index(corners[i]);
    return {mesh.positions[f[k == 2 ? 0 : k + 1]], mesh.positions[f[k == 0 ? 2 : k - 1]]};
  }
};

// Whether exactly one facet has g.(p - v) >= 0 > g.(q - v), with p and q exchanged if the fan is seen from behind.
// `before(x)` says g.(x - v) < 0.
template <typename Before>
bool turns_once(const Fan& fan, bool reversed, Before before) {
  unsigned turns = 0;
  for (std::size_t i = 0; i < fan.corners.size(); ++i) {
    const auto [p, q] = fan.rim(i);
    const bool bp = before(p), bq = before(q);
    turns += reversed ? (!bq && bp) : (!bp && bq);
  }
  return turns == 1;
}

// For a coordinate axis g is a coordinate axis, too, and its signs are comparisons.
bool turns_once_along_axis(const Fan& fan, int axis, bool reversed) {
  const Vec3d& v = fan.centre;
  if (axis == 0) return turns_once(fan, reversed, [&](const Vec3d& x) { return x.z < v.z; });
  if (axis == 1) return turns_once(fan, reversed, [&](const Vec3d& x) { return v.z < x.z; });
  return turns_once(fan, reversed, [&](const Vec3d& x) { return x.y < v.y; });
}

bool turns_once_along(const Fan& fan, const IntVec3& d, bool reversed) {
  const Vec3d g = (d[1] != 0 || d[2] != 0)
                      ? Vec3d{0, static_cast<double>(d[2]), -static_cast<double>(d[1])}
                      : Vec3d{0, 0, 1};
  return turns_once(fan, reversed, [&](const Vec3d& x) {
    return compare_along(g, x, fan.centre) == Sign::kNegative;
  });
}

// +1 or -1 if n.d certainly has that sign for all facets, else 0.
int common_sign(const std::vector<FacetNormal>& normals, const IntVec3& d) {
  int common = 0;
  for (const auto& n : normals) {
    const Sign3 s = n.sign_along(d);
    if (!is_certain(s) || (common != 0 && static_cast<int>(s) != common)) return 0;
    common = static_cast<int>(s);
  }
  return common;
}

bool holds_along(const Fan& fan, const std::vector<FacetNormal>& normals, const IntVec3& d) {
  const int s = common_sign(normals, d);
  return s != 0 && turns_once_along(fan, d, s < 0);
}

// The sum of the unit normals, rounded to integers.
IntVec3 mean_direction(const std::vector<FacetNormal>& normals) {
  double sum[3] = {0, 0, 0};
  for (const auto& n : normals) {
    const double length =
        std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);  // too large or small: skipped
    if (!(length > 0) || !std::isfinite(length)) continue;
    sum[0] += n.x / length;
    sum[1] += n.y / length;
    sum[2] += n.z / length;
  }
  const double scale = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])});
  IntVec3 d{0, 0, 0};
  if (!(scale > 0)) return d;
  for (int k = 0; k < 3; ++k)
    d[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(std::lround(sum[k] / scale * 1023));
  return d;
}

class StarFinder {
 public:
  StarFinder(const TriangleMesh& mesh, const Incidence& incidence, const FacetSigns& signs)
      : mesh_(mesh), incidence_(incidence), signs_(signs) {}

  // The code of v; `own` is set if it is kOwnDirection.
  std::uint8_t find(std::uint32_t v, IntVec3& own) {
    const Fan fan{mesh_, incidence_.corners(v), mesh_.positions[v]};
    if (fan.corners.size() < 3) return kNoStar;
    unsigned common = 0x3f;
    for (std::uint32_t c : fan.corners) common &= signs_.signs[corner_face(c)];
    for (int axis = 0; axis < 3; ++axis) {
      const unsigned bits = common >> (2 * axis) & 3u;
      if (bits != 0 && turns_once_along_axis(fan, axis, bits == 2))
        return static_cast<std::uint8_t>(1 + axis);
    }
    return find_oblique(fan, own);
  }

 private:
  std::uint8_t find_oblique(const Fan& fan, IntVec3& own) {
    normals_.clear();
    for (std::uint32_t c : fan.corners) {
      const auto& f = mesh_.faces[corner_face(c)];
      normals_.emplace_back(mesh_.positions[f[0]], mesh_.positions[f[1]], mesh_.positions[f[2]]);
    }
    for (std::uint8_t code = 4; code < kStarDirections.size(); ++code)
      if (holds_along(fan, normals_, kStarDirections[code])) return code;
    own = mean_direction(normals_);
    return own != IntVec3{0, 0, 0} && holds_along(fan, normals_, own) ? kOwnDirection : kNoStar;
  }

  const TriangleMesh& mesh_;
  const Incidence& incidence_;
  const FacetSigns& signs_;
  std::vector<FacetNormal> normals_;
};

}  // namespace

VertexStars find_vertex_stars(const TriangleMesh& mesh, const Incidence& incidence,
                              const FacetSigns& signs, std::span<const std::uint32_t> irregular,
                              unsigned jobs) {
  VertexStars out;
  const std::size_t n = incidence.num_vertices();
  out.code.resize(n);
  std::vector<decltype(out.own)> own(num_chunks(n, kChunk));
  parallel_for(n, kChunk, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    StarFinder finder(mesh, incidence, signs);
    IntVec3 direction{};
    auto skip = std::lower_bound(irregular.begin(), irregular.end(), begin);
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<std::uint32_t>(i);
      if (skip != irregular.end() && *skip == v) {
        ++skip;
        continue;
      }
      out.code[i] = finder.find(v, direction);
      if (out.code[i] == kOwnDirection) own[chunk].emplace_back(v, direction);
    }
  });
  for (const auto& part : own) out.own.insert(out.own.end(), part.begin(), part.end());
  return out;
}

}  // namespace veritope
