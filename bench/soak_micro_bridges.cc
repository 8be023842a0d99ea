// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_micro_bridges.cc: --rounds N --patches N --seed S --kind domain|space. Bridges, or sweeps, from jacks in
// random cages to the skins of random solids: star-shaped ones with bumps, and tori, of a few thousand facets; and balls,
// shells, cylinders and tori of patches, turned and stretched. Wrong: a bridge that prove_bridges does not prove, or a
// sweep that prove_sweeps does not; an exact point of one that is not in the interior of the solid; one of an end face
// farther from the surface than the skin; one of a sweep that lies in a tile, as far as a fine mesh of the tiles tells; a
// mesh of the whole that is not VALID with the numbers of the tiles; with patches, a whole that prove_inside does not
// prove to be inside, within the skin. One JSON line for each kind of solid: caps, bridges, those dropped by reasons, and
// how many tries with positive determinants got a matrix. Seeds of what is wrong go to standard error.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "bench/arguments.h"
#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/mesh_projection.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_projection.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/build_sweeps.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/inside/micro_inside.h"
#include "solids/micro/jack.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_topology.h"
#include "solids/micro/sweep_start.h"
#include "solids/micro/synthesis/filter_tiles.h"
#include "solids/polyhedron/validity.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"

namespace {

using namespace veritope;

struct Totals {
  std::uint64_t rounds = 0, tiles = 0, caps = 0, built = 0, wrong = 0, points = 0, unfolded = 0,
                proved_unfolded = 0, meshes = 0, inside = 0;
  std::array<std::uint64_t, kNumBridgeDrops> dropped{};
};

double number_between(Random& random, double lo, double hi) {
  return lo + (hi - lo) * static_cast<double>(random.below(1u << 20)) / (1u << 20);
}

constexpr double kPi = 3.14159265358979;

// A torus, or a sphere with bumps; inside of [-1, 1]^3.
TriangleMesh random_solid(Random& random) {
  TriangleMesh out;
  const bool is_torus = random.below(3) == 0;
  const std::uint32_t m = 48, n = is_torus ? 24 : 23;
  std::array<double, 4> bump{};
  for (double& b : bump) b = number_between(random, -0.12, 0.12);
  const double tube = number_between(random, 0.25, 0.4);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < m; ++i) {
      const double a = 2 * kPi * i / m;
      if (is_torus) {
        const double b = 2 * kPi * j / n, r = 0.55 + tube * std::cos(b);
        out.positions.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
        continue;
      }
      const double b = kPi * (j + 1) / (n + 1);
      const double r = 0.62 + bump[0] * std::cos(3 * a) * std::sin(b) + bump[1] * std::cos(2 * b) +
                       bump[2] * std::sin(2 * a + 1) * std::sin(b) + bump[3] * std::cos(b);
      out.positions.push_back(
          {r * std::sin(b) * std::cos(a), r * std::sin(b) * std::sin(a), r * std::cos(b)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % m + m * (j % n); };
  for (std::uint32_t j = 0; j + (is_torus ? 0 : 1) < n; ++j)
    for (std::uint32_t i = 0; i < m; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (is_torus) {
        out.faces.push_back({a, b, c});
        out.faces.push_back({a, c, d});
      } else {
        out.faces.push_back({a, c, b});
        out.faces.push_back({a, d, c});
      }
    }
  if (is_torus) return out;
  const auto north = static_cast<std::uint32_t>(out.positions.size());
  out.positions.push_back({0, 0, 0.62 + bump[1] + bump[3]});
  out.positions.push_back({0, 0, -(0.62 + bump[1] - bump[3])});
  for (std::uint32_t i = 0; i < m; ++i) {
    out.faces.push_back({north, at(i, 0), at(i + 1, 0)});
    out.faces.push_back({north + 1, at(i + 1, n - 1), at(i, n - 1)});
  }
  return out;
}

// A ball, with poles or without, a shell, a cylinder, a torus or a cylinder with a ball, by an affine map in [-1, 1]^3.
PatchComplex random_patches(Random& random) {
  const Rational half = Rational(1) / Rational(2);
  std::vector<Patch> shape;
  Rational reach(1);  // no coordinate is greater
  switch (random.below(6)) {
    case 0: shape = patch_shapes::sphere(); break;
    case 1: shape = patch_shapes::octant_sphere(); break;
    case 2: shape = patch_shapes::thin_shell(half); break;
    case 3:
      shape = patch_shapes::placed(patch_shapes::disc_cylinder(Rational(2)), 1, {0, 0, -1});
      break;
    case 4: shape = patch_shapes::torus(2, 1), reach = Rational(3); break;
    default: shape = patch_shapes::ball_with_neck(), reach = Rational(8);
  }
  // A matrix near the unit matrix, whose rows have sums of magnitudes below 1.
  std::array<std::array<Rational, 3>, 3> a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      a[i][j] = Rational(i == j ? random.between(10, 13) : random.between(-1, 1)) /
                (Rational(16) * reach);
  for (Patch& patch : shape) {
    Patch::Tensor map = patch.tensor();
    for (std::size_t n = 0; n < map.grid().count(); ++n) {
      std::array<Rational, 3> x;
      for (std::size_t c = 0; c < 3; ++c) x[c] = map.component(static_cast<int>(c))[n];
      for (std::size_t c = 0; c < 3; ++c)
        map.component(static_cast<int>(c))[n] = a[c][0] * x[0] + a[c][1] * x[1] + a[c][2] * x[2];
    }
    patch = turned(make_patch(std::move(map), patch.origin()).value(),
                   static_cast<std::uint32_t>(random.below(4)));
  }
  return make_patch_complex(std::move(shape)).value();
}

// A cube around [-1, 1]^3 whose inner control points, and those of the faces along them, are moved a bit.
VVolume random_cage(Random& random) {
  std::array<BSplineVolume<Rational>::Axis, 3> axes;
  for (auto& axis : axes) {
    axis.degree = 1 + static_cast<int>(random.below(3));
    const std::size_t spans = 1 + random.below(3);
    axis.knots.assign(static_cast<std::size_t>(axis.degree) + 1, Rational(0));
    for (std::size_t s = 1; s < spans; ++s) axis.knots.push_back(Rational(s) / Rational(spans));
    axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(axis.degree) + 1, Rational(1));
  }
  Grid<3> grid;
  for (std::size_t a = 0; a < 3; ++a)
    grid.size[a] = axes[a].knots.size() - static_cast<std::size_t>(axes[a].degree) - 1;
  std::vector<Rational> c;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto index = grid.index_of(i);
      // Greville's points move no line; each is moved by less than a tenth of the distance of neighbours.
      Rational greville;
      for (int d = 1; d <= axes[k].degree; ++d)
        greville += axes[k].knots[index[k] + static_cast<std::size_t>(d)];
      greville /= Rational(axes[k].degree);
      Rational x = Rational(3) * greville - Rational(3) / Rational(2);
      const bool is_at_end = index[k] == 0 || index[k] + 1 == grid.size[k];
      if (!is_at_end) x += Rational(random.between(-30, 30)) / Rational(900);
      c.push_back(x);
    }
  return VVolume(axes, 3, false, std::move(c));
}

