// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_conditions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/chain/literal_conditions_internal.h"
#include "solids/chain/literal_polynomials_internal.h"
#include "solids/chain/literal_regions_internal.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope::internal {
namespace {

bool is_nowhere_negative(const Polynomial& f) {
  return nowhere_negative(f).decision == Decision::kHolds;
}

Polynomial negative(Polynomial f) {
  for (Rational& c : f.coefficients()) c.negate();
  return f;
}

// Whether the directions of both partial derivatives of the projected patch lie in cones such that any two span the
// base with one orientation: then the projection is one to one, since the difference of the images of two points is a
// sum of averages of both derivatives.
bool is_one_to_one(const LiteralFacet& facet) {
  if (facet.map->is_rational()) return false;
  const std::array<Polynomial, 2> base = base_forms(facet);
  const Rational o(1), z;
  const Barycentric<Rational> along_u{-o, o, z}, along_v{-o, z, o};
  const Polynomial xu = directional_derivative<Rational>(base[0], along_u),
                   xv = directional_derivative<Rational>(base[0], along_v),
                   yu = directional_derivative<Rational>(base[1], along_u),
                   yv = directional_derivative<Rational>(base[1], along_v);
  for (std::size_t i = 0; i < xu.count(); ++i)
    for (std::size_t j = 0; j < xv.count(); ++j)
      if ((xu.component(0)[i] * yv.component(0)[j] - xv.component(0)[j] * yu.component(0)[i])
              .sign() <= 0)
        return false;
  return true;
}

// The centre of the base.
ExactPoint centre_of_base(const LiteralFacet& facet) {
  return times(Rational(1) / Rational(3),
               plus(facet.corners[0], plus(facet.corners[1], facet.corners[2])));
}

// (P - b) . (P_u x P_v), times a power of the weight: with homogeneous Y = X - b w, det(Y, Y_u, Y_v).
Polynomial outward_form(const LiteralFacet& facet, const ExactPoint& b) {
  std::array<Polynomial, 3> y{linear_form(facet, {1, 0, 0}, b[0]),
                              linear_form(facet, {0, 1, 0}, b[1]),
                              linear_form(facet, {0, 0, 1}, b[2])};
  const Rational o(1), z;
  const Barycentric<Rational> along_u{-o, o, z}, along_v{-o, z, o};
  Polynomial out(3 * y[0].degree() - 2, 1, false);
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial &p = y[(k + 1) % 3], &q = y[(k + 2) % 3];
    const Polynomial normal = difference(product(directional_derivative<Rational>(p, along_u),
                                                 directional_derivative<Rational>(q, along_v)),
                                         product(directional_derivative<Rational>(p, along_v),
                                                 directional_derivative<Rational>(q, along_u)));
    const Polynomial term = product(y[k], normal);
    for (std::size_t i = 0; i < out.count(); ++i) out.component(0)[i] += term.component(0)[i];
  }
  return out;
}

// What lies between patch and base is star-shaped around the centre b of the base: the patch nowhere turns its back,
// neither along the base's normal nor seen from b, and nor does the wall below its boundary. So is the part in the
// wedge, which is convex and contains b.
bool is_star_shaped(const LiteralCellPart& part) {
  const LiteralFacet& facet = part.cell->facet();
  const ExactPoint b = centre_of_base(facet);
  const Polynomial outward = outward_form(facet, b);
  if (!is_nowhere_negative(part.is_plus ? outward : negative(outward))) return false;
  if (!is_nowhere_negative(jacobian_form(facet))) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (nowhere_negative(turning_form(facet, k, b)).decision != Decision::kHolds) return false;
  return true;
}

std::string two_places(const LiteralFacet& facet, const std::array<Barycentric<Rational>, 2>& at) {
  return "the points " + approx_text(point_at(facet, at[0])) + " and " +
         approx_text(point_at(facet, at[1])) + " of the patch are in parts that do not meet";
}

