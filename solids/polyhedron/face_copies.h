// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/face_copies.h: faces with the same three vertices as one face with a number, so that what is
// decided about one of them is not decided for every pair of them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace veritope {

/// Groups of faces with the same three vertices. The least face of each stands for it.
class FaceCopies {
 public:
  using Group = std::vector<std::uint32_t>;

  FaceCopies() = default;
  /// REQUIRES disjoint groups of two or more faces, each ascending.
  explicit FaceCopies(std::vector<Group> groups) : groups_(std::move(groups)) {
    std::sort(groups_.begin(), groups_.end());
  }

  std::span<const Group> groups() const { return groups_; }
  /// All faces with the vertices of `face`, ascending; empty if there is no other, or `face` is not the least of them.
  std::span<const std::uint32_t> of(std::uint32_t face) const {
    const auto at = std::lower_bound(groups_.begin(), groups_.end(), face,
                                     [](const Group& g, std::uint32_t f) { return g[0] < f; });
    if (at == groups_.end() || at->front() != face) return {};
    return *at;
  }
  std::uint64_t count(std::uint32_t face) const {
    return std::max<std::uint64_t>(of(face).size(), 1);
  }
  /// The faces, ascending as before, without those that a smaller one of them stands for.
  std::vector<std::uint32_t> without_copies(const std::vector<std::uint32_t>& faces) const {
    Group later;
    for (const Group& g : groups_) later.insert(later.end(), g.begin() + 1, g.end());
    std::sort(later.begin(), later.end());
    Group out;
    std::set_difference(faces.begin(), faces.end(), later.begin(), later.end(),
                        std::back_inserter(out));
    return out;
  }

 private:
  std::vector<Group> groups_;
};

}  // namespace veritope
