// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/patch_model_internal.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

#include "interval/upward.h"
#include "solids/classify/patch_cuts.h"

namespace veritope::internal {

namespace {

// Patches are cut in advance until there are about so many parts.
constexpr std::size_t kManyParts = 4096;
// A piece that is smaller than this part of the tile's largest one and of the model, and still not apart, touches the
// surface, or as good as that.
constexpr double kHopelessPart = 0x1p-30;
// Levels of the classifier's octree: one more costs twice the time to build, and gains no time on grids of 20^3 cells.
constexpr int kLevels = 7;

// The parts of the model near one tile, halved further where pieces of the tile are smaller than they are.
class PatchParts final : public Obstacles {
 public:
  explicit PatchParts(const PatchModel& model) : model_(model) {}

  std::vector<std::uint32_t> near(const TilePiece& piece) override {
    largest_ = std::max(largest_, extent(box_of(piece)));
    std::vector<std::uint32_t> out;
    model_.visit_parts(box_of(piece), [&](std::uint32_t p) { out.push_back(p); });
    keep_close(piece, &out);
    return out;
  }
  void keep_close(const TilePiece& piece, std::vector<std::uint32_t>* numbers) override;
  PieceSide examine(const TilePiece& piece, std::span<const std::uint32_t>,
                    std::optional<ExactPoint>*) override {
    PieceSide out;
    out.is_hopeless = extent(box_of(piece)) < kHopelessPart * std::min(model_.size(), largest_);
    return out;
  }

 private:
  static constexpr std::uint32_t kNoHalves = 0xffffffffu;

  const PatchObstacle& part(std::uint32_t number) const {
    const auto& shared = model_.parts();
    return number < shared.size() ? shared[number] : own_[number - shared.size()];
  }
  std::uint32_t halves_of(std::uint32_t number);

  const PatchModel& model_;
  double largest_ = 0;             // of the pieces that were asked for first
  std::deque<PatchObstacle> own_;  // numbered after the model's parts; halves follow each other
  std::vector<std::pair<std::uint32_t, std::uint32_t>> halves_of_shared_;  // number, first half
  std::vector<std::uint32_t> halves_of_own_;
};

// The number of the first half; the other one is next to it.
std::uint32_t PatchParts::halves_of(std::uint32_t number) {
  const std::size_t num_shared = model_.parts().size();
  std::uint32_t* known = nullptr;
  if (number < num_shared) {
    const auto at = std::find_if(halves_of_shared_.begin(), halves_of_shared_.end(),
                                 [&](const auto& entry) { return entry.first == number; });
    if (at != halves_of_shared_.end()) return at->second;
    known = &halves_of_shared_.emplace_back(number, kNoHalves).second;
  } else {
    known = &halves_of_own_[number - num_shared];
    if (*known != kNoHalves) return *known;
  }
  const auto first = static_cast<std::uint32_t>(num_shared + own_.size());
  *known = first;
  const PatchPiece& piece = part(number).piece;
  auto [low, high] = piece.halves(piece.longer_axis());
  own_.emplace_back(std::move(low));
  own_.emplace_back(std::move(high));
  halves_of_own_.resize(own_.size(), kNoHalves);
  return first;
}

void PatchParts::keep_close(const TilePiece& piece, std::vector<std::uint32_t>* numbers) {
  const CornerHull hull(piece.corners, excess_of(piece), box_of(piece));
  const double size = extent(hull.box());
  std::vector<std::uint32_t> stack(numbers->rbegin(), numbers->rend());
  numbers->clear();
  while (!stack.empty()) {
    const std::uint32_t number = stack.back();
    stack.pop_back();
    const PatchObstacle& obstacle = part(number);
    if (hull.is_apart(obstacle.hull)) continue;
    if (extent(obstacle.piece.box()) <= size || !obstacle.piece.can_halve()) {
      numbers->push_back(number);
      continue;
    }
    const std::uint32_t first = halves_of(number);
    stack.push_back(first + 1);
    stack.push_back(first);
  }
}

}  // namespace

PatchModel::PatchModel(const PatchComplex& complex)
    : classifier_(PatchClassifier::of_valid_model(complex, kLevels)) {
  const ScopedUpward upward;
  cut(complex);
  find_shells(complex);
}

void PatchModel::cut(const PatchComplex& complex) {
  std::vector<PatchPiece> pieces = pieces_of(complex, kManyParts);
  std::vector<Box3d> boxes;
  Box3d all = empty_box();
  parts_.reserve(pieces.size());
  for (PatchPiece& piece : pieces) {
    boxes.push_back(piece.box());
    all = hull(all, piece.box());
    parts_.emplace_back(std::move(piece));
  }
  size_ = extent(all);
  tree_ = BoxHierarchy(boxes);
}

void PatchModel::find_shells(const PatchComplex& complex) {
  std::vector<std::uint32_t> shell_of(complex.num_vertices(), ShellVertices::kUnused);
  vertices_.resize(complex.num_vertices());
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (std::uint32_t c = 0; c < complex.patch(p).num_sides(); ++c) {
      const std::uint32_t v = complex.vertex({p, c});
      if (shell_of[v] != ShellVertices::kUnused) continue;
      shell_of[v] = complex.shell(p);
      const auto point = point_of(complex.patch(p).corner(c));
      VT_CHECK(point.has_value(), "a patch of a valid model has a weight of 0");
      vertices_[v] = Box3(enclose((*point)[0]), enclose((*point)[1]), enclose((*point)[2]));
    }
  set_shells({shell_of, static_cast<std::uint32_t>(complex.shells().size()),
              [&](std::uint32_t v) { return vertex(v); }});
}

std::unique_ptr<Obstacles> PatchModel::obstacles(const CellMap&, const TileShape&,
                                                 const TileFilterLimits&) const {
  return std::make_unique<PatchParts>(*this);
}

}  // namespace veritope::internal
