// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_enclosures.cc: --trials N --seed S. A trial is a random (surface patch, parameter box, point of the box).
// It requires that every enclosure over the box contains what rationals compute at the point: the three coordinates,
// their five first and second derivatives, the normal, the Gauss, mean and principal curvatures, by hull and by mean
// value, and the cone of normals. Patches: degrees 2 to 4, up to three spans an axis, polynomial or rational; in half
// of them knots and control points are not binary64. A patch has 64 points at distances 2^0 .. 2^-31 of a centre,
// sometimes a knot, each evaluated once, and 128 boxes around the centre of widths 2^1 .. 2^-31, some without width: a
// point is tried with every box in which it lies. Then the orders of convergence. One JSON line a figure.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "interval/enclosure/surface_enclosure.h"
#include "tests/interval/exact_jets.h"

namespace {

using namespace veritope;
using exact_jets::Bracket;
using exact_jets::holds;

constexpr EnclosureForm kForms[] = {EnclosureForm::kHull, EnclosureForm::kMeanValue};
constexpr int kPoints = 64, kBoxes = 128;

BSpline<Rational, 2> draw_patch(Random& random) {
  const bool is_rational = random.below(3) == 0, is_dyadic = random.below(2) == 0;
  exact_map::Shape<2> shape{
      {2 + static_cast<int>(random.below(3)), 2 + static_cast<int>(random.below(3))},
      {1 + random.below(3), 1 + random.below(3)},
      3 + is_rational,
      is_rational};
  auto map = exact_map::random_bspline<2>(random, shape, is_dyadic ? 8 : 7, is_dyadic ? 64 : 30);
  if (random.below(4) == 0) return map;  // wild: folds and points without a normal
  const Grid<2> grid = map.grid();
  for (std::size_t i = 0; i < grid.count(); ++i)
    for (int c = 0; c < 2; ++c) {
      const std::size_t along = c == 0 ? i / grid.size[1] : i % grid.size[1];
      Rational x = Rational(4 * along) + map.component(c)[i] / Rational(8);
      if (is_rational) x *= map.component(3)[i];
      map.component(c)[i] = std::move(x);
    }
  return map;
}

// What rationals compute at a point.
struct Truth {
  std::array<double, 2> at;
  std::vector<std::pair<std::array<int, 2>, std::vector<Bracket>>> derivatives;
  std::vector<Bracket> normal;
  std::vector<Bracket> curvatures;  // Gauss exact, the others ranges; empty without a normal
  exact_jets::Vector exact_normal;
};

struct Patch {
  BSpline<Rational, 2> map;
  BezierPieces<Rational, 2> pieces;
  SplineEnclosure<2> enclosure;
  std::vector<std::optional<exact_jets::PieceJets<2>>> jets;  // made on demand

  explicit Patch(BSpline<Rational, 2> m)
      : map(std::move(m)),
        pieces(bezier_pieces(map)),
        enclosure(SplineEnclosure<2>::prepare(map, 3).value()),
        jets(pieces.pieces.size()) {}

