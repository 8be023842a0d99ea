// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "verify/format/patch_certificate_text.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include "verify/format/byte_stream.h"
#include "verify/format/text_parts.h"

namespace veritope::certificate {
namespace {

using internal::append_list;
using internal::ByteReader;

constexpr std::array<std::string_view, 4> kClaims = {"star-box-1", "star-box-turned-1", "collar-1",
                                                     "patch-invalid-1"};
constexpr int kMostLevels = 24;
// Headers that the rest is read with: the one that is meant comes early, behind a few of which the roots of patches are a part.
constexpr std::size_t kMostHeaders = 16;

// The text behind "key":, up to a quotation mark, comma or brace.
std::string_view value_of(std::string_view statement, std::string_view key) {
  const std::size_t at = statement.find("\"" + std::string(key) + "\":");
  if (at == statement.npos) return {};
  statement.remove_prefix(at + key.size() + 3);
  if (statement.starts_with('"')) statement.remove_prefix(1);
  return statement.substr(0, statement.find_first_of("\",}"));
}
std::string_view statement_of(std::span<const unsigned char> bytes) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return all.substr(0, std::min(all.find('\n'), all.size()));
}
std::string number(std::uint64_t n) { return std::to_string(n); }
std::string point_text(const std::array<std::int64_t, 3>& p) {
  return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
         ")";
}
std::array<std::int64_t, 3> point(ByteReader& r) {
  const std::int64_t x = r.zigzag(), y = r.zigzag();
  return {x, y, r.zigzag()};
}

// A surface's breaks along one axis; the number of intervals between them.
std::uint64_t skip_breaks(ByteReader& r) {
  const std::uint32_t n = r.count(2);
  for (std::uint32_t i = 0; i < n && r.ok(); ++i) {
    r.zigzag();
    if (r.varint() != 0) continue;
    for (int part = 0; part < 2; ++part) {
      const std::uint64_t size = r.varint();
      size <= r.left() ? (void)r.raw(size) : r.fail();
    }
  }
  if (n < 2) r.fail();
  return n < 2 ? 0 : n - 1;
}

struct Header {
  std::uint32_t entities = 0, surfaces = 0, reversed = 0;
  std::uint64_t patches = 0;
  ByteReader rest;
};
// The header with as many surfaces as there may be, then a few with fewer; those with another number of patches are left out.
std::vector<Header> headers(ByteReader r, std::uint64_t patches) {
  Header h{0, 0, 0, 0, r};
  h.entities = h.rest.count(1);
  for (std::uint32_t i = 0; i < h.entities; ++i) h.reversed += h.rest.u8() == 1 ? 1 : 0;
  h.patches = h.entities;
  std::vector<Header> all;
  while (h.rest.ok()) {
    if (h.patches == patches) all.push_back(h);
    if (h.surfaces == h.entities) break;
    const std::uint64_t u = skip_breaks(h.rest), v = skip_breaks(h.rest);
    ++h.surfaces;
    if (u == 0 || v > (std::uint64_t{1} << 40) / u) break;
    h.patches += u * v - 1;
  }
  std::reverse(all.begin(), all.end());
  if (all.size() > kMostHeaders) all.erase(all.begin() + kMostHeaders, all.end());
  return all;
}
std::string header_text(std::string_view claim, const Header& h) {
  return "body: " + std::string(claim) + ", " + number(h.entities) + " entities (" +
         number(h.surfaces) + " surfaces, " + number(h.entities - h.surfaces) + " triangles; " +
         number(h.reversed) + " reversed), " + number(h.patches) + " patches\n";
}

struct TreeCounts {
  std::uint64_t nodes = 0, leaves = 0;
  int deepest = 0;
  std::string text(std::string_view what) const {
    return std::string(what) + ": " + number(leaves) + " leaves, " + number(nodes) +
           " nodes, at most " + std::to_string(deepest) + " levels deep\n";
  }
};
// One tree in preorder, from a node of level `root` on; is_leaf(level) reads a symbol.
template <class IsLeaf>
void skip_tree(ByteReader& r, int root, TreeCounts& counts, IsLeaf is_leaf) {
  std::array<int, kMostLevels + 2> open{};
  open[static_cast<std::size_t>(root)] = 1;
  for (int level = root; level >= root && r.ok();) {
    int& left = open[static_cast<std::size_t>(level)];
    if (left == 0) {
      --level;
      continue;
    }
    --left;
    ++counts.nodes;
    counts.deepest = std::max(counts.deepest, level);
    if (is_leaf(level)) {
      ++counts.leaves;
    } else if (level == kMostLevels) {
      r.fail();
    } else {
      open[static_cast<std::size_t>(++level)] = 4;
    }
  }
}

// Points and end of a walk or shore.
std::string rest_of_walk(ByteReader& r) {
  const std::uint32_t n = r.count(4);
  for (std::uint32_t i = 0; i < n && r.ok(); ++i) {
    r.varint();
    point(r);
  }
  const std::string text = number(n) + " points, to ";
  const std::uint8_t end = r.u8();
  if (end < 6) return text + "infinity along " + "+-"[end % 2] + "xyz"[end / 2];
  if (end > 6) r.fail();
  const std::uint64_t box = r.varint();
  return text + (r.u8() == 0 ? "c-" : "c+") + " of box " + number(box);
}

struct StarReader {
  ByteReader r;
  std::string text;
  std::size_t max_items;
  std::vector<std::uint8_t> leaf_levels;

