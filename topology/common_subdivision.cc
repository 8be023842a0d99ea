// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/common_subdivision.h"

#include <algorithm>
#include <string>

#include "topology/radix_sort_internal.h"

namespace veritope {
namespace {

using Point = std::array<std::uint32_t, 3>;
using internal::kNone;

/// A face before its corners have ids.
struct RawFace {
  Point corner;
  std::uint32_t below, above;
  std::uint8_t axis, level;
};

/// Lists every face once. A face between two cells is listed by the coarser one, or of equal ones by the one below it.
class FaceLister {
 public:
  explicit FaceLister(const OctreeKeySet& cells) : cells_(cells) {}

  /// Returns false if there are more than max_faces; stops there.
  bool run(std::uint32_t max_faces) {
    faces_.reserve(4 * cells_.size());
    for (cell_ = 0; cell_ < cells_.size(); ++cell_) {
      for (axis_ = 0; axis_ < 3; ++axis_)
        for (const bool upper : {false, true}) list_side(upper);
      if (faces_.size() > max_faces) return false;
    }
    return true;
  }
  std::vector<RawFace>& faces() { return faces_; }

 private:
  struct Range {
    std::size_t first, last;
    bool empty() const { return first == last; }
  };

  void list_side(bool upper) {
    upper_ = upper;
    const OctreeKey key = cells_[cell_];
    const std::optional<OctreeKey> across = key.neighbour(axis_, upper);
    if (!across) return list(key, kNone);
    const std::size_t first = cells_.lower_bound(across->first_code());
    if (first < cells_.size() && cells_[first] == *across) {
      if (upper) list(key, static_cast<std::uint32_t>(first));
    } else if (first < cells_.size() && across->contains(cells_[first])) {
      if (!split(*across, {first, cells_.lower_bound(across->last_code() + 1)})) list(key, kNone);
    } else if (!has_container(*across, first)) {
      list(key, kNone);
    }
  }

  /// Is `key`, which contains no cell of the set, contained in one? `at` is its lower bound.
  bool has_container(OctreeKey key, std::size_t at) const {
    return (at < cells_.size() && cells_[at].contains(key)) ||
           (at > 0 && cells_[at - 1].contains(key));
  }

  /// Lists the part of the cell's side that lies on `across`, which is of the cell's level or finer and contains the
  /// cells of `range`, if some of these touch it; returns whether. Each node is visited for at most one coarse cell per
  /// side: O(n depth) in all.
  bool split(OctreeKey across, Range range) {
    if (range.empty()) return false;
    if (cells_[range.first] == across)
      return list(across, static_cast<std::uint32_t>(range.first)), true;
    std::array<OctreeKey, 4> quadrant;
    std::array<bool, 4> touched;
    unsigned num = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      if ((octant >> axis_ & 1) == (upper_ ? 1u : 0u)) continue;  // away from the side
      quadrant[num] = across.child(octant);
      touched[num] = split(quadrant[num], part(range, quadrant[num]));
      ++num;
    }
    if (!touched[0] && !touched[1] && !touched[2] && !touched[3]) return false;
    for (unsigned q = 0; q < 4; ++q)
      if (!touched[q]) list(quadrant[q], kNone);
    return true;
  }

  Range part(Range range, OctreeKey key) const {
    const auto begin = cells_.keys().begin(),
               last = begin + static_cast<std::ptrdiff_t>(range.last);
    const auto less = [](OctreeKey a, std::uint64_t code) { return a.code() < code; };
    const auto lo = std::lower_bound(begin + static_cast<std::ptrdiff_t>(range.first), last,
                                     key.first_code(), less);
    const auto hi = std::lower_bound(lo, last, key.last_code() + 1, less);
    return {static_cast<std::size_t>(lo - begin), static_cast<std::size_t>(hi - begin)};
  }

  /// `key` is the cell itself or a node across the side.
  void list(OctreeKey key, std::uint32_t other) {
    const auto own = static_cast<std::uint32_t>(cell_);
    RawFace face{key.corner(), upper_ ? own : other, upper_ ? other : own,
                 static_cast<std::uint8_t>(axis_), static_cast<std::uint8_t>(key.level())};
    const OctreeKey cell = cells_[cell_];
    face.corner[axis_] = cell.corner()[axis_] + (upper_ ? cell.size() : 0);
    faces_.push_back(face);
  }