  Truth truth(const std::array<double, 2>& at) {
    std::array<std::size_t, 2> cell;
    std::array<Rational, 2> length, local;
    for (std::size_t a = 0; a < 2; ++a) {
      const auto& b = pieces.breaks[a];
      const Rational u = Rational::from_double(at[a]);
      cell[a] = 0;
      while (cell[a] + 2 < b.size() && b[cell[a] + 1] <= u) ++cell[a];
      length[a] = b[cell[a] + 1] - b[cell[a]], local[a] = (u - b[cell[a]]) / length[a];
    }
    auto& here = jets[pieces.grid().at(cell)];
    if (!here) here.emplace(pieces.at(cell), length, 2);
    const auto values = here->at(local);
    Truth out{at, {}, {}, {}, {}};
    for (const auto& [order, v] : values)
      if (order[0] + order[1] <= 2)
        out.derivatives.emplace_back(order, std::vector<Bracket>(v.begin(), v.end()));
    const auto shape = exact_jets::shape_of(values);
    out.exact_normal = shape.normal;
    for (const Rational& v : shape.normal) out.normal.emplace_back(v);
    if (exact_jets::dot(shape.normal, shape.normal).sign() == Sign::kZero) return out;
    out.curvatures.emplace_back(shape.gauss);
    for (const auto& range : {shape.mean, shape.principal_min, shape.principal_max})
      out.curvatures.emplace_back(range.first, range.second);
    return out;
  }
};

struct Counts {
  std::uint64_t trials = 0, checks = 0, misses = 0, patches = 0, boxes = 0, unbounded = 0,
                cones = 0;
};

// All enclosures over one box.
class Enclosed {
 public:
  Enclosed(const Patch& patch, const Box2& box, const std::vector<Truth>& truths, Counts& counts)
      : counts_(counts) {
    for (const EnclosureForm form : kForms) {
      for (const auto& [order, unused] : truths[0].derivatives)
        derivatives_.push_back(patch.enclosure.derivative(order, box, form).value());
      normals_.push_back(enclose_normal(patch.enclosure, box, form).value());
      curvatures_.push_back(enclose_curvatures(patch.enclosure, box, form).value());
      counts_.unbounded += !is_common(curvatures_.back().mean);
    }
    cone_ = enclose_normal_cone(patch.enclosure, box).value();
    counts_.cones += cone_.has_value();
  }
  // What an enclosure misses, or nothing.
  std::string missed(const Truth& truth) {
    std::size_t k = 0;
    for (std::size_t f = 0; f < 2; ++f) {
      for (const auto& [order, values] : truth.derivatives) {
        for (std::size_t c = 0; c < 3; ++c)
          if (!check(derivatives_[k][c], values[c], true))
            return "derivative " + std::to_string(order[0]) + " " + std::to_string(order[1]);
        ++k;
      }
      for (std::size_t c = 0; c < 3; ++c)
        if (!check(normals_[f][c], truth.normal[c], true)) return "normal";
      if (truth.curvatures.empty()) continue;
      const auto& e = curvatures_[f];
      if (!check(e.gauss, truth.curvatures[0], true)) return "Gauss curvature";
      if (!check(e.mean, truth.curvatures[1], false)) return "mean curvature";
      if (!check(e.principal_min, truth.curvatures[2], false) ||
          !check(e.principal_max, truth.curvatures[3], false))
        return "principal curvature";
    }
    return !cone_ || is_in_cone(truth) ? "" : "cone";
  }

 private:
  bool check(const Interval& a, const Bracket& x, bool is_exact) {
    ++counts_.checks;
    return holds(a, x, is_exact);
  }
  bool is_in_cone(const Truth& truth) {
    ++counts_.checks;
    exact_jets::Vector axis;
    for (std::size_t c = 0; c < 3; ++c) axis[c] = Rational::from_double(cone_->axis[c]);
    const Rational along = exact_jets::dot(truth.exact_normal, axis),
                   limit = Rational::from_double(cone_->tangent) * along;
    const auto across = exact_jets::cross(truth.exact_normal, axis);
    return along.sign() != Sign::kNegative && exact_jets::dot(across, across) <= limit * limit;
  }
  Counts& counts_;
  std::vector<std::vector<Interval>> derivatives_;
  std::vector<Box3> normals_;
  std::vector<CurvatureEnclosure> curvatures_;
  std::optional<DirectionCone> cone_;
};

void soak_patch(Random& random, Counts& counts, std::uint64_t seed) {
  Patch patch(draw_patch(random));
  const Box2 domain = patch.enclosure.domain();
  std::array<double, 2> centre;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto& breaks = patch.pieces.breaks[a];
    centre[a] = random.below(3) == 0
                    ? nearest_double(breaks[random.below(breaks.size())])
                    : domain[a].lo() + random.unit() * (domain[a].hi() - domain[a].lo());
  }
  const auto inside = [&](std::size_t a, double x) {
    return std::min(std::max(x, domain[a].lo()), domain[a].hi());
  };
  std::vector<Truth> truths;
  for (int k = 0; k < kPoints; ++k) {
    std::array<double, 2> at;
    for (std::size_t a = 0; a < 2; ++a) {
      at[a] = centre[a] + std::ldexp(2 * random.unit() - 1, -k / 2);
      if (k % 8 != 0)
        at[a] = std::nearbyint(at[a] * 0x1p34) * 0x1p-34;  // fewer digits, a faster oracle
      at[a] = inside(a, at[a]);
    }
    truths.push_back(patch.truth(at));
  }
  for (int k = 0; k < kBoxes; ++k) {
    Box2 box;
    for (std::size_t a = 0; a < 2; ++a) {
      const double width = random.below(32) == 0 ? 0 : std::ldexp(1 + random.unit(), -(k % 32));
      const double lo = inside(a, centre[a] - width * random.unit());
      box[a] = Interval::from_bounds(lo, std::max(lo, inside(a, lo + width)));
    }
    ++counts.boxes;
    std::optional<Enclosed> enclosed;
    for (const Truth& truth : truths) {
      if (!contains(box, truth.at)) continue;
      if (!enclosed) enclosed.emplace(patch, box, truths, counts);
      ++counts.trials;
      const std::string missed = enclosed->missed(truth);
      if (missed.empty()) continue;
      if (counts.misses++ < 10)
        std::fprintf(stderr, "missed: %s, seed %llu, patch %llu, box %d %s x %s, point %a %a\n",
                     missed.c_str(), static_cast<unsigned long long>(seed),
                     static_cast<unsigned long long>(counts.patches), k, to_string(box[0]).c_str(),
                     to_string(box[1]).c_str(), truth.at[0], truth.at[1]);
    }
  }
  ++counts.patches;
}

