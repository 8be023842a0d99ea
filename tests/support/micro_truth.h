// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_truth.h: how tiles of flat patches in affine cells lie with respect to convex and block models,
// in rational numbers. Shares no line with solids/micro/filter.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solids/micro/filter/tile_filter.h"
#include "splines/de_casteljau.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/micro_tiles.h"
#include "tests/support/shapes.h"

namespace veritope::micro_truth {

using oracle::RVec;

/// A bounded convex polyhedron: its points, and all directions of normals and edges that it has.
struct Convex {
  std::vector<RVec> points, normals, edges;
};

inline Convex convex_of(const micro_tiles::Hexahedron& h) {
  using oracle::operator-;
  Convex out{{h.begin(), h.end()}, {}, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    for (const std::size_t at : {std::size_t{0}, std::size_t{1} << a})
      out.normals.push_back(
          oracle::cross(h[at | std::size_t{1} << b] - h[at], h[at | std::size_t{1} << c] - h[at]));
    for (const std::size_t i : {std::size_t{0}, std::size_t{1} << b, std::size_t{1} << c,
                                std::size_t{1} << b | std::size_t{1} << c})
      out.edges.push_back(h[i | std::size_t{1} << a] - h[i]);
  }
  return out;
}

inline Convex convex_of(const TriangleMesh& mesh) {
  using oracle::operator-;
  Convex out;
  for (const Vec3d& p : mesh.positions) out.points.push_back(oracle::rational(p));
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto t = oracle::rational_triangle(mesh, f);
    out.normals.push_back(oracle::normal_of(t));
    for (std::size_t i = 0; i < 3; ++i) out.edges.push_back(t[(i + 1) % 3] - t[i]);
  }
  return out;
}

enum class Gap { kApart, kTouching, kOverlapping };

/// Whether two convex polyhedra with interior points are disjoint, have only boundary points in common, or more. By all
/// planes along a facet of one, or along an edge of each.
inline Gap gap_of(const Convex& a, const Convex& b) {
  std::vector<RVec> directions = a.normals;
  directions.insert(directions.end(), b.normals.begin(), b.normals.end());
  for (const RVec& e : a.edges)
    for (const RVec& f : b.edges) directions.push_back(oracle::cross(e, f));
  Gap out = Gap::kOverlapping;
  for (const RVec& d : directions) {
    if (oracle::is_zero(d)) continue;
    const auto range = [&](const Convex& c) {
      Rational lo = oracle::dot(d, c.points[0]), hi = lo;
      for (const RVec& p : c.points) {
        const Rational x = oracle::dot(d, p);
        lo = std::min(lo, x), hi = std::max(hi, x);
      }
      return std::pair(lo, hi);
    };
    const auto x = range(a), y = range(b);
    if (x.second < y.first || y.second < x.first) return Gap::kApart;
    if (x.second == y.first || y.second == x.first) out = Gap::kTouching;
  }
  return out;
}

struct Facts {
  bool is_in_interior = false, is_disjoint = false, meets_interior = false, meets_outside = false;
  CellStatus status() const {
    if (is_in_interior) return CellStatus::kKept;
    if (is_disjoint) return CellStatus::kOutside;
    return meets_interior && meets_outside ? CellStatus::kCrossing : CellStatus::kTouching;
  }
};

/// A solid whose truth is known: convex, a large box without such a solid, or the union of unit cubes.
struct Solid {
  TriangleMesh mesh;
  std::optional<Convex> convex;
  TriangleMesh convex_mesh;
  bool is_hollow = false;  ///< the convex solid is a bubble
  std::set<std::array<int, 3>> cubes;

  /// -1 off, 0 on, 1 inside.
  int side(const RVec& p) const;
  Facts facts(const std::vector<Convex>& parts) const;
};

inline micro_tiles::Hexahedron cube_at(const std::array<int, 3>& c) {
  return micro_tiles::hexahedron({Rational(c[0]), Rational(c[1]), Rational(c[2])},
                                 {Rational(c[0] + 1), Rational(c[1] + 1), Rational(c[2] + 1)});
}

