// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/mesh_cells.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "predicates/orient3d.h"
#include "robust/base/box3d.h"
#include "robust/base/check.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/domain/mesh_triangles.h"

namespace veritope {
namespace {

Box3d box_of(std::span<const Vec3d> points, std::span<const std::uint32_t> ids) {
  Box3d box = empty_box();
  for (const std::uint32_t v : ids) add(to_point(points[v]), &box);
  return box;
}

// Whether all signs are 0 or opposite to `side`.
template <typename Signs>
bool are_beyond(const Signs& signs, Sign side) {
  return std::none_of(signs.begin(), signs.end(), [&](Sign s) { return s == side; });
}

class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, std::span<const TetrahedronCorners> tetrahedra,
         std::size_t max_vertices)
      : mesh_(mesh),
        triangles_(mesh),
        cells_(mesh.positions, tetrahedra, planes_of(mesh)),
        near_(tetrahedra.size()),
        pending_(tetrahedra.size()),
        max_vertices_(max_vertices) {
    find_near(tetrahedra);
  }

  Result<MeshCells> run() {
    if (const Status status = cut_all(); !status) return status.error();
    std::vector<std::uint32_t> on_mesh(cells_.faces().size());
    for (std::uint32_t f = 0; f < on_mesh.size(); ++f) on_mesh[f] = triangle_at(f);
    std::vector<std::uint8_t> inside = flood(on_mesh);
    return MeshCells{std::move(cells_), std::move(on_mesh), std::move(inside), cuts_};
  }

 private:
  using Section = std::array<Sign, 3>;

  static std::vector<CellPlane> planes_of(const TriangleMesh& mesh) {
    return {mesh.faces.begin(), mesh.faces.end()};
  }

  Sign side(std::uint32_t plane, const Vec3d& p) const {
    const CellPlane& q = cells_.planes()[plane];
    const auto points = cells_.points();
    return orient3d(points[q[0]], points[q[1]], points[q[2]], p);
  }
  Section sides_of_corners(std::uint32_t plane, std::uint32_t t) const {
    const CellPlane& q = cells_.planes()[plane];
    Section out{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles_.corners(t)[k];
      out[k] = std::find(q.begin(), q.end(), v) != q.end() ? Sign::kZero
                                                           : side(plane, mesh_.positions[v]);
    }
    return out;
  }

