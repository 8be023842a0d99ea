// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_classify_curved.cc: --points N --seed S: classifies points with respect to curved solids whose truth is
// the exact sign of a polynomial: sphere, torus, cylinder, cone, a graph; random ones, ones with coordinates that put
// axis rays on tangent planes, seams and poles, ones on the surface at rational and irrational parameters, and ones
// that are 2^-60 to 2^-1000 away from it; and a cube with faces of degrees (7, 7), most of whose points have parameters
// of a high degree. One JSON line a figure.
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "models/patch_shapes.h"
#include "models/restless_faces.h"
#include "robust/base/random.h"
#include "solids/classify/patch_classifier.h"
#include "splines/binomial.h"
#include "splines/de_casteljau.h"

namespace veritope::bench {
namespace {

using patch_shapes::Patches;

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

struct Solid {
  const char* name;
  Patches patches;
  /// Positive inside, 0 on the surface, negative outside; exact.
  std::function<Sign(const ExactPoint&)> truth;
  Vec3d lo, hi;  // around it
};

Sign least(Sign a, Sign b) { return to_int(a) < to_int(b) ? a : b; }

// r2 - x^2 - y^2 - z^2
Sign in_ball(const ExactPoint& p) {
  return (Rational(1) - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]).sign();
}
// (x^2 + y^2 + z^2 + 8)^2 < 36 (x^2 + y^2), radii 3 and 1.
Sign in_torus(const ExactPoint& p) {
  const Rational xy = p[0] * p[0] + p[1] * p[1], s = xy + p[2] * p[2] + Rational(8);
  return (Rational(36) * xy - s * s).sign();
}
Sign in_slab(const Rational& z, const Rational& height) {
  return least(z.sign(), (height - z).sign());
}
Sign in_cylinder(const ExactPoint& p) {
  return least((Rational(1) - p[0] * p[0] - p[1] * p[1]).sign(), in_slab(p[2], 2));
}
// Apex at z = 2.
Sign in_cone(const ExactPoint& p) {
  const Rational r = Rational(1) - p[2] / Rational(2);
  return least(least((r * r - p[0] * p[0] - p[1] * p[1]).sign(), r.sign()), in_slab(p[2], 2));
}
Sign in_cube(const ExactPoint& p) {
  return least(least(in_slab(p[0], 1), in_slab(p[1], 1)), in_slab(p[2], 1));
}
// 0 <= z <= h(x, y) = 1 + x (1 - x) y / 2 + x y^2 / 3 over the unit square.
Rational height_at(const Rational& x, const Rational& y) {
  return Rational(1) + x * (Rational(1) - x) * y / Rational(2) + x * y * y / Rational(3);
}
Sign in_graph(const ExactPoint& p) {
  const Sign square = least(in_slab(p[0], 1), in_slab(p[1], 1));
  if (square < 0) return square;
  return least(square, in_slab(p[2], height_at(p[0], p[1])));
}

// The patch through the points f(i / p, j / q) of a polynomial map of degrees p, q <= 2.
using Map = std::function<ExactPoint(const Rational&, const Rational&)>;
Patch biquadratic(const Map& f) {
  Patch::Tensor map({2, 2}, 3, false);
  for (int c = 0; c < 3; ++c) {
    std::array<std::array<Rational, 3>, 3> v;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        v[i][j] = f(ratio(i, 2), ratio(j, 2))[static_cast<std::size_t>(c)];
    const auto middle = [](const Rational& a, const Rational& m, const Rational& b) {
      return Rational(2) * m - (a + b) / Rational(2);
    };
    for (auto& row : v) row[1] = middle(row[0], row[1], row[2]);
    for (int j = 0; j < 3; ++j) v[1][j] = middle(v[0][j], v[1][j], v[2][j]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) map.component(c)[static_cast<std::size_t>(3 * i + j)] = v[i][j];
  }
  return make_patch(std::move(map)).value();
}

Patches graph() {
  const Rational one(1), zero(0);
  const auto wall = [](auto xy) {
    return biquadratic([xy](const Rational& u, const Rational& v) {
      const auto [x, y] = xy(u);
      return ExactPoint{x, y, v * height_at(x, y)};
    });
  };
  using Pair = std::pair<Rational, Rational>;
  return {biquadratic([](const Rational& u, const Rational& v) {
            return ExactPoint{u, v, height_at(u, v)};
          }),
          biquadratic([](const Rational& u, const Rational& v) {
            return ExactPoint{v, u, 0};
          }),
          wall([](const Rational& t) { return Pair(t, 0); }),
          wall([](const Rational& t) { return Pair(1, t); }),
          wall([](const Rational& t) { return Pair(Rational(1) - t, 1); }),
          wall([](const Rational& t) { return Pair(0, Rational(1) - t); })};
}

// Coefficients of 1, t, ... of a Bezier line, and back.
std::vector<Rational> powers_of(std::vector<Rational> b) {
  const int n = static_cast<int>(b.size()) - 1;
  std::vector<Rational> out;
  for (int k = 0; k <= n; ++k) {
    out.push_back(b[0] * Rational(binomial(n, k)));
    for (int i = 0; i + 1 < static_cast<int>(b.size()); ++i)
      b[static_cast<std::size_t>(i)] =
          b[static_cast<std::size_t>(i) + 1] - b[static_cast<std::size_t>(i)];
    b.pop_back();
  }
  return out;
}
std::vector<Rational> bernstein_of(const std::vector<Rational>& a) {
  const int n = static_cast<int>(a.size()) - 1;
  std::vector<Rational> out(a.size());
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= i; ++k)
      out[static_cast<std::size_t>(i)] +=
          a[static_cast<std::size_t>(k)] * Rational(binomial(i, k)) / Rational(binomial(n, k));
  return out;
}
std::vector<Rational> times(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  std::vector<Rational> out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}
// b(g(t)), g = (t + 3 t^2 - 2 t^3) / 2, which maps [0, 1] onto itself: preimages of most rational points are
// irrational.
std::vector<Rational> bent(const std::vector<Rational>& b) {
  const std::vector<Rational> g{0, ratio(1, 2), ratio(3, 2), -1}, a = powers_of(b);
  std::vector<Rational> power{1}, sum(3 * (b.size() - 1) + 1);
  for (const Rational& c : a) {
    for (std::size_t i = 0; i < power.size(); ++i) sum[i] += c * power[i];
    power = times(power, g);
  }
  return bernstein_of(sum);
}
Patch bent(const Patch& patch) {
  const Patch::Tensor& map = patch.tensor();
  const int p = map.degree(0), q = map.degree(1);
  Patch::Tensor out({3 * p, 3 * q}, map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<std::vector<Rational>> rows;
    for (int i = 0; i <= p; ++i) {
      const auto first = map.component(c).begin() + i * (q + 1);
      rows.push_back(bent(std::vector<Rational>(first, first + q + 1)));
    }
    for (int j = 0; j <= 3 * q; ++j) {
      std::vector<Rational> column;
      for (int i = 0; i <= p; ++i)
        column.push_back(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
      const auto line = bent(column);
      for (int i = 0; i <= 3 * p; ++i)
        out.component(c)[static_cast<std::size_t>(i * (3 * q + 1) + j)] =
            line[static_cast<std::size_t>(i)];
    }
  }
  return make_patch(std::move(out)).value();
}
Patches bent(Patches patches) {
  for (Patch& p : patches) p = bent(p);
  return patches;
}

std::vector<Solid> solids() {
  const auto frustum = [](int top) { return patch_shapes::frustum(1, top, 2); };
  const Vec3d one{1.2, 1.2, 1.2}, minus{-1.2, -1.2, -1.2};
  return {{"sphere", patch_shapes::sphere(), in_ball, minus, one},
          {"octants", patch_shapes::octant_sphere(), in_ball, minus, one},
          {"torus", patch_shapes::torus(3, 1), in_torus, {-4.2, -4.2, -1.2}, {4.2, 4.2, 1.2}},
          {"one_patch_torus",
           patch_shapes::one_patch_torus(3, 1),
           in_torus,
           {-4.2, -4.2, -1.2},
           {4.2, 4.2, 1.2}},
          {"cylinder", frustum(1), in_cylinder, {-1.2, -1.2, -0.2}, {1.2, 1.2, 2.2}},
          {"cone", frustum(0), in_cone, {-1.2, -1.2, -0.2}, {1.2, 1.2, 2.2}},
          {"graph", graph(), in_graph, {-0.2, -0.2, -0.2}, {1.2, 1.2, 1.7}},
          {"restless_cube",
           patch_shapes::restless_cube(7, 1),
           in_cube,
           {-0.2, -0.2, -0.2},
           {1.2, 1.2, 1.2}},
          {"bent_octants", bent(patch_shapes::octant_sphere()), in_ball, minus, one},
          {"bent_graph", bent(graph()), in_graph, {-0.2, -0.2, -0.2}, {1.2, 1.2, 1.7}}};
}

ExactPoint exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

class Soak {
 public:
  Soak(std::uint64_t points, std::uint64_t seed) : points_(points), random_(seed) {}

  void run(const Solid& solid) {
    const PatchComplex complex = make_patch_complex(solid.patches).value();
    const PatchClassifier classifier = PatchClassifier::make(complex, true);
    const bool is_slow =
        std::string(solid.name).starts_with("bent") || std::string(solid.name) == "restless_cube";
    const std::uint64_t few = std::max<std::uint64_t>(points_ / 1000, 1);
    const auto ask = [&](const char* kind, std::uint64_t count, auto make) {
      Tally tally;
      const Stopwatch watch;
      for (std::uint64_t i = 0; i < count; ++i) compare(solid, classifier, make(), tally);
      report(solid.name, kind, tally, watch.ns() * 1e-9);
    };
    ask("uniform", points_, [&] { return exact(uniform(solid)); });
    ask("lattice", points_ / 10, [&] { return lattice(solid); });
    ask("on", is_slow ? few : points_ / 10, [&] { return on(solid); });
    ask("on_borders", is_slow ? few : points_ / 10, [&] { return on_border(solid); });
    for (const int bits : {60, 300, 1000})
      ask(bits == 60    ? "off_2^-60"
          : bits == 300 ? "off_2^-300"
                        : "off_2^-1000",
          few, [&] { return off(solid, bits); });
    if (std::string(solid.name) == "cone")
      for (const int bits : {30, 300})
        ask(bits == 30 ? "below_apex_2^-30" : "below_apex_2^-300", few,
            [&] { return below_apex(bits); });
  }

  std::uint64_t num_bad() const { return bad_; }

 private:
  struct Tally {
    std::uint64_t points = 0, wrong = 0, undecided = 0, on = 0;
  };

  Vec3d uniform(const Solid& s) {
    const auto between = [&](double a, double b) { return a + random_.unit() * (b - a); };
    return {between(s.lo.x, s.hi.x), between(s.lo.y, s.hi.y), between(s.lo.z, s.hi.z)};
  }
  // Multiples of 1/4: axis rays that touch the surface, run along seams and through poles.
  ExactPoint lattice(const Solid& s) {
    const Vec3d p = uniform(s);
    return exact({std::round(4 * p.x) / 4, std::round(4 * p.y) / 4, std::round(4 * p.z) / 4});
  }
  // Sometimes of few digits, sometimes a double.
  Rational parameter() {
    const auto den = static_cast<std::int64_t>(1 + random_.below(100));
    if (random_.below(2) == 0)
      return ratio(static_cast<std::int64_t>(random_.below(static_cast<std::uint64_t>(den + 1))),
                   den);
    return Rational::from_double(random_.unit());
  }
  const Patch& patch_of(const Solid& s) { return s.patches[random_.below(s.patches.size())]; }
  static ExactPoint at(const Patch& patch, const Rational& u, const Rational& v) {
    const auto f = evaluate(patch.tensor(), std::array<Rational, 2>{u, v});
    return *point_of(f);
  }
  // Points of a bent solid are those at rational parameters of the straight one: g is a bijection.
  ExactPoint at_parameters(const Solid& s, const Rational& u, const Rational& v) {
    if (!std::string(s.name).starts_with("bent")) return at(patch_of(s), u, v);
    static const Patches octants = patch_shapes::octant_sphere(), plain = graph();
    const Patches& straight = s.patches.size() == octants.size() ? octants : plain;
    return at(straight[random_.below(straight.size())], u, v);
  }
  ExactPoint on(const Solid& s) { return at_parameters(s, parameter(), parameter()); }
  ExactPoint on_border(const Solid& s) {
    const Rational end = ratio(static_cast<std::int64_t>(random_.below(2)));
    const Rational other =
        random_.below(4) == 0 ? ratio(static_cast<std::int64_t>(random_.below(2))) : parameter();
    return random_.below(2) == 0 ? at_parameters(s, end, other) : at_parameters(s, other, end);
  }
  ExactPoint off(const Solid& s, int bits) {
    ExactPoint p = on(s);
    for (Rational& x : p)
      x += ratio(static_cast<std::int64_t>(random_.below(2001)) - 1000, 1000) *
           Rational::power_of_two(-bits);
    return p;
  }
  ExactPoint below_apex(int bits) {
    const Rational unit = Rational::power_of_two(-bits);
    const auto some = [&] {
      return ratio(static_cast<std::int64_t>(random_.below(2001)) - 1000, 2000) * unit;
    };
    return {some(), some(), Rational(2) - unit * parameter()};
  }

  // Rational parameters are substituted; of others the middles, with all bits but 64 of their intervals.
  static bool is_there(const Solid& solid, const OnPatch& where, const ExactPoint& p) {
    const auto& [u, v] = where.parameters.numbers;
    const Patch& patch = solid.patches[where.patch];
    const ExactPoint q = at(patch, (u.lo + u.hi) / Rational(2), (v.lo + v.hi) / Rational(2));
    if (u.is_rational() && v.is_rational()) return q == p;
    const Rational reach = std::max({u.hi - u.lo, v.hi - v.lo}) * Rational::power_of_two(64);
    for (std::size_t k = 0; k < 3; ++k)
      if (abs(q[k] - p[k]) > reach) return false;
    return true;
  }

  void compare(const Solid& solid, const PatchClassifier& classifier, const ExactPoint& p,
               Tally& tally) {
    std::optional<OnPatch> where;
    const PointAnswer answer = classifier.classify(p, &where);
    ++tally.points;
    if (!answer.is_decided) {
      ++tally.undecided;
      return;
    }
    const Sign truth = solid.truth(p);
    bool is_right =
        answer.is_on() ? truth == 0 : answer.winding == (truth > 0 ? 1 : 0) && truth != 0;
    if (answer.is_on() && where) is_right = is_right && is_there(solid, *where, p);
    tally.on += answer.is_on() ? 1 : 0;
    if (is_right) return;
    ++tally.wrong;
    std::fprintf(stderr, "%s: %s %s %s: on %d winding %d\n", solid.name, p[0].to_string().c_str(),
                 p[1].to_string().c_str(), p[2].to_string().c_str(), int{answer.is_on()},
                 answer.winding);
  }

  void report(const char* solid, const char* kind, const Tally& t, double seconds) {
    const auto print = [&](const char* what, std::uint64_t value) {
      std::printf(
          "{\"name\":\"classify_curved_%s_%s_%s\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,"
          "\"on\":%llu,\"us_a_point\":%.1f}\n",
          solid, kind, what, static_cast<unsigned long long>(value),
          static_cast<unsigned long long>(t.points), static_cast<unsigned long long>(t.on),
          seconds * 1e6 / static_cast<double>(std::max<std::uint64_t>(t.points, 1)));
    };
    print("wrong", t.wrong);
    print("undecided", t.undecided);
    std::fflush(stdout);
    bad_ += t.wrong + t.undecided;
  }

  std::uint64_t points_;
  Random random_;
  std::uint64_t bad_ = 0;
};

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t points = 20'000, seed = 1;
  std::string only;
  bench::read_arguments(argc, argv, {{"--points", &points}, {"--seed", &seed}, {"--only", &only}});
  bench::Soak soak(points, seed);
  for (const auto& solid : bench::solids())
    if (only.empty() || only == solid.name) soak.run(solid);
  return soak.num_bad() == 0 ? 0 : 1;
}
