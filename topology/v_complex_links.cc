// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex_links.h"

#include <algorithm>
#include <cstddef>

#include "robust/base/disjoint_sets.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

// The uses that begin at a V-point, ascending, and what turns one into another.
class LinkUses {
 public:
  LinkUses(const VComplexTables& t, VPointId p) : t_(t), uses_(internal::uses_from(t, p)) {
    std::sort(uses_.begin(), uses_.end());
  }
  std::size_t size() const { return uses_.size(); }
  CurveUseId operator[](std::size_t i) const { return uses_[i]; }
  bool is_free(std::size_t i) const { return t_.uses[uses_[i]].mate.is_none(); }

  // The next corner of the cell's boundary around the point.
  std::size_t next_in_cell(std::size_t i) const {
    return at(t_.uses[t_.uses[uses_[i]].across].next);
  }
  // This corner in the mate of its half-V-surface. REQUIRES !is_free(i).
  std::size_t of_mate(std::size_t i) const { return at(t_.uses[t_.uses[uses_[i]].mate].next); }
  // A use of the same end of the same fan, or none.
  std::size_t in_fan(std::size_t i) const {
    const CurveUseId u = t_.uses[t_.uses[uses_[i]].across].mate;
    return u.is_none() ? i : at(u);
  }
  // For a free corner: the next free one around the component's boundary circle.
  std::size_t next_free(std::size_t i) const {
    CurveUseId u = uses_[i];
    for (;;) {
      const CurveUseId across = t_.uses[u].across;
      if (t_.uses[across].mate.is_none()) return at(t_.uses[across].next);
      u = t_.uses[across].mate;
    }
  }

 private:
  std::size_t at(CurveUseId u) const {
    const auto i = std::lower_bound(uses_.begin(), uses_.end(), u);
    VT_CHECK(i != uses_.end() && *i == u, "a use that does not begin at the V-point");
    return static_cast<std::size_t>(i - uses_.begin());
  }
  const VComplexTables& t_;
  std::vector<CurveUseId> uses_;
};

// Classes of 0, ..., n - 1 under a map to 0, ..., n - 1 that is defined where `has` says so.
template <class Has, class Map>
DisjointSets<std::size_t> link_classes(std::size_t n, Has has, Map map) {
  DisjointSets<std::size_t> out(n);
  for (std::size_t i = 0; i < n; ++i)
    if (has(i)) out.join(i, map(i));
  return out;
}

}  // namespace

VCurveLink link_of(const VComplex& complex, VCurveId curve) {
  VCurveLink out;
  for (const CurveUseId first : complex.curve(curve).fans)
    ++(complex.use(first).mate.is_none() ? out.open_fans : out.cyclic_fans);
  return out;
}

VPointLink link_of(const VComplex& complex, VPointId point) {
  const LinkUses uses(complex.tables(), point);
  const std::size_t n = uses.size();
  const auto always = [](std::size_t) { return true; };
  const auto free = [&](std::size_t i) { return uses.is_free(i); };
  const auto mated = [&](std::size_t i) { return !uses.is_free(i); };
  auto faces = link_classes(n, always, [&](std::size_t i) { return uses.next_in_cell(i); });
  auto edges = link_classes(n, mated, [&](std::size_t i) { return uses.of_mate(i); });
  auto vertices = link_classes(n, always, [&](std::size_t i) { return uses.in_fan(i); });
  auto circles = link_classes(n, free, [&](std::size_t i) { return uses.next_free(i); });
  DisjointSets<std::size_t> components(n);
  for (std::size_t i = 0; i < n; ++i) {
    components.join(i, faces.find(i));
    components.join(i, edges.find(i));
  }
  VPointLink out;
  std::vector<std::size_t> number(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t root = components.find(i);
    if (root == i) {
      number[i] = out.components.size();
      out.components.emplace_back().first_use = uses[i];
    }
    VPointLinkComponent& component = out.components[number[root]];
    component.faces += faces.find(i) == i;
    component.edges += edges.find(i) == i;
    component.vertices += vertices.find(i) == i;
    component.boundary_circles += uses.is_free(i) && circles.find(i) == i;
  }
  for (const VCurveId c : complex.point(point).curves)
    out.has_pinched_curve = out.has_pinched_curve || !link_of(complex, c).is_manifold();
  return out;
}

std::vector<VCurveId> nonmanifold_curves(const VComplex& complex) {
  std::vector<VCurveId> out;
  for (const VCurveId c : complex.tables().curves)
    if (!link_of(complex, c).is_manifold()) out.push_back(c);
  return out;
}

std::vector<VPointId> nonmanifold_points(const VComplex& complex) {
  std::vector<VPointId> out;
  for (const VPointId p : complex.tables().points)
    if (!link_of(complex, p).is_manifold()) out.push_back(p);
  return out;
}

bool is_manifold(const VComplex& complex) {
  return nonmanifold_curves(complex).empty() && nonmanifold_points(complex).empty();
}

std::vector<VCellBoundaryComponent> boundary_of_cell(const VComplex& complex, VCellId cell) {
  const VComplexTables& t = complex.tables();
  std::vector<HalfVSurfaceId> halves = t.cells[cell].half_surfaces;
  std::sort(halves.begin(), halves.end());
  const auto number_of = [&](HalfVSurfaceId h) {
    return static_cast<std::size_t>(std::lower_bound(halves.begin(), halves.end(), h) -
                                    halves.begin());
  };
  std::vector<CurveUseId> uses;
  DisjointSets<std::size_t> components(halves.size());
  for (const HalfVSurfaceId h : halves) {
    for (const CurveUseId u : internal::uses_of_half(t, h)) {
      uses.push_back(u);
      components.join(number_of(h), number_of(t.uses[t.uses[u].across].half_surface));
    }
  }
  std::sort(uses.begin(), uses.end());
  DisjointSets<std::size_t> corners(uses.size());
  const auto place_of = [&](CurveUseId u) {
    return static_cast<std::size_t>(std::lower_bound(uses.begin(), uses.end(), u) - uses.begin());
  };
  for (std::size_t i = 0; i < uses.size(); ++i)
    corners.join(i, place_of(t.uses[t.uses[uses[i]].across].next));
  std::vector<VCellBoundaryComponent> out;
  std::vector<std::size_t> of_half(halves.size());
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const std::size_t root = components.find(i);
    of_half[i] = root == i ? out.size() : of_half[root];
    if (root == i) out.emplace_back().first_half = halves[i];
    ++out[of_half[i]].half_surfaces;
    out[of_half[i]].loops += t.half_surfaces[halves[i]].loops.size();
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {
    VCellBoundaryComponent& component = out[of_half[number_of(t.uses[uses[i]].half_surface)]];
    component.corners += corners.find(i) == i;
    component.curves += uses[i] < t.uses[uses[i]].across;
  }
  return out;
}

}  // namespace veritope
