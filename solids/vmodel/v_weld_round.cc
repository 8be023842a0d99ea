// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_weld_round_internal.h"

#include <algorithm>
#include <limits>
#include <string>

#include "robust/base/entity_error.h"
#include "solids/vmodel/control_gap_internal.h"
#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_face_parts_internal.h"
#include "solids/vmodel/v_parts.h"
#include "splines/bspline_common.h"
#include "splines/bspline_domain.h"

namespace veritope::internal {
namespace {

Error over_control_points(std::uint32_t cell) {
  return error_at_entity(Code::kOverLimit, cell,
                         "the welded cells up to this one would have over " +
                             std::to_string(kMaxWeldControlPoints) + " control points");
}

// The control points of an edge: first + n * step.
struct EdgeLine {
  std::size_t first = 0, step = 0, count = 0;
};
EdgeLine line_of(const Grid<3>& grid, std::size_t edge) {
  const std::size_t axis = edge / 4;
  const auto others = v_face_axes(axis);
  EdgeLine out{0, grid.stride(axis), grid.size[axis]};
  for (std::size_t k = 0; k < 2; ++k)
    if ((edge >> k & 1) != 0) out.first += (grid.size[others[k]] - 1) * grid.stride(others[k]);
  return out;
}
std::size_t place_of_corner(const Grid<3>& grid, std::size_t corner) {
  std::size_t at = 0;
  for (std::size_t a = 0; a < 3; ++a)
    if ((corner >> a & 1) != 0) at += (grid.size[a] - 1) * grid.stride(a);
  return at;
}
// Control points (i, j) of face k.
struct FacePlaces {
  std::array<std::size_t, 2> size{}, step{};
  std::size_t first = 0;

  FacePlaces(const Grid<3>& grid, std::size_t k) {
    const auto axes = v_face_axes(k / 2);
    for (std::size_t n = 0; n < 2; ++n)
      size[n] = grid.size[axes[n]], step[n] = grid.stride(axes[n]);
    if (k % 2 == 1) first = (grid.size[k / 2] - 1) * grid.stride(k / 2);
  }
  std::size_t at(std::size_t i, std::size_t j) const { return first + i * step[0] + j * step[1]; }
};

}  // namespace

WeldRound::WeldRound(const VModel& model, const Rational& eps, const std::vector<NearPair>& pairs,
                     WeldClasses classes)
    : model_(model),
      eps_(eps),
      pairs_(pairs),
      classes_(std::move(classes)),
      is_untied_(pairs.size(), false),
      is_tied_face_(model.num_faces(), false) {
  for (VFaceNumber f = 0; f < model.num_faces(); ++f) is_tied_face_[f] = model.face(f).is_glued();
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (const auto reason = classes_.tie(pairs_[i], eps_)) {
      fail(i, *reason), is_untied_[i] = true;
    } else {
      is_tied_face_[pairs_[i].f] = is_tied_face_[pairs_[i].g] = true;
    }
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!is_tied(i)) continue;
    const VFaceNumber f = pairs_[i].f;
    for (std::size_t n = 0; n < 4; ++n) {
      const std::uint32_t edge = 12 * (f / 6) + edge_of_side(f % 6, n);
      pairs_at_edge_[classes_.edge_class(edge).axis].push_back(i);
      const auto corner =
          corner_of_face(f % 6, {static_cast<unsigned>(n & 1), static_cast<unsigned>(n >> 1)});
      pairs_at_corner_[classes_.corner_class(8 * (f / 6) + corner)].push_back(i);
    }
  }
}

void WeldRound::fail_around(std::uint32_t cell, VApartReason reason) {
  bool is_found = false;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const auto at = pairs_at_corner_.find(classes_.corner_class(8 * cell + k));
    if (at == pairs_at_corner_.end()) continue;
    is_found = true;
    for (const std::size_t i : at->second) fail(i, reason);
  }
  if (is_found) return;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (is_tied(i)) fail(i, reason);
}