  // The triangles that may cut a tetrahedron, or share an area with one of its faces.
  void find_near(std::span<const TetrahedronCorners> tetrahedra) {
    std::vector<Box3d> boxes;
    boxes.reserve(tetrahedra.size());
    for (const TetrahedronCorners& t : tetrahedra) boxes.push_back(box_of(mesh_.positions, t));
    const BoxHierarchy tree(boxes);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Box3d box = box_of(mesh_.positions, triangles_.corners(t));
      tree.visit([&](const Box3d& b) { return meets(b, box); },
                 [&](std::uint32_t cell) { add_near(cell, t); });
    }
  }

  void add_near(std::uint32_t cell, std::uint32_t t) {
    bool is_flat = false;
    for (const CellHalfSpace& s : cells_.cells()[cell].sides) {
      const Section corners = sides_of_corners(s.plane, t);
      const bool lies_in_it = corners == Section{};
      is_flat |= lies_in_it;
      if (!lies_in_it && are_beyond(corners, s.side)) return;
    }
    if (is_flat) return near_[cell].push_back(t);
    bool is_above = false, is_below = false;
    for (const std::uint32_t v : cells_.skeleton(cell).vertices) {
      const Sign s = cells_.side(t, v);
      is_above |= s == Sign::kPositive;
      is_below |= s == Sign::kNegative;
    }
    if (!(is_above && is_below)) return;
    near_[cell].push_back(t);
    pending_[cell].push_back(t);
  }

  Status cut_all() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t c = 0; c < pending_.size(); ++c)
      if (!pending_[c].empty()) open.push_back(c);
    while (!open.empty()) {
      const std::uint32_t c = open.back();
      std::vector<std::uint32_t>& pending = pending_[c];
      pending.erase(std::remove_if(pending.begin(), pending.end(),
                                   [&](std::uint32_t t) { return !enters(t, c); }),
                    pending.end());
      if (pending.empty()) {
        open.pop_back();
        continue;
      }
      const std::uint32_t t = best_cut(pending);
      const std::uint32_t other = cells_.cut(c, t);
      ++cuts_;
      part_pending(c, other, t);
      open.push_back(other);
      if (cells_.num_vertices() > max_vertices_) return over_limit();
    }
    return ok_status();
  }

  // One of the first triangles whose plane crosses fewest of the others.
  std::uint32_t best_cut(const std::vector<std::uint32_t>& pending) const {
    constexpr std::size_t kCandidates = 8, kCrossed = 64;
    std::uint32_t best = pending[0];
    std::size_t fewest = pending.size();
    for (std::size_t i = 0; i < std::min(kCandidates, pending.size()); ++i) {
      std::size_t crossed = 0;
      for (std::size_t j = 0; j < std::min(kCrossed, pending.size()); ++j) {
        const Section corners = sides_of_corners(pending[i], pending[j]);
        if (!are_beyond(corners, Sign::kPositive) && !are_beyond(corners, Sign::kNegative))
          ++crossed;
      }
      if (crossed < fewest) fewest = crossed, best = pending[i];
    }
    return best;
  }

  Error over_limit() const {
    return {Code::kOverLimit,
            {},
            "more than " + std::to_string(max_vertices_) +
                " vertices arise, the limit of --max-vertices"};
  }

  // The triangles of a cell go to those of its parts that they may enter.
  void part_pending(std::uint32_t above, std::uint32_t below, std::uint32_t plane) {
    std::vector<std::uint32_t> all = std::move(pending_[above]), upper, lower;
    for (const std::uint32_t t : all) {
      if (t == plane) continue;
      const Section corners = sides_of_corners(plane, t);
      if (!are_beyond(corners, Sign::kPositive)) upper.push_back(t);
      if (!are_beyond(corners, Sign::kNegative)) lower.push_back(t);
    }
    pending_[above] = std::move(upper);
    pending_.resize(std::max<std::size_t>(pending_.size(), below + 1));
    pending_[below] = std::move(lower);
  }

  // Whether the triangle meets the inside of the cell. Its plane meets the cell in a convex polygon. The inside of this
  // and the triangle are disjoint iff the line of a side of either one separates them.
  bool enters(std::uint32_t t, std::uint32_t cell) {
    for (const CellHalfSpace& s : cells_.cells()[cell].sides)
      if (are_beyond(sides_of_corners(s.plane, t), s.side)) return false;
    const ConvexCells::Skeleton& parts = cells_.skeleton(cell);
    signs_.resize(cells_.num_vertices());
    bool is_above = false, is_below = false;
    for (const std::uint32_t v : parts.vertices) {
      const Sign s = signs_[v] = cells_.side(t, v);
      is_above |= s == Sign::kPositive;
      is_below |= s == Sign::kNegative;
    }
    if (!(is_above && is_below)) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (is_section_beyond(t, k, parts)) return false;
    return true;
  }

  // Whether the polygon lies on the outer side of a side of the triangle.
  bool is_section_beyond(std::uint32_t t, std::size_t k, const ConvexCells::Skeleton& parts) {
    const auto rim = triangles_.rim(t, k);
    const Sign inner = triangles_.rim_side(t, k);
    rim_signs_.resize(signs_.size());
    for (const std::uint32_t v : parts.vertices) {
      rim_signs_[v] = cells_.side(rim, v);
      if (signs_[v] == Sign::kZero && rim_signs_[v] == inner) return false;
    }
    for (const std::uint32_t e : parts.edges) {
      const auto [a, b] = cells_.edges()[e].ends;
      if (signs_[a] * signs_[b] != Sign::kNegative) continue;
      const bool a_is_inner = rim_signs_[a] == inner, b_is_inner = rim_signs_[b] == inner;
      if (!a_is_inner && !b_is_inner) continue;
      if (a_is_inner && b_is_inner) return false;
      if (cells_.side_of_crossing(rim, e, t) == inner) return false;
    }
    return true;
  }

  // Once nothing enters a cell, each face lies on the mesh or has no inner point in common with it.
  std::uint32_t triangle_at(std::uint32_t f) const {
    const CellFace& face = cells_.faces()[f];
    const std::uint32_t tetrahedron = cells_.cells()[face.cells[0]].tetrahedron;
    for (const std::uint32_t t : near_[tetrahedron])
      if ((face.plane == t || sides_of_corners(face.plane, t) == Section{}) && overlaps(face, t))
        return t;
    return MeshCells::kOff;
  }

  // Whether a face and a triangle in its plane have inner points in common.
  bool overlaps(const CellFace& face, std::uint32_t t) const {
    std::vector<Sign> signs(face.corners.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const auto rim = triangles_.rim(t, k);
      for (std::size_t i = 0; i < signs.size(); ++i) signs[i] = cells_.side(rim, face.corners[i]);
      if (are_beyond(signs, triangles_.rim_side(t, k))) return false;
    }
    return std::none_of(face.edges.begin(), face.edges.end(), [&](std::uint32_t e) {
      return is_beyond_edge(face, cells_.edges()[e].line, t);
    });
  }

  bool is_beyond_edge(const CellFace& face, const CellLine& line, std::uint32_t t) const {
    if (line.is_explicit)
      return is_beyond_plane(
          face, {mesh_.positions[line.of[0]], mesh_.positions[line.of[1]], triangles_.beside(t)},
          t);
    for (const std::uint32_t p : line.of) {
      if (p == face.plane) continue;
      const CellPlane& q = cells_.planes()[p];
      const auto points = cells_.points();
      if (is_beyond_plane(face, {points[q[0]], points[q[1]], points[q[2]]}, t)) return true;
    }
    return false;
  }
  // Whether the plane separates the triangle from the face, which does not lie in it.
  bool is_beyond_plane(const CellFace& face, const std::array<Vec3d, 3>& plane,
                       std::uint32_t t) const {
    Sign side = Sign::kZero;
    for (const std::uint32_t v : face.corners)
      if (side == Sign::kZero) side = cells_.side(plane, v);
    if (side == Sign::kZero) return false;
    Section corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = orient3d(plane[0], plane[1], plane[2], triangles_.point(t, k));
    return are_beyond(corners, side);
  }

  // Outside of the hull is outside; across a face one is on the other side iff the face lies on the mesh.
  std::vector<std::uint8_t> flood(const std::vector<std::uint32_t>& on_mesh) const {
    constexpr std::uint8_t kUnknown = 2;
    std::vector<std::uint8_t> inside(cells_.cells().size(), kUnknown);
    std::vector<std::uint32_t> open;
    const auto is_on_mesh = [&](std::uint32_t f) -> std::uint8_t {
      return on_mesh[f] != MeshCells::kOff;
    };
    const auto enter = [&](std::uint32_t cell, std::uint8_t value) {
      if (inside[cell] == kUnknown) open.push_back(cell), inside[cell] = value;
      VT_CHECK(inside[cell] == value,
               "each cell is either inside or outside of a mesh without defects");
    };
    for (std::uint32_t f = 0; f < on_mesh.size(); ++f)
      if (cells_.faces()[f].cells[1] == kNoCell) enter(cells_.faces()[f].cells[0], is_on_mesh(f));
    while (!open.empty()) {
      const std::uint32_t c = open.back();
      open.pop_back();
      for (const std::uint32_t f : cells_.cells()[c].faces)
        for (const std::uint32_t next : cells_.faces()[f].cells)
          if (next != kNoCell && next != c) enter(next, inside[c] ^ is_on_mesh(f));
    }
    return inside;
  }

  const TriangleMesh& mesh_;
  MeshTriangles triangles_;
  ConvexCells cells_;
  std::vector<std::vector<std::uint32_t>> near_;     // for each tetrahedron
  std::vector<std::vector<std::uint32_t>> pending_;  // for each cell
  std::size_t max_vertices_;
  std::uint64_t cuts_ = 0;
  std::vector<Sign> signs_, rim_signs_;
};

}  // namespace

Result<MeshCells> cut_along_mesh(const TriangleMesh& mesh,
                                 std::span<const TetrahedronCorners> tetrahedra,
                                 std::size_t max_vertices) {
  return Cutter(mesh, tetrahedra, max_vertices).run();
}

}  // namespace veritope
