// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/collar_defects.h"

#include <algorithm>
#include <optional>

namespace veritope {
namespace {

// A cavity at one place is enough for a collar. Where fewer cells than this are to be split they are split everywhere,
// which finds the place without an estimate.
constexpr std::size_t kManyCells = std::size_t{1} << 15;
constexpr double kReachOfCavity = 2;  // in cells, beside the one where it is sought

// Calls visit(number in the cover, number in the complex) for each cell of the cover. Both lists ascend by code, and
// the complex contains all cells of the cover.
template <typename Visit>
void for_each_cell(const PieceOctree& cover, const CommonSubdivision& complex, Visit visit) {
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < cover.num_cells(); ++i) {
    while (complex.cells()[at] != cover.key(i)) ++at;
    visit(i, at);
  }
}

class Splitter {
 public:
  Splitter(PieceForest& forest, FacingOfPieces& facing, const PieceOctree& cover,
           const CommonSubdivision& complex, const ComplexBoundary& boundary,
           const std::vector<BodyDefect>& bodies)
      : forest_(forest),
        facing_(facing),
        cover_(cover),
        c_(complex),
        b_(boundary),
        is_defect_(boundary.bodies.size()),
        has_one_shell_(boundary.bodies.size()) {
    for (const BodyDefect& d : bodies) {
      is_defect_[d.body] = true;
      if (d.lacks_cavity) flat_bodies_.push_back(d.body);
      has_one_shell_[d.body] = d.has_one_shell;
    }
  }

  std::vector<bool> run() {
    std::vector<LocalSheets> cells(c_.num_cells());
    std::vector<bool> is_filler(c_.num_cells(), true);
    for_each_cell(cover_, c_, [&](std::size_t i, std::uint32_t cell) {
      is_filler[cell] = false;
      if (is_defect_[b_.body_of_cell[cell]])
        cells[cell] = sheets_of(i, has_one_shell_[b_.body_of_cell[cell]]);
    });
    // Cells that only fill gaps join the bodies that they touch.
    const std::vector<LocalSheets> around = at_vertices(cells);
    for (std::uint32_t cell = 0; cell < c_.num_cells(); ++cell)
      if (is_filler[cell])
        for_each_vertex(cell, [&](std::uint32_t v) { cells[cell].add(around[v]); });
    std::vector<bool> out = choose(at_vertices(cells));
    for (const std::uint32_t body : flat_bodies_) keep_one_place(body, out);
    return out;
  }

 private:
  LocalSheets sheets_of(std::size_t cell, bool with_facing) {
    LocalSheets out;
    const Box3d box = cover_.root().box(cover_.key(cell));
    forest_.limit_memory(PieceForest::kNetMemory);
    cover_.for_each_piece(cell, [&](PieceForest::Id id) {
      const std::uint32_t shell = forest_.complex().shell(forest_.node(id).patch);
      out.add({with_facing && out.facing != 0 ? facing_.of_part(id, box) : out.facing, shell, shell});
    });
    return out;
  }
  template <typename Visit>
  void for_each_vertex(std::uint32_t cell, Visit visit) const {
    for (const std::uint32_t f : c_.faces_of_cell(cell))
      for (const std::uint32_t e : c_.edges_of_face(f))
        visit(c_.edges()[e].lower), visit(c_.edges()[e].upper);
  }
  std::vector<LocalSheets> at_vertices(const std::vector<LocalSheets>& cells) const {
    std::vector<LocalSheets> out(c_.num_vertices());
    for (std::uint32_t cell = 0; cell < c_.num_cells(); ++cell)
      if (is_defect_[b_.body_of_cell[cell]])
        for_each_vertex(cell, [&](std::uint32_t v) { out[v].add(cells[cell]); });
    return out;
  }
  std::vector<bool> choose(const std::vector<LocalSheets>& around) const {
    std::vector<bool> out(cover_.num_cells()), has_one(b_.bodies.size());
    for_each_cell(cover_, c_, [&](std::size_t i, std::uint32_t cell) {
      const std::uint32_t body = b_.body_of_cell[cell];
      if (!is_defect_[body]) return;
      for_each_vertex(cell, [&](std::uint32_t v) { out[i] = out[i] || around[v].is_suspicious(); });
      if (out[i]) has_one[body] = true;
    });
    for_each_cell(cover_, c_, [&](std::size_t i, std::uint32_t cell) {
      const std::uint32_t body = b_.body_of_cell[cell];
      if (is_defect_[body] && !has_one[body]) out[i] = true;
    });
    return out;
  }

