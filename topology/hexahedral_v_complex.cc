// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/hexahedral_v_complex.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <string>
#include <utility>

#include "robust/base/disjoint_sets.h"
#include "topology/hexahedral_numbers_internal.h"
#include "topology/v_complex_internal.h"

namespace veritope {
namespace {

using namespace internal::hexahedral;
using Kind = HexahedralFace::Kind;

Error cell_error(std::size_t cell, std::string message) {
  Error error = bad_argument("cell " + std::to_string(cell) + ": " + std::move(message));
  error.place.entity = cell;
  return error;
}

std::string face_name(unsigned face) { return {"uvw"[face / 2], "01"[face % 2]}; }
std::string edge_name(unsigned edge) {
  const auto& others = kOtherAxes[edge / 4];
  return face_name(2 * others[0] + (edge & 1u)) + face_name(2 * others[1] + (edge >> 1 & 1u));
}

class HexahedralMaker {
 public:
  explicit HexahedralMaker(const std::vector<HexahedralCell>& cells)
      : cells_(cells), points_(8 * cells.size()), edges_(12 * cells.size()) {}

  Result<HexahedralVComplex> make() {
    if (cells_.size() > (1u << 26)) return bad_argument("more than 2^26 cells");
    for (const auto step : {&HexahedralMaker::complete_gluings, &HexahedralMaker::mark_collapsed,
                            &HexahedralMaker::orient_cells, &HexahedralMaker::join_classes,
                            &HexahedralMaker::number_classes, &HexahedralMaker::add_halves,
                            &HexahedralMaker::pair_uses}) {
      const Status status = (this->*step)();
      if (!status) return status.error();
    }
    direct_curves();
    Result<VComplex> complex = VComplex::from_tables(std::move(t_));
    VT_CHECK(complex.has_value(), complex.error().message.c_str());
    out_.complex = std::move(complex).value();
    return std::move(out_);
  }

 private:
  static bool is_collapsed_face(const HexahedralFace& f) {
    return f.kind != Kind::kBoundary && f.kind != Kind::kGlued;
  }

