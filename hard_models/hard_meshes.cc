// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "hard_models/hard_mesh.h"
#include "hard_models/mesh_shapes_internal.h"
#include "robust/base/random.h"
#include "robust/rational.h"

namespace veritope::hard_models {
namespace {

using namespace internal;

constexpr double kUlp = 0x1p-52;                                      // of 1
constexpr double kLeast = std::numeric_limits<double>::denorm_min();  // 2^-1074
constexpr double kGreatest = std::numeric_limits<double>::max();
constexpr double kAbove = 1 + kUlp, kBelow = 1 - kUlp / 2;  // the neighbours of 1
const Vec3d kSame{1, 1, 1}, kOrigin{0, 0, 0};

// The number of places where one rule is broken.
struct Broken {
  int rule, times;
};

class MeshList {
 public:
  void valid(std::string name, std::string what, TriangleMesh mesh, int bodies = 1, int genus = 0) {
    models_.push_back({std::move(name), std::move(what), std::move(mesh), {}, bodies, genus});
  }
  void broken(std::string name, std::string what, TriangleMesh mesh,
              std::initializer_list<Broken> rules) {
    HardMesh model{std::move(name), std::move(what), std::move(mesh)};
    for (const Broken& b : rules) model.breaks[static_cast<std::size_t>(b.rule - 1)] = b.times;
    models_.push_back(std::move(model));
  }
  std::vector<HardMesh> take() { return std::move(models_); }

 private:
  std::vector<HardMesh> models_;
};

TriangleMesh with_face(TriangleMesh mesh, std::array<std::uint32_t, 3> face) {
  mesh.faces.push_back(face);
  return mesh;
}
TriangleMesh without_face(TriangleMesh mesh, std::size_t face) {
  mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(face));
  return mesh;
}
TriangleMesh with_turned_face(TriangleMesh mesh, std::size_t face) {
  std::swap(mesh.faces[face][1], mesh.faces[face][2]);
  return mesh;
}
TriangleMesh with_vertex_at(TriangleMesh mesh, std::size_t vertex, const Vec3d& position) {
  mesh.positions[vertex] = position;
  return with_distinct_positions(mesh);
}
// One corner of one face alone is moved: a crack along two edges.
TriangleMesh cracked(TriangleMesh mesh, std::size_t face, std::size_t corner,
                     const Vec3d& position) {
  mesh.positions.push_back(position);
  mesh.faces[face][corner] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  return mesh;
}
// The tetrahedron with the edges 2, 2, 2 whose edge along x is split at `middle` on one side; a face closes the gap.
TriangleMesh split_edge(const Vec3d& middle) {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, middle},
          {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}}};
}
TriangleMesh scaled(const TriangleMesh& mesh, double by, const Vec3d& shift = kOrigin) {
  return placed(mesh, {by, by, by}, shift);
}

