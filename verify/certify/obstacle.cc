// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/obstacle.h"

#include <algorithm>
#include <cmath>

#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using internal::dot;
using Id = PieceForest::Id;

constexpr std::size_t kMostOwn = 64;  // parts of the piece that are examined
constexpr double kFacing =
    -0.25;  // cosine of normals that face each other: sheets of a wedge of less than 75 degrees do

struct Facet {
  Point3d at, normal;
};

// The mean of the control points, and the mean normal of unit length (0 if that has no direction).
Facet facet_of(PieceForest& forest, Id id) {
  Facet out{{}, forest.approx_normal(id)};
  const double length = std::hypot(out.normal[0], out.normal[1], out.normal[2]);
  for (double& c : out.normal) c = length > 0 ? c / length : 0;
  const PieceForest::Form& form = forest.form(forest.node(id).patch);
  const std::size_t n = form.shape.count();
  const double* const x = forest.control(id);
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += form.is_rational ? x[k * n + i] / x[3 * n + i] : x[k * n + i];
    out.at[k] = form.origin[k] + sum / static_cast<double>(n);
  }
  return out;
}

bool has_normal(const Facet& a) { return dot(a.normal, a.normal) > 0; }

// The distance along the normals; infinity unless the facets face each other.
double gap_between(const Facet& a, const Facet& b) {
  if (dot(a.normal, b.normal) >= kFacing) return std::numeric_limits<double>::infinity();
  const Point3d d{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]};
  return std::max(std::abs(dot(d, a.normal)), std::abs(dot(d, b.normal)));
}

bool is_part(const PieceForest& forest, Id piece, Id of) {
  const std::uint8_t level = forest.node(of).level;
  while (forest.node(piece).level > level) piece = forest.node(piece).parent;
  return piece == of;
}

}  // namespace

double gap_between(PieceForest& forest, Id a, Id b) {
  return gap_between(facet_of(forest, a), facet_of(forest, b));
}

double gap_in_model(PieceForest& forest, Id a, Id b) {
  std::array<Facet, 2> facets{facet_of(forest, a), facet_of(forest, b)};
  for (Facet& f : facets) {
    for (std::size_t k = 0; k < 3; ++k) {
      f.at[k] = std::ldexp(f.at[k], -forest.frame().scale[k]);
      f.normal[k] = std::ldexp(f.normal[k], forest.frame().scale[k]);
    }
    const double length = std::hypot(f.normal[0], f.normal[1], f.normal[2]);
    for (double& c : f.normal) c = length > 0 ? c / length : 0;
  }
  const Point3d d{facets[0].at[0] - facets[1].at[0], facets[0].at[1] - facets[1].at[1],
                  facets[0].at[2] - facets[1].at[2]};
  return std::max(std::abs(dot(d, facets[0].normal)), std::abs(dot(d, facets[1].normal)));
}

Obstacle find_obstacle(PieceForest& forest, Id piece, const std::vector<Id>& near) {
  std::vector<Facet> all;
  std::vector<std::size_t> own;
  for (const Id id : near) {
    if (is_part(forest, id, piece)) own.push_back(all.size());
    all.push_back(facet_of(forest, id));
  }
  Obstacle out;
  const std::size_t step = 1 + own.size() / kMostOwn;
  double turn = 0;  // 1 minus the cosine of the angle between normals of the piece
  for (std::size_t i = 0; i < own.size(); i += step) {
    const Facet& a = all[own[i]];
    turn = std::max(turn, 1 - dot(a.normal, all[own[0]].normal));
    for (const Facet& b : all) {
      if (has_normal(a) && has_normal(b))
        out.least_cosine = std::min(out.least_cosine, dot(a.normal, b.normal));
      const double gap = gap_between(a, b);
      if (gap >= out.gap) continue;
      out.gap = gap;
      out.facing = {near[own[i]], near[static_cast<std::size_t>(&b - all.data())]};
    }
  }
  // Half the piece's length times the angle between its normals, which is at most twice their angle with the first
  // normal.
  const double bend = extent(forest.node(piece).hull) * std::sqrt(2 * turn);
  out.least_gap = std::max(0.0, out.gap - bend);
  return out;
}

}  // namespace veritope
