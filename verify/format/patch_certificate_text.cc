// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_certificate_text_internal.h"

#include <array>
#include <bit>
#include <cstdint>

#include "verify/format/entities_of_body_internal.h"
#include "verify/format/preorder_internal.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::append_list;

std::string number(std::uint64_t n) { return std::to_string(n); }
std::string point_text(const std::array<std::int64_t, 3>& p) {
  return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
         ")";
}

std::string head_text(std::string_view claim, const std::vector<PatchEntity>& entities) {
  std::uint64_t surfaces = 0, others = 0;
  for (const PatchEntity& e : entities) {
    surfaces += e.is_surface ? 1 : 0;
    others += e.is_other ? 1 : 0;
  }
  return "body: " + std::string(claim) + ", " + number(entities.size()) + " entities (" +
         number(surfaces) + " surfaces, " + number(entities.size() - surfaces - others) +
         " triangles; " + (others == 0 ? "" : number(others) + " others; ") +
         number(num_reversed(entities)) + " reversed), " + number(internal::num_patches(entities)) +
         " patches\n";
}

std::string fraction_text(const UnitFraction& t) {
  return number(t.numerator) + "/" + number(t.denominator);
}

struct TreeCounts {
  std::uint64_t nodes = 0, leaves = 0;
  int deepest = 0;
  bool count(int level, bool is_leaf) {
    ++nodes;
    leaves += is_leaf ? 1 : 0;
    deepest = std::max(deepest, level);
    return is_leaf;
  }
  std::string text(const std::string& what) const {
    return what + ": " + number(leaves) + " leaves, " + number(nodes) + " nodes, at most " +
           std::to_string(deepest) + " levels deep\n";
  }
};

std::string end_text(const WalkPath& path) {
  const std::string text = number(path.points.size()) + " points, to ";
  if (path.end < 6) return text + "infinity along " + "+-"[path.end % 2] + "xyz"[path.end / 2];
  return text + (path.ends_outside ? "c+" : "c-") + " of box " + number(path.end_box);
}
std::string walk_text(const StarWalk& walk) {
  return std::string("from ") + (walk.starts_outside ? "c+" : "c-") + " of box " +
         number(walk.box) + ", " + end_text(walk.path);
}

std::string frame_text(const StarFrame& f) {
  return point_text(f.rows[0]) + ", " + point_text(f.rows[1]) + ", " + point_text(f.rows[2]);
}
std::string separator_text(const StarSeparator& q) {
  std::string text =
      "degree " + number(q.degree) + ", t = " + std::to_string(q.shift) + ", coefficients";
  for (const std::int64_t v : q.coefficients) text += " " + std::to_string(v);
  return text;
}
std::string sheets_text(const StarBoxBody& body, std::size_t box) {
  const StarBoxItem& b = body.boxes[box];
  std::string text = "box " + number(box) + ", frame " + number(b.frame) +
                     ", points in units of 2^" + number(b.point_shift) + " of these";
  for (const StarSheet& sheet : b.sheets) {
    text +=
        "\n    c- " + point_text(sheet.inside) + ", c+ " + point_text(sheet.outside) + ", signs ";
    for (const std::uint8_t sign : sheet.signs) text += "0+-?"[std::min<int>(sign, 3)];
  }
  for (const StarSeparator& q : b.separators) text += "\n    separator of " + separator_text(q);
  return text;
}
// What only bodies of version 2 have.
void append_frames_and_sheets(std::string& out, const StarBoxBody& body, std::size_t max_items) {
  append_list(out, "frames", body.frames.size() + 1, max_items, [&](std::size_t i) {
    return i == 0 ? "the unit matrix" : frame_text(body.frames[i - 1]);
  });
  std::uint64_t framed = 0;
  std::vector<std::size_t> several;
  for (std::size_t i = 0; i < body.boxes.size(); ++i) {
    framed += body.boxes[i].frame != 0 ? 1 : 0;
    if (body.boxes[i].sheets.size() > 1) several.push_back(i);
  }
  out += "boxes in other frames than 0: " + number(framed) + "\n";
  append_list(out, "boxes with several sheets", several.size(), max_items,
              [&](std::size_t i) { return sheets_text(body, several[i]); });
}

// The part of the text that star boxes and collars share.
std::string star_text(const StarBoxBody& body, std::string_view claim, std::size_t max_items) {
  std::string out =
      head_text(claim, body.entities) + "unit: 2^" + std::to_string(body.exponent) + "\n";
  std::uint64_t meshes = 0, roots = 0;
  for (const StarBoxItem& b : body.boxes) meshes += b.is_mesh ? 1 : 0;
  out += "star boxes: " + number(body.boxes.size() - meshes) + "\nmesh boxes: " + number(meshes) +
         "\n";
  if (body.version != 1) append_frames_and_sheets(out, body, max_items);
  for (const auto& [a, b] : body.roots) roots += std::uint64_t{1} << (a + b);
  TreeCounts trees;
  std::size_t at = 0;
  while (at < body.trees.size())
    internal::each_node(
        0, [&](int level) { return trees.count(level, body.trees[at++] != kSplit); },
        [&] { return at < body.trees.size(); });
  out += trees.text("trees of " + number(roots) + " roots");
  append_list(out, "walks", body.walks.size(), max_items,
              [&](std::size_t i) { return walk_text(body.walks[i]); });
  return out;
}