/// REQUIRES an outward mesh.
inline Solid convex_solid(TriangleMesh mesh) {
  Solid out;
  out.convex = convex_of(mesh);
  out.convex_mesh = mesh;
  out.mesh = std::move(mesh);
  return out;
}
/// The box [-2^20, 2^20]^3 without that solid. REQUIRES that all is far inside of it.
inline Solid hollow_solid(const TriangleMesh& bubble) {
  Solid out = convex_solid(bubble);
  out.is_hollow = true;
  constexpr double kFar = 0x1p20;
  out.mesh = shapes::joined(shapes::box({-kFar, -kFar, -kFar}, {kFar, kFar, kFar}),
                            shapes::reversed(bubble));
  return out;
}
/// REQUIRES cubes whose union's boundary is a surface.
inline Solid block_solid(const std::set<std::array<int, 3>>& cubes) {
  Solid out;
  out.mesh = shapes::polycube({cubes.begin(), cubes.end()});
  out.cubes = cubes;
  return out;
}

inline int floor_of(const Rational& x) {
  int n = static_cast<int>(nearest_double(x));
  while (Rational(n) > x) --n;
  while (Rational(n + 1) <= x) ++n;
  return n;
}

inline int Solid::side(const RVec& p) const {
  using oracle::operator-;
  if (convex) {
    int out = 1;
    for (std::uint32_t f = 0; f < convex_mesh.faces.size(); ++f) {
      const auto t = oracle::rational_triangle(convex_mesh, f);
      out = std::min(out, -oracle::sgn(oracle::dot(oracle::normal_of(t), p - t[0])));
    }
    return is_hollow ? -out : out;
  }
  // All cubes that contain the point.
  bool is_in_all = true, is_in_one = false;
  std::array<int, 3> at;
  for (std::size_t c = 0; c < 3; ++c) at[c] = floor_of(p[c]);
  for (int i = 0; i < 8; ++i) {
    std::array<int, 3> cube = at;
    bool contains = true;
    for (std::size_t c = 0; c < 3; ++c)
      if ((i >> c & 1) != 0) {
        contains = contains && Rational(at[c]) == p[c];
        --cube[c];
      }
    if (!contains) continue;
    const bool is_solid = cubes.contains(cube);
    is_in_all = is_in_all && is_solid;
    is_in_one = is_in_one || is_solid;
  }
  return is_in_all ? 1 : is_in_one ? 0 : -1;
}

inline Facts Solid::facts(const std::vector<Convex>& parts) const {
  Facts out{true, true, false, false};
  if (convex) {
    for (const Convex& part : parts) {
      for (const RVec& p : part.points) {
        const int s = is_hollow ? -side(p) : side(p);
        out.is_in_interior = out.is_in_interior && s > 0;
        out.meets_outside = out.meets_outside || s < 0;
      }
      const Gap gap = gap_of(part, *convex);
      out.is_disjoint = out.is_disjoint && gap == Gap::kApart;
      out.meets_interior = out.meets_interior || gap == Gap::kOverlapping;
    }
    if (is_hollow) {
      std::swap(out.is_in_interior, out.is_disjoint);
      std::swap(out.meets_interior, out.meets_outside);
    }
    return out;
  }
  for (const Convex& part : parts) {
    std::array<int, 3> lo, hi;
    for (std::size_t c = 0; c < 3; ++c) {
      Rational least = part.points[0][c], most = least;
      for (const RVec& p : part.points) least = std::min(least, p[c]), most = std::max(most, p[c]);
      lo[c] = floor_of(least) - 1, hi[c] = floor_of(most) + 1;
    }
    for (int x = lo[0]; x <= hi[0]; ++x)
      for (int y = lo[1]; y <= hi[1]; ++y)
        for (int z = lo[2]; z <= hi[2]; ++z) {
          const bool is_solid = cubes.contains({x, y, z});
          const Gap gap = gap_of(part, convex_of(cube_at({x, y, z})));
          if (gap == Gap::kApart) continue;
          (is_solid ? out.is_disjoint : out.is_in_interior) = false;
          if (gap == Gap::kOverlapping) (is_solid ? out.meets_interior : out.meets_outside) = true;
        }
  }
  return out;
}

/// x -> origin + columns[0] x[0] + columns[1] x[1] + columns[2] x[2].
struct Affine {
  RVec origin;
  std::array<RVec, 3> columns;
  RVec operator()(const RVec& x) const {
    RVec out = origin;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t a = 0; a < 3; ++a) out[c] += columns[a][c] * x[a];
    return out;
  }
  Rational determinant() const {
    return oracle::dot(columns[0], oracle::cross(columns[1], columns[2]));
  }
};

/// One random question of known truth.
struct Case {
  Solid solid;
  micro_tiles::Tile tile;
  Affine cell;
  BezierVolume<Rational> map{{1, 1, 1}, 3, false};