// Points in a solid, and the squares of their distances from its surface, at least.
struct MeshTruth {
  explicit MeshTruth(const TriangleMesh& mesh)
      : classifier(std::move(MeshClassifier::make(mesh).value())), projection(mesh) {}
  bool holds(const ExactPoint& x) const { return classifier.classify(x).winding == 1; }
  Rational least_square(const ExactPoint& x) const {
    return projection.project(x).squared_distance;
  }
  MeshClassifier classifier;
  MeshProjection projection;
};
struct PatchTruth {
  explicit PatchTruth(const PatchComplex& complex)
      : classifier(PatchClassifier::of_valid_model(complex, 6)), projection(complex) {}
  bool holds(const ExactPoint& x) const { return classifier.classify(x).winding == 1; }
  Rational least_square(const ExactPoint& x) const {
    return Rational::from_double(projection.project(x).squared_distance.lo());
  }
  PatchClassifier classifier;
  PatchProjection projection;
};

template <typename Truth>
std::string fault_of_points(const Microstructure& micro, const Truth& truth, double skin,
                            Random& random, Totals& totals) {
  for (const MicroBridge& b : micro.bridges) {
    if (random.below(4) != 0) continue;
    BezierVolume<Rational> map({b.degrees[0], b.degrees[1], kBridgeAxisDegree}, 3, false);
    for (std::size_t i = 0; i < b.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[i] = b.points[i][c];
    for (int sample = 0; sample < 4; ++sample) {
      const auto t = [&] { return Rational(random.between(0, 64)) / Rational(64); };
      const auto p = evaluate<Rational, 3>(map, {t(), t(), sample == 0 ? Rational(1) : t()});
      const auto x = point(micro.cage[b.volume], {p[0], p[1], p[2]}).value();
      ++totals.points;
      if (!truth.holds({x[0], x[1], x[2]}))
        return "a point of a bridge is not in the interior of the solid";
      const Rational most = Rational::from_double(skin) * Rational::from_double(skin);
      if (sample == 0 && truth.least_square({x[0], x[1], x[2]}) > most)
        return "an end is too far from the surface";
    }
  }
  return "";
}

// The point (u, v, w) of a sweep, exactly.
ExactPoint point_of_sweep(const Microstructure& micro, const MicroSweep& sweep,
                          const BezierSurface<Rational>& cap, const std::array<Rational, 3>& at) {
  const MicroGrid& grid = micro.grids[sweep.cap.grid];
  const auto cell = grid.shape().index_of(sweep.cap.cell);
  const auto across = static_cast<std::size_t>(sweep.cap.wall / 2);
  const auto p = evaluate<Rational, 2>(cap, {at[0], at[1]});
  std::array<Rational, 3> x;
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational &lo = grid.breaks[a][cell[a]], &hi = grid.breaks[a][cell[a] + 1];
    x[a] = a == across ? (sweep.cap.wall % 2 == 0 ? lo : hi)
                       : lo + (hi - lo) * p[a < across ? a : a - 1];
  }
  const auto image = point(micro.cage[grid.volume], x).value();
  const Rational &w = at[2], first = Rational(2) * w * (Rational(1) - w), second = w * w;
  ExactPoint out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = image[c] + first * sweep.axis[0][c] + second * sweep.axis[1][c];
  return out;
}

