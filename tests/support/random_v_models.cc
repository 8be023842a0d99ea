// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/random_v_models.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

#include "robust/base/check.h"
#include "solids/volumes/primitives.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_product.h"
#include "splines/de_casteljau.h"

namespace veritope::random_v_models {
namespace {

using Cube = std::array<int, 3>;
using Cubes = std::set<Cube>;
using Map = BezierVolume<Rational>;
using Scalar = BezierVolume<Rational>;  // one component

Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }
std::size_t index_of(int i) { return static_cast<std::size_t>(i); }

// ---- Quadratic shears

struct Shear {
  Rational a, b, c, d;
};
Shear random_shear(Random& random) {
  const auto part = [&] { return ratio(random.between(-6, 6), 16); };
  return {part(), part(), part(), part()};
}
Scalar scaled(Scalar s, const Rational& by) {
  for (Rational& x : s.coefficients()) x *= by;
  return s;
}
// (x, y + a x^2, z + b x^2 + c x y + d y^2) of the homogeneous map: the degrees are doubled.
Map sheared(const Map& map, const Shear& by) {
  const Scalar one({0, 0, 0}, 1, false, {Rational(1)});
  const auto component = [&](int c) -> Scalar {
    const auto values = map.component(c);
    return {map.degrees(), 1, false, {values.begin(), values.end()}};
  };
  const Scalar x = component(0), y = component(1), z = component(2),
               w = map.is_rational() ? component(3) : one;
  auto degrees = map.degrees();
  for (int& p : degrees) p *= 2;
  const Scalar zero(degrees, 1, false), xx = multiplied(x, x);
  const std::array<Scalar, 4> out{
      sum(multiplied(x, w), zero), sum(multiplied(y, w), scaled(xx, by.a)),
      sum(sum(multiplied(z, w), scaled(xx, by.b)),
          sum(scaled(multiplied(x, y), by.c), scaled(multiplied(y, y), by.d))),
      multiplied(w, w)};
  std::vector<Rational> values;
  const int n = map.num_components();
  for (int c = 0; c < n; ++c) {
    const auto part = out[index_of(c)].component(0);
    values.insert(values.end(), part.begin(), part.end());
  }
  return {degrees, n, map.is_rational(), std::move(values)};
}
void shear(std::vector<Map>& cells, Model& model, Random& random) {
  const Shear by = random_shear(random);
  for (Map& cell : cells) cell = sheared(cell, by);
  model.description += ", sheared by " + by.a.to_string() + " " + by.b.to_string() + " " +
                       by.c.to_string() + " " + by.d.to_string();
}
void set_cells(Model& model, const std::vector<Map>& cells) {
  for (const Map& cell : cells) model.cells.push_back(to_bspline(cell));
}

// ---- Moved lattices

// The point (i / p, j / q, k / r), moved by less than share / (2 (p + q + r)) in each coordinate.
class MovedLattice {
 public:
  MovedLattice(std::array<int, 3> degrees, double share, Random& random)
      : degrees_(degrees), random_(random) {
    const int sum = degrees[0] + degrees[1] + degrees[2];
    steps_ = static_cast<std::int64_t>(share / (2 * sum) * kUnit);
  }
  const Point& at(const Cube& place) {
    const auto [found, is_new] = points_.try_emplace(place);
    if (is_new)
      for (std::size_t c = 0; c < 3; ++c)
        found->second[c] = ratio(place[c], degrees_[c]) +
                           Rational(random_.between(-steps_, steps_)) / Rational(kUnit);
    return found->second;
  }
  Map cell(const Cube& cube) {
    Map out(degrees_, 3, false);
    const Grid<3> grid = out.grid();
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto index = grid.index_of(n);
      Cube place;
      for (std::size_t c = 0; c < 3; ++c)
        place[c] = cube[c] * degrees_[c] + static_cast<int>(index[c]);
      const Point& p = at(place);
      for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[n] = p[c];
    }
    return out;
  }

 private:
  static constexpr int kUnit = 1 << 14;
  std::array<int, 3> degrees_;
  Random& random_;
  std::int64_t steps_;
  std::map<Cube, Point> points_;
};

std::array<int, 3> random_degrees(Random& random, int low, int high) {
  std::array<int, 3> out;
  for (int& p : out) p = static_cast<int>(random.between(low, high));
  return out;
}
std::string text_of(const std::array<int, 3>& d) {
  return std::to_string(d[0]) + " " + std::to_string(d[1]) + " " + std::to_string(d[2]);
}

// ---- Sets of unit cubes

