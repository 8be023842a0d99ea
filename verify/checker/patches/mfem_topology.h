// SPDX-License-Identifier: Apache-2.0 OR MIT
// mfem_topology.h: how vertices and edges connect the patches of a NURBS mesh of MFEM, and the numbers of its control
// points; docs/certificates/reading-rule-mfem.md, section 4.
#pragma once
#include "star_model.h"

struct MfemKnots {
  int64_t degree;
  uint64_t points;          // how many control points an axis has
  Numbers knots, reversed;  // reversed: t0 + t1 - t for the knots t, in reverse order
  bool is_symmetric;        // both are equal
};
struct MfemEdge {
  uint64_t knots, from, to;  // knots: the number of a knot vector
};
struct MfemTopology {
  size_t axes;
  std::vector<uint64_t> corners;  // 2^axes vertices for each patch
  std::vector<MfemEdge> edges;
  uint64_t vertices;

  size_t patches() const { return corners.size() >> axes; }
};
struct MfemPatch {
  uint64_t knots[3];  // for each axis, the number of its knot vector
  bool is_reversed[3];
  std::vector<uint64_t> points;  // the numbers of the control points, last axis fastest
};
struct MfemNumbering {
  uint64_t points;  // how many control points the mesh has
  std::vector<MfemPatch> patches;
};
// Refuses a mesh whose patches, or which itself, has more control points than `most`.
MfemNumbering number_points(const MfemTopology& topology, const std::vector<MfemKnots>& knots,
                            uint64_t most);
