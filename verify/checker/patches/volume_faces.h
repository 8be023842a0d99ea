// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_faces.h: the surfaces that bound volumes; docs/certificates/reading-rule-faces.md.
#pragma once
#include "star_model.h"

// Section 4: for each of these faces, whether it is left out as a wall. REQUIRES that all of them have an area.
std::vector<bool> are_walls(const std::vector<Entity>& faces);
// The face in its lowest degrees.
Entity lowered(Entity face);
