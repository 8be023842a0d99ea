// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_mesh.cc: mesh boxes, docs/certificates/star-box.md, section 5, by separating axes: two disjoint convex polygons,
// segments or boxes have disjoint projections to a normal of one of their faces, to a product of directions of their
// edges, or, in a plane, to a normal of an edge.
#include "star_box.h"

namespace {

struct Vec {
  Big x[3];
};
Vec operator-(const Vec& a, const Vec& b) {
  Vec r;
  for (int k = 0; k < 3; ++k) r.x[k] = a.x[k] - b.x[k];
  return r;
}
Vec operator*(const Vec& a, const Big& f) {
  Vec r;
  for (int k = 0; k < 3; ++k) r.x[k] = a.x[k] * f;
  return r;
}
Big dot(const Vec& a, const Vec& b) { return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2]; }
Vec cross(const Vec& a, const Vec& b) {
  Vec r;
  for (int k = 0; k < 3; ++k)
    r.x[k] = a.x[(k + 1) % 3] * b.x[(k + 2) % 3] - a.x[(k + 2) % 3] * b.x[(k + 1) % 3];
  return r;
}
bool is_zero(const Vec& a) {
  return a.x[0].sign() == 0 && a.x[1].sign() == 0 && a.x[2].sign() == 0;
}

typedef std::vector<Vec> Points;
// Whether the values of d on P all lie below, or all above, those on Q.
bool separates(const Vec& d, const Points& p, const Points& q) {
  Big lo[2], hi[2];
  for (int s = 0; s < 2; ++s) {
    const Points& set = s == 0 ? p : q;
    for (size_t i = 0; i < set.size(); ++i) {
      const Big v = dot(d, set[i]);
      if (i == 0 || v < lo[s]) lo[s] = v;
      if (i == 0 || hi[s] < v) hi[s] = v;
    }
  }
  return hi[0] < lo[1] || hi[1] < lo[0];
}

struct Triangle {
  Points v;  // times w
  Vec e[3], n;
  Triangle(const Points& corners) : v(corners), n(cross(v[1] - v[0], v[2] - v[0])) {
    for (size_t i = 0; i < 3; ++i) e[i] = v[(i + 1) % 3] - v[i];
  }
  // Whether q is disjoint from the plane polygon or segment with these edges and, if it is a
  // triangle, the normal m.
  bool is_apart(const Points& q, const std::vector<Vec>& edges, const Vec* m) const {
    if (separates(n, v, q) || (m != nullptr && separates(*m, v, q))) return true;
    for (const Vec& f : edges) {
      for (const Vec& g : e)
        if (separates(cross(g, f), v, q)) return true;
      if (separates(cross(m != nullptr ? *m : n, f), v, q)) return true;
    }
    for (const Vec& g : e)
      if (separates(cross(n, g), v, q)) return true;
    return false;
  }
};
Points corners(const Patch& p, const Node& node) {
  Points r(3);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) r[size_t(i)].x[k] = Big::of(node.coordinate(p, i, k), node.net.n);
  return r;
}
Big weight(const Piece& a) { return Big::of(a.node->weight(*a.patch, 0), a.node->net.n); }

bool meet_properly(const Piece& a, const Piece& b) {
  Points p = corners(*a.patch, *a.node), q = corners(*b.patch, *b.node);
  for (size_t i = 0; i < 3; ++i) p[i] = p[i] * weight(b), q[i] = q[i] * weight(a);
  const Triangle t(p), u(q);
  int common = 0, edges = 0;
  size_t at[2] = {0, 0};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) {
      if (a.patch->vertex[i] == b.patch->vertex[j]) ++common, at[0] = i, at[1] = j;
      if (a.patch->pair[i] == b.patch->pair[j]) ++edges;
    }
  if (common == 0) return t.is_apart(q, std::vector<Vec>(u.e, u.e + 3), &u.n);
  if (common == 1) {  // MESH-2: the edge opposite to the vertex of one misses the other
    for (int s = 0; s < 2; ++s) {
      const Triangle &one = s == 0 ? t : u, &other = s == 0 ? u : t;
      const size_t from = (at[s] + 1) % 3;
      if (!other.is_apart({one.v[from], one.v[(from + 1) % 3]}, {one.e[from]}, nullptr))
        return false;
    }
    return true;
  }
  if (common != 2 || edges != 1) return false;
  if (!is_zero(cross(t.n, u.n))) return true;
  // In one plane: if the directions on the common edge are opposite, equal normals mean different
  // sides of the edge.
  return dot(t.n, u.n).sign() == (a.patch->is_reversed == b.patch->is_reversed ? 1 : -1);
}

}  // namespace

bool triangle_misses(const Patch& p, const Node& node, const Box& b) {
  const Triangle t(corners(p, node));
  const Big w = Big::of(node.weight(p, 0), node.net.n);
  Points q;
  for (int i = 0; i < 8; ++i) {
    Vec v;
    for (int k = 0; k < 3; ++k) v.x[k] = w * Big((i >> k & 1) != 0 ? b.hi[k] : b.lo[k]);
    q.push_back(v);
  }
  if (separates(t.n, t.v, q)) return true;
  for (int k = 0; k < 3; ++k) {
    Vec axis;
    axis.x[k] = 1;
    if (separates(axis, t.v, q)) return true;
    for (const Vec& e : t.e)
      if (separates(cross(axis, e), t.v, q)) return true;
  }
  return false;
}

bool meet_properly(const std::vector<Piece>& pieces, Units* units) {
  for (const Piece& a : pieces)
    if (is_zero(Triangle(corners(*a.patch, *a.node)).n)) return false;
  for (size_t i = 0; i < pieces.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      units->add(1);
      if (!meet_properly(pieces[i], pieces[j])) return false;
    }
  return true;
}
