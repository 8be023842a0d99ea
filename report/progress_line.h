// SPDX-License-Identifier: LGPL-3.0-or-later
// report/progress_line.h: the line of a terminal that says what the program does.
#pragma once
#include <cstddef>
#include <string>

#include "robust/base/work_share.h"

namespace veritope::report {

struct ProgressText {
  std::size_t number = 0, num_files = 0;  ///< of the file; shown if there are several
  std::string file, phase;
};

/// "3 of 58, part.stl: deciding, 45 % of step 1, 3.2 s". Without a known share that part is missing. The name of the
/// file is cut if the line would have more than `most` bytes.
std::string progress_line(const ProgressText& text, const WorkShare::View& work, double seconds,
                          std::size_t most = 78);

}  // namespace veritope::report