void WeldRound::fail_at_edge(std::uint32_t edge_class, VApartReason reason) {
  const auto at = pairs_at_edge_.find(edge_class);
  if (at == pairs_at_edge_.end()) return fail_around(edge_class / 12, reason);
  for (const std::size_t i : at->second) fail(i, reason);
}

// ---- ranks

WeldRound::Rank WeldRound::rank_of_face(VFaceNumber f) const {
  const FaceView face = view(f);
  Rank out{static_cast<std::uint64_t>(face.knots(0).degree + face.knots(1).degree),
           face.size(0) * face.size(1), false, f};
  if (face.is_rational())
    for (std::size_t i = 0; i < face.size(0) && !out.has_weights; ++i)
      for (std::size_t j = 0; j < face.size(1) && !out.has_weights; ++j)
        out.has_weights = face.weight(i, j) != face.weight(0, 0);
  return out;
}

WeldRound::Rank WeldRound::best_rank(std::uint32_t cell,
                                     std::initializer_list<std::size_t> faces) const {
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  Rank best{most, most, true, 6 * cell};
  for (const std::size_t k : faces) {
    const auto f = static_cast<VFaceNumber>(6 * cell + k);
    if (is_tied_face_[f]) best = std::min(best, rank_of_face(f));
  }
  return best;
}

WeldRound::Rank WeldRound::rank_of_corner(std::uint32_t corner) const {
  return best_rank(corner / 8, {corner & 1, 2 + (corner >> 1 & 1), 4 + (corner >> 2 & 1)});
}

WeldRound::Rank WeldRound::rank_of_edge(std::uint32_t edge) const {
  const std::size_t e = edge % 12;
  const auto others = v_face_axes(e / 4);
  return best_rank(edge / 12, {2 * others[0] + (e & 1), 2 * others[1] + (e >> 1 & 1)});
}

// ---- corners

WeldRound::Point3 WeldRound::corner_point(std::uint32_t corner) const {
  return v_corner_point(model_.cell(corner / 8), corner % 8);
}

void WeldRound::place_corners() {
  std::map<std::uint32_t, std::vector<std::uint32_t>> members;
  for (std::uint32_t c = 0; c < 8 * model_.num_cells(); ++c)
    if (const std::uint32_t root = classes_.corner_class(c); classes_.is_tied_corner(root))
      members[root].push_back(c);
  for (const auto& [root, corners] : members) {
    std::vector<Point3> points;
    std::size_t winner = 0;
    Rank best = rank_of_corner(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      points.push_back(corner_point(corners[i]));
      if (i == 0) continue;
      if (Rank rank = rank_of_corner(corners[i]); rank < best) best = rank, winner = i;
    }
    Point3 place = points[winner];
    Rational farthest(0);
    for (const Point3& p : points) farthest = std::max(farthest, point_gap(place, p));
    if (farthest > eps_)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto range =
            std::minmax_element(points.begin(), points.end(),
                                [c](const Point3& p, const Point3& q) { return p[c] < q[c]; });
        place[c] = ((*range.first)[c] + (*range.second)[c]) / Rational(2);
      }
    is_stirred_[root] =
        std::any_of(points.begin(), points.end(), [&](const Point3& p) { return p != place; });
    places_[root] = std::move(place);
  }
}

bool WeldRound::is_stirred_corner(std::uint32_t corner) {
  const auto at = is_stirred_.find(classes_.corner_class(corner));
  return at != is_stirred_.end() && at->second;
}

const WeldRound::Point3* WeldRound::moved_corner(std::uint32_t corner) {
  if (!is_stirred_corner(corner)) return nullptr;
  const Point3& place = places_.at(classes_.corner_class(corner));
  return place == corner_point(corner) ? nullptr : &place;
}

WeldRound::Point3 WeldRound::place_of(std::uint32_t corner) {
  const Point3* const moved = moved_corner(corner);
  return moved != nullptr ? *moved : corner_point(corner);
}

