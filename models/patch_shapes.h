// SPDX-License-Identifier: LGPL-3.0-or-later
// models/patch_shapes.h: example models as patches with exact rational control points, whose truth is known by
// construction: sound ones, and broken ones whose names say what is wrong.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope::patch_shapes {

using Point = PatchPoint;
using Patches = std::vector<Patch>;

// All normals point out of the solid. Circles are cut into quarters at the directions +x, +y, -x, -y; the weights of a
// quarter's ends are 1 and 2, so that they agree where quarters meet.

/// Six bilinear faces. REQUIRES low < high in every coordinate.
Patches box(const Point& low, const Point& high);
/// The unit sphere as six rational biquartic patches without a singular point: the images of a square around either
/// pole by stereographic projection, and four patches between them. chi = 8 - 12 + 6.
Patches sphere();
/// The unit sphere as eight biquadratic octants with collapsed sides at the poles. chi = 6 - 12 + 8.
Patches octant_sphere();
/// A circle of radius r whose middle has the distance R from the z axis, revolved: 16 rational biquadratic patches. It
/// is embedded iff r < R; with r = R the origin is two poles (genus 0); with r > R it meets itself in two points of the
/// axis, where S_u = 0.
Patches torus(const Rational& big_radius, const Rational& radius);
/// That torus as one patch of degrees (5, 5), glued to itself along both pairs of opposite sides. chi = 1 - 2 + 1.
Patches one_patch_torus(const Rational& big_radius, const Rational& radius);

/// A frustum with radius `bottom` at z = 0 and `top` at z = height, whose flat ends have five patches each and no
/// singular point; a cylinder if the radii are equal. With top = 0 it is a cone whose apex is a pole, without the upper
/// end. REQUIRES bottom > 0, top >= 0, height > 0.
Patches frustum(const Rational& bottom, const Rational& top, const Rational& height);
/// The boundary of a union of unit cubes at integer places: each face that only one cube has is a bilinear patch. It is
/// a solid iff the union is a manifold; REQUIRES that for a sound model.
Patches blocks(const std::vector<std::array<int, 3>>& cubes);
/// A plate of cubes with g square holes in a row, bent by two quadratic shears: patches of degrees (4, 4), genus g.
Patches plate(int g);
/// The unit sphere with a spherical hole of radius 1 - thickness in its middle: two shells. REQUIRES 0 < thickness < 1.
Patches thin_shell(const Rational& thickness);
/// A tube around a trefoil: uniform biquadratic B-splines around `around` and `along` control points, whose frames are
/// rounded to multiples of 2^-12 and closed exactly; polynomial patches, C1. Embedded for radius <= 1/4, around >= 5,
/// along >= 40. Genus 1.
Patches knotted_tube(const Rational& radius, int around, int along);
/// A bellied pot with a neck and a knob: 20 patches of degrees (2, 3), smooth poles at both ends. Its height rises
/// along the whole profile, so it is embedded.
Patches teapot();
/// PN triangles over a torus (3, 1) of 2 m n triangles, with coordinates rounded to multiples of 2^-20 and control
/// points to binary64. It is embedded for m >= 12, n >= 8; (12, 8) has 192 cubic Bezier triangles.
Patches pn_torus(int m, int n);
/// A torus of m times n bilinear patches, for timing.
Patches grid_torus(int m, int n);

/// x -> factor * x + shift for each patch; a negative factor reverses them. REQUIRES factor != 0.
Patches placed(const Patches& patches, const Rational& factor, const Point& shift);
/// All patches of the parts, numbered anew.
Patches joined(std::initializer_list<Patches> parts);
/// The patches with every normal reversed.
Patches reversed(const Patches& patches);

/// The cube [-4,4]^3 of 38 flat triangles whose top is folded like a Z without leaving its plane: three sheets in the
/// middle, S0 true. Its set of points looks like that of a sound cube: it must be refused all the same.
Patches wrinkled_cube();

/// What is known of a model's map by construction.
enum class Truth {
  kEmbedded,  ///< one to one
  kCrossing,  ///< two sheets cross transversally somewhere: a witness can be proved
  /// not one to one, but nowhere with a crossing that need be found: tangent, in contact, or folded onto itself
  kTouching,
};
struct Shape {
  std::string name;
  Patches patches;
  Truth truth;
  std::vector<int> genus;  ///< of each shell, in the order of PatchComplex::shells()
  int bodies;              ///< of an embedded model
};
/// Every builder above with small parameters.
std::vector<Shape> sound_shapes();
/// A broken form of each; every one is a closed oriented surface (S0), and wrong only in space.
std::vector<Shape> broken_shapes();

}  // namespace veritope::patch_shapes
