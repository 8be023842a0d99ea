// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/v_complex_homology.h"

#include <cstddef>
#include <map>
#include <string>

#include "robust/base/int128.h"
#include "topology/v_complex_internal.h"
#include "topology/v_complex_links.h"

namespace veritope {
namespace {

using Column = std::map<std::uint32_t, std::int32_t>;

void append_column(IntegerMatrix& matrix, const Column& column) {
  auto& out = matrix.columns.emplace_back();
  for (const auto& entry : column)
    if (entry.second != 0) out.push_back(entry);
}

// The rank of an element among those that exist.
template <class Id, class T>
std::vector<std::uint32_t> ranks_of(const IdTable<Id, T>& table) {
  std::vector<std::uint32_t> out(table.end_id());
  std::uint32_t next = 0;
  for (const Id id : table) out[id.value] = next++;
  return out;
}

std::uint64_t residue_product(std::uint64_t a, std::uint64_t b, std::uint64_t prime) {
  return static_cast<std::uint64_t>(static_cast<uint128>(a) * b % prime);
}
std::uint64_t residue_inverse(std::uint64_t a, std::uint64_t prime) {
  std::uint64_t out = 1;
  for (std::uint64_t e = prime - 2; e != 0; e >>= 1) {
    if ((e & 1) != 0) out = residue_product(out, a, prime);
    a = residue_product(a, a, prime);
  }
  return out;
}

using ResidueColumn =
    std::vector<std::pair<std::uint32_t, std::uint64_t>>;  // rows ascending, no zeros

// a - factor * b.
ResidueColumn minus_multiple(const ResidueColumn& a, const ResidueColumn& b, std::uint64_t factor,
                             std::uint64_t prime) {
  ResidueColumn out;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool in_a = i < a.size() && (j == b.size() || a[i].first <= b[j].first);
    const bool in_b = j < b.size() && (i == a.size() || b[j].first <= a[i].first);
    const std::uint32_t row = in_a ? a[i].first : b[j].first;
    std::uint64_t value = in_a ? a[i++].second : 0;
    if (in_b) {
      const std::uint64_t less = residue_product(factor, b[j++].second, prime);
      value = value >= less ? value - less : value + prime - less;
    }
    if (value != 0) out.emplace_back(row, value);
  }
  return out;
}

// The bridges through a V-surface or V-cell as more columns of d1: from the first point to each of the others.
void append_bridges(IntegerMatrix& d1, const std::vector<std::uint32_t>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    Column column;
    column[points[i]] += 1;
    column[points[0]] -= 1;
    append_column(d1, column);
  }
}

}  // namespace

bool IntegerMatrix::is_zero() const {
  for (const auto& column : columns)
    if (!column.empty()) return false;
  return true;
}

IntegerMatrix product(const IntegerMatrix& a, const IntegerMatrix& b) {
  VT_CHECK(a.columns.size() == b.num_rows, "matrices that do not fit");
  IntegerMatrix out{a.num_rows, {}};
  for (const auto& column : b.columns) {
    Column sum;
    for (const auto& [k, factor] : column)
      for (const auto& [row, entry] : a.columns[k]) sum[row] += factor * entry;
    append_column(out, sum);
  }
  return out;
}

BoundaryMaps boundary_maps(const VComplex& complex) {
  const VComplexTables& t = complex.tables();
  const auto surface = ranks_of(t.surfaces), curve = ranks_of(t.curves), point = ranks_of(t.points);
  BoundaryMaps out;
  out.d3.num_rows = static_cast<std::uint32_t>(t.surfaces.size());
  out.d2.num_rows = static_cast<std::uint32_t>(t.curves.size());
  out.d1.num_rows = static_cast<std::uint32_t>(t.points.size());
  for (const VCellId c : t.cells) {
    Column column;
    for (const HalfVSurfaceId h : t.cells[c].half_surfaces) {
      const VSurfaceId s = t.half_surfaces[h].surface;
      column[surface[s.value]] += t.surfaces[s].halves[0] == h ? 1 : -1;
    }
    append_column(out.d3, column);
  }
  for (const VSurfaceId s : t.surfaces) {
    Column column;
    for (const CurveUseId u : internal::uses_of_half(t, t.surfaces[s].halves[0]))
      column[curve[t.uses[u].curve.value]] += t.uses[u].is_forward ? 1 : -1;
    append_column(out.d2, column);
  }
  for (const VCurveId c : t.curves) {
    Column column;
    column[point[t.curves[c].ends[1].value]] += 1;
    column[point[t.curves[c].ends[0].value]] -= 1;
    append_column(out.d1, column);
  }
  return out;
}