  void read(std::uint64_t patches, bool is_collar) {
    std::uint64_t roots = 0;
    if (patches > r.left() / 3) return r.fail();
    for (std::uint64_t i = 0; i < patches && r.ok(); ++i) {
      const int a = r.u8(), b = r.u8();
      if (a > 12 || b > 12) return r.fail();
      roots += std::uint64_t{1} << (a + b);
    }
    const std::int64_t exponent = r.zigzag();
    text += "unit: 2^" + std::to_string(exponent) + "\n";
    boxes();
    TreeCounts trees;
    for (std::uint64_t i = 0; i < roots && r.ok(); ++i)
      skip_tree(r, 0, trees, [&](int level) {
        const bool is_leaf = r.varint() != 0;
        if (is_leaf) leaf_levels.push_back(static_cast<std::uint8_t>(level));
        return is_leaf;
      });
    text += trees.text("trees of " + number(roots) + " roots");
    list("walks", r.count(7), [&](std::size_t) {
      const std::uint64_t box = r.varint();
      const std::string from = r.u8() == 0 ? "c-" : "c+";
      return "from " + from + " of box " + number(box) + ", " + rest_of_walk(r);
    });
    if (is_collar) collar();
  }
  void boxes() {
    const std::uint32_t n = r.count(8);
    std::uint64_t meshes = 0;
    for (std::uint32_t i = 0; i < n && r.ok(); ++i) {
      const std::uint8_t kind = r.u8();
      if (kind > 1) return r.fail();
      meshes += kind;
      r.varint();
      point(r);
      for (int k = kind == 0 ? 9 : 3; k > 0; --k) r.varint();
    }
    text += "star boxes: " + number(n - meshes) + "\nmesh boxes: " + number(meshes) + "\n";
  }
  void collar() {
    const std::uint64_t shift = r.varint();
    text += "root cube: least corner " + point_text(point(r)) + " units of 2^" + number(shift) +
            " of these, edge 2^20\n";
    const std::uint32_t cells = r.count(2);
    std::array<std::uint64_t, 21> of_level{};
    std::uint64_t code = 0;
    for (std::uint32_t i = 0; i < cells && r.ok(); ++i) {
      code += r.varint();
      const int level = 20 - std::countr_zero(code) / 3;
      if (code == 0 || level < 0) return r.fail();
      ++of_level[static_cast<std::size_t>(level)];
    }
    text += "cells: " + number(cells) + "\n";
    for (std::size_t level = 0; level < of_level.size(); ++level)
      if (of_level[level] != 0)
        text += "  level " + number(level) + ": " + number(of_level[level]) + "\n";
    const std::uint32_t sides = r.count(1);
    list("components of the boundary", sides,
         [&](std::size_t) { return std::string(r.u8() == 1 ? "in d+" : "in d-"); });
    for (std::uint32_t i = 0; i < cells && r.ok(); ++i) r.zigzag();
    text += "collapses: " + number(cells) + "\n";
    TreeCounts leaves;
    for (const std::uint8_t level : leaf_levels)
      skip_tree(r, level, leaves, [&](int) { return r.u8() != 0; });
    text += leaves.text("trees of these " + number(leaf_levels.size()) + " leaves");
    list("shores", sides, [&](std::size_t) { return rest_of_walk(r); });
  }
  // item(i) reads.
  template <class Item>
  void list(const std::string& name, std::uint32_t size, Item item) {
    std::vector<std::string> kept;
    for (std::uint32_t i = 0; i < size && r.ok(); ++i) {
      std::string one = item(i);
      if (i < max_items) kept.push_back(std::move(one));
    }
    if (r.ok()) append_list(text, name, size, max_items, [&](std::size_t i) { return kept[i]; });
  }
};

std::string interval(ByteReader& r) {
  const std::uint64_t k = r.varint(), a = r.varint(), b = r.varint();
  const std::string scale = "/2^" + number(k);
  return "[" + number(a) + scale + ", " + number(b) + scale + "]";
}
void read_finding(StarReader& s) {
  ByteReader& r = s.r;
  const std::uint8_t kind = r.u8();
  if (kind > 1) return r.fail();
  if (kind == 0) {
    s.text += "two parts of the surface that meet:\n";
    for (const char name : {'A', 'B'}) {
      const std::string patch = number(r.varint()), first = interval(r);
      s.text +=
          std::string("  ") + name + ": patch " + patch + ", " + first + " x " + interval(r) + "\n";
    }
    for (int row = 1; row <= 3; ++row)
      s.text += "  Y_" + std::to_string(row) + ": " + point_text(point(r)) + "\n";
    return;
  }
  s.list("arcs that are the same curve", r.count(5), [&](std::size_t) {
    const std::string patch = number(r.varint()), side = number(r.u8());
    return "patch " + patch + ", side " + side + ", " + interval(r);
  });
  const std::uint8_t axis = r.u8();
  const std::uint64_t k = r.varint(), at = r.varint();
  s.text += std::string("monotone along: ") + "xyz"[axis % 3] + "\npoint: " + number(at) + "/2^" +
            number(k) + " of the first one's side\n";
}

}  // namespace