  Status complete_gluings() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned f = 0; f < 6; ++f) {
        const HexahedralFace& face = cells_[c].faces[f];
        if (face.kind != Kind::kGlued) continue;
        const std::string where = "face " + face_name(f);
        if (face.cell >= cells_.size() || face.face >= 6 || face.symmetry >= 8)
          return cell_error(c,
                            where + " is glued to a face, or by a symmetry, that does not exist");
        if (face.cell == c && face.face == f) return cell_error(c, where + " is glued to itself");
        HexahedralFace& back = cells_[face.cell].faces[face.face];
        const HexahedralFace wanted{Kind::kGlued, static_cast<std::uint32_t>(c), f,
                                    inverse_symmetry(face.symmetry)};
        if (back.kind == Kind::kBoundary) back = wanted;
        if (is_collapsed_face(back)) return cell_error(c, where + " is glued to a collapsed face");
        if (back.cell != wanted.cell || back.face != wanted.face ||
            back.symmetry != wanted.symmetry)
          return cell_error(c, where + " is glued to a face that is glued in another way");
      }
    }
    return ok_status();
  }

  Status mark_collapsed() {
    for (HexahedralCell& cell : cells_) {
      for (unsigned f = 0; f < 6; ++f) {
        const Kind kind = cell.faces[f].kind;
        if (!is_collapsed_face(cell.faces[f])) continue;
        const auto ring = ring_of_face(f);
        for (unsigned k = 0; k < 4; ++k) {
          // Sides 0 and 2 of the ring run along the first parameter.
          const bool is_first = k % 2 == 0;
          if (kind == Kind::kToPoint || (kind == Kind::kAlongFirst) == is_first)
            cell.is_collapsed[edge_between(ring[k], ring[(k + 1) % 4])] = true;
        }
      }
    }
    return ok_status();
  }

  // Glued faces must be seen in opposite directions: that decides which cells are reversed.
  Status orient_cells() {
    out_.is_reversed.assign(cells_.size(), false);
    std::vector<bool> is_seen(cells_.size());
    std::vector<std::size_t> todo;
    for (std::size_t start = 0; start < cells_.size(); ++start) {
      if (is_seen[start]) continue;
      is_seen[start] = true;
      out_.is_reversed[start] = cells_[start].is_reversed;
      todo.push_back(start);
      while (!todo.empty()) {
        const std::size_t c = todo.back();
        todo.pop_back();
        for (unsigned f = 0; f < 6; ++f) {
          const HexahedralFace& face = cells_[c].faces[f];
          if (face.kind != Kind::kGlued) continue;
          const bool keeps = std::popcount(face.symmetry) % 2 == 0;
          const bool differs = (is_ring_outward(f) == is_ring_outward(face.face)) == keeps;
          const bool wanted = out_.is_reversed[c] != differs;
          if (is_seen[face.cell]) {
            if (out_.is_reversed[face.cell] != wanted)
              return cell_error(c, "face " + face_name(f) +
                                       " is glued so that its cells have no common orientation");
            continue;
          }
          is_seen[face.cell] = true;
          out_.is_reversed[face.cell] = wanted;
          todo.push_back(face.cell);
        }
      }
    }
    return ok_status();
  }

  std::uint32_t corner_id(std::size_t c, unsigned corner) const {
    return static_cast<std::uint32_t>(8 * c + corner);
  }
  std::uint32_t edge_id(std::size_t c, unsigned edge) const {
    return static_cast<std::uint32_t>(12 * c + edge);
  }

  Status join_classes() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned e = 0; e < 12; ++e)
        if (cells_[c].is_collapsed[e])
          points_.join(corner_id(c, begin_of_edge(e)), corner_id(c, end_of_edge(e)));
      for (unsigned f = 0; f < 6; ++f) {
        if (cells_[c].faces[f].kind == Kind::kGlued) {
          const Status status = join_glued(c, f);
          if (!status) return status;
        } else if (is_collapsed_face(cells_[c].faces[f])) {
          const Status status = join_collapsed(c, f);
          if (!status) return status;
        }
      }
    }
    return ok_status();
  }

  Status join_glued(std::size_t c, unsigned f) {
    const HexahedralFace& face = cells_[c].faces[f];
    const auto ring = ring_of_face(f);
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned from = ring[k], to = ring[(k + 1) % 4];
      const unsigned g = image_of_corner(f, from, face.face, face.symmetry);
      const unsigned h = image_of_corner(f, to, face.face, face.symmetry);
      points_.join(corner_id(c, from), corner_id(face.cell, g));
      const unsigned e = edge_between(from, to), d = edge_between(g, h);
      if (cells_[c].is_collapsed[e] != cells_[face.cell].is_collapsed[d])
        return cell_error(c, "edge " + edge_name(e) + " is collapsed, or is not, and edge " +
                                 edge_name(d) + " of cell " + std::to_string(face.cell) +
                                 ", which is glued to it, differs");
      edges_.join(edge_id(c, e), edge_id(face.cell, d));
    }
    return ok_status();
  }

  Status join_collapsed(std::size_t c, unsigned f) {
    const auto ring = ring_of_face(f);
    for (unsigned k = 0; k < 2; ++k) {
      const unsigned e = edge_between(ring[k], ring[k + 1]), d = opposite_edge(e, f);
      if (cells_[c].is_collapsed[e] != cells_[c].is_collapsed[d])
        return cell_error(c, "of edges " + edge_name(e) + " and " + edge_name(d) +
                                 ", which a collapsed face makes one, only one is collapsed");
      const bool is_kept = !cells_[c].is_collapsed[e];
      if (is_kept) edges_.join(edge_id(c, e), edge_id(c, d));
    }
    return ok_status();
  }

  // V-points and V-curves in the order of the least corners and edges of their classes.
  Status number_classes() {
    out_.half_surfaces.resize(cells_.size());
    out_.curves.resize(cells_.size());
    out_.points.resize(cells_.size());
    out_.is_edge_reversed.resize(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned corner = 0; corner < 8; ++corner) {
        const std::uint32_t least = points_.find(corner_id(c, corner));
        out_.points[c][corner] =
            least == corner_id(c, corner) ? t_.points.add({}) : out_.points[least / 8][least % 8];
      }
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned e = 0; e < 12; ++e) {
        if (cells_[c].is_collapsed[e]) continue;
        const std::uint32_t least = edges_.find(edge_id(c, e));
        if (least != edge_id(c, e)) {
          out_.curves[c][e] = out_.curves[least / 12][least % 12];
          continue;
        }
        if (face_near(c, e).is_none)
          return cell_error(c, "edge " + edge_name(e) + " is between collapsed faces only");
        const std::array<VPointId, 2> ends{out_.points[c][begin_of_edge(e)],
                                           out_.points[c][end_of_edge(e)]};
        const VCurveId curve = out_.curves[c][e] = t_.curves.add({ends, {}});
        for (const VPointId p : ends) internal::add_curve_at(t_, p, curve);
        least_edge_.push_back(least);
      }
    }
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (const VPointId p : out_.points[c])
        if (t_.points[p].curves.empty())
          return cell_error(c, "all edges at a corner are collapsed");
    return ok_status();
  }

  Status add_halves() {
    use_of_.assign(24 * cells_.size(), {});
    for (std::size_t c = 0; c < cells_.size(); ++c)
      t_.cells.add({{static_cast<std::uint32_t>(c)}, {}});
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned f = 0; f < 6; ++f) {
        if (is_collapsed_face(cells_[c].faces[f])) continue;
        const Status status = add_half(c, f);
        if (!status) return status;
      }
    }
    return ok_status();
  }

  Status add_half(std::size_t c, unsigned f) {
    const VCellId cell{static_cast<std::uint32_t>(c)};
    const HexahedralFace& face = cells_[c].faces[f];
    const HalfVSurfaceId h = t_.half_surfaces.add({cell, cell.value, {}, {}});
    out_.half_surfaces[c][f] = h;
    t_.cells[cell].half_surfaces.push_back(h);
    const HalfVSurfaceId mate =
        face.kind == Kind::kGlued ? out_.half_surfaces[face.cell][face.face] : HalfVSurfaceId{};
    if (mate.is_none()) {
      t_.half_surfaces[h].surface = t_.surfaces.add({{h, HalfVSurfaceId{}}});
    } else {
      t_.half_surfaces[h].surface = t_.half_surfaces[mate].surface;
      t_.surfaces[t_.half_surfaces[h].surface].halves[1] = h;
    }
    return add_loop(c, f, h);
  }

  Status add_loop(std::size_t c, unsigned f, HalfVSurfaceId h) {
    auto ring = ring_of_face(f);
    if (is_ring_outward(f) == out_.is_reversed[c]) std::reverse(ring.begin(), ring.end());
    std::vector<CurveUseId> loop;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned from = ring[k], to = ring[(k + 1) % 4], e = edge_between(from, to);
      if (cells_[c].is_collapsed[e]) continue;
      const bool runs_up = from < to;
      const CurveUseId u = t_.uses.add({h, {}, {}, out_.curves[c][e], runs_up, {}, {}});
      use_at(c, f, e) = u;
      loop.push_back(u);
    }
    if (loop.empty())
      return cell_error(
          c, "all edges of face " + face_name(f) + " are collapsed, but the face is not");
    for (std::size_t i = 0; i < loop.size(); ++i)
      internal::join_uses(t_, loop[i], loop[(i + 1) % loop.size()]);
    t_.half_surfaces[h].loops.push_back(loop[0]);
    return ok_status();
  }

  CurveUseId& use_at(std::size_t c, unsigned f, unsigned e) {
    // The face across the lesser axis is the first one at an edge.
    const unsigned side = f / 2 == kOtherAxes[e / 4][0] ? 0 : 1;
    return use_of_[2 * edge_id(c, e) + side];
  }

  // Where the edge of a cell, or one that collapsed faces make one with it, is an edge of a half-V-surface.
  struct FaceNear {
    bool is_none = false;
    unsigned face = 0, edge = 0;
  };
  FaceNear face_near(std::size_t c, unsigned e) const { return beyond(c, e, other_face(e, 6)); }
  // From the edge e of the face g on, through collapsed faces.
  FaceNear beyond(std::size_t c, unsigned e, unsigned g) const {
    unsigned d = e;
    for (unsigned steps = 0; is_collapsed_face(cells_[c].faces[g]); ++steps) {
      if (steps == 6) return {true, 0, 0};
      d = opposite_edge(d, g);
      g = other_face(d, g);
    }
    return {false, g, d};
  }

  Status pair_uses() {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned e = 0; e < 12; ++e) {
        if (cells_[c].is_collapsed[e]) continue;
        const unsigned f = other_face(e, 6);
        for (const unsigned g : {f, other_face(e, f)})
          if (!is_collapsed_face(cells_[c].faces[g])) pair_use(c, g, e);
      }
    }
    return ok_status();
  }

  // Finds the use across, and the mate.
  void pair_use(std::size_t c, unsigned f, unsigned e) {
    const CurveUseId u = use_at(c, f, e);
    const FaceNear near = beyond(c, e, other_face(e, f));
    VT_CHECK(!near.is_none, "collapsed faces without an end");
    t_.uses[u].across = use_at(c, near.face, near.edge);
    const HexahedralFace& face = cells_[c].faces[f];
    if (face.kind != Kind::kGlued) return;
    const unsigned from = image_of_corner(f, begin_of_edge(e), face.face, face.symmetry);
    const unsigned to = image_of_corner(f, end_of_edge(e), face.face, face.symmetry);
    t_.uses[u].mate = use_at(face.cell, face.face, edge_between(from, to));
  }

  CurveUseId use_near(std::size_t c, unsigned e) {
    const FaceNear near = face_near(c, e);
    return use_at(c, near.face, near.edge);
  }

  // Directions are those of the cells' edges until here. Now they are given from use to use, so that a curve runs as
  // the least edge of its class.
  void direct_curves() {
    std::vector<bool> runs_up;
    std::vector<std::vector<CurveUseId>> uses(t_.curves.end_id());
    for (const CurveUseId u : t_.uses) {
      runs_up.push_back(t_.uses[u].is_forward);
      uses[t_.uses[u].curve.value].push_back(u);
    }
    for (const VCurveId c : t_.curves) {
      direct_uses(uses[c.value], use_near(least_edge_[c.value] / 12, least_edge_[c.value] % 12));
      t_.curves[c].fans = internal::fans_of_uses(t_, uses[c.value]);
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      for (unsigned e = 0; e < 12; ++e) {
        if (cells_[c].is_collapsed[e]) continue;
        const CurveUseId u = use_near(c, e);
        out_.is_edge_reversed[c][e] = t_.uses[u].is_forward != runs_up[u.value];
      }
    }
  }

  // A class of edges is one fan: across and mate connect all its uses, and each step turns the direction.
  void direct_uses(const std::vector<CurveUseId>& uses, CurveUseId first) {
    std::vector<bool> is_done(uses.size());
    std::vector<CurveUseId> todo;
    const auto visit = [&](CurveUseId v, bool is_forward) {
      const auto i =
          static_cast<std::size_t>(std::lower_bound(uses.begin(), uses.end(), v) - uses.begin());
      VT_CHECK(i < uses.size() && uses[i] == v, "a fan leaves its V-curve");
      if (is_done[i]) return;
      is_done[i] = true;
      t_.uses[v].is_forward = is_forward;
      todo.push_back(v);
    };
    visit(first, t_.uses[first].is_forward);
    while (!todo.empty()) {
      const CurveUse use = t_.uses[todo.back()];
      todo.pop_back();
      visit(use.across, !use.is_forward);
      if (!use.mate.is_none()) visit(use.mate, !use.is_forward);
    }
  }

  std::vector<HexahedralCell> cells_;
  DisjointSets<std::uint32_t> points_, edges_;
  VComplexTables t_;
  std::vector<CurveUseId> use_of_;         // 24 of each cell: two of each edge
  std::vector<std::uint32_t> least_edge_;  // of each V-curve
  HexahedralVComplex out_;
};

}  // namespace

std::uint32_t inverse_symmetry(std::uint32_t symmetry) {
  // (a, b) -> exchange -> reverse. Backwards: reverse, then exchange, so the reversals change places.
  if ((symmetry & 1u) == 0) return symmetry;
  return 1u | (symmetry & 2u) << 1 | (symmetry & 4u) >> 1;
}

Result<HexahedralVComplex> hexahedral_v_complex(const std::vector<HexahedralCell>& cells) {
  return HexahedralMaker(cells).make();
}

}  // namespace veritope
