// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_skin.cc: I1 for bridges, and I4 for bridges and sweeps; docs/certificates/micro-inside.md, sections 3 and 6.
#include "micro_inside.h"

namespace {

const int kMostLevelOfBridge = 60, kMostLevelOfEnd = 24, kMostNodesOfEnd = 4096;

// The intervals between these rising numbers that may have a common point with [lo, hi]: first <= i < last.
void find_intervals(const std::vector<Span>& t, double lo, double hi, size_t* first, size_t* last) {
  const size_t not_below = size_t(
      std::lower_bound(t.begin(), t.end(), lo, [](const Span& s, double x) { return s.hi < x; }) -
      t.begin());
  const size_t above = size_t(
      std::upper_bound(t.begin(), t.end(), hi, [](double x, const Span& s) { return x < s.lo; }) -
      t.begin());
  *first = not_below == 0 ? 0 : not_below - 1;
  *last = std::min(above, t.size() - 1);
}
// [lo, hi] and the interval from a to b in the parameters in which this is [0, 1], or more.
Span part_of(double lo, double hi, const Span& a, const Span& b) {
  const double more = std::ldexp(1.0, -47);
  const double long_length = (b.hi - a.lo) * (1 + more), short_length = (b.lo - a.hi) * (1 - more);
  Span r = {0, 1};
  if (lo > a.hi) r.lo = (lo - a.hi) / long_length - more;
  if (short_length > 0) r.hi = (hi - a.lo) / short_length * (1 + more) + more;
  return Span{std::min(1.0, std::max(0.0, r.lo)), std::max(0.0, std::min(1.0, r.hi))};
}

}  // namespace

bool KnotBoxes::each(const DoubleBox& x, uint64_t* count,
                     const std::function<bool(const PointHull&)>& use) {
  size_t first[3], last[3], i[3];
  for (size_t a = 0; a < 3; ++a)
    find_intervals(maps_.unit_knots(volume_, a), x.lo[a], x.hi[a], &first[a], &last[a]);
  PointHull hull;
  for (i[0] = first[0]; i[0] < last[0]; ++i[0])
    for (i[1] = first[1]; i[1] < last[1]; ++i[1])
      for (i[2] = first[2]; i[2] < last[2]; ++i[2]) {
        ++*count;
        DoubleNet net = maps_.net(volume_, i);
        for (size_t a = 0; a < 3; ++a) {
          const std::vector<Span>& t = maps_.unit_knots(volume_, a);
          const Span part = part_of(x.lo[a], x.hi[a], t[i[a]], t[i[a] + 1]);
          restrict_net(&net, a, part.lo, part.hi);
        }
        set_hull(net, &hull);
        if (!use(hull)) return false;
      }
  return true;
}

DoubleNet net_of_bridge(const MicroBridge& b, const Entity& volume, bool is_end_only) {
  DoubleNet r;
  r.n[0] = size_t(b.p) + 1, r.n[1] = size_t(b.q) + 1, r.n[2] = is_end_only ? 1 : 3;
  for (size_t i = is_end_only ? 6 : 0; i < b.net.size(); i += is_end_only ? 9 : 3)
    for (size_t k = 0; k < 3; ++k) {
      const std::vector<Ratio>& t = volume.knots[k];
      const Ratio length = t.back() - t[0];
      const Big n = b.net[i + k] * t[0].d - t[0].n * b.scale;
      r.add(span_of(n * length.d, b.scale * t[0].d * length.n));
    }
  return r;
}

void OffSurface::check_bridges() {
  for (const MicroBridge& b : file_.bridges) {
    KnotBoxes boxes(&parts_.maps(), b.volume);
    std::vector<std::pair<DoubleNet, int>> nodes;  // with their levels
    nodes.push_back(std::make_pair(net_of_bridge(b, file_.cage[b.volume], false), 0));
    while (!nodes.empty()) {
      const std::pair<DoubleNet, int> node = std::move(nodes.back());
      nodes.pop_back();
      uint64_t count = 0;
      const bool is_off = boxes.each(box_of(node.first), &count, [&](const PointHull& hull) {
        return surface_.misses(hull, &pairs_);
      });
      add_nodes(count);
      if (is_off) continue;
      require(node.second < kMostLevelOfBridge, "I1",
              "this bridge may meet the model:", uint64_t(&b - file_.bridges.data()));
      nodes.resize(nodes.size() + 2);
      std::pair<DoubleNet, int>* const halves = &nodes[nodes.size() - 2];
      halve_net(node.first, size_t(node.second % 3), &halves[0].first, &halves[1].first);
      halves[0].second = halves[1].second = node.second + 1;
    }
  }
}

namespace {

class SkinCheck {
 public:
  SkinCheck(const MicroFile& file, Obstacle* surface, const Ratio& skin)
      : surface_(*surface),
        distance_(span_of(skin).lo),
        most_nodes_((uint64_t(1) << 22) +
                    256 * uint64_t(file.bridges.size() + file.sweeps.size())) {}
  // An end with this net. each(net, use, count) calls use(points) for each box Y, until it is false, and counts them.
  template <class Each>
  void check(DoubleNet whole, uint64_t number, const Each& each) {
    std::vector<std::pair<DoubleNet, int>> nodes;  // with their levels
    nodes.push_back(std::make_pair(std::move(whole), 0));
    for (int visited = 1; !nodes.empty(); ++visited) {
      require(visited <= kMostNodesOfEnd, "I4", "too many nodes of the end of bridge or sweep",
              number);
      const std::pair<DoubleNet, int> node = std::move(nodes.back());
      nodes.pop_back();
      const bool is_near = each(
          node.first,
          [&](const PointHull& hull) { return surface_.is_near(hull, distance_, &pairs_); },
          &nodes_);
      require(pairs_ <= kMostPairs && nodes_ <= most_nodes_, "I4",
              "this checker has a limit of nodes of ends, and of their pairs");
      if (is_near) continue;
      require(node.second < kMostLevelOfEnd, "I4",
              "the end may be farther than the skin from the model, of bridge or sweep", number);
      nodes.resize(nodes.size() + 2);
      std::pair<DoubleNet, int>* const halves = &nodes[nodes.size() - 2];
      halve_net(node.first, size_t(node.second % 2), &halves[0].first, &halves[1].first);
      halves[0].second = halves[1].second = node.second + 1;
    }
  }

 private:
  Obstacle& surface_;
  const double distance_;
  const uint64_t most_nodes_;
  uint64_t pairs_ = 0, nodes_ = 0;
};

}  // namespace

void check_skin(TileParts* parts, Obstacle* surface, const Ratio& skin) {
  const MicroFile& file = parts->file();
  SkinCheck check(file, surface, skin);
  typedef std::function<bool(const PointHull&)> Use;
  for (const MicroBridge& b : file.bridges) {
    KnotBoxes boxes(&parts->maps(), b.volume);
    check.check(net_of_bridge(b, file.cage[b.volume], true), uint64_t(&b - file.bridges.data()),
                [&](const DoubleNet& net, const Use& use, uint64_t* count) {
                  return boxes.each(box_of(net), count, use);
                });
  }
  for (const MicroSweep& b : file.sweeps) {
    const uint64_t number = uint64_t(&b - file.sweeps.data());
    const SweepPart part(parts, b, number, "I4");
    PointHull hull;
    check.check(part.cap(), number, [&](const DoubleNet& cap, const Use& use, uint64_t* count) {
      ++*count;
      part.set_points(cap, 1, 1, &hull);
      return use(hull);
    });
  }
}
