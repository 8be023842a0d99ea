// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_v_gluing.cc: --pairs N --seed S. Pairs of cells with a common face, N in all, whose truth is known by
// construction. Equal: the face of the second cell is that of the first in another description (symmetry, degrees,
// knots, domain, constant factor). Not equal: a control point one ulp off, the orientation reversed (then they are
// copies), a parameter replaced by a quadratic one, or the homogeneous face times a polynomial. One JSON line a kind:
// wrong answers; the cells of a wrong one go to standard error.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "splines/bezier_product.h"
#include "splines/composition.h"
#include "tests/support/v_cells.h"

namespace {

using namespace veritope;
using v_cells::Point;

enum class Change { kNone, kOneUlp, kReversed, kQuadratic, kFactor };
constexpr std::array<const char*, 5> kNames = {"equal", "one_ulp", "reversed", "quadratic",
                                               "polynomial_factor"};

Rational small_double(Random& random) {
  return Rational::from_double(0.25 * (random.unit() - 0.5));
}

// A cell on [0,1]^3 whose face u = 0 is the surface, thick enough along x to be right-handed near it.
VVolume on_face(const BezierSurface<Rational>& face, int side) {
  BezierVolume<Rational> map({1, face.degree(0), face.degree(1)}, face.num_components(),
                             face.is_rational());
  const Grid<3> grid = map.grid();
  const std::size_t count = face.grid().count();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const std::size_t i = n / count, at = n % count;
    for (int c = 0; c < face.num_components(); ++c) map.component(c)[n] = face.component(c)[at];
    const Rational w = face.is_rational() ? face.component(3)[at] : Rational(1);
    const bool is_far =
        (i == 1) == (side > 0);  // the face is the end of the left cell, the begin of the right one
    if (is_far) map.component(0)[n] += Rational(4 * side) * w;
  }
  return to_bspline(map);
}

BezierSurface<Rational> random_face(Random& random) {
  const std::array<int, 2> degrees{static_cast<int>(1 + random.below(3)),
                                   static_cast<int>(1 + random.below(3))};
  const bool is_rational = random.below(2) == 0;
  BezierSurface<Rational> face(degrees, is_rational ? 4 : 3, is_rational);
  const Grid<2> grid = face.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    const Rational w = is_rational ? Rational(random.between(4, 9)) / Rational(7) : Rational(1);
    face.component(0)[n] = small_double(random) * w;
    for (std::size_t k = 0; k < 2; ++k)
      face.component(static_cast<int>(k) + 1)[n] =
          (Rational(at[k]) / Rational(degrees[k]) + small_double(random)) * w;
    if (is_rational) face.component(3)[n] = w;
  }
  return face;
}

// v -> v + a v (1 - v) in one parameter.
BezierSurface<Rational> quadratic(const BezierSurface<Rational>& face, Random& random) {
  const std::size_t axis = random.below(2);
  BezierSurface<Rational> inner({axis == 0 ? 2 : 1, axis == 0 ? 1 : 2}, 2, false);
  const Rational bend = Rational(static_cast<std::int64_t>(1 + random.below(3))) / Rational(8);
  for (std::size_t n = 0; n < inner.grid().count(); ++n) {
    const auto at = inner.grid().index_of(n);
    for (std::size_t k = 0; k < 2; ++k)
      inner.component(static_cast<int>(k))[n] = Rational(at[k]) / Rational(inner.degree(k));
    if (at[axis] == 1) inner.component(static_cast<int>(axis))[n] += bend;
  }
  return compose(face, inner).value();
}

// The homogeneous face times 1 + a v, or times 1 + a u.
BezierSurface<Rational> with_polynomial_factor(const BezierSurface<Rational>& face,
                                               Random& random) {
  const std::size_t axis = random.below(2);
  BezierSurface<Rational> factor({axis == 0 ? 1 : 0, axis == 0 ? 0 : 1}, 1, false);
  factor.component(0)[0] = Rational(1);
  factor.component(0)[1] = Rational(static_cast<std::int64_t>(3 + random.below(5))) / Rational(2);
  const auto whole = to_rational(face);
  const auto product = multiplied(factor, components(whole, 0, 4));
  const auto c = product.coefficients();
  return {product.degrees(), 4, true, {c.begin(), c.end()}};
}

BezierSurface<Rational> one_ulp_off(BezierSurface<Rational> face, Random& random) {
  const auto c = face.coefficients();
  Rational& x = c[random.below(c.size())];
  const double near = nearest_double(x);
  const double ulp = std::nextafter(std::abs(near), 1e300) - std::abs(near);
  x += Rational::from_double(random.below(2) == 0 ? ulp : -ulp);
  return face;
}

struct Kind {
  std::uint64_t pairs = 0, wrong = 0;
};

bool is_right(Change change, const VModel& model) {
  const VCounts& n = model.counts();
  const bool is_glued = n.internal == 1, has_copy = !model.copies().empty();
  if (change == Change::kNone) return is_glued && !has_copy;
  if (change == Change::kReversed) return n.internal == 0 && model.copies().size() == 1;
  return n.internal == 0 && !has_copy;
}

}  // namespace

int main(int argc, char** argv) {
  int pairs = 100000;
  std::uint64_t seed = 1;
  bench::read_arguments(argc, argv, {{"--pairs", &pairs}, {"--seed", &seed}});
  std::array<Kind, 5> kinds;
  for (int n = 0; n < pairs; ++n) {
    Random random(seed * 1000003 + static_cast<std::uint64_t>(n));
    const auto change = static_cast<Change>(random.below(2) == 0 ? 0 : 1 + random.below(4));
    const BezierSurface<Rational> face = random_face(random);
    BezierSurface<Rational> other = face;
    if (change == Change::kOneUlp) other = one_ulp_off(face, random);
    if (change == Change::kQuadratic) other = quadratic(face, random);
    if (change == Change::kFactor) other = with_polynomial_factor(face, random);
    // The copy lies on the same side: then the symmetry does not reverse the orientation.
    std::vector<VVolume> cells{on_face(face, -1),
                               on_face(other, change == Change::kReversed ? -1 : 1)};
    if (change == Change::kReversed) {
      // Another thickness: only the common face is a copy.
      cells[1] = v_cells::mapped(cells[1], [](Point p) {
        if (p[0] < Rational(-1)) p[0] -= Rational(3);
        return p;
      });
    }
    for (VVolume& cell : cells)
      cell = v_cells::redescribed(v_cells::turned(cell, static_cast<unsigned>(random.below(48))),
                                  random);
    const VModel model = make_v_model(cells, VOrientation::kAuto).value();
    Kind& kind = kinds[static_cast<std::size_t>(change)];
    ++kind.pairs;
    if (is_right(change, model)) continue;
    ++kind.wrong;
    std::fprintf(stderr, "wrong: %s, seed %llu, pair %d\n%s%s",
                 kNames[static_cast<std::size_t>(change)], static_cast<unsigned long long>(seed), n,
                 v_cells::text_of(cells[0]).c_str(), v_cells::text_of(cells[1]).c_str());
  }
  std::uint64_t wrong = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    wrong += kinds[k].wrong;
    std::printf("{\"name\":\"v_gluing_%s\",\"value\":%llu,\"goal\":\"0\",\"pairs\":%llu}\n",
                kNames[k], static_cast<unsigned long long>(kinds[k].wrong),
                static_cast<unsigned long long>(kinds[k].pairs));
  }
  return wrong == 0 ? 0 : 1;
}
