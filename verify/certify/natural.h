// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/natural.h: integers as certificates hold them.
#pragma once
#include "robust/integer.h"
#include "verify/format/mesh_certificate.h"

namespace veritope {

/// REQUIRES n >= 0.
inline certificate::Natural to_natural(Integer n) {
  certificate::Natural out;
  for (; !n.is_zero(); n.shift_right(8))
    out.push_back(static_cast<unsigned char>(n.low_bits() & 0xffu));
  return out;
}

}  // namespace veritope
