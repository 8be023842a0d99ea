// SPDX-License-Identifier: Apache-2.0 OR MIT
// mfem_topology.cc: docs/certificates/reading-rule-mfem.md, section 4: corners, edges and faces of patches, and the
// numbers of control points.
#include "mfem_topology.h"

#include <array>

namespace {

typedef std::array<uint64_t, 4> Quad;  // vertices of a face
// The faces of a volume, as corners, in the page's order.
const int kFaces[6][4] = {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5},
                          {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};

struct Ends {  // for each axis 0 for its begin, 1 for its end
  int of[3];
  int corner() const { return 4 * of[2] + (of[1] == 1 ? 3 - of[0] : of[0]); }
  Ends with(size_t axis, int end) const {
    Ends r = *this;
    r.of[axis] = end;
    return r;
  }
};

struct Edges {  // the list, by their vertices
  struct Key {
    uint64_t low, high, edge;
    bool operator<(const Key& b) const { return low != b.low ? low < b.low : high < b.high; }
  };
  std::vector<Key> keys;

  explicit Edges(const std::vector<MfemEdge>& edges) {
    for (size_t i = 0; i < edges.size(); ++i)
      keys.push_back(
          Key{std::min(edges[i].from, edges[i].to), std::max(edges[i].from, edges[i].to), i});
    std::sort(keys.begin(), keys.end());
    for (size_t i = 1; i < keys.size(); ++i)
      expect(keys[i - 1] < keys[i], "two edges of the list have the same vertices");
  }
  uint64_t between(uint64_t a, uint64_t b) const {
    const Key key = {std::min(a, b), std::max(a, b), 0};
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    expect(at != keys.end() && !(key < *at), "an edge of a patch is not in the list of edges");
    return at->edge;
  }
};

struct Face {
  Quad vertices;          // a, b, c, d where it occurs first
  uint64_t first, along;  // the number of its first control point; how many there are along ab
};

class Numbering {
 public:
  Numbering(const MfemTopology& topology, const std::vector<MfemKnots>& knots, uint64_t most)
      : t_(topology),
        knots_(knots),
        most_(most),
        edges_(topology.edges),
        total_(topology.vertices) {}

  MfemNumbering result() {
    for (const MfemEdge& e : t_.edges) {
      expect(e.knots < knots_.size(), "an edge names a knot vector that does not exist");
      expect(std::max(e.from, e.to) < t_.vertices, "an edge names a vertex that does not exist");
      first_of_edge_.push_back(take(knots_[e.knots].points - 2));
    }
    MfemNumbering r;
    uint64_t points = 0;  // of all patches, shared ones counted each time
    for (size_t i = 0; i < t_.patches(); ++i) {
      r.patches.push_back(axes_of(corners(i)));
      uint64_t n = 1;
      for (size_t a = 0; a < t_.axes; ++a) n = product(n, size(r.patches[i], a));
      points += n;
      expect(points <= most_, "the patches have more control points than the file can hold");
      for (size_t f = 0; t_.axes == 3 && f < 6; ++f) add_face(corners(i), r.patches[i], kFaces[f]);
    }
    for (size_t i = 0; i < t_.patches(); ++i) {
      uint64_t within = 1;
      for (size_t a = 0; a < t_.axes; ++a) within *= size(r.patches[i], a) - 2;  // below n above
      number(corners(i), take(within), &r.patches[i]);
    }
    r.points = total_;
    return r;
  }

 private:
  const uint64_t* corners(size_t patch) const { return &t_.corners[patch << t_.axes]; }
  uint64_t size(const MfemPatch& p, size_t axis) const { return knots_[p.knots[axis]].points; }
  uint64_t product(uint64_t a, uint64_t b) const {
    expect(a <= most_ / b, "a patch has more control points than the file can hold");
    return a * b;
  }
  uint64_t take(uint64_t n) {  // so many numbers; the result is the first
    expect(n <= most_ - total_, "the mesh has more control points than the file can hold");
    total_ += n;
    return total_ - n;
  }

  MfemPatch axes_of(const uint64_t* v) const {
    std::vector<uint64_t> sorted(v, v + (size_t(1) << t_.axes));
    std::sort(sorted.begin(), sorted.end());
    expect(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
           "a patch has a vertex twice");
    MfemPatch r = MfemPatch();
    for (size_t a = 0; a < t_.axes; ++a)
      for (int side = 0; side < (t_.axes == 2 ? 2 : 4); ++side) {  // the ends of the other axes
        Ends begin = {{0, 0, 0}};
        begin.of[a == 0 ? 1 : 0] = side % 2;
        begin.of[a == 2 ? 1 : 2] = side / 2;
        const uint64_t from = v[begin.corner()];
        const MfemEdge& e = t_.edges[edges_.between(from, v[begin.with(a, 1).corner()])];
        const bool is_reversed = e.from != from;
        if (side == 0) r.knots[a] = e.knots, r.is_reversed[a] = is_reversed;
        expect(e.knots == r.knots[a],
               "the edges of an axis of a patch have different knot vectors");
        expect(is_reversed == r.is_reversed[a] || knots_[e.knots].is_symmetric,
               "the edges of an axis of a patch give it different knots");
      }
    return r;
  }

