// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/facet_signs.h"

#include "predicates/orient2d.h"
#include "predicates/projection.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/chunk_internal.h"

namespace veritope {
namespace {

using internal::kChunk;

template <typename Decide>
NormalSigns signs_by(const Vec3d& a, const Vec3d& b, const Vec3d& c, Decide decide) {
  unsigned out = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int s =
        static_cast<int>(decide(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)));
    out |= (s == 1 ? 1u : (s == -1 ? 2u : 0u)) << (2 * axis);
  }
  return static_cast<NormalSigns>(out);
}

NormalSigns signs_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const NormalSigns fast =
      signs_by(a, b, c, [](Vec2d p, Vec2d q, Vec2d r) { return orient2d_filter(p, q, r); });
  if (fast != 0) [[likely]]
    return fast;
  return signs_by(a, b, c, [](Vec2d p, Vec2d q, Vec2d r) { return orient2d(p, q, r); });
}

}  // namespace

FacetSigns facet_signs(const TriangleMesh& mesh, unsigned jobs) {
  FacetSigns out;
  out.signs.resize(mesh.faces.size());
  std::vector<std::vector<std::uint32_t>> degenerate(num_chunks(mesh.faces.size(), kChunk));
  parallel_for(
      mesh.faces.size(), kChunk, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const auto& t = mesh.faces[f];
          out.signs[f] = signs_of(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
          if (out.signs[f] == 0) degenerate[chunk].push_back(static_cast<std::uint32_t>(f));
        }
      });
  for (const auto& d : degenerate) out.degenerate.insert(out.degenerate.end(), d.begin(), d.end());
  return out;
}

}  // namespace veritope
