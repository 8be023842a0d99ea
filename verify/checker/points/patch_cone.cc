// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "patch_cone.h"

namespace {

// A point of a patch's domain, times its unit: u, v of a tensor patch; the barycentric coordinates of a triangle.
struct DomainPoint {
  const Patch* patch;
  Big unit, at[3];

  bool is_triangle() const { return patch->shape.is_triangle; }
  int corners() const { return patch->shape.sides(); }
  // A tensor patch: sides v = 0, u = 1, v = 1, u = 0.
  bool is_on_side(int e) const {
    if (is_triangle()) return at[e].m.empty();
    const Big& x = at[e % 2 == 0 ? 1 : 0];
    return e == 0 || e == 3 ? x.m.empty() : x == unit;
  }
};

DomainPoint place_in(const Patch& patch, const Ratio* at) {
  DomainPoint r = {&patch, at[0].d * at[1].d, {}};
  const Big first = at[0].n * at[1].d, second = at[1].n * at[0].d;
  if (patch.shape.is_triangle)
    r.at[0] = r.unit - first - second, r.at[1] = first, r.at[2] = second;
  else
    r.at[0] = first, r.at[1] = second;
  return r;
}
// The point of a side where t / unit of it is passed, in the patch's own direction.
DomainPoint place_on_side(const Patch& patch, int e, const Big& t, const Big& unit) {
  DomainPoint r = {&patch, unit, {}};
  if (patch.shape.is_triangle) {
    r.at[(e + 1) % 3] = unit - t;
    r.at[(e + 2) % 3] = t;
  } else {
    r.at[e % 2] = e < 2 ? t : unit - t;
    r.at[1 - e % 2] = e == 1 || e == 2 ? unit : Big();
  }
  return r;
}
// How much of the side is passed at a point of it.
Big part_passed(const DomainPoint& p, int e) {
  if (p.is_triangle()) return p.at[(e + 2) % 3];
  return e < 2 ? p.at[e % 2] : p.unit - p.at[e % 2];
}
// Corner c of a tensor patch is where its side c starts; of a triangle, its corner c.
// The sides that start and that end at a corner.
int side_from(const Shape& s, int c) { return s.is_triangle ? (c + 2) % 3 : c; }
int side_to(const Shape& s, int c) { return s.is_triangle ? (c + 1) % 3 : (c + 3) % 4; }
int corner_from(const Shape& s, int e) {
  return s.is_triangle ? (e + 1) % 3 : e;
}  // where side e starts
DomainPoint place_at_corner(const Patch& patch, int c) {
  return place_on_side(patch, side_from(patch.shape, c), 0, 1);
}

typedef std::vector<BigVec> Net;

Net row_of(const Net& net, const Shape& s, int i) {
  return Net(net.begin() + s.at(i, 0), net.begin() + s.at(i, 0) + s.q + 1);
}
BigVec minus(const BigVec& a, const BigVec& b) { return sum(1, a, -1, b); }
// The polynomial with the Bernstein coefficients c at t / unit, times unit^degree.
BigVec value_at(Net c, const Big& t, const Big& unit) {
  const Big rest = unit - t;
  for (size_t left = c.size(); left > 1; --left)
    for (size_t i = 0; i + 1 < left; ++i) c[i] = sum(rest, c[i], t, c[i + 1]);
  return c[0];
}
Net differences(const Net& c) {
  Net r;
  for (size_t i = 0; i + 1 < c.size(); ++i) r.push_back(minus(c[i + 1], c[i]));
  return r;
}

struct Derivatives {  // along both parameters, times one positive number
  BigVec a, b;
};
Derivatives tensor_derivatives(const Net& net, const Shape& s, const DomainPoint& at) {
  Net values, slopes;
  for (int i = 0; i <= s.p; ++i) {
    const Net row = row_of(net, s, i);
    values.push_back(value_at(row, at.at[1], at.unit));
    slopes.push_back(value_at(differences(row), at.at[1], at.unit));
  }
  const BigVec u = value_at(differences(values), at.at[0], at.unit),
               v = value_at(slopes, at.at[0], at.unit), zero = {};
  return Derivatives{sum(Big(s.p), u, 0, zero), sum(Big(s.q), v, 0, zero)};
}
BigVec triangle_value(Net c, const Shape& s, const DomainPoint& at, int degree) {
  for (; degree > 0; --degree) {
    Net next;
    for (int row = 0; row < degree; ++row)
      for (int k = 0; k <= row; ++k) {
        const int j = row - k;
        next.push_back(
            sum(1, sum(at.at[0], c[size_t(s.at3(j, k))], at.at[1], c[size_t(s.at3(j + 1, k))]),
                at.at[2], c[size_t(s.at3(j, k + 1))]));
      }
    c.swap(next);
  }
  return c[0];
}
Derivatives triangle_derivatives(const Net& net, const Shape& s, const DomainPoint& at) {
  Net first, second;
  for (int row = 0; row < s.p; ++row)
    for (int k = 0; k <= row; ++k) {
      const BigVec& from = net[size_t(s.at3(row - k, k))];
      first.push_back(minus(net[size_t(s.at3(row - k + 1, k))], from));
      second.push_back(minus(net[size_t(s.at3(row - k, k + 1))], from));
    }
  return Derivatives{triangle_value(first, s, at, s.p - 1), triangle_value(second, s, at, s.p - 1)};
}

// The control points as seen from the point, times their weights.
Net net_around(const Patch& patch, const RationalPoint& q) {
  Net net;
  for (size_t i = 0; i < patch.net.size(); i += 4) {
    net.emplace_back();
    for (size_t k = 0; k < 3; ++k)
      net.back().x[k] = q.d * patch.net[i + k] - patch.net[i + 3] * q.n[k];
  }
  return net;
}
// Whether all are in the plane of a normal other than 0.
bool is_flat(const Net& net, const BigVec& normal) {
  bool has_normal = false;
  for (const Big& x : normal.x) has_normal = has_normal || !x.m.empty();
  for (const BigVec& r : net) has_normal = has_normal && side(normal, r) == 0;
  return has_normal;
}

// The corners of the domain as seen from the point, mapped by the derivatives there; false if the patch is not flat.
bool add_patch(const DomainPoint& at, const RationalPoint& q, Cone* cone) {
  const Net net = net_around(*at.patch, q);
  const Derivatives d = at.is_triangle() ? triangle_derivatives(net, at.patch->shape, at)
                                         : tensor_derivatives(net, at.patch->shape, at);
  if (!is_flat(net, cross(d.a, d.b))) return false;
  Net corners;
  for (int c = 0; c < at.corners(); ++c) {
    const DomainPoint to = place_at_corner(*at.patch, c);
    const int first = at.is_triangle() ? 1 : 0;
    corners.push_back(sum(at.unit * to.at[first] - at.at[first], d.a,
                          at.unit * to.at[first + 1] - at.at[first + 1], d.b));
  }
  add_polygon(corners, cone);
  return true;
}

// The number of the k-th control point in the row next to side e, in its direction of travel.
int next_to_side(const Shape& s, int e, int k) {
  if (s.is_triangle)
    return e == 0 ? s.at3(s.p - 1 - k, k) : e == 1 ? s.at3(1, s.p - 1 - k) : s.at3(k, 1);
  return e == 0   ? s.at(k, 1)
         : e == 1 ? s.at(s.p - 1, k)
         : e == 2 ? s.at(s.p - k, s.q - 1)
                  : s.at(1, s.q - k);
}
// Side e is collapsed to the point; false if the patch is not flat, or the row next to the side does not turn there.
bool add_fan(const Patch& patch, int e, const RationalPoint& q, Cone* cone) {
  const Net net = net_around(patch, q);
  Net fan;
  for (int k = patch.shape.side_degree(e) - (patch.shape.is_triangle ? 1 : 0); k >= 0; --k)
    fan.push_back(net[size_t(next_to_side(patch.shape, e, k))]);
  const BigVec normal = cross(fan.front(), fan.back());
  if (!is_flat(net, normal)) return false;
  for (size_t k = 1; k < fan.size(); ++k)
    for (size_t i = 0; i < k; ++i) {
      const int turn = side(normal, cross(fan[i], fan[k]));
      const bool is_at_end = k == 1 || i + 2 == fan.size();
      if (turn < 0 || (is_at_end && turn == 0)) return false;
    }
  add_polygon({fan.front(), fan.back(), BigVec()}, cone);
  return true;
}

class PatchCone {
 public:
  PatchCone(const PatchSurface& surface, const RationalPoint& q, const PlaceOnPatch& place,
            PointUnits* units, Cone* to)
      : surface_(surface), q_(q), place_(place), units_(*units), to_(*to) {}

