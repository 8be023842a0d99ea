// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/box_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solids/star_box/mesh_box.h"
#include "solids/star_box/place_centres.h"
#include "verify/certify/box_separation.h"
#include "verify/certify/grid_box.h"
#include "verify/certify/half_spaces.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;
using Why = UncoveredPiece::Why;

// Grid units that fit the narrowest strip between a piece and a cut-back side of a box.
constexpr double kUnitsInStrip = 8;
constexpr std::size_t kMostPieces = 4096;
// The number of failures at poles that a model may have; each costs up to 16 kMostPieces signs.
constexpr std::size_t kMostCrowdedFailures = 16;
// Conditions of each piece in the first linear program for centres.
constexpr std::size_t kFewConditions = 12;
// Where centres on the mean normal are tried, from the middle of the box to its border.
constexpr double kPartToBorder = 0.75;
// The most triangles in a mesh box. Mesh boxes are tried only at vertices, and every pair of their
// triangles is tested.
constexpr std::size_t kMostTriangles = 48;

// The common area of the boxes' shadows along the axis.
double common_area(const Box3d& a, const Box3d& b, std::size_t axis) {
  double out = 1;
  for (const std::size_t k : {(axis + 1) % 3, (axis + 2) % 3})
    out *= std::max(0.0, std::min(a.hi[k], b.hi[k]) - std::max(a.lo[k], b.lo[k]));
  return out;
}

double square(double a) { return a * a; }

// The children of a tensor piece at the corners where its sides 0, 1, 2, 3 start.
constexpr std::array<Id, 4> kTensorChildAtCorner{0, 2, 3, 1};

// Whether this corner of the piece is that corner of the patch.
bool is_at_corner(const PieceForest& forest, const PieceForest::Node& node, std::uint32_t corner) {
  const std::uint32_t n = forest.form(node.patch).shape.is_triangle ? 3 : 4;
  return !node.is_upside_down && forest.is_on_side(node, corner, corner) &&
         forest.is_on_side(node, corner, (corner + n - 1) % n);
}
std::optional<std::uint32_t> corner_of_patch(const PieceForest& forest,
                                             const PieceForest::Node& node) {
  const std::uint32_t n = forest.form(node.patch).shape.is_triangle ? 3 : 4;
  for (std::uint32_t corner = 0; corner < n; ++corner)
    if (is_at_corner(forest, node, corner)) return corner;
  return std::nullopt;
}

}  // namespace

bool BoxSearch::try_piece(Id id) {
  piece_ = id;
  tested_.assign(1, id);
  held_.clear();
  num_near_ = 1;
  may_have_zeros_ = is_marginal_ = false;
  obstacle_.reset();
  const Box3d hull = forest_.node(id).hull;
  // Coordinates are at most 1; a hull is longer where weights are not known to be positive.
  if (!(extent(hull) > 0) || !(extent(hull) < 8)) return fail(Why::kNoCentres);
  box_ = cube_around(approx_centre(hull), 0.5 * options_.growth * extent(hull));
  if (!is_inside(hull, box_.star.box)) return fail(Why::kTooDeep);
  scale_.fill(extent(box_.star.box));
  if (box_.unit < options_.least_cube_unit) {
    tested_.clear();
    find_pieces(forest_, box_.star.box, 0.5 * extent(box_.star.box), kMostPieces, &tested_, &held_);
    return fail(Why::kTooFine);
  }
  if (try_star()) return true;
  may_have_zeros_ = is_marginal_;
  const Why why_of_cube = why_;
  return try_cut_star() || try_mesh() || fail(why_of_cube);
}

// A mesh box is tried only at a corner of flat patches and only for parts of them: the rest of each patch then has star
// boxes, at which walks begin.
bool BoxSearch::try_mesh() {
  const PieceForest::Node& node = forest_.node(piece_);
  if (why_ == Why::kTooDeep || node.level == 0 || node.is_upside_down) return false;
  const PatchComplex& complex = forest_.complex();
  const auto found = corner_of_patch(forest_, node);
  if (!found || !flat_.contain(node.patch)) return false;
  const std::uint32_t corner = *found;
  const PieceForest::Form& form = forest_.form(node.patch);
  const std::size_t at = complex.patch(node.patch).side_index(corner, 0), n = form.shape.count();
  Point3d vertex;
  for (std::size_t k = 0; k < 3; ++k)
    vertex[k] = form.origin[k] + forest_.control(piece_)[k * n + at];
  const Box3d hull = node.hull;
  CoverBox mesh = cube_around(vertex, 1.125 * extent(hull));
  mesh.is_mesh = true;
  if (!is_inside(hull, mesh.star.box)) return false;
  const auto patches = mesh_box_patches(forest_, flat_, mesh.star.box, kMostTriangles);
  if (!patches) return false;
  mesh.needs_version_2 = !std::all_of(patches->begin(), patches->end(), [&](std::uint32_t p) {
    return complex.patch(p).is_flat_triangle();
  });
  box_ = mesh;
  held_.clear();
  const std::uint32_t common = complex.vertex({forest_.node(piece_).patch, corner});
  for (const std::uint32_t patch : *patches)
    for (std::uint32_t c = 0; c < complex.patch(patch).num_sides(); ++c)
      if (complex.vertex({patch, c}) == common) hold_corner(patch, c);
  return true;
}