std::array<Cube, 2> box_around(const Cubes& cubes) {
  std::array<Cube, 2> out{*cubes.begin(), *cubes.begin()};
  for (const Cube& c : cubes)
    for (std::size_t a = 0; a < 3; ++a) {
      out[0][a] = std::min(out[0][a], c[a]);
      out[1][a] = std::max(out[1][a], c[a] + 1);
    }
  return out;
}
template <typename Visit>
void for_each_vertex(const Cubes& cubes, Visit visit) {
  const auto [low, high] = box_around(cubes);
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int z = low[2]; z <= high[2]; ++z) visit(Cube{x, y, z});
}
// Bit dx + 2 dy + 4 dz: whether the cube at vertex - 1 + (dx, dy, dz) is there.
unsigned cubes_at(const Cubes& cubes, const Cube& vertex) {
  unsigned out = 0;
  for (unsigned n = 0; n < 8; ++n) {
    Cube cube = vertex;
    for (unsigned a = 0; a < 3; ++a) cube[a] += static_cast<int>(n >> a & 1) - 1;
    if (cubes.count(cube) != 0) out |= 1u << n;
  }
  return out;
}
// Whether the octants in the set hang together through faces.
bool is_connected(unsigned octants) {
  if (octants == 0) return true;
  unsigned seen = octants & (~octants + 1);
  for (unsigned before = 0; before != seen;) {
    before = seen;
    for (unsigned n = 0; n < 8; ++n)
      for (unsigned a = 0; a < 3; ++a)
        if ((seen >> n & 1) != 0) seen |= octants & 1u << (n ^ 1u << a);
  }
  return seen == octants;
}
// The edge from the vertex along an axis: whether exactly two of its four cubes are there, across it.
bool is_bad_edge(const Cubes& cubes, const Cube& vertex, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto has = [&](int di, int dj) {
    Cube cube = vertex;
    cube[i] += di, cube[j] += dj;
    return cubes.count(cube) != 0;
  };
  const bool a = has(-1, -1), b = has(0, -1), c = has(-1, 0), d = has(0, 0);
  return a == d && b == c && a != b;
}
bool is_bad_vertex(const Cubes& cubes, const Cube& vertex) {
  const unsigned octants = cubes_at(cubes, vertex);
  return !is_connected(octants) || !is_connected(~octants & 255u);
}
bool is_manifold(const Cubes& cubes) {
  bool out = true;
  for_each_vertex(cubes, [&](const Cube& v) { out = out && !is_bad_vertex(cubes, v); });
  return out;
}
// Whether two border faces at one vertex look in opposite directions.
bool has_opposed_faces(const Cubes& cubes) {
  bool out = false;
  for_each_vertex(cubes, [&](const Cube& v) {
    const unsigned octants = cubes_at(cubes, v);
    for (unsigned a = 0; a < 3; ++a) {
      unsigned ways = 0;
      for (unsigned n = 0; n < 8; ++n)
        if ((n >> a & 1) == 0 && (octants >> n & 1) != (octants >> (n | 1u << a) & 1))
          ways |= (octants >> n & 1) != 0 ? 1u : 2u;
      out = out || ways == 3;
    }
  });
  return out;
}

// Places of the lattice with half the spacing: vertices, middles of edges, faces and cubes.
KnownSolid numbers_of(const Cubes& cubes) {
  std::map<Cube, int> cells_on;  // of each part of a cube
  for (const Cube& cube : cubes)
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z) ++cells_on[{2 * cube[0] + x, 2 * cube[1] + y, 2 * cube[2] + z}];
  KnownSolid out;
  const auto is_odd = [](int i) { return (i & 1) != 0; };
  std::map<Cube, std::size_t> border;  // faces, with the number of a component
  std::vector<std::size_t> root;
  for (const auto& [place, count] : cells_on) {
    const int odd = is_odd(place[0]) + is_odd(place[1]) + is_odd(place[2]);
    ++(odd == 0 ? out.v_points : odd == 1 ? out.v_curves : out.v_surfaces);
    if (odd == 3) --out.v_surfaces;
    if (odd == 2 && count == 1) border[place] = root.size(), root.push_back(root.size());
  }
  const auto find = [&](std::size_t n) {
    while (root[n] != n) n = root[n];
    return n;
  };
  // In a manifold an edge has no or two border faces, and those at a vertex are one component.
  std::map<Cube, std::size_t> sides;  // vertices and edges on the border, with one of their faces
  for (const auto& [face, number] : border) {
    std::array<std::size_t, 2> along{};
    for (std::size_t a = 0, n = 0; a < 3; ++a)
      if (is_odd(face[a])) along[n++] = a;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) {
        if (i == 0 && j == 0) continue;
        Cube at = face;
        at[along[0]] += i, at[along[1]] += j;
        const auto [found, is_new] = sides.try_emplace(at, number);
        if (!is_new) root[find(number)] = find(found->second);
      }
  }
  std::map<std::size_t, std::int64_t> chi;
  for (const auto& [face, number] : border) ++chi[find(number)];
  for (const auto& [place, number] : sides)
    chi[find(number)] += is_odd(place[0] + place[1] + place[2]) ? -1 : 1;
  for (const auto& [component, value] : chi) out.genus.push_back(1 - value / 2);
  std::sort(out.genus.begin(), out.genus.end());
  Cubes left = cubes;
  for (; !left.empty(); ++out.bodies) {
    std::vector<Cube> open{*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const Cube cube = open.back();
      open.pop_back();
      for (std::size_t a = 0; a < 3; ++a)
        for (const int by : {-1, 1}) {
          Cube next = cube;
          next[a] += by;
          if (left.erase(next) != 0) open.push_back(next);
        }
    }
  }
  return out;
}

