// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_internal.h: what the edits of a V-complex share.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "topology/v_complex.h"

namespace veritope::internal {

/// The tables of a complex, for its edits.
struct VComplexAccess {
  static VComplexTables& tables(VComplex& complex) { return complex.tables_; }
};

/// The uses of a loop from u on. REQUIRES that next is a permutation.
std::vector<CurveUseId> loop_of(const VComplexTables& t, CurveUseId u);
/// All uses of a half-V-surface, loop after loop.
std::vector<CurveUseId> uses_of_half(const VComplexTables& t, HalfVSurfaceId h);
/// The uses of the fan with this first use, in radial order.
VFan fan_of(const VComplexTables& t, CurveUseId first);
/// All uses of a V-curve, by its list of fans.
std::vector<CurveUseId> uses_of_curve(const VComplexTables& t, VCurveId c);
/// All uses that begin at p.
std::vector<CurveUseId> uses_from(const VComplexTables& t, VPointId p);

/// The first use of each fan of these uses of one curve; REQUIRES that they are whole fans. Ascending.
std::vector<CurveUseId> fans_of_uses(const VComplexTables& t, std::vector<CurveUseId> uses);

/// Makes v the use after u.
void join_uses(VComplexTables& t, CurveUseId u, CurveUseId v);
/// Makes v the use after u, and the mate of u the one after the mate of v if there are mates.
void join_uses_and_mates(VComplexTables& t, CurveUseId u, CurveUseId v);
/// Makes the two the uses across each other, or mates of each other.
void pair_across(VComplexTables& t, CurveUseId u, CurveUseId v);
void pair_mates(VComplexTables& t, CurveUseId u, CurveUseId v);

/// Removes from the list of loops of u's half-V-surface the loop that holds u.
void forget_loop(VComplexTables& t, CurveUseId u);
/// Gives all uses of u's loop to h, and adds the loop to its list.
void take_loop(VComplexTables& t, HalfVSurfaceId h, CurveUseId u);

/// Adds c to, or removes c from, the list of the point. A point without curves is removed by drop_curve_at.
void add_curve_at(VComplexTables& t, VPointId p, VCurveId c);
void drop_curve_at(VComplexTables& t, VPointId p, VCurveId c);

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}
template <class Id>
std::string id_text(Id id) {
  return std::to_string(id.value);
}

}  // namespace veritope::internal