// Orders. Excess is the width beyond the hull of 4 x 4 parts, by both forms. Hulls of monotone quantities are exact, so
// the worst box of a partition counts for them; the curvatures, whose hull form is never exact, take one box.
using Quantity = std::vector<Interval> (*)(const SplineEnclosure<2>&, const Box2&, EnclosureForm);
struct Named {
  const char* name;
  Quantity of;
  double goal[2][2];  // [rational][form]
  bool is_curvature = false;
};
std::vector<Interval> from_curvature(const SplineEnclosure<2>& s, const Box2& b, EnclosureForm form,
                                     int which) {
  const auto k = enclose_curvatures(s, b, form).value();
  if (which == 0) return {k.gauss};
  if (which == 1) return {k.mean};
  return {k.principal_min, k.principal_max};
}
const Named kQuantities[] = {
    {"value",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return s.value(b, f).value();
     },
     {{2, 2}, {2, 2}}},
    {"first_derivative",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return s.derivative({1, 0}, b, f).value();
     },
     {{2, 2}, {1, 2}}},
    {"second_derivative",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return s.derivative({1, 1}, b, f).value();
     },
     {{2, 2}, {1, 2}}},
    {"normal",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       const Box3 n = enclose_normal(s, b, f).value();
       return std::vector<Interval>(n.begin(), n.end());
     },
     {{1, 2}, {1, 2}}},
    {"gauss_curvature",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return from_curvature(s, b, f, 0);
     },
     {{1, 2}, {1, 2}},
     true},
    {"mean_curvature",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return from_curvature(s, b, f, 1);
     },
     {{1, 2}, {1, 2}},
     true},
    {"principal_curvatures",
     [](const SplineEnclosure<2>& s, const Box2& b, EnclosureForm f) {
       return from_curvature(s, b, f, 2);
     },
     {{1, 2}, {1, 2}},
     true},
};

