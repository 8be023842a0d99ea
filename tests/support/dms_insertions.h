// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_insertions.h: the law of insertion on random simplex-spline solids: values and derivatives stay
// exactly equal. For the unit tests and for the experiment soak_dms_insertions.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_insert.h"
#include "tests/support/random_dms.h"

namespace veritope {

struct DmsInsertionCounts {
  std::uint64_t insertions = 0, points = 0;
  std::uint64_t collapsed = 0;  ///< new clouds of one knot
  std::uint64_t inside = 0;     ///< points in the tetrahedron that was cut
  std::uint64_t creases = 0;    ///< points that rule H enters along the barycentre: on the boundary
};

namespace internal {

inline DmsPoint draw_inside(Random& random, const DmsModel& model, std::uint32_t tetrahedron) {
  DmsPoint sum;
  Rational total;
  for (const std::uint32_t v : model.tetrahedra[tetrahedron]) {
    const Rational weight(random.between(1, 9));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * model.knot(v, 0)[c];
    total += weight;
  }
  for (Rational& c : sum) c /= total;
  return sum;
}

/// The model with a vertex at a random place, its cloud halved until it is admissible. Nothing if ten places have no
/// admissible cloud: near a face whose knots reach across it even a collapsed one is not admissible.
inline std::optional<DmsInsertion> draw_insertion(Random& random, const DmsModel& model,
                                                  std::string& text) {
  for (int place = 0; place < 10; ++place) {
    const auto t = static_cast<std::uint32_t>(random.below(model.tetrahedra.size()));
    DmsCloud cloud{draw_inside(random, model, t)};
    const int last = model.degree - 1 + static_cast<int>(random.below(2));
    const bool is_collapsed = random.below(3) == 0;
    for (int i = 1; !is_collapsed && i <= last; ++i) {
      DmsPoint knot = cloud[0];
      for (Rational& c : knot) c += Rational(random.between(-6, 6)) / Rational(60);
      cloud.push_back(knot);
    }
    for (int halving = 0; halving < 6; ++halving) {
      Result<DmsInsertion> out = insert_dms_vertex(model, cloud);
      VT_CHECK(out.has_value() && out->tetrahedron == t, "a point inside is inserted");
      if (out->defects.count == 0) {
        text += ", vertex " + text_of(cloud[0]) + " with " + std::to_string(cloud.size()) +
                " knots in " + std::to_string(t);
        return std::move(*out);
      }
      for (std::size_t i = 1; i < cloud.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) cloud[i][c] = (cloud[i][c] + cloud[0][c]) / Rational(2);
    }
  }
  return std::nullopt;
}

}  // namespace internal

/// "" or the law that is broken, with the seed. The derivatives are compared on the path that rule H takes before the
/// insertion; the values on the path after it, too.
inline std::string check_dms_insertion(std::uint64_t seed, int max_degree, int points,
                                       DmsInsertionCounts& counts) {
  RandomDms drawn = draw_dms(seed, max_degree, 1);
  Random random(seed + 1'000'000'007);
  const DmsModel& model = drawn.model;
  const auto drawn_insertion = internal::draw_insertion(random, model, drawn.text);
  if (!drawn_insertion) return "";
  const DmsInsertion& inserted = *drawn_insertion;
  if (!validate(inserted.model)) return drawn.text + ": the model is not valid";
  ++counts.insertions;
  counts.collapsed += inserted.model.clouds.back().size() == 1;
  DmsEvaluator before(model), after(inserted.model);
  for (int i = 0; i < points; ++i) {
    // Half of the points lie in the parts, or on their faces, edges and planes of knots.
    DmsPoint u = draw_dms_point(random, i % 4 == 0 ? model : inserted.model);
    if (i % 4 == 1) u = internal::draw_inside(random, model, inserted.tetrahedron);
    const std::string at = drawn.text + ", at " + text_of(u) + ": ";
    const auto old_place = before.locate(u), new_place = after.locate(u);
    if (!old_place || !new_place) return at + "the point is not in both domains";
    const DmsValue old_value = before.evaluate(*old_place);
    const DmsValue on_old_path = after.evaluate({new_place->tetrahedron, old_place->path});
    if (on_old_path.value != old_value.value) return at + "the value changes";
    if (on_old_path.gradient != old_value.gradient) return at + "the derivative changes";
    const bool is_crease = old_place->path.target().has_value();
    if (is_crease && after.evaluate(*new_place).value != old_value.value)
      return at + "the value changes on the path of the new model";
    ++counts.points;
    counts.inside += old_place->tetrahedron == inserted.tetrahedron;
    counts.creases += is_crease;
  }
  return "";
}

}  // namespace veritope