Cubes box_of(const Cube& size) {
  Cubes out;
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z) out.insert({x, y, z});
  return out;
}
// Cubes around one vertex, or cubes that grow one from another; with few, single ones apart.
Cubes random_cubes(Random& random) {
  Cubes out;
  if (random.below(3) == 0) {
    const auto octants = static_cast<unsigned>(1 + random.below(255));
    for (unsigned n = 0; n < 8; ++n)
      if ((octants >> n & 1) != 0)
        out.insert(
            {static_cast<int>(n & 1), static_cast<int>(n >> 1 & 1), static_cast<int>(n >> 2)});
  } else {
    out.insert({0, 0, 0});
  }
  const std::size_t wanted = out.size() + random.below(6);
  while (out.size() < wanted) {
    auto from = out.begin();
    std::advance(from, static_cast<std::ptrdiff_t>(random.below(out.size())));
    Cube next = *from;
    next[random.below(3)] += random.below(2) != 0 ? 1 : -1;
    out.insert(next);
  }
  if (random.below(6) == 0)
    out.insert(
        {static_cast<int>(random.between(-3, 4)), static_cast<int>(random.between(-3, 4)), 3});
  return out;
}
Cubes random_manifold_cubes(Random& random, bool has_opposed) {
  for (;;) {
    Cubes out = random_cubes(random);
    if (is_manifold(out) && has_opposed_faces(out) == has_opposed) return out;
  }
}

std::string text_of(const Cubes& cubes) {
  std::string out;
  for (const Cube& c : cubes) out += (out.empty() ? "" : "; ") + text_of(c);
  return out;
}

// Moved unit cubes.
std::vector<Map> cells_of(const Cubes& cubes, const std::array<int, 3>& degrees, double share,
                          Random& random, Model& model) {
  MovedLattice lattice(degrees, share, random);
  std::vector<Map> out;
  for (const Cube& cube : cubes) out.push_back(lattice.cell(cube));
  model.description += "cubes " + text_of(cubes) + ", degrees " + text_of(degrees) + ", share " +
                       std::to_string(share);
  return out;
}
double random_share(Random& random) {
  return random.below(5) == 0 ? 0.0 : 0.2 + 0.77 * random.unit();
}
// Mostly low ones: N has three times the degrees.
std::array<int, 3> usual_degrees(Random& random) {
  return random_degrees(random, 1, random.below(4) == 0 ? 3 : 2);
}
bool is_low(const std::array<int, 3>& degrees) {
  return *std::max_element(degrees.begin(), degrees.end()) < 3;
}

// ---- Rings and helices

// A curve in the plane around 0, homogeneous: control points and weights.
struct Arc {
  std::array<std::array<Rational, 2>, 3> p;
  std::array<Rational, 3> w;
};
// n arcs that close.
std::vector<Arc> random_arcs(std::size_t n, bool is_rational, Random& random) {
  std::vector<Arc> out;
  if (is_rational) {
    // (1 - t^2, 2 t, 1 + t^2) on parts of [0, 1], and its turns by 90 degrees: blossoms at the ends.
    std::array<std::vector<Rational>, 4> cuts;
    for (auto& c : cuts) c = {Rational(0), Rational(1)};
    for (std::size_t i = 4; i < n; ++i) {
      auto& c = cuts[random.below(4)];
      const std::size_t at = random.below(c.size() - 1);
      const Rational t = c[at] + (c[at + 1] - c[at]) * ratio(random.between(3, 5), 8);
      c.insert(c.begin() + static_cast<std::ptrdiff_t>(at) + 1, t);
    }
    for (std::size_t turn = 0; turn < 4; ++turn)
      for (std::size_t i = 0; i + 1 < cuts[turn].size(); ++i) {
        Arc arc;
        const std::array<Rational, 2> t{cuts[turn][i], cuts[turn][i + 1]};
        for (std::size_t k = 0; k < 3; ++k) {
          const Rational &a = t[k / 2], &b = t[(k + 1) / 2];
          std::array<Rational, 2> p{Rational(1) - a * b, a + b};
          for (std::size_t r = 0; r < turn; ++r) p = {-p[1], p[0]};
          arc.p[k] = p;
          arc.w[k] = Rational(1) + a * b;
        }
        out.push_back(arc);
      }
    return out;
  }
  std::vector<std::array<Rational, 2>> ends;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 *
                         (static_cast<double>(i) + 0.4 * (random.unit() - 0.5)) /
                         static_cast<double>(n);
    ends.push_back({ratio(std::lround(64 * std::cos(angle)), 64),
                    ratio(std::lround(64 * std::sin(angle)), 64)});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = ends[i], &b = ends[(i + 1) % n];
    const Rational s = ratio(random.between(9, 16), 16), t = ratio(random.between(9, 16), 16);
    VT_CHECK(a[0] * b[1] - a[1] * b[0] > Rational(0), "neighbours are less than 180 degrees apart");
    out.push_back({{a, {s * a[0] + t * b[0], s * a[1] + t * b[1]}, b},
                   {Rational(1), Rational(1), Rational(1)}});
  }
  return out;
}

BezierCurve<Rational> scaled_curve(BezierCurve<Rational> c, const Rational& by) {
  for (Rational& x : c.coefficients()) x *= by;
  return c;
}

