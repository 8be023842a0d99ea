// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/vmodel_refuter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "solids/vmodel/v_parts.h"
#include "splines/knot_insertion.h"
#include "verify/certify/parameter_text.h"
#include "verify/certify/vmodel_invalid_work.h"

namespace veritope {
namespace {

using Triple = std::array<Rational, 3>;
using Range = std::array<Rational, 2>;

std::string text_of_point(const Triple& t) {
  return "(" + number_text(t[0]) + ", " + number_text(t[1]) + ", " + number_text(t[2]) + ")";
}
std::string cell_text(std::uint64_t cell) { return "cell " + std::to_string(cell); }

// The finding, with the places that are given in its place, too.
Finding v_defect(const char* code, std::string message, std::vector<CellPlace> places,
                 std::optional<Triple> point) {
  Finding out;
  out.code = code;
  out.message = std::move(message);
  for (const CellPlace& place : places) {
    EntityPart part;
    part.entity = place.cell;
    part.is_of_volume = true;
    for (std::size_t a = 0; a < 3 && (place.box || place.parameters); ++a) {
      const Range range =
          place.box ? (*place.box)[a] : Range{(*place.parameters)[a], (*place.parameters)[a]};
      part.parameters.push_back({round_down(range[0]), round_up(range[1])});
    }
    out.place.parts.push_back(std::move(part));
  }
  out.witness.cells = std::move(places);
  if (!point) return out;
  const Point3d near = {nearest_double((*point)[0]), nearest_double((*point)[1]),
                        nearest_double((*point)[2])};
  if (std::isfinite(near[0]) && std::isfinite(near[1]) && std::isfinite(near[2]))
    out.place.near = near;
  out.witness.point = RationalPoint{std::move(*point)};
  return out;
}

std::optional<certificate::UnitFraction> short_fraction(const Rational& t) {
  if (std::max(t.numerator().bit_length(), t.denominator().bit_length()) >= 63) return std::nullopt;
  return certificate::UnitFraction{t.numerator().low_bits(), t.denominator().low_bits()};
}
// Both over one power of two.
std::optional<certificate::UnitInterval> short_interval(const Range& at) {
  const std::uint64_t bits =
      std::max(at[0].denominator().bit_length(), at[1].denominator().bit_length()) - 1;
  if (bits > 62) return std::nullopt;
  certificate::UnitInterval out{bits, 0, 0};
  for (std::size_t e = 0; e < 2; ++e) {
    const Rational scaled = at[e] * Rational::power_of_two(static_cast<std::int64_t>(bits));
    if (scaled.denominator() != Integer(1)) return std::nullopt;
    (e == 0 ? out.low : out.high) = scaled.numerator().low_bits();
  }
  return out;
}

// The edge of a cell that is a side of a face: its number, the end of each axis, and the axis along which it runs.
struct EdgeOfSide {
  std::size_t edge = 0, axis = 0;
  std::array<std::size_t, 3> ends{};
};
EdgeOfSide edge_of(const VArc& arc) {
  const std::size_t across = arc.face / 2;
  const auto axes = v_face_axes(across);
  EdgeOfSide out;
  out.axis = axes[arc.side / 2];
  out.ends[across] = arc.face % 2;
  out.ends[axes[1 - arc.side / 2]] = arc.side % 2;
  const auto others = v_face_axes(out.axis);
  out.edge = 4 * out.axis + out.ends[others[0]] + 2 * out.ends[others[1]];
  return out;
}
CellPlace place_of(const VModel& model, const VArc& arc) {
  const VVolume& cell = model.cell(arc.cell);
  const EdgeOfSide edge = edge_of(arc);
  CellPlace out{arc.cell, v_edge_name(edge.edge), {}, {}};
  std::array<Range, 3>& box = out.box.emplace();
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = cell.axis(a);
    const Rational end = edge.ends[a] == 0 ? axis.domain_begin() : axis.domain_end();
    box[a] = {end, end};
  }
  const std::vector<Rational> knots = internal::breaks_of(cell.axis(edge.axis));
  const Rational &lo = knots[arc.span], &hi = knots[arc.span + 1];
  box[edge.axis] = {lo + (hi - lo) * arc.at[0], lo + (hi - lo) * arc.at[1]};
  return out;
}

Triple corner_parameters(const VVolume& cell, std::size_t corner) {
  Triple out;
  for (std::size_t a = 0; a < 3; ++a)
    out[a] = (corner >> a & 1) == 0 ? cell.axis(a).domain_begin() : cell.axis(a).domain_end();
  return out;
}

// The number of parts that are named, each once, and their names: "edge u1v1 of cell 0 and edge u0v0 of cell 1".
std::pair<std::size_t, std::string> parts_text(const char* what,
                                               const std::vector<CellPlace>& places) {
  std::vector<std::string> names;
  for (const CellPlace& p : places) {
    std::string name = std::string(what) + " " + p.part + " of " + cell_text(p.cell);
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  }
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return {names.size(), std::move(out)};
}

}  // namespace

