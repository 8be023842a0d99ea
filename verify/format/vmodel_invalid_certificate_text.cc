// SPDX-License-Identifier: Apache-2.0 OR MIT
#include <array>
#include <string>

#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/text_parts.h"
#include "verify/format/vmodel_invalid_certificate.h"

namespace veritope::certificate {
namespace {

constexpr std::array<const char*, 3> kAxisNames = {"u", "v", "w"};

std::string digits(std::uint64_t n) { return std::to_string(n); }
std::string in_cell(std::uint64_t cell) { return "cell " + digits(cell); }

std::string place_text(const CellPoint& p) {
  std::string out = in_cell(p.cell) + ":";
  for (std::size_t a = 0; a < 3; ++a)
    out += std::string(a == 0 ? " " : ", ") + kAxisNames[a] + " at " +
           digits(p.at[a].at.numerator) + "/" + digits(p.at[a].at.denominator) + " of piece " +
           digits(p.at[a].piece);
  return out + "\n";
}
std::string span_text(const SpanInterval& t) {
  return "from " + digits(t.at.low) + "/2^" + digits(t.at.bits) + " to " + digits(t.at.high) +
         "/2^" + digits(t.at.bits) + " of piece " + digits(t.piece);
}
std::string place_text(const CellOverlap::Somewhere& s) {
  std::string out = in_cell(s.box.cell) + ":";
  for (std::size_t a = 0; a < 3; ++a)
    out += std::string(a == 0 ? " " : ", ") + kAxisNames[a] + " " + span_text(s.box.at[a]);
  out += "\n";
  for (std::size_t i = 0; i < 3; ++i) {
    out += "  row " + digits(i + 1) + ":";
    for (const std::int64_t v : s.rows[i]) out += " " + std::to_string(v);
    out += "\n";
  }
  return out;
}

std::string cells_text(const FlatCell& x) {
  std::string out = "the Jacobian determinant vanishes on a part of " + in_cell(x.cell) + ":";
  for (std::size_t a = 0; a < 3; ++a)
    out += std::string(a == 0 ? " " : ", ") + kAxisNames[a] + " in piece " + digits(x.pieces[a]);
  return out + "\n";
}
std::string cells_text(const LeftHandedCell& x) {
  return "the Jacobian determinant is negative at\n  " + place_text(x.at);
}
std::string cells_text(const SingularPoint& x) {
  return "the Jacobian determinant is 0 at\n  " + place_text(x.at);
}
std::string cells_text(const CellOverlap& x) {
  const auto other = [](const auto& place) { return place_text(place); };
  return "two points of the cells with one image:\n  A: " + place_text(x.inside) +
         (x.other.index() == 0 ? "  B: " : "  B: somewhere in ") + std::visit(other, x.other);
}
std::string cells_text(const CrowdedCurve& x) {
  std::string out = "three sides of faces that pass one arc:\n";
  for (const FaceArc& arc : x.arcs)
    out += "  " + in_cell(arc.cell) + ", face " + digits(arc.face) + ", side " + digits(arc.side) +
           ", " + span_text(arc.at) + "\n";
  return out;
}
std::string cells_text(const PinchedPoint& x) {
  return "two corners of the boundary are one point of space: corner " + digits(x.corner) + " of " +
         in_cell(x.cell) + "\n";
}

}  // namespace

std::string explain(const VModelInvalidBody& body, std::string_view claim, std::size_t) {
  return "body: " + std::string(claim) + ", " + digits(body.cells) +
         " cells\nfinding: " + std::string(name_of(body.finding)) + "\n" +
         std::visit([](const auto& finding) { return cells_text(finding); }, body.finding);
}

}  // namespace veritope::certificate
