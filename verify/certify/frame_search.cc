// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/frame_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/base/disjoint_sets.h"
#include "solids/pieces/piece_descent.h"
#include "verify/certify/box_separation.h"
#include "verify/certify/grid_box.h"
#include "verify/certify/half_spaces.h"
#include "verify/certify/piece_neighbours.h"
#include "verify/certify/piece_samples.h"
#include "verify/certify/separator_search.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

constexpr double kRowLength = FrameProposals::kRowLength;
constexpr std::size_t kMostNear = 192, kMostSheets = 8;
// The most pieces that a proof may test, and a sixteenth of those that it may visit. A box that takes more than a few
// in each sheet is only used if no other is found: a certificate with such boxes takes long to check. Beside a rim that
// is not at right angles to its walls, a thin box in the frame of the rim takes thousands of small pieces of the walls,
// and an oblique one few.
constexpr std::size_t kFewPieces = 32, kMostPiecesOfProof = 1024;
// The conditions of each piece in the first programs for centres.
constexpr std::size_t kFirstConditions = 8;
// The least depth of centres, in half sizes of the box.
constexpr double kLeastDepth = 1e-3;
// Centres stay this far inside, in half sizes of the box.
constexpr double kRoom = 0.9375;
// A piece is flat if it leaves the plane of its normal by no more than this part of the box's least half size.
constexpr double kFlatPart = 0x1p-8;
// Heights of boxes that hold a curved piece, in heights of its hull: its tangent planes meet above and below it.
constexpr double kHeights = 4;
// The growth of tight boxes along the surface, and the size of the pieces that reach out of them, in half sizes.
constexpr double kTightGrowth = 1.125, kTightPart = 0.125;
// What a box that was cut on one side reaches on the other, as a multiple.
constexpr double kOtherSide = 2;
// Cut::kOppositeParts splits pieces that are higher than this many heights of the hull and this part of their distance.
constexpr double kMostHeights = 2, kMostOfDistance = 0.25;
constexpr std::size_t kMostSplits = 1024;

using internal::dot;
using internal::length_of;
// A model whose metric is distorted by no more than this is treated as one as long as wide.
constexpr double kMostDistortion = 1.2;
double length_along(const Box3d& b) { return std::min(b.hi[0] - b.lo[0], b.hi[1] - b.lo[1]); }
double height(const Box3d& b) { return b.hi[2] - b.lo[2]; }
double power_of_two_below(double v) { return std::exp2(std::floor(std::log2(v))); }
Point3d product(const Point3d& a, const Point3d& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
double least_in_frame(const SearchFrame& frame, const Point3d& half) {
  const Point3d in_frame = product(half, frame.unit);
  return std::min({in_frame[0], in_frame[1], in_frame[2]});
}

}  // namespace

Box3d FrameSearch::Region::box() const {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k)
    out.lo[k] = middle[k] - half[k], out.hi[k] = middle[k] + half[k];
  return out;
}

bool FrameSearch::try_piece(Id id, bool with_one_sheet_only) {
  if (proposals_.empty()) make_proposals();
  piece_ = id;
  for (most_pieces_ = kFewPieces;; most_pieces_ = kMostPiecesOfProof) {
    had_more_pieces_ = false;
    for (std::size_t i = 0; i < proposals_.size(); ++i) {
      const std::size_t number = (first_proposals_ + i) % proposals_.size();
      if (!try_piece(id, with_one_sheet_only, proposals_[number])) continue;
      first_proposals_ = number;
      return true;
    }
    if (!had_more_pieces_ || most_pieces_ == kMostPiecesOfProof) return false;
  }
}

void FrameSearch::make_proposals() {
  proposals_.emplace_back(forest_, ShapeMetric());
  const ShapeMetric metric(forest_);
  if (metric.distortion() > kMostDistortion) proposals_.emplace_back(forest_, metric);
}

bool FrameSearch::try_piece(Id id, bool with_one_sheet_only, FrameProposals& proposals) {
  metric_ = &proposals.metric();
  const auto plain = proposals.along(id);
  if (!plain) return false;
  use(*plain);
  if (try_in_frame(with_one_sheet_only)) return true;
  const auto other = proposals.normal_across_crease(id, around_);
  if (!other) return false;
  if (try_tight()) return true;
  const auto oblique = proposals.along_crease(id, *other, *plain);
  if (!oblique) return false;
  use(*oblique);
  return try_in_frame(with_one_sheet_only) || try_tight();
}

void FrameSearch::use(const PieceFrame& chosen) {
  box_.sheets.frame = chosen.frame;
  frame_ = chosen;
  hulls_.use(chosen.frame);
  hull_ = chosen.hull;
}

