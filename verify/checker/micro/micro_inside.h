// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_inside.h: what the parts of micro-inside-1 share. The page: docs/certificates/micro-inside.md.
#pragma once
#include "../mesh/mesh_body.h"
#include "micro_off.h"
#include "micro_patches.h"

struct VoidEntry {
  uint64_t volume;
  Ratio x[3];
  uint64_t corner;  // 8: none
};
struct InsideBody {
  Body structure, solid;
  std::vector<VoidEntry> voids;
};

// The solid M, as I2 and I3 ask about it.
class SolidAround {
 public:
  virtual ~SolidAround() {}
  // The winding number of M around a point of each shell's first patch is 1. REQUIRES I1.
  virtual void check_shells(const std::vector<PatchOfCell>& shells, OffSurface* off) = 0;  // I2
  // Called before the next two, for I3 with so many entries.
  virtual void begin_voids(uint64_t entries) = 0;
  virtual const std::vector<uint64_t>& depths() = 0;  // of the shells of M
  // The winding numbers of shells of M around (X, Y, Z) / W, those that are not 0. If the point lies on M, I3 fails,
  // for the void of this shell.
  virtual std::map<uint32_t, int64_t> around(const std::vector<Big>& point, uint32_t shell) = 0;
};
std::unique_ptr<SolidAround> around_mesh(const Model& model, const SolidMesh& solid);

// A spline model that bounds a solid.
struct SolidPatches {
  std::vector<Grid> grids;
  std::vector<bool> is_rational;
  std::vector<uint32_t> shell;  // of each patch
  uint32_t shells = 0;
  int64_t unit = 0;    // the patches count in units of 2^unit
  uint64_t bytes = 0;  // of the model and the certificate's body
};
// The conditions of star-box-2 for the part about the solid, and I0. model_bytes: of the file with these entities.
SolidPatches check_solid_patches(const std::vector<Entity>& entities, uint64_t model_bytes,
                                 const Body& part);
std::unique_ptr<SolidAround> around_patches(const SolidPatches& solid);

// I3.
void check_voids(const std::vector<VoidEntry>& voids, TileParts* parts, SolidAround* solid);
// I4.
void check_skin(TileParts* parts, Obstacle* surface, const Ratio& skin);
