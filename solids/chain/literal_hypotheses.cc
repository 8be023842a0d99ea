// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_hypotheses.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "robust/base/parallel.h"
#include "solids/chain/literal_hypotheses_internal.h"
#include "solids/chain/literal_polynomials_internal.h"

namespace veritope::internal {
namespace {

// The planes at one vertex so far: the first normal, and the line that two of them have in common.
struct PlanesAtVertex {
  bool has_plane = false, has_line = false, is_violated = false, lacks_plane = false;
  std::uint32_t num = 0;
  ExactPoint plane, line;

  void add(const ExactPoint& normal) {
    ++num;
    if (is_zero(normal)) {
      is_violated = lacks_plane = true;
      return;
    }
    if (!has_plane) {
      has_plane = true;
      plane = normal;
    } else if (!has_line) {
      line = cross(plane, normal);
      has_line = !is_zero(line);
    } else if (dot(line, normal).sign() != 0) {
      is_violated = true;
    }
  }
};

// Whether a is nearer to kHolds than b.
bool is_better(const PlaceAnswer& a, const PlaceAnswer& b) {
  const auto rank = [](const PlaceAnswer& x) {
    return x.decision == Decision::kHolds ? 0 : x.decision == Decision::kOpen ? 1 : 2;
  };
  return rank(a) < rank(b);
}

// Where the vertices of a complex are: the first facet's corner at each.
struct VertexPlace {
  std::uint32_t facet = LiteralFacet::kNone;
  std::size_t corner = 0;
};

std::vector<VertexPlace> places_of_vertices(const PatchComplex& complex,
                                            const LiteralFacets& facets) {
  std::vector<VertexPlace> out(complex.num_vertices());
  for (const LiteralEdge& e : facets.edges())
    for (std::size_t end = 0; end < 2; ++end) {
      VertexPlace& place = out[e.vertices[end]];
      if (place.facet == LiteralFacet::kNone || e.facets[0] < place.facet)
        place = {e.facets[0], (e.sides[0] + end) % 3};
    }
  return out;
}

std::string ends_text(const LiteralFacet& facet, std::size_t k) {
  return "the edge from " + approx_text(facet.corners[k]) + " to " +
         approx_text(facet.corners[(k + 1) % 3]);
}

void add(LiteralHypothesis& out, const PlaceAnswer& answer, const std::string& name) {
  ++out.places;
  if (answer.decision == Decision::kHolds) return;
  const bool is_first_violation = answer.decision == Decision::kViolated && out.violations == 0;
  if (is_first_violation || out.first.empty()) out.first = name + ": " + answer.why;
  ++(answer.decision == Decision::kViolated ? out.violations : out.undecided);
}

}  // namespace

std::string approx_text(const ExactPoint& p) {
  std::string out = "(";
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                   nearest_double(p[k]), std::chars_format::general, 6);
    out.append(digits.data(), end.ptr);
    out += k < 2 ? ", " : ")";
  }
  return out;
}

std::string name_of(const PatchComplex& complex, const LiteralFacet& facet) {
  const Patch& patch = complex.patch(facet.patch);
  std::string out = to_string(patch.origin());
  if (!patch.is_triangle()) out += facet.half == 0 ? ", first half" : ", second half";
  return out;
}

LiteralHypothesis planes_share_lines(const PatchComplex& complex, const LiteralFacets& facets) {
  std::vector<PlanesAtVertex> at(complex.num_vertices());
  for (const LiteralEdge& e : facets.edges())
    for (const std::uint32_t v : e.vertices) at[v].add(e.plane);
  LiteralHypothesis out;
  out.places = at.size();
  const std::vector<VertexPlace> places = places_of_vertices(complex, facets);
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (!at[v].is_violated) continue;
    if (out.violations++ > 0) continue;
    const LiteralFacet& facet = facets.facets()[places[v].facet];
    out.first = "the vertex at " + approx_text(facet.corners[places[v].corner]) + " of " +
                name_of(complex, facet) +
                (at[v].lacks_plane ? ": an edge has no plane"
                                   : ": the planes of its " + std::to_string(at[v].num) +
                                         " edges have no line in common");
  }
  return out;
}

