// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_itf1788.cc: runs the .itl files in the folder itf1788 of VERITOPE_DATA (default: ../shared/data). One JSON
// line a figure.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "tests/interval/itf1788_operations.h"

int main() {
  using namespace veritope::itf1788;
  const char* given = std::getenv("VERITOPE_DATA");
  const std::filesystem::path folder =
      std::filesystem::path(given != nullptr ? given : "../shared/data") / "itf1788";
  if (!std::filesystem::is_directory(folder)) {
    std::fprintf(stderr, "soak_itf1788: %s is no folder\n", folder.c_str());
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".itl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::size_t total = 0, passed = 0;
  for (const auto& file : files) {
    std::size_t good = 0;
    const auto statements = read(file.string());
    for (const Statement& s : statements)
      if (!failure(s)) ++good;
    std::printf("{\"name\":\"itf1788_%s\",\"value\":%zu,\"goal\":\"of %zu statements\"}\n",
                file.stem().c_str(), good, statements.size());
    total += statements.size(), passed += good;
  }
  std::printf(
      "{\"name\":\"itf1788\",\"value\":%zu,\"goal\":\">= 7300 of 9542 statements "
      "pass\",\"statements\":%zu}\n",
      passed, total);
  return total == 9542 && passed >= 7300 ? 0 : 1;
}