  bool add(const DomainPoint& at) {
    spend_on(*at.patch);
    return add_patch(at, q_, &to_);
  }
  // Corners at which collapsed sides start stand for these, and those at which they end for nothing.
  bool add_vertex(uint32_t vertex) {
    for (uint32_t at : surface_.corners_at(vertex)) {
      const Patch& p = surface_.patches()[at / 4];
      const int from = side_from(p.shape, int(at % 4)), to = side_to(p.shape, int(at % 4));
      if (p.is_collapsed(to)) continue;
      if (!(p.is_collapsed(from) ? add_pole(p, from) : add(place_at_corner(p, int(at % 4)))))
        return false;
    }
    return true;
  }
  bool add_edge(const DomainPoint& at, int e) {
    const Big t = part_passed(at, e);
    for (uint32_t side : surface_.sides_of(at.patch->pair[e])) {
      const Patch& p = surface_.patches()[side / 4];
      const bool is_own = &p == at.patch && int(side % 4) == e;
      if (!add(is_own ? at : place_on_side(p, int(side % 4), at.unit - t, at.unit))) return false;
    }
    return true;
  }

 private:
  bool add_pole(const Patch& patch, int e) {
    spend_on(patch);
    return add_fan(patch, e, q_, &to_);
  }
  void spend_on(const Patch& patch) {
    const uint32_t number = uint32_t(&patch - surface_.patches().data());
    units_.add(surface_.units_at(number, q_, place_));
  }

