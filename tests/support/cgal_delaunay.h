// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/cgal_delaunay.h: CGAL's Delaunay tetrahedralization, an oracle. Its rule for points of one sphere is
// that of [DT11], too.
#pragma once
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "predicates/vec.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The finite cells. Any one of several points at one place may be a corner.
inline std::vector<TetrahedronCorners> cgal_delaunay(std::span<const Vec3d> points) {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, CgalKernel>;
  using Data = CGAL::Triangulation_data_structure_3<Vertex>;
  std::vector<std::pair<CgalKernel::Point_3, std::uint32_t>> numbered;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(CgalKernel::Point_3(points[i].x, points[i].y, points[i].z), i);
  const CGAL::Delaunay_triangulation_3<CgalKernel, Data> triangulation(numbered.begin(),
                                                                       numbered.end());
  std::vector<TetrahedronCorners> out;
  for (const auto cell : triangulation.finite_cell_handles())
    out.push_back({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                   cell->vertex(3)->info()});
  return out;
}

}  // namespace veritope
