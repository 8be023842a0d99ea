// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_booleans.cc: --trees N --points M --seed S : random expressions of overlapping, touching, coincident and
// repeated solids, and points with respect to them: random, and on walls, edges, vertices, and where planes of facets
// meet. CGAL's Nef polyhedra know the truth. With --folder F: each valid mesh of the folder beside a copy with its
// facets in another order and turned, on walls only, where the truth follows from laws. One JSON line a figure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/nef_solid.h"
#include "bench/stopwatch.h"
#include "io/read_model.h"
#include "robust/base/random.h"
#include "solids/expression/expression_classifier.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/shapes.h"

namespace veritope::bench {
namespace {

enum PlaceKind { kAnywhere, kVertices, kEdges, kFacets, kPlanes, kNumKinds };
constexpr const char* kNames[kNumKinds] = {"anywhere", "vertices", "edges", "facets",
                                           "planes_meet"};

ExactPoint exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
ExactPoint mix(const ExactPoint& a, const ExactPoint& b, const Rational& t) {
  ExactPoint out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = a[k] + t * (b[k] - a[k]);
  return out;
}

// The mesh with coordinates of few bits, so that midpoints and moved copies are exact.
TriangleMesh snapped(TriangleMesh mesh) {
  for (Vec3d& p : mesh.positions)
    p = {std::round(p.x * 0x1p20) * 0x1p-20, std::round(p.y * 0x1p20) * 0x1p-20,
         std::round(p.z * 0x1p20) * 0x1p-20};
  return mesh;
}

// A solid in or near the cube from 0 to 4.
TriangleMesh random_solid(Random& random) {
  const auto at = [&] { return static_cast<double>(random.below(4)); };
  const auto size = [&] { return static_cast<double>(1 + random.below(2)); };
  switch (random.below(8)) {
    case 0:
    case 1: {
      const Vec3d lo{at(), at(), at()};
      return shapes::box(lo, {lo.x + size(), lo.y + size(), lo.z + size()});
    }
    case 2: return shapes::moved(shapes::box({0, 0, 0}, {2, 2, 2}, 2), {at(), at(), at()});
    case 3:
      return shapes::moved(shapes::bipyramid(3 + static_cast<int>(random.below(4))),
                           {at(), at(), at()});
    case 4:
      return shapes::moved(shapes::prism(3 + static_cast<int>(random.below(4)), 1.5, 2),
                           {at(), at(), at()});
    case 5: return shapes::moved(shapes::star_polyhedron(random, 0), {at(), at(), at()});
    case 6: {
      TriangleMesh out = shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1");
      return shapes::moved(shapes::mapped(out, shapes::random_matrix(random, 2), {0, 0, 0}),
                           {at(), at(), at()});
    }
    default: {
      const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
      return shapes::moved(shapes::mapped(box, shapes::random_matrix(random, 1), {0, 0, 0}),
                           {at(), at(), at()});
    }
  }
}

// One of the solids that are there, moved so that both touch or overlap, or described by other facets.
TriangleMesh related_solid(const TriangleMesh& mesh, Random& random) {
  const auto step = [&] { return static_cast<double>(random.below(3)) - 1; };
  switch (random.below(3)) {
    case 0: return shapes::subdivided(mesh);
    case 1: return shapes::moved(mesh, {step(), step(), step()});
    default: return shapes::relabelled(mesh, random);
  }
}

class Tree {
 public:
  Tree(Random& random) : random_(random) {
    num_leaves_ = 2 + random.below(11);
    const std::uint64_t num_solids = 2 + random.below(5);
    while (meshes.size() < num_solids) {
      TriangleMesh mesh = meshes.empty() || random.below(2) != 0
                              ? snapped(random_solid(random))
                              : related_solid(meshes[random.below(meshes.size())], random);
      if (!decide_validity(mesh, {}).is_valid) mesh = shapes::reversed(mesh);
      if (!decide_validity(mesh, {}).is_valid || mesh.faces.size() > 120) continue;
      meshes.push_back(std::move(mesh));
    }
    box = {{ExactInterval{-20, 20}, ExactInterval{-20, 20}, ExactInterval{-20, 20}}};
    for (const TriangleMesh& m : meshes) nefs_.emplace_back(m);
    nefs_.emplace_back(box);
    auto [f, n] = node(num_leaves_, 8);
    formula = std::move(f);
    nef = std::make_unique<NefSolid>(n.regularized());
  }