// ---- edges

WeldRound::Curve WeldRound::curve_of(const Member& member) const {
  const VVolume& cell = model_.cell(member.edge / 12);
  Curve curve = with_domain(curve_of_edge(cell, member.edge % 12, cell.is_rational()), 0,
                            Rational(0), Rational(1))
                    .value();
  return member.flips ? reversed(curve, 0) : curve;
}

void WeldRound::set_ends(Curve& curve, const Member& member) {
  const auto ends = ends_of_edge(member.edge % 12);
  const std::uint32_t first = 8 * (member.edge / 12);
  set_control_point(curve, 0, place_of(first + ends[member.flips ? 1 : 0]));
  set_control_point(curve, curve.grid().count() - 1, place_of(first + ends[member.flips ? 0 : 1]));
}

void WeldRound::make_edges() {
  std::map<std::uint32_t, std::vector<Member>> classes;
  for (std::uint32_t e = 0; e < 12 * model_.num_cells(); ++e) {
    if (model_.is_edge_collapsed(e / 12, e % 12)) continue;
    const auto root = classes_.edge_class(e);
    const auto ends = ends_of_edge(e % 12);
    if (classes_.is_tied_edge(root.axis) || is_stirred_corner(8 * (e / 12) + ends[0]) ||
        is_stirred_corner(8 * (e / 12) + ends[1]))
      classes[root.axis].push_back({e, root.flips});
  }
  for (const auto& [root, members] : classes) make_edge(root, members);
}

// Nothing, or why the curve cannot take the places of the edges.
std::optional<VApartReason> WeldRound::fault_of_edge(const Curve& curve,
                                                     const std::vector<Member>& members) const {
  for (const Member& m : members) {
    const auto common = to_common_axes(curve, curve_of(m)).value();
    const auto gap = control_gap(common.first, common.second);
    if (!gap) return VApartReason::kWeights;
    if (*gap > eps_) return VApartReason::kTooFar;
  }
  return std::nullopt;
}

// In the space of all of them, with the weights of one.
WeldRound::Curve WeldRound::middle_of(const std::vector<Member>& members, Curve weights) const {
  UnitSpace space = unit_space(weights.axis(0));
  for (const Member& m : members) space = common_space(space, unit_space(curve_of(m).axis(0)));
  weights = raised(std::move(weights), 0, space);
  std::vector<Curve> curves;
  for (const Member& m : members) curves.push_back(raised(curve_of(m), 0, space));
  for (std::size_t n = 0; n < space.num_control(); ++n) {
    Point3 low = control_point(curves[0], n), high = low;
    for (const Curve& curve : curves) {
      const Point3 p = control_point(curve, n);
      for (std::size_t c = 0; c < 3; ++c)
        low[c] = std::min(low[c], p[c]), high[c] = std::max(high[c], p[c]);
    }
    for (std::size_t c = 0; c < 3; ++c) low[c] = (low[c] + high[c]) / Rational(2);
    set_control_point(weights, n, low);
  }
  return weights;
}

void WeldRound::make_edge(std::uint32_t edge_class, const std::vector<Member>& members) {
  if (classes_.is_reversible(edge_class)) return fail_at_edge(edge_class, VApartReason::kCollapse);
  Member winner = members[0];
  Rank best = rank_of_edge(winner.edge);
  for (const Member& m : members)
    if (Rank rank = rank_of_edge(m.edge); rank < best) best = rank, winner = m;
  Curve curve = curve_of(winner);
  set_ends(curve, winner);
  auto fault = fault_of_edge(curve, members);
  if (fault == VApartReason::kTooFar) {
    curve = middle_of(members, std::move(curve));
    set_ends(curve, winner);
    fault = fault_of_edge(curve, members);
  }
  if (fault) return fail_at_edge(edge_class, *fault);
  const std::size_t number = final_edges_.size();
  for (const Member& m : members) {
    const auto common = to_common_axes(curve, curve_of(m)).value();
    if (control_gap(common.first, common.second)->sign() != 0)
      moved_edges_.emplace(m.edge, MovedEdge{number, m.flips});
  }
  UnitSpace space = unit_space(curve.axis(0));
  final_edges_.push_back({std::move(curve), std::move(space)});
}

