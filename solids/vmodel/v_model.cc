// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_model.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <tuple>

#include "robust/base/disjoint_sets.h"
#include "robust/base/entity_error.h"
#include "solids/patches/tied_axes.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_face_internal.h"
#include "splines/knot_insertion.h"

namespace veritope {

using internal::FaceView;

namespace {

std::string axis_text(std::size_t axis) { return "axis " + std::to_string(axis) + ": "; }

std::optional<Error> fault_of_axis(const KnotAxis<Rational>& axis, std::size_t number,
                                   std::uint64_t cell) {
  const std::string at = axis_text(number);
  if (axis.degree > kMaxVDegree)
    return error_at_entity(Code::kOverLimit, cell,
                           "the volume has the degree " + std::to_string(axis.degree) + " along " +
                               "uvw"[number] + ", and certificates are about volumes of a degree " +
                               "of at most " + std::to_string(kMaxVDegree));
  const auto p = static_cast<std::size_t>(axis.degree);
  if (axis.knots.front() != axis.domain_begin() || axis.knots.back() != axis.domain_end())
    return error_at_entity(Code::kBadArgument, cell, at + "the knots are not clamped");
  for (std::size_t i = p + 1; i + p < axis.num_control(); ++i)
    if (axis.knots[i] == axis.knots[i + p])
      return error_at_entity(Code::kBadArgument, cell,
                             at + "the inner knot " + internal::knot_text(axis.knots[i]) +
                                 " occurs more often than the degree " + std::to_string(p));
  return std::nullopt;
}

std::optional<Error> fault_of_cell(const VVolume& cell, std::uint64_t number) {
  for (std::size_t a = 0; a < 3; ++a)
    if (auto error = fault_of_axis(cell.axis(a), a, number)) return error;
  if (!cell.is_rational()) return std::nullopt;
  for (const Rational& w : cell.component(cell.num_components() - 1))
    if (w.sign() <= 0)
      return error_at_entity(Code::kBadArgument, number,
                             "the weight " + w.to_string() + " is not positive");
  return std::nullopt;
}

// Corner e0 + 2 e1 + 4 e2 of the cell, from a corner (x, y) of its face k.
std::uint32_t corner_of_face(std::size_t k, std::array<unsigned, 2> at) {
  const auto axes = v_face_axes(k / 2);
  return static_cast<std::uint32_t>((k % 2) << (k / 2) | at[0] << axes[0] | at[1] << axes[1]);
}
// Edge 4 axis + e + 2 f between two corners.
std::uint32_t edge_between(std::uint32_t c, std::uint32_t d) {
  const std::uint32_t axis = (c ^ d) == 1 ? 0 : (c ^ d) == 2 ? 1 : 2;
  const auto others = v_face_axes(axis);
  return 4 * axis + (c >> others[0] & 1) + 2 * (c >> others[1] & 1);
}
constexpr std::array<std::array<std::array<unsigned, 2>, 2>, 4> kSidesOfFace = {{
    {{{0, 0}, {1, 0}}},
    {{{0, 1}, {1, 1}}},  // along the first parameter
    {{{0, 0}, {0, 1}}},
    {{{1, 0}, {1, 1}}},  // along the second one
}};

std::array<std::uint32_t, 2> ends_of_edge(std::size_t edge) {
  const std::size_t axis = edge / 4;
  const auto others = v_face_axes(axis);
  const auto low =
      static_cast<std::uint32_t>((edge & 1) << others[0] | (edge >> 1 & 1) << others[1]);
  return {low, low | 1u << axis};
}

std::uint64_t num_classes(DisjointSets<>& sets, const std::vector<bool>* left_out) {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < sets.size(); ++i)
    if (sets.find(i) == i && (left_out == nullptr || !(*left_out)[i])) ++count;
  return count;
}

}  // namespace

const std::vector<Rational>& VModel::added_breaks(std::size_t c, std::size_t axis) const {
  return added_[added_of_[c][axis]];
}

std::vector<Rational> VModel::breaks(std::size_t c, std::size_t axis) const {
  const auto knots = internal::breaks_of(cells_[c].axis(axis));
  const auto& added = added_breaks(c, axis);
  std::vector<Rational> out;
  std::merge(knots.begin(), knots.end(), added.begin(), added.end(), std::back_inserter(out));
  return out;
}

