// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_points.h: the claim points-1 about spline models; docs/certificates/points.md, section 6.
#pragma once
#include "algebraic.h"
#include "answers.h"
#include "patch_winding.h"

struct PlaceOnPatch {
  uint64_t patch = 0;
  Ratio at[2];                           // parameters
  std::shared_ptr<Algebraic> algebraic;  // instead of them, if not null
};

// The patches of a spline model. The functions that read are called in their order, then glue(); only then are there
// patches, of which all others speak.
class PatchSurface {
 public:
  // The file has this many bytes.
  PatchSurface(std::vector<Entity> entities, uint64_t bytes);

  void read_counts(Bytes* bytes);                      // F and N
  void read_breaks(uint64_t body_size, Bytes* bytes);  // and compares F with the size of the body
  PlaceOnPatch read_place(Bytes* bytes) const;
  void glue();  // B2 and P1

  const std::vector<Patch>& patches() const { return patches_; }
  // Numbers 4 patch + corner, 4 patch + side: with this vertex of the gluing, or this pair.
  const std::vector<uint32_t>& corners_at(uint32_t vertex) const { return corners_.at(vertex); }
  const std::vector<uint32_t>& sides_of(uint32_t pair) const { return sides_.at(pair); }
  void check_on(const RationalPoint& q, const PlaceOnPatch& place, const std::string& where,
                PointUnits* units) const;  // P2
  // What a point at these parameters costs on a patch.
  uint64_t units_at(uint32_t patch, const RationalPoint& q, const PlaceOnPatch& place) const;
  int64_t winding(const RationalPoint& q, int direction, const std::string& where,
                  PointUnits* units) const;  // P3

 private:
  const std::vector<Entity> entities_;
  const uint64_t bytes_;
  uint64_t num_patches_ = 0;
  Cuts cuts_;
  std::vector<Patch> patches_;
  std::vector<Grid> grids_;
  std::map<uint32_t, std::vector<uint32_t>> corners_, sides_;
  std::unique_ptr<const PatchBoxes> boxes_;
};

RationalPoint rational_point(const Coordinate* coordinates);

// The format of a spline model, with or without "-faces".
bool is_about_patches(const Statement& statement);
// The conditions from B1 on, after those of the answers.
void check_points_of_patches(const Statement& statement, const std::string& file, const Body& body,
                             const std::vector<Answer>& answers);