FoldPlace fold_place_of(const VPlace& place) {
  FoldPlace out;
  for (std::size_t a = 0; a < 3; ++a) out.piece[a] = place.span[a], out.at[a] = place.at[a];
  return out;
}

std::optional<certificate::CellPoint> VModelRefuter::certified_point(const VPlace& place) const {
  const auto& volume = std::get<ExactVolume>(file_.model.entities[place.cell].shape);
  if (!fits_certificate(volume, fold_place_of(place))) return std::nullopt;
  certificate::CellPoint out;
  out.cell = place.cell;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto at = short_fraction(place.at[a]);
    if (!at) return std::nullopt;
    out.at[a] = {place.span[a], *at};
  }
  return out;
}

std::optional<VRefutation> VModelRefuter::flat(const JacobianFinding& piece) const {
  if (piece.kind != JacobianFinding::Kind::kFlat) return std::nullopt;
  Triple middle;
  for (std::size_t a = 0; a < 3; ++a) middle[a] = (piece.box[a][0] + piece.box[a][1]) / Rational(2);
  const VPlace in = place_at(model_, piece.cell, middle);
  VInvalidWork work(model_, file_.bytes);
  work.add_flat(piece.cell, in.span);
  if (!work.fits()) return std::nullopt;
  const std::array<Range, 3> whole = {
      Range{Rational(0), Rational(1)}, {Rational(0), Rational(1)}, {Rational(0), Rational(1)}};
  const auto box = parameters_of(model_, VBox{piece.cell, in.span, whole});
  return VRefutation{
      v_defect("flat",
               cell_text(piece.cell) + ": the Jacobian determinant is zero on a whole knot span",
               {{piece.cell, {}, {}, box}}, point_of(model_, in)),
      certificate::FlatCell{piece.cell, {in.span[0], in.span[1], in.span[2]}}};
}

std::optional<VRefutation> VModelRefuter::left_handed(std::uint32_t cell) const {
  Grid<3> spans;
  for (std::size_t a = 0; a < 3; ++a)
    spans.size[a] = internal::breaks_of(model_.cell(cell).axis(a)).size() - 1;
  const Rational half(Integer(1), Integer(2));
  for (std::size_t i = 0; i < spans.count(); ++i) {
    const auto index = spans.index_of(i);
    const VPlace place{cell, {index[0], index[1], index[2]}, {half, half, half}};
    const Triple at = parameters_of(model_, place);
    if (jacobian_sign(model_.cell(cell), at) != Sign::kNegative) continue;
    auto point = certified_point(place);
    if (!point) continue;
    return VRefutation{v_defect("left-handed",
                                cell_text(cell) +
                                    " is left-handed: its Jacobian determinant is "
                                    "negative at " +
                                    text_of_point(at),
                                {{cell, {}, at, {}}}, point_of(model_, place)),
                       certificate::LeftHandedCell{std::move(*point)}};
  }
  return std::nullopt;
}

std::optional<VRefutation> VModelRefuter::singular(const VSingularity& where) const {
  const auto cell = static_cast<std::uint32_t>(where.cell);
  Triple at;
  for (std::size_t a = 0; a < 3; ++a) at[a] = (where.box[a][0] + where.box[a][1]) / Rational(2);
  const VPlace right = place_at(model_, cell, at);
  const auto& volume = std::get<ExactVolume>(file_.model.entities[cell].shape);
  for (unsigned left = 0; left < 8;
       ++left) {  // at an inner knot the zero may be that from the left
    VPlace place = right;
    bool is_place = true;
    for (std::size_t a = 0; a < 3; ++a) {
      if ((left >> a & 1) == 0) continue;
      is_place = is_place && place.at[a].sign() == Sign::kZero && place.span[a] > 0;
      if (is_place) --place.span[a], place.at[a] = Rational(1);
    }
    if (!is_place || jacobian_sign(volume, fold_place_of(place)) != Sign::kZero) continue;
    auto point = certified_point(place);
    if (!point) continue;
    return VRefutation{
        v_defect("singular",
                 cell_text(cell) + ": the Jacobian determinant is zero at " + text_of_point(at),
                 {{where.cell, {}, at, {}}}, point_of(model_, place)),
        certificate::SingularPoint{std::move(*point)}};
  }
  return std::nullopt;
}

