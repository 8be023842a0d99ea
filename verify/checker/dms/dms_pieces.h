// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_pieces.h: tetrahedra and triangles on which s is one polynomial (J2 and
// T2 of docs/certificates/dms-solid.md).
#pragma once
#include "dms_near.h"

// The planes beside a leaf: across axes, of its faces, of its root's faces, and
// of the list.
DmsSides dms_sides_of_leaf(const std::vector<const DmsPoint*>& leaf, std::vector<DmsPlane> of_root,
                           const std::vector<Ratio>& listed);
// T2, by the name units->id, for a triangle with this number and list of
// planes: the V_gamma that are not excluded.
std::vector<DmsTerm> terms_on_triangle(const DmsNear& near,
                                       const std::vector<const DmsPoint*>& corners,
                                       const std::vector<Ratio>& listed, Units* units,
                                       size_t number);
// The plane that contains a, b and the normal of a plane.
DmsPlane upright_plane(const DmsPoint& a, const DmsPoint& b, const DmsPlane& along);