  std::vector<TriangleMesh> meshes;
  ExactBox<3> box;
  Formula formula;
  std::unique_ptr<NefSolid> nef;
  std::string text;

 private:
  std::pair<Formula, NefSolid> node(std::uint64_t leaves, int depth) {
    if (leaves == 1 || depth == 0) {
      const std::uint64_t i = random_.below(meshes.size());
      text += 'A' + static_cast<char>(i);
      return {Formula::variable(static_cast<std::uint32_t>(i)), nefs_[i]};
    }
    if (depth > 1 && random_.below(8) == 0) {
      text += "!(";
      auto [f, n] = node(leaves, depth - 1);
      text += ")";
      const auto last = static_cast<std::uint32_t>(meshes.size());
      return {Formula::all_of({Formula::variable(last), f.negated()}),
              nefs_.back().without(n).regularized()};
    }
    const std::uint64_t left = 1 + random_.below(leaves - 1);
    const std::uint64_t op = random_.below(3);
    text += "(";
    auto [f, n] = node(left, depth - 1);
    text += op == 0 ? " | " : op == 1 ? " & " : " - ";
    auto [g, m] = node(leaves - left, depth - 1);
    text += ")";
    switch (op) {
      case 0: return {Formula::any_of({f, g}), n.united(m).regularized()};
      case 1: return {Formula::all_of({f, g}), n.intersected(m).regularized()};
      default: return {Formula::all_of({f, g.negated()}), n.without(m).regularized()};
    }
  }

  Random& random_;
  std::uint64_t num_leaves_ = 0;
  std::vector<NefSolid> nefs_;
};

class Places {
 public:
  Places(const std::vector<TriangleMesh>& meshes, Random& random)
      : meshes_(meshes), random_(random) {}

  ExactPoint place(PlaceKind kind) {
    const auto t = facet();
    const auto part = [&] {
      return Rational(Integer(static_cast<std::int64_t>(1 + random_.below(7))), Integer(8));
    };
    switch (kind) {
      case kAnywhere: {
        const auto at = [&] { return Rational::from_double(random_.unit() * 8 - 2); };
        return {at(), at(), at()};
      }
      case kVertices: return t[0];
      case kEdges: return mix(t[0], t[1], part());
      case kFacets: return mix(t[0], mix(t[1], t[2], part()), part());
      default: break;
    }
    for (int i = 0; i < 20; ++i)
      if (const auto p = common_point()) return *p;
    return t[0];
  }

 private:
  std::array<ExactPoint, 3> facet() {
    const TriangleMesh& m = meshes_[random_.below(meshes_.size())];
    const auto& t = m.faces[random_.below(m.faces.size())];
    return {exact(m.positions[t[0]]), exact(m.positions[t[1]]), exact(m.positions[t[2]])};
  }

  // Where three planes of facets meet near the solids.
  std::optional<ExactPoint> common_point() {
    std::array<ExactPoint, 3> n;
    std::array<Rational, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto t = facet();
      const auto edge = [&](std::size_t j, std::size_t k) { return t[j][k] - t[0][k]; };
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
        n[i][k] = edge(1, p) * edge(2, q) - edge(1, q) * edge(2, p);
      }
      d[i] = n[i][0] * t[0][0] + n[i][1] * t[0][1] + n[i][2] * t[0][2];
    }
    const auto det = [](const std::array<ExactPoint, 3>& m) {
      Rational out;
      for (std::size_t k = 0; k < 3; ++k)
        out += m[0][k] *
               (m[1][(k + 1) % 3] * m[2][(k + 2) % 3] - m[1][(k + 2) % 3] * m[2][(k + 1) % 3]);
      return out;
    };
    const Rational whole = det(n);
    if (whole.sign() == 0) return std::nullopt;
    ExactPoint out;
    for (std::size_t k = 0; k < 3; ++k) {
      auto m = n;
      for (std::size_t i = 0; i < 3; ++i) m[i][k] = d[i];
      out[k] = det(m) / whole;
      if (out[k] < Rational(-3) || Rational(8) < out[k]) return std::nullopt;
    }
    return out;
  }

