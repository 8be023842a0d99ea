// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/round_truth.h: how tiles lie with respect to balls, cylinders and what is made of them, by their
// equations, in rational numbers. Shares no line with solids/micro/filter.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/micro/filter/tile_filter.h"
#include "splines/de_casteljau.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/micro_tiles.h"

namespace veritope::round_truth {

using oracle::RVec;

/// factor * x + shift of a solid whose equations are known.
struct Solid {
  enum class Kind { kBall, kPolarBall, kShell, kCylinder, kNeck, kTorus };
  static constexpr int kNumKinds = 6;
  Kind kind = Kind::kBall;
  Rational factor{1};
  RVec shift;

  patch_shapes::Patches patches() const {
    return patch_shapes::placed(
        [&] {
          switch (kind) {
            case Kind::kBall: return patch_shapes::sphere();
            case Kind::kPolarBall: return patch_shapes::octant_sphere();
            case Kind::kShell: return patch_shapes::thin_shell(Rational(1) / Rational(4));
            case Kind::kCylinder: return patch_shapes::disc_cylinder(Rational(2));
            case Kind::kNeck: return patch_shapes::ball_with_neck();
            default: return patch_shapes::torus(3, 1);
          }
        }(),
        factor, shift);
  }
  RVec local(const RVec& p) const {
    using oracle::operator*;
    using oracle::operator-;
    return (Rational(1) / factor) * (p - shift);
  }

  /// -1 off, 0 on, 1 inside.
  int side(const RVec& point) const {
    const RVec p = local(point);
    const Rational xy = p[0] * p[0] + p[1] * p[1], all = xy + p[2] * p[2];
    const auto between = [](const Rational& x, const Rational& lo, const Rational& hi) {
      return std::min(oracle::sgn(x - lo), oracle::sgn(hi - x));
    };
    const Rational one(1), zero(0);
    switch (kind) {
      case Kind::kBall:
      case Kind::kPolarBall: return oracle::sgn(one - all);
      case Kind::kShell: return between(all, Rational(9) / Rational(16), one);
      case Kind::kCylinder:
        return std::min(oracle::sgn(one - xy), between(p[2], zero, Rational(2)));
      case Kind::kNeck: {
        const int ball = oracle::sgn(Rational(25) - all);
        const int neck = std::min(oracle::sgn(Rational(9) - xy), between(p[2], zero, Rational(8)));
        return std::max(ball, neck);
      }
      default: {
        const Rational s = all + Rational(8);
        return oracle::sgn(Rational(36) * xy - s * s);
      }
    }
  }
};

/// The least and the greatest value of x^2 + y^2 + z^2, or of x^2 + y^2, on the convex hull of points.
struct SquareRange {
  Rational least, most;
};

/// The least square of the distance from the origin of a point of the segment.
inline Rational least_square(const RVec& a, const RVec& b) {
  using oracle::operator-;
  const RVec d = b - a;
  const Rational along = -oracle::dot(a, d), length = oracle::dot(d, d);
  if (oracle::sgn(along) <= 0) return oracle::dot(a, a);
  if (along >= length) return oracle::dot(b, b);
  return oracle::dot(a, a) - along * along / length;
}

/// The range on a hexahedron with flat faces, numbered as micro_tiles::Hexahedron; it may be mirrored.
inline SquareRange square_range(const micro_tiles::Hexahedron& h) {
  using oracle::operator-;
  SquareRange out{oracle::dot(h[0], h[0]), oracle::dot(h[0], h[0])};
  for (const RVec& p : h) out.most = std::max(out.most, oracle::dot(p, p));
  RVec middle;
  for (std::size_t c = 0; c < 3; ++c)
    for (const RVec& p : h) middle[c] += p[c] / Rational(8);
  bool is_inside = true;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t b = std::size_t{1} << (a + 1) % 3, c = std::size_t{1} << (a + 2) % 3,
                        at = end << a;
      const std::array<RVec, 4> f{h[at], h[at | b], h[at | b | c], h[at | c]};
      RVec n = oracle::cross(f[1] - f[0], f[3] - f[0]);
      // The normal points away from the middle.
      Rational height = oracle::dot(n, f[0]);
      if (height < oracle::dot(n, middle)) {
        n = RVec{-n[0], -n[1], -n[2]};
        height = -height;
      }
      is_inside = is_inside && oracle::sgn(height) > 0;
      for (std::size_t i = 0; i < 4; ++i)
        out.least = std::min(out.least, least_square(f[i], f[(i + 1) % 4]));
      // The foot of the origin on the plane, if it is in the face.
      const Rational nn = oracle::dot(n, n);
      const RVec foot{n[0] * height / nn, n[1] * height / nn, n[2] * height / nn};
      int sign = 0;
      bool is_in_face = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const int s =
            oracle::sgn(oracle::dot(n, oracle::cross(f[(i + 1) % 4] - f[i], foot - f[i])));
        is_in_face = is_in_face && (s == 0 || sign == 0 || s == sign);
        if (s != 0) sign = s;
      }
      if (is_in_face) out.least = std::min(out.least, height * height / nn);
    }
  if (is_inside) out.least = Rational(0);
  return out;
}