  void add_face(const uint64_t* v, const MfemPatch& p, const int* corner) {
    Face face;
    for (int i = 0; i < 4; ++i) face.vertices[i] = v[corner[i]];
    const auto known = faces_.find(sorted(face.vertices));
    if (known != faces_.end())
      return expect(is_turned(known->second.vertices, face.vertices),
                    "two faces have the same vertices in another order");
    uint64_t inner[2];  // along ab and bc
    for (int i = 0; i < 2; ++i) inner[i] = size(p, axis_between(corner[i], corner[i + 1])) - 2;
    face.along = inner[0];
    face.first = take(inner[0] * inner[1]);  // below the number of the patch's points
    faces_[sorted(face.vertices)] = face;
  }
  static size_t axis_between(int corner, int next) {
    for (size_t a = 0; a < 2; ++a)
      for (int side = 0; side < 4; ++side) {
        Ends ends = {{0, 0, 0}};
        ends.of[1 - a] = side % 2;
        ends.of[2] = side / 2;
        const int begin = ends.corner(), end = ends.with(a, 1).corner();
        if ((begin == corner && end == next) || (begin == next && end == corner)) return a;
      }
    return 2;
  }
  static Quad sorted(Quad q) {
    std::sort(q.begin(), q.end());
    return q;
  }
  static bool is_turned(Quad a, const Quad& b) {
    for (int i = 0; i < 8; ++i) {
      if (a == b) return true;
      std::rotate(a.begin(), a.begin() + 1, a.end());
      if (i == 3) std::reverse(a.begin(), a.end());
    }
    return false;
  }

  void number(const uint64_t* v, uint64_t inside, MfemPatch* p) const {
    uint64_t n[3] = {1, 1, 1}, at[3];
    for (size_t a = 0; a < t_.axes; ++a) n[a] = size(*p, a);
    for (at[0] = 0; at[0] < n[0]; ++at[0])
      for (at[1] = 0; at[1] < n[1]; ++at[1])
        for (at[2] = 0; at[2] < n[2]; ++at[2]) p->points.push_back(number(v, n, at, inside));
  }
  // The number of the control point at these positions along the axes of a patch of this size.
  uint64_t number(const uint64_t* v, const uint64_t* n, const uint64_t* at, uint64_t inside) const {
    Ends ends = {{0, 0, 0}};
    size_t within[3], count = 0;  // the axes between whose ends it lies
    for (size_t a = 0; a < t_.axes; ++a) {
      if (at[a] > 0 && at[a] + 1 < n[a])
        within[count++] = a;
      else
        ends.of[a] = at[a] > 0;
    }
    if (count == 0) return v[ends.corner()];
    if (count == t_.axes)
      return inside + at[0] - 1 +
             (n[0] - 2) * (at[1] - 1 + (t_.axes == 3 ? (n[1] - 2) * (at[2] - 1) : 0));
    const size_t a = within[0];
    if (count == 1) {
      const uint64_t from = v[ends.corner()], to = v[ends.with(a, 1).corner()];
      return first_of_edge_[edges_.between(from, to)] + (from < to ? at[a] - 1 : n[a] - 2 - at[a]);
    }
    return in_face(v, n, at, ends, a, within[1]);
  }
  // The number of a control point within the face in which the axes s and t run.
  uint64_t in_face(const uint64_t* v, const uint64_t* n, const uint64_t* at, const Ends& ends,
                   size_t s, size_t t) const {
    const auto vertex = [&](int i, int j) { return v[ends.with(s, i).with(t, j).corner()]; };
    const Face& face =
        faces_.at(sorted(Quad{{vertex(0, 0), vertex(1, 0), vertex(0, 1), vertex(1, 1)}}));
    int i = 0, j = 0;  // the ends of s and t where the vertex a of the face lies
    while (vertex(i, j) != face.vertices[0]) j += i, i = 1 - i;
    const bool s_is_ab = vertex(1 - i, j) == face.vertices[1];
    const uint64_t from_a[2] = {i == 0 ? at[s] - 1 : n[s] - 2 - at[s],
                                j == 0 ? at[t] - 1 : n[t] - 2 - at[t]};
    return face.first + from_a[s_is_ab ? 0 : 1] + face.along * from_a[s_is_ab ? 1 : 0];
  }

  const MfemTopology& t_;
  const std::vector<MfemKnots>& knots_;
  const uint64_t most_;
  const Edges edges_;
  uint64_t total_;  // numbers that are taken
  std::vector<uint64_t> first_of_edge_;
  std::map<Quad, Face> faces_;
};

}  // namespace

MfemNumbering number_points(const MfemTopology& topology, const std::vector<MfemKnots>& knots,
                            uint64_t most) {
  return Numbering(topology, knots, most).result();
}
