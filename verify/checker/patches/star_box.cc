// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_box.cc: C1 to C4 of docs/certificates/star-box.md in their order, and the claim as a whole.
#include "star_box.h"

#include "patch_claims.h"

namespace {

// Boxes near one another are tested in succession, so that their nodes are still in memory.
std::vector<uint32_t> by_place(const std::vector<Box>& boxes) {
  int64_t lo[3] = {kFarthest, kFarthest, kFarthest}, width = 1;
  for (const Box& b : boxes)
    for (int k = 0; k < 3; ++k) lo[k] = std::min(lo[k], b.lo[k]);
  for (const Box& b : boxes)
    for (int k = 0; k < 3; ++k) width = std::max(width, b.lo[k] - lo[k]);
  const int drop = std::max(0, bit_length(uint64_t(width)) - 20);
  std::vector<std::pair<uint64_t, uint32_t>> codes;
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    uint64_t code = 0;  // Morton's
    for (int bit = 20; bit-- > 0;)
      for (int k = 0; k < 3; ++k) code = 2 * code + ((boxes[i].lo[k] - lo[k]) >> drop >> bit & 1);
    codes.push_back(std::make_pair(code, i));
  }
  std::sort(codes.begin(), codes.end());
  std::vector<uint32_t> order;
  for (const auto& c : codes) order.push_back(c.second);
  return order;
}

bool leads_to(const Box& b, const int64_t* lo, const int64_t* hi) {
  for (int k = 0; k < 3; ++k)
    if (hi[k] < b.lo[k] || lo[k] > b.hi[k]) return false;
  return true;
}

struct Descent {
  Forest& forest;
  Units& units;
  const Box& box;
  uint64_t number;
  std::vector<Piece> pieces;

  void star(const Patch& p, Node* node, Node* parent) {
    units.add(p.cost);
    if (node->hull.misses(box)) return;
    forest.need_g(p, node, parent);
    if (star_test(p, node, box)) return pieces.push_back(Piece{&p, node});
    require(node->level < kLevels, "C2", "S1 fails on a node of level 24, in box", number);
    Node* const child = forest.children(p, node);
    for (int c = 0; c < 4; ++c) star(p, child + c, node);
  }
  bool mesh(const Patch& p, Node* node) {  // false: C4 fails
    units.add(p.cost);
    if (node->hull.misses(box)) return true;
    if (p.is_flat()) {
      if (!triangle_misses(p, *node, box)) pieces.push_back(Piece{&p, node});
      return true;
    }
    if (node->level == kLevels) return false;
    Node* const child = forest.children(p, node);
    for (int c = 0; c < 4; ++c)
      if (!mesh(p, child + c)) return false;
    return true;
  }
};

void check_box(const Box& b, uint64_t number, Forest* forest, Units* units) {
  Descent d = {*forest, *units, b, number, {}};
  bool flat = true;
  units->id = b.is_mesh ? "C4" : "C2";
  forest->descend([&](const int64_t* lo, const int64_t* hi) { return leads_to(b, lo, hi); },
                  [&](const Patch& p, Node* root) {
                    if (!b.is_mesh) d.star(p, root, nullptr);
                    if (b.is_mesh) flat = flat && d.mesh(p, root);
                  });
  if (!b.is_mesh)
    require(crossing_number(d.pieces, b, units) == 1, "C3", "the crossing number is not 1 in box",
            number);
  else
    require(flat && meet_properly(d.pieces, units), "C4", "no proper mesh in box", number);
}
// The least box that fails is named, whatever the order.
void check_boxes(const StarBody& body, Forest* forest, Units* units) {
  uint32_t first = kNoPair;
  Rejected why;
  for (uint32_t i : by_place(body.boxes)) {
    if (i > first) continue;
    try {
      check_box(body.boxes[i], i, forest, units);
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

std::string check_star_boxes(const Statement& s, const std::string& model, const Body& bytes,
                             MoreThanBoxes* more) {
  const bool is_reversed = s.number.count("winding") != 0;
  StarBody body = read_star_body(s, read_spline_model(model, s.text.at("subject_format")), bytes,
                                 [more](StarBytes* b) {
                                   if (more != nullptr) more->read(b);
                                 });
  const Gluing x(&body.patches);
  Units units = {0, 2000 * (body.leaves + body.boxes.size() + 100), "C2"};
  Forest forest(&body, &units);
  check_boxes(body, &forest, &units);
  units.id = "W1";
  const Walks walks = check_walks(body, x.components, &forest, &units);
  require(is_reversed || walks.wrong == ~uint64_t(0), "W2", "w is wrong at the start of walk",
          walks.wrong);
  require(!is_reversed || walks.last != 1, "W2", "w(c-) is 1 on the component of the last walk");
  std::map<std::string, uint64_t> numbers = {{"patches", body.patches.size()},
                                             {"edges", x.edges},
                                             {"vertices", x.vertices},
                                             {"shells", x.components},
                                             {"bodies", is_reversed ? 0 : walks.bodies},
                                             {"genus", x.genus},
                                             {"boxes", body.boxes.size()},
                                             {"flipped", body.num_reversed}};
  require(!is_reversed || body.num_reversed == 0, "W3",
          "flags, by which any solid could be turned:", body.num_reversed);
  if (is_reversed) numbers["winding"] = 2 * magnitude(walks.last) - (walks.last < 0);
  std::string text;
  for (const auto& n : numbers) {
    require(s.number.at(n.first) == n.second, "W3", ("the number of " + n.first + " is").c_str(),
            n.second);
    text += (text.empty() ? "" : ", ") + std::to_string(n.second) + ' ' + n.first;
  }
  return more == nullptr ? text : text + ", " + more->check(s, body, x, &forest, &units);
}
