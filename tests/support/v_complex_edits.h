// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/v_complex_edits.h: edits of a V-complex from any numbers, and what must hold after each: for tests,
// soak and fuzzing. A sequence that breaks a law shrinks to a short one that does.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_boundary.h"
#include "topology/v_complex_edit.h"
#include "topology/v_complex_homology.h"
#include "topology/v_complex_links.h"

namespace veritope::v_edits {

using Step = std::array<std::uint32_t, 5>;  // the edit, and numbers that choose its arguments
using Sequence = std::vector<Step>;

enum class Edit : std::uint32_t {
  kAddCell,
  kRemoveCell,
  kGlue,
  kUnglue,
  kSplitCurve,
  kMergeCurves,
  kSplitSurface,
  kMergeSurfaces,
  kSplitCell,
  kMergeCells,
  kIdentifyPoints,
  kIdentifyCurves,
  kCompact
};
inline constexpr std::uint32_t kNumEdits = 13;
inline constexpr std::size_t kMaxUses = 400;  // edits that add elements are left out above this

/// As text that can be pasted into a test.
inline std::string to_text(const Sequence& sequence) {
  std::string out = "{";
  for (const Step& step : sequence) {
    out += out.size() > 1 ? ", {" : "{";
    for (std::size_t i = 0; i < step.size(); ++i)
      out += (i > 0 ? ", " : "") + std::to_string(step[i]);
    out += "}";
  }
  return out + "}";
}

inline Sequence random_sequence(std::uint64_t seed, std::size_t steps) {
  // Edits by weight: what is added must not be removed at once.
  constexpr std::array<std::uint32_t, 24> kWeights{0, 0, 0, 1, 2, 2, 2, 2, 2, 3,  3,  4,
                                                   4, 5, 6, 6, 7, 8, 8, 8, 9, 10, 11, 12};
  Random random(seed);
  Sequence out;
  for (std::size_t i = 0; i < steps; ++i) {
    Step& step = out.emplace_back();
    step[0] = i < 2 ? 0 : kWeights[random.below(kWeights.size())];
    for (std::size_t k = 1; k < step.size(); ++k)
      step[k] = static_cast<std::uint32_t>(random.below(1000));
  }
  return out;
}

/// The element of this number, counted cyclically; none in an empty table.
template <class Id, class T>
Id pick(const IdTable<Id, T>& table, std::uint32_t number) {
  if (table.empty()) return {};
  auto left = number % table.size();
  for (const Id id : table)
    if (left-- == 0) return id;
  return {};
}

inline VComplexData shape_of(std::uint32_t number) {
  switch (number % 6) {
    case 0: return v_shapes::data_of({v_shapes::cube()});
    case 1: return v_shapes::data_of({v_shapes::tetrahedron()});
    case 2: return v_shapes::data_of({v_shapes::triangular_prism()});
    case 3: return v_shapes::data_of({v_shapes::cube_with_through_hole()});
    case 4: return v_shapes::data_of({v_shapes::cube_with_window()});
    default: return v_shapes::data_of({v_shapes::cube_with_void()});
  }
}

inline std::vector<std::size_t> loop_lengths(const VComplex& complex, HalfVSurfaceId h) {
  std::vector<std::size_t> out;
  for (const auto& loop : complex.loops(h)) out.push_back(loop.size());
  return out;
}

/// Pairs for a gluing of one free half-V-surface with the next one of the same shape; no pair if there is no such one.
inline std::vector<UsePair> some_gluing(const VComplex& complex, const Step& step) {
  std::vector<HalfVSurfaceId> free;
  for (const HalfVSurfaceId h : complex.tables().half_surfaces)
    if (complex.mate(h).is_none()) free.push_back(h);
  if (free.empty()) return {};
  const std::size_t a = step[1] % free.size();
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::size_t b = (step[2] + k) % free.size();
    // Sometimes anything is tried, so that the edit must refuse it.
    if (step[4] % 16 != 0 &&
        (a == b || loop_lengths(complex, free[a]) != loop_lengths(complex, free[b])))
      continue;
    const auto loops_a = complex.loops(free[a]), loops_b = complex.loops(free[b]);
    std::vector<UsePair> out;
    for (std::size_t i = 0; i < std::min(loops_a.size(), loops_b.size()); ++i)
      out.push_back({loops_a[i][0], loops_b[i][(step[3] + i * step[4]) % loops_b[i].size()]});
    return out;
  }
  return {};
}

