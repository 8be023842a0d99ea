// SPDX-License-Identifier: Apache-2.0 OR MIT
// The text form of certificates about meshes.
#include <string>

#include "verify/format/mesh_certificate.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::append_list;
using internal::statement_text;

std::string vector_text(const std::array<std::int32_t, 3>& d) {
  return "(" + std::to_string(d[0]) + ", " + std::to_string(d[1]) + ", " + std::to_string(d[2]) +
         ")";
}

std::string axis_text(std::uint8_t code) {
  std::string text = std::string(code % 2 == 0 ? "+" : "-") + "xyz"[code / 2 % 3];
  return code < 6 ? text : "unknown axis " + std::to_string(code);
}

// "n(a)", "-e0(a) x e2(b)", ... as section 5 of the page names them.
std::string pair_code_text(std::uint8_t code) {
  const int axis = code & 31;
  const auto edge = [](int i, char of) { return "e" + std::to_string(i) + "(" + of + ")"; };
  std::string text = (code & 32) != 0 ? "-" : "";
  if (axis == 0)
    text += "n(a)";
  else if (axis == 1)
    text += "n(b)";
  else if (axis <= 10)
    text += edge((axis - 2) / 3, 'a') + " x " + edge((axis - 2) % 3, 'b');
  else if (axis <= 13)
    text += "n(a) x " + edge(axis - 11, 'a');
  else if (axis <= 16)
    text += "n(b) x " + edge(axis - 14, 'b');
  else
    text += "unknown axis " + std::to_string(axis);
  return text + ((code & 64) != 0 ? ", then" : "");
}

std::string counts_text(const ValidBody& b, std::string_view claim) {
  return "body: " + std::string(claim) + ", " + std::to_string(b.order.size()) + " triangles, " +
         std::to_string(b.num_vertex_ids) + " vertex ids\n";
}

std::string proof_text(const ValidBody& b, std::size_t max_items) {
  std::string out;
  append_list(out, "order (triangle at each leaf)", b.order.size(), max_items,
              [&](std::size_t i) { return std::to_string(b.order[i]); });
  std::vector<std::size_t> by_code(256);
  for (std::uint8_t c : b.stars) ++by_code[c];
  out += "stars: " + std::to_string(b.stars.size() - by_code[0]) + " of " +
         std::to_string(b.stars.size()) + "\n";
  for (std::size_t c = 1; c < by_code.size(); ++c)
    if (by_code[c] != 0)
      out += "  direction " + std::to_string(c) + ": " + std::to_string(by_code[c]) + " vertices\n";
  append_list(out, "star vectors", b.star_vectors.size(), max_items,
              [&](std::size_t i) { return vector_text(b.star_vectors[i]); });
  append_list(out, "separators (pair of nodes, direction)", b.separators.size(), max_items,
              [&](std::size_t i) {
                return "pair " + std::to_string(b.separators[i].index) + ", " +
                       vector_text(b.separators[i].direction);
              });
  append_list(out, "codes of leaf pairs", b.codes.size(), max_items,
              [&](std::size_t i) { return pair_code_text(b.codes[i]); });
  append_list(out, "nesting rays", b.nesting.size(), max_items,
              [&](std::size_t i) { return axis_text(b.nesting[i]); });
  return out;
}

// 0x... ; naturals may have thousands of bits.
std::string natural_text(const Natural& n) {
  static const char* const kHex = "0123456789abcdef";
  std::string out = "0x";
  for (std::size_t i = n.size(); i-- > 0;) {
    out += kHex[n[i] >> 4];
    out += kHex[n[i] & 15];
  }
  return n.empty() ? "0" : out;
}

std::string witness_text(const Witness& w) {
  const std::string a = std::to_string(w.first), b = std::to_string(w.second);
  switch (w.rule) {
    case 1: return "M1: face " + a + " is degenerate";
    case 2: return "M2: faces " + a + " and " + b + " have the same vertices";
    case 3: return "M3: edge " + a + "-" + b + " has one face";
    case 4: return "M4: edge " + a + "-" + b + " has more than two faces";
    case 5: return "M5: both faces of edge " + a + "-" + b + " run from " + a + " to " + b;
    case 6: return "M6: the faces at vertex " + a + " form more than one fan";
    case 7: {
      std::string text = "M7: faces " + a + " and " + b + " meet in the point with weights";
      for (const Natural& n : w.weights) text += " " + natural_text(n);
      return text;
    }
    default:
      return "M" + std::to_string(w.rule) + ": just outside face " + a +
             " the winding number is not 0 (ray along " + std::string(1, "xyz"[w.axis % 3]) + ")";
  }
}

}  // namespace

std::string explain(const ValidBody& body, std::string_view, std::size_t max_items) {
  return counts_text(body, kValidClaim) + proof_text(body, max_items);
}

std::string explain(const ReversedBody& body, std::string_view, std::size_t max_items) {
  std::vector<std::size_t> reversed;
  for (std::size_t f = 0; f < 8 * body.reversed.size(); ++f)
    if ((body.reversed[f / 8] >> (f % 8) & 1) != 0) reversed.push_back(f);
  std::string out = counts_text(body.solid, kReversedClaim);
  append_list(out, "reversed triangles", reversed.size(), max_items,
              [&](std::size_t i) { return std::to_string(reversed[i]); });
  return out + proof_text(body.solid, max_items);
}

std::string explain(const InvalidBody& body, std::string_view, std::size_t max_items) {
  std::string out;
  append_list(out, "witnesses", body.witnesses.size(), max_items,
              [&](std::size_t i) { return witness_text(body.witnesses[i]); });
  return out;
}

std::string explain(const Certificate& c, std::size_t max_items) {
  std::string out = statement_text(c.statement) + "\n";
  if (c.valid) out += explain(*c.valid, kValidClaim, max_items);
  if (c.invalid) out += explain(*c.invalid, kInvalidClaim, max_items);
  if (c.reversed) out += explain(*c.reversed, kReversedClaim, max_items);
  return out;
}

}  // namespace veritope::certificate
