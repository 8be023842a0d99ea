// SPDX-License-Identifier: Apache-2.0 OR MIT
#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>

#include "verify/format/dms_invalid_certificate.h"
#include "verify/format/micro_certificate.h"
#include "verify/format/patch_certificate_text_internal.h"

namespace veritope::certificate {
namespace {

std::string plain(std::uint64_t n) { return std::to_string(n); }
template <typename Numbers>
std::string tuple_text(const Numbers& numbers) {
  std::string out = "(";
  for (const auto& x : numbers) {
    if (out.size() > 1) out += ", ";
    if constexpr (std::is_same_v<std::decay_t<decltype(x)>, Fraction>)
      out += internal::short_text(x);
    else
      out += std::to_string(x);
  }
  return out + ")";
}
std::string face_text(const DmsFaceName& f) {
  return "face " + plain(f.number) + " of tetrahedron " + plain(f.tetrahedron);
}

std::string dms_text(const DmsReversedTetrahedron& x) {
  return "tetrahedron " + plain(x.tetrahedron) + " is not positively oriented\n";
}
std::string dms_text(const DmsOverusedFace& x) {
  return face_text(x.faces[0]) + " and " + face_text(x.faces[1]) + " are one cyclic order\n";
}
std::string dms_text(const DmsDegenerateCloud& x) {
  return "tetrahedron " + plain(x.tetrahedron) + ", the knots " + tuple_text(x.index) +
         ": not positively oriented\n";
}
std::string dms_text(const DmsCloudWithoutCore& x) {
  std::string out = "tetrahedron " + plain(x.tetrahedron) +
                    ": half-spaces of its knots' tetrahedra without a common inner point:\n";
  for (const auto& w : x.weights)
    out += "  " + internal::short_text(w.weight) + " times that opposite to corner " +
           plain(w.corner) + " of " + tuple_text(w.index) + "\n";
  return out;
}
std::string dms_text(const DmsCloudInside& x) {
  return face_text(x.face) + ", its knots up to " + tuple_text(x.last) +
         ": their mean with the weights " + tuple_text(x.weights) + " is inside of tetrahedron " +
         plain(x.tetrahedron) + "\n";
}
std::string dms_text(const DmsNegativePoint& x) {
  return "the determinant of the derivative is below 0 at " + tuple_text(x.at) + "\n";
}
std::string part_text(const DmsPolynomialPart& x) {
  std::string out = "a part of tetrahedron " + plain(x.tetrahedron) + ", with the corners\n";
  for (const auto& p : x.corners) out += "  " + tuple_text(p) + "\n";
  return out;
}
std::string dms_text(const DmsFlatLeaf& x) {
  return "the determinant of the derivative is 0 in " + part_text(x);
}
std::string dms_text(const DmsCoveringLeaf& x) {
  return "the image of " + tuple_text(x.other) + " is also that of a point in " + part_text(x);
}
std::string dms_text(const DmsCrowdedEdgeName& x) {
  return "the edge of the vertices " + plain(x.vertices[0]) + ", " + plain(x.vertices[1]) +
         " is in three faces of the boundary or more\n";
}
std::string dms_text(const DmsPinchedVertexName& x) {
  return "the faces of the boundary at vertex " + plain(x.vertex) + " form several fans\n";
}
std::string dms_text(const DmsImproperPoint& x) {
  return face_text(x.faces[0]) + " and " + face_text(x.faces[1]) +
         " have a common point, the mean of their vertices with the weights " +
         tuple_text(x.weights[0]) + " and " + tuple_text(x.weights[1]) + "\n";
}
std::string dms_text(const DmsOverlapPoint& x) {
  return "the tetrahedra " + plain(x.tetrahedra[0]) + " and " + plain(x.tetrahedra[1]) +
         " have the common inner point " + tuple_text(x.at) + "\n";
}
std::string dms_text(const DmsMeetingPoints& x) {
  return "two points with one image: " + tuple_text(x.at[0]) + " and " + tuple_text(x.at[1]) + "\n";
}
std::string dms_text(const DmsCrossingPieces& x) {
  std::string out = "two pieces of the boundary whose images cross:\n";
  for (std::size_t i = 0; i < 2; ++i) {
    out += std::string("  ") + (i == 0 ? "A" : "B") + ": " + face_text(x.pieces[i].face) +
           ", corners ";
    for (const auto& p : x.pieces[i].corners) out += tuple_text(p) + " ";
    for (const UnitInterval& t : x.at[i])
      out += "[" + plain(t.low) + ", " + plain(t.high) + "]/2^" + plain(t.bits) + " ";
    out.back() = '\n';
  }
  for (const auto& row : x.rows) out += "  row " + tuple_text(row) + "\n";
  return out;
}

}  // namespace

std::string explain(const DmsInvalidBody& body, std::string_view claim, std::size_t) {
  std::string out = "body: " + std::string(claim) + ", " + plain(body.tetrahedra) +
                    " tetrahedra\nfinding: " + std::string(name_of(body.finding)) + "\n" +
                    std::visit([](const auto& finding) { return dms_text(finding); }, body.finding);
  if (needs_planes(body.finding))
    out += "faces of the boundary: " + plain(body.planes.size()) + "\n";
  return out;
}

}  // namespace veritope::certificate