void add_rules_1_to_3(MeshList& list) {
  const TriangleMesh tet = tetrahedron();
  list.valid("tetrahedron", "a tetrahedron", tet);
  list.broken("m1_repeated_corner", "a face has the same corner twice", with_face(tet, {0, 0, 1}),
              {{1, 1}});
  list.broken("m1_collinear", "a face without area closes a T-junction", split_edge({1, 0, 0}),
              {{1, 1}, {7, 2}});
  list.valid("m1_collinear_nearest_valid", "the face has an area of 2^-1074",
             split_edge({1, kLeast, 0}));

  const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  list.broken("m2_two_sides", "the two sides of one triangle", triangle, {{2, 1}, {7, 1}});
  list.valid("m2_two_sides_nearest_valid", "a tetrahedron of height 2^-1074",
             {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, kLeast}}, tet.faces});
  list.broken("m2_copied_face", "one face occurs twice", with_face(tet, {2, 3, 1}),
              {{2, 1}, {4, 3}, {7, 1}});
  list.broken("m2_copied_mesh", "every face occurs twice", joined({tet, tet}),
              {{2, 4}, {4, 6}, {7, 4}});

  list.broken("m3_one_triangle", "a triangle alone", {triangle.positions, {{0, 1, 2}}}, {{3, 3}});
  list.broken("m3_missing_face", "a tetrahedron without one face", without_face(tet, 3), {{3, 3}});
  list.broken("m3_crack_one_ulp", "one corner of one face is off by 2^-52",
              cracked(tet, 3, 0, {kAbove, 0, 0}), {{3, 4}});
  list.broken("m3_crack_least", "one corner of one face is off by 2^-1074",
              cracked(tet, 2, 0, {-kLeast, 0, 0}), {{3, 4}});
  list.broken("m3_t_junction", "an edge is split on one side only",
              without_face(split_edge({1, 0, 0}), 5), {{3, 3}, {7, 2}});
  list.valid("m3_t_junction_nearest_valid", "the edge is split on both sides",
             {split_edge({1, 0, 0}).positions,
              {{0, 2, 4}, {4, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
}

void add_rules_4_to_6(MeshList& list) {
  const TriangleMesh tet = tetrahedron(), mirror = placed(tet, {-1, -1, 1}, kOrigin);
  const TriangleMesh pyramids = bipyramid({1, 1, 4}, {1, 1, -4});
  list.valid("m4_wall_inside_nearest_valid", "two pyramids on one triangle", pyramids);
  list.broken("m4_wall_inside", "the triangle between the pyramids is a face, too",
              with_face(pyramids, {0, 1, 2}), {{4, 3}});
  list.broken("m4_common_edge", "two bodies have one edge in common", joined({tet, mirror}),
              {{4, 1}});
  list.valid("m4_common_edge_nearest_valid", "the edges are apart by 2^-1074",
             joined({tet, placed(mirror, kSame, {-kLeast, -kLeast, 0})}), 2);

  list.broken("m5_turned_face", "one face is turned", with_turned_face(tet, 3), {{5, 3}});
  list.broken("m5_one_sided", "a Moebius strip of five faces",
              {{{8, 0, 0}, {2, 7, 3}, {-7, 4, -4}, {-7, -5, 5}, {2, -8, -3}},
               {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}},
              {{3, 5}, {5, 5}});

  const TriangleMesh opposite = placed(tet, {-1, -1, -1}, kOrigin);
  list.broken("m6_common_vertex", "two bodies have one vertex in common", joined({tet, opposite}),
              {{6, 1}});
  list.valid("m6_common_vertex_nearest_valid", "the vertices are apart by 2^-1074",
             joined({tet, placed(opposite, kSame, {-kLeast, -kLeast, -kLeast})}), 2);
}

// A spike whose tip is one ulp above a block's upper side, on it, or one ulp below it.
void add_spikes(MeshList& list) {
  const TriangleMesh block = box({0, 0, -1}, {4, 4, 1});
  struct Place {
    std::string name, where;
    double x, y;
    std::initializer_list<Broken> touching, crossing;
  };
  const Place places[] = {{"face", "a face", 3, 1, {{7, 3}}, {{7, 3}}},
                          {"diagonal", "an edge in a flat side", 2, 2, {{7, 6}}, {{7, 6}}},
                          {"edge", "an edge", 4, 2, {{7, 6}}, {{7, 6}}},
                          {"vertex", "a vertex", 4, 4, {{6, 1}}, {{7, 12}}}};
  for (const Place& p : places) {
    const auto with_tip_at = [&](double z) { return joined({block, spike({p.x, p.y, z})}); };
    const std::string name = "spike_at_" + p.name;
    list.valid(name + "_apart", "a vertex is one ulp above " + p.where + " of another body",
               with_tip_at(kAbove), 2);
    list.broken(name + "_touching", "a vertex lies on " + p.where + " of another body",
                with_tip_at(1), p.touching);
    list.broken(name + "_crossing", "a vertex is one ulp inside another body, below " + p.where,
                with_tip_at(kBelow), p.crossing);
  }
}

// Two ridges, one along x from below and one along y from above.
void add_edges(MeshList& list) {
  const TriangleMesh lower{{{-1, 0, 1}, {1, 0, 1}, {0, 1, 0}, {0, -1, 0}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
  const auto upper = [](double z) {
    return TriangleMesh{{{0, -1, z}, {0, 1, z}, {1, 0, 2}, {-1, 0, 2}},
                        {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}}};
  };
  list.valid("edges_apart", "two edges are one ulp apart", joined({lower, upper(kAbove)}), 2);
  list.broken("edges_touching", "two edges have one point in common", joined({lower, upper(1)}),
              {{7, 4}});
  list.broken("edges_crossing", "an edge is one ulp inside another body",
              joined({lower, upper(kBelow)}), {{7, 4}});
  const TriangleMesh along = placed(lower, {1, 1, -1}, {1, 0, 2});
  list.broken("edges_overlapping", "two edges lie on one line and overlap", joined({lower, along}),
              {{7, 8}});
  list.valid("edges_overlapping_nearest_valid", "the lines are one ulp apart",
             joined({lower, placed(lower, {1, 1, -1}, {1, 0, 2 + 2 * kUlp})}), 2);
}

void add_intersections(MeshList& list) {
  const TriangleMesh tet = tetrahedron();
  list.broken("m7_crossing", "two faces cross", bipyramid({1, 1, 4}, {4, 4, 1}), {{7, 2}});
  list.valid("m7_crossing_nearest_valid", "the same faces without the crossing",
             bipyramid({1, 1, 4}, {1, 1, 1}));
  list.broken("m7_flat", "a tetrahedron in one plane",
              {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}}, tet.faces}, {{7, 3}});
  list.broken("m7_crossing_bodies", "two bodies cross",
              joined({scaled(tet, 4), scaled(tet, 4, {1, 1, 0.5})}), {{7, 3}});

  const TriangleMesh low = box({0, 0, 0}, {2, 2, 1});
  const auto high = [](double z) { return box({1, 1, z}, {3, 3, 2}); };
  list.valid("walls_apart", "two parallel walls are one ulp apart", joined({low, high(kAbove)}), 2);
  list.broken("walls_touching", "two walls lie in one plane and overlap", joined({low, high(1)}),
              {{7, 22}});
  list.broken("walls_crossing", "two bodies overlap by one ulp", joined({low, high(kBelow)}),
              {{7, 14}});
  list.broken("walls_equal", "two bodies have one wall in common",
              joined({low, box({0, 0, 1}, {2, 2, 2})}), {{2, 2}, {4, 5}, {7, 2}});
  list.broken("copy_one_ulp_aside", "two bodies are equal but for a shift of one ulp",
              joined({box({1, 1, 1}, {2, 2, 2}),
                      box({kAbove, kAbove, kAbove}, {2 + 2 * kUlp, 2 + 2 * kUlp, 2 + 2 * kUlp})}),
              {{7, 18}});
}

void add_shells(MeshList& list) {
  const TriangleMesh tet = tetrahedron(), outer = scaled(tet, 8), inner = scaled(tet, 1, kSame);
  list.broken("m8_inside_out", "all faces point inward", reversed(tet), {{8, 1}});
  list.broken("m8_one_of_two", "one of two bodies is inside out",
              joined({tet, reversed(scaled(tet, 1, {3, 0, 0}))}), {{8, 1}});
  list.broken("m9_cavity_turned", "a cavity points outward", joined({outer, inner}), {{9, 1}});
  list.valid("m9_cavity_turned_nearest_valid", "a body with a cavity",
             joined({outer, reversed(inner)}));
  list.broken("m9_inside_out", "a body with a cavity is inside out",
              joined({reversed(outer), inner}), {{8, 1}, {9, 1}});

  const TriangleMesh first = scaled(tet, 64), second = scaled(tet, 32, {4, 4, 4}),
                     third = scaled(tet, 8, {6, 6, 6});
  list.valid("nested_three", "a body in the cavity of another",
             joined({first, reversed(second), third}), 2);
  list.broken("nested_three_middle_turned", "the cavity points outward",
              joined({first, second, third}), {{9, 1}});
  list.broken("nested_three_inner_turned", "the body in the cavity is inside out",
              joined({first, reversed(second), reversed(third)}), {{9, 1}});

  const TriangleMesh body = box({0, 0, 0}, {4, 4, 4});
  const auto cavity = [](double top) { return reversed(box({1, 1, 1}, {3, 3, top})); };
  list.valid("cavity_apart", "a cavity is one ulp below the outer wall",
             joined({body, cavity(4 - 2 * kUlp)}));
  list.broken("cavity_touching", "a cavity touches the outer wall from inside",
              joined({body, cavity(4)}), {{7, 18}});
  list.broken("cavity_crossing", "a cavity is one ulp higher than the outer wall",
              joined({body, cavity(4 + 4 * kUlp)}), {{7, 12}});
}

void add_thin_walls_and_needles(MeshList& list) {
  const TriangleMesh tet = tetrahedron();
  list.valid("plate_one_ulp", "a plate of thickness 2^-52", box({0, 0, 1}, {1, 1, kAbove}));
  list.valid("plate_least", "a plate of thickness 2^-1074", box({0, 0, 0}, {1, 1, kLeast}));
  list.broken("plate_without_thickness", "the two sides of a plate are one",
              with_distinct_positions(box({0, 0, 1}, {1, 1, 1})), {{1, 8}, {2, 2}, {4, 1}, {7, 2}});
  const auto cube = [](double half) { return box({-half, -half, -half}, {half, half, half}); };
  list.valid("shell_one_ulp", "a hollow cube with walls of 2^-53",
             joined({cube(1), reversed(cube(kBelow))}));
  list.broken("shell_without_walls", "the outer and the inner side of a hollow cube are one",
              joined({cube(1), reversed(cube(1))}), {{2, 12}, {4, 18}, {7, 12}});
  list.broken("shell_turned", "the outer side of a hollow cube lies inside its inner side",
              joined({cube(1), reversed(cube(kAbove))}), {{8, 1}, {9, 1}});
  list.valid("needle", "a tetrahedron with edges of 2^200, 2^-200 and 1",
             placed(tet, {0x1p200, 0x1p-200, 1}, kOrigin));
  list.valid("mixed_scales", "a tetrahedron with edges of 1e300, 1 and 2^-1074",
             placed(tet, {1e300, 1, kLeast}, kOrigin));
  list.valid("sliver_one_ulp", "a tetrahedron whose height is one ulp",
             {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1.25, 1.25, kAbove}}, tet.faces});
  list.broken("sliver_turned", "a tetrahedron whose height is minus one ulp",
              {{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1.25, 1.25, kBelow}}, tet.faces}, {{8, 1}});
  list.valid("cap", "a face whose middle corner is 2^-1074 from the line of the others",
             {{{-1, 0, 0}, {1, 0, 0}, {0, kLeast, 0}, {0, 0, 1}}, tet.faces});
  list.valid("whole_range", "a tetrahedron from end to end of binary64",
             {{{-kGreatest, -kGreatest, -kGreatest},
               {kGreatest, -kGreatest, -kGreatest},
               {-kGreatest, kGreatest, -kGreatest},
               {-kGreatest, -kGreatest, kGreatest}},
              tet.faces});
  list.valid("far_away", "a tetrahedron of size 1 at the distance 2^52",
             placed(tet, kSame, {0x1p52, -0x1p52, 0x1p52}));
}