  std::vector<Convex> parts() const {
    std::vector<Convex> out;
    for (micro_tiles::Hexahedron h : tile.parts) {
      for (auto& p : h) p = cell(p);
      out.push_back(convex_of(h));
    }
    return out;
  }
  std::string text() const {
    std::string out = shapes::to_text(solid.mesh) + "\n cell";
    for (const Rational& x : map.coefficients()) out += " " + x.to_string();
    for (const auto& h : tile.parts) {
      out += "\n part";
      for (const auto& p : h)
        for (const Rational& x : p) out += " " + x.to_string();
    }
    return out + "\n";
  }
};

inline Rational random_fraction(Random& random, int lo, int hi, int denominator) {
  return Rational(random.between(lo, hi)) / Rational(denominator);
}

/// A box, tetrahedron or octahedron with integer vertices.
inline Solid random_convex(Random& random) {
  for (;;) {
    TriangleMesh mesh;
    switch (random.below(3)) {
      case 0: mesh = shapes::parse("box 0,0,0 8,6,7"); break;
      case 1: mesh = shapes::parse("tet 0,0,0 9,0,0 0,8,0 0,0,9"); break;
      default:
        mesh = shapes::parse(
            "v 6,0,0 -6,0,0 0,5,0 0,-5,0 0,0,7 0,0,-7; f 0,2,4 2,1,4 1,3,4 3,0,4 2,0,5 1,2,5 3,1,5 "
            "0,3,5");
    }
    if (random.below(2) == 0) return convex_solid(std::move(mesh));
    const auto m = shapes::random_matrix(random, 2);
    if (shapes::determinant(m) < 0) continue;
    return convex_solid(shapes::mapped(mesh, m, {0, 0, 0}));
  }
}

/// Cubes of a 6 x 6 x 6 block, of which boxes are cut out: notches, tunnels and bubbles.
inline Solid random_blocks(Random& random) {
  for (;;) {
    std::set<std::array<int, 3>> cubes;
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 6; ++y)
        for (int z = 0; z < 6; ++z) cubes.insert({x, y, z});
    const auto num = random.below(4) + 1;
    for (std::uint64_t i = 0; i < num; ++i) {
      std::array<int, 3> lo, hi;
      for (std::size_t c = 0; c < 3; ++c) {
        lo[c] = static_cast<int>(random.between(0, 5));
        hi[c] = lo[c] + static_cast<int>(random.between(0, random.below(3) == 0 ? 5 : 1));
      }
      for (int x = lo[0]; x <= hi[0]; ++x)
        for (int y = lo[1]; y <= hi[1]; ++y)
          for (int z = lo[2]; z <= hi[2]; ++z) cubes.erase({x, y, z});
    }
    if (cubes.empty()) continue;
    // No two cubes, and no two empty places, that meet only in an edge or a corner.
    bool is_surface = true;
    for (int x = -1; x < 6 && is_surface; ++x)
      for (int y = -1; y < 6 && is_surface; ++y)
        for (int z = -1; z < 6 && is_surface; ++z) {
          std::array<bool, 8> is_solid;
          for (int i = 0; i < 8; ++i)
            is_solid[static_cast<std::size_t>(i)] =
                cubes.contains({x + (i & 1), y + (i >> 1 & 1), z + (i >> 2 & 1)});
          for (const bool kind : {false, true}) {
            std::array<bool, 8> is_seen{};
            int num_pieces = 0;
            for (std::size_t i = 0; i < 8; ++i) {
              if (is_solid[i] != kind || is_seen[i]) continue;
              ++num_pieces;
              std::vector<std::size_t> stack{i};
              while (!stack.empty()) {
                const std::size_t k = stack.back();
                stack.pop_back();
                if (is_seen[k]) continue;
                is_seen[k] = true;
                for (std::size_t bit : {1u, 2u, 4u})
                  if (is_solid[k ^ bit] == kind) stack.push_back(k ^ bit);
              }
            }
            is_surface = is_surface && num_pieces <= 1;
          }
          // The four places round an edge.
          for (std::size_t a = 1; a < 8; a *= 2)
            for (std::size_t end : {std::size_t{0}, a}) {
              const std::size_t b = a == 4 ? 1 : 2 * a, c = 7 - a - b;
              const bool p = is_solid[end], q = is_solid[end | b], r = is_solid[end | c],
                         s = is_solid[end | b | c];
              is_surface = is_surface && !(p == s && q == r && p != q);
            }
        }
    if (is_surface) return block_solid(cubes);
  }
}

