// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_chain_laws.cc: --rounds N --points M --seed S : three random solids a round, of facets or of patches, as
// normal chains from random origins; the laws of chains, the theorems of their products, and the classifiers of solids
// and expressions at M points off all walls. With --origins K also the normal chains of all kinds of solids from K
// origins each - on vertices, in planes of facets, far away - against the classifiers. One JSON line a figure.
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/boolean_chains.h"
#include "solids/chain/normal_chain.h"
#include "solids/chain/plane_cell.h"
#include "solids/chain/plane_region.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/patch_classifier.h"
#include "solids/expression/expression_classifier.h"
#include "solids/patches/patch_sources.h"
#include "tests/support/shapes.h"

namespace veritope::bench {
namespace {

constexpr std::int64_t kReach = 6;      // of the solids
constexpr std::int64_t kBoxReach = 64;  // of delta_R; origins are inside

Rational some(Random& random, double from, double to) {
  return Rational::from_double(from + random.unit() * (to - from));
}
ExactPoint some_point(Random& random, double reach) {
  return {some(random, -reach, reach), some(random, -reach, reach), some(random, -reach, reach)};
}
template <std::size_t Dim>
std::string text_of(const PointIn<Dim>& p) {
  std::string out;
  for (const Rational& x : p) out += (out.empty() ? "" : " ") + x.to_string();
  return out;
}

// A valid solid, its service, and its patches.
struct Solid {
  std::string name;
  std::unique_ptr<const TriangleMesh> mesh;  // of facets
  std::unique_ptr<const PatchComplex> complex;
  std::shared_ptr<const Operand> operand;
  std::function<PointAnswer(const ExactPoint&)> classify;
  std::shared_ptr<const NormalChain> normal;
};

Solid solid_of(std::string name, TriangleMesh mesh) {
  Solid out;
  out.name = std::move(name);
  out.mesh = std::make_unique<const TriangleMesh>(std::move(mesh));
  out.complex = std::make_unique<const PatchComplex>(
      make_patch_complex(patches_of(*out.mesh).value()).value());
  out.operand = mesh_operand(*out.mesh);
  auto service =
      std::make_shared<const MeshClassifier>(std::move(MeshClassifier::make(*out.mesh).value()));
  out.classify = [service](const ExactPoint& q) { return service->classify(q); };
  out.normal = std::make_shared<const NormalChain>(*out.complex);
  return out;
}

Solid solid_of(std::string name, std::vector<Patch> patches) {
  Solid out;
  out.name = std::move(name);
  out.complex = std::make_unique<const PatchComplex>(make_patch_complex(patches).value());
  out.operand = patch_operand(
      std::make_unique<const PatchComplex>(make_patch_complex(std::move(patches)).value()));
  auto service =
      std::make_shared<const PatchClassifier>(PatchClassifier::make(*out.complex, false, 6));
  out.classify = [service](const ExactPoint& q) { return service->classify(q); };
  out.normal = std::make_shared<const NormalChain>(*out.complex);
  return out;
}

constexpr std::uint64_t kNumMeshes = 6, kNumCurved = 6;

Solid mesh_solid(std::uint64_t kind, Random& random) {
  const auto at = [&] { return static_cast<double>(random.below(9)) / 2 - 2; };
  const Vec3d by{at(), at(), at()};
  switch (kind) {
    case 0: return solid_of("box", shapes::moved(shapes::box({-1, -1, -1}, {1, 1, 1}), by));
    case 1: return solid_of("prism", shapes::moved(shapes::prism(5, 1.5, 2), by));
    case 2: return solid_of("bipyramid", shapes::moved(shapes::bipyramid(6), by));
    case 3: return solid_of("star", shapes::moved(shapes::star_polyhedron(random, 0), by));
    case 4: return solid_of("cone", shapes::moved(shapes::cone(7), by));
    default: return solid_of("torus", shapes::moved(shapes::torus(5, 4, 2, 1), by));
  }
}

Solid curved_solid(std::uint64_t kind, Random& random) {
  const auto at = [&] {
    return Rational(static_cast<std::int64_t>(random.below(9)) - 4) / Rational(3);
  };
  const patch_shapes::Point by{at(), at(), at()};
  const auto placed = [&](const std::vector<Patch>& patches, std::int64_t size) {
    return patch_shapes::placed(patches, Rational(size) / Rational(2), by);
  };
  switch (kind) {
    case 0: return solid_of("octants", placed(patch_shapes::octant_sphere(), 3));
    case 1: return solid_of("sphere", placed(patch_shapes::sphere(), 3));
    case 2: return solid_of("ring", placed(patch_shapes::one_patch_torus(2, 1), 2));
    case 3: return solid_of("cone", placed(patch_shapes::frustum(1, 0, 2), 4));
    case 4: return solid_of("tori", placed(patch_shapes::torus(2, 1), 2));
    default: return solid_of("block", placed(patch_shapes::box({-1, -1, -1}, {1, 1, 1}), 3));
  }
}

ExactPoint some_origin(const PatchComplex& complex, std::uint64_t kind, double far,
                       Random& random) {
  const Patch& patch =
      complex.patch(static_cast<std::uint32_t>(random.below(complex.patches().size())));
  const BaseTriangle base = base_triangles(patch)[0];
  switch (kind % 5) {
    case 0: return base[random.below(3)];
    case 1: {  // in the plane of a base
      ExactPoint p;
      const Rational s = some(random, -2, 2), t = some(random, -2, 2);
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = base[0][k] + s * (base[1][k] - base[0][k]) + t * (base[2][k] - base[0][k]);
      return p;
    }
    case 2: return some_point(random, far);
    case 3: return some_point(random, 2);
    default: return {0, 0, 0};
  }
}

// Beside a point of a base.
ExactPoint near_surface(const PatchComplex& complex, Random& random) {
  const BaseTriangle base = base_triangles(
      complex.patch(static_cast<std::uint32_t>(random.below(complex.patches().size()))))[0];
  const Rational s = some(random, 0, 1), t = (Rational(1) - s) * some(random, 0, 1);
  ExactPoint q = some_point(random, 0.5);
  for (std::size_t k = 0; k < 3; ++k)
    q[k] += base[0][k] + s * (base[1][k] - base[0][k]) + t * (base[2][k] - base[0][k]);
  return q;
}

// Comparisons and failures by law.
class Tallies {
 public:
  explicit Tallies(std::uint64_t seed) : seed_(seed) {}