Point3d FrameSearch::normal_of(Id id) {
  return metric_->image_of_normal(forest_.approx_normal(id));
}

Box3d FrameSearch::hull_of(Id id) { return frame_.in_lengths(hulls_.of(id)); }

bool FrameSearch::try_in_frame(bool with_one_sheet_only) {
  const double along = length_along(hull_);
  const double bent = growth_ * kHeights * height(hull_);
  const Region wide = region_of_height(std::max(along, bent), growth_);
  const bool is_gathered = gather(wide);
  around_ = near_;
  if (is_gathered && try_one_sheet(wide, with_one_sheet_only ? Cut::kOppositeParts : Cut::kAll))
    return true;
  if (with_one_sheet_only) return false;
  return try_several(std::max(along, bent)) || (bent < along && try_several(bent));
}

// In the region, into which gather has looked, if it has one; or before other sheets.
bool FrameSearch::try_one_sheet(const Region& region, Cut which) {
  const std::vector<std::vector<Id>> all = components();
  if (all.size() == 1 && try_sheets(region, region, all)) return true;
  const auto cut = cut_back(region, which);
  if (!cut) return false;
  // A walk that starts at the far centre of a high box clears hulls that are higher than the gap on the near side.
  if (which == Cut::kOppositeParts && gather(cut->high) && try_sheets(cut->high, cut->low, {near_}))
    return true;
  return gather(cut->low) && try_sheets(cut->low, cut->low, {near_});
}

// All sheets in a box of this height that is hardly longer than the piece: in a longer one centres must see farther
// round the bend, so that the piece must be shorter. One sheet alone is different: it bends less in a lower box.
bool FrameSearch::try_several(double height) {
  const Region region = region_of_height(height, kTightGrowth);
  return gather(region) && try_sheets(region, region, components());
}

// One sheet in a box hardly longer than the piece: beside a curved rim a longer box is a thicker one, and its centres
// must see farther round the bend.
bool FrameSearch::try_tight() {
  Region region = region_of_height(length_along(hull_), kTightGrowth);
  region.part = kTightPart;
  if (!gather(region)) return false;
  if (const auto cut = cut_back(region, Cut::kOpposite)) {
    region = cut->low;
    if (!gather(region)) return false;
  }
  return try_sheets(region, region, {near_});
}

// The hull of the piece, grown along the surface, with this height.
FrameSearch::Region FrameSearch::region_of_height(double height, double growth) const {
  Region out;
  out.middle = approx_centre(hull_);
  for (std::size_t k = 0; k < 2; ++k) out.half[k] = 0.5 * growth * (hull_.hi[k] - hull_.lo[k]);
  out.half[2] = 0.5 * height;
  // A side of the hull may have no length.
  const double least = 0x1p-20 * std::max({out.half[0], out.half[1], out.half[2]});
  for (double& h : out.half) h = std::max(h, least);
  return out;
}

// Whether the piece, with this hull in the frame, need not be split for a search in the region: it is at most half as
// long on every axis (a part of that where it reaches out of the region); or it is flat, and not long on all axes.
bool FrameSearch::is_small(Id id, const Box3d& hull, const Region& region) {
  const Box3d box = region.box();
  int num_long = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_within = box.lo[k] <= hull.lo[k] && hull.hi[k] <= box.hi[k];
    const double most = is_within ? region.half[k] : region.part * region.half[k];
    num_long += hull.hi[k] - hull.lo[k] <= most ? 0 : 1;
  }
  if (num_long == 0) return true;
  // The hull of all of a flat piece may hide a gap that those of its parts do not.
  if (region.ends_at_opposite && dot(normal_of(id), normal_of(piece_)) < 0) return false;
  const double least = std::min({region.half[0], region.half[1], region.half[2]});
  return num_long < 3 && approx_bend(forest_, id, *metric_) <= kFlatPart * least;
}

// Puts the small pieces that the region meets into near_.
bool FrameSearch::gather(const Region& region) {
  near_.clear();
  const Box3d box = frame_.in_frame(region.box());
  return descend_to(forest_, frame_.frame.around(box), 16 * kMostNear, [&](Id id) {
    const auto hull = hulls_.that_meets(id, box);
    if (!hull) return PieceStep::kTaken;
    if (!is_small(id, frame_.in_lengths(*hull), region)) return PieceStep::kSplit;
    near_.push_back(id);
    return near_.size() <= kMostNear ? PieceStep::kTaken : PieceStep::kStop;
  });
}

