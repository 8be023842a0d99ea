// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/mesh_model_internal.h"

#include <cmath>
#include <utility>

#include "robust/base/disjoint_sets.h"
#include "solids/micro/filter/exact_contact_internal.h"
#include "solids/micro/filter/separation_internal.h"

namespace veritope::internal {

namespace {

class Facets final : public Obstacles {
 public:
  Facets(const MeshModel& model, const CellMap& cell, const TileShape& tile,
         const TileFilterLimits& limits)
      : model_(model), limits_(limits), exact_(cell, tile) {}

  std::vector<std::uint32_t> near(const TilePiece& piece) override {
    std::vector<std::uint32_t> out = model_.facets_near(box_of(piece));
    keep_close(piece, &out);
    return out;
  }
  void keep_close(const TilePiece& piece, std::vector<std::uint32_t>* facets) override {
    const GrownHull hull(piece);
    std::erase_if(*facets, [&](std::uint32_t f) { return hull.is_apart(model_.corners(f)); });
  }
  PieceSide examine(const TilePiece& piece, std::span<const std::uint32_t> facets,
                    std::optional<ExactPoint>* contact) override;

 private:
  bool looks_like_contact(const TilePiece& piece, std::span<const std::uint32_t> facets) const;

  const MeshModel& model_;
  const TileFilterLimits& limits_;
  ExactPatches exact_;
  int num_exact_ = 0;
};

// Whether no facet enters the hull of the piece's corners, and one nearly touches it, so that rationals may show more.
// Approximate.
bool Facets::looks_like_contact(const TilePiece& piece,
                                std::span<const std::uint32_t> facets) const {
  const Box3d box = box_of(piece);
  double size = 0, scale = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    size += box.hi[c] - box.lo[c];
    scale += std::abs(box.hi[c]) + std::abs(box.lo[c]);
  }
  const GrownHull hull(piece);
  const double tolerance = 0x1p-20 * size + 0x1p-46 * scale;
  bool is_near = false;
  for (const std::uint32_t f : facets) {
    const FacetCorners facet = model_.corners(f);
    if (!hull.may_have_gap(facet, -tolerance)) return false;
    is_near = is_near || !hull.may_have_gap(facet, tolerance);
  }
  return is_near;
}

PieceSide Facets::examine(const TilePiece& piece, std::span<const std::uint32_t> facets,
                          std::optional<ExactPoint>* contact) {
  PieceSide side;
  if (num_exact_ >= limits_.max_exact_points || !looks_like_contact(piece, facets)) return side;
  const auto look = [&](const std::optional<ExactControl>& control) {
    if (!control) return;
    num_exact_ += static_cast<int>(control->points.size());
    side = exact_side(model_, piece, *control, facets, contact);
  };
  look(exact_.around(piece));
  const auto num_points = exact_.num_points(piece.patch);
  if (!side.is_decided && num_points + static_cast<std::size_t>(num_exact_) <=
                              static_cast<std::size_t>(limits_.max_exact_points))
    look(exact_.control(piece));
  return side;
}

}  // namespace

MeshModel::MeshModel(const TriangleMesh& mesh, MeshClassifier classifier)
    : mesh_(&mesh), classifier_(std::move(classifier)) {
  find_shells();
}

// Faces that share a vertex belong to one shell.
void MeshModel::find_shells() {
  const std::size_t n = mesh_->positions.size();
  DisjointSets<> sets(n);
  std::vector<char> is_used(n);
  for (const auto& t : mesh_->faces) {
    for (const std::uint32_t v : t) is_used[v] = 1;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<std::uint32_t> shell_of(n, ShellVertices::kUnused);
  std::uint32_t num_shells = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (is_used[v] == 0) continue;
    const std::uint32_t least = sets.find(v);
    if (least == v) shell_of[v] = num_shells++;
    shell_of[v] = shell_of[least];
  }
  set_shells({shell_of, num_shells, [&](std::uint32_t v) { return vertex(v); }});
}

std::unique_ptr<Obstacles> MeshModel::obstacles(const CellMap& cell, const TileShape& tile,
                                                const TileFilterLimits& limits) const {
  return std::make_unique<Facets>(*this, cell, tile, limits);
}

}  // namespace veritope::internal
