// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/condition_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solids/interval_boxes/box_bounds.h"
#include "solids/star_box/star_box.h"
#include "topology/collar.h"

namespace veritope {
namespace {

Error over(std::uint64_t max_cells) {
  return {Code::kOverLimit, {}, "over " + std::to_string(max_cells) + " cells"};
}

// The cells of one level that a piece's closed hull may meet and whose closed box it does not miss within the budget: a
// cover of V.
class CellCover {
 public:
  CellCover(PieceForest& forest, double size) : forest_(forest) {
    const Box3d all = hull_of_roots(forest);
    // The root holds V with two cells to spare, and its cells' planes are no round numbers: models like those.
    const double whole = extent(all);
    while (level_ < OctreeKey::kMaxLevel &&
           std::ldexp(size, static_cast<int>(level_)) < whole + 5 * size)
      ++level_;
    cell_ = size;
    for (std::size_t k = 0; k < 3; ++k) low_[k] = all.lo[k] - (2 + 0x1.5p-2) * size;
    fits_ = std::ldexp(size, static_cast<int>(level_)) >= whole + 5 * size;
  }

  Result<OctreeKeySet> run(std::uint64_t max_cells) {
    if (!fits_) return Error{Code::kOverLimit, {}, "the octree has too few levels for this size"};
    std::vector<OctreeCell> cells;
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r)
      if (const Status done = visit(forest_.root(r), max_cells, &cells); !done) return done.error();
    const auto key = [](const OctreeCell& c) { return std::array{c.i, c.j, c.k}; };
    std::sort(cells.begin(), cells.end(), [&](auto& a, auto& b) { return key(a) < key(b); });
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return OctreeKeySet::make(cells);
  }

 private:
  // Hulls a quarter of a cell wide: all cells that they meet.
  Status visit(PieceForest::Id id, std::uint64_t max_cells, std::vector<OctreeCell>* cells) {
    const PieceForest::Node node = forest_.node(id);
    if (extent(node.hull) > 0.25 * cell_) {
      if (!forest_.may_split(id))
        return forest_.is_out_of_memory()
                   ? memory_error(*forest_.budget())
                   : Error{Code::kOverLimit, {}, "pieces below level " + std::to_string(node.level)};
      const PieceForest::Id first = forest_.children(id);
      for (PieceForest::Id k = 0; k < 4; ++k)
        if (const Status done = visit(first + k, max_cells, cells); !done) return done;
      return ok_status();
    }
    std::array<std::uint32_t, 3> from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = internal::first_cell(node.hull.lo[k], low_[k], cell_);
      to[k] = internal::last_cell(node.hull.hi[k], low_[k], cell_);
    }
    for (std::uint32_t x = from[0]; x <= to[0]; ++x)
      for (std::uint32_t y = from[1]; y <= to[1]; ++y)
        for (std::uint32_t z = from[2]; z <= to[2]; ++z) {
          const OctreeCell cell{level_, x, y, z};
          if (!cells->empty() && cells->back() == cell) continue;
          cells->push_back(cell);
        }
    if (cells->size() > 64 * max_cells) return over(max_cells);
    return ok_status();
  }

  PieceForest& forest_;
  double cell_ = 0;
  Point3d low_{};
  unsigned level_ = 0;
  bool fits_ = false;
};

Status decide_collar(BoundaryModel& model, double eps, std::uint64_t max_cells, SweepRow* row) {
  const double size = std::ldexp(eps, model.forest().scale());
  if (!std::isfinite(8 * size))  // a few cells beside the model
    return Error{Code::kBadArgument, {}, "eps is too large for the model"};
  auto keys = CellCover(model.forest(), size).run(max_cells);
  if (!keys) return keys.error();
  if (keys->size() > max_cells) return over(max_cells);
  row->cells = keys->size();
  const auto complex = CommonSubdivision::build(std::move(*keys));
  if (!complex) return complex.error();
  const auto collar = find_collar(*complex);
  if (!collar) return collar.error();
  row->collar[0] = collar->boundary.is_manifold() ? Answer::kTrue : Answer::kFalse;
  if (collar->outcome == CollarOutcome::kNotManifold) return ok_status();
  row->collar[1] = collar->outcome == CollarOutcome::kNotProduct ? Answer::kFalse : Answer::kTrue;
  if (collar->outcome == CollarOutcome::kCollar) row->collar[2] = Answer::kTrue;
  return ok_status();
}

