// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/paths.h"

#include <cstdlib>

namespace veritope::test {

std::string source_dir() { return VERITOPE_SOURCE_DIR; }
std::string program_dir() { return VERITOPE_BIN_DIR; }
std::string python() { return VERITOPE_PYTHON; }

std::string data_dir() {
  const char* const given = std::getenv("VERITOPE_DATA");
  return given != nullptr ? given : VERITOPE_DATA_DEFAULT;
}

}  // namespace veritope::test