  template <std::size_t Dim>
  void check(const std::string& law, bool holds, std::uint64_t round, const PointIn<Dim>& q) {
    auto& [comparisons, broken] = tallies_[law];
    ++comparisons;
    if (holds) return;
    ++broken;
    std::fprintf(stderr, "%s: seed %llu round %llu at %s\n", law.c_str(),
                 static_cast<unsigned long long>(seed_), static_cast<unsigned long long>(round),
                 text_of<Dim>(q).c_str());
  }
  void print(const char* name, std::uint64_t value, const char* goal) const {
    std::printf("{\"name\":\"chain_laws_%s\",\"value\":%llu,\"goal\":\"%s\",\"seed\":%llu}\n", name,
                static_cast<unsigned long long>(value), goal,
                static_cast<unsigned long long>(seed_));
  }
  std::uint64_t report() const {
    std::uint64_t broken = 0;
    for (const auto& [name, tally] : tallies_) {
      std::printf(
          "{\"name\":\"chain_laws_%s_broken\",\"value\":%llu,\"goal\":\"0\",\"comparisons\":%llu}"
          "\n",
          name.c_str(), static_cast<unsigned long long>(tally.second),
          static_cast<unsigned long long>(tally.first));
      broken += tally.second;
    }
    return broken;
  }
  std::uint64_t seed() const { return seed_; }

  std::uint64_t points = 0, on_walls = 0, in_results = 0, plane_points = 0;

 private:
  std::uint64_t seed_;
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> tallies_;
};

// The laws of three chains whose f is 0 or 1, at single points; some hold for all chains.
template <std::size_t Dim>
class Laws {
 public:
  using Function = AssociatedFunction<Dim>;

  // @param are_normal  whether f is 0 or 1 off walls
  Laws(const std::vector<Chain<Dim>>& chains, bool are_normal, Random& random) {
    const Integer k(static_cast<std::int64_t>(random.below(9)) - 4);
    add_general(chains, k);
    add_linear(chains[0], chains[1], k);
    if (are_normal) add_boolean(chains);
  }

  void check(std::uint64_t round, const PointIn<Dim>& q, Tallies& tallies) const {
    for (const Law& law : laws_) tallies.check<Dim>(law.name, law.holds(q), round, q);
  }

 private:
  struct Law {
    std::string name;
    std::function<bool(const PointIn<Dim>&)> holds;
  };