/// The least of x^2 + y^2 on the part of the hexahedron with lo <= z <= hi; nothing if it is empty.
inline std::optional<Rational> least_around_axis(const micro_tiles::Hexahedron& h,
                                                 const Rational& lo, const Rational& hi) {
  std::vector<RVec> points;
  const auto add = [&](const RVec& p) {
    if (p[2] >= lo && p[2] <= hi) points.push_back({p[0], p[1], Rational(0)});
  };
  for (const RVec& p : h) add(p);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t bit : {1u, 2u, 4u}) {
      if ((i & bit) != 0) continue;
      const RVec &p = h[i], &q = h[i | bit];
      for (const Rational& z : {lo, hi}) {
        const Rational d = q[2] - p[2];
        if (oracle::sgn(d) == 0 || oracle::sgn(z - p[2]) * oracle::sgn(z - q[2]) >= 0) continue;
        const Rational t = (z - p[2]) / d;
        add({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), z});
      }
    }
  if (points.empty()) return std::nullopt;
  Rational least = oracle::dot(points[0], points[0]);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i + 1; k < points.size(); ++k)
      least = std::min(least, least_square(points[i], points[k]));
  const auto turn = [](const RVec& a, const RVec& b) {
    return oracle::sgn(a[0] * b[1] - a[1] * b[0]);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const int a = turn(points[i], points[j]), b = turn(points[j], points[k]),
                  c = turn(points[k], points[i]);
        if (a != 0 && a == b && b == c) return Rational(0);
      }
  return least;
}

/// The status of a tile of hexahedra; nothing where this truth does not know it.
inline std::optional<CellStatus> status_of(const Solid& solid,
                                           std::vector<micro_tiles::Hexahedron> parts) {
  using Kind = Solid::Kind;
  bool is_in = true, is_off = true, meets_in = false, meets_off = false, knows_all = true;
  const Rational one(1);
  for (micro_tiles::Hexahedron& h : parts) {
    for (RVec& p : h) {
      const int s = solid.side(p);
      meets_in = meets_in || s > 0;
      meets_off = meets_off || s < 0;
      p = solid.local(p);
    }
    const SquareRange r = square_range(h);
    switch (solid.kind) {
      case Kind::kBall:
      case Kind::kPolarBall:
        is_in = is_in && r.most < one;
        is_off = is_off && r.least > one;
        meets_in = meets_in || r.least < one;
        break;
      case Kind::kShell: {
        const Rational inner = Rational(9) / Rational(16);
        is_in = is_in && r.most < one && r.least > inner;
        is_off = is_off && (r.least > one || r.most < inner);
        // Squares of all values between occur.
        meets_in = meets_in || (r.least < one && r.most > inner);
        meets_off = meets_off || r.least < inner;
        break;
      }
      case Kind::kCylinder: {
        const std::optional<Rational> d = least_around_axis(h, Rational(0), Rational(2));
        for (const RVec& p : h)
          is_in = is_in && p[0] * p[0] + p[1] * p[1] < one && oracle::sgn(p[2]) > 0 &&
                  p[2] < Rational(2);
        is_off = is_off && (!d || *d > one);
        // Whether interior points of the cylinder are among them where no vertex is, is not known.
        knows_all = false;
        break;
      }
      case Kind::kNeck: {
        const std::optional<Rational> d = least_around_axis(h, Rational(0), Rational(8));
        bool is_in_neck = true;
        for (const RVec& p : h)
          is_in_neck = is_in_neck && p[0] * p[0] + p[1] * p[1] < Rational(9) &&
                       oracle::sgn(p[2]) > 0 && p[2] < Rational(8);
        is_in = is_in && (r.most < Rational(25) || is_in_neck);
        is_off = is_off && r.least > Rational(25) && (!d || *d > Rational(9));
        meets_in = meets_in || r.least < Rational(25);
        knows_all = false;
        break;
      }
      default: is_in = is_off = knows_all = false;
    }
  }
  if (is_in) return CellStatus::kKept;
  if (is_off) return CellStatus::kOutside;
  if (meets_in && meets_off) return CellStatus::kCrossing;
  return knows_all ? std::optional(CellStatus::kTouching) : std::nullopt;
}