template <typename Truth>
std::string fault_of_sweeps(const Microstructure& micro, const VModel& cage,
                            const std::vector<AnalysedTile>& tiles, const Truth& truth, double skin,
                            Random& random, Totals& totals) {
  const SweepStarts starts(micro, tiles);
  Microstructure alone = micro;
  alone.sweeps.clear();
  MicroMeshOptions meshing;
  meshing.chord = 0.004;
  std::optional<MicroMesh> mesh;
  if (random.below(4) == 0 && !micro.sweeps.empty())
    mesh = std::move(mesh_of(alone, cage, tiles, meshing).value());
  std::optional<MeshClassifier> in_tiles;
  if (mesh) in_tiles.emplace(std::move(MeshClassifier::make(mesh->mesh).value()));
  const Rational most = Rational::from_double(skin) * Rational::from_double(skin);
  for (const MicroSweep& s : micro.sweeps) {
    if (random.below(4) != 0) continue;
    const BezierSurface<Rational> cap = starts.cap(s.cap).value();
    for (int sample = 0; sample < 4; ++sample) {
      const auto t = [&] { return Rational(random.between(0, 64)) / Rational(64); };
      const ExactPoint x =
          point_of_sweep(micro, s, cap, {t(), t(), sample == 0 ? Rational(1) : t()});
      ++totals.points;
      if (!truth.holds(x)) return "a point of a sweep is not in the interior of the solid";
      if (sample == 0 && truth.least_square(x) > most) return "an end is too far from the surface";
      if (!mesh || in_tiles->classify(x).winding == 0) continue;
      const Rational d = Rational::from_double(mesh->distance);
      if (MeshProjection(mesh->mesh).project(x).squared_distance > d * d)
        return "a point of a sweep lies in a tile";
    }
  }
  return "";
}