// (rho, h) of degrees (p, q).
struct Section {
  int p = 1, q = 1;
  std::vector<std::array<Rational, 2>> at;  // i (q + 1) + j
};
Section random_section(double share, Random& random) {
  Section out;
  out.p = static_cast<int>(random.between(1, 2));
  out.q = static_cast<int>(random.between(1, 2));
  const Rational inner = ratio(random.between(5, 16), 8);
  const auto steps = static_cast<std::int64_t>(share / (2 * (out.p + out.q)) * 4096);
  for (int i = 0; i <= out.p; ++i)
    for (int j = 0; j <= out.q; ++j)
      out.at.push_back({inner + ratio(i, out.p) + ratio(random.between(-steps, steps), 4096),
                        ratio(j, out.q) + ratio(random.between(-steps, steps), 4096)});
  return out;
}

// rho(u, w) c(v), h(u, w) + begin + (end - begin) v; the last axis is the section's second one.
Map turned_section(const Section& section, const Arc& arc, const Rational& begin,
                   const Rational& end, bool is_rational) {
  const bool rises = begin != end;
  const int degree = is_rational && rises ? 3 : 2;
  const BezierCurve<Rational> line({1}, 1, false, {begin, end}), zero({degree}, 1, false);
  const auto curve = [](std::vector<Rational> values) {
    return BezierCurve<Rational>({2}, 1, false, std::move(values));
  };
  const auto raised = [&](const BezierCurve<Rational>& c) { return sum(c, zero); };
  const auto x = raised(curve({arc.p[0][0], arc.p[1][0], arc.p[2][0]})),
             y = raised(curve({arc.p[0][1], arc.p[1][1], arc.p[2][1]})),
             w = raised(curve({arc.w[0], arc.w[1], arc.w[2]})),
             z = raised(is_rational
                            ? (rises ? multiplied(line, curve({arc.w[0], arc.w[1], arc.w[2]}))
                                     : scaled_curve(w, begin))
                            : line);
  Map out({section.p, degree, section.q}, is_rational ? 4 : 3, is_rational);
  const Grid<3> grid = out.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    const auto& [rho, h] = section.at[at[0] * index_of(section.q + 1) + at[2]];
    const Rational& weight = w.component(0)[at[1]];
    out.component(0)[n] = rho * x.component(0)[at[1]];
    out.component(1)[n] = rho * y.component(0)[at[1]];
    out.component(2)[n] = h * weight + z.component(0)[at[1]];
    if (is_rational) out.component(3)[n] = weight;
  }
  return out;
}

struct Helix {
  std::vector<Map> cells;
  bool is_rational = false;
};
// `count` cells, n a turn, which rises by `pitch`.
Helix random_helix(const Section& section, std::size_t n, std::size_t count, const Rational& pitch,
                   bool is_rational, Random& random) {
  const std::vector<Arc> arcs = random_arcs(n, is_rational, random);
  std::vector<Rational> heights;  // of one turn
  for (std::size_t i = 0; i < n; ++i)
    heights.push_back(pitch *
                      ratio(static_cast<std::int64_t>(8 * i) + (i == 0 ? 0 : random.between(-2, 2)),
                            static_cast<std::int64_t>(8 * n)));
  const auto height = [&](std::size_t i) { return heights[i % n] + pitch * Rational(i / n); };
  Helix out;
  out.is_rational = is_rational;
  for (std::size_t i = 0; i < count; ++i)
    out.cells.push_back(
        turned_section(section, arcs[i % n], height(i), height(i + 1), is_rational));
  return out;
}
KnownSolid chain_numbers(std::size_t cells, bool is_closed) {
  KnownSolid out;
  const std::size_t walls = cells + (is_closed ? 0 : 1);
  out.genus = {is_closed ? 1 : 0};
  out.bodies = 1;
  out.v_surfaces = 4 * cells + walls;
  out.v_curves = 4 * cells + 4 * walls;
  out.v_points = 4 * walls;
  return out;
}

// Polynomial cells in a row along v as one cell with knots of full multiplicity.
VVolume in_one(const std::vector<Map>& cells) {
  BezierPieces<Rational, 3> pieces;
  pieces.breaks[0] = pieces.breaks[2] = {Rational(0), Rational(1)};
  std::vector<Rational> inner;
  for (std::size_t i = 0; i <= cells.size(); ++i) {
    pieces.breaks[1].emplace_back(i);
    if (i > 0 && i < cells.size()) inner.emplace_back(i);
  }
  pieces.pieces = cells;
  return without_knots(joined(pieces), 1, inner).value();
}

// ---- Blocks

using Box = std::array<Point, 2>;
// A box as one cell, whose inner control points are moved as a lattice's are.
Map block(const Box& box, Random& random) {
  const auto degrees = random_degrees(random, 1, 2);
  const double share = 0.2 + 0.7 * random.unit();
  MovedLattice lattice(degrees, share, random);
  Map out = lattice.cell({0, 0, 0});
  const Grid<3> grid = out.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    bool is_inner = true;
    for (std::size_t a = 0; a < 3; ++a)
      is_inner = is_inner && at[a] > 0 && at[a] < index_of(degrees[a]);
    for (std::size_t a = 0; a < 3; ++a) {
      Rational& x = out.component(static_cast<int>(a))[n];
      if (!is_inner) x = ratio(static_cast<std::int64_t>(at[a]), degrees[a]);
      x = box[0][a] + (box[1][a] - box[0][a]) * x;
    }
  }
  return out;
}
std::string text_of(const Box& box) {
  std::string out = "[";
  for (std::size_t a = 0; a < 3; ++a)
    out += (a == 0 ? "" : " x ") + box[0][a].to_string() + ".." + box[1][a].to_string();
  return out + "]";
}
// The trilinear cell corner + a e0 + b e1 + c e2.
Map parallelepiped(const Point& corner, const std::array<Point, 3>& edges) {
  Map out({1, 1, 1}, 3, false);
  for (std::size_t n = 0; n < 8; ++n) {
    const auto at = out.grid().index_of(n);
    for (std::size_t c = 0; c < 3; ++c) {
      Rational x = corner[c];
      for (std::size_t e = 0; e < 3; ++e)
        if (at[e] == 1) x += edges[e][c];
      out.component(static_cast<int>(c))[n] = x;
    }
  }
  return out;
}
Rational random_depth(Random& random) {
  return Rational::power_of_two(-random.between(1, 30)) * ratio(random.between(4, 7), 4);
}
Rational part(Random& random, int low, int high) { return ratio(random.between(low, high), 16); }

