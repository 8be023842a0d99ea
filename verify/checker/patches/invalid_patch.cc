// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_patch.cc: B1 to B3 of docs/certificates/patch-invalid.md, and the claim as a whole.
#include "invalid.h"
#include "patch_claims.h"

namespace {

struct FindingReader : InvalidBytes {
  FindingReader(const std::vector<Entity>& entities, const char* magic, const Body& bytes)
      : InvalidBytes(entities, magic, false, bytes) {}
  Crossing crossing() {
    Crossing r;
    for (RestrictedPatch& s : r.sheet) {
      s.patch = patch();
      for (Part& t : s.t) t = read_interval(this);
    }
    for (auto& row : r.y)
      for (Big& y : row) y = Big(zigzag());
    return r;
  }
  Sides sides() {
    Sides r;
    const uint64_t n = body.count(5);
    require(n >= 1, "B1", "there are no arcs");
    r.arcs.reserve(n);
    for (uint64_t i = 0; i < n; ++i) {
      Arc a;
      a.patch = patch();
      const bool is_triangle = (*cuts.entities)[cuts.entity_of(a.patch)].kind == Entity::kTriangle;
      a.side = int(at_most(body.natural(1), is_triangle ? 2 : 3, "there is no side"));
      a.t = read_interval(this);
      r.arcs.push_back(a);
    }
    r.axis = int(at_most(body.natural(1), 2, "there is no axis"));
    r.k = int(at_most(varint(), 62, "a point counts 2^-k, k ="));
    r.at = int64_t(varint());
    return r;
  }
};

// B2: no inner knot occurs more often than the degree: the surface is continuous.
void check_knots(const Entity& e) {
  for (size_t axis = 0; axis < e.knots.size() && e.kind == Entity::kSurface; ++axis) {
    const std::vector<Ratio>& t = e.knots[axis];
    const size_t p = size_t(e.degrees[axis]), n = t.size() - p - 1;
    for (size_t i = 0; i + p < t.size(); ++i)
      require(compare(t[i], t[i + p]) != 0 || compare(t[i], t[p]) <= 0 || compare(t[i], t[n]) >= 0,
              "B2", "an inner knot occurs more often than the degree");
  }
}
// The patches with an outer side, in order.
std::vector<uint64_t> outer_patches(const Cuts& cuts) {
  std::vector<uint64_t> r;
  for (size_t i = 0; i < cuts.entities->size(); ++i) {
    const bool is_surface = (*cuts.entities)[i].kind == Entity::kSurface;
    const uint64_t v = is_surface ? cuts.intervals(i, 1) : 1;
    for (uint64_t k = cuts.first[i], u = 0; k < cuts.first[i + 1]; k += v, ++u) {
      const bool is_end = u == 0 || k + v == cuts.first[i + 1];
      for (uint64_t j = 0; j < v; j += is_end || v == 1 ? 1 : v - 1) r.push_back(k + j);
    }
  }
  return r;
}
// Calls use(patch, number) for the patches with these numbers; tests B2 for their coefficients.
template <class Use>
void each_patch(const Cuts& cuts, const std::vector<uint64_t>& numbers, Use use) {
  std::vector<Place> places;
  for (uint64_t i : numbers) places.push_back(cuts.place(cuts.entity_of(i), i));
  size_t at = 0;
  cut_patches(places, 0, cuts.breaks, [&](Patch&& p) { use(std::move(p), numbers[at++]); });
}
struct Outer {
  std::vector<OuterSide> sides;
  uint64_t number = 0;  // collapsed ones included
};
Outer outer_sides(const Cuts& cuts) {
  Outer r;
  const std::vector<uint64_t> patches = outer_patches(cuts);
  r.sides.reserve(4 * patches.size());
  each_patch(cuts, patches, [&](Patch&& p, uint64_t number) {
    for (int e = 0; e < p.shape.sides(); ++e) {
      if (!p.is_outer[e]) continue;
      ++r.number;
      Curve c = side_curve(p, e, false);
      if (!is_point(c))
        r.sides.push_back(OuterSide{number, e, cuts.reversed[cuts.entity_of(number)], p.is_rational,
                                    std::move(c)});
    }
  });
  return r;
}

}  // namespace

void check_kinds_and_knots(const std::vector<Entity>& entities) {
  check_kinds(entities);
  for (const Entity& e : entities) check_knots(e);
}
Patch cut_patch(const Cuts& cuts, uint64_t number) {
  Patch r;
  each_patch(cuts, {number}, [&](Patch&& p, uint64_t) { r = std::move(p); });
  return r;
}
void check_numbers_of_patches(const Statement& s, const Cuts& cuts) {
  require(s.number.at("patches") == cuts.patches(), "B3", "the number of patches is",
          cuts.patches());
  require(s.number.at("flipped") == cuts.num_reversed, "B3", "the number of flipped is",
          cuts.num_reversed);
}

void check_finding(const Statement& s) {
  const std::string& finding = s.text.at("finding");
  require(finding == "crossing" || finding == "side", "S1", "unknown finding");
}

std::string check_patch_invalid(const Statement& s, std::string model, const Body& bytes) {
  const std::vector<Entity> entities = read_spline_model(model, s.text.at("subject_format"));
  FindingReader r(entities, s.claim->magic, bytes);
  const Cuts& cuts = r.cuts;
  const bool is_side = r.at_most(r.body.natural(1), 1, "there is no kind") == 1;
  Crossing crossing;
  Sides sides;
  if (is_side)
    sides = r.sides();
  else
    crossing = r.crossing();
  r.end();

  check_kinds_and_knots(entities);
  Outer outer;
  std::vector<Patch> ab;
  if (is_side)
    outer = outer_sides(cuts);
  else
    for (const RestrictedPatch& sheet : crossing.sheet) ab.push_back(cut_patch(cuts, sheet.patch));
  const uint64_t same = s.number.at("same"), opposite = s.number.at("opposite");
  require((s.text.at("finding") == "side") == is_side, "B3", "the body has another finding");
  check_numbers_of_patches(s, cuts);
  require(is_side || (same == 0 && opposite == 0), "B3", "a crossing has same or opposite sides");
  const std::string text = std::to_string(cuts.patches()) + " patches, ";
  if (!is_side) {
    check_crossing(crossing, ab[0], ab[1]);
    return text + "a crossing of patches " + std::to_string(crossing.sheet[0].patch) + " and " +
           std::to_string(crossing.sheet[1].patch);
  }
  check_sides(sides, outer.sides, outer.number, cuts.num_reversed > 0, same, opposite);
  return text + "an arc passed " + std::to_string(same) + " and, the other way, " +
         std::to_string(opposite) + " times";
}