// As the edge runs.
WeldRound::Curve WeldRound::moved_curve(const MovedEdge& edge, const UnitSpace& space) const {
  const Curve& curve = final_edges_[edge.number].curve;
  return raised(edge.flips ? reversed(curve, 0) : curve, 0, space);
}

// ---- faces

bool WeldRound::has_moved_side(VFaceNumber f) {
  for (std::size_t n = 0; n < 4; ++n) {
    const std::uint32_t edge = edge_of_side(f % 6, n);
    if (moved_edges_.count(12 * (f / 6) + edge) != 0) return true;
    if (model_.is_edge_collapsed(f / 6, edge) &&
        moved_corner(8 * (f / 6) + ends_of_edge(edge)[0]) != nullptr)
      return true;
  }
  return false;
}

// The face with its sides where they go, in the least space that holds both.
Result<WeldRound::FinalFace> WeldRound::with_moved_sides(VFaceNumber f) {
  const FaceView face = view(f);
  std::array<UnitSpace, 2> spaces{unit_space(face.knots(0)), unit_space(face.knots(1))};
  std::array<const MovedEdge*, 4> moved{};
  for (std::size_t n = 0; n < 4; ++n) {
    const auto at = moved_edges_.find(12 * (f / 6) + edge_of_side(f % 6, n));
    if (at == moved_edges_.end()) continue;
    moved[n] = &at->second;
    const UnitSpace& space = final_edges_[at->second.number].space;
    spaces[n / 2] = common_space(spaces[n / 2], at->second.flips ? reversed_space(space) : space);
  }
  if (spaces[0].num_control() * spaces[1].num_control() > kMaxWeldControlPoints)
    return over_control_points(f / 6);
  Surface surface = on_unit_square(surface_of(face, face.is_rational()));
  for (std::size_t k = 0; k < 2; ++k) surface = raised(std::move(surface), k, spaces[k]);
  const Grid<2> grid = surface.grid();
  for (std::size_t n = 0; n < 4; ++n) {
    const std::size_t along = n / 2;
    const auto place = [&](std::size_t i) {
      const std::size_t line = n % 2 == 0 ? 0 : grid.size[1 - along] - 1;
      return along == 0 ? grid.at({i, line}) : grid.at({line, i});
    };
    const std::uint32_t edge = edge_of_side(f % 6, n);
    if (moved[n] != nullptr) {
      const Curve curve = moved_curve(*moved[n], spaces[along]);
      for (std::size_t i = 0; i < grid.size[along]; ++i)
        set_control_point(surface, place(i), control_point(curve, i));
    } else if (model_.is_edge_collapsed(f / 6, edge)) {
      if (const Point3* const to = moved_corner(8 * (f / 6) + ends_of_edge(edge)[0]))
        for (std::size_t i = 0; i < grid.size[along]; ++i)
          set_control_point(surface, place(i), *to);
    }
  }
  return FinalFace{std::move(surface), std::move(spaces)};
}

void WeldRound::need(std::uint32_t cell, std::size_t axis, const UnitSpace& space) {
  const auto key = static_cast<std::uint32_t>(3 * cell + axis);
  const auto at = needs_.emplace(key, unit_space(model_.cell(cell).axis(axis))).first;
  at->second = common_space(at->second, space);
}

void WeldRound::store(VFaceNumber f, FinalFace face) {
  const auto axes = v_face_axes(f % 6 / 2);
  for (std::size_t k = 0; k < 2; ++k) need(f / 6, axes[k], face.spaces[k]);
  final_faces_.insert_or_assign(f, std::move(face));
}