  void add(std::string name, std::function<bool(const PointIn<Dim>&)> holds) {
    laws_.push_back({(Dim == 2 ? "plane_" : "") + std::move(name), std::move(holds)});
  }
  void equal(std::string name, const Chain<Dim>& a, const Chain<Dim>& b) {
    auto f = std::make_shared<const Function>(a), g = std::make_shared<const Function>(b);
    add(std::move(name), [f, g](const PointIn<Dim>& q) {
      const auto v = f->value(q);
      return v && v == g->value(q);
    });
  }
  static Chain<Dim> times(const Chain<Dim>& x, const Chain<Dim>& y) {
    return product(x, y).value();
  }
  static Chain<Dim> either(const Chain<Dim>& x, const Chain<Dim>& y) {
    return union_of(x, y).value();
  }
  static Chain<Dim> outside(const Chain<Dim>& x) {
    return complement_of<Dim>(x, far(-kBoxReach), far(kBoxReach)).value();
  }
  static PointIn<Dim> far(std::int64_t x) {
    PointIn<Dim> out;
    out.fill(x);
    return out;
  }

  void add_general(const std::vector<Chain<Dim>>& chains, const Integer& k) {
    const Chain<Dim>&a = chains[0], &b = chains[1], &c = chains[2];
    equal("sum_commutative", a + b, b + a);
    equal("sum_associative", (a + b) + c, a + (b + c));
    equal("product_commutative", times(a, b), times(b, a));
    equal("product_associative", times(times(a, b), c), times(a, times(b, c)));
    equal("product_distributive", times(a, b + c), times(a, b) + times(a, c));
    equal("scalar_distributive", k * (a - b), k * a - k * b);
    equal("scalar_in_product", times(k * a, b), k * times(a, b));
    equal("union_commutative", either(a, b), either(b, a));
    equal("difference_by_complement", difference_of(a, b).value(), times(a, outside(b)));
    equal("double_complement", *box_chain<Dim>(far(-kBoxReach), far(kBoxReach)) - outside(a), a);
    equal("de_morgan_union", outside(either(a, b)), times(outside(a), outside(b)));
    equal("de_morgan_intersection", outside(times(a, b)), either(outside(a), outside(b)));
  }
  void add_boolean(const std::vector<Chain<Dim>>& chains) {
    const Chain<Dim>&a = chains[0], &b = chains[1], &c = chains[2];
    equal("union_idempotent", either(a, a), a);
    equal("intersection_idempotent", times(a, a), a);
    equal("difference_with_itself", difference_of(a, a).value(), Chain<Dim>());
    equal("union_over_intersection", either(a, times(b, c)), times(either(a, b), either(a, c)));
  }
  void add_linear(const Chain<Dim>& a, const Chain<Dim>& b, const Integer& k) {
    auto f = std::make_shared<const Function>(a), g = std::make_shared<const Function>(b),
         sum = std::make_shared<const Function>(a + b),
         multiple = std::make_shared<const Function>(k * a),
         both = std::make_shared<const Function>(product(a, b).value());
    add("f_of_sum",
        [=](const PointIn<Dim>& q) { return *sum->value(q) == *f->value(q) + *g->value(q); });
    add("f_of_multiple",
        [=](const PointIn<Dim>& q) { return *multiple->value(q) == k * *f->value(q); });
    add("f_of_product",
        [=](const PointIn<Dim>& q) { return *both->value(q) == *f->value(q) * *g->value(q); });
  }

  std::vector<Law> laws_;
};

template <std::size_t Dim>
bool are_off_walls(const std::vector<AssociatedFunction<Dim>>& functions, const PointIn<Dim>& q) {
  for (const auto& f : functions)
    if (f.is_off_walls(q) != true) return false;
  return true;
}

class Expressions {
 public:
  Expressions(const std::vector<Solid>& solids, const std::vector<Chain<3>>& chains) {
    std::vector<std::shared_ptr<const Operand>> operands;
    for (const Solid& s : solids) operands.push_back(s.operand);
    const Formula a = Formula::variable(0), b = Formula::variable(1), c = Formula::variable(2);
    const auto add = [&](const Chain<3>& chain, const Formula& formula) {
      pairs_.emplace_back(AssociatedFunction<3>(chain), ExpressionClassifier(formula, operands));
    };
    const Chain<3>&x = chains[0], &y = chains[1], &z = chains[2];
    add(union_of(x, y).value(), Formula::any_of({a, b}));
    add(intersection_of(x, y).value(), Formula::all_of({a, b}));
    add(difference_of(x, y).value(), Formula::all_of({a, b.negated()}));
    add(difference_of(union_of(x, y).value(), z).value(),
        Formula::all_of({Formula::any_of({a, b}), c.negated()}));
  }