void add_larger_shapes(MeshList& list) {
  list.valid("torus_7_vertices", "the torus with the fewest vertices", small_torus(), 1, 1);
  list.valid("frame", "a square ring", frame(), 1, 1);
  const TriangleMesh ball = sphere(4);
  const auto& face = ball.faces[0];
  const Vec3d p = ball.positions[face[0]];
  const auto times = [&](double by) { return Vec3d{p.x * by, p.y * by, p.z * by}; };
  list.valid("sphere", "a sphere of 128 faces", ball);
  list.broken("sphere_missing_face", "a sphere without one face", without_face(ball, 0), {{3, 3}});
  list.broken("sphere_turned_face", "one face of a sphere is turned", with_turned_face(ball, 0),
              {{5, 3}});
  list.broken("sphere_cracked", "one corner of one face of a sphere is off by one ulp",
              cracked(ball, 0, 0, times(kAbove)), {{3, 4}});
  list.broken("sphere_pushed_through", "one vertex of a sphere is on the other side of it",
              with_vertex_at(ball, face[0], times(-2)), {{7, 12}});
  list.broken("sphere_pushed_to_touch", "two opposite vertices of a sphere are one",
              with_vertex_at(ball, face[0], times(-1)), {{6, 1}});
  list.valid("sphere_pushed_nearly", "one vertex of a sphere is one ulp before the opposite one",
             with_vertex_at(ball, face[0], times(-kBelow)));
}

}  // namespace