Result<std::optional<VApartReason>> WeldRound::make_face(VFaceNumber f, VFaceNumber g,
                                                         unsigned symmetry) {
  if (rank_of_face(g) < rank_of_face(f)) {
    std::swap(f, g);
    symmetry = v_symmetry_inverse(symmetry);
  }
  Result<FinalFace> made = with_moved_sides(f);
  if (!made) return made.error();
  FinalFace& own = *made;
  FinalFace other{under_symmetry(own.surface, symmetry), own.spaces};
  if ((symmetry & 1) != 0) std::swap(other.spaces[0], other.spaces[1]);
  for (std::size_t k = 0; k < 2; ++k)
    if ((symmetry >> (k + 1) & 1) != 0)
      other.spaces[k] = reversed_space(std::move(other.spaces[k]));
  const FaceView loser = view(g);
  for (std::size_t k = 0, count = 1; k < 2; ++k) {
    count *= common_space(other.spaces[k], unit_space(loser.knots(k))).num_control();
    if (count > kMaxWeldControlPoints) return over_control_points(g / 6);
  }
  const auto common =
      to_common_axes(other.surface, on_unit_square(surface_of(loser, loser.is_rational()))).value();
  const auto gap = control_gap(common.first, common.second);
  if (!gap) return std::optional(VApartReason::kWeights);
  if (*gap > eps_) return std::optional(VApartReason::kTooFar);
  if (gap->sign() != 0) store(g, std::move(other));
  if (has_moved_side(f)) store(f, std::move(own));
  return std::optional<VApartReason>();
}

std::optional<Error> WeldRound::make_faces() {
  for (VFaceNumber f = 0; f < model_.num_faces(); ++f) {
    const VFaceRole& role = model_.face(f);
    if (!role.is_glued() || role.mate < f) continue;
    if (!has_moved_side(f) && !has_moved_side(role.mate)) continue;
    const auto reason = make_face(f, role.mate, role.symmetry);
    if (!reason) return reason.error();
    if (*reason) fail_around(f / 6, **reason), fail_around(role.mate / 6, **reason);
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (!is_tied(i)) continue;
    const auto reason = make_face(pairs_[i].f, pairs_[i].g, pairs_[i].symmetry);
    if (!reason) return reason.error();
    if (*reason) fail(i, **reason);
  }
  return std::nullopt;
}

// ---- cells

std::optional<Error> WeldRound::make_cells() {
  std::map<std::uint32_t, bool> changed;
  for (const auto& [edge, moved] : moved_edges_) {
    need(edge / 12, edge % 12 / 4,
         moved.flips ? reversed_space(final_edges_[moved.number].space)
                     : final_edges_[moved.number].space);
  }
  for (const auto& entry : needs_) changed[entry.first / 3] = true;
  for (std::uint32_t c = 0; c < 8 * model_.num_cells(); ++c)
    if (moved_corner(c) != nullptr) changed[c / 8] = true;
  for (const auto& entry : changed)
    if (auto error = make_cell(entry.first)) return error;
  for (const auto& [c, cell] : cells_)
    if (const auto fault = fault_of(c, cell)) fail_around(c, *fault);
  return std::nullopt;
}

std::optional<Error> WeldRound::make_cell(std::uint32_t c) {
  std::array<UnitSpace, 3> spaces;
  Grid<3> grid;
  for (std::uint32_t a = 0; a < 3; ++a) {
    const auto at = needs_.find(3 * c + a);
    spaces[a] = at != needs_.end() ? at->second : unit_space(model_.cell(c).axis(a));
    grid.size[a] = spaces[a].num_control();
  }
  const auto count = grid.count_up_to(kMaxWeldControlPoints);
  if (!count || num_control_points_ + *count > kMaxWeldControlPoints) return over_control_points(c);
  num_control_points_ += *count;
  VVolume before = model_.cell(c);
  for (std::size_t a = 0; a < 3; ++a) before = raised(std::move(before), a, spaces[a]);
  WeldedCell cell{std::move(spaces), before, before};
  write_edges(c, cell);
  write_faces(c, cell);
  write_collapsed(c, cell);
  cells_.emplace(c, std::move(cell));
  return std::nullopt;
}