  const OctreeKeySet& cells_;
  std::vector<RawFace> faces_;
  std::size_t cell_ = 0;
  unsigned axis_ = 0;
  bool upper_ = false;
};

/// ids[r] = the rank of record r's key among the distinct keys, which are returned in order. REQUIRES keys < 2^bits.
std::vector<std::uint64_t> rank(Buffer<internal::KeyedRecord>& records, unsigned bits,
                                std::vector<std::uint32_t>& ids) {
  internal::radix_sort(records, bits);
  std::vector<std::uint64_t> distinct;
  ids.resize(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (distinct.empty() || distinct.back() != records[i].key) distinct.push_back(records[i].key);
    ids[records[i].record] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  return distinct;
}

/// first[i + 1] counts of row i -> first[i] its start. Returns the sum.
std::uint32_t rows_from_counts(std::vector<std::uint32_t>& first) {
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  return first.back();
}

}  // namespace

class SubdivisionBuilder {
 public:
  SubdivisionBuilder(OctreeKeySet cells, std::vector<RawFace> raw) : raw_(std::move(raw)) {
    s_.cells_ = std::move(cells);
    s_.bits_ = s_.cells_.finest_level() + 1;
    s_.up_ = OctreeKey::kMaxLevel - s_.cells_.finest_level();
  }

  CommonSubdivision run() {
    number_vertices();
    order_faces();
    for (unsigned axis = 0; axis < 3; ++axis) link_vertices(axis);
    list_edges();
    list_faces_of_cells();
    return std::move(s_);
  }

 private:
  void number_vertices() {
    Buffer<internal::KeyedRecord> corners(4 * raw_.size());
    for (std::size_t f = 0; f < raw_.size(); ++f)
      for (unsigned q = 0; q < 4; ++q) {
        Point p = raw_[f].corner;
        const std::uint32_t size = OctreeKey::kGrid >> raw_[f].level;
        if (q & 1) p[(raw_[f].axis + 1u) % 3] += size;
        if (q & 2) p[(raw_[f].axis + 2u) % 3] += size;
        std::uint64_t key = 0;
        for (unsigned a = 3; a-- > 0;) key = key << s_.bits_ | p[a] >> s_.up_;
        corners[4 * f + q] = {key, static_cast<std::uint32_t>(4 * f + q)};
      }
    s_.points_ = rank(corners, 3 * s_.bits_, corner_);
  }

  /// No two faces have the same normal and least corner: they would overlap.
  void order_faces() {
    std::vector<std::uint32_t> at(3 * s_.points_.size(), kNone);
    for (std::size_t f = 0; f < raw_.size(); ++f)
      at[3 * std::size_t{corner_[4 * f]} + raw_[f].axis] = static_cast<std::uint32_t>(f);
    std::vector<std::array<std::uint32_t, 4>> corners;
    corners.reserve(raw_.size());
    s_.faces_.reserve(raw_.size());
    for (const std::uint32_t f : at) {
      if (f == kNone) continue;
      const RawFace& raw = raw_[f];
      s_.faces_.push_back({raw.below, raw.above, corner_[4 * std::size_t{f}], raw.axis, raw.level});
      const std::uint32_t* c = corner_.data() + 4 * std::size_t{f};
      corners.push_back({c[0], c[1], c[2], c[3]});
    }
    VT_CHECK(s_.faces_.size() == raw_.size(), "two faces of the common subdivision have one name");
    corners_ = std::move(corners);
    raw_ = {};
    corner_ = {};
  }

