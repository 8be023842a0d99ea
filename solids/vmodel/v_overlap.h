// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_overlap.h: two points of the cells of a V-model, one of them inside of a cell, with one image.
// The theorem: docs/THEORY.md, VMODEL-2. The conditions: docs/certificates/vmodel-invalid.md, section 3.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/vmodel/v_model.h"

namespace veritope {

/// A point of a cell, in a knot span of each axis: spans lie between different knots of the domain.
struct VPlace {
  std::uint32_t cell = 0;
  std::array<std::size_t, 3> span{};
  std::array<Rational, 3> at;  ///< from 0 to 1 along the spans
};
/// A box of parameters in a knot span of each axis, with dyadic ends.
struct VBox {
  std::uint32_t cell = 0;
  std::array<std::size_t, 3> span{};
  std::array<std::array<Rational, 2>, 3> at;  ///< from 0 to 1 along the spans, low < high
};
/// Some point of the box has the image Q: for the rows Y_i of the matrix, Y_i·(T - Q) is negative on the face of the
/// box at the begin of axis i and positive at its end (Poincare and Miranda).
struct VPreimage {
  VBox box;
  std::array<std::array<std::int64_t, 3>, 3> rows{};
};

struct VOverlap {
  VPlace inside;  ///< a point of an open cell
  /// Another point with its image, which is either known or in a box.
  std::optional<VPlace> point;
  std::optional<VPreimage> somewhere;
};

/// The parameters of the cell. REQUIRES a place of the model.
std::array<Rational, 3> parameters_of(const VModel& model, const VPlace& place);
std::array<std::array<Rational, 2>, 3> parameters_of(const VModel& model, const VBox& box);
/// The point in space, exactly.
std::array<Rational, 3> point_of(const VModel& model, const VPlace& place);
/// The knot span that holds a parameter of the cell's domain, and where in it.
VPlace place_at(const VModel& model, std::uint32_t cell, const std::array<Rational, 3>& at);

/// Whether the overlap is a proof: O1 to O4, exactly. REQUIRES cells, spans and exactly one of the two others.
bool is_overlap(const VModel& model, const VOverlap& overlap);

struct VOverlapOptions {
  /// Points of cells near which an overlap is likely, in the cells' parameters; they are tried first.
  struct Hint {
    std::uint32_t cell = 0;
    std::array<Rational, 3> at;
  };
  std::vector<Hint> hints;
  std::size_t max_solves = 200'000;  ///< of systems of three equations, by Newton's iteration
  bool within_spans = true;  ///< seek parts of one knot span that overlap, too, which takes many
};
/// Seeks among the images of points in the middle of pieces and next to middles, edges and corners of border faces one
/// that another cell, or another part of the same one, has as well. What is found is proved; nothing found proves
/// nothing. @cost up to max_solves iterations in binary64, then few exact tests
std::optional<VOverlap> find_overlap(const VModel& model, const VOverlapOptions& options = {});

/// Two points of the box, one of them inside of the cell, with exactly one image, if lines of parameters in it are
/// collapsed: tried at the simplest rational numbers of the box and along its axes.
std::optional<VOverlap> find_collapsed_line(const VModel& model, std::uint32_t cell,
                                            const std::array<std::array<Rational, 2>, 3>& box);

}  // namespace veritope
