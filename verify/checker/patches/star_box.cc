// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_box.cc: C1 to C4 of docs/certificates/star-box.md and star-box-2.md in their order, and the claims as a whole.
#include "star_box.h"

#include <set>

#include "patch_claims.h"
#include "star_sheet.h"

namespace {

__extension__ typedef __int128 i128;

// Boxes near one another are tested in succession, so that their nodes are still in memory.
std::vector<uint32_t> by_place(const std::vector<Box>& boxes) {
  int64_t lo[3] = {kFarthest, kFarthest, kFarthest}, width = 1;
  for (const Box& b : boxes)
    for (int k = 0; k < 3; ++k) lo[k] = std::min(lo[k], b.place[k]);
  for (const Box& b : boxes)
    for (int k = 0; k < 3; ++k) width = std::max(width, b.place[k] - lo[k]);
  const int drop = std::max(0, bit_length(uint64_t(width)) - 20);
  std::vector<std::pair<uint64_t, uint32_t>> codes;
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    uint64_t code = 0;  // Morton's
    for (int bit = 20; bit-- > 0;)
      for (int k = 0; k < 3; ++k)
        code = 2 * code + ((boxes[i].place[k] - lo[k]) >> drop >> bit & 1);
    codes.push_back(std::make_pair(code, i));
  }
  std::sort(codes.begin(), codes.end());
  std::vector<uint32_t> order;
  for (const auto& c : codes) order.push_back(c.second);
  return order;
}

bool leads_to(const Bounds& b, const int64_t* lo, const int64_t* hi) {
  for (int k = 0; k < 3; ++k)
    if (hi[k] < b.lo[k] || lo[k] > b.hi[k]) return false;
  return true;
}
// Whether A x may be in the box for an x between lo and hi. Where these are cut off, x may be farther away.
bool leads_to(const Bounds& b, const Frame& frame, const int64_t* lo, const int64_t* hi) {
  for (int k = 0; k < 3; ++k)
    if (lo[k] <= -kFarthest || hi[k] >= kFarthest) return true;
  for (int row = 0; row < 3; ++row) {
    i128 least = 0, most = 0;
    for (int k = 0; k < 3; ++k) {
      const int64_t a = frame.a[row][k];
      least += i128(a) * (a > 0 ? lo[k] : hi[k]);
      most += i128(a) * (a > 0 ? hi[k] : lo[k]);
    }
    // most < lo 2^shift or least > hi 2^shift.
    if (most >> b.shift < b.lo[row] || (least - 1) >> b.shift >= b.hi[row]) return false;
  }
  return true;
}

struct BoxDescent {
  Forest& forest;
  Units& units;
  const Box& box;
  const Frame& frame;
  uint64_t number;

  // Visits every root that may meet the box, and some others.
  template <class Visit>
  void each_root(Visit visit) {
    if (box.frame == 0)
      forest.descend([&](const int64_t* lo, const int64_t* hi) { return leads_to(box, lo, hi); },
                     visit);
    else
      forest.descend(
          [&](const int64_t* lo, const int64_t* hi) { return leads_to(box, frame, lo, hi); },
          visit);
  }
  bool misses(const Patch& p, const Node& node) {
    units.add(p.cost_of_hull(node.level));
    if (box.frame == 0) return node.hull.misses(box);
    return !leads_to(box, frame, node.hull.out_lo, node.hull.out_hi) ||
           misses_in(frame, box, p, node);
  }
};

struct StarDescent : BoxDescent {
  SheetTest test;
  std::vector<std::vector<Piece>> pieces;  // for each sheet

  StarDescent(const BoxDescent& d, int version)
      : BoxDescent(d), test(box, version, &units), pieces(box.sheets.size()) {}

  // Visits child c of a node with these signs, or a root.
  void visit(const Patch& p, Node* node, Node* parent, const Signs* of_parent, int c) {
    if (misses(p, *node)) return;
    units.add(p.cost_of_g(node->level));
    forest.need_g(p, node, parent);
    Signs signs = test.begin(p, of_parent, c);
    const int sheet = test.sheet_of(p, node, &signs);
    if (sheet >= 0) return pieces[size_t(sheet)].push_back(Piece{&p, node});
    require(node->level < kLevels, "C2", "S1 fails on a node of level 24, in box", number);
    const Forest::Held held(&forest, test.complete(p, *node, &signs));
    Node* const child = forest.children(p, node);
    for (int i = 0; i < 4; ++i) visit(p, child + i, node, &signs, i);
  }
};

struct MeshDescent : BoxDescent {
  std::vector<Facet> facets;
  std::set<const Patch*> seen;  // flat patches, which may have several roots