std::string cells_text(const std::vector<std::uint64_t>& cells) {
  std::array<std::uint64_t, 21> of_level{};
  for (const std::uint64_t code : cells)
    ++of_level[static_cast<std::size_t>(20 - std::countr_zero(code) / 3)];
  std::string out = "cells: " + number(cells.size()) + "\n";
  for (std::size_t level = 0; level < of_level.size(); ++level)
    if (of_level[level] != 0)
      out += "  level " + number(level) + ": " + number(of_level[level]) + "\n";
  return out;
}

std::string interval_text(const UnitInterval& t) {
  const std::string scale = "/2^" + number(t.bits);
  return "[" + number(t.low) + scale + ", " + number(t.high) + scale + "]";
}

std::string finding_text(const CrossingFinding& crossing, std::size_t) {
  std::string out = "two parts of the surface that meet:\n";
  for (std::size_t i = 0; i < 2; ++i) {
    const RestrictedPatch& sheet = crossing.sheets[i];
    out += std::string("  ") + "AB"[i] + ": patch " + number(sheet.patch) + ", " +
           interval_text(sheet.at[0]) + " x " + interval_text(sheet.at[1]) + "\n";
  }
  for (std::size_t row = 0; row < 3; ++row)
    out += "  Y_" + number(row + 1) + ": " + point_text(crossing.rows[row]) + "\n";
  return out;
}
std::string finding_text(const SideFinding& sides, std::size_t max_items) {
  std::string out;
  append_list(out, "arcs that are the same curve", sides.arcs.size(), max_items,
              [&](std::size_t i) {
                const PatchArc& arc = sides.arcs[i];
                return "patch " + number(arc.patch) + ", side " + number(arc.side) + ", " +
                       interval_text(arc.at);
              });
  return out + "monotone along: " + "xyz"[sides.axis % 3] + "\npoint: " + number(sides.point) +
         "/2^" + number(sides.point_bits) + " of the first one's side\n";
}

}  // namespace

std::string explain(const StarBoxBody& body, std::string_view claim, std::size_t max_items) {
  return star_text(body, claim, max_items);
}

std::string explain(const CollarBody& body, std::string_view claim, std::size_t max_items) {
  std::string out = star_text(body.star, claim, max_items);
  out += "root cube: least corner " + point_text(body.corner) + " units of 2^" +
         number(body.shift) + " of these, edge 2^20\n";
  out += cells_text(body.cells);
  append_list(out, "components of the boundary", body.sides.size(), max_items,
              [&](std::size_t i) { return std::string(body.sides[i] == 1 ? "in d+" : "in d-"); });
  out += "collapses: " + number(body.collapses.size()) + "\n";
  TreeCounts leaves;
  std::size_t at = 0;
  const std::vector<std::uint8_t> levels = internal::leaf_levels(body.star);
  for (const std::uint8_t level : levels)
    internal::each_node(
        level, [&](int l) { return leaves.count(l, body.leaves[at++] != 0); },
        [&] { return at < body.leaves.size(); });
  out += leaves.text("trees of these " + number(levels.size()) + " leaves");
  append_list(out, "shores", body.shores.size(), max_items,
              [&](std::size_t i) { return end_text(body.shores[i]); });
  return out;
}

std::string explain(const PatchInvalidBody& body, std::string_view claim, std::size_t max_items) {
  return head_text(claim, body.entities) +
         std::visit([&](const auto& finding) { return finding_text(finding, max_items); },
                    body.finding);
}

std::string explain(const PatchMeetingBody& body, std::string_view claim, std::size_t) {
  std::string out = head_text(claim, body.entities) + "two points of the surface with one image:\n";
  for (std::size_t i = 0; i < body.places.size(); ++i) {
    const MeetingPlace& place = body.places[i];
    out += std::string("  ") + "AB"[i] + ": patch " + number(place.patch) + ", (" +
           fraction_text(place.at[0]) + ", " + fraction_text(place.at[1]) + ")\n";
  }
  return out;
}

std::string explain(const VolumeFoldedBody& body, std::string_view claim, std::size_t) {
  std::string out = "body: " + std::string(claim) + ", " + number(body.volumes) + " volumes\n" +
                    "the Jacobian determinant of volume " + number(body.entity) + " is\n";
  constexpr std::array<const char*, 2> kSigns = {"positive", "negative"};
  constexpr std::array<const char*, 3> kAxes = {"u", "v", "w"};
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    out += std::string("  ") + kSigns[i] + " at " + "AB"[i] + ":";
    for (std::size_t a = 0; a < kAxes.size(); ++a) {
      const PieceFraction& t = body.points[i][a];
      out += std::string(a == 0 ? " " : ", ") + kAxes[a] + " at " + fraction_text(t.at) +
             " of piece " + number(t.piece);
    }
    out += '\n';
  }
  return out;
}

}  // namespace veritope::certificate