  void keep_one_place(std::uint32_t body, std::vector<bool>& which) const {
    std::vector<std::size_t> chosen;
    for_each_cell(cover_, c_, [&](std::size_t i, std::uint32_t cell) {
      if (which[i] && b_.body_of_cell[cell] == body) chosen.push_back(i);
    });
    if (chosen.size() <= kManyCells) return;
    const Box3d near = around(thickest(chosen));
    for (const std::size_t i : chosen)
      which[i] = meets(cover_.root().box(cover_.key(i)), near);
  }
  // Among the finest cells: where one place was chosen before, its cells are.
  std::size_t thickest(const std::vector<std::size_t>& chosen) const {
    std::size_t best = chosen.front();
    double most = -1;
    for (const std::size_t i : chosen) {
      const unsigned level = cover_.key(i).level(), finest = cover_.key(best).level();
      if (level < finest) continue;
      const double here = thickness(i);
      if (level > finest || here > most) best = i, most = here;
    }
    return best;
  }
  // The least side of the box around the pieces in the cell: approximate, and far too much where sheets are oblique.
  double thickness(std::size_t cell) const {
    std::optional<Box3d> all;
    cover_.for_each_piece(cell, [&](PieceForest::Id id) {
      all = all ? hull(*all, forest_.node(id).hull) : forest_.node(id).hull;
    });
    const Box3d box = cover_.root().box(cover_.key(cell));
    double out = extent(box);
    for (std::size_t k = 0; all && k < 3; ++k)
      out = std::min(out, std::min(all->hi[k], box.hi[k]) - std::max(all->lo[k], box.lo[k]));
    return out;
  }
  Box3d around(std::size_t cell) const {
    Box3d out = cover_.root().box(cover_.key(cell));
    const double reach = kReachOfCavity * extent(out);
    for (std::size_t k = 0; k < 3; ++k) out.lo[k] -= reach, out.hi[k] += reach;
    return out;
  }

  PieceForest& forest_;
  FacingOfPieces& facing_;
  const PieceOctree& cover_;
  const CommonSubdivision& c_;
  const ComplexBoundary& b_;
  std::vector<bool> is_defect_, has_one_shell_;
  std::vector<std::uint32_t> flat_bodies_;
};

}  // namespace

void LocalSheets::add(const LocalSheets& other) {
  facing &= other.facing;
  least_shell = std::min(least_shell, other.least_shell);
  greatest_shell = std::max(greatest_shell, other.greatest_shell);
}

std::vector<std::vector<std::uint32_t>> shells_of_bodies(const PatchComplex& patches,
                                                         const PieceForest& forest,
                                                         const PieceOctree& cover,
                                                         const CommonSubdivision& complex,
                                                         const ComplexBoundary& boundary) {
  std::vector<std::vector<std::uint32_t>> out(boundary.bodies.size());
  for_each_cell(cover, complex, [&](std::size_t i, std::uint32_t cell) {
    std::vector<std::uint32_t>& shells = out[boundary.body_of_cell[cell]];
    cover.for_each_piece(i, [&](PieceForest::Id id) {
      const std::uint32_t shell = patches.shell(forest.node(id).patch);
      if (!shells.empty() && shells.back() == shell) return;
      const auto at = std::lower_bound(shells.begin(), shells.end(), shell);
      if (at == shells.end() || *at != shell) shells.insert(at, shell);
    });
  });
  return out;
}

std::vector<BodyDefect> find_body_defects(
    const PatchComplex& patches, const std::vector<std::vector<std::uint32_t>>& shells_of_body,
    const ComplexBoundary& boundary) {
  std::vector<std::vector<std::uint32_t>> sides(boundary.bodies.size());
  for (std::uint32_t k = 0; k < boundary.components.size(); ++k)
    sides[boundary.components[k].body].push_back(k);
  std::vector<BodyDefect> out;
  for (std::uint32_t body = 0; body < boundary.bodies.size(); ++body) {
    const std::vector<std::uint32_t>& shells = shells_of_body[body];
    const auto complain = [&](std::string message) {
      out.push_back({body, shells.size() == 1, std::move(message)});
    };
    if (shells.size() != 1) {
      complain("the cells around shell " +
               (shells.empty() ? std::string("none") : std::to_string(shells[0])) + " hold " +
               std::to_string(shells.size()) + " shells");
      continue;
    }
    const std::string name = "the cells around shell " + std::to_string(shells[0]);
    if (sides[body].size() != 2) {
      complain(name + " have " + std::to_string(sides[body].size()) +
               " boundary components, not 2");
      out.back().lacks_cavity =
          sides[body].size() == 1 && patches.shells()[shells[0]].euler() == 2;
      continue;
    }
    const std::int64_t euler = patches.shells()[shells[0]].euler();
    for (const std::uint32_t side : sides[body])
      if (boundary.components[side].euler() != euler) {
        complain(name + ", of genus " + std::to_string(1 - euler / 2) +
                 ", have a boundary component of genus " +
                 std::to_string(boundary.components[side].genus()));
        break;
      }
  }
  return out;
}

std::vector<bool> cells_to_split(PieceForest& forest, FacingOfPieces& facing,
                                 const PieceOctree& cover, const CommonSubdivision& complex,
                                 const ComplexBoundary& boundary,
                                 const std::vector<BodyDefect>& bodies) {
  return Splitter(forest, facing, cover, complex, boundary, bodies).run();
}

}  // namespace veritope
