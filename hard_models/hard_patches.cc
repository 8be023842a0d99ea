// SPDX-License-Identifier: LGPL-3.0-or-later
#include "hard_models/hard_patches.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

#include "models/patch_shapes.h"
#include "models/thin_shapes.h"
#include "robust/base/check.h"
#include "solids/patches/patch_transform.h"

namespace veritope::hard_models {
namespace {

namespace shapes = patch_shapes;
using Patches = std::vector<Patch>;
using Corner = PatchPoint;

const Rational kHalf = Rational(1) / Rational(2), kQuarter = Rational(1) / Rational(4);
const Rational kFar = Rational(3) / Rational(4);
// 10^-12, which no binary number of any length equals, and one ulp of 1.
const Rational kTrillionth = Rational(1) / Rational(1'000'000'000'000);
const Rational kUlpOfOne = Rational::power_of_two(-52);

class PatchList {
 public:
  void valid(std::string name, std::string what, Patches patches, int bodies = 1, int genus = 0) {
    models_.push_back({std::move(name), std::move(what), std::move(patches), true, Answer::kProved,
                       "", bodies, genus});
  }
  void invalid(std::string name, std::string what, Patches patches, std::string code) {
    models_.push_back({std::move(name), std::move(what), std::move(patches), false, Answer::kProved,
                       std::move(code)});
  }
  /// The last model is UNDECIDED for certify, with this reason.
  void undecided(std::string code) {
    models_.back().answer = Answer::kUndecided;
    models_.back().code = std::move(code);
  }
  std::vector<HardPatches> take() { return std::move(models_); }

 private:
  std::vector<HardPatches> models_;
};

Patches cube() { return shapes::box({0, 0, 0}, {1, 1, 1}); }
constexpr std::size_t kTop = 5;  // of a box: the face z = 1

// A box beside the unit cube that begins at x and has a smaller wall.
Patches beside_cube(const Rational& x) {
  return shapes::joined({cube(), shapes::box({x, kQuarter, kQuarter}, {2, kFar, kFar})});
}
// Two spheres of radius 1 whose middles have the distance 2 + gap.
Patches two_spheres(const Rational& gap) {
  const Patches ball = shapes::sphere();
  return shapes::joined({ball, shapes::placed(ball, 1, {Rational(2) + gap, 0, 0})});
}
// One above the other, with their poles 2 + gap - 2 apart.
Patches pole_to_pole(const Rational& gap) {
  const Patches ball = shapes::octant_sphere();
  return shapes::joined({ball, shapes::placed(ball, 1, {0, 0, Rational(2) + gap})});
}
// The patches with every control point at `from` moved to `to`. REQUIRES polynomial tensor patches.
Patches moved(Patches patches, const Corner& from, const Corner& to) {
  for (Patch& patch : patches) {
    Patch::Tensor map = patch.tensor();
    for (std::size_t i = 0; i < patch.num_control(); ++i) {
      bool is_there = true;
      for (int c = 0; c < 3; ++c)
        is_there = is_there && map.component(c)[i] == from[static_cast<std::size_t>(c)];
      if (!is_there) continue;
      for (int c = 0; c < 3; ++c) map.component(c)[i] = to[static_cast<std::size_t>(c)];
    }
    patch = make_patch(std::move(map), patch.origin()).value();
  }
  return patches;
}
// One bilinear patch; the corners are counterclockwise as seen from where its normal points.
Patches bilinear(const std::array<Corner, 4>& corners) {
  std::vector<Rational> control;
  for (std::size_t c = 0; c < 3; ++c)
    for (const std::size_t k : {0u, 3u, 1u, 2u}) control.push_back(corners[k][c]);  // v fastest
  return {make_patch(Patch::Tensor({1, 1}, 3, false, std::move(control))).value()};
}
// The first patches of the list.
Patches first(const Patches& patches, std::size_t count) {
  return {patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(count)};
}

// The top of the unit cube, of degree 2 along x, whose middle control points lie at x = middle.
Patches lid_with_middle(const Rational& middle) {
  const std::vector<Rational> control{0, 0, middle, middle, 1, 1,   // x
                                      0, 1, 0,      1,      0, 1,   // y
                                      1, 1, 1,      1,      1, 1};  // z
  return {make_patch(Patch::Tensor({2, 1}, 3, false, control)).value()};
}
// Two pyramids whose apex is the origin, with walls of four patches; the middle line of each wall is the apex.
Patches hourglass() {
  const std::array<Corner, 4> low{{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}}};
  const auto opposite = [](const Corner& p) { return Corner{-p[0], -p[1], -p[2]}; };
  Patches out;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = low[i], &b = low[(i + 1) % 4];
    out = shapes::joined({out, bilinear({a, b, opposite(b), opposite(a)})});
  }
  return shapes::joined(
      {out, bilinear({low[0], low[3], low[2], low[1]}),
       bilinear({opposite(low[0]), opposite(low[1]), opposite(low[2]), opposite(low[3])})});
}

