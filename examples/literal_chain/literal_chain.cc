// SPDX-License-Identifier: LGPL-3.0-or-later
// The cells of seed 001 [GRF03] as they stand in definitions 8 and 9, with exact planes: over an octahedron with
// normals along the positions f is the winding number w; over a torus it is not, and the points say where.
#include <array>
#include <cstdio>
#include <vector>

#include "models/patch_shapes.h"
#include "solids/chain/literal_chain.h"
#include "solids/classify/patch_classifier.h"
#include "splines/pn_triangle.h"

using namespace veritope;

namespace {

std::vector<Patch> octahedron() {
  std::vector<Patch> out;
  for (int octant = 0; octant < 8; ++octant) {
    std::array<PnPoint, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k][k] = Rational((octant >> k & 1) != 0 ? -1 : 1);
    if (octant == 1 || octant == 2 || octant == 4 || octant == 7) std::swap(corners[1], corners[2]);
    out.push_back(make_patch(make_pn_triangle(corners, corners).value().points).value());
  }
  return out;
}

void report(const char* name, const LiteralHypothesis& h) {
  const auto holds = h.holds();
  std::printf("  %-7s %s, %llu of %llu%s%s\n", name,
              !holds   ? "undecided"
              : *holds ? "holds"
                       : "fails",
              static_cast<unsigned long long>(h.violations),
              static_cast<unsigned long long>(h.places), h.first.empty() ? "" : "; ",
              h.first.c_str());
}

// A grid of points in the box from -reach to reach: where f is not the winding number.
void compare(const char* title, const std::vector<Patch>& patches,
             const std::array<int, 3>& reach) {
  const PatchComplex complex = make_patch_complex(patches).value();
  const LiteralChain literal(complex);
  const PatchClassifier service = PatchClassifier::make(complex, false);
  const LiteralHypotheses h = literal.hypotheses();
  std::printf("%s\n", title);
  report("planes", h.planes_share_lines);
  report("curves", h.curves_in_planes);
  report("graphs", h.graphs);
  constexpr int kSteps = 32;
  const ExactPoint origin, shift{Rational(1) / Rational(97), Rational(1) / Rational(89),
                                 Rational(1) / Rational(83)};  // away from symmetric walls
  int points = 0, wrong = 0;
  for (int i = 1; i < kSteps; ++i)
    for (int j = 1; j < kSteps; ++j)
      for (int k = 1; k < kSteps; ++k) {
        const std::array<int, 3> at{i, j, k};
        ExactPoint q;
        for (std::size_t c = 0; c < 3; ++c)
          q[c] = Rational(reach[c]) * Rational(2 * at[c] - kSteps) / Rational(kSteps) + shift[c];
        const auto f = literal.value(q, origin).f;
        const int w = service.classify(q).winding;
        if (!f) continue;
        ++points;
        if (*f == w) continue;
        if (++wrong <= 5)
          std::printf("  at (%s, %s, %s): f = %d, w = %d\n", q[0].to_string().c_str(),
                      q[1].to_string().c_str(), q[2].to_string().c_str(), *f, w);
      }
  std::printf("  f != w at %d of %d points\n", wrong, points);
}

// Cells are closed sets: where two of them meet both count, and f* does not mend that.
void show_wall(const std::vector<Patch>& patches) {
  const PatchComplex complex = make_patch_complex(patches).value();
  const ExactPoint q{Rational(1) / Rational(3), Rational(1) / Rational(3),
                     Rational(1) / Rational(3)};
  const LiteralValue value = LiteralChain(complex).value(q, {});
  std::printf("  at (1/3, 1/3, 1/3), on a base: f = %d, f* = %d\n", *value.f, *value.regular);
}

}  // namespace

int main() {
  compare("PN triangles over an octahedron", octahedron(), {1, 1, 1});
  show_wall(octahedron());
  compare("PN triangles over a torus", patch_shapes::pn_torus(12, 8), {5, 5, 2});
}