double total_width(const std::vector<Interval>& v) {
  double sum = 0;
  for (const Interval& x : v) sum += wid(x);
  return sum;
}
double excess(const SplineEnclosure<2>& s, const Quantity& of, EnclosureForm form,
              const std::array<double, 2>& at, double d) {
  constexpr int kParts = 4;
  std::vector<Interval> range;
  for (int i = 0; i < kParts; ++i)
    for (int j = 0; j < kParts; ++j) {
      const auto side = [&](double begin, int k) {
        return Interval::from_bounds(begin + d * k / kParts, begin + d * (k + 1) / kParts);
      };
      const auto part = of(s, Box2(side(at[0], i), side(at[1], j)), EnclosureForm::kBoth);
      if (range.empty()) range = part;
      for (std::size_t c = 0; c < part.size(); ++c) range[c] = hull(range[c], part[c]);
    }
  const Box2 whole(Interval::from_bounds(at[0], at[0] + d),
                   Interval::from_bounds(at[1], at[1] + d));
  return total_width(of(s, whole, form)) - total_width(range);
}
double worst_excess(const SplineEnclosure<2>& s, const Named& quantity, EnclosureForm form,
                    const std::array<double, 2>& corner, double size, int parts) {
  if (quantity.is_curvature) return excess(s, quantity.of, form, corner, size / (64 * parts));
  double worst = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j)
      worst = std::max(worst, excess(s, quantity.of, form,
                                     {corner[0] + size * i / parts, corner[1] + size * j / parts},
                                     size / parts));
  return worst;
}

// One piece of a surface that is nearly a graph.
BSpline<Rational, 2> draw_graph(Random& random, bool is_rational) {
  auto map =
      exact_map::random_bspline<2>(random, {{3, 3}, {1, 1}, 3 + is_rational, is_rational}, 8, 64);
  for (std::size_t i = 0; i < 16; ++i)
    for (int c = 0; c < 2; ++c) {
      const Rational w = is_rational ? map.component(3)[i] : Rational(1);
      map.component(c)[i] =
          w * (Rational(4 * (c == 0 ? i / 4 : i % 4)) + map.component(c)[i] / Rational(8));
    }
  return map;
}

bool print_orders(Random& random) {
  bool are_good = true;
  for (int is_rational = 0; is_rational < 2; ++is_rational)
    for (const Named& quantity : kQuantities)
      for (int f = 0; f < 2; ++f) {
        double coarse = 0, fine = 0;
        for (int loop = 0; loop < 5; ++loop) {
          const auto surface =
              SplineEnclosure<2>::prepare(draw_graph(random, is_rational != 0), 3).value();
          const Box2 domain = surface.domain();
          const std::array<double, 2> corner{domain[0].lo(), domain[1].lo()};
          const double size =
              0.999 * std::min(domain[0].hi() - corner[0], domain[1].hi() - corner[1]);
          coarse += worst_excess(surface, quantity, kForms[f], corner, size, 16);
          fine += worst_excess(surface, quantity, kForms[f], corner, size, 32);
        }
        const double order = std::log2(coarse / fine), goal = quantity.goal[is_rational][f];
        are_good = are_good && order > goal - 0.3;
        std::printf("{\"name\":\"enclosures_order_%s_%s_%s\",\"value\":%.2f,\"goal\":\"%.0f\"}\n",
                    quantity.name, f == 0 ? "hull" : "mean_value",
                    is_rational != 0 ? "rational" : "polynomial", order, goal);
      }
  return are_good;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t trials = 100000, seed = 1;
  bench::read_arguments(argc, argv, {{"--trials", &trials}, {"--seed", &seed}});
  Random random(seed);
  const bool are_good = print_orders(random);
  std::fflush(stdout);
  Counts counts;
  const bench::Stopwatch watch;
  while (counts.trials < trials) soak_patch(random, counts, seed);
  const double seconds = watch.ns() * 1e-9;
  const auto n = [](std::uint64_t v) { return static_cast<unsigned long long>(v); };
  std::printf(
      "{\"name\":\"enclosures_misses\",\"value\":%llu,\"goal\":\"0 of 10^7 "
      "trials\",\"trials\":%llu,\"checks\":%llu,\"patches\":%llu,\"boxes\":%llu,"
      "\"unbounded_curvatures\":%llu,\"cones\":%llu,\"seconds\":%.0f,\"trials_per_second\":%.0f}\n",
      n(counts.misses), n(counts.trials), n(counts.checks), n(counts.patches), n(counts.boxes),
      n(counts.unbounded), n(counts.cones), seconds, static_cast<double>(counts.trials) / seconds);
  return counts.misses == 0 && are_good ? 0 : 1;
}
