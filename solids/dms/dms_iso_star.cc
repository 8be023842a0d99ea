// SPDX-License-Identifier: LGPL-3.0-or-later
// Vertices at which g = c: the last part of DMS-4 (docs/THEORY.md).
#include <algorithm>
#include <map>
#include <utility>

#include "interval/upward.h"
#include "solids/dms/dms_iso_cells_internal.h"

namespace veritope::internal {
namespace {

Rational determinant(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c) {
  return dot_product(a, cross_product(b, c));
}

}  // namespace

std::vector<std::uint32_t> IsoCells::star(std::uint32_t vertex) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t c : at_zero_.at(vertex))
    if (cells[c].is_alive) out.push_back(c);
  return out;
}

std::vector<DmsPoint> IsoCells::parallel_at(std::uint32_t vertex) const {
  // The other two vertices of each face at the vertex, and how many cells have it.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces;
  for (const std::uint32_t c : star(vertex))
    for (const auto& [i, j] : kDmsEdges) {
      const std::uint32_t a = cells[c].corners[i], b = cells[c].corners[j];
      if (a != vertex && b != vertex) ++faces[{std::min(a, b), std::max(a, b)}];
    }
  std::vector<DmsPoint> span{{Rational(1), Rational(0), Rational(0)},
                             {Rational(0), Rational(1), Rational(0)},
                             {Rational(0), Rational(0), Rational(1)}};
  for (const auto& [ends, count] : faces) {
    if (count != 1) continue;
    const DmsPoint a = difference(vertices[ends.first].at, vertices[vertex].at),
                   b = difference(vertices[ends.second].at, vertices[vertex].at),
                   normal = cross_product(a, b);
    if (std::all_of(span.begin(), span.end(), [&](const DmsPoint& d) {
          return dot_product(normal, d).sign() == Sign::kZero;
        }))
      continue;
    if (span.size() == 3) {
      span = {a, b};
    } else if (span.size() == 2) {
      span = {cross_product(normal, cross_product(span[0], span[1]))};
    } else {
      return {};
    }
  }
  return span;
}

bool IsoCells::grows_around(std::uint32_t vertex) const {
  const std::vector<DmsPoint> span = parallel_at(vertex);
  if (span.empty()) return false;
  DmsIsoSlopes all;
  std::vector<DmsIsoSlopes> of_cells;
  for (const std::uint32_t c : star(vertex)) {
    const IsoCell& cell = cells[c];
    const auto m = static_cast<std::size_t>(
        std::find(cell.corners.begin(), cell.corners.end(), vertex) - cell.corners.begin());
    std::vector<DmsPoint> edges;
    for (std::size_t k = 0; k < 4; ++k)
      if (k != m) edges.push_back(difference(vertices[cell.corners[k]].at, vertices[vertex].at));
    // The coordinates of each vector of the span along the edges.
    std::array<std::array<Interval, 3>, 3> shares{};
    const Rational volume = determinant(edges[0], edges[1], edges[2]);
    for (std::size_t d = 0; d < span.size(); ++d)
      for (std::size_t k = 0; k < 3; ++k)
        shares[d][k] =
            enclose(determinant(span[d], edges[(k + 1) % 3], edges[(k + 2) % 3]) / volume);
    const ScopedUpward upward;
    DmsIsoSlopes along = rule_.slopes(cell.form, kAllCorners, m);
    for (auto* list : {&along.polynomial, &along.rests})
      for (DmsIsoSlopes::Slope& slope : *list) {
        DmsIsoSlopes::Slope moved{};
        for (std::size_t d = 0; d < span.size(); ++d)
          for (std::size_t k = 0; k < 3; ++k) moved[d] = moved[d] + shares[d][k] * slope[k];
        slope = moved;
      }
    all.polynomial.insert(all.polynomial.end(), along.polynomial.begin(), along.polynomial.end());
    of_cells.push_back(std::move(along));
  }
  const ScopedUpward upward;
  const auto e = all.guess_direction(true);
  return e && std::all_of(of_cells.begin(), of_cells.end(),
                          [&](const DmsIsoSlopes& s) { return s.all_grow_along(*e); });
}

void IsoCells::cut_star(std::uint32_t vertex) {
  std::uint32_t chosen = 0;
  std::size_t edge = 0;
  Rational most;
  for (const std::uint32_t c : star(vertex))
    for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
      const auto [i, j] = kDmsEdges[e];
      if (cells[c].corners[i] != vertex && cells[c].corners[j] != vertex) continue;
      Rational length = squared_length(cells[c].corners[i], cells[c].corners[j]);
      if (length > most) most = std::move(length), chosen = c, edge = e;
    }
  if (most.sign() == Sign::kPositive) cut(chosen, edge, Rational(1) / Rational(2));
}

}  // namespace veritope::internal
