// SPDX-License-Identifier: LGPL-3.0-or-later
// io/micro/write_micro.h: microstructures as files .vmicro.
#pragma once
#include <string>

#include "solids/micro/microstructure.h"

namespace veritope {

/// The canonical form of docs/formats/micro-files.md: equal microstructures have equal bytes, and read_micro gives the
/// same microstructure. REQUIRES validate(micro), and names in UTF-8.
std::string write_micro(const Microstructure& micro);

}  // namespace veritope
