// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/open_tile.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "solids/micro/micro_validity.h"
#include "splines/bezier.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

constexpr int kCoilSpans = 4;
constexpr int kMaxCurveParts = 256;

Rational fraction_of(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

TilePatch curve_patch(std::vector<TilePoint> points) {
  TilePatch out;
  out.degrees = {static_cast<int>(points.size()) - 1, 0};
  out.points.push_back(std::move(points));
  return out;
}

// The control points of a turn of the coil, relative to its line.
constexpr std::array<int, kCoilSpans> kTurn{1, 0, -1, 0};
int turn_at(int i) { return kTurn[static_cast<std::size_t>((i + kCoilSpans) % kCoilSpans)]; }

// Coefficient k, 0 to 3, in Bernstein form, of the span from knot s to knot s + 1 of the cubic spline with uniform
// knots whose control points are turn_at(shift + i), that of knot i.
Rational coil_coefficient(int s, int k, int shift) {
  const int before = turn_at(shift + s - 1), at = turn_at(shift + s), next = turn_at(shift + s + 1),
            after = turn_at(shift + s + 2);
  switch (k) {
    case 0: return fraction_of(before + 4 * at + next, 6);
    case 1: return fraction_of(2 * at + next, 3);
    case 2: return fraction_of(at + 2 * next, 3);
    default: return fraction_of(at + 4 * next + after, 6);
  }
}

std::vector<TilePoint> coil_span(std::size_t axis, int span, const Rational& radius) {
  std::vector<TilePoint> out(4);
  for (int k = 0; k <= 3; ++k) {
    TilePoint& p = out[static_cast<std::size_t>(k)];
    p[axis] = fraction_of(3 * span + k, 3 * kCoilSpans);
    p[(axis + 1) % 3] = fraction_of(1, 4) + radius * coil_coefficient(span, k, 0);
    p[(axis + 2) % 3] = fraction_of(3, 4) + radius * coil_coefficient(span, k, 1);
  }
  return out;
}

// The point of a coil at n / parts of its length in parameters.
TilePoint coil_point(std::size_t axis, int n, int parts, const Rational& radius) {
  const int span = std::min(n * kCoilSpans / parts, kCoilSpans - 1);
  const Rational t = fraction_of(n * kCoilSpans - span * parts, parts);
  BezierCurve<Rational> curve({3}, 3, false);
  const std::vector<TilePoint> points = coil_span(axis, span, radius);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < points.size(); ++k)
      curve.component(static_cast<int>(c))[k] = points[k][c];
  const auto x = evaluate<Rational, 1>(curve, {t});
  return {x[0], x[1], x[2]};
}

bool lies_in_wall(const TilePatch& patch) {
  for (std::size_t a = 0; a < 3; ++a)
    for (const Rational& end : {Rational(0), Rational(1)}) {
      bool is_in = true;
      for (std::size_t power = 0; power < patch.points.size(); ++power)
        for (const TilePoint& p : patch.points[power])
          is_in = is_in && p[a] == (power == 0 ? end : Rational(0));
      if (is_in) return true;
    }
  return false;
}

}  // namespace

Result<MicroTile> curves3_tile(const Curves3Shape& shape) {
  if (!(Rational(0) < shape.radius && shape.radius < fraction_of(1, 4)))
    return bad_argument("radius = " + shape.radius.to_string() +
                        " of curves3 is not between 0 and 1/4");
  if (shape.parts && (*shape.parts < 1 || *shape.parts > kMaxCurveParts))
    return bad_argument("parts = " + std::to_string(*shape.parts) + " of curves3 is not 1 to " +
                        std::to_string(kMaxCurveParts));
  MicroTile out;
  out.is_open = true;
  out.name = "curves3,radius=" + shape.radius.to_string() +
             (shape.parts ? ",parts=" + std::to_string(*shape.parts) : "");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!shape.parts) {
      for (int span = 0; span < kCoilSpans; ++span)
        out.patches.push_back(curve_patch(coil_span(axis, span, shape.radius)));
      continue;
    }
    TilePoint last = coil_point(axis, 0, *shape.parts, shape.radius);
    for (int n = 1; n <= *shape.parts; ++n) {
      TilePoint next = coil_point(axis, n, *shape.parts, shape.radius);
      out.patches.push_back(curve_patch({last, next}));
      last = std::move(next);
    }
  }
  return out;
}

MicroTile sheets_of(MicroTile tile) {
  tile.is_open = true;
  std::erase_if(tile.patches, lies_in_wall);
  const bool depends = std::any_of(tile.patches.begin(), tile.patches.end(),
                                   [](const TilePatch& p) { return p.wall.has_value(); });
  if (!depends) tile.range.reset();
  return tile;
}

Status check_open_tile(const MicroTile& tile) {
  if (Status status = check_tile(tile, 0); !status) return status;
  for (std::size_t i = 0; i < tile.patches.size(); ++i) {
    if (tile.patches[i].wall) continue;
    for (const TilePoint& p : tile.patches[i].points.front())
      for (const Rational& x : p)
        if (x.sign() == Sign::kNegative || x > Rational(1))
          return bad_argument("patch " + std::to_string(i) +
                              " has a control point with the coordinate " + x.to_string() +
                              ", which is not in the unit cube");
  }
  return ok_status();
}

AnalysedTile analysis_of_open(MicroTile tile) {
  AnalysedTile out;
  out.cap_of_patch.assign(tile.patches.size(), AnalysedTile::kNoCap);
  out.tile = std::move(tile);
  return out;
}

}  // namespace veritope