void WeldRound::write_edges(std::uint32_t c, WeldedCell& cell) {
  const Grid<3> grid = cell.after.grid();
  for (std::uint32_t k = 0; k < 8; ++k)
    if (const Point3* const to = moved_corner(8 * c + k))
      set_control_point(cell.after, place_of_corner(grid, k), *to);
  for (std::uint32_t e = 0; e < 12; ++e) {
    const EdgeLine line = line_of(grid, e);
    const auto moved = moved_edges_.find(12 * c + e);
    if (moved != moved_edges_.end()) {
      const Curve curve = moved_curve(moved->second, cell.spaces[e / 4]);
      for (std::size_t n = 0; n < line.count; ++n)
        set_control_point(cell.after, line.first + n * line.step, control_point(curve, n));
    } else if (model_.is_edge_collapsed(c, e)) {
      if (const Point3* const to = moved_corner(8 * c + ends_of_edge(e)[0]))
        for (std::size_t n = 0; n < line.count; ++n)
          set_control_point(cell.after, line.first + n * line.step, *to);
    }
  }
}

void WeldRound::write_faces(std::uint32_t c, WeldedCell& cell) {
  const Grid<3> grid = cell.after.grid();
  for (std::uint32_t k = 0; k < 6; ++k) {
    const auto at = final_faces_.find(6 * c + k);
    if (at == final_faces_.end()) continue;
    const auto axes = v_face_axes(k / 2);
    Surface surface = at->second.surface;
    for (std::size_t n = 0; n < 2; ++n)
      surface = raised(std::move(surface), n, cell.spaces[axes[n]]);
    const FacePlaces places(grid, k);
    for (std::size_t i = 0; i < places.size[0]; ++i)
      for (std::size_t j = 0; j < places.size[1]; ++j)
        set_control_point(cell.after, places.at(i, j),
                          control_point(surface, surface.grid().at({i, j})));
  }
}

// What is collapsed follows its sides.
void WeldRound::write_collapsed(std::uint32_t c, WeldedCell& cell) {
  for (std::uint32_t k = 0; k < 6; ++k) {
    const VCollapse collapse = model_.face(c, k).collapse;
    if (collapse == VCollapse::kNone || !has_moved_side(6 * c + k)) continue;
    const FacePlaces places(cell.after.grid(), k);
    for (std::size_t i = 0; i < places.size[0]; ++i)
      for (std::size_t j = 0; j < places.size[1]; ++j) {
        const std::size_t from = collapse == VCollapse::kToPoint      ? places.at(0, 0)
                                 : collapse == VCollapse::kAlongFirst ? places.at(0, j)
                                                                      : places.at(i, 0);
        set_control_point(cell.after, places.at(i, j), control_point(cell.after, from));
      }
  }
}

std::optional<VApartReason> WeldRound::fault_of(std::uint32_t c, const WeldedCell& cell) const {
  for (std::size_t n = 0; n < cell.after.grid().count(); ++n)
    if (point_gap(control_point(cell.before, n), control_point(cell.after, n)) > eps_)
      return VApartReason::kTooFar;
  for (std::size_t e = 0; e < 12; ++e)
    if (is_edge_collapsed(cell.after, e) != model_.is_edge_collapsed(c, e))
      return VApartReason::kCollapse;
  for (std::size_t k = 0; k < 6; ++k)
    if (collapse_of(FaceView(cell.after, k)) != model_.face(c, k).collapse)
      return VApartReason::kCollapse;
  return std::nullopt;
}

}  // namespace veritope::internal