bool is_valid_solid(const TriangleMesh& solid) { return decide_validity(solid, {}).is_valid; }
bool is_valid_solid(const PatchComplex& solid) { return solid.is_closed_oriented_surface(); }
TileFilter filter_of(const TriangleMesh& solid) {
  return std::move(TileFilter::make(solid).value());
}
TileFilter filter_of(const PatchComplex& solid) { return TileFilter::make(solid); }

// What is asked only of some rounds with meshes, and of all with patches.
std::string fault_of_whole(const TriangleMesh&, const Microstructure& micro, const VModel& cage,
                           const std::vector<AnalysedTile>& tiles, const std::vector<CellPatch>&,
                           const MicroCounts& counts, double, Random& random, Totals& totals) {
  if (random.below(4) != 0 || counts.tiles == 0) return "";
  MicroMeshOptions meshing;
  meshing.chord = 0.01;
  const Result<MicroMesh> mesh = mesh_of(micro, cage, tiles, meshing);
  if (!mesh) return "no mesh: " + mesh.error().message;
  ++totals.meshes;
  const ValidityReport found = decide_validity(mesh->mesh, {});
  if (!found.is_valid) return "the mesh is not VALID";
  return found.counts.shells == counts.shells && found.counts.genus == counts.genus
             ? ""
             : "the mesh has other numbers";
}
std::string fault_of_whole(const PatchComplex& solid, const Microstructure& micro, const VModel&,
                           const std::vector<AnalysedTile>& tiles,
                           const std::vector<CellPatch>& first_patches, const MicroCounts&,
                           double skin, Random&, Totals& totals) {
  const auto inside = prove_inside(micro, tiles, first_patches, solid, 1);
  if (const auto* const defect = std::get_if<InsideDefect>(&inside))
    return std::string("not proved inside: ") + defect->condition + ": " + defect->message;
  ++totals.inside;
  const auto& proved = std::get<InsideProof>(inside).skin;
  return proved && *proved > Rational::from_double(skin) * Rational(17) / Rational(16)
             ? "the proved skin is much greater than the one that was asked for"
             : "";
}