/// One random question.
struct Case {
  Solid solid;
  patch_shapes::Patches patches;
  micro_tiles::Tile tile;
  BezierVolume<Rational> map{{1, 1, 1}, 3, false};
  bool is_affine = true;

  std::vector<micro_tiles::Hexahedron> parts() const {
    std::vector<micro_tiles::Hexahedron> out = tile.parts;
    for (auto& h : out)
      for (RVec& p : h) p = image(p);
    return out;
  }
  RVec image(const RVec& u) const {
    const auto x = evaluate<Rational, 3>(map, u);
    return {x[0], x[1], x[2]};
  }
  std::string text() const {
    std::string out = "kind " + std::to_string(static_cast<int>(solid.kind)) + ", factor " +
                      solid.factor.to_string() + ", shift";
    for (const Rational& x : solid.shift) out += " " + x.to_string();
    out += "\n cell of degrees";
    for (const int d : map.degrees()) out += " " + std::to_string(d);
    for (const Rational& x : map.coefficients()) out += " " + x.to_string();
    for (const auto& h : tile.parts) {
      out += "\n part";
      for (const auto& p : h)
        for (const Rational& x : p) out += " " + x.to_string();
    }
    return out + "\n";
  }
};

inline Rational fraction(Random& random, int lo, int hi, int denominator) {
  return Rational(random.between(lo, hi)) / Rational(denominator);
}

/// A point of the tile's body in the unit cube.
inline RVec body_point(Random& random, const micro_tiles::Tile& tile) {
  const auto& volume = tile.volumes[random.below(tile.volumes.size())];
  RVec u;
  for (Rational& x : u) x = fraction(random, 0, 64, 64);
  if (random.below(2) == 0) u[random.below(3)] = Rational(random.below(2));
  const auto x = evaluate<Rational, 3>(volume, u);
  return {x[0], x[1], x[2]};
}