std::optional<VRefutation> VModelRefuter::overlap(const VOverlap& overlap) const {
  VT_CHECK(is_overlap(model_, overlap), "an overlap is a proof");
  auto inside = certified_point(overlap.inside);
  if (!inside) return std::nullopt;
  certificate::CellOverlap out;
  out.inside = std::move(*inside);
  const Triple at = parameters_of(model_, overlap.inside), point = point_of(model_, overlap.inside);
  std::vector<CellPlace> places = {{overlap.inside.cell, {}, at, {}}};
  if (overlap.point) {
    auto other = certified_point(*overlap.point);
    if (!other) return std::nullopt;
    out.other = std::move(*other);
    places.push_back({overlap.point->cell, {}, parameters_of(model_, *overlap.point), {}});
  } else {
    const VBox& box = overlap.somewhere->box;
    certificate::CellOverlap::Somewhere other;
    other.box.cell = box.cell;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto interval = short_interval(box.at[a]);
      if (!interval) return std::nullopt;
      other.box.at[a] = {box.span[a], *interval};
    }
    other.rows = overlap.somewhere->rows;
    VInvalidWork work(model_, file_.bytes);
    work.add_box(box);
    if (!work.fits()) return std::nullopt;
    out.other = std::move(other);
    places.push_back({box.cell, {}, {}, parameters_of(model_, box)});
  }
  const bool is_self = places[0].cell == places[1].cell;
  std::string message =
      is_self ? cell_text(places[0].cell) + " runs through itself: two of its points are "
              : "cells " + std::to_string(places[0].cell) + " and " +
                    std::to_string(places[1].cell) + " overlap: both have the point ";
  message += text_of_point(point);
  return VRefutation{v_defect("overlap", std::move(message), std::move(places), point),
                     std::move(out)};
}

std::optional<VRefutation> VModelRefuter::crowded(const VCrowdedCurve& curve) const {
  certificate::CrowdedCurve out;
  std::vector<CellPlace> places;
  std::vector<VFaceNumber> faces;
  VInvalidWork work(model_, file_.bytes);
  for (std::size_t i = 0; i < 3; ++i) {
    const VArc& arc = curve.arcs[i];
    const auto interval = short_interval(arc.at);
    if (!interval) return std::nullopt;
    out.arcs[i] = {arc.cell,
                   static_cast<std::uint8_t>(arc.face),
                   static_cast<std::uint8_t>(arc.side),
                   {arc.span, *interval}};
    places.push_back(place_of(model_, arc));
    faces.push_back(static_cast<VFaceNumber>(6 * arc.cell + arc.face));
    work.add_arc(arc);
  }
  work.add_comparisons(faces, nullptr);
  work.add_cells_near(curve.middle);
  if (!work.fits()) return std::nullopt;
  const auto [count, edges] = parts_text("edge", places);
  std::string message = edges + (count == 1 ? " passes a curve twice at " : " are one curve at ") +
                        text_of_point(curve.middle) +
                        ", where more than two faces that are not glued meet";
  return VRefutation{
      v_defect("curve-nonmanifold", std::move(message), std::move(places), curve.middle),
      std::move(out)};
}

std::optional<VRefutation> VModelRefuter::pinched(const VPinchedPoint& point) const {
  std::vector<CellPlace> places;
  for (const auto& c : point.corners)
    places.push_back(
        {c.cell, v_corner_name(c.corner), corner_parameters(model_.cell(c.cell), c.corner), {}});
  std::vector<VFaceNumber> faces;
  for (std::size_t c = 0; c < model_.num_cells(); ++c)
    for (std::size_t k = 0; k < 8; ++k) {
      if (v_corner_point(model_.cell(c), k) != point.at) continue;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t f = 6 * c + 2 * a + (k >> a & 1);
        if (!model_.face(static_cast<VFaceNumber>(f)).is_collapsed())
          faces.push_back(static_cast<VFaceNumber>(f));
      }
    }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  VInvalidWork work(model_, file_.bytes);
  work.add_comparisons(faces, &point.at);
  work.add_cells_near(point.at);
  if (!work.fits()) return std::nullopt;
  std::string message = parts_text("corner", places).second + " are one point, " +
                        text_of_point(point.at) + ", at which the boundary meets itself";
  return VRefutation{v_defect("point-nonmanifold", std::move(message), std::move(places), point.at),
                     certificate::PinchedPoint{point.corners[0].cell,
                                               static_cast<std::uint8_t>(point.corners[0].corner)}};
}

}  // namespace veritope
