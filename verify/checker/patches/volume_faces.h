// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_faces.h: the surfaces that bound volumes; docs/certificates/reading-rule-faces.md.
#pragma once
#include "star_model.h"

// Section 4: for each of these faces, whether it is left out as a wall. REQUIRES that all of them have an area.
std::vector<bool> are_walls(const std::vector<Entity>& faces);
// The two parameters of the faces 2 axis + end of a right-handed volume; of others they change places. Section 3.
extern const size_t kParametersOfFaces[6][2];
Entity face_of_volume(const Entity& volume, size_t number, bool is_right_handed);
// The face in its lowest degrees.
Entity lowered(Entity face);