/// A cell some point of whose tile is near the surface. Curved cells are shears by quadratic functions after an affine
/// map, and so one to one.
inline Case random_case(Random& random, Solid::Kind kind, bool is_affine) {
  Case out;
  out.is_affine = is_affine;
  out.solid.kind = kind;
  out.solid.factor = fraction(random, 1, 24, 8);
  for (Rational& x : out.solid.shift) x = fraction(random, -20, 20, 8);
  out.patches = out.solid.patches();
  const auto width = [&] { return fraction(random, 2, 7, 16); };
  out.tile =
      random.below(3) != 0
          ? micro_tiles::jack(width(), {width(), width(), width(), width(), width(), width()},
                              is_affine || random.below(2) == 0 ? 1 : 3)
          : micro_tiles::box({fraction(random, 0, 7, 16), fraction(random, 0, 7, 16),
                              fraction(random, 0, 7, 16)},
                             {fraction(random, 8, 16, 16), fraction(random, 8, 16, 16),
                              fraction(random, 8, 16, 16)});
  // A point near the surface, exactly on it at times.
  const Patch& patch = out.patches[random.below(out.patches.size())];
  const auto on = point_of(evaluate<Rational, 2>(
      patch.tensor(), {fraction(random, 0, 16, 16), fraction(random, 0, 16, 16)}));
  RVec at = *on;
  const std::uint64_t how = random.below(4);
  if (how != 0)
    for (Rational& x : at)
      x += out.solid.factor * fraction(random, -100, 100, how == 1 ? 100 : 1000);
  // Cells from a twentieth of the solid to several of them.
  const std::array<int, 4> sizes{50, 150, 600, 4000};
  const int size = sizes[random.below(4)];
  std::array<RVec, 3> columns;
  do {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t c = 0; c < 3; ++c)
        columns[a][c] = out.solid.factor * fraction(random, -(a == c ? size : size / 2),
                                                    a == c ? size : size / 2, 1000);
  } while (oracle::sgn(oracle::dot(columns[0], oracle::cross(columns[1], columns[2]))) == 0);
  const int bend = is_affine ? 0 : static_cast<int>(random.between(10, 60));
  const Rational a = fraction(random, -bend, bend, 100), b = fraction(random, -bend, bend, 100),
                 c = fraction(random, -bend, bend, 100);
  // (u + a v^2 + b v w, v + c w^2, w), in Bernstein form of degree 2.
  const int degree = is_affine ? 1 : 2;
  out.map = BezierVolume<Rational>({degree, degree, degree}, 3, false);
  const Grid<3> grid = out.map.grid();
  const auto place = [&](const RVec& origin) {
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto i = grid.index_of(n);
      RVec u;
      for (std::size_t k = 0; k < 3; ++k) u[k] = Rational(i[k]) / Rational(degree);
      // The blossom of t^2 at the knots of control point i of degree 2 is 0, 0, 1; that of v w is the product.
      const RVec w = u;
      if (!is_affine) {
        u[0] += a * Rational(i[1] == 2 ? 1 : 0) + b * w[1] * w[2];
        u[1] += c * Rational(i[2] == 2 ? 1 : 0);
      }
      for (std::size_t k = 0; k < 3; ++k)
        out.map.component(static_cast<int>(k))[n] =
            origin[k] + columns[0][k] * u[0] + columns[1][k] * u[1] + columns[2][k] * u[2];
    }
  };
  place({});
  const RVec body = out.image(body_point(random, out.tile));
  place({at[0] - body[0], at[1] - body[1], at[2] - body[2]});
  return out;
}

/// Why the finding is wrong; empty if nothing speaks against it. The points are exact ones of the tile's body.
inline std::string fault_of(const Case& c, const TileShape& shape, const CellFinding& finding,
                            const std::optional<CellStatus>& truth, int points, Random& random) {
  const CellStatus status = finding.status;
  if (status == CellStatus::kUndecided) return "";
  if (truth && *truth != status)
    return std::string("it is ") + cell_status_name(*truth) + ", and said to be " +
           cell_status_name(status);
  const auto side_at = [&](const TilePatchPoint& at) {
    const auto u = evaluate<Rational, 2>(shape.patches()[at.patch].exact, {at.u, at.v});
    return c.solid.side(c.image({u[0], u[1], u[2]}));
  };
  if (finding.inside && side_at(*finding.inside) != 1) return "the point inside is not inside";
  if (finding.off && side_at(*finding.off) != -1) return "the point off is not off";
  if (status == CellStatus::kCrossing && static_cast<int>(finding.inside.has_value()) +
                                                 static_cast<int>(finding.off.has_value()) +
                                                 static_cast<int>(finding.vertex.has_value()) <
                                             2)
    return "a crossing without witnesses";
  for (int i = 0; i < points; ++i) {
    const int s = c.solid.side(c.image(body_point(random, c.tile)));
    if (status == CellStatus::kKept && s != 1) return "a point of a kept tile is not inside";
    if (status == CellStatus::kOutside && s != -1) return "a point of an outer tile is not off";
  }
  return "";
}

}  // namespace veritope::round_truth
