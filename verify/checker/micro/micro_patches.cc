// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_patches.h"

namespace {

const int kMostLevelOfPatch = 60, kMostLevelNear = 24;
// Numbers of the nodes that are kept for the next question, and of those of one question.
const size_t kMostNumbersOfAll = 1 << 24, kMostNumbersOfOne = 1 << 26;
const uint64_t kMostPairsOfOne = 1 << 30;  // of one question

double extent_of(const DoubleBox& b) {
  return std::max(b.hi[0] - b.lo[0], std::max(b.hi[1] - b.lo[1], b.hi[2] - b.lo[2]));
}
double largest_of(const double* a) {
  return std::max(std::abs(a[0]), std::max(std::abs(a[1]), std::abs(a[2])));
}

struct Values {
  double least, most;
};
// Bounds of d.(q - base) for the points q, where each number of d is known up to `of_d`. With r for the largest
// coordinate of a difference, which may be wrong by the points' error e and 2^-51 r, and D for the largest of d, a
// computed value differs by less than 3 (D (e + 2^-51 r) + of_d (r + e)) + 2^-48 D r from the exact one.
Values values_of(const PointHull& hull, const double* base, const double* d, double of_d) {
  Values v = {0, 0};
  double r = 0;
  for (size_t i = 0; i < hull.p.size(); i += 3) {
    double to[3];
    for (size_t k = 0; k < 3; ++k) to[k] = hull.p[i + k] - base[k];
    const double value = d[0] * to[0] + d[1] * to[1] + d[2] * to[2];
    v.least = i == 0 ? value : std::min(v.least, value);
    v.most = i == 0 ? value : std::max(v.most, value);
    r = std::max(r, largest_of(to));
  }
  const double size = largest_of(d), e = hull.error;
  const double more = 4 * (size * e + of_d * (r + e)) + std::ldexp(size * (r + e), -45) + kTiny;
  return Values{v.least - more, v.most + more};
}

double square_distance(const double* p, const DoubleBox& b) {  // rounded; only saves work
  double r = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double x = std::max(0.0, std::max(b.lo[k] - p[k], p[k] - b.hi[k]));
    r += x * x;
  }
  return r;
}
// Whether no point of the one is known to be farther than `most` from any of the other.
bool are_near(const PointHull& a, const PointHull& b, double most) {
  const double e = a.error + b.error;
  for (size_t i = 0; i < a.p.size(); i += 3)
    for (size_t j = 0; j < b.p.size(); j += 3) {
      double square = 0;
      for (size_t k = 0; k < 3; ++k) {
        const double x = std::abs(a.p[i + k] - b.p[j + k]) * (1 + std::ldexp(1.0, -49)) + e;
        square += x * x;
      }
      const double r = std::sqrt(square);
      if (!(r + std::ldexp(r, -45) + 1e-140 <= most)) return false;
    }
  return true;
}

}  // namespace

SplinePatches::SplinePatches(const std::vector<Grid>& grids, const std::vector<bool>& is_rational,
                             int64_t unit)
    : patches_(grids.size()) {
  std::vector<DoubleBox> boxes;
  for (size_t g = 0; g < grids.size(); ++g) {
    const std::vector<Big>& from = grids[g].net;
    DoubleNet net;
    net.stride = is_rational[g] ? 4 : 3;
    net.n[0] = size_t(grids[g].shape.p) + 1, net.n[1] = size_t(grids[g].shape.q) + 1;
    int64_t bits = 0;  // of the longest weight
    for (size_t c = 3; c < from.size(); c += 4) bits = std::max(bits, from[c].bits());
    const Big one = shifted(Big(1), bits);
    for (size_t c = 0; c < from.size(); c += 4)
      for (size_t k = 0; k < net.stride; ++k) {
        const Big& of = is_rational[g] ? one : from[c + 3];
        const bool is_scaled = k < 3 && unit != 0;
        net.add(span_of(is_scaled && unit > 0 ? shifted(from[c + k], unit) : from[c + k],
                        is_scaled && unit < 0 ? shifted(of, -unit) : of));
      }
    nodes_.push_back(make(std::move(net), 0));
    boxes.push_back(nodes_.back().hull.box);
  }
  tree_.reset(new BoxTree(boxes));
}