bool is_valid(const HardMesh& model) {
  return std::all_of(model.breaks.begin(), model.breaks.end(), [](int n) { return n == 0; });
}

std::vector<HardMesh> plain_hard_meshes() {
  MeshList list;
  add_rules_1_to_3(list);
  add_rules_4_to_6(list);
  add_intersections(list);
  add_spikes(list);
  add_edges(list);
  add_shells(list);
  add_thin_walls_and_needles(list);
  add_larger_shapes(list);
  return list.take();
}

namespace {

// The exponents of the greatest coordinate and of the lowest bit of all coordinates that are not 0.
struct Exponents {
  int highest = std::numeric_limits<int>::min(), lowest = std::numeric_limits<int>::max();
};
Exponents exponents_of(const TriangleMesh& mesh) {
  Exponents e;
  for (const Vec3d& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0) continue;
      e.highest = std::max(e.highest, std::ilogb(p[axis]));
      // The lowest bit: shift the mantissa until it is odd.
      int exponent;
      auto bits =
          static_cast<std::uint64_t>(std::ldexp(std::fabs(std::frexp(p[axis], &exponent)), 53));
      exponent -= 53;
      for (; bits % 2 == 0; bits /= 2) ++exponent;
      e.lowest = std::min(e.lowest, exponent);
    }
  return e;
}
TriangleMesh times_power(const TriangleMesh& mesh, int exponent) {
  TriangleMesh out = mesh;
  for (Vec3d& p : out.positions)
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  return out;
}