LiteralHypothesis curves_in_planes(const PatchComplex& complex, const LiteralFacets& facets) {
  LiteralHypothesis out;
  for (const LiteralEdge& e : facets.edges()) {
    const LiteralFacet& facet = facets.facets()[e.facets[0]];
    const std::size_t k = e.sides[0];
    PlaceAnswer answer;
    if (is_zero(e.plane)) {
      answer = {Decision::kViolated, ends_text(facet, k) + " has no plane"};
    } else if (facet.map) {
      const auto f = side_form(facet, k, e.plane, dot(e.plane, facet.corners[k]));
      if (std::any_of(f.begin(), f.end(), [](const Rational& c) { return c.sign() != 0; }))
        answer = {Decision::kViolated, "the curve of " + ends_text(facet, k) + " leaves its plane"};
    }
    add(out, answer, name_of(complex, facet));
  }
  return out;
}

PlaceAnswer is_in_wedge(const LiteralFacet& facet) {
  if (!facet.map) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const NowhereNegative f =
        nowhere_negative(linear_form(facet, facet.walls[k], facet.offsets[k]));
    if (f.decision == Decision::kViolated)
      return {f.decision, "the patch leaves its wedge at " +
                              approx_text(point_at(facet, *f.where)) + ", across the plane of " +
                              ends_text(facet, k)};
    if (f.decision == Decision::kOpen)
      return {f.decision, "whether the patch leaves its wedge across the plane of " +
                              ends_text(facet, k) + " is undecided"};
  }
  return {};
}

PlaceAnswer is_facing(const LiteralFacet& facet) {
  if (!facet.map) return {};
  const NowhereNegative f = nowhere_negative(jacobian_form(facet));
  if (f.decision == Decision::kViolated)
    return {f.decision, "the patch turns its back at " + approx_text(point_at(facet, *f.where)) +
                            ", seen along the base's normal"};
  if (f.decision == Decision::kOpen)
    return {f.decision, "whether the patch turns its back anywhere is undecided"};
  if (f.is_zero) return {Decision::kViolated, "the patch stands on its base like a wall"};
  return {};
}

PlaceAnswer is_upright(const LiteralFacet& facet) {
  PlaceAnswer out;
  for (std::size_t k = 0; facet.map && k < 3; ++k) {
    const Sign lean = dot(facet.walls[k], facet.normal).sign();
    if (lean == 0) continue;
    std::vector<Rational> h =
        side_form(facet, k, facet.normal, dot(facet.normal, facet.corners[0]));
    if (lean < 0)
      for (Rational& c : h) c.negate();
    const NowhereNegativeCurve f = nowhere_negative(std::move(h));
    if (f.decision == Decision::kViolated)
      return {f.decision, "the wedge reaches over the patch at " + ends_text(facet, k)};
    if (f.decision == Decision::kOpen)
      out = {f.decision, "whether the wedge reaches over the patch at " + ends_text(facet, k) +
                             " is undecided"};
  }
  return out;
}

void decide_graphs(const PatchComplex& complex, const LiteralFacets& facets, unsigned jobs,
                   LiteralHypotheses& out) {
  const std::vector<LiteralFacet>& all = facets.facets();
  std::vector<std::array<PlaceAnswer, 3>> answers(all.size());
  parallel_for(all.size(), 64, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const LiteralFacet& facet = all[i];
      if (facet.has_wedge)
        answers[i] = {is_in_wedge(facet), is_facing(facet), is_upright(facet)};
      else
        answers[i].fill({Decision::kViolated, is_zero(facet.normal)
                                                  ? "the base has no area"
                                                  : "a side has no plane, or that of the base"});
    }
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = name_of(complex, all[i]);
    add(out.in_wedges, answers[i][0], name);
    add(out.facing, answers[i][1], name);
    add(out.upright, answers[i][2], name);
    add(out.graphs, *std::max_element(answers[i].begin(), answers[i].end(), is_better), name);
  }
}

}  // namespace veritope::internal
