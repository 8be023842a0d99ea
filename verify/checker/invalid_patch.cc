// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_patch.cc: B1 to B3 of docs/certificates/patch-invalid.md, and the claim as a whole.
#include "invalid.h"
#include "star_bytes.h"

namespace {

struct Reader : Bytes {
  const Cuts* cuts = nullptr;

  explicit Reader(const Body& bytes) : Bytes(bytes) {}
  Part part() {
    Part t;
    t.k = int(at_most(varint(), 62, "an interval counts 2^-k, k ="));
    t.a = int64_t(varint());
    t.b = int64_t(at_most(varint(), uint64_t(1) << t.k, "an interval leaves [0, 1]:"));
    require(t.a <= t.b, "B1", "an interval's ends fall");
    return t;
  }
  uint64_t patch(bool* is_triangle) {
    const uint64_t i = varint();
    require(i < cuts->places.size(), "B1", "there is no patch", i);
    *is_triangle = cuts->places[i].entity->kind == Entity::kTriangle;
    return i;
  }
  Crossing crossing() {
    Crossing r;
    for (Sheet& s : r.sheet) {
      bool is_triangle;
      s.patch = patch(&is_triangle);
      for (Part& t : s.t) t = part();
      require(!is_triangle || s.t[0].a > 0, "B1", "an interval of s of a triangle contains 0");
    }
    for (auto& row : r.y)
      for (Big& y : row) y = Big(zigzag());
    return r;
  }
  Sides sides() {
    Sides r;
    const uint64_t n = body.count(5);
    require(n >= 1, "B1", "there are no arcs");
    for (uint64_t i = 0; i < n; ++i) {
      Arc a;
      bool is_triangle;
      a.patch = patch(&is_triangle);
      a.side = int(at_most(body.natural(1), is_triangle ? 2 : 3, "there is no side"));
      a.t = part();
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
bool is_outer(const Cuts& cuts, const Place& at, int e) {
  if (at.entity->kind == Entity::kTriangle) return true;
  const size_t axis = e % 2 == 0 ? 1 : 0, i = at.interval[axis];
  return e == 0 || e == 3 ? i == 0 : i + 2 == cuts.breaks[2 * at.surface + axis].size();
}

}  // namespace

std::string check_patch_invalid(const Statement& s, const std::string& model, const Body& bytes) {
  const std::vector<Entity> entities = read_spline_model(model);
  Reader r(bytes);
  // A surface has a control point for each patch between knots, so more than a byte of the model.
  const Cuts cuts = read_cuts(entities, 0x49505456, 0, model.size(), &r);
  r.cuts = &cuts;
  const bool is_side = r.at_most(r.body.natural(1), 1, "there is no kind") == 1;
  Crossing crossing;
  Sides sides;
  if (is_side)
    sides = r.sides();
  else
    crossing = r.crossing();
  r.end();

  check_kinds(entities);
  for (const Entity& e : entities) check_knots(e);
  std::vector<OuterSide> outer;
  Patch sheet[2];
  uint64_t patch = 0, num_outer = 0;
  cut_patches(cuts.places, 0, cuts.breaks, [&](Patch&& p) {
    const Place& at = cuts.places[patch];
    for (int e = 0; e < p.shape.sides() && is_side; ++e) {
      if (!is_outer(cuts, at, e)) continue;
      ++num_outer;
      const Curve c = side_curve(p, e, false);
      if (!is_point(c))
        outer.push_back(OuterSide{patch, e, cuts.is_flipped(entities, at), p.is_rational, c});
    }
    for (int i = 0; i < 2 && !is_side; ++i)
      if (crossing.sheet[i].patch == patch) sheet[i] = p;
    ++patch;
  });
  const uint64_t same = s.number.at("same"), opposite = s.number.at("opposite");
  require((s.text.at("finding") == "side") == is_side, "B3", "the body has another finding");
  require(s.number.at("patches") == patch, "B3", "the number of patches is", patch);
  require(s.number.at("flipped") == cuts.num_flipped, "B3", "the number of flipped is",
          cuts.num_flipped);
  require(is_side || (same == 0 && opposite == 0), "B3", "a crossing has same or opposite sides");
  const std::string text = std::to_string(patch) + " patches, ";
  if (!is_side) {
    check_crossing(crossing, sheet[0], sheet[1]);
    return text + "a crossing of patches " + std::to_string(crossing.sheet[0].patch) + " and " +
           std::to_string(crossing.sheet[1].patch);
  }
  check_sides(sides, outer, num_outer, same, opposite);
  return text + "an arc passed " + std::to_string(same) + " and, the other way, " +
         std::to_string(opposite) + " times";
}