bool is_patch_certificate(std::span<const unsigned char> bytes) {
  const std::string_view claim = value_of(statement_of(bytes), "claim");
  return std::find(kClaims.begin(), kClaims.end(), claim) != kClaims.end();
}

std::optional<std::string> explain_patch_certificate(std::span<const unsigned char> bytes,
                                                     std::size_t max_items, std::string& why) {
  const std::string_view statement = statement_of(bytes), claim = value_of(statement, "claim");
  why = "the claim is none about patches, or there is no line feed";
  if (!is_patch_certificate(bytes) || statement.size() == bytes.size()) return std::nullopt;
  const bool is_invalid = claim == "patch-invalid-1";
  const ByteReader body(bytes.subspan(statement.size() + 1));
  ByteReader r = body;
  const std::span<const unsigned char> magic = r.raw(4);
  const std::string_view wanted = is_invalid ? "VTPI" : "VTSB";
  why = "the body does not begin with " + std::string(wanted);
  if (!r.ok() || !std::equal(magic.begin(), magic.end(), wanted.begin())) return std::nullopt;
  std::uint64_t patches = 0;
  for (const char c : value_of(statement, "patches"))
    if (c >= '0' && c <= '9' && patches < std::uint64_t{1} << 40)
      patches = 10 * patches + static_cast<std::uint64_t>(c - '0');
  why = "the body is not complete";
  for (const Header& h : headers(r, patches)) {
    StarReader s{h.rest, header_text(claim, h), max_items, {}};
    is_invalid ? read_finding(s) : s.read(patches, claim == "collar-1");
    if (s.r.at_end()) return internal::statement_text(std::string(statement)) + "\n" + s.text;
  }
  return std::nullopt;
}

}  // namespace veritope::certificate
