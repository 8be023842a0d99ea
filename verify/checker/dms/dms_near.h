// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_near.h: the V_gamma that planes do not keep away from a simplex, and the triangles of their knots.
#pragma once
#include "dms_boxes.h"
#include "dms_values.h"

struct DmsNear {
  explicit DmsNear(const DmsModel& model);

  const DmsModel& model;

  // Those without a plane of `sides`, by the closed box of its corners.
  std::vector<DmsTerm> not_excluded(const DmsBox& box, DmsSides* sides, Units* units) const;
  // Those of them that T2 keeps: keeps(their different knots) decides.
  std::vector<DmsTerm> filtered(
      const DmsBox& box, DmsSides* sides, Units* units,
      const std::function<bool(const std::vector<uint32_t>& knots)>& keeps) const;
  // use(knots) for all triangles of different knots of the terms, also flat ones, once for each set of knots.
  void each_cut(const std::vector<DmsTerm>& terms, Units* units,
                const std::function<void(const std::array<uint32_t, 3>& knots)>& use) const;
  // Rejects by units->id, unless each cut has a plane of `sides` or its own one
  // beside the corners.
  void check_cuts(const std::vector<DmsTerm>& terms, DmsSides* sides, Units* units, const char* why,
                  size_t number) const;
  std::vector<uint32_t> knots_of(const DmsTerm& term) const;  // different ones, ascending
  DmsPlane plane_of(const std::array<uint32_t, 3>& knots) const {
    return DmsPlane::of(model.points[knots[0]], model.points[knots[1]], model.points[knots[2]]);
  }

 private:
  std::vector<DmsBox> boxes;  // of the knots of tetrahedra
  std::unique_ptr<DmsBoxes> tree;
};

// G_gamma of a term, row by row, times a positive number; kept.
struct DmsMatrices {
  explicit DmsMatrices(const DmsModel& m) : model(m) {}
  const std::vector<Big>& of(const DmsTerm& term);

 private:
  const DmsModel& model;
  std::unordered_map<uint64_t, std::vector<Big>> known;
};
// W_gamma and the x, y, z of the control points c(I, gamma + e_m).
void dms_corners(const DmsModel& model, const DmsTerm& term, const DmsPoint** w, const Ratio** c);