Status decide_boxes(BoundaryModel& model, const SweepOptions& options, SweepRow* row) {
  const auto cover = make_surface_cover(model, row->eps, options.boxes);
  if (!cover) return cover.error();
  for (const SurfaceBox& b : cover->boxes)
    ++(b.kind == SurfaceBox::Kind::kFace   ? row->face_boxes
       : b.kind == SurfaceBox::Kind::kEdge ? row->edge_boxes
                                           : row->vertex_boxes);
  auto conditions = decide_conditions(model, cover->plain_boxes(), options.conditions);
  if (!conditions) return conditions.error();
  row->conditions = std::move(conditions->results);
  return ok_status();
}

// Boxes and cells have limits of their own.
void fill(BoundaryModel& model, const SweepOptions& options, SweepRow* row) {
  const auto note = [&](const char* what, const Status& status) {
    if (!status)
      row->why_not += (row->why_not.empty() ? "" : "; ") + (what + (": " + status.error().message));
  };
  if (MemoryBudget* const budget = model.forest().budget()) budget->forgive();
  note("boxes", decide_boxes(model, options, row));
  if (!model.is_planar()) note("cells", decide_collar(model, row->eps, options.max_cells, row));
}

const char* mark(Answer a) { return a == Answer::kTrue ? "yes" : a == Answer::kFalse ? "no" : "?"; }

}  // namespace

Result<std::vector<SweepRow>> sweep_conditions(BoundaryModel& model, double eps, int halvings,
                                               const SweepOptions& options) {
  if (!std::isfinite(eps) || !(eps > 0))
    return Error{Code::kBadArgument, {}, "eps = " + std::to_string(eps) + " is not positive"};
  if (halvings < 0 || halvings > kMaxSweep)
    return Error{Code::kBadArgument,
                 {},
                 std::to_string(halvings) + " halvings: 0 to " + std::to_string(kMaxSweep) +
                     " are possible"};
  std::vector<SweepRow> rows;
  for (int k = 0; k <= halvings; ++k) {
    SweepRow row;
    row.eps = std::ldexp(eps, -k);
    fill(model, options, &row);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string to_table(const std::vector<SweepRow>& rows) {
  std::string out = "        eps   face   edge vertex";  // rows have 79 columns
  char text[160];
  for (std::size_t c = 0; c < kNumPaperConditions; ++c) {
    std::snprintf(text, sizeof text, " %3s", name_of(static_cast<PaperCondition>(c)));
    out += text;
  }
  out += "  cells  K1  K2  K3\n";
  for (const SweepRow& r : rows) {
    std::snprintf(text, sizeof text, "%11.6g %6llu %6llu %6llu", r.eps,
                  static_cast<unsigned long long>(r.face_boxes),
                  static_cast<unsigned long long>(r.edge_boxes),
                  static_cast<unsigned long long>(r.vertex_boxes));
    out += text;
    for (const ConditionResult& c : r.conditions) {
      std::snprintf(text, sizeof text, " %3s", mark(c.answer));
      out += text;
    }
    std::snprintf(text, sizeof text, " %6llu", static_cast<unsigned long long>(r.cells));
    out += text;
    for (const Answer a : r.collar) {
      std::snprintf(text, sizeof text, " %3s", mark(a));
      out += text;
    }
    out += (r.why_not.empty() ? "" : "  " + r.why_not) + "\n";
  }
  return out;
}

}  // namespace veritope