Result<VVolume> geometry_of(const VVolume& volume) {
  if (volume.dimension() < 3)
    return bad_argument("a volume with " + std::to_string(volume.dimension()) +
                        " coordinates, not in space");
  if (volume.dimension() == 3) return volume;
  std::vector<Rational> values;
  for (int c = 0; c < 3; ++c)
    values.insert(values.end(), volume.component(c).begin(), volume.component(c).end());
  if (volume.is_rational()) {
    const auto weights = volume.component(volume.num_components() - 1);
    values.insert(values.end(), weights.begin(), weights.end());
  }
  return VVolume(volume.axes(), volume.is_rational() ? 4 : 3, volume.is_rational(),
                 std::move(values));
}

class VModelMaker {
 public:
  std::optional<Error> take(std::vector<VVolume> cells) {
    if (cells.empty()) return Error{Code::kEmpty, {}, "there is no cell"};
    if (cells.size() > kMaxVCells)
      return error_at_entity(Code::kOverLimit, kMaxVCells,
                             "there are over " + std::to_string(kMaxVCells) + " cells");
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].dimension() != 3) {
        Result<VVolume> geometry = geometry_of(cells[c]);
        if (!geometry) return error_at_entity(geometry.error().code, c, geometry.error().message);
        cells[c] = std::move(geometry).value();
      }
      if (auto error = fault_of_cell(cells[c], c)) return error;
    }
    m_.cells_ = std::move(cells);
    return std::nullopt;
  }

  void find_hands(VOrientation orientation) {
    for (std::uint32_t c = 0; c < m_.num_cells(); ++c) {
      m_.hands_.push_back(hand_of(m_.cells_[c]));
      if (m_.hands_.back() < 0) m_.left_handed_.push_back(c);
    }
    m_.is_reversed_.assign(m_.num_cells(), false);
    if (orientation == VOrientation::kKeep) return;
    for (const std::uint32_t c : m_.left_handed_) m_.is_reversed_[c] = true;
  }

  void find_collapses() {
    m_.faces_.resize(6 * m_.num_cells());
    m_.collapsed_edges_.resize(m_.num_cells());
    for (std::size_t c = 0; c < m_.num_cells(); ++c) {
      for (std::size_t k = 0; k < 6; ++k)
        m_.faces_[6 * c + k].collapse = internal::collapse_of(FaceView(m_.cells_[c], k));
      for (std::size_t e = 0; e < 12; ++e)
        if (internal::is_edge_collapsed(m_.cells_[c], e))
          m_.collapsed_edges_[c] = static_cast<std::uint16_t>(m_.collapsed_edges_[c] | 1u << e);
    }
  }

  void glue() {
    auto keys = hashed_faces(all_open_faces(), internal::corner_hash);
    for_each_group(keys, [&](std::vector<VFaceNumber> group) {
      if (group.size() == 2) return match(group);
      auto inner = hashed_faces(group, internal::inner_hash);
      for_each_group(inner, [&](const std::vector<VFaceNumber>& same) { match(same); });
    });
    std::sort(m_.copies_.begin(), m_.copies_.end());
    std::sort(m_.crowds_.begin(), m_.crowds_.end());
  }

  std::optional<Error> find_breaks() {
    internal::TiedAxes axes(3 * m_.num_cells());
    for (VFaceNumber f = 0; f < m_.num_faces(); ++f) tie_axes(axes, f);
    if (auto error = cut_axes(axes)) return error;
    m_.first_piece_.push_back(0);
    for (std::size_t c = 0; c < m_.num_cells(); ++c) {
      Grid<3> grid;
      for (std::size_t a = 0; a < 3; ++a)
        grid.size[a] =
            internal::breaks_of(m_.cells_[c].axis(a)).size() - 1 + m_.added_breaks(c, a).size();
      const auto count = grid.count_up_to(kMaxVPieces);
      if (!count || m_.first_piece_.back() + *count > kMaxVPieces) return too_many_pieces(c);
      m_.piece_grids_.push_back(grid);
      m_.first_piece_.push_back(m_.first_piece_.back() + *count);
    }
    return std::nullopt;
  }

  void count() {
    VCounts& n = m_.counts_;
    n.cells = m_.num_cells();
    n.pieces = m_.num_pieces();
    n.reversed = static_cast<std::uint64_t>(
        std::count(m_.is_reversed_.begin(), m_.is_reversed_.end(), true));
    for (const VFaceRole& role : m_.faces_) {
      n.half_v_surfaces += role.is_collapsed() ? 0 : 1;
      n.boundary += role.is_border() ? 1 : 0;
    }
    n.internal = (n.half_v_surfaces - n.boundary) / 2;
    n.v_surfaces = n.internal + n.boundary;
    count_points_and_curves();
    n.euler = static_cast<std::int64_t>(n.v_points) - static_cast<std::int64_t>(n.v_curves) +
              static_cast<std::int64_t>(n.v_surfaces) - static_cast<std::int64_t>(n.cells);
  }

  VModel finish() && {
    for (std::size_t c = 0; c < m_.num_cells(); ++c)
      if (m_.piece_grids_[c].count() > 1) internal::find_forbidden(m_, c, m_.forbidden_);
    return std::move(m_);
  }

 private:
  using Keys = std::vector<std::pair<std::uint64_t, VFaceNumber>>;

  static Sign hand_of(const VVolume& cell) {
    std::array<std::vector<Rational>, 3> breaks;
    Grid<3> grid;
    for (std::size_t a = 0; a < 3; ++a) {
      breaks[a] = internal::breaks_of(cell.axis(a));
      grid.size[a] = breaks[a].size() - 1;
    }
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto piece = grid.index_of(n);
      std::array<Rational, 3> middle;
      for (std::size_t a = 0; a < 3; ++a)
        middle[a] = (breaks[a][piece[a]] + breaks[a][piece[a] + 1]) / Rational(2);
      if (const Sign sign = jacobian_sign(cell, middle); sign != 0) return sign;
    }
    return Sign::kZero;
  }

  FaceView view(VFaceNumber f) const { return {m_.cells_[f / 6], f % 6}; }

  std::vector<VFaceNumber> all_open_faces() const {
    std::vector<VFaceNumber> out;
    for (VFaceNumber f = 0; f < m_.num_faces(); ++f)
      if (!m_.faces_[f].is_collapsed()) out.push_back(f);
    return out;
  }
  template <typename Hash>
  Keys hashed_faces(const std::vector<VFaceNumber>& faces, Hash hash) const {
    Keys keys;
    keys.reserve(faces.size());
    for (const VFaceNumber f : faces) keys.emplace_back(hash(view(f)), f);
    std::sort(keys.begin(), keys.end());
    return keys;
  }
  // Two or more faces with one key, ascending.
  template <typename Visit>
  static void for_each_group(const Keys& keys, Visit visit) {
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
      while (end < keys.size() && keys[end].first == keys[begin].first) ++end;
      if (end - begin < 2) continue;
      std::vector<VFaceNumber> group;
      for (std::size_t i = begin; i < end; ++i) group.push_back(keys[i].second);
      visit(std::move(group));
    }
  }

  // -1 or 1, as section 4 of the page defines it.
  int hand_of_face(VFaceNumber f) const {
    const std::size_t k = f % 6;
    int hand = k % 2 == 0 ? -1 : 1;
    if (k / 2 == 1) hand = -hand;
    return m_.is_reversed_[f / 6] ? -hand : hand;
  }
  // Bit s for the symmetries that glue.
  unsigned gluing_symmetries(VFaceNumber f, VFaceNumber g) const {
    const bool is_odd = hand_of_face(f) * hand_of_face(g) == 1;
    unsigned out = 0;
    for (unsigned s = 0; s < 8; ++s)
      if (is_v_symmetry_odd(s) == is_odd) out |= 1u << s;
    return out;
  }

  // Sorts the faces of a group into classes of equal ones, and glues those of two.
  void match(const std::vector<VFaceNumber>& group) {
    std::vector<std::vector<VFaceNumber>> classes;
    if (group.size() == 2) return match_pair(group[0], group[1]);
    for (const VFaceNumber f : group) {
      const auto of = std::find_if(classes.begin(), classes.end(), [&](const auto& known) {
        return internal::equal_symmetries(view(known.front()), view(f), 0xff) != 0;
      });
      if (of == classes.end()) {
        classes.push_back({f});
      } else {
        of->push_back(f);
      }
    }
    for (auto& equal : classes) {
      if (equal.size() == 2) match_pair(equal[0], equal[1]);
      if (equal.size() > 2) m_.crowds_.push_back(std::move(equal));
    }
  }
  void match_pair(VFaceNumber f, VFaceNumber g) {
    const unsigned right = gluing_symmetries(f, g);
    for (unsigned s = 0; s < 8; ++s) {
      if ((right >> s & 1) == 0 || internal::equal_symmetries(view(f), view(g), 1u << s) == 0)
        continue;
      m_.faces_[f].mate = g;
      m_.faces_[f].symmetry = static_cast<std::uint8_t>(s);
      m_.faces_[g].mate = f;
      m_.faces_[g].symmetry = static_cast<std::uint8_t>(v_symmetry_inverse(s));
      return;
    }
    if (internal::equal_symmetries(view(f), view(g), 0xff & ~right) != 0)
      m_.copies_.push_back({f, g});
  }

  // ---- breaks

  void tie_axes(internal::TiedAxes& axes, VFaceNumber f) const {
    const VFaceRole& role = m_.faces_[f];
    if (!role.is_glued() || role.mate < f) return;
    const auto own = v_face_axes(f % 6 / 2), others = v_face_axes(role.mate % 6 / 2);
    const std::size_t first = role.symmetry & 1;
    const auto number = [](VFaceNumber face, std::size_t axis) {
      return static_cast<std::uint32_t>(3 * (face / 6) + axis);
    };
    axes.tie(number(f, own[first]), number(role.mate, others[0]), (role.symmetry & 2) != 0);
    axes.tie(number(f, own[1 - first]), number(role.mate, others[1]), (role.symmetry & 4) != 0);
  }

  // The inner knots of an axis on [0,1], reversed if asked for.
  std::vector<Rational> inner_breaks(std::uint32_t axis, bool is_reversed) const {
    const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
    std::vector<Rational> out = internal::breaks_of(knots);
    out.pop_back();
    out.erase(out.begin());
    const Rational begin = knots.domain_begin(), length = knots.domain_end() - begin;
    for (Rational& t : out)
      t = is_reversed ? Rational(1) - (t - begin) / length : (t - begin) / length;
    if (is_reversed) std::reverse(out.begin(), out.end());
    return out;
  }

  static Error too_many_pieces(std::uint64_t cell) {
    return error_at_entity(
        Code::kOverLimit, cell,
        "the cells up to this one have over " + std::to_string(kMaxVPieces) + " pieces");
  }

  std::optional<Error> cut_axes(internal::TiedAxes& axes) {
    const auto count = static_cast<std::uint32_t>(3 * m_.num_cells());
    std::vector<std::vector<Rational>> all(count);  // of each root
    for (std::uint32_t a = 0; a < count; ++a) {
      if (!has_inner(a)) continue;
      const auto root = axes.find(a);
      add_breaks(all[root.axis], inner_breaks(a, root.flips));
      if (axes.is_symmetric(root.axis)) add_breaks(all[root.axis], inner_breaks(a, !root.flips));
    }
    m_.added_.emplace_back();
    m_.added_of_.assign(m_.num_cells(), {0, 0, 0});
    std::array<std::uint64_t, 3> breaks{};  // a cell has no fewer pieces than breaks on an axis
    for (std::uint32_t a = 0; a < count; ++a) {
      const auto root = axes.find(a);
      if (all[root.axis].empty()) continue;
      breaks[a % 3] += all[root.axis].size();
      if (breaks[a % 3] > kMaxVPieces) return too_many_pieces(a / 3);
      add_missing(a, all[root.axis], root.flips);
    }
    return std::nullopt;
  }
  bool has_inner(std::uint32_t axis) const {
    const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
    return knots.num_control() > static_cast<std::size_t>(knots.degree) + 1;
  }
  static void add_breaks(std::vector<Rational>& to, std::vector<Rational> from) {
    if (to == from) return;
    std::vector<Rational> both;
    std::set_union(to.begin(), to.end(), from.begin(), from.end(), std::back_inserter(both));
    to = std::move(both);
  }
  void add_missing(std::uint32_t axis, const std::vector<Rational>& all, bool is_reversed) {
    std::vector<Rational> wanted = all, missing;
    if (is_reversed) {
      for (Rational& t : wanted) t = Rational(1) - t;
      std::reverse(wanted.begin(), wanted.end());
    }
    const auto own = inner_breaks(axis, false);
    std::set_difference(wanted.begin(), wanted.end(), own.begin(), own.end(),
                        std::back_inserter(missing));
    if (missing.empty()) return;
    const auto& knots = m_.cells_[axis / 3].axis(axis % 3);
    for (Rational& t : missing)
      t = knots.domain_begin() + t * (knots.domain_end() - knots.domain_begin());
    m_.added_of_[axis / 3][axis % 3] = static_cast<std::uint32_t>(m_.added_.size());
    m_.added_.push_back(std::move(missing));
  }

  // ---- numbers

  void count_points_and_curves() {
    DisjointSets<> points(8 * m_.num_cells()), curves(12 * m_.num_cells());
    for (VFaceNumber f = 0; f < m_.num_faces(); ++f) {
      const VFaceRole& role = m_.faces_[f];
      if (role.is_glued() && role.mate > f) identify(points, curves, f, role);
      if (role.collapse == VCollapse::kAlongFirst) identify_sides(curves, f, 2);
      if (role.collapse == VCollapse::kAlongSecond) identify_sides(curves, f, 0);
    }
    std::vector<bool> is_collapsed(curves.size(), false);
    for (std::uint32_t c = 0; c < m_.num_cells(); ++c)
      for (std::uint32_t e = 0; e < 12; ++e)
        if (m_.is_edge_collapsed(c, e)) {
          is_collapsed[curves.find(12 * c + e)] = true;
          const auto ends = ends_of_edge(e);
          points.join(8 * c + ends[0], 8 * c + ends[1]);
        }
    m_.counts_.v_points = num_classes(points, nullptr);
    m_.counts_.v_curves = num_classes(curves, &is_collapsed);
  }
  static void identify(DisjointSets<>& points, DisjointSets<>& curves, VFaceNumber f,
                       const VFaceRole& role) {
    const auto cell = static_cast<std::uint32_t>(f / 6),
               other = static_cast<std::uint32_t>(role.mate / 6);
    for (const auto& side : kSidesOfFace) {
      std::array<std::uint32_t, 2> own{}, others{};
      for (std::size_t end = 0; end < 2; ++end) {
        own[end] = corner_of_face(f % 6, side[end]);
        others[end] = corner_of_face(role.mate % 6, v_symmetry_image(role.symmetry, side[end]));
        points.join(8 * cell + own[end], 8 * other + others[end]);
      }
      curves.join(12 * cell + edge_between(own[0], own[1]),
                  12 * other + edge_between(others[0], others[1]));
    }
  }
  // Sides n and n + 1 of the face.
  static void identify_sides(DisjointSets<>& curves, VFaceNumber f, std::size_t n) {
    const auto edge = [&](std::size_t side) {
      return 12 * (f / 6) + edge_between(corner_of_face(f % 6, kSidesOfFace[side][0]),
                                         corner_of_face(f % 6, kSidesOfFace[side][1]));
    };
    curves.join(edge(n), edge(n + 1));
  }

  VModel m_;
};

Result<VModel> make_v_model(std::vector<VVolume> cells, VOrientation orientation) {
  VModelMaker maker;
  if (auto error = maker.take(std::move(cells))) return std::move(*error);
  maker.find_hands(orientation);
  maker.find_collapses();
  maker.glue();
  if (auto error = maker.find_breaks()) return std::move(*error);
  maker.count();
  return std::move(maker).finish();
}

}  // namespace veritope