/// A walk along V-curves on the boundary of a cell, until it comes to a corner again; the cycle that it closes.
inline std::vector<CurveUseId> some_cycle(const VComplex& complex, const Step& step) {
  const VComplexTables& t = complex.tables();
  CurveUseId at = pick(t.uses, step[1]);
  if (at.is_none()) return {};
  Random random(step[2]);
  std::vector<CurveUseId> path;
  std::vector<std::set<CurveUseId>> corners;
  for (;;) {
    std::set<CurveUseId> corner{at};
    for (CurveUseId u = t.uses[t.uses[at].across].next; u != at; u = t.uses[t.uses[u].across].next)
      corner.insert(u);
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i] == corner) return {path.begin() + static_cast<std::ptrdiff_t>(i), path.end()};
    auto choice = corner.begin();
    std::advance(choice, static_cast<std::ptrdiff_t>(random.below(corner.size())));
    corners.push_back(corner);
    path.push_back(*choice);
    at = t.uses[*choice].next;
  }
}

inline std::vector<CurveUseId> some_loops(const VComplex& complex, CurveUseId from,
                                          std::uint32_t number) {
  std::vector<CurveUseId> out;
  if (from.is_none()) return out;
  for (const auto& loop : complex.loops(complex.use(from).half_surface)) {
    const bool has_from = std::find(loop.begin(), loop.end(), from) != loop.end();
    if ((number & 1) != 0 && !has_from) out.push_back(loop[0]);
    number >>= 1;
  }
  return out;
}

template <class T>
bool is_done(const Result<T>& result) {
  return result.has_value();
}

/// Tries the edit; false if it was refused.
inline bool apply(VComplex& complex, const Step& step) {
  const VComplexTables& t = complex.tables();
  const bool is_full = t.uses.size() > kMaxUses;
  switch (static_cast<Edit>(step[0] % kNumEdits)) {
    case Edit::kAddCell: return !is_full && is_done(add_cell(complex, shape_of(step[1])));
    case Edit::kRemoveCell: return is_done(remove_cell(complex, pick(t.cells, step[1])));
    case Edit::kGlue: return is_done(glue(complex, some_gluing(complex, step)));
    case Edit::kUnglue: return is_done(unglue(complex, pick(t.surfaces, step[1])));
    case Edit::kSplitCurve:
      return !is_full && is_done(split_curve(complex, pick(t.curves, step[1])));
    case Edit::kMergeCurves: return is_done(merge_curves(complex, pick(t.points, step[1])));
    case Edit::kSplitSurface: {
      const CurveUseId from = pick(t.uses, step[1]);
      if (is_full || from.is_none()) return false;
      const auto loops = complex.loops(complex.use(from).half_surface);
      const auto& loop = loops[step[2] % loops.size()];
      const CurveUseId to = loop[step[3] % loop.size()];
      return is_done(split_surface(complex, from, to, some_loops(complex, from, step[4])));
    }
    case Edit::kMergeSurfaces: return is_done(merge_surfaces(complex, pick(t.curves, step[1])));
    case Edit::kSplitCell: {
      if (is_full) return false;
      const auto cycle = some_cycle(complex, step);
      std::vector<HalfVSurfaceId> moved;
      if (step[4] % 4 == 0) moved.push_back(pick(t.half_surfaces, step[3]));
      return is_done(split_cell(complex, cycle, step[3] % 50 == 0 ? 1 : 0, moved));
    }
    case Edit::kMergeCells: return is_done(merge_cells(complex, pick(t.surfaces, step[1])));
    case Edit::kIdentifyPoints:
      return is_done(identify_points(complex, pick(t.points, step[1]), pick(t.points, step[2])));
    case Edit::kIdentifyCurves:
      return is_done(identify_curves(complex, pick(t.curves, step[1]), pick(t.curves, step[2]),
                                     step[3] % 2 == 1));
    case Edit::kCompact: complex = compacted(complex); return true;
  }
  return false;
}

/// The edits that change the decomposition and not the space.
inline bool keeps_space(const Step& step) {
  const auto edit = static_cast<Edit>(step[0] % kNumEdits);
  return (edit >= Edit::kSplitCurve && edit <= Edit::kMergeCells) || edit == Edit::kCompact;
}

