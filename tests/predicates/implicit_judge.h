// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/implicit_judge.h: every predicate on implicit points beside the rational points.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "predicates/implicit_predicates.h"
#include "tests/predicates/implicit_cases.h"
#include "tests/predicates/implicit_oracle.h"

namespace veritope::judge {

struct Question {
  const char* name;
  Sign found;
  int expected;
};

/// All questions about five points in space that exist, x[i] = where p[i] is; a direction and an offset for
/// the linear ones.
template <typename Report>
void questions3(const std::array<AnyPoint3, 5>& p, const std::array<oracle::Exact, 5>& x,
                const Vec3d& direction, double offset, TierCounts* tally, Report report) {
  using oracle::Exact;
  report(Question{"orient3d", orient3d(p[0], p[1], p[2], p[3], tally),
                  oracle::orient({x[0], x[1], x[2], x[3]})});
  report(Question{"in_sphere", in_sphere(p[0], p[1], p[2], p[3], p[4], tally),
                  oracle::in_ball({x[0], x[1], x[2], x[3], x[4]})});
  for (int axis = 0; axis < 3; ++axis) {
    const auto drop = [&](const Exact& v) { return Exact{v[(axis + 1) % 3], v[(axis + 2) % 3]}; };
    report(Question{"orient2d_projected", orient2d_projected(p[0], p[1], p[4], axis, tally),
                    oracle::orient({drop(x[0]), drop(x[1]), drop(x[4])})});
    report(Question{"compare_axis", compare_axis(p[0], p[1], axis, tally),
                    sgn(mpq_class(x[0][axis] - x[1][axis]))});
  }
  report(Question{"compare_along", compare_along(direction, p[0], p[1], tally),
                  oracle::along(oracle::exact(direction), x[0], x[1])});
  report(Question{"side_of_plane", side_of_plane({direction, offset}, p[2], tally),
                  sgn(mpq_class(oracle::dot(oracle::exact(direction), x[2]) + mpq_class(offset)))});
  report(Question{"compare_lexicographic", compare_lexicographic(p[0], p[1], tally),
                  x[0] < x[1] ? -1 : (x[1] < x[0] ? 1 : 0)});
}

template <typename Report>
void questions2(const std::array<AnyPoint2, 5>& p, const std::array<oracle::Exact, 5>& x,
                const Vec2d& direction, TierCounts* tally, Report report) {
  report(
      Question{"orient2d", orient2d(p[0], p[1], p[2], tally), oracle::orient({x[0], x[1], x[2]})});
  report(Question{"in_circle", in_circle(p[0], p[1], p[2], p[3], tally),
                  oracle::in_ball({x[0], x[1], x[2], x[3]})});
  for (int axis = 0; axis < 2; ++axis) {
    report(Question{"compare_axis", compare_axis(p[0], p[1], axis, tally),
                    sgn(mpq_class(x[0][axis] - x[1][axis]))});
  }
  report(Question{"compare_along", compare_along(direction, p[0], p[1], tally),
                  oracle::along(oracle::exact(direction), x[0], x[1])});
  report(Question{"compare_lexicographic", compare_lexicographic(p[0], p[1], tally),
                  x[0] < x[1] ? -1 : (x[1] < x[0] ? 1 : 0)});
}

/// Half of the time -direction . x, rounded: mostly exact, so that x lies on the plane.
inline double offset_for(const Vec3d& direction, const oracle::Exact& x, Random& random) {
  const double through = -mpq_class(oracle::dot(oracle::exact(direction), x)).get_d();
  return random.below(2) == 0 && std::isfinite(through) ? through : 1;
}

/// A random case of every predicate of the dimension. report(question); the text of the case in `text`. False
/// if some point does not exist; agrees = does is_defined() say the same of each?
template <typename Report>
bool ask(Random& random, int dimension, std::string& text, bool& agrees, TierCounts* tally,
         Report report) {
  const auto definitions = generate::implicit_case(random, dimension);
  text.clear();
  for (const generate::Disguised& d : definitions) text += generate::text(d);
  std::array<oracle::Exact, 5> x;
  bool exist = true;
  agrees = true;
  const auto look = [&](const auto& variant, std::size_t i) {
    const auto at = std::visit([](const auto& v) { return oracle::point(v); }, variant);
    const bool is_defined = std::visit(
        [](const auto& v) {
          if constexpr (requires { v.is_defined(); }) {
            return v.is_defined();
          } else {
            return true;
          }
        },
        variant);
    agrees = agrees && is_defined == at.has_value();
    exist = exist && at.has_value();
    if (at) x[i] = *at;
  };
  if (dimension == 3) {
    std::vector<generate::Point3> p;
    for (std::size_t i = 0; i < 5; ++i)
      p.push_back(generate::make3(definitions[i], random.below(2) == 0)), look(p[i], i);
    if (!exist || !agrees) return false;
    const generate::Points numbers = generate::points(
        random.below(2) == 0 ? generate::Kind::kSmallGrid : generate::Kind::kMixedExtremes, random);
    using generate::any;
    questions3({any(p[0]), any(p[1]), any(p[2]), any(p[3]), any(p[4])}, x, numbers[0],
               offset_for(numbers[0], x[2], random), tally, report);
  } else {
    std::vector<generate::Point2> p;
    for (std::size_t i = 0; i < 5; ++i) p.push_back(generate::make2(definitions[i])), look(p[i], i);
    if (!exist || !agrees) return false;
    const generate::Points numbers = generate::points(generate::Kind::kSmallGrid, random);
    using generate::any;
    questions2({any(p[0]), any(p[1]), any(p[2]), any(p[3]), any(p[4])}, x,
               {numbers[0].x, numbers[0].y}, tally, report);
  }
  return true;
}

}  // namespace veritope::judge