  const std::vector<TriangleMesh>& meshes_;
  Random& random_;
};

PointWord word_of(Side side) {
  return side == Side::kIn ? PointWord::kIn : side == Side::kOn ? PointWord::kOn : PointWord::kOut;
}

// Pairs of formulas that mean one set.
std::vector<std::pair<Formula, Formula>> laws_of(const Formula& a, const Formula& b,
                                                 const Formula& c, const Formula& box) {
  const auto either = [](const Formula& x, const Formula& y) { return Formula::any_of({x, y}); };
  const auto both = [](const Formula& x, const Formula& y) { return Formula::all_of({x, y}); };
  const auto complement = [&](const Formula& x) { return both(box, x.negated()); };
  return {{either(a, b), either(b, a)},
          {either(a, either(b, c)), either(either(a, b), c)},
          {both(a, both(b, c)), both(both(a, b), c)},
          {both(a, either(b, c)), either(both(a, b), both(a, c))},
          {either(a, both(b, c)), both(either(a, b), either(a, c))},
          {either(a, a), a},
          {complement(either(a, b)), both(complement(a), complement(b))},
          {complement(both(a, b)), either(complement(a), complement(b))},
          {complement(complement(a)), both(box, a)}};
}

// A mesh and a copy of it with other facets first: A - B is empty, and walls of A are walls of A | B and A & B.
struct CopyTally {
  std::uint64_t models = 0, points = 0, wrong = 0;
  double seconds = 0;

  void add(const std::string& path, const TriangleMesh& mesh, std::uint64_t num, Random& random) {
    const std::vector<TriangleMesh> meshes = {mesh, shapes::relabelled(mesh, random)};
    std::vector<std::shared_ptr<const Operand>> solids;
    for (const TriangleMesh& m : meshes) solids.push_back(mesh_operand(m));
    const Formula a = Formula::variable(0), b = Formula::variable(1);
    const std::pair<ExpressionClassifier, PointWord> cases[] = {
        {ExpressionClassifier(Formula::any_of({a, b}), solids), PointWord::kOn},
        {ExpressionClassifier(Formula::all_of({a, b}), solids), PointWord::kOn},
        {ExpressionClassifier(Formula::all_of({a, b.negated()}), solids), PointWord::kOut},
        {ExpressionClassifier(Formula::any_of({a, b.negated()}), solids), PointWord::kIn}};
    Places places(meshes, random);
    ++models;
    const Stopwatch watch;
    for (std::uint64_t k = 0; k < num; ++k) {
      const ExactPoint p = places.place(static_cast<PlaceKind>(kVertices + k % 3));
      ++points;
      for (const auto& [classifier, word] : cases) {
        if (classifier.classify(p) == word) continue;
        ++wrong;
        std::fprintf(stderr, "wrong: %s at %s %s %s\n", path.c_str(), p[0].to_string().c_str(),
                     p[1].to_string().c_str(), p[2].to_string().c_str());
      }
    }
    seconds += watch.ns() * 1e-9;
  }
};

CopyTally compare_copies(const std::string& folder, std::uint64_t points, std::uint64_t seed) {
  constexpr std::size_t kMostFaces = 200000;
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  CopyTally out;
  Random random(seed);
  for (const std::string& path : paths) {
    const auto file = read_model_file(path, {});
    const auto* mesh = file ? std::get_if<MeshFile>(&*file) : nullptr;
    if (mesh == nullptr || mesh->mesh.faces.size() > kMostFaces) continue;
    if (decide_validity(mesh->mesh, {}).is_valid) out.add(path, mesh->mesh, points, random);
  }
  return out;
}