const Box kUnitBox{Point{Rational(0), Rational(0), Rational(0)},
                   Point{Rational(1), Rational(1), Rational(1)}};

// ---- Folds

template <typename Number>
Number det3(const std::array<std::array<Number, 3>, 3>& m) {
  Number out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    out += m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
  }
  return out;
}
template <typename Number>
std::array<std::array<Number, 3>, 3> derivatives_at(const Bezier<Number, 3>& map,
                                                    const std::array<Number, 3>& at) {
  std::array<std::array<Number, 3>, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto d = evaluate(derivative(map, a), at);
    for (std::size_t c = 0; c < 3; ++c) out[a][c] = d[c];
  }
  return out;
}
// N of map + t shift at a point is linear in t, as the shift has one direction e there: d(shift) = e grad^T has rank 1.
template <typename Number>
std::array<Number, 2> linear_n(const Bezier<Number, 3>& map, const Bezier<Number, 3>& bump,
                               const std::array<Number, 3>& direction,
                               const std::array<Number, 3>& at) {
  auto d = derivatives_at(map, at);
  const Number n = det3(d);
  for (std::size_t a = 0; a < 3; ++a) {
    const Number slope = evaluate(derivative(bump, a), at)[0];
    for (std::size_t c = 0; c < 3; ++c) d[a][c] = d[a][c] + slope * direction[c];
  }
  return {n, det3(d) - n};
}
Bezier<double, 3> in_doubles(const Map& map) {
  Bezier<double, 3> out(map.degrees(), map.num_components(), false);
  for (std::size_t i = 0; i < map.coefficients().size(); ++i)
    out.coefficients()[i] = nearest_double(map.coefficients()[i]);
  return out;
}
// The inner parameter at which N vanishes first as t > 0 grows, roughly: least on a grid, then shrinking steps.
std::array<double, 3> first_zero(const Map& map, const Scalar& bump, const Point& direction) {
  const Bezier<double, 3> m = in_doubles(map), b = in_doubles(bump);
  std::array<double, 3> e;
  for (std::size_t c = 0; c < 3; ++c) e[c] = nearest_double(direction[c]);
  const auto time = [&](const std::array<double, 3>& at) {
    for (const double x : at)
      if (!(x > 0.03 && x < 0.97)) return 1e300;
    const auto [n, slope] = linear_n(m, b, e, at);
    return slope < 0 ? -n / slope : 1e300;
  };
  std::array<double, 3> best{0.5, 0.5, 0.5};
  double least = 1e300;
  for (int i = 1; i < 8; ++i)
    for (int j = 1; j < 8; ++j)
      for (int k = 1; k < 8; ++k) {
        const std::array<double, 3> at{i / 8.0, j / 8.0, k / 8.0};
        if (const double t = time(at); t < least) least = t, best = at;
      }
  for (double step = 1 / 16.0; step > 0x1p-26; step /= 2)
    for (bool moves = true; moves;) {
      moves = false;
      for (int n = 0; n < 27; ++n) {
        auto at = best;
        at[0] += step * (n % 3 - 1), at[1] += step * (n / 3 % 3 - 1), at[2] += step * (n / 9 - 1);
        if (const double t = time(at); t < least) least = t, best = at, moves = true;
      }
    }
  return best;
}

}  // namespace

std::vector<VVolume> affine_image(const std::vector<VVolume>& cells, const AffineMap& map) {
  std::vector<VVolume> out;
  for (const VVolume& cell : cells) out.push_back(transformed(cell, map));
  return out;
}
Rational determinant(const AffineMap& map) {
  std::array<Point, 3> rows;
  for (std::size_t i = 0; i < 9; ++i) rows[i / 3][i % 3] = map.linear[i];
  return det3(rows);
}
AffineMap random_affine_map(Random& random) {
  for (;;) {
    AffineMap out{3, 3, std::vector<Rational>(9), std::vector<Rational>(3)};
    for (Rational& x : out.linear) x = ratio(random.between(-16, 16), 16);
    for (Rational& x : out.translation) x = ratio(random.between(-64, 64), 16);
    if (abs(determinant(out)) > ratio(1, 4)) return out;
  }
}

