// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Corners = std::array<DmsPoint, 4>;
using CellEdge = std::array<std::uint32_t, 2>;

// A convex polygon of a cell: its corners in order, no three of them on one line.
struct Facet {
  std::vector<std::uint32_t> corners;
  DmsPlane plane;
};
struct Cell {
  std::vector<DmsPoint> corners;
  std::vector<Facet> facets;
  std::vector<DmsSupport> supports;  // those that may reach into it
};

Cell cell_of(const Corners& corners) {
  Cell out{{corners.begin(), corners.end()}, {}, {}};
  std::vector<DmsPlane> planes = face_planes(corners);
  const std::array<std::vector<std::uint32_t>, 4> faces = {
      {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
  for (std::size_t f = 0; f < 4; ++f) out.facets.push_back({faces[f], std::move(planes[f])});
  return out;
}

CellEdge cell_edge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// One polygon of all these edges. REQUIRES that they are one.
std::vector<std::uint32_t> loop_of(
    const std::map<std::uint32_t, std::vector<std::uint32_t>>& next) {
  std::vector<std::uint32_t> out{next.begin()->first};
  std::uint32_t before = next.begin()->second.at(1);
  for (;;) {
    const std::uint32_t at = out.back();
    const std::vector<std::uint32_t>& both = next.at(at);
    VT_CHECK(both.size() == 2, "a plane that cuts a convex cell meets it in one polygon");
    const std::uint32_t to = both[0] == before ? both[1] : both[0];
    if (to == out.front()) break;
    before = at;
    out.push_back(to);
  }
  VT_CHECK(out.size() == next.size(), "a plane that cuts a convex cell meets it in one polygon");
  return out;
}

// The part of a cell on one side of a plane.
class HalfCell {
 public:
  HalfCell(const Cell& cell, const std::vector<Rational>& heights, int side)
      : cell_(cell), heights_(heights), side_(side) {}

  Cell cut(const DmsPlane& plane) && {
    for (const Facet& facet : cell_.facets) add(facet);
    std::map<std::uint32_t, std::vector<std::uint32_t>> next;
    for (const auto& [a, b] : section_) {
      next[a].push_back(b);
      next[b].push_back(a);
    }
    out_.facets.push_back({loop_of(next), plane});
    out_.supports = cell_.supports;
    return std::move(out_);
  }

 private:
  int sign(std::uint32_t corner) const { return side_ * static_cast<int>(heights_[corner].sign()); }
  std::uint32_t number(const CellEdge& edge) {
    const auto [at, is_new] =
        numbers_.try_emplace(edge, static_cast<std::uint32_t>(out_.corners.size()));
    if (!is_new) return at->second;
    const auto [a, b] = edge;
    DmsPoint p = cell_.corners[a];
    if (a != b) {
      const Rational t = heights_[a] / (heights_[a] - heights_[b]);
      for (std::size_t c = 0; c < 3; ++c) p[c] += t * (cell_.corners[b][c] - cell_.corners[a][c]);
    }
    out_.corners.push_back(std::move(p));
    return at->second;
  }
  void add(const Facet& facet) {
    Facet kept{{}, facet.plane};
    std::vector<std::uint32_t> in_plane;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      const std::uint32_t a = facet.corners[i], b = facet.corners[(i + 1) % facet.corners.size()];
      if (sign(a) >= 0) kept.corners.push_back(number({a, a}));
      if (sign(a) == 0) in_plane.push_back(kept.corners.back());
      if (sign(a) * sign(b) >= 0) continue;
      kept.corners.push_back(number(cell_edge(a, b)));
      in_plane.push_back(kept.corners.back());
    }
    if (in_plane.size() == 2) section_.insert(cell_edge(in_plane[0], in_plane[1]));
    if (kept.corners.size() >= 3) out_.facets.push_back(std::move(kept));
  }

  const Cell& cell_;
  const std::vector<Rational>& heights_;
  int side_;
  Cell out_;
  std::map<CellEdge, std::uint32_t> numbers_;  // two equal ends: a corner of the cell
  std::set<CellEdge> section_;                 // edges in the plane
};

class Parts {
 public:
  Parts(const DmsKnotTable& knots, std::uint32_t tetrahedron)
      : knots_(knots), root_planes_(face_planes(knots.corners(tetrahedron))) {}

  std::optional<std::vector<DmsCell>> run(Cell root, std::size_t max_cells) {
    root.supports = region(root).supports();
    std::vector<Cell> todo;
    todo.push_back(std::move(root));
    while (!todo.empty()) {
      Cell cell = std::move(todo.back());
      todo.pop_back();
      DmsRegion near = region(cell);
      std::erase_if(cell.supports,
                    [&](const DmsSupport& s) { return near.misses(knots_.knots(s)); });
      const auto three = near.find_cut(cell.supports);
      if (!three) {
        parts_.push_back(finished(cell));
        continue;
      }
      if (parts_.size() + todo.size() + 2 > max_cells) return std::nullopt;
      const DmsPlane plane = plane_of(*three);
      std::vector<Rational> heights;
      for (const DmsPoint& p : cell.corners)
        heights.push_back(dot_product(plane.vector, p) - plane.number);
      todo.push_back(HalfCell(cell, heights, 1).cut(plane));
      todo.push_back(HalfCell(cell, heights, -1).cut(plane));
    }
    return std::move(parts_);
  }

 private:
  DmsRegion region(const Cell& cell) const {
    std::vector<DmsPlane> planes;
    for (const Facet& f : cell.facets) planes.push_back(f.plane);
    planes.insert(planes.end(), root_planes_.begin(), root_planes_.end());
    return {knots_, cell.corners, planes};
  }
  DmsPlane plane_of(const std::array<std::uint32_t, 3>& three) const {
    const DmsPoint& o = knots_.point(three[0]);
    DmsPlane out{
        cross_product(difference(knots_.point(three[1]), o), difference(knots_.point(three[2]), o)),
        {}};
    out.number = dot_product(out.vector, o);
    return out;
  }
  static Corners oriented(Corners corners) {
    const DmsPoint a = difference(corners[1], corners[0]), b = difference(corners[2], corners[0]),
                   c = difference(corners[3], corners[0]);
    if (dot_product(a, cross_product(b, c)).sign() == Sign::kNegative)
      std::swap(corners[2], corners[3]);
    return corners;
  }
  static DmsCell finished(Cell& cell) {
    DmsCell out;
    for (Facet& f : cell.facets) {
      const std::vector<std::uint32_t>& c = f.corners;
      if (std::find(c.begin(), c.end(), 0) == c.end())
        for (std::size_t i = 1; i + 1 < c.size(); ++i)
          out.tetrahedra.push_back(oriented(
              {cell.corners[0], cell.corners[c[0]], cell.corners[c[i]], cell.corners[c[i + 1]]}));
      if (side_of_plane(cell.corners, f.plane) < 0) {
        for (Rational& x : f.plane.vector) x.negate();
        f.plane.number.negate();
      }
      out.planes.push_back(std::move(f.plane));
    }
    out.corners = std::move(cell.corners);
    return out;
  }

  const DmsKnotTable& knots_;
  std::vector<DmsPlane> root_planes_;
  std::vector<DmsCell> parts_;
};

}  // namespace

std::optional<std::vector<DmsCell>> polynomial_parts(const DmsKnotTable& knots,
                                                     std::uint32_t tetrahedron,
                                                     std::size_t max_cells) {
  return Parts(knots, tetrahedron).run(cell_of(knots.corners(tetrahedron)), max_cells);
}

}  // namespace veritope