struct Tally {
  std::uint64_t points = 0, walls = 0, on = 0, wrong = 0;
  double seconds = 0;
};

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  std::uint64_t trees = 20, points = 200, seed = 1;
  std::string folder;
  read_arguments(
      argc, argv,
      {{"--trees", &trees}, {"--points", &points}, {"--seed", &seed}, {"--folder", &folder}});
  if (!folder.empty()) {
    const CopyTally t = compare_copies(folder, points, seed);
    std::printf(
        "{\"name\":\"boolean_copies_wrong\",\"value\":%llu,\"goal\":\"0\",\"models\":%llu,"
        "\"points\":%llu,\"seconds\":%.0f}\n",
        static_cast<unsigned long long>(t.wrong), static_cast<unsigned long long>(t.models),
        static_cast<unsigned long long>(t.points), t.seconds);
    return t.wrong == 0 && t.models > 0 ? 0 : 1;
  }
  Tally tallies[kNumKinds];
  constexpr std::uint64_t kNumLawPoints = 500;  // of each tree
  std::uint64_t num_laws = 0, broken = 0;
  double nef_seconds = 0;
  const Stopwatch all;
  for (std::uint64_t i = 0; i < trees; ++i) {
    Random random(seed + 1000003 * i);
    const Tree tree(random);
    std::vector<std::shared_ptr<const Operand>> solids;
    for (const TriangleMesh& m : tree.meshes) solids.push_back(mesh_operand(m));
    solids.push_back(box_operand(tree.box));
    const ExpressionClassifier classifier(tree.formula, solids);
    const auto variable = [&](std::uint64_t v) {
      return Formula::variable(static_cast<std::uint32_t>(v));
    };
    std::vector<std::pair<ExpressionClassifier, ExpressionClassifier>> laws;
    for (const auto& [f, g] :
         laws_of(tree.formula, variable(0), variable(1), variable(tree.meshes.size())))
      laws.emplace_back(ExpressionClassifier(f, solids), ExpressionClassifier(g, solids));
    Places places(tree.meshes, random);
    for (std::uint64_t k = 0; k < points; ++k) {
      const auto kind = static_cast<PlaceKind>(k % kNumKinds);
      const ExactPoint p = places.place(kind);
      Tally& tally = tallies[kind];
      Stopwatch watch;
      const PointWord word = classifier.classify(p);
      tally.seconds += watch.ns() * 1e-9;
      watch = Stopwatch();
      const PointWord truth = word_of(tree.nef->side(p));
      nef_seconds += watch.ns() * 1e-9;
      int num_on = 0;
      for (const auto& solid : solids) num_on += solid->value(p) == Value3::kMixed ? 1 : 0;
      ++tally.points;
      tally.walls += num_on > 1 ? 1 : 0;
      tally.on += word == PointWord::kOn ? 1 : 0;
      if (k < kNumLawPoints)
        for (const auto& [f, g] : laws) {
          ++num_laws;
          broken += f.classify(p) == g.classify(p) ? 0 : 1;
        }
      if (word == truth) continue;
      ++tally.wrong;
      std::fprintf(stderr, "wrong: tree %llu of seed %llu, %s at %s %s %s: %d, not %d\n",
                   static_cast<unsigned long long>(i), static_cast<unsigned long long>(seed),
                   tree.text.c_str(), p[0].to_string().c_str(), p[1].to_string().c_str(),
                   p[2].to_string().c_str(), static_cast<int>(word), static_cast<int>(truth));
    }
    if (i % 50 == 49)
      std::fprintf(stderr, "%llu trees, %.0f s\n", static_cast<unsigned long long>(i + 1),
                   all.ns() * 1e-9);
  }
  std::uint64_t wrong = 0;
  for (int k = 0; k < kNumKinds; ++k) {
    const Tally& t = tallies[k];
    std::printf(
        "{\"name\":\"booleans_%s_wrong\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,\"on_"
        "several_walls\":%llu,"
        "\"on\":%llu,\"trees\":%llu,\"microseconds_a_point\":%.1f}\n",
        kNames[k], static_cast<unsigned long long>(t.wrong),
        static_cast<unsigned long long>(t.points), static_cast<unsigned long long>(t.walls),
        static_cast<unsigned long long>(t.on), static_cast<unsigned long long>(trees),
        1e6 * t.seconds / static_cast<double>(std::max<std::uint64_t>(1, t.points)));
    wrong += t.wrong;
  }
  std::printf(
      "{\"name\":\"booleans_laws_broken\",\"value\":%llu,\"goal\":\"0\",\"comparisons\":%llu}\n",
      static_cast<unsigned long long>(broken), static_cast<unsigned long long>(num_laws));
  wrong += broken;
  std::printf("{\"name\":\"booleans_seconds\",\"value\":%.0f,\"nef_locate_seconds\":%.0f}\n",
              all.ns() * 1e-9, nef_seconds);
  return wrong == 0 ? 0 : 1;
}