void add_sides(PatchList& list) {
  const Patches whole = cube(), walls = first(whole, kTop);
  const Patches top{whole[kTop]};
  list.valid("cube", "a cube", whole);
  list.invalid("side_open", "a cube without its top", walls, "side-open");
  list.invalid("side_open_one_ulp", "one corner of the top of a cube is off by 2^-52",
               shapes::joined({walls, moved(top, {1, 1, 1}, {1, 1, Rational(1) + kUlpOfOne})}),
               "side-open");
  list.invalid("side_open_one_trillionth", "one corner of the top of a cube is off by 1e-12",
               shapes::joined({walls, moved(top, {1, 1, 1}, {1, 1, Rational(1) + kTrillionth})}),
               "side-open");
  list.invalid("side_direction", "the top of a cube is turned",
               shapes::joined({walls, shapes::reversed(top)}), "side-direction");
  list.invalid("side_overused", "two cubes have one edge in common",
               shapes::joined({whole, shapes::box({1, 1, 0}, {2, 2, 1})}), "side-overused");
  list.valid("side_overused_nearest_valid", "the edges are 1e-12 apart",
             shapes::joined({whole, shapes::box({1, Rational(1) + kTrillionth, 0}, {2, 2, 1})}), 2);
  list.valid("t_junction", "the top of a cube is cut in two, the walls are not",
             shapes::joined({walls,
                             bilinear({Corner{0, 0, 1}, Corner{kHalf, 0, 1}, Corner{kHalf, 1, 1},
                                       Corner{0, 1, 1}}),
                             bilinear({Corner{kHalf, 0, 1}, Corner{1, 0, 1}, Corner{1, 1, 1},
                                       Corner{kHalf, 1, 1}})}));
  list.undecided("side-t-junction");
  list.valid("parametrization", "one side of a cube's top has other parameters than the wall's",
             shapes::joined({walls, lid_with_middle(kQuarter)}));
  list.undecided("side-parametrization");
  list.valid("parametrization_nearest_valid", "the parameters are the same",
             shapes::joined({walls, lid_with_middle(kHalf)}));
}

void add_contacts_of_patches(PatchList& list) {
  const Rational one(1);
  list.valid("walls_apart", "two parallel walls are 1e-12 apart", beside_cube(one + kTrillionth),
             2);
  list.invalid("walls_touching", "two walls lie in one plane and overlap", beside_cube(1),
               "patches-touching");
  list.invalid("walls_crossing", "two boxes overlap by 1e-12", beside_cube(one - kTrillionth),
               "patches-crossing");
  const auto with_box = [](const Rational& at) {
    return shapes::joined({cube(), shapes::box({at, at, at}, {2, 2, 2})});
  };
  list.valid("vertices_apart", "two cubes are apart by 1e-12 in each coordinate",
             with_box(one + kTrillionth), 2);
  list.invalid("vertices_touching", "two cubes have one vertex in common", with_box(1),
               "patches-touching");
  list.invalid("vertices_crossing", "two cubes overlap by 1e-12 in each coordinate",
               with_box(one - kTrillionth), "patches-crossing");
  list.undecided("not-certified");
  const auto with_edge = [](const Rational& at) {
    return shapes::joined({cube(), shapes::box({at, at, kQuarter}, {2, 2, kFar})});
  };
  list.valid("edges_apart", "two parallel edges are apart by 1e-12 in two coordinates",
             with_edge(one + kTrillionth), 2);
  list.invalid("edges_touching", "an edge lies on an edge of another box", with_edge(1),
               "patches-touching");
  list.valid("spheres_apart", "two spheres are 1e-12 apart", two_spheres(kTrillionth), 2);
  list.invalid("spheres_touching", "two spheres touch in one point", two_spheres(0),
               "patches-touching");
  list.invalid("spheres_crossing", "two spheres overlap by 1e-12", two_spheres(-kTrillionth),
               "patches-crossing");
  list.valid("poles_apart", "the poles of two spheres are 1e-12 apart", pole_to_pole(kTrillionth),
             2);
  list.undecided("not-certified");
  list.invalid("poles_touching", "the poles of two spheres are one point", pole_to_pole(0),
               "patches-touching");
  list.invalid("poles_crossing", "two spheres overlap at their poles by 1e-12",
               pole_to_pole(-kTrillionth), "patches-crossing");
  list.invalid("torus_without_hole", "a torus whose hole is one point", shapes::torus(1, 1),
               "patches-touching");
  list.valid("torus_small_hole", "a torus whose hole has the radius 1e-12",
             shapes::torus(Rational(1) + kTrillionth, 1), 1, 1);
  list.undecided("not-certified");
  list.invalid("spindle_torus", "a torus that meets itself in two points of its axis",
               shapes::torus(1, 2), "patches-touching");
  list.undecided("singular-line");
}