// The image under a rotation times 3, whose matrix is that of thin_shapes::turned; nothing if a coordinate would be
// rounded.
std::optional<TriangleMesh> turned(const TriangleMesh& mesh) {
  constexpr int kTurn[3][3] = {{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}};
  TriangleMesh out = mesh;
  for (Vec3d& p : out.positions) {
    double image[3];
    for (int row = 0; row < 3; ++row) {
      Rational sum;
      for (int axis = 0; axis < 3; ++axis)
        sum += Rational(kTurn[row][axis]) * Rational::from_double(p[axis]);
      image[row] = nearest_double(sum);
      if (!std::isfinite(image[row]) || Rational::from_double(image[row]) != sum)
        return std::nullopt;
    }
    p = {image[0], image[1], image[2]};
  }
  return out;
}

TriangleMesh shuffled(const TriangleMesh& mesh, Random& random) {
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), 0u);
  const auto shuffle = [&](auto& items) {  // std::shuffle differs between libraries
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
  };
  shuffle(place);
  TriangleMesh out;
  out.positions.resize(mesh.positions.size());
  for (std::size_t v = 0; v < place.size(); ++v) out.positions[place[v]] = mesh.positions[v];
  for (std::array<std::uint32_t, 3> face : mesh.faces) {
    for (std::uint32_t& corner : face) corner = place[corner];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random.below(3)),
                face.end());
    out.faces.push_back(face);
  }
  shuffle(out.faces);
  return out;
}

}  // namespace

std::vector<HardMesh> hard_meshes(std::uint64_t seed) {
  constexpr int kHighest = std::numeric_limits<double>::max_exponent - 1;  // of a double: 1023
  constexpr int kLowest = -1074;
  Random random(seed);
  std::vector<HardMesh> out;
  for (HardMesh& model : plain_hard_meshes()) {
    const auto add = [&](const char* suffix, const char* how, TriangleMesh mesh) {
      out.push_back(model);
      out.back().name += suffix;
      out.back().what += how;
      out.back().mesh = std::move(mesh);
    };
    const TriangleMesh mesh = model.mesh;
    const Exponents e = exponents_of(mesh);
    add("", "", mesh);
    if (e.highest < kHighest - 1)
      add("_huge", "; scaled up to the end of binary64",
          times_power(mesh, kHighest - 1 - e.highest));
    if (e.lowest > kLowest)
      add("_tiny", "; scaled down to the end of binary64", times_power(mesh, kLowest - e.lowest));
    if (std::optional<TriangleMesh> image = turned(mesh))
      add("_oblique", "; with oblique faces", std::move(*image));
    add("_shuffled", "; in another order", shuffled(mesh, random));
  }
  return out;
}

}  // namespace veritope::hard_models