// The surface beyond the patch, in doubles: a search, whose finds are confirmed exactly.
class Extension {
 public:
  explicit Extension(const LiteralFacet& facet) : degree_(facet.map->degree()) {
    for (int c = 0; c < 4; ++c)
      for (std::size_t i = 0; i < facet.map->count(); ++i)
        control_[static_cast<std::size_t>(c)].push_back(
            c < 3                      ? nearest_double(facet.map->component(c)[i])
            : facet.map->is_rational() ? nearest_double(facet.map->component(3)[i])
                                       : 1);
  }
  Point3d approx_at(const std::array<double, 3>& at) const {
    std::array<double, 4> h;
    for (std::size_t c = 0; c < 4; ++c) {
      std::vector<double> work = control_[c];
      for (int left = degree_; left > 0; --left)
        for_each_triangle_index(left - 1, [&](int, int j, int k) {
          double& v = work[triangle_index(j, k)];
          v = at[0] * v + at[1] * work[triangle_index(j + 1, k)] +
              at[2] * work[triangle_index(j, k + 1)];
        });
      h[c] = work.front();
    }
    return {h[0] / h[3], h[1] / h[3], h[2] / h[3]};
  }

 private:
  int degree_;
  std::array<std::vector<double>, 4> control_;
};

bool is_in_box(const Point3d& p, const Box3d& box) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.lo[k] <= p[k] && p[k] <= box.hi[k])) return false;
  return true;
}

// In the interior of the part.
bool is_inside(const LiteralCellPart& part, const ExactPoint& q) {
  const LiteralFacet& facet = part.cell->facet();
  if (facet.height(q).sign() == 0) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (facet.over_wall(k, q).sign() <= 0) return false;
  return part.cell->part_holds(q, part.is_plus) == Meets::kSome;
}

// The surface is the graph of a polynomial over the plane of the base: in the cell it is the patch.
bool is_graph_of_polynomial(const LiteralFacet& facet) {
  if (facet.map->is_rational()) return false;
  for (const Polynomial& f : base_forms(facet)) {
    const Rational o(1), z;
    for (const auto& along : {Barycentric<Rational>{-o, o, z}, Barycentric<Rational>{-o, z, o}}) {
      const Polynomial slope = directional_derivative<Rational>(f, along);
      const auto c = slope.component(0);
      if (std::any_of(c.begin(), c.end(), [&](const Rational& v) { return v != c.front(); }))
        return false;
    }
  }
  return true;
}

}  // namespace

PlaceAnswer is_connected(const LiteralCellPart& part) {
  const LiteralFacet& facet = part.cell->facet();
  const bool is_in_its_wedge = is_in_wedge(facet).decision == Decision::kHolds;
  if (part.is_all && (is_in_its_wedge || is_star_shaped(part))) return {};
  const PlaceAnswer open{Decision::kOpen, "whether the cell is connected is undecided"};
  if (!is_in_its_wedge) return open;
  const Polynomial h = height_form(facet);
  const PositiveRegion region = positive_region(part.is_plus ? h : negative(h));
  if (region.decision == Decision::kHolds) return {};
  if (region.decision == Decision::kViolated && is_one_to_one(facet))
    return {Decision::kViolated, two_places(facet, region.where)};
  return open;
}

PlaceAnswer is_on_one_side(const LiteralCellPart& part) {
  const LiteralFacet& facet = part.cell->facet();
  if (is_graph_of_polynomial(facet)) return {};
  constexpr int kSteps = 4, kReach = 2;  // of barycentric coordinates
  const Extension surface(facet);
  for (int i = -kReach * kSteps; i <= (1 + kReach) * kSteps; ++i)
    for (int j = -kReach * kSteps; j <= (1 + kReach) * kSteps; ++j) {
      const int k = kSteps - i - j;
      if (i >= 0 && j >= 0 && k >= 0) continue;  // the patch
      const Point3d p =
          surface.approx_at({i / double{kSteps}, j / double{kSteps}, k / double{kSteps}});
      if (!is_in_box(p, part.cell->box())) continue;
      const Barycentric<Rational> at{Rational(i) / Rational(kSteps), Rational(j) / Rational(kSteps),
                                     Rational(k) / Rational(kSteps)};
      const auto q = point_of(evaluate<Rational>(*facet.map, at));
      if (q && is_inside(part, *q))
        return {Decision::kViolated,
                "the surface beyond the patch passes through the cell at " + approx_text(*q)};
    }
  return {Decision::kOpen,
          "whether the surface beyond the patch passes through the cell is undecided"};
}