// Adds to held_ the existing parts at this corner that lie in the box.
void BoxSearch::hold_corner(std::uint32_t patch, std::uint32_t corner) {
  const PieceForest::Form& form = forest_.form(patch);
  for (Id root = form.first_root; root < form.first_root + form.num_roots; ++root) {
    if (!is_at_corner(forest_, forest_.node(root), corner)) continue;
    const Id child = form.shape.is_triangle ? corner : kTensorChildAtCorner[corner];
    Id id = forest_.node(root).first_child;
    for (; id != PieceForest::kNone; id = forest_.node(id + child).first_child)
      if (is_inside(forest_.node(id + child).hull, box_.star.box)) held_.push_back(id + child);
  }
}

bool BoxSearch::try_star() {
  if (!is_promising()) return fail(Why::kNoCentres);
  const Box3d& box = box_.star.box;
  tested_.clear();
  if (!find_pieces(forest_, box, 0.5 * extent(box), kMostPieces, &tested_, &held_))
    return try_crowded_star();
  tested_pieces_ += tested_.size();
  num_near_ = tested_.size();
  held_.push_back(piece_);  // where doubles are coarse, it may be a part of a small piece
  return has_star();
}

bool BoxSearch::has_star() {
  const bool has_centres = (place_centres() && are_centres()) || search_centres();
  if (!has_centres) return fail(Why::kNoCentres);
  return crossing_number(forest_, tested_, box_.star) == 1 || fail(Why::kCrossings);
}

// Tries the cube, cut back before the pieces that do not touch the hull: along flat sheets such boxes are as thin as a
// gap, and as long as the sheet.
bool BoxSearch::try_cut_star() {
  if (why_ == Why::kTooDeep || num_near_ == 1) return false;
  obstacle();  // computed for the cube
  const auto box = cut_back();
  if (!box) return false;
  box_ = *box;
  // Star boxes stay star boxes where axes are stretched.
  for (std::size_t k = 0; k < 3; ++k) scale_[k] = box_.star.box.hi[k] - box_.star.box.lo[k];
  std::erase_if(tested_, [&](Id id) { return !meets(box_.star.box, forest_.node(id).hull); });
  std::erase_if(held_, [&](Id id) { return !is_inside(forest_.node(id).hull, box_.star.box); });
  return has_star();
}

// The box with sides halfway to each piece that was met, on the axis on which that piece is farthest from the hull;
// nothing if all of them (nearly) touch the hull.
std::optional<CoverBox> BoxSearch::cut_back() const {
  const Box3d hull = forest_.node(piece_).hull;
  Box3d box = box_.star.box;
  double narrowest = std::numeric_limits<double>::infinity(), gap_squares = 0;
  for (const Id id : tested_) {
    const Box3d other = forest_.node(id).hull;
    const Separation s = separation(hull, other);
    if (!(s.distance > 2 * kUnitsInStrip * options_.least_unit)) continue;
    gap_squares =
        std::max(gap_squares, common_area(hull, other, s.axis) /
                                  square(std::max(s.distance, gap_between(forest_, piece_, id))));
    if (!meets(box, other)) continue;
    if (s.is_above)
      box.hi[s.axis] = hull.hi[s.axis] + 0.5 * s.distance;
    else
      box.lo[s.axis] = hull.lo[s.axis] - 0.5 * s.distance;
    narrowest = std::min(narrowest, 0.5 * s.distance);
  }
  if (std::isinf(narrowest)) return std::nullopt;
  const double unit = std::exp2(std::floor(std::log2(narrowest / kUnitsInStrip)));
  CoverBox out = on_grid(box, std::min(box_.unit, unit));
  out.gap_squares = gap_squares;
  return out;
}

// Near a pole of many slivers: uses the centres of the piece alone, and splits no piece further than S1 needs.
bool BoxSearch::try_crowded_star() {
  tested_.assign(1, piece_);
  if (!is_promising()) return fail(Why::kTooDeep);
  tested_.clear(), held_.clear();
  if (crowded_failures_ >= kMostCrowdedFailures ||
      !find_star_pieces(forest_, box_.star, kMostPieces, &tested_, &held_)) {
    ++crowded_failures_;
    return fail(Why::kTooDeep);
  }
  tested_pieces_ += tested_.size();
  num_near_ = tested_.size();
  held_.push_back(piece_);  // it may be a part of a piece that was taken
  return crossing_number(forest_, tested_, box_.star) == 1 || fail(Why::kCrossings);
}