template <typename Truth, typename Solid>
std::string fault_of_round(const Solid& solid, bool is_in_space, Random& random, Totals& totals) {
  JackShape shape;
  shape.degree = random.below(2) == 0 ? 1 : 3;
  shape.cap = Rational(random.between(6, 10)) / Rational(64);
  std::vector<VVolume> volumes = {random_cage(random)};
  const VModel cage = make_v_model(volumes, VOrientation::kAuto).value();
  const auto count = [&] { return static_cast<std::uint64_t>(random.between(8, 18)); };
  Microstructure micro = fill_cage(
                             volumes, cage, {count(), count(), count()},
                             [&](unsigned arms) {
                               shape.arms = arms;
                               return jack_tile(shape);
                             },
                             1 << 20)
                             .value();
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : micro.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  if (!is_valid_solid(solid)) return "";  // bumps may be too steep
  const TileFilter filter = filter_of(solid);
  if (!filter_tiles_to(filter, 1, micro)) return "the filter refuses the cage";
  BridgeOptions options;
  options.alpha = number_between(random, 0.3, 0.7);
  options.skin = default_skin(solid) * number_between(random, 0.5, 1.5);
  const BridgeReport report = (is_in_space ? build_sweeps(solid, cage, tiles, options, micro)
                                           : build_bridges(solid, cage, tiles, options, micro))
                                  .value();
  ++totals.rounds;
  for (const std::uint8_t t : micro.grids[0].tiles) totals.tiles += t != 0;
  totals.caps += report.caps;
  totals.built += report.built;
  for (std::size_t i = 0; i < kNumBridgeDrops; ++i) totals.dropped[i] += report.dropped[i];
  totals.unfolded += report.unfolded;
  totals.proved_unfolded += report.proved_unfolded;
  if (!validate(micro)) return "the microstructure is not valid";
  std::vector<CellPatch> first_patches;
  const auto topology = topology_of(micro, cage, tiles, &first_patches);
  if (!std::holds_alternative<MicroCounts>(topology)) return "the tiles do not fit";
  const auto proof = prove_bridges(micro, cage, tiles);
  if (const auto* defect = std::get_if<BridgeDefect>(&proof))
    return std::string("a bridge is not proved: ") + defect->condition;
  const auto swept = prove_sweeps(micro, cage, tiles, 1).value();
  if (const auto* defect = std::get_if<BridgeDefect>(&swept))
    return std::string("a sweep is not proved: ") + defect->condition;
  const Truth truth(solid);
  if (std::string fault =
          is_in_space ? fault_of_sweeps(micro, cage, tiles, truth, options.skin, random, totals)
                      : fault_of_points(micro, truth, options.skin, random, totals);
      !fault.empty())
    return fault;
  return fault_of_whole(solid, micro, cage, tiles, first_patches, std::get<MicroCounts>(topology),
                        options.skin, random, totals);
}

template <typename Round>
Totals run_rounds(const char* name, int rounds, std::uint64_t seed, Round fault_of) {
  Totals t;
  for (int n = 0; n < rounds; ++n) {
    Random random(seed * 1000003 + static_cast<std::uint64_t>(n));
    const std::string fault = fault_of(random, t);
    if (fault.empty()) continue;
    ++t.wrong;
    std::fprintf(stderr, "wrong: %s, %s, seed %llu, round %d\n", fault.c_str(), name,
                 static_cast<unsigned long long>(seed), n);
  }
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf(
      "{\"name\":\"%s\",\"value\":%llu,\"goal\":\"0\",\"structures\":%llu,"
      "\"tiles\":%llu,\"caps\":%llu,\"built\":%llu",
      name, n(t.wrong), n(t.rounds), n(t.tiles), n(t.caps), n(t.built));
  for (std::size_t i = 0; i < kNumBridgeDrops; ++i)
    std::printf(",\"%s\":%llu", bridge_drop_name(static_cast<BridgeDrop>(i)), n(t.dropped[i]));
  std::printf(
      ",\"positive_tries\":%llu,\"with_matrix\":%llu,\"points\":%llu,\"meshes\":%llu,"
      "\"inside\":%llu}\n",
      n(t.unfolded), n(t.proved_unfolded), n(t.points), n(t.meshes), n(t.inside));
  std::fflush(stdout);
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 100, patches = 60;
  std::uint64_t seed = 1;
  std::string kind = "domain";
  bench::read_arguments(
      argc, argv,
      {{"--rounds", &rounds}, {"--patches", &patches}, {"--seed", &seed}, {"--kind", &kind}});
  if (kind != "domain" && kind != "space") {
    std::fprintf(stderr, "--kind must be domain or space, not %s\n", kind.c_str());
    return 2;
  }
  const bool is_in_space = kind == "space";
  const Totals meshes = run_rounds("micro_bridges", rounds, seed, [&](Random& random, Totals& t) {
    return fault_of_round<MeshTruth>(random_solid(random), is_in_space, random, t);
  });
  const Totals splines =
      run_rounds("micro_bridges_patches", patches, seed, [&](Random& random, Totals& t) {
        return fault_of_round<PatchTruth>(random_patches(random), is_in_space, random, t);
      });
  return meshes.wrong + splines.wrong == 0 ? 0 : 1;
}
