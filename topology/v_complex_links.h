// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_links.h: is a V-complex a 3-manifold with boundary at its V-curves and V-points?
#pragma once
#include <cstdint>
#include <vector>

#include "topology/v_complex.h"

namespace veritope {

/// The link of an inner point of a V-curve: a cycle for each cyclic fan, a path for each open one.
struct VCurveLink {
  std::uint32_t cyclic_fans = 0, open_fans = 0;
  bool is_manifold() const { return cyclic_fans + open_fans == 1; }
};
VCurveLink link_of(const VComplex& complex, VCurveId curve);

/// One component of the link of a V-point: what a small sphere around it meets. V-curves that end there with several
/// fans are several vertices of it, so that it is an oriented surface with boundary.
struct VPointLinkComponent {
  std::uint64_t vertices = 0, edges = 0,
                faces = 0;  ///< ends of fans, corners of V-surfaces, corners of V-cells
  std::uint64_t boundary_circles = 0;
  CurveUseId first_use;  ///< the least use that begins at the V-point in this component

  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(faces);
  }
  std::int64_t genus() const {
    return (2 - euler() - static_cast<std::int64_t>(boundary_circles)) / 2;
  }
  bool is_sphere() const { return boundary_circles == 0 && euler() == 2; }
  bool is_disk() const { return boundary_circles == 1 && euler() == 1; }
};

struct VPointLink {
  std::vector<VPointLinkComponent> components;  ///< by their first uses
  bool has_pinched_curve = false;               ///< a V-curve that ends there has several fans
  /// One sphere (the point is inside) or one disk (on the boundary).
  bool is_manifold() const {
    return !has_pinched_curve && components.size() == 1 &&
           (components[0].is_sphere() || components[0].is_disk());
  }
};
/// @cost O(k log k) for k uses of V-curves at the point
VPointLink link_of(const VComplex& complex, VPointId point);

/// Ascending. Between V-curves and V-points the complex always is a manifold with boundary.
std::vector<VCurveId> nonmanifold_curves(const VComplex& complex);
std::vector<VPointId> nonmanifold_points(const VComplex& complex);
bool is_manifold(const VComplex& complex);

/// One closed oriented surface of the boundary of a V-cell.
struct VCellBoundaryComponent {
  std::uint64_t corners = 0, curves = 0, half_surfaces = 0, loops = 0;
  HalfVSurfaceId first_half;  ///< the least one
  /// A half-V-surface with k loops has the Euler characteristic 2 - k.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(corners) - static_cast<std::int64_t>(curves) +
           2 * static_cast<std::int64_t>(half_surfaces) - static_cast<std::int64_t>(loops);
  }
  std::int64_t genus() const { return (2 - euler()) / 2; }
};
/// The boundary of a cell before anything is glued to it: a V-point or V-curve that it meets several times counts as
/// often. By first halves.
std::vector<VCellBoundaryComponent> boundary_of_cell(const VComplex& complex, VCellId cell);

}  // namespace veritope
