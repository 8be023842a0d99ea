// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_mesh.cc: mesh boxes, section 5 of docs/certificates/star-box.md and star-box-2.md, by
// separating axes: two disjoint convex polygons, segments or boxes have disjoint projections to a normal
// of one of their faces, to a product of directions of their edges, or, in a plane, to a normal of an edge.
#include "star_box.h"
#include "star_poly.h"

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

typedef std::vector<Vec> MappedPoints;
// Whether the values of d on P all lie below, or all above, those on Q.
bool separates(const Vec& d, const MappedPoints& p, const MappedPoints& q) {
  Big lo[2], hi[2];
  for (int s = 0; s < 2; ++s) {
    const MappedPoints& set = s == 0 ? p : q;
    for (size_t i = 0; i < set.size(); ++i) {
      const Big v = dot(d, set[i]);
      if (i == 0 || v < lo[s]) lo[s] = v;
      if (i == 0 || hi[s] < v) hi[s] = v;
    }
  }
  return hi[0] < lo[1] || hi[1] < lo[0];
}

struct Triangle {
  MappedPoints v;  // times w
  Vec e[3], n;
  Triangle(const MappedPoints& corners) : v(corners), n(cross(v[1] - v[0], v[2] - v[0])) {
    for (size_t i = 0; i < 3; ++i) e[i] = v[(i + 1) % 3] - v[i];
  }
  // Whether q is disjoint from the plane polygon or segment with these edges and, if it is a
  // triangle, the normal m.
  bool is_apart(const MappedPoints& q, const std::vector<Vec>& edges, const Vec* m) const {
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
Vec corner(const Patch& p,
           int i) {  // times its weight, which all points of a polynomial patch share
  const int side = p.shape.is_triangle ? (i + 2) % 3 : i;  // the one that starts there
  Vec r;
  for (size_t k = 0; k < 3; ++k) r.x[k] = p.net[4 * size_t(p.shape.on_side(side, 0)) + k];
  return r;
}
MappedPoints corners(const Facet& f) {
  return {corner(*f.patch, f.corner[0]), corner(*f.patch, f.corner[1]),
          corner(*f.patch, f.corner[2])};
}

bool meet_properly(const Facet& a, const Facet& b) {
  MappedPoints p = corners(a), q = corners(b);
  for (size_t i = 0; i < 3; ++i) p[i] = p[i] * b.patch->net[3], q[i] = q[i] * a.patch->net[3];
  const Triangle t(p), u(q);
  int common = 0, edges = 0;
  size_t at[2] = {0, 0};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) {
      if (a.patch->vertex[a.corner[i]] == b.patch->vertex[b.corner[j]])
        ++common, at[0] = i, at[1] = j;
      if (a.edge[i] == b.edge[j]) ++edges;
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

std::vector<Facet> facets_of(const Patch& p) {
  if (p.shape.is_triangle) return {Facet{&p, {0, 1, 2}, {p.pair[0], p.pair[1], p.pair[2]}}};
  const uint64_t diagonal =
      uint64_t(1) << 63 | p.first_root;  // no pair has this number, nor another patch
  return {Facet{&p, {0, 1, 2}, {p.pair[0], p.pair[1], diagonal}},
          Facet{&p, {0, 2, 3}, {diagonal, p.pair[2], p.pair[3]}}};
}

bool misses(const Facet& facet, const Frame& frame, const Box& b) {
  MappedPoints mapped = corners(facet);
  for (Vec& v : mapped) {
    const Vec plain = v;
    for (int row = 0; row < 3; ++row) {
      v.x[row] = Big();
      for (int k = 0; k < 3; ++k) v.x[row] = v.x[row] + Big(frame.a[row][k]) * plain.x[k];
    }
  }
  const Triangle t(mapped);
  const Big& w = facet.patch->net[3];
  MappedPoints q;
  for (int i = 0; i < 8; ++i) {
    Vec v;
    for (int k = 0; k < 3; ++k)
      v.x[k] = w * shifted(Big((i >> k & 1) != 0 ? b.hi[k] : b.lo[k]), b.shift);
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

bool meet_properly(const std::vector<Facet>& facets, Units* units) {
  for (const Facet& a : facets)
    if (is_zero(Triangle(corners(a)).n)) return false;
  for (size_t i = 0; i < facets.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const uint64_t bits = uint64_t(facets[i].patch->bits + facets[j].patch->bits);
      units->add(4 + bits * bits / 16384);
      if (!meet_properly(facets[i], facets[j])) return false;
    }
  return true;
}

namespace {

// Each corner is to the left of the line through any two successive others.
bool is_strictly_convex(const MappedPoints& corners, const Vec& normal) {
  for (size_t i = 0, n = corners.size(); i < n; ++i)
    for (size_t j = 2; j < n; ++j) {
      const Vec along = corners[(i + 1) % n] - corners[i], to = corners[(i + j) % n] - corners[i];
      if (dot(cross(along, to), normal).sign() <= 0) return false;
    }
  return true;
}
// No Bernstein coefficient of the normal times n0 is negative, and one is positive.
bool is_turned_to(const Patch& p, const Vec& n0) {
  Poly derivative[2][3];
  for (size_t k = 0; k < 3; ++k) {
    std::vector<Big> x;
    for (size_t i = k; i < p.net.size(); i += 4) x.push_back(p.net[i]);
    for (int axis = 0; axis < 2; ++axis) derivative[axis][k] = polynomial(p.shape, x, axis);
  }
  Poly sum;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    Poly normal = combined(product(derivative[0][i], derivative[1][j]),
                           product(derivative[0][j], derivative[1][i]), -1);
    for (Big& x : normal.c) x = x * n0.x[k];
    sum = k == 0 ? normal : combined(sum, normal, 1);
  }
  bool any = false;
  for (const Big& x : sum.c) {
    if (x.sign() < 0) return false;
    any = any || x.sign() > 0;
  }
  return any;
}

}  // namespace

bool is_flat_patch(const Patch& p) {
  if (p.is_rational) return false;
  MappedPoints at, points;
  for (int i = 0; i < p.shape.sides(); ++i) at.push_back(corner(p, i));
  const Vec n0 = cross(at[1] - at[0], at[2] - at[0]);
  if (!is_strictly_convex(at, n0)) return false;
  for (size_t i = 0; i < p.net.size(); i += 4) {
    points.push_back(at[0]);
    std::copy(&p.net[i], &p.net[i] + 3, points.back().x);
    if (dot(points.back() - at[0], n0).sign() != 0) return false;
  }
  for (int e = 0; e < p.shape.sides(); ++e) {
    const Vec& from = points[size_t(p.shape.on_side(e, 0))];
    const Vec along = points[size_t(p.shape.on_side(e, p.shape.side_degree(e)))] - from;
    for (int k = 0; k <= p.shape.side_degree(e); ++k)
      if (!is_zero(cross(points[size_t(p.shape.on_side(e, k))] - from, along))) return false;
  }
  return is_turned_to(p, n0);
}