// Whether centres for the piece alone were found, approximately.
bool BoxSearch::is_promising() { return (place_centres() && are_centres()) || search_centres(); }

const Obstacle& BoxSearch::obstacle() {
  if (!obstacle_) obstacle_ = find_obstacle(forest_, piece_, tested_);
  return *obstacle_;
}

// Centres on the mean normal, rounded to the box's grid and kept inside the box: on a grid that is finer than doubles
// they may still fall on the border.
bool BoxSearch::place_centres() {
  StarBox& star = box_.star;
  Point3d direction = mean_normal(forest_, tested_, NormalWeight::kSize);
  for (std::size_t k = 0; k < 3; ++k) direction[k] *= scale_[k];
  if (!veritope::place_centres(direction, kPartToBorder, &star)) return false;
  const double unit = box_.unit;
  for (Point3d* const c : {&star.inside, &star.outside})
    for (std::size_t k = 0; k < 3; ++k)
      (*c)[k] = std::clamp(on_grid((*c)[k], unit), star.box.lo[k] + unit, star.box.hi[k] - unit);
  return true;
}

bool BoxSearch::are_centres() { return veritope::are_centres(forest_, tested_, box_.star); }

// Solves with a few conditions of each piece first: if these are infeasible so is the rest; a solution usually
// satisfies the rest.
bool BoxSearch::search_centres() {
  ++programs_;
  switch (solve_centres(kFewConditions)) {
    case Centres::kNone: return false;
    case Centres::kAllConditions: return are_centres();
    case Centres::kSomeConditions: break;
  }
  return are_centres() || (solve_centres(~std::size_t{0}) != Centres::kNone && are_centres());
}

// The deepest points, on the box's grid, under approximately `most` conditions of each piece.
BoxSearch::Centres BoxSearch::solve_centres(std::size_t most) {
  const Box3d& box = box_.star.box;
  const double unit = box_.unit, enough = 1e-3 * std::min(1.0, kUnitsInBox * unit / extent(box));
  const Point3d m = approx_centre(box);
  Box3d room;
  for (std::size_t k = 0; k < 3; ++k) {
    room.lo[k] = (box.lo[k] + 2 * unit - m[k]) / scale_[k];
    room.hi[k] = (box.hi[k] - 2 * unit - m[k]) / scale_[k];
  }
  half_spaces_.clear();
  bool has_all = true;
  for (const Id id : tested_)
    has_all = append_half_spaces(forest_, id, {m, scale_}, most, &half_spaces_) && has_all;
  double bound = 0;
  const auto inside = deepest_point(half_spaces_, room, enough, &bound);
  if (!inside) return no_centres(bound);
  box_.star.inside = on_grid_near(inside->point);
  for (HalfSpace& h : half_spaces_) h = {{-h.a[0], -h.a[1], -h.a[2]}, -h.b};
  const auto outside = deepest_point(half_spaces_, room, enough, &bound);
  if (!outside) return no_centres(bound);
  box_.star.outside = on_grid_near(outside->point);
  return has_all ? Centres::kAllConditions : Centres::kSomeConditions;
}

// Notes whether centres fail at borders of half-spaces only, or at normals that are zero.
BoxSearch::Centres BoxSearch::no_centres(double bound) {
  is_marginal_ = bound > -kBorderDepth ||
                 std::any_of(half_spaces_.begin(), half_spaces_.end(), [](const HalfSpace& h) {
                   return h.a[0] == 0 && h.a[1] == 0 && h.a[2] == 0;
                 });
  return Centres::kNone;
}

// Converts a point of the linear programs, (c - m) / scale_, to c on the box's grid: the nearest grid point or, if that
// lies outside the half-spaces, on each axis in turn the neighbour that lies deeper in them. (In a thin box one grid
// unit is long.)
Point3d BoxSearch::on_grid_near(Point3d point) const {
  const Point3d m = approx_centre(box_.star.box);
  const double unit = box_.unit;
  const auto length = [&](std::size_t k, double c) { return (c - m[k]) / scale_[k]; };
  Point3d out, moved;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = on_grid(m[k] + scale_[k] * point[k], unit);
    moved[k] = length(k, out[k]);
  }
  if (least_depth(half_spaces_, moved) > 0) return out;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = (m[k] + scale_[k] * point[k]) / unit;
    const std::array<double, 2> neighbours{std::floor(at) * unit, std::ceil(at) * unit};
    std::array<double, 2> depths;
    for (std::size_t i = 0; i < 2; ++i) {
      point[k] = length(k, neighbours[i]);
      depths[i] = least_depth(half_spaces_, point);
    }
    out[k] = neighbours[depths[1] > depths[0] ? 1 : 0];
    point[k] = length(k, out[k]);
  }
  return out;
}

}  // namespace veritope