// The region with sides halfway to each piece that does not touch the hull, on the axis on which it is farthest from
// it; nothing if there is no such piece. Cut::kOpposite: of those that face the other way; Cut::kOppositeParts: of
// parts of those, so small that their hulls do not hide a gap.
std::optional<FrameSearch::CutRegion> FrameSearch::cut_back(const Region& region, Cut which) {
  Box3d box = region.box();
  const Point3d normal = normal_of(piece_);
  bool is_cut = false;
  std::vector<Id> open = near_;
  for (std::size_t splits = 0; !open.empty();) {
    const Id id = open.back();
    open.pop_back();
    if (which != Cut::kAll && !(dot(normal_of(id), normal) < 0)) continue;
    const Box3d other = hull_of(id);
    if (!meets(box, other)) continue;
    const auto [axis, distance, is_above] = separation(hull_, other);
    const double enough = std::max(kMostHeights * height(hull_), kMostOfDistance * distance);
    if (which == Cut::kOppositeParts && height(other) > enough && splits < kMostSplits &&
        forest_.may_split(id)) {
      const Id first = forest_.children(id);
      for (Id k = 0; k < 4; ++k) open.push_back(first + k);
      ++splits;
      continue;
    }
    if (!(distance * frame_.unit[axis] > 16 * least_unit_)) continue;
    is_cut = true;
    if (is_above)
      box.hi[axis] = std::min(box.hi[axis], hull_.hi[axis] + 0.5 * distance);
    else
      box.lo[axis] = std::max(box.lo[axis], hull_.lo[axis] - 0.5 * distance);
  }
  if (!is_cut) return std::nullopt;
  const auto region_of = [&] {
    Region out = region;
    out.ends_at_opposite = which == Cut::kOppositeParts;
    out.middle = approx_centre(box);
    for (std::size_t k = 0; k < 3; ++k) out.half[k] = 0.5 * (box.hi[k] - box.lo[k]);
    return out;
  };
  const Region high = region_of();
  // Centres lie on both sides of the piece: a box that ends near it on one side need not reach far on the other.
  const double below = hull_.lo[2] - box.lo[2], above = box.hi[2] - hull_.hi[2];
  box.lo[2] = std::max(box.lo[2], hull_.lo[2] - kOtherSide * above);
  box.hi[2] = std::min(box.hi[2], hull_.hi[2] + kOtherSide * below);
  return CutRegion{high, region_of()};
}

