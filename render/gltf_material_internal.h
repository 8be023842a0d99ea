// SPDX-License-Identifier: LGPL-3.0-or-later
// render/gltf_material_internal.h: names, materials and sizes in glTF 2.0.
#pragma once
#include <string>

#include "render/scene.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"

namespace veritope::internal {

/// A JSON string; what would need escapes becomes "_".
std::string gltf_text(const std::string& name);

/// An object of "materials": it is seen from both sides and does not shine.
std::string gltf_material(const std::string& name, const Paint& paint);

/// Whether all sizes and distances of a scene with this box can be binary32, with the relative accuracy of normal
/// numbers. @error kNotFinite
Status check_gltf_size(const Box3d& box);

}  // namespace veritope::internal
