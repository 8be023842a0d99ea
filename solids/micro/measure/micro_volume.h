// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/micro_volume.h: the volume of a microstructure, and of all its cells, enclosed. Nothing is
// composed. Design: docs/design/0077-measures-and-composed-output.md.
#pragma once
#include "interval/interval.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

struct MicroVolume {
  Interval tiles;    ///< of the union of all mapped tiles, in cubic units of the model
  Interval bridges;  ///< of the union of all bridges
  Interval solid;    ///< of both together
  Interval cells;    ///< of the images of all cells of all grids, whether they hold a tile or not
  /// Contains solid / cells; its upper bound may be infinite where bridges lead out of all cells.
  Interval density;
};

/// The tiles and bridges of a sound microstructure have no common inner points, so that their volumes may be added: the
/// integral of the determinant over each. Numbers of walls enter by polynomials that are made once for each kind of
/// tile; the determinant is a polynomial on each span between knots, expanded about each cell to an order that the span
/// and its cells need. Bounds are less than 10^-9 apart, relatively, but for coarse cells of rational volumes whose
/// weights vary along several axes (a few 10^-9 if a cell is a quarter of a turn along two axes), for polynomials of
/// high degree that oscillate within a cell, and where many bridges cross creases of the cage. The result is the same
/// for every number of jobs.
/// REQUIRES that the cage is that of micro, that the structure is certified, or that topology_of finds no defect
/// and prove_bridges none; that determinants of the cage have one sign in each volume.
/// @error kNotFinite: numbers beyond the range of binary64, or a weight that is not proved positive
/// @cost  for trilinear and tricubic volumes a few microseconds a tile, and some milliseconds a span; a millisecond a
///        bridge, and up to 0.2 s for one that crosses a knot
Result<MicroVolume> volume_of(const Microstructure& micro, const VModel& cage, unsigned jobs);

}  // namespace veritope