inline micro_tiles::Tile random_tile(Random& random, int degree) {
  const auto inner = [&] { return random_fraction(random, 2, 7, 16); };
  if (random.below(3) != 0)
    return micro_tiles::jack(inner(), {inner(), inner(), inner(), inner(), inner(), inner()},
                             degree);
  micro_tiles::Point lo, hi;
  for (std::size_t c = 0; c < 3; ++c) {
    lo[c] = random_fraction(random, 0, 7, 16);
    hi[c] = random_fraction(random, 8, 16, 16);
  }
  return micro_tiles::box(lo, hi);
}

/// A point of a random facet.
inline RVec random_surface_point(Random& random, const TriangleMesh& mesh) {
  const auto& face = mesh.faces[random.below(mesh.faces.size())];
  RVec at;
  Rational weights(0);
  for (const std::uint32_t v : face) {
    const Rational w(random.between(1, 4));
    weights += w;
    const RVec p = oracle::rational(mesh.positions[v]);
    for (std::size_t c = 0; c < 3; ++c) at[c] += w * p[c];
  }
  for (Rational& x : at) x /= weights;
  return at;
}

/// A point of the tile's body in the unit cube.
inline micro_tiles::Point random_body_point(Random& random, const micro_tiles::Tile& tile) {
  const auto& volume = tile.volumes[random.below(tile.volumes.size())];
  // Every other point lies on the boundary of its volume.
  std::array<Rational, 3> u;
  for (Rational& x : u) x = random_fraction(random, 0, 16, 16);
  if (random.below(2) == 0) u[random.below(3)] = Rational(random.below(2));
  const auto x = evaluate<Rational, 3>(volume, u);
  return {x[0], x[1], x[2]};
}

/// Half of all cells have columns on the lattice of quarters, and half of these have a corner of the tile on the
/// surface, in some coordinates at least. In others a point of the tile's body lies on the surface, so that small
/// solids and bubbles may be inside of the tile.
inline Case random_case(Random& random, bool has_blocks) {
  Case out;
  out.solid = has_blocks ? random_blocks(random) : random_convex(random);
  out.tile = random_tile(random, 1);
  const bool is_on_lattice = random.below(2) == 0;
  const int denominator = is_on_lattice ? 4 : 1009;
  // Cells from a fifth of a cube to several solids.
  const std::array<int, 4> sizes{1, 4, 12, has_blocks ? 24 : 800};
  const std::size_t kind = random.below(4);
  const int size = sizes[kind] * (is_on_lattice ? 4 : 1009) / 4;
  do {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t c = 0; c < 3; ++c) {
        const int most = a == c ? size : is_on_lattice && random.below(2) == 0 ? 0 : size / 2;
        out.cell.columns[a][c] = random_fraction(random, -most, most, denominator);
      }
    }
  } while (out.cell.determinant().sign() == Sign::kZero);
  if (!has_blocks && random.below(2) == 0) out.solid = hollow_solid(out.solid.mesh);
  const TriangleMesh& near = has_blocks ? out.solid.mesh : out.solid.convex_mesh;
  const RVec at = random_surface_point(random, near);
  const bool is_touching = is_on_lattice && random.below(2) == 0;
  const auto& part = out.tile.parts[random.below(out.tile.parts.size())];
  const bool is_in_body = random.below(4) < (kind == 3 ? 3 : 1);
  const RVec body = random_body_point(random, out.tile);
  const RVec corner = part[random.below(8)];
  for (std::size_t c = 0; c < 3; ++c) {
    // Either a corner of the tile is moved to the point, in some coordinates at least, or the middle near to it.
    const bool is_corner = is_touching && random.below(4) != 0;
    RVec from{micro_tiles::half(), micro_tiles::half(), micro_tiles::half()};
    if (is_corner) from = corner;
    if (is_in_body) from = body;
    out.cell.origin[c] =
        at[c] - (out.cell.columns[0][c] * from[0] + out.cell.columns[1][c] * from[1] +
                 out.cell.columns[2][c] * from[2]);
    if (!is_corner && !is_in_body)
      out.cell.origin[c] +=
          random_fraction(random, -size, size, denominator) * random_fraction(random, 0, 2, 1);
  }
  std::array<int, 3> degrees;
  for (int& d : degrees) d = static_cast<int>(1 + random.below(3) / 2 * (1 + random.below(2)));
  out.map = micro_tiles::cage(degrees, [&](const RVec& u) { return out.cell(u); });
  return out;
}