  /// next_[3 v + axis] = the next vertex on the line through v, whether or not an edge runs there.
  void link_vertices(unsigned axis) {
    const std::size_t n = s_.points_.size();
    next_.resize(3 * n, kNone);
    // The bits are rotated so that the axis has the lowest ones: points of one line are then adjacent.
    const unsigned all = 3 * s_.bits_, shift = axis * s_.bits_;
    const std::uint64_t mask = (std::uint64_t{1} << all) - 1;
    const auto rotated = [&](std::uint64_t p) {
      return shift == 0 ? p : (p >> shift | p << (all - shift)) & mask;
    };
    Buffer<internal::KeyedRecord> order(n);
    for (std::size_t v = 0; v < n; ++v)
      order[v] = {rotated(s_.points_[v]), static_cast<std::uint32_t>(v)};
    if (axis != 0) internal::radix_sort(order, all);
    for (std::size_t i = 1; i < n; ++i)
      if (order[i].key >> s_.bits_ == order[i - 1].key >> s_.bits_)
        next_[3 * std::size_t{order[i - 1].record} + axis] = order[i].record;
  }

  void list_edges() {
    // First the edges of faces by the slot 3 v + axis of their lower vertex, then by rank of the slots in use.
    std::vector<std::uint32_t> id(next_.size(), 0);
    s_.face_first_.assign(1, 0);
    s_.face_first_.reserve(s_.faces_.size() + 1);
    s_.face_edges_.reserve(4 * s_.faces_.size() + s_.faces_.size() / 4);
    for (std::size_t f = 0; f < s_.faces_.size(); ++f) {
      const unsigned b = (s_.faces_[f].axis + 1u) % 3, c = (s_.faces_[f].axis + 2u) % 3;
      const std::array<std::uint32_t, 4>& corner = corners_[f];
      walk(corner[0], corner[1], b, id);
      walk(corner[0], corner[2], c, id);
      walk(corner[2], corner[3], b, id);
      walk(corner[1], corner[3], c, id);
      s_.face_first_.push_back(static_cast<std::uint32_t>(s_.face_edges_.size()));
    }
    corners_ = {};
    for (std::size_t slot = 0; slot < id.size(); ++slot) {
      if (id[slot] == 0) continue;
      id[slot] = static_cast<std::uint32_t>(s_.edges_.size());
      s_.edges_.push_back({static_cast<std::uint32_t>(slot / 3), next_[slot]});
    }
    for (std::uint32_t& e : s_.face_edges_) e = id[e];
    next_ = {};
  }

  void walk(std::uint32_t from, std::uint32_t to, unsigned axis, std::vector<std::uint32_t>& used) {
    for (std::uint32_t v = from; v != to; v = next_[3 * std::size_t{v} + axis]) {
      const std::uint32_t slot = 3 * v + axis;
      used[slot] = 1;
      s_.face_edges_.push_back(slot);
    }
  }

  void list_faces_of_cells() {
    s_.cell_first_.assign(s_.cells_.size() + 1, 0);
    for (const CommonSubdivision::Face& face : s_.faces_)
      for (const std::uint32_t cell : {face.below, face.above})
        if (cell != kNone) ++s_.cell_first_[cell + 1];
    s_.cell_faces_.resize(rows_from_counts(s_.cell_first_));
    std::vector<std::uint32_t> at(s_.cell_first_.begin(), s_.cell_first_.end() - 1);
    for (std::uint32_t f = 0; f < s_.num_faces(); ++f)
      for (const std::uint32_t cell : {s_.faces_[f].below, s_.faces_[f].above})
        if (cell != kNone) s_.cell_faces_[at[cell]++] = f;
  }

  CommonSubdivision s_;
  std::vector<RawFace> raw_;
  std::vector<std::uint32_t> corner_;  // ids of the corners of raw face f at 4 f
  std::vector<std::array<std::uint32_t, 4>>
      corners_;  // of face f: least, along axis + 1, along axis + 2, greatest
  std::vector<std::uint32_t> next_;
};

Result<CommonSubdivision> CommonSubdivision::build(OctreeKeySet cells, std::uint32_t max_faces) {
  VT_CHECK(max_faces <= kMaxFaces, "ids of 32 bits");
  FaceLister lister(cells);
  if (!lister.run(max_faces))
    return Error{Code::kOverLimit,
                 {},
                 std::to_string(cells.size()) + " octree cells have more than " +
                     std::to_string(max_faces) + " faces"};
  std::vector<RawFace> raw = std::move(lister.faces());
  return SubdivisionBuilder(std::move(cells), std::move(raw)).run();
}

}  // namespace veritope
