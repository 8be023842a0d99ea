// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/progress_line.h"

#include <cstdio>

namespace veritope::report {
namespace {

// At most `most` bytes of the text, with "..." in the place of the rest; characters stay whole.
std::string cut(const std::string& text, std::size_t most) {
  constexpr std::size_t kDots = 3;
  if (text.size() <= most) return text;
  std::size_t size = most > kDots ? most - kDots : 0;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size) + "...";
}

}  // namespace

std::string progress_line(const ProgressText& text, const WorkShare::View& work, double seconds,
                          std::size_t most) {
  std::string head, tail = ": " + text.phase;
  if (text.num_files > 1)
    head = std::to_string(text.number) + " of " + std::to_string(text.num_files) + ", ";
  if (const auto percent = work.percent())
    tail += ", " + std::to_string(*percent) + " % of step " + std::to_string(work.step);
  char time[32];
  std::snprintf(time, sizeof time, ", %.1f s", seconds);
  tail += time;
  const std::size_t rest = head.size() + tail.size();
  return head + cut(text.file, most > rest ? most - rest : 0) + tail;
}

}  // namespace veritope::report