  explicit MeshDescent(const BoxDescent& d) : BoxDescent(d) {}

  bool visit(const Patch& p, Node* node) {  // false: C4 fails
    if (misses(p, *node)) return true;
    if (p.is_flat) {
      if (!seen.insert(&p).second) return true;
      for (const Facet& facet : facets_of(p))
        if (!::misses(facet, frame, box)) facets.push_back(facet);
      return true;
    }
    if (node->level == kLevels) return false;
    Node* const child = forest.children(p, node);
    for (int c = 0; c < 4; ++c)
      if (!visit(p, child + c)) return false;
    return true;
  }
};

void check_star_box(const BoxDescent& descent, int version) {
  StarDescent d(descent, version);
  d.units.id = "C2";
  d.each_root([&](const Patch& p, Node* root) { d.visit(p, root, nullptr, nullptr, 0); });
  for (size_t i = 0; i < d.pieces.size(); ++i)
    require(crossing_number(d.pieces[i], d.box.sheets[i], &d.units) == 1, "C3",
            "the crossing number is not 1 in box", d.number);
}
void check_mesh_box(const BoxDescent& descent) {
  MeshDescent d(descent);
  d.units.id = "C4";
  bool flat = true;
  d.each_root([&](const Patch& p, Node* root) { flat = flat && d.visit(p, root); });
  require(flat && meet_properly(d.facets, &d.units), "C4", "no proper mesh in box", d.number);
}
// The least box that fails is named, whatever the order.
void check_boxes(const StarBody& body, Forest* forest, Units* units) {
  uint32_t first = kNoPair;
  Rejected why;
  for (uint32_t i : by_place(body.boxes)) {
    if (i > first) continue;
    try {
      const Box& b = body.boxes[i];
      const BoxDescent descent = {*forest, *units, b, body.frames[b.frame], i};
      if (b.is_mesh) check_mesh_box(descent);
      if (!b.is_mesh) check_star_box(descent, body.version);
    } catch (const Rejected& r) {
      first = i;
      why = r;
    }
    forest->tidy();
  }
  if (first != kNoPair) throw why;
}

}  // namespace

std::string check_star_box(const Statement& s, std::string model, const Body& bytes) {
  return check_star_boxes(s, model, bytes, nullptr);
}

StarCheck::StarCheck(StarBody* whole, uint64_t bytes, bool is_turned)
    : body(*whole), x(&whole->patches), units(Units::of_bytes(bytes)), forest(whole, &units) {
  check_boxes(body, &forest, &units);
  units.id = "W1";
  walks = check_walks(body, x.components, &forest, &units);
  require(is_turned || walks.wrong == ~uint64_t(0), "W2", "w is wrong at the start of walk",
          walks.wrong);
  require(!is_turned || walks.last != 1, "W2", "w(c-) is 1 on the component of the last walk");
}
std::map<std::string, uint64_t> StarCheck::numbers() const {
  return {{"patches", body.patches.size()},
          {"edges", x.edges},
          {"vertices", x.vertices},
          {"shells", x.components},
          {"bodies", walks.bodies},
          {"genus", x.genus},
          {"boxes", body.boxes.size()},
          {"flipped", body.num_reversed}};
}

std::string check_star_boxes(const Statement& s, const std::string& model, const Body& bytes,
                             MoreThanBoxes* more) {
  const bool is_turned = s.number.count("winding") != 0;
  StarBody body = read_star_body(s.claim->magic, read_spline_model(model, s.text.at("subject_format")),
                                 bytes, [more](StarBytes* b) {
                                   if (more != nullptr) more->read(b);
                                 });
  StarCheck check(&body, s.number.at("subject_bytes") + bytes.left(), is_turned);
  std::map<std::string, uint64_t> numbers = check.numbers();
  require(!is_turned || body.num_reversed == 0, "W3",
          "flags, by which any solid could be turned:", body.num_reversed);
  if (is_turned) {
    numbers["bodies"] = 0;
    numbers["winding"] = 2 * magnitude(check.walks.last) - (check.walks.last < 0);
  }
  const std::string text = compared(s, numbers);
  return more == nullptr ? text : text + ", " + more->check(s, body, check.x, &check.forest, &check.units);
}

std::string compared(const Statement& s, const std::map<std::string, uint64_t>& numbers) {
  std::string text;
  for (const auto& n : numbers) {
    require(s.number.at(n.first) == n.second, "W3", ("the number of " + n.first + " is").c_str(),
            n.second);
    text += (text.empty() ? "" : ", ") + std::to_string(n.second) + ' ' + n.first;
  }
  return text;
}
