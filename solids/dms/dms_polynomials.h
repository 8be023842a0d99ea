// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_polynomials.h: the polynomials of a simplex-spline solid's map, cell by cell, for pictures.
// Design: docs/design/0105-bezier-cells-of-simplex-splines.md.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "robust/base/result.h"
#include "solids/dms/dms_parts.h"
#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_restriction.h"

namespace veritope {

struct DmsCellOptions {
  unsigned jobs = 1;  ///< 0: as many as the machine runs
  std::size_t max_cells =
      4096;  ///< convex cells into which triangles of knots may cut a tetrahedron
};

/// kCode with the tetrahedron as the entity.
inline Error error_in_tetrahedron(Code code, std::uint32_t tetrahedron, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.entity = tetrahedron;
  return error;
}

/// One thread at a time.
class DmsPolynomials {
 public:
  /// All references must outlive this. REQUIRES a model without defects (solids/dms/dms_defects.h).
  DmsPolynomials(const DmsModel& model, const DmsKnotTable& knots, const DmsEvaluator& evaluator,
                 std::size_t max_cells)
      : model_(model), knots_(knots), pieces_(model, evaluator), max_cells_(max_cells) {}

  /// visit(cell, components, map) for the convex cells of a tetrahedron: `components` are the exact coefficients on the
  /// cell's first tetrahedron, of all components, and `map` has them on others. A visit returns a Status, and an error
  /// ends the loop. @error kOverLimit for more than max_cells cells
  template <typename Visit>
  Status visit_cells(std::uint32_t tetrahedron, Visit visit) {
    const auto cells = polynomial_parts(knots_, tetrahedron, max_cells_);
    if (!cells)
      return error_in_tetrahedron(Code::kOverLimit, tetrahedron,
                                  "triangles of knots cut the tetrahedron into more than " +
                                      std::to_string(max_cells_) + " cells");
    for (const DmsCell& cell : *cells) {
      const auto components = pieces_.components(cell.tetrahedra[0], model_.num_components());
      VT_CHECK(components.has_value(), "parts of tetrahedra are in the domain");
      DmsRestriction map(model_.degree, cell.tetrahedra[0], *components);
      if (Status status = visit(cell, *components, map); !status) return status;
    }
    return ok_status();
  }

 private:
  const DmsModel& model_;
  const DmsKnotTable& knots_;
  DmsPieces pieces_;
  std::size_t max_cells_;
};

/// make(polynomials, tetrahedron) -> Result<Made> for all tetrahedra, by several threads; take(tetrahedron, made) ->
/// Status in their order, by this one. The first error ends the loop. What is taken does not depend on `jobs`.
template <typename Made, typename Make, typename Take>
Status for_each_tetrahedron(const DmsModel& model, const DmsCellOptions& options, Make make,
                            Take take) {
  constexpr std::size_t kInRound = 64, kInChunk = 8;  // of a thread
  const DmsKnotTable knots(model);
  const DmsEvaluator evaluator(model);
  const std::size_t in_round =
      kInRound * (options.jobs == 0 ? hardware_jobs() : std::size_t{options.jobs});
  for (std::size_t first = 0; first < model.tetrahedra.size(); first += in_round) {
    const std::size_t size = std::min(in_round, model.tetrahedra.size() - first);
    std::vector<std::optional<Result<Made>>> made(size);
    parallel_for(size, kInChunk, options.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   DmsPolynomials polynomials(model, knots, evaluator, options.max_cells);
                   for (std::size_t i = begin; i < end; ++i)
                     made[i] = make(polynomials, static_cast<std::uint32_t>(first + i));
                 });
    for (std::size_t i = 0; i < size; ++i) {
      if (!*made[i]) return made[i]->error();
      if (Status status = take(static_cast<std::uint32_t>(first + i), std::move(**made[i]));
          !status)
        return status;
    }
  }
  return ok_status();
}

}  // namespace veritope
