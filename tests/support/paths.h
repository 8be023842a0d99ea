// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/paths.h: where tests find the tree, the programs and the real models. Only paths.cc depends on this machine's folders.
#pragma once
#include <string>

namespace veritope::test {

/// The root of the source tree, without a slash at its end.
std::string source_dir();
/// The folder of the built programs.
std::string program_dir();
/// The interpreter that runs the Python checker.
std::string python();
/// The folder of the real models: VERITOPE_DATA if it is set, else shared/data beside the tree. It may not exist.
std::string data_dir();

}  // namespace veritope::test