// Two planes of sides and that of the base meet in a corner, on the patch. The planes of all three sides meet in one
// point or none: a line in all of them would meet the plane of the base in a point of three lines that bound a
// triangle, or be parallel to all of these.
PlaceAnswer has_vertices_on_patch(const LiteralCellPart& part) {
  const LiteralFacet& facet = part.cell->facet();
  const auto& w = facet.walls;
  const ExactPoint w12 = cross(w[1], w[2]), w20 = cross(w[2], w[0]), w01 = cross(w[0], w[1]);
  const Rational det = dot(w[0], w12);
  if (det.sign() == 0) return {};
  ExactPoint apex = plus(times(facet.offsets[0], w12),
                         plus(times(facet.offsets[1], w20), times(facet.offsets[2], w01)));
  for (Rational& x : apex) x /= det;
  const Meets held = part.cell->part_holds(apex, part.is_plus);
  if (held == Meets::kNone || held == Meets::kOn) return {};
  const std::string where = "the planes of the three sides meet at " + approx_text(apex);
  if (held != Meets::kOpen && part.cell->line().point(facet, apex) == Meets::kNone)
    return {Decision::kViolated, where + ", in the cell and off the patch"};
  return {Decision::kOpen,
          where + ", and whether that is in the cell or on the patch is undecided"};
}

namespace {

void add_answer(const PlaceAnswer& answer, const std::string& name, LiteralHypothesis& out) {
  ++out.places;
  if (answer.decision == Decision::kHolds) return;
  const bool is_violated = answer.decision == Decision::kViolated;
  if ((is_violated && out.violations == 0) || out.first.empty())
    out.first = name + ": " + answer.why;
  ++(is_violated ? out.violations : out.undecided);
}

struct PartAnswers {
  bool is_there = false;
  PlaceAnswer connected, one_side, vertices;
};
struct CellAnswers {
  bool is_open = false;              // on which sides there are parts
  std::array<PartAnswers, 2> parts;  // minus, plus
};

CellAnswers judge(const LiteralCell& cell) {
  CellAnswers out;
  for (const bool is_plus : {false, true}) {
    const auto has_part = cell.has_part(is_plus);
    out.is_open = out.is_open || !has_part;
    out.parts[is_plus ? 1 : 0].is_there = has_part == true;
  }
  for (std::size_t k = 0; !out.is_open && k < 2; ++k) {
    PartAnswers& answers = out.parts[k];
    if (!answers.is_there) continue;
    const LiteralCellPart part{&cell, k == 1, !out.parts[1 - k].is_there};
    answers.connected = is_connected(part);
    answers.one_side = is_on_one_side(part);
    answers.vertices = has_vertices_on_patch(part);
  }
  return out;
}

void add_part(const PatchComplex& complex, const LiteralFacet& facet, bool is_plus,
              const PartAnswers& answers, LiteralCells& out) {
  const std::string name = name_of(complex, facet) + (is_plus ? ", plus part" : ", minus part");
  ++(is_plus ? out.plus : out.minus);
  add_answer(answers.connected, name, out.connected);
  add_answer(answers.one_side, name, out.on_one_side);
  add_answer(answers.vertices, name, out.with_vertices_on_patch);
  for (const auto& [answer, figure] :
       {std::pair(&answers.connected, "1a"), std::pair(&answers.vertices, "3a")})
    if (answer->decision == Decision::kViolated)
      out.refused.push_back({facet.patch, facet.half, is_plus, figure, name + ": " + answer->why});
}

}  // namespace

void judge_cells(const PatchComplex& complex, const std::vector<LiteralCell>& cells, unsigned jobs,
                 LiteralCells& out) {
  std::vector<CellAnswers> answers(cells.size());
  parallel_for(cells.size(), 16, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = judge(cells[i]);
  });
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (answers[i].is_open) {
      ++out.undecided;
      continue;
    }
    for (const bool is_plus : {true, false})
      if (answers[i].parts[is_plus ? 1 : 0].is_there)
        add_part(complex, cells[i].facet(), is_plus, answers[i].parts[is_plus ? 1 : 0], out);
    out.split += answers[i].parts[0].is_there && answers[i].parts[1].is_there ? 1 : 0;
  }
}

}  // namespace veritope::internal
