// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_walk.cc: walks, docs/certificates/star-box.md, section 6 (and W1), and shores of collars.
#include "star_box.h"

namespace {

__extension__ typedef __int128 i128;
int sign(const Big& x) { return x.sign(); }
int sign(i128 x) { return x < 0 ? -1 : x > 0; }

struct WalkLine {  // from a along d: to a + d, or without an end
  int64_t a[3], d[3];
  bool is_ray;

  // Whether the line meets the closed box of lo / w, hi / w, with a w > 0 for each bound. I = i128:
  // REQUIRES w = 1 and |lo|, |hi| <= kFarthest; then all products are below 2^125.
  template <class I>
  bool meets(const I* lo, const I* lo_w, const I* hi, const I* hi_w) const {
    I least = 0, least_w = 1, most = 1, most_w = 1;  // the parameters that are left
    bool is_open = is_ray;
    for (int k = 0; k < 3; ++k) {
      I p = lo[k] - I(a[k]) * lo_w[k], p_w = lo_w[k], q = hi[k] - I(a[k]) * hi_w[k], q_w = hi_w[k];
      if (d[k] == 0) {
        if (sign(p) > 0 || sign(q) < 0) return false;
        continue;
      }
      if (d[k] < 0) {
        std::swap(p, q), std::swap(p_w, q_w);
        p = I(0) - p, q = I(0) - q;
      }
      const I length = int64_t(magnitude(d[k]));
      p_w = p_w * length, q_w = q_w * length;
      if (sign(p * least_w - least * p_w) > 0) least = p, least_w = p_w;
      if (is_open || sign(q * most_w - most * q_w) < 0) most = q, most_w = q_w, is_open = false;
    }
    return is_open || sign(least * most_w - most * least_w) <= 0;
  }
};

struct WalkDescent {
  const WalkLine line;
  uint64_t walk;
  Forest& forest;
  Units& units;

  bool leads(const int64_t* lo, const int64_t* hi) const {
    const i128 one[3] = {1, 1, 1}, l[3] = {lo[0], lo[1], lo[2]}, h[3] = {hi[0], hi[1], hi[2]};
    return line.meets(l, one, h, one);
  }
  // Whether the line meets the exact hull.
  bool meets(const Patch& p, const Node& node) const {
    if (!leads(node.hull.out_lo, node.hull.out_hi)) return false;
    Big end[2][3], w[2][3];
    for (int i = 0; i < p.shape.count(); ++i) {
      const Big v = Big::of(node.weight(p, i), node.net.n);
      for (int k = 0; k < 3; ++k) {
        const Big x = Big::of(node.coordinate(p, i, k), node.net.n);
        for (int s = 0; s < 2; ++s) {
          const int side = i == 0 ? 1 : compare(x * w[s][k], end[s][k] * v) * (s == 0 ? -1 : 1);
          if (side > 0) end[s][k] = x, w[s][k] = v;
        }
      }
    }
    return line.meets(end[0], w[0], end[1], w[1]);
  }
  void visit(const Patch& p, Node* node) {
    units.add(2 * p.cost_of_hull(node->level));
    if (!meets(p, *node)) return;
    require(node->level < kLevels, units.id, "a node of level 24 is not off the walk", walk);
    Node* const child = forest.children(p, node);
    for (int c = 0; c < 4; ++c) visit(p, child + c);
  }
};

void check_line(const WalkLine& line, uint64_t walk, Forest* forest, Units* units) {
  WalkDescent d = {line, walk, *forest, *units};
  forest->descend([&](const int64_t* lo, const int64_t* hi) { return d.leads(lo, hi); },
                  [&](const Patch& p, Node* root) { d.visit(p, root); });
  forest->tidy();
}

}  // namespace

void check_polyline(const std::vector<int64_t>& points, int end, uint64_t walk, Forest* forest,
                    Units* units) {
  for (size_t at = 0; at < points.size(); at += 3) {
    WalkLine line = {{points[at], points[at + 1], points[at + 2]}, {0, 0, 0}, at + 3 == points.size()};
    if (line.is_ray && end == 6) break;
    for (size_t k = 0; k < 3 && !line.is_ray; ++k) line.d[k] = points[at + 3 + k] - line.a[k];
    if (line.is_ray) line.d[end / 2] = end % 2 == 0 ? 1 : -1;
    check_line(line, walk, forest, units);
  }
}

Walks check_walks(const StarBody& body, uint32_t components, Forest* forest, Units* units) {
  std::vector<bool> seen(components);
  std::vector<int64_t> inside(components);  // w(c-)
  Walks r = {0, 0, ~uint64_t(0)};
  require(body.walks.size() == components, "W1",
          "components and walks differ; components:", components);
  for (uint64_t i = 0; i < body.walks.size(); ++i) {
    const Walk& w = body.walks[i];
    const Box &from = body.boxes[w.box], &to = body.boxes[w.end < 6 ? w.box : w.end_box];
    require(!from.is_mesh && !to.is_mesh, "W1", "a mesh box is at an end of walk", i);
    require(from.sheets.size() == 1 && to.sheets.size() == 1, "W1",
            "a box with several sheets is at an end of walk", i);
    require(!seen[from.component], "W1", "a component has two walks, one is", i);
    require(w.end < 6 || seen[to.component], "W1", "no earlier walk is where this ends:", i);
    seen[from.component] = true;
    check_polyline(w.polyline(from.sheets[0].c[w.sign], body.boxes), w.end, i, forest, units);
    const int64_t at_end = w.end < 6 ? 0 : inside[to.component] - w.end_sign;
    r.last = inside[from.component] = at_end + w.sign;
    if (r.last != 1) r.wrong = std::min(r.wrong, i);
    r.bodies += uint64_t(w.sign);
  }
  return r;
}