// The points at the corners, and so the two vectors, are wrong by the hull's error e; a difference of two numbers that
// are at most S apart by 2^-51 S more. So each number of the two, at most 2 S, is wrong by less than 4 e + 2^-48 S =
// f, and one of their cross product by less than 2 (2 S f + 2 S f + f f) + 2^-46 S^2.
SplinePatches::Node SplinePatches::make(DoubleNet net, int level) const {
  Node r;
  r.net = std::move(net), r.level = level, r.child = 0;
  set_hull(r.net, &r.hull);
  if (!r.hull.is_known) {
    const double far = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < 3; ++k) r.hull.box.lo[k] = -far, r.hull.box.hi[k] = far;
    return r;
  }
  const size_t row = 3 * r.net.n[1], last = r.hull.p.size() - 3;
  const double *const a = &r.hull.p[0], *const b = &r.hull.p[last + 3 - row],
                      *const c = &r.hull.p[row - 3], *const d = &r.hull.p[last];
  double s[3], t[3], size = 0;
  for (size_t k = 0; k < 3; ++k) {
    s[k] = (b[k] - a[k]) + (d[k] - c[k]);
    t[k] = (c[k] - a[k]) + (d[k] - b[k]);
    for (double x : {b[k] - a[k], d[k] - c[k], c[k] - a[k], d[k] - b[k]})
      size = std::max(size, std::abs(x));
  }
  for (size_t k = 0; k < 3; ++k)
    r.n[k] = s[(k + 1) % 3] * t[(k + 2) % 3] - s[(k + 2) % 3] * t[(k + 1) % 3];
  const double f = 4 * r.hull.error + std::ldexp(size, -48);
  r.error = 2 * (4 * size * f + f * f) + std::ldexp(size * size, -45) + kTiny;
  const Values v = values_of(r.hull, a, r.n, r.error);
  r.least = v.least, r.most = v.most;
  return r;
}

uint32_t SplinePatches::children(uint32_t i) {
  if (nodes_[i].child == 0) {
    const int level = nodes_[i].level;
    DoubleNet half[2];
    halve_net(nodes_[i].net, size_t(level % 2), &half[0], &half[1]);
    nodes_[i].child = uint32_t(nodes_.size());
    for (DoubleNet& net : half) {
      nodes_.push_back(make(std::move(net), level + 1));
      numbers_ += nodes_.back().net.v.size() + nodes_.back().hull.p.size() + 40;
    }
  }
  return nodes_[i].child;
}
void SplinePatches::tidy() {
  if (numbers_ <= kMostNumbersOfAll) return;
  nodes_.erase(nodes_.begin() + long(patches_), nodes_.end());
  for (Node& n : nodes_) n.child = 0;
  numbers_ = 0;
}
std::vector<uint32_t> SplinePatches::roots_near(const DoubleBox& box) const {
  std::vector<uint32_t> r;
  tree_->each(box, [&](uint32_t i) {
    r.push_back(i);
    return true;
  });
  return r;
}

// Nodes of patches are halved as long as they are larger than half of the points' box.
bool SplinePatches::misses(const PointHull& hull, uint64_t* pairs) {
  if (!hull.is_known) return false;
  tidy();
  const double least = extent_of(hull.box) / 2;
  const uint64_t before = *pairs;
  std::vector<uint32_t> open = roots_near(hull.box);
  while (!open.empty()) {
    const uint32_t i = open.back();
    open.pop_back();
    const Node& node = nodes_[i];
    if (!node.hull.box.meets(hull.box)) continue;
    ++*pairs;
    if (!node.hull.is_known) return false;  // its halves would hardly be
    const Values v = values_of(hull, &node.hull.p[0], node.n, node.error);
    if (v.most < node.least || node.most < v.least) continue;
    if (node.level == kMostLevelOfPatch || !(extent_of(node.hull.box) > least) ||
        *pairs - before > kMostPairsOfOne || numbers_ > kMostNumbersOfOne)
      return false;
    const uint32_t child = children(i);
    open.push_back(child), open.push_back(child + 1);
  }
  return true;
}

bool SplinePatches::is_near(const PointHull& hull, double most, uint64_t* pairs) {
  if (!hull.is_known) return false;
  tidy();
  DoubleBox grown = hull.box;
  double middle[3];
  for (size_t k = 0; k < 3; ++k) {
    middle[k] = hull.box.lo[k] / 2 + hull.box.hi[k] / 2;
    grown.lo[k] -= most, grown.hi[k] += most;
  }
  const uint64_t before = *pairs;
  // A point that is within this distance of all lies within it of both ends of their box.
  if (extent_of(hull.box) > 2.000001 * most) return false;
  std::vector<uint32_t> open = roots_near(grown);
  while (!open.empty()) {
    const uint32_t i = open.back();
    open.pop_back();
    const Node& node = nodes_[i];
    double farthest = 0;
    for (size_t p = 0; p < hull.p.size(); p += 3)
      farthest = std::max(farthest, square_distance(&hull.p[p], node.hull.box));
    if (farthest > most * most * 1.000001) continue;
    ++*pairs;
    if (node.hull.is_known && are_near(hull, node.hull, most)) return true;
    if (*pairs - before > kMostPairsOfOne || numbers_ > kMostNumbersOfOne) return false;
    if (node.level == kMostLevelNear) continue;
    const uint32_t child = children(i);  // the nearer one is visited first
    const bool is_first = square_distance(middle, nodes_[child].hull.box) <
                          square_distance(middle, nodes_[child + 1].hull.box);
    open.push_back(is_first ? child + 1 : child);
    open.push_back(is_first ? child : child + 1);
  }
  return false;
}