Model grid(Random& random) {
  Cube size;
  do size = random_degrees(random, 1, 3);
  while (size[0] * size[1] * size[2] > 8);
  const bool is_one_cell = random.below(5) == 0;
  if (is_one_cell) size = {1, size[1], 1};
  const Cubes cubes = box_of(size);
  Model out;
  auto degrees = usual_degrees(random);
  if (cubes.size() > 4) degrees = random_degrees(random, 1, 2);
  auto cells = cells_of(cubes, degrees, random_share(random), random, out);
  if (is_low(degrees) && cubes.size() <= 4 && random.below(3) == 0) shear(cells, out, random);
  if (is_one_cell) {
    out.description += ", as one cell";
    out.cells = {in_one(cells)};
    out.solid = numbers_of({{0, 0, 0}});
    return out;
  }
  set_cells(out, cells);
  out.solid = numbers_of(cubes);
  return out;
}

Model polycube(Random& random) {
  const bool has_opposed = random.below(5) == 0;
  const Cubes cubes = random_manifold_cubes(random, has_opposed);
  Model out;
  const auto degrees = random_degrees(random, 1, 2);
  auto cells = cells_of(cubes, degrees, has_opposed ? 0.0 : random_share(random), random, out);
  if (!has_opposed && random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  out.solid = numbers_of(cubes);
  return out;
}

Model opposed(Random& random) {
  const Cubes cubes = random_manifold_cubes(random, true);
  Model out;
  auto cells =
      cells_of(cubes, random_degrees(random, 1, 2), 0.2 + 0.77 * random.unit(), random, out);
  if (random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  out.solid = numbers_of(cubes);
  return out;
}

Model ring(Random& random) {
  const bool is_rational = random.below(2) == 0;
  const std::size_t n = (is_rational ? 4 : 3) + random.below(4);
  const Section section = random_section(random_share(random), random);
  const std::vector<Arc> arcs = random_arcs(n, is_rational, random);
  Model out;
  out.description = "ring of " + std::to_string(n) + (is_rational ? " rational" : "") + " cells";
  std::vector<Map> cells;
  for (const Arc& arc : arcs)
    cells.push_back(turned_section(section, arc, Rational(0), Rational(0), is_rational));
  if (random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  out.solid = chain_numbers(n, true);
  return out;
}

Model helix(Random& random) {
  const bool is_rational = random.below(3) == 0;
  const std::size_t n = (is_rational ? 4 : 3) + random.below(2), count = n + random.below(n + 1);
  const Section section = random_section(random_share(random), random);
  Rational low = section.at[0][1], high = low;
  for (const auto& at : section.at) low = std::min(low, at[1]), high = std::max(high, at[1]);
  const Rational gap = Rational::power_of_two(-random.between(0, 6));
  Model out;
  out.description = "helix of " + std::to_string(count) + " cells, " + std::to_string(n) +
                    " a turn, gap at least " + gap.to_string();
  auto cells = random_helix(section, n, count, high - low + gap, is_rational, random).cells;
  if (!is_rational && random.below(4) == 0) shear(cells, out, random);
  set_cells(out, cells);
  out.solid = chain_numbers(count, false);
  return out;
}

Model primitive(Random& random) {
  const auto length = [&] { return ratio(random.between(1, 40), 16); };
  const Rational a = length(), b = length(), c = length();
  Model out;
  KnownSolid solid;
  solid.genus = {0};
  solid.bodies = 1;
  const auto set = [&](const char* what, Cells cells, std::array<std::uint64_t, 3> counts) {
    out.description =
        std::string(what) + " of " + a.to_string() + " " + b.to_string() + " " + c.to_string();
    out.cells = std::move(cells);
    solid.v_points = counts[0], solid.v_curves = counts[1], solid.v_surfaces = counts[2];
  };
  bool has_knots = false;
  switch (random.below(8)) {
    case 0:
      set("box", box_cells({Rational(0), Rational(0), Rational(0)}, {a, b, c}).value(), {8, 12, 6});
      break;
    case 1: set("cylinder", cylinder_cells(a, b).value(), {16, 32, 22}); break;
    case 2: set("frustum", cone_cells(a, b, c).value(), {16, 32, 22}); break;
    case 3:
      set("cone", cone_cells(a, Rational(0), c).value(), {9, 20, 17});
      solid.is_regular = false;
      break;
    case 4:
      set("torus", torus_cells(a + b, a).value(), {8, 20, 17});
      solid.genus = {1};
      has_knots = true;
      break;
    case 5: set("sphere", sphere_cells(a).value(), {16, 32, 24}); break;
    case 6:
      set("cell that is a cylinder", one_cell_cylinder(a, b).value(), {4, 6, 4});
      solid.is_regular = false;
      has_knots = true;
      break;
    default:
      set("cell that is a sphere", one_cell_sphere(a).value(), {2, 2, 2});
      solid.is_regular = false;
      has_knots = true;
      break;
  }
  if (!has_knots && random.below(4) == 0) {
    std::vector<Map> cells;
    for (const VVolume& cell : out.cells) cells.push_back(bezier_pieces(cell).pieces.front());
    shear(cells, out, random);
    out.cells.clear();
    set_cells(out, cells);
  }
  out.solid = std::move(solid);
  return out;
}

Model folded(Random& random) {
  Model out;
  const Cubes cubes = box_of({1, static_cast<int>(random.between(1, 2)), 1});
  const auto degrees =
      random.below(2) == 0 ? std::array<int, 3>{3, 3, 3} : random_degrees(random, 2, 3);
  auto cells = cells_of(cubes, degrees, 0.9 * random.unit(), random, out);
  out.folded_cell = random.below(cells.size());
  Map& cell = cells[out.folded_cell];
  const Grid<3> grid = cell.grid();
  Point direction;
  do
    for (Rational& x : direction) x = ratio(random.between(-8, 8), 8);
  while (direction == Point{});
  Scalar bump(degrees, 1, false);
  const bool one_point = random.below(2) == 0;
  bool is_moved = false;
  while (!is_moved)
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto at = grid.index_of(n);
      bool is_inner = true;
      for (std::size_t a = 0; a < 3; ++a)
        is_inner = is_inner && at[a] > 0 && at[a] < index_of(degrees[a]);
      if (!is_inner || (is_moved && one_point) || random.below(2) == 0) continue;
      bump.component(0)[n] = one_point ? Rational(1) : ratio(random.between(-4, 4), 4);
      is_moved = is_moved || bump.component(0)[n] != Rational(0);
    }
  const bool is_first = random.below(2) == 0;
  for (;;) {
    std::array<double, 3> near = first_zero(cell, bump, direction);
    if (!is_first)
      for (double& x : near) x = 0.0625 + 0.875 * random.unit();
    Point at;
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = Rational(static_cast<std::int64_t>(std::ldexp(near[a], 24))) *
              Rational::power_of_two(-24);
    const auto [n, slope] = linear_n(cell, bump, direction, at);
    if (!(slope < Rational(0))) {
      if (is_first) direction = {-direction[0], -direction[1], -direction[2]};
      continue;
    }
    // N = n + t slope = -2^-40 n, up to the rounding of t to a double.
    const Rational t = Rational::from_double(
        nearest_double(-n / slope * (Rational(1) + Rational::power_of_two(-40))));
    for (std::size_t k = 0; k < grid.count(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        cell.component(static_cast<int>(c))[k] += t * bump.component(0)[k] * direction[c];
    const Rational depth = -det3(derivatives_at(cell, at)) / n * Rational::power_of_two(40);
    VT_CHECK(abs(depth - Rational(1)) < ratio(1, 1000), "N is what was planned");
    out.negative_at = at;
    out.description += std::string(", folded") + (is_first ? " first" : "") + " at " +
                       at[0].to_string() + " " + at[1].to_string() + " " + at[2].to_string();
    break;
  }
  if (is_low(degrees) && random.below(3) == 0) shear(cells, out, random);
  if (random.below(3) == 0) {
    out.description += ", as one cell";
    out.cells = {in_one(cells)};
    (*out.negative_at)[1] += Rational(out.folded_cell);
    out.folded_cell = 0;
    return out;
  }
  set_cells(out, cells);
  return out;
}

Model overlapping(Random& random) {
  Model out;
  const Rational depth = random_depth(random);
  std::vector<Map> cells;
  switch (random.below(5)) {
    case 0: {
      // The first and the last cell share a part of the turn, on which the section is the same square.
      const bool is_rational = random.below(3) == 0;
      const std::size_t n = (is_rational ? 4 : 3) + random.below(2),
                        count = n + 1 + random.below(2);
      const Section section = random_section(0, random);
      cells = random_helix(section, n, count, Rational(1) - depth, is_rational, random).cells;
      out.description = "helix of " + std::to_string(count) + " cells, " + std::to_string(n) +
                        " a turn, depth " + depth.to_string();
      if (!is_rational && random.below(3) == 0) shear(cells, out, random);
      if (!is_rational && random.below(2) == 0) {
        out.description += ", as one cell";
        out.cells = {in_one(cells)};
      } else {
        set_cells(out, cells);
      }
      return out;
    }
    case 1: {
      // Along one to three axes the second begins so much before the first ends.
      Box other;
      const std::size_t axes = 1 + random.below(3), first = random.below(3);
      for (std::size_t a = 0; a < 3; ++a) {
        other[0][a] = (a + 3 - first) % 3 < axes ? Rational(1) - depth : part(random, -4, 12);
        other[1][a] = other[0][a] + part(random, 8, 24) + depth;
      }
      cells = {block(kUnitBox, random), block(other, random)};
      out.description = "blocks " + text_of(kUnitBox) + " and " + text_of(other);
      break;
    }
    case 2: {
      Box inner;
      for (std::size_t a = 0; a < 3; ++a) {
        inner[0][a] = part(random, 1, 7);
        inner[1][a] = inner[0][a] + depth;
      }
      cells = {block(kUnitBox, random), block(inner, random)};
      out.description = "block " + text_of(inner) + " in " + text_of(kUnitBox);
      break;
    }
    case 3: {
      cells = cells_of(box_of({1, 1, 1}), random_degrees(random, 1, 2), random_share(random),
                       random, out);
      cells.push_back(cells[0]);
      out.description += ", twice";
      break;
    }
    default: {
      // The image of the cube holds that of its centre and what is nearer to it than 0.44.
      cells = cells_of(box_of({1, 1, 1}), random_degrees(random, 1, 2), 0.12 * random.unit(),
                       random, out);
      Map copy = cells[0];
      const std::size_t axes = 1 + random.below(3), first = random.below(3);
      const Rational by = depth < ratio(1, 4) ? depth : depth / Rational(2);
      for (std::size_t a = 0; a < 3; ++a)
        if ((a + 3 - first) % 3 < axes)
          for (Rational& x : copy.component(static_cast<int>(a))) x += by;
      cells.push_back(copy);
      out.description +=
          ", twice, moved along " + std::to_string(axes) + " axes from " + std::to_string(first);
      break;
    }
  }
  out.description += ", depth " + depth.to_string();
  if (random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  return out;
}

namespace {

void finish_touching(Model& out, std::vector<Map> cells, Random& random) {
  if (random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  if (random.below(2) == 0) std::reverse(out.cells.begin(), out.cells.end());
}

}  // namespace

Model touching_at_sides(Random& random) {
  Model out;
  const Rational zero(0), one(1), two(2), low = part(random, 1, 7), high = part(random, 9, 15);
  std::vector<Map> cells{block(kUnitBox, random)};
  Box other{Point{one, zero, zero}, Point{two, one, one}};
  switch (random.below(6)) {
    case 0: other[1][1] = high; break;                                         // along three sides
    case 1: other[1][1] = high, other[0][2] = low; break;                      // along two
    case 2: other[1][1] = high, other[0][2] = low, other[1][2] = high; break;  // along one
    case 3: other[0][1] = one, other[1][1] = two, other[0][2] = low; break;  // in a part of an edge
    case 4: other[0][1] = low, other[1][1] = two, other[0][2] = one, other[1][2] = two; break;
    default: break;
  }
  if (other[1] == Point{two, one, one} && other[0] == Point{one, zero, zero}) {
    // The whole face, with another parameter: y = v + a v (1 - v).
    const Rational a = part(random, 2, 12);
    Map cell({1, 2, 1}, 3, false);
    for (std::size_t n = 0; n < cell.grid().count(); ++n) {
      const auto at = cell.grid().index_of(n);
      cell.component(0)[n] = one + Rational(at[0]);
      cell.component(1)[n] = at[1] == 1 ? (one + a) / two : Rational(at[1] / 2);
      cell.component(2)[n] = Rational(at[2]);
    }
    cells.push_back(cell);
    out.description = "unit cubes, the second with a quadratic parameter, " + a.to_string();
  } else {
    cells.push_back(block(other, random));
    out.description = "blocks " + text_of(kUnitBox) + " and " + text_of(other);
  }
  finish_touching(out, std::move(cells), random);
  return out;
}

Model touching_inside(Random& random) {
  Model out;
  const Rational one(1), two(2), low = part(random, 1, 7), high = part(random, 9, 15);
  std::vector<Map> cells{block(kUnitBox, random)};
  const auto cone = [&] {  // edges that lead away from x <= 1
    return std::array<Point, 3>{Point{one, ratio(-1, 2), ratio(-1, 4)},
                                Point{one, ratio(3, 4), ratio(-1, 4)},
                                Point{one, part(random, 0, 4), ratio(3, 4)}};
  };
  switch (random.below(4)) {
    case 0: {
      const Box other{Point{one, low, part(random, 1, 7)}, Point{two, high, part(random, 9, 15)}};
      cells.push_back(block(other, random));
      out.description = "block " + text_of(other) + " on a face of the unit cube";
      break;
    }
    case 1:
      cells.push_back(parallelepiped({one, low, high}, cone()));
      out.description = "corner in a face";
      break;
    case 2:
      cells.push_back(parallelepiped({one, one, low}, cone()));
      out.description = "corner in an edge";
      break;
    default: {
      // x + y >= 2 on the second, with equality in an edge from (3/2, 1/2) to (1/2, 3/2); <= 2 on the cube.
      const Point corner{ratio(3, 2), ratio(1, 2), low};
      cells.push_back(
          parallelepiped(corner, {Point{Rational(-1), one, Rational(0)},
                                  Point{one, one, Rational(-1)}, Point{one, one, one}}));
      out.description = "edge across an edge";
      break;
    }
  }
  out.description += " at " + low.to_string() + " " + high.to_string();
  finish_touching(out, std::move(cells), random);
  return out;
}

Model non_manifold(Random& random) {
  Cubes cubes;
  switch (random.below(4)) {
    case 0: cubes = {{0, 0, 0}, {1, 1, 0}}; break;
    case 1: cubes = {{0, 0, 0}, {1, 1, 1}}; break;
    default:
      do cubes = random_cubes(random);
      while (is_manifold(cubes));
  }
  Model out;
  auto cells = cells_of(cubes, random_degrees(random, 1, 2), random_share(random), random, out);
  if (random.below(3) == 0) shear(cells, out, random);
  set_cells(out, cells);
  std::size_t number = 0;
  for (const Cube& cube : cubes) {
    for (std::size_t edge = 0; edge < 12; ++edge) {
      const auto others = v_face_axes(edge / 4);
      Cube vertex = cube;
      vertex[others[0]] += static_cast<int>(edge & 1),
          vertex[others[1]] += static_cast<int>(edge >> 1 & 1);
      if (is_bad_edge(cubes, vertex, edge / 4)) out.bad_edges.insert({number, edge});
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Cube vertex = cube;
      for (std::size_t a = 0; a < 3; ++a) vertex[a] += static_cast<int>(corner >> a & 1);
      if (is_bad_vertex(cubes, vertex)) out.bad_corners.insert({number, corner});
    }
    ++number;
  }
  return out;
}

}  // namespace veritope::random_v_models
