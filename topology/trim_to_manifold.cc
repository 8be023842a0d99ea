// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/trim_to_manifold.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

class Trimmer {
 public:
  Trimmer(const TetrahedralComplex& complex, std::span<const std::uint32_t> order,
          std::vector<bool>& kept)
      : complex_(complex), order_(order), kept_(kept), is_waiting_(complex.num_vertices(), true) {
    for (std::uint32_t v = 0; v < complex.num_vertices(); ++v) waiting_.push_back(v);
  }

  std::vector<TrimmedTetrahedron> run() {
    while (!waiting_.empty()) {
      const std::uint32_t v = waiting_.front();
      waiting_.pop_front();
      is_waiting_[v] = false;
      if (is_whole(v)) continue;
      if (!trim_parts(v) && !trim_fans(v)) trim_ring(v);
    }
    return std::move(trimmed_);
  }

 private:
  using Group = std::vector<std::uint32_t>;

  // Each of these removes something, and has the vertices of it looked at again, or returns false.
  bool trim_parts(std::uint32_t v);
  bool trim_fans(std::uint32_t v);
  bool trim_ring(std::uint32_t v);

  bool is_whole(std::uint32_t v) const {
    return std::ranges::all_of(complex_.tetrahedra_at(v),
                               [&](std::uint32_t t) { return kept_[t]; });
  }
  Group kept_at(std::uint32_t v) const;
  bool is_open(std::uint32_t t, std::uint32_t m) const;
  // The tetrahedra of the group, connected through faces that contain all `vertices`.
  std::vector<Group> parts(const Group& group, std::span<const std::uint32_t> vertices) const;
  bool remove_all_but_largest(const std::vector<Group>& groups, TrimReason reason);
  void remove(std::uint32_t t, TrimReason reason);

  const TetrahedralComplex& complex_;
  std::span<const std::uint32_t> order_;
  std::vector<bool>& kept_;
  std::deque<std::uint32_t> waiting_;
  std::vector<bool> is_waiting_;
  std::vector<TrimmedTetrahedron> trimmed_;
};

Trimmer::Group Trimmer::kept_at(std::uint32_t v) const {
  Group out;
  for (const std::uint32_t t : complex_.tetrahedra_at(v))
    if (kept_[t]) out.push_back(t);
  return out;
}

bool Trimmer::is_open(std::uint32_t t, std::uint32_t m) const {
  const auto partner = complex_.partner(4 * t + m);
  return !partner || !kept_[face_tetrahedron(*partner)];
}

std::vector<Trimmer::Group> Trimmer::parts(const Group& group,
                                           std::span<const std::uint32_t> vertices) const {
  DisjointSets<std::uint32_t> sets(group.size());
  for (std::uint32_t i = 0; i < group.size(); ++i)
    for (std::uint32_t m = 0; m < 4; ++m) {
      const std::uint32_t corner = complex_.tetrahedra()[group[i]][m];
      if (std::find(vertices.begin(), vertices.end(), corner) != vertices.end()) continue;
      if (is_open(group[i], m)) continue;
      const std::uint32_t other = face_tetrahedron(*complex_.partner(4 * group[i] + m));
      const auto at = std::lower_bound(group.begin(), group.end(), other) - group.begin();
      sets.join(i, static_cast<std::uint32_t>(at));
    }
  std::map<std::uint32_t, Group> by_root;
  for (std::uint32_t i = 0; i < group.size(); ++i) by_root[sets.find(i)].push_back(group[i]);
  std::vector<Group> out;
  for (auto& [root, part] : by_root) out.push_back(std::move(part));
  std::sort(out.begin(), out.end());
  return out;
}

bool Trimmer::remove_all_but_largest(const std::vector<Group>& groups, TrimReason reason) {
  if (groups.size() < 2) return false;
  const auto largest =
      std::max_element(groups.begin(), groups.end(),
                       [](const Group& a, const Group& b) { return a.size() < b.size(); });
  for (auto group = groups.begin(); group != groups.end(); ++group)
    if (group != largest)
      for (const std::uint32_t t : *group) remove(t, reason);
  return true;
}

void Trimmer::remove(std::uint32_t t, TrimReason reason) {
  kept_[t] = false;
  trimmed_.push_back({t, reason});
  for (const std::uint32_t v : complex_.tetrahedra()[t]) {
    if (is_waiting_[v]) continue;
    is_waiting_[v] = true;
    waiting_.push_back(v);
  }
}

bool Trimmer::trim_parts(std::uint32_t v) {
  const std::array<std::uint32_t, 1> vertices{v};
  return remove_all_but_largest(parts(kept_at(v), vertices), TrimReason::kVertex);
}

bool Trimmer::trim_fans(std::uint32_t v) {
  const Group group = kept_at(v);
  std::vector<std::uint32_t> others;
  for (const std::uint32_t t : group)
    for (const std::uint32_t w : complex_.tetrahedra()[t])
      if (w != v) others.push_back(w);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  for (const std::uint32_t w : others) {
    Group at_edge;
    for (const std::uint32_t t : group) {
      const TetrahedronCorners& c = complex_.tetrahedra()[t];
      if (std::find(c.begin(), c.end(), w) != c.end()) at_edge.push_back(t);
    }
    const std::array<std::uint32_t, 2> vertices{v, w};
    if (remove_all_but_largest(parts(at_edge, vertices), TrimReason::kEdge)) return true;
  }
  return false;
}

// The link is a connected surface now, part of a sphere; one border curve or none is as it should be.
bool Trimmer::trim_ring(std::uint32_t v) {
  const Group group = kept_at(v);
  std::vector<std::array<std::uint32_t, 3>> link;
  for (const std::uint32_t t : group) {
    const TetrahedronCorners& c = complex_.tetrahedra()[t];
    const auto m = static_cast<std::uint32_t>(std::find(c.begin(), c.end(), v) - c.begin());
    link.push_back(complex_.vertices(4 * t + m));
  }
  if (classify_link(link) != LinkKind::kOther) return false;
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t first = kNone;
  for (const std::uint32_t t : group)
    for (std::uint32_t m = 0; m < 4; ++m)
      if (complex_.tetrahedra()[t][m] != v && is_open(t, m) &&
          (first == kNone || order_[t] < order_[first]))
        first = t;
  VT_CHECK(first != kNone, "a link that is no sphere has a border");
  remove(first, TrimReason::kRing);
  return true;
}

}  // namespace

std::vector<TrimmedTetrahedron> trim_to_manifold(const TetrahedralComplex& complex,
                                                 std::span<const std::uint32_t> order,
                                                 std::vector<bool>& kept) {
  return Trimmer(complex, order, kept).run();
}

}  // namespace veritope
