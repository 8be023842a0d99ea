// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/nesting.h"

#include <algorithm>
#include <array>

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/facet_signs.h"

namespace veritope {
namespace {

constexpr std::uint32_t kNoVertex = 0xffffffffu;
constexpr std::size_t kFewBoxes = 32;  // a ray that meets no more is taken at once

// The edge {a, b} lies to the right of v, or beyond it upwards: see the stab rule.
bool counts(Vec2d a, Vec2d b, Vec2d v) {
  if ((a.y <= v.y) == (b.y <= v.y)) return false;
  const bool up = a.y <= v.y;
  return orient2d(up ? a : b, up ? b : a, v) == Sign::kPositive;
}

// The vertices of each shell that are greatest (code 2k) or least (2k + 1) in coordinate k; on a tie the least id.
using Extremes = std::array<std::uint32_t, 6>;

std::vector<Extremes> extreme_vertices(const TriangleMesh& mesh,
                                       std::span<const std::uint32_t> shell_of_face,
                                       std::size_t num_shells) {
  Extremes none;
  none.fill(kNoVertex);
  std::vector<Extremes> out(num_shells, none);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (shell_of_face[f] >= num_shells) continue;
    Extremes& e = out[shell_of_face[f]];
    for (std::uint32_t v : mesh.faces[f])
      for (int k = 0; k < 3; ++k) {
        const double c = mesh.positions[v][k];
        for (std::size_t side = 0; side < 2; ++side) {
          std::uint32_t& best = e[2 * static_cast<std::size_t>(k) + side];
          const double b = best == kNoVertex ? c : mesh.positions[best][k];
          const bool better = side == 0 ? c > b : c < b;
          if (best == kNoVertex || better || (c == b && v < best)) best = v;
        }
      }
  }
  return out;
}

struct Ray {
  std::uint8_t code = 0;
  std::vector<std::uint32_t> facets;
};

// The first of six directions that meets few boxes; the meaning of few grows until one does.
Ray choose_ray(const TriangleMesh& mesh, const BoxGroups& boxes, const Extremes& extremes) {
  Ray ray;
  for (std::size_t few = kFewBoxes;; few *= 8)
    for (ray.code = 0; ray.code < 6; ++ray.code) {
      ray.facets.clear();
      if (boxes.stabbed(mesh.positions[extremes[ray.code]], ray.code / 2, ray.code % 2 == 0, few,
                        ray.facets))
        return ray;
    }
}

std::uint32_t depth_along(const TriangleMesh& mesh, const Ray& ray, const Vec3d& from,
                          std::uint32_t shell, std::span<const std::uint32_t> shell_of_face) {
  std::vector<std::uint32_t> hit_shells;
  for (std::uint32_t f : ray.facets) {
    if (shell_of_face[f] == shell) continue;
    const Stab s = stab_facet(mesh, f, from, ray.code / 2, ray.code % 2 == 0);
    VT_CHECK(s != Stab::kTouch, "shells of an embedded surface touch");
    if (s == Stab::kHit) hit_shells.push_back(shell_of_face[f]);
  }
  std::sort(hit_shells.begin(), hit_shells.end());
  std::uint32_t depth = 0;
  for (std::size_t i = 0, j = 0; i < hit_shells.size(); i = j) {
    while (j < hit_shells.size() && hit_shells[j] == hit_shells[i]) ++j;
    depth += (j - i) % 2;
  }
  return depth;
}

}  // namespace

Stab stab_facet(const TriangleMesh& mesh, std::uint32_t facet, const Vec3d& from, int axis,
                bool positive) {
  const auto& t = mesh.faces[facet];
  const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  const Vec2d pa = drop_axis(a, axis), pb = drop_axis(b, axis), pc = drop_axis(c, axis);
  const Vec2d v = drop_axis(from, axis);
  if ((counts(pa, pb, v) + counts(pb, pc, v) + counts(pc, pa, v)) % 2 == 0) return Stab::kMiss;
  const Sign ahead = -orient3d(a, b, c, from) * orient2d(pa, pb, pc);
  if (ahead == Sign::kZero) return Stab::kTouch;
  return (ahead == Sign::kPositive) == positive ? Stab::kHit : Stab::kMiss;
}

Nesting nest_shells(const TriangleMesh& mesh, const BoxGroups& boxes,
                    std::span<const std::uint32_t> shell_of_face, std::size_t num_shells,
                    unsigned jobs) {
  Nesting out;
  out.depth.assign(num_shells, 0);
  out.axis_code.assign(num_shells, 0);
  if (num_shells < 2) return out;
  const auto extremes = extreme_vertices(mesh, shell_of_face, num_shells);
  parallel_for(num_shells, 16, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Ray ray = choose_ray(mesh, boxes, extremes[s]);
      out.axis_code[s] = ray.code;
      out.depth[s] = depth_along(mesh, ray, mesh.positions[extremes[s][ray.code]],
                                 static_cast<std::uint32_t>(s), shell_of_face);
    }
  });
  return out;
}

}  // namespace veritope
