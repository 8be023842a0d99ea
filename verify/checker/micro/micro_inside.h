// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_inside.h: what the parts of micro-inside-1 share. The page: docs/certificates/micro-inside.md.
#pragma once
#include "../mesh/mesh_body.h"
#include "micro_off.h"

struct VoidEntry {
  uint64_t volume;
  Ratio x[3];
  uint64_t corner;  // 8: none
};
struct InsideBody {
  Body structure, solid;
  std::vector<VoidEntry> voids;
};

// I2.
void check_shells(const std::vector<PatchOfCell>& shells, const Model& model, OffSurface* off);
// I3.
void check_voids(const std::vector<VoidEntry>& voids, const MicroFile& file, const Model& model,
                 const SolidMesh& solid, VolumeMaps* maps);
// I4.
void check_skin(const MicroFile& file, const Triangles& triangles, VolumeMaps* maps,
                const Ratio& skin);