  const PatchSurface& surface_;
  const RationalPoint& q_;
  const PlaceOnPatch& place_;
  PointUnits& units_;
  Cone& to_;
};

}  // namespace

bool find_patch_cone(const PatchSurface& surface, const RationalPoint& q, const PlaceOnPatch& place,
                     PointUnits* units, Cone* cone) {
  const Patch& patch = surface.patches()[size_t(place.patch)];
  if (place.algebraic != nullptr) {  // the middle stands for other places inside
    if (!place.algebraic->is_in_domain(patch.shape.is_triangle, 1)) return false;
    PlaceOnPatch middle;
    middle.patch = place.patch;
    middle.at[0] = middle.at[1] = Ratio(1, patch.shape.is_triangle ? 3 : 2);
    return PatchCone(surface, q, middle, units, cone).add(place_in(patch, middle.at));
  }
  const DomainPoint at = place_in(patch, place.at);
  std::vector<int> sides;
  for (int e = 0; e < patch.shape.sides(); ++e)
    if (at.is_on_side(e)) sides.push_back(e);
  PatchCone of(surface, q, place, units, cone);
  if (sides.empty()) return of.add(at);
  const bool is_on_side = sides.size() == 1;
  if (is_on_side && !patch.is_collapsed(sides[0])) return of.add_edge(at, sides[0]);
  int c = is_on_side ? corner_from(patch.shape, sides[0]) : 0;  // the corner where the point is
  for (int i = 0; i < patch.shape.sides(); ++i) {
    const DomainPoint corner = place_at_corner(patch, i);
    bool is_here = true;
    for (int k = 0; k < 3; ++k) is_here = is_here && corner.at[k] * at.unit == at.at[k];
    if (is_here) c = i;
  }
  return of.add_vertex(patch.vertex[c]);
}