std::int64_t euler_characteristic(const VComplex& complex) {
  const VComplexTables& t = complex.tables();
  std::int64_t out =
      static_cast<std::int64_t>(t.points.size()) - static_cast<std::int64_t>(t.curves.size());
  for (const VSurfaceId s : t.surfaces)
    out += 2 - static_cast<std::int64_t>(t.half_surfaces[t.surfaces[s].halves[0]].loops.size());
  for (const VCellId c : t.cells)
    for (const VCellBoundaryComponent& component : boundary_of_cell(complex, c))
      out -= component.euler() / 2;
  return out;
}

std::uint64_t rank_modulo(const IntegerMatrix& matrix, std::uint64_t prime) {
  std::vector<ResidueColumn> by_pivot(
      matrix.num_rows);  // the columns kept, by their last row; entry 1 there
  std::uint64_t rank = 0;
  for (const auto& entries : matrix.columns) {
    ResidueColumn column;
    for (const auto& [row, entry] : entries) {
      const auto size =
          static_cast<std::uint64_t>(entry < 0 ? -std::int64_t{entry} : std::int64_t{entry}) %
          prime;
      if (size != 0) column.emplace_back(row, entry < 0 ? prime - size : size);
    }
    while (!column.empty() && !by_pivot[column.back().first].empty())
      column = minus_multiple(column, by_pivot[column.back().first], column.back().second, prime);
    if (column.empty()) continue;
    const std::uint64_t inverse = residue_inverse(column.back().second, prime);
    for (auto& entry : column) entry.second = residue_product(entry.second, inverse, prime);
    const std::uint32_t pivot = column.back().first;
    by_pivot[pivot] = std::move(column);
    ++rank;
  }
  return rank;
}

Result<std::array<std::uint64_t, 4>> betti_numbers(const VComplex& complex) {
  const VComplexTables& t = complex.tables();
  const auto rank_of_point = ranks_of(t.points);
  const auto point_of = [&](CurveUseId u) { return rank_of_point[t.start(u).value]; };
  BoundaryMaps maps = boundary_maps(complex);
  for (const VSurfaceId s : t.surfaces) {
    std::vector<std::uint32_t> points;
    for (const CurveUseId u : t.half_surfaces[t.surfaces[s].halves[0]].loops)
      points.push_back(point_of(u));
    append_bridges(maps.d1, points);
  }
  for (const VCellId c : t.cells) {
    std::vector<std::uint32_t> points;
    for (const VCellBoundaryComponent& component : boundary_of_cell(complex, c)) {
      if (component.genus() != 0) {
        Error error = bad_argument(
            "V-cell " + internal::id_text(c) + " has a boundary surface of genus " +
            std::to_string(component.genus()) + ": cut it along cycles of V-curves first");
        error.place.entity = c.value;
        return error;
      }
      points.push_back(point_of(t.half_surfaces[component.first_half].loops[0]));
    }
    append_bridges(maps.d1, points);
  }
  const std::uint64_t r3 = rank_modulo(maps.d3, kBettiPrime),
                      r2 = rank_modulo(maps.d2, kBettiPrime),
                      r1 = rank_modulo(maps.d1, kBettiPrime);
  const std::uint64_t n3 = t.cells.size(), n2 = t.surfaces.size(), n1 = maps.d1.columns.size(),
                      n0 = t.points.size();
  return std::array<std::uint64_t, 4>{n0 - r1, n1 - r1 - r2, n2 - r2 - r3, n3 - r3};
}

}  // namespace veritope