// The classes of near_ by common points in the surface.
std::vector<std::vector<Id>> FrameSearch::components() const {
  DisjointSets<> classes(near_.size());
  for (std::uint32_t i = 0; i < near_.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (classes.find(i) != classes.find(j) &&
          meets(forest_.node(near_[i]).hull, forest_.node(near_[j]).hull) &&
          are_neighbours(forest_, near_[i], near_[j]))
        classes.join(i, j);
  std::vector<std::vector<Id>> out;
  std::vector<std::size_t> number(near_.size(), near_.size());
  for (std::uint32_t i = 0; i < near_.size(); ++i) {
    std::size_t& n = number[classes.find(i)];
    if (n == near_.size()) n = out.size(), out.emplace_back();
    out[n].push_back(near_[i]);
  }
  return out;
}

// Centres on the side of the sheet on which the region reaches no farther than `near` lie in `near`.
bool FrameSearch::try_sheets(const Region& region, const Region& near,
                             const std::vector<std::vector<Id>>& sheets) {
  if (sheets.empty() || sheets.size() > kMostSheets) return false;
  const double least = least_in_frame(frame_, near.half);
  box_.unit = power_of_two_below(least / kUnitsInBox);
  if (box_.unit < least_unit_) return false;
  const Box3d box = frame_.in_frame(region.box());
  for (std::size_t k = 0; k < 3; ++k) {
    box_.sheets.box.lo[k] = std::floor(box.lo[k] / box_.unit) * box_.unit;
    box_.sheets.box.hi[k] = std::ceil(box.hi[k] / box_.unit) * box_.unit;
  }
  const Box3d all = region.box(), part = near.box();
  const bool is_far_above = all.hi[2] - part.hi[2] > part.lo[2] - all.lo[2];
  const bool is_outside_above = dot(normal_of(piece_), frame_.rows[2]) > 0;
  const bool is_outside_far = is_far_above == is_outside_above;
  box_.centre_unit = std::numeric_limits<double>::infinity();
  box_.sheets.sheets.assign(sheets.size(), {});
  box_.sheets.separators.clear();
  for (std::size_t i = 0; i < sheets.size(); ++i)
    if (!place_centres(is_outside_far ? near : region, is_outside_far ? region : near, sheets[i],
                       &box_.sheets.sheets[i]))
      return false;
  if (sheets.size() > 1 && !separate(sheets, region)) return false;
  const std::size_t most = std::min(most_pieces_ * sheets.size(), kMostPiecesOfProof);
  if (!is_sheet_box(forest_, box_.sheets, most, &pieces_)) {
    had_more_pieces_ |= pieces_.num_visited > most;
    return false;
  }
  hold_near();
  return true;
}

// The proof may have taken larger pieces than the search: parts of them lie in the box, too.
void FrameSearch::hold_near() {
  near_.push_back(piece_);
  for (const Id id : near_)
    if (is_inside(hulls_.of(id), box_.sheets.box)) pieces_.held.push_back(id);
}

// The first conditions of each piece for a centre that sees it from inside: for z, where A c = middle + half z, both in
// the frame.
void FrameSearch::set_half_spaces(const Region& region, const std::vector<Id>& pieces,
                                  std::size_t most) {
  const BoxFrame& frame = box_.sheets.frame;
  CentreSteps in{frame.approx_back(product(region.middle, frame_.unit)), {}};
  for (std::size_t j = 0; j < 3; ++j) {
    Point3d y{};
    y[j] = region.half[j] * frame_.unit[j];
    in.steps[j] = frame.approx_back(y);
  }
  half_spaces_.clear();
  for (const Id id : pieces) append_half_spaces_in_steps(forest_, id, in, most, &half_spaces_);
}

// The deepest points that see all of the pieces, from inside in the one region and from outside in the other. Mostly a
// few conditions of each piece show that no such points exist.
bool FrameSearch::place_centres(const Region& inside, const Region& outside,
                                const std::vector<Id>& pieces, Sheet* sheet) {
  const Box3d room{{-kRoom, -kRoom, -kRoom}, {kRoom, kRoom, kRoom}};
  for (const std::size_t most : {kFirstConditions, ~std::size_t{0}})
    for (const bool is_inside : {true, false}) {
      const Region& region = is_inside ? inside : outside;
      // Where both regions are one, the conditions from outside are those from inside, turned.
      if (is_inside || &inside != &outside) set_half_spaces(region, pieces, most);
      if (!is_inside)
        for (HalfSpace& h : half_spaces_) h = {{-h.a[0], -h.a[1], -h.a[2]}, -h.b};
      if (most == kFirstConditions) {
        if (is_surely_shallow(half_spaces_, room, kLeastDepth)) return false;
        continue;
      }
      const auto deepest = deepest_point(half_spaces_, room, kLeastDepth);
      if (!deepest) return false;
      (is_inside ? sheet->inside : sheet->outside) =
          rounded(region, deepest->point, deepest->depth);
    }
  return true;
}

// A centre near middle + half z, on a grid that is short against its depth.
Point3d FrameSearch::rounded(const Region& region, const Point3d& z, double depth) {
  const double least = least_in_frame(frame_, region.half) / kRowLength;
  const double unit =
      std::max(least_centre_unit_, power_of_two_below(std::min(depth, 1 - kRoom) * least / 4));
  Point3d y;
  for (std::size_t k = 0; k < 3; ++k) y[k] = region.middle[k] + region.half[k] * z[k];
  Point3d c = frame_.frame.approx_back(product(y, frame_.unit));
  for (double& v : c) v = std::nearbyint(v / unit) * unit;
  box_.centre_unit = std::min(box_.centre_unit, unit);
  return c;
}

// Separators until any two sheets are on different sides of one.
bool FrameSearch::separate(const std::vector<std::vector<Id>>& sheets, const Region& region) {
  const Point3d half = product(region.half, frame_.unit);
  const double size = std::max({half[0], half[1], half[2]}) / kRowLength;
  std::vector<std::vector<Point3d>> samples(sheets.size());
  for (std::size_t i = 0; i < sheets.size(); ++i)
    for (const Id id : sheets[i]) append_samples(forest_, id, &samples[i]);
  auto& made = box_.sheets.sheets;
  for (std::size_t i = 0; i < sheets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (are_apart(made[i], made[j])) continue;
      const auto q =
          find_separator(samples[i], samples[j], made[0].inside, power_of_two_below(size) * 2);
      if (!q) return false;
      for (std::size_t s = 0; s < made.size(); ++s)
        made[s].signs.push_back(common_sign(*q, samples[s]));
      if (made[i].signs.back() * made[j].signs.back() != Sign::kNegative) return false;
      box_.sheets.separators.push_back(*q);
    }
  return true;
}

}  // namespace veritope