  void check(std::uint64_t round, const ExactPoint& q, Tallies& tallies) const {
    for (const auto& [chain, expression] : pairs_) {
      const PointWord word = expression.classify(q);
      const bool is_in = word == PointWord::kIn;
      tallies.check<3>("product_is_expression",
                       word != PointWord::kUndecided && chain.value(q) == Integer(is_in ? 1 : 0),
                       round, q);
      tallies.in_results += is_in ? 1 : 0;
    }
  }

 private:
  std::vector<std::pair<AssociatedFunction<3>, ExpressionClassifier>> pairs_;
};

void check_solids(std::uint64_t round, bool is_curved, std::uint64_t points, Tallies& tallies) {
  Random random(tallies.seed() + 1000003 * round + (is_curved ? 1 : 0));
  std::vector<Solid> solids;
  while (solids.size() < 3)
    solids.push_back(is_curved ? curved_solid(random.below(kNumCurved), random)
                               : mesh_solid(random.below(kNumMeshes), random));
  std::vector<Chain<3>> chains;
  for (const Solid& s : solids)
    chains.push_back(s.normal->chain(some_origin(*s.complex, random.below(5), 8, random)));
  const Laws<3> laws(chains, true, random);
  const Expressions expressions(solids, chains);
  const std::vector<AssociatedFunction<3>> given(chains.begin(), chains.end());
  for (std::uint64_t i = 0; i < points; ++i) {
    const ExactPoint q = i % 3 == 0 ? some_point(random, static_cast<double>(kReach))
                                    : near_surface(*solids[i % 2].complex, random);
    if (!are_off_walls(given, q)) {
      ++tallies.on_walls;
      continue;
    }
    ++tallies.points;
    for (std::size_t s = 0; s < solids.size(); ++s)
      tallies.check<3>("normal_is_service",
                       *given[s].value(q) == Integer(solids[s].classify(q).winding), round, q);
    laws.check(round, q, tallies);
    expressions.check(round, q, tallies);
  }
}

// A closed loop of polynomial and rational curves, which may cross itself.
std::vector<PlaneArc> random_loop(Random& random) {
  const auto at = [&] {
    return PointIn<2>{some(random, -kReach, kReach), some(random, -kReach, kReach)};
  };
  const PointIn<2> first = at();
  PointIn<2> from = first;
  std::vector<PlaneArc> out;
  const std::uint64_t n = 2 + random.below(4);
  for (std::uint64_t i = 0; i < n; ++i) {
    const bool is_rational = random.below(2) == 0;
    const auto degree = 1 + random.below(4);
    PlaneArc::Curve map({static_cast<int>(degree)}, is_rational ? 3 : 2, is_rational);
    for (std::uint64_t k = 0; k <= degree; ++k) {
      const PointIn<2> p = k == 0 ? from : k < degree ? at() : i + 1 == n ? first : at();
      const Rational w(is_rational ? 1 + static_cast<std::int64_t>(random.below(4)) : 1);
      for (int c = 0; c < 2; ++c) map.component(c)[k] = w * p[static_cast<std::size_t>(c)];
      if (is_rational) map.component(2)[k] = w;
      if (k == degree) from = p;
    }
    out.push_back(PlaneArc::make(std::move(map)).value());
  }
  return out;
}

// Chains of loops, whose f is any integer; normal chains of 100 origins are the loops' winding numbers.
void check_plane(std::uint64_t round, std::uint64_t points, Tallies& tallies) {
  Random random(tallies.seed() + 1000003 * round + 2);
  std::vector<PlaneRegion> regions;
  std::vector<Chain<2>> chains;
  const auto origin_of = [&](const PlaneRegion& region, std::uint64_t kind) {
    const PlaneArc& arc = region.arcs()[random.below(region.arcs().size())];
    const double far = kind % 4 == 2 ? 1e6 : 8;
    if (kind % 4 == 0) return arc.start();
    if (kind % 4 == 1)  // in the line of a chord
      return PointIn<2>{Rational(2) * arc.start()[0] - arc.end()[0],
                        Rational(2) * arc.start()[1] - arc.end()[1]};
    return PointIn<2>{some(random, -far, far), some(random, -far, far)};
  };
  while (regions.size() < 3) {
    regions.push_back(PlaneRegion::make(random_loop(random)).value());
    chains.push_back(plane_chain(regions.back().arcs(), origin_of(regions.back(), 3)));
  }
  const Laws<2> laws(chains, false, random);
  const std::vector<AssociatedFunction<2>> given(chains.begin(), chains.end());
  const auto some_place = [&] {
    return PointIn<2>{some(random, -kReach, kReach), some(random, -kReach, kReach)};
  };
  for (std::uint64_t i = 0; i < points; ++i) {
    const PointIn<2> q = some_place();
    if (!are_off_walls(given, q)) {
      ++tallies.on_walls;
      continue;
    }
    ++tallies.plane_points;
    for (std::size_t s = 0; s < regions.size(); ++s)
      tallies.check<2>("plane_normal_is_winding",
                       given[s].value(q) == Integer(regions[s].classify(q).winding), round, q);
    laws.check(round, q, tallies);
  }
  for (std::uint64_t o = 0; o < 100; ++o) {
    const PlaneRegion& region = regions[o % 3];
    const AssociatedFunction<2> f(plane_chain(region.arcs(), origin_of(region, o)));
    for (int i = 0; i < 10; ++i) {
      const PointIn<2> q = some_place();
      if (f.is_off_walls(q) == true)
        tallies.check<2>("plane_origins", f.value(q) == Integer(region.classify(q).winding), round,
                         q);
    }
  }
}

// NormalChain::value and f of its cells against the service.
std::uint64_t check_origins(std::uint64_t seed, std::uint64_t origins, std::uint64_t points) {
  Random random(seed);
  std::uint64_t compared = 0, wrong = 0, walls = 0, models = 0;
  for (std::uint64_t kind = 0; kind < kNumMeshes + kNumCurved; ++kind) {
    const Solid solid =
        kind < kNumMeshes ? mesh_solid(kind, random) : curved_solid(kind - kNumMeshes, random);
    ++models;
    for (std::uint64_t o = 0; o < origins; ++o) {
      const ExactPoint origin = some_origin(*solid.complex, o, 1e6, random);
      const AssociatedFunction<3> f(solid.normal->chain(origin));
      for (std::uint64_t i = 0; i < points; ++i) {
        const ExactPoint q = some_point(random, static_cast<double>(kReach));
        const PointAnswer truth = solid.classify(q);
        const auto value = solid.normal->value(q, origin);
        const auto sum = f.value(q);
        if (!value || !sum || truth.is_on()) {
          ++walls;
          continue;
        }
        ++compared;
        if (*value == truth.winding && *sum == Integer(truth.winding)) continue;
        ++wrong;
        std::fprintf(stderr, "origin: seed %llu %s from %s at %s: %d and %s, not %d\n",
                     static_cast<unsigned long long>(seed), solid.name.c_str(),
                     text_of<3>(origin).c_str(), text_of<3>(q).c_str(), *value,
                     sum->to_string().c_str(), truth.winding);
      }
    }
  }
  std::printf(
      "{\"name\":\"chain_laws_origins_wrong\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,"
      "\"on_walls\":%llu,\"models\":%llu,\"origins_each\":%llu,\"seed\":%llu}\n",
      static_cast<unsigned long long>(wrong), static_cast<unsigned long long>(compared),
      static_cast<unsigned long long>(walls), static_cast<unsigned long long>(models),
      static_cast<unsigned long long>(origins), static_cast<unsigned long long>(seed));
  return wrong;
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t rounds = 4, points = 100, origins = 10, seed = 1;
  bench::read_arguments(
      argc, argv,
      {{"--rounds", &rounds}, {"--points", &points}, {"--origins", &origins}, {"--seed", &seed}});
  const bench::Stopwatch watch;
  bench::Tallies tallies(seed);
  for (std::uint64_t r = 0; r < rounds; ++r) bench::check_solids(r, r % 4 == 3, points, tallies);
  for (std::uint64_t r = 0; r < rounds; ++r) bench::check_plane(r, points / 2, tallies);
  std::uint64_t broken = tallies.report();
  tallies.print("points_off_walls", tallies.points, ">= 100000");
  tallies.print("plane_points_off_walls", tallies.plane_points, ">= 10000");
  tallies.print("points_on_walls", tallies.on_walls, "few");
  tallies.print("points_in_results", tallies.in_results, "many");
  broken += bench::check_origins(seed, origins, 20);
  std::printf("{\"name\":\"chain_laws_seconds\",\"value\":%.0f}\n", watch.ns() * 1e-9);
  return broken == 0 ? 0 : 1;
}
