// SPDX-License-Identifier: Apache-2.0 OR MIT
#include <array>

#include "verify/format/patch_certificate_text_internal.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

constexpr std::array<const char*, 6> kFaces = {"u0", "u1", "v0", "v1", "w0", "w1"};

// "face u1 of cell 4".
std::string name_of_face(std::uint64_t face) {
  return std::string("face ") + kFaces[face % 6] + " of cell " + std::to_string(face / 6);
}
// "u0v1w" for the edge along w at u = 0, v = 1.
std::string name_of_zero(std::uint32_t zero) {
  const std::array<std::uint32_t, 3> ends = {zero / 9, zero / 3 % 3, zero % 3};
  std::string out;
  for (std::size_t a = 0; a < 3; ++a) {
    out += "uvw"[a];
    if (ends[a] < 2) out += "01"[ends[a]];
  }
  return out;
}
std::string determinant_text(const VModelDeterminant& d) {
  std::string out = "piece " + std::to_string(d.piece) + ", ";
  std::size_t leaves = 0;
  for (const std::uint8_t symbol : d.tree) leaves += symbol == 0 ? 1 : 0;
  out += std::to_string(leaves) + (leaves == 1 ? " leaf" : " leaves");
  const char* before = ", zero on ";
  for (std::uint32_t zero = 0; zero < 26; ++zero) {
    if ((d.zeros >> zero & 1u) == 0) continue;
    out += before + name_of_zero(zero);
    before = ", ";
  }
  return out;
}

}  // namespace

std::string explain(const VModelBody& body, std::string_view claim, std::size_t max_items) {
  std::vector<std::size_t> glued;
  std::size_t reversed = 0, boundary = 0, collapsed = 0;
  for (const VModelCell& cell : body.cells) reversed += cell.is_reversed ? 1 : 0;
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    boundary += body.faces[f].kind == VModelFace::Kind::kBoundary ? 1 : 0;
    collapsed += body.faces[f].kind == VModelFace::Kind::kCollapsed ? 1 : 0;
    if (body.faces[f].kind == VModelFace::Kind::kGlued) glued.push_back(f);
  }
  std::string out = "body: " + std::string(claim) + ", " + std::to_string(body.cells.size()) +
                    " cells (" + std::to_string(reversed) +
                    " reversed)\nfaces: " + std::to_string(boundary) + " of the boundary, " +
                    std::to_string(collapsed) + " collapsed\n";
  internal::append_list(out, "glued pairs", glued.size(), max_items, [&](std::size_t i) {
    const VModelFace& face = body.faces[glued[i]];
    return name_of_face(glued[i]) + " and " + name_of_face(face.other) + ", symmetry " +
           std::to_string(face.symmetry);
  });
  internal::append_list(out, "determinants", body.determinants.size(), max_items,
                        [&](std::size_t i) { return determinant_text(body.determinants[i]); });
  return out + "the boundary as a " + explain(body.boundary, kStarBox2Claim, max_items);
}

}  // namespace veritope::certificate
