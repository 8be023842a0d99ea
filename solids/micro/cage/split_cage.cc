// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/split_cage.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "solids/vmodel/v_model.h"
#include "solids/volumes/placed.h"

namespace veritope {
namespace {

struct CagePlane {
  std::uint32_t cell;
  std::size_t axis;
  Rational at;
  auto operator<=>(const CagePlane&) const = default;
};

// The parameters at which the axes of cells are cut.
class CutPropagation {
 public:
  explicit CutPropagation(const VModel& model) : model_(model) {}

  Status add(CagePlane plane) {
    std::vector<CagePlane> open{std::move(plane)};
    while (!open.empty()) {
      const CagePlane next = std::move(open.back());
      open.pop_back();
      if (!planes_.insert(next).second) continue;
      if (planes_.size() > kMaxSplitCells)
        return Error{Code::kOverLimit,
                     {},
                     "the cut would have to go on through more than " +
                         std::to_string(kMaxSplitCells) + " cells"};
      for (std::size_t across = 0; across < 3; ++across)
        for (std::size_t end = 0; end < 2 && across != next.axis; ++end)
          if (auto beyond = through(next, across, end)) open.push_back(std::move(*beyond));
    }
    return ok_status();
  }

  std::vector<Rational> of(std::uint32_t cell, std::size_t axis) const {
    std::vector<Rational> out;
    for (const CagePlane& p : planes_)
      if (p.cell == cell && p.axis == axis) out.push_back(p.at);
    return out;
  }

 private:
  std::optional<CagePlane> through(const CagePlane& plane, std::size_t across,
                                   std::size_t end) const {
    const VFaceRole& role = model_.face(plane.cell, 2 * across + end);
    if (!role.is_glued()) return std::nullopt;
    const std::size_t which = v_face_axes(across)[0] == plane.axis ? 0 : 1;
    const unsigned s = role.symmetry;
    const std::size_t there = (s & 1) != 0 ? 1 - which : which;
    const bool is_reversed = there == 0 ? ((s >> 1) & 1) != 0 : (s >> 2) != 0;
    const auto& axis = model_.cell(plane.cell).axis(plane.axis);
    Rational part = (plane.at - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin());
    if (is_reversed) part = Rational(1) - part;
    CagePlane out{role.mate / 6, v_face_axes(role.mate % 6 / 2)[there], {}};
    const auto& to = model_.cell(out.cell).axis(out.axis);
    out.at = to.domain_begin() + part * (to.domain_end() - to.domain_begin());
    return out;
  }

  const VModel& model_;
  std::set<CagePlane> planes_;
};

std::vector<CellVolume> cut_at(std::vector<CellVolume> parts, std::size_t axis,
                               const std::vector<Rational>& places) {
  std::vector<CellVolume> out;
  for (CellVolume& part : parts) {
    CellVolume rest = std::move(part);
    for (const Rational& place : places) {
      auto halves = split(rest, axis, place).value();
      out.push_back(std::move(halves[0]));
      rest = std::move(halves[1]);
    }
    out.push_back(std::move(rest));
  }
  return out;
}

// A function of one axis of a part: linear, with these values at the ends of its domain, at its Greville abscissae.
std::vector<Rational> slope_of(const KnotAxis<Rational>& axis, const Rational& begin,
                               const Rational& end) {
  std::vector<Rational> out;
  for (const Rational& part : internal::rising(axis)) out.push_back(begin + (end - begin) * part);
  return out;
}

class CrackOpener {
 public:
  CrackOpener(const CellVolume& whole, const CageSplit& split)
      : whole_(whole), split_(split), crack_(*split.crack) {}

  void open(CellVolume& part) const {
    const auto& across = part.axis(split_.axis);
    const bool is_low = across.domain_end() == split_.at;
    if (!is_low && across.domain_begin() != split_.at) return;
    const auto& along = part.axis(crack_.axis);
    const Rational begin = depth(along.domain_begin()), end = depth(along.domain_end());
    if (begin.sign() == Sign::kNegative || end.sign() == Sign::kNegative) return;
    const std::vector<Rational> to_wall = slope_of(across, is_low ? 0 : 1, is_low ? 1 : 0);
    const std::vector<Rational> to_face = slope_of(along, begin, end);
    const CellPoint& move = is_low ? crack_.low : crack_.high;
    const Grid<3> grid = part.grid();
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto at = grid.index_of(n);
      Rational factor = to_wall[at[split_.axis]] * to_face[at[crack_.axis]];
      if (part.is_rational()) factor *= part.component(part.num_components() - 1)[n];
      for (std::size_t k = 0; k < 3; ++k)
        part.component(static_cast<int>(k))[n] += factor * move[k];
    }
  }

 private:
  // 0 at the line, 1 at the face.
  Rational depth(const Rational& at) const {
    const auto& axis = whole_.axis(crack_.axis);
    const Rational& face = crack_.is_at_end ? axis.domain_end() : axis.domain_begin();
    return (at - crack_.from) / (face - crack_.from);
  }

  const CellVolume& whole_;
  const CageSplit& split_;
  const CageCrack& crack_;
};

Status check_inside(const char* what, const Rational& at, const KnotAxis<Rational>& axis) {
  if (axis.domain_begin() < at && at < axis.domain_end()) return ok_status();
  return bad_argument(std::string(what) + " must lie inside of the domain, from " +
                      axis.domain_begin().to_string() + " to " + axis.domain_end().to_string() +
                      ", and it is " + at.to_string());
}

Status check_split(const std::vector<CellVolume>& cells, const CageSplit& split) {
  if (split.cell >= cells.size())
    return bad_argument(
        "entity " + std::to_string(split.cell) + " does not exist: there " +
        (cells.size() == 1 ? "is 1 cell" : "are " + std::to_string(cells.size()) + " cells") +
        ", numbered from 0");
  const CellVolume& cell = cells[split.cell];
  if (const Status in = check_inside("at", split.at, cell.axis(split.axis)); !in) return in;
  if (!split.crack) return ok_status();
  if (split.crack->axis == split.axis)
    return bad_argument("open names a face across the axis of the cut, along which no crack runs");
  if (split.crack->low == split.crack->high)
    return bad_argument("low and high are equal: nothing would open");
  return check_inside("from", split.crack->from, cell.axis(split.crack->axis));
}

}  // namespace

Result<std::vector<CellVolume>> split_cage(std::vector<CellVolume> cells, const CageSplit& split) {
  const Result<VModel> model = make_v_model(cells, VOrientation::kAuto);
  if (!model) return model.error();
  if (const Status fits = check_split(cells, split); !fits) return fits.error();
  CutPropagation cuts(*model);
  if (const Status ok = cuts.add({split.cell, split.axis, split.at}); !ok) return ok.error();
  if (split.crack)
    if (const Status ok = cuts.add({split.cell, split.crack->axis, split.crack->from}); !ok)
      return ok.error();
  std::vector<CellVolume> out;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    std::vector<CellVolume> parts{cells[c]};
    std::size_t count = 1;
    std::array<std::vector<Rational>, 3> places;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      places[axis] = cuts.of(c, axis);
      count *= places[axis].size() + 1;
      if (out.size() + count > kMaxSplitCells)
        return Error{Code::kOverLimit,
                     {},
                     "the cut gives more than " + std::to_string(kMaxSplitCells) + " cells"};
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      parts = cut_at(std::move(parts), axis, places[axis]);
    if (split.crack && c == split.cell)
      for (CellVolume& part : parts) CrackOpener(cells[c], split).open(part);
    for (CellVolume& part : parts) out.push_back(std::move(part));
  }
  return out;
}

}  // namespace veritope