void add_shells_of_patches(PatchList& list) {
  const Patches plate = thin_shapes::turned(thin_shapes::plate(kTrillionth, kTrillionth));
  list.invalid("shell_turned", "a cube is inside out", shapes::reversed(cube()), "shell-turned");
  list.invalid("shell_turned_thin", "an oblique plate of thickness 1e-12 is inside out",
               shapes::reversed(plate), "shell-turned");
  const Patches ball = shapes::sphere(), small = shapes::placed(ball, kHalf, {kQuarter, 0, 0});
  list.valid("cavity", "a sphere with a spherical cavity",
             shapes::joined({ball, shapes::reversed(small)}));
  list.invalid("cavity_turned", "the cavity points outward", shapes::joined({ball, small}),
               "shell-turned");
  list.invalid("patch_repeated", "the two sides of one patch",
               shapes::joined({Patches{cube()[kTop]}, shapes::reversed({cube()[kTop]})}),
               "patch-repeated");
  const Corner top{1, 1, 1};
  list.invalid("patch_degenerate", "a cube with a patch that is one point",
               shapes::joined({cube(), bilinear({top, top, top, top})}), "patch-degenerate");
  list.invalid("singular_line", "a line inside each wall of an hourglass is one point", hourglass(),
               "singular-line");
  list.invalid(
      "fold", "the top of a box runs to and fro in its plane",
      [] {
        for (shapes::Shape& shape : shapes::broken_shapes())
          if (shape.name == "box-folded") return std::move(shape.patches);
        return Patches{};
      }(),
      "patches-touching");
  list.undecided("not-certified");
}

// A family of thin shapes, as far as the decision takes a fraction of a second.
struct ThinWalls {
  const char* family;
  bool are_sides_common;  ///< where the walls touch, sides of patches are one curve
  bool has_trillionth;    ///< also with walls that are 1e-12 apart
  bool is_apart_decided, is_touching_decided;  ///< those
};
constexpr ThinWalls kThinWalls[] = {
    {"plate", true, true, true, true},      {"plate-turned", true, true, true, true},
    {"wedge", true, true, true, true},      {"tube", true, false, true, true},
    {"cone", true, false, true, true},      {"curved-plate", true, false, true, true},
    {"spheres", false, true, false, false}, {"eccentric", false, true, false, true},
    {"tori", false, false, true, true},     {"nested", false, false, true, true}};

void add_thin_walls_of_patches(PatchList& list) {
  using thin_shapes::Walls;
  for (const thin_shapes::Family& family : thin_shapes::families()) {
    const auto row = std::find_if(std::begin(kThinWalls), std::end(kThinWalls),
                                  [&](const ThinWalls& r) { return family.name == r.family; });
    VT_CHECK(row != std::end(kThinWalls), "a family of thin shapes without a row");
    const int genus = std::accumulate(family.genus.begin(), family.genus.end(), 0);
    const auto add = [&](const std::string& gap, const Rational& size, bool is_thinnest) {
      std::string name = "thin_" + family.name + (is_thinnest ? "_1e_12" : "_1e_3");
      std::replace(name.begin(), name.end(), '-', '_');
      const std::string walls = "the walls of a shape (" + family.name + ") ";
      list.valid(name + "_apart", walls + "are " + gap + " apart", family.make(size, Walls::kApart),
                 family.bodies, genus);
      if (is_thinnest && !row->is_apart_decided) list.undecided("not-certified");
      list.invalid(name + "_touching", walls + "touch", family.make(size, Walls::kTouching),
                   row->are_sides_common ? "side-overused" : "patches-touching");
      if (is_thinnest && !row->is_touching_decided) list.undecided("not-certified");
      list.invalid(name + "_crossing", walls + "cross by " + gap,
                   family.make(size, Walls::kCrossing), "patches-crossing");
    };
    add("1e-3", Rational(1) / Rational(1000), false);
    if (row->has_trillionth) add("1e-12", kTrillionth, true);
  }
}

void add_shapes_of_patches(PatchList& list) {
  for (shapes::Shape& shape : shapes::sound_shapes()) {
    std::string name = "sound_" + shape.name;
    std::replace(name.begin(), name.end(), '-', '_');
    const int genus = std::accumulate(shape.genus.begin(), shape.genus.end(), 0);
    list.valid(std::move(name), "a sound solid", std::move(shape.patches), shape.bodies, genus);
  }
}

}  // namespace

std::vector<HardPatches> plain_hard_patches() {
  PatchList list;
  add_sides(list);
  add_contacts_of_patches(list);
  add_shells_of_patches(list);
  add_thin_walls_of_patches(list);
  add_shapes_of_patches(list);
  return list.take();
}

std::vector<HardPatches> hard_patches(std::uint64_t seed) {
  constexpr std::size_t kMostShuffled = 12;
  Random random(seed);
  std::vector<HardPatches> out;
  for (HardPatches& model : plain_hard_patches()) {
    out.push_back(model);
    if (model.patches.size() > kMostShuffled) continue;
    model.name += "_shuffled";
    model.what += "; in another order";
    model.patches = relabelled(model.patches, random);
    out.push_back(std::move(model));
  }
  return out;
}

}  // namespace veritope::hard_models
