// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_values.h: exact values of s, as docs/formats/dms-files.md defines them, and Bernstein coefficients through them.
#pragma once
#include "dms.h"

struct DmsTerm {  // a V_gamma
  uint32_t tetrahedron;
  DmsIndex gamma;
};

// One point u and the simplex splines there. The path of rule H leads from u into the domain: by e(epsilon) where u is
// an inner point of a tetrahedron, and else towards a point `inside`, then by e(epsilon).
struct DmsPlace {
  // inside: null, or an inner point of a tetrahedron that u lies in
  DmsPlace(const DmsModel& model, const DmsPoint& u, const DmsPoint* inside);

  // The sum of N_gamma L_gamma over these terms: x, y, z.
  std::vector<Ratio> value(const std::vector<DmsTerm>& terms, Units* units);
  // The sum of N_gamma times the linear part of L_gamma, row by row: the
  // derivative of s, divided by n.
  std::vector<Ratio> derivative(const std::vector<DmsTerm>& terms, Units* units);

 private:
  friend struct DmsSum;                    // the same with polynomials
  typedef std::array<uint32_t, 3> Triple;  // of points, ascending
  struct Hash {
    size_t operator()(const Triple& t) const {
      return size_t(((t[0] * 0x9e3779b97f4a7c15u + t[1]) * 0x9e3779b97f4a7c15u + t[2]) *
                        0x9e3779b97f4a7c15u >>
                    13);
    }
  };
  struct Beside {  // what is known of the plane through three points
    DmsPlane plane;
    Big at_u;
    int side;  // of the path, after u
  };
  const Beside& beside(const Triple& t);
  // What beside() has of the points w but the m-th; *is_odd: whether d(u, ...) has the
  // other sign.
  const Beside& opposite(const uint32_t* w, size_t m, bool* is_odd);
  // d of the points w with u in the place of the m-th, times the denominators of the others and of u.
  Big replaced(const uint32_t* w, size_t m, int* side);
  Big determinant(const uint32_t* w);                   // d times the four denominators
  const Ratio& spline(const std::vector<uint32_t>& v);  // ascending
  // M(u|V_gamma), and W_gamma.
  const Ratio& spline(const DmsTerm& term, uint32_t* w, Units* units);
  Ratio computed(const std::vector<uint32_t>& v);
  Ratio constant(const uint32_t* v);
  bool find_simplex(const std::vector<uint32_t>& v, uint32_t* w);

  const DmsModel& model;
  const DmsPoint &u, *inside;
  std::unordered_map<Triple, Beside, Hash> planes;
  std::map<std::vector<uint32_t>, Ratio> splines;
};

// The mean of the vertices of a tetrahedron.
DmsPoint dms_middle(const DmsModel& model, size_t tetrahedron);

// How the Bernstein coefficients of degree n depend on the values at the points with the barycentric coordinates
// (i + 1, ...) / (n + corners): row by row, the indices in their order.
struct DmsInterpolation {
  DmsInterpolation(int n, size_t corners);

  std::vector<DmsIndex> indices;  // the last of them is 0 if there are three corners
  std::vector<Ratio> inverse;

  // The point of this index in a simplex.
  DmsPoint point(const DmsIndex& index, const DmsPoint* const* corner) const;
  // All coefficients, three coordinates each, of the polynomial with these
  // values at those points.
  std::vector<Ratio> coefficients(
      const DmsPoint* const* corner,
      const std::function<std::vector<Ratio>(const DmsPoint&)>& value) const;

 private:
  const int n;
  const size_t corners;
};