/// A cell of a cage of degree 1 to 3 in each axis, near the surface: an affine image of the unit cube whose control
/// points were moved by less than 1/18, so that the map stays one to one: its derivative differs from the identity by
/// less than 1 in every row sum. A third of the maps are rational: a projective map comes after. The tile has the degree
/// 1 or 3; the affine map is only where the cell lies.
inline Case random_curved_case(Random& random, bool has_blocks) {
  Case out;
  out.solid = has_blocks ? random_blocks(random) : random_convex(random);
  out.tile = random_tile(random, random.below(2) == 0 ? 1 : 3);
  const int size = static_cast<int>(random.between(300, 4000));
  do {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t c = 0; c < 3; ++c)
        out.cell.columns[a][c] = random_fraction(random, -size, size, 1009) *
                                 random_fraction(random, a == c ? 2 : 0, 2, 2);
  } while (out.cell.determinant().sign() == Sign::kZero);
  const RVec at = random_surface_point(random, out.solid.mesh);
  for (std::size_t c = 0; c < 3; ++c) {
    const RVec& x = out.cell.columns[0];
    out.cell.origin[c] =
        at[c] + random_fraction(random, -size, size, 1009) -
        micro_tiles::half() * (x[c] + out.cell.columns[1][c] + out.cell.columns[2][c]);
  }
  std::array<int, 3> degrees;
  for (int& d : degrees) d = static_cast<int>(random.between(1, 3));
  std::vector<RVec> moved;
  out.map = micro_tiles::cage(degrees, [&](RVec u) {
    for (Rational& x : u) x += random_fraction(random, -55, 55, 1000);
    moved.push_back(u);
    return out.cell(u);
  });
  if (random.below(3) != 0) return out;
  // A projective map after it, which fixes the middle m: x -> m + (x - m) / w, w = 1 + a . (x - m) in the unit cube's
  // coordinates.
  RVec a;
  for (Rational& x : a) x = random_fraction(random, -10, 10, 40);
  const RVec middle{micro_tiles::half(), micro_tiles::half(), micro_tiles::half()};
  const RVec fixed = out.cell(middle);
  BezierVolume<Rational> rational(degrees, 4, true);
  for (std::size_t n = 0; n < moved.size(); ++n) {
    Rational w(1);
    for (std::size_t c = 0; c < 3; ++c) w += a[c] * (moved[n][c] - middle[c]);
    for (std::size_t c = 0; c < 3; ++c)
      rational.component(static_cast<int>(c))[n] =
          out.map.component(static_cast<int>(c))[n] + fixed[c] * (w - Rational(1));
    rational.component(3)[n] = w;
  }
  out.map = std::move(rational);
  return out;
}

/// What contradicts a status at `num` points of the tile, or nothing.
inline std::string contradiction_of(const Case& c, const CellMap& cell, CellStatus status, int num,
                                    Random& random) {
  int least = 1, most = -1;
  for (int i = 0; i < num; ++i) {
    const int side = c.solid.side(cell.image(random_body_point(random, c.tile)));
    least = std::min(least, side), most = std::max(most, side);
  }
  if ((status == CellStatus::kKept && least < 1) || (status == CellStatus::kOutside && most > -1) ||
      (status == CellStatus::kTouching && least < 0 && most > 0))
    return std::string("it is said to be ") + cell_status_name(status) + ", but its points show " +
           std::to_string(least) + " to " + std::to_string(most);
  return "";
}

/// What is wrong with a finding, or nothing. Undecided is never wrong here.
inline std::string fault_of(const Case& c, const CellMap& cell, const TileShape& shape,
                            const CellFinding& finding, const std::optional<Facts>& facts) {
  if (finding.status == CellStatus::kUndecided) return "";
  if (facts && finding.status != facts->status())
    return std::string("it is ") + cell_status_name(facts->status()) + ", and said to be " +
           cell_status_name(finding.status);
  if (finding.inside && c.solid.side(cell.image(shape, *finding.inside)) != 1)
    return "the point inside is not inside";
  if (finding.off && c.solid.side(cell.image(shape, *finding.off)) != -1)
    return "the point off is not off";
  if (finding.status == CellStatus::kCrossing &&
      static_cast<int>(finding.inside.has_value()) + static_cast<int>(finding.off.has_value()) +
              static_cast<int>(finding.vertex.has_value()) <
          2)
    return "a crossing without witnesses";
  if (finding.status == CellStatus::kTouching && c.solid.side(*finding.contact) != 0)
    return "the contact is not on the surface";
  return "";
}

}  // namespace veritope::micro_truth