/// What is wrong with a complex in itself; empty if nothing is.
inline std::string fault_of(const VComplex& complex) {
  if (const auto violation = validate(complex.tables()))
    return "invariant " + std::to_string(static_cast<int>(violation->invariant)) + ": " +
           violation->message;
  const BoundaryMaps maps = boundary_maps(complex);
  if (!product(maps.d2, maps.d3).is_zero()) return "d2 d3 is not zero";
  if (!product(maps.d1, maps.d2).is_zero()) return "d1 d2 is not zero";
  const BoundaryBrep brep = boundary_brep(complex);
  for (const VShell& shell : brep.shells)
    if (shell.euler() % 2 != 0 || shell.genus() < 0) return "a shell without a genus";
  for (const VCellId c : complex.tables().cells)
    for (const VCellBoundaryComponent& component : boundary_of_cell(complex, c))
      if (component.euler() % 2 != 0 || component.genus() < 0)
        return "a cell's boundary without a genus";
  // The cut surface of a small ball around a point: closed, or with boundary circles.
  std::int64_t sum = 0;
  for (const VPointId p : complex.tables().points) {
    const VPointLink link = link_of(complex, p);
    for (const VPointLinkComponent& component : link.components) {
      if (component.genus() < 0 ||
          (component.euler() + static_cast<std::int64_t>(component.boundary_circles)) % 2 != 0)
        return "a link without a genus";
      sum += component.euler();
    }
  }
  // The ends of all fans, the corners of all V-surfaces and V-cells, counted in another way.
  std::int64_t want = 0;
  const VComplexTables& t = complex.tables();
  for (const VCurveId c : t.curves) want += 2 * static_cast<std::int64_t>(t.curves[c].fans.size());
  for (const CurveUseId u : t.uses) {
    const CurveUseId m = t.uses[u].mate;
    want -= m.is_none() || u < m ? 1 : 0;
  }
  for (const VCellId c : t.cells)
    for (const VCellBoundaryComponent& component : boundary_of_cell(complex, c))
      want += static_cast<std::int64_t>(component.corners);
  return sum == want ? "" : "the links do not sum up";
}

struct Tally {
  std::uint64_t done = 0, refused = 0;
  std::array<std::uint64_t, kNumEdits> done_by_edit{};
};

/// Runs a sequence from the empty complex. What is wrong after the first step that breaks a law; empty if none does.
inline std::string run(const Sequence& sequence, bool with_betti = false, Tally* tally = nullptr,
                       const std::function<bool(const VComplex&)>& also = {}) {
  VComplex complex;
  std::int64_t euler = 0;
  std::optional<std::array<std::uint64_t, 4>> betti = std::array<std::uint64_t, 4>{};
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::string where = "step " + std::to_string(i) + ": ";
    const VComplexTables before = complex.tables();
    const bool is_applied = apply(complex, sequence[i]);
    if (!is_applied && !(complex.tables() == before))
      return where + "an edit was refused, and changed something";
    if (tally != nullptr) {
      ++(is_applied ? tally->done : tally->refused);
      tally->done_by_edit[sequence[i][0] % kNumEdits] += is_applied ? 1 : 0;
    }
    if (!is_applied) continue;
    const std::string fault = fault_of(complex);
    if (!fault.empty()) return where + fault;
    const std::int64_t now = euler_characteristic(complex);
    if (keeps_space(sequence[i]) && now != euler) return where + "the Euler characteristic changed";
    euler = now;
    if (also && !also(complex)) return where + "the law does not hold";
    if (!with_betti) continue;
    const auto numbers = betti_numbers(complex);
    std::optional<std::array<std::uint64_t, 4>> next;
    if (numbers) next = numbers.value();
    if (next) {
      const auto& b = *next;
      const auto alternating =
          static_cast<std::int64_t>(b[0] + b[2]) - static_cast<std::int64_t>(b[1] + b[3]);
      if (alternating != now)
        return where + "the Betti numbers do not give the Euler characteristic";
    }
    if (next && betti && keeps_space(sequence[i]) && *next != *betti)
      return where + "the Betti numbers changed";
    betti = next;
  }
  return {};
}

/// A shorter sequence of lesser numbers that fails, too. REQUIRES fails(sequence).
inline Sequence shrink(Sequence sequence, const std::function<bool(const Sequence&)>& fails) {
  for (std::size_t size = sequence.size(); size > 0; size /= 2) {
    for (std::size_t at = 0; at + size <= sequence.size();) {
      Sequence less = sequence;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(at),
                 less.begin() + static_cast<std::ptrdiff_t>(at + size));
      if (fails(less)) {
        sequence = less;
      } else {
        at += size;
      }
    }
  }
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    for (std::size_t k = 1; k < sequence[i].size(); ++k) {
      for (std::uint32_t cut = sequence[i][k]; cut > 0; cut /= 2) {
        Sequence less = sequence;
        less[i][k] -= std::min(cut, less[i][k]);
        if (fails(less)) sequence = less;
      }
    }
  }
  return sequence;
}

/// Empty if all laws hold; else the shrunken sequence and what it breaks.
inline std::string run_and_shrink(const Sequence& sequence, bool with_betti = false,
                                  Tally* tally = nullptr) {
  if (run(sequence, with_betti, tally).empty()) return {};
  const Sequence small =
      shrink(sequence, [&](const Sequence& s) { return !run(s, with_betti).empty(); });
  return run(small, with_betti) + " of " + to_text(small);
}

}  // namespace veritope::v_edits
