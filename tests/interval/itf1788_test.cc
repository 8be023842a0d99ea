// SPDX-License-Identifier: LGPL-3.0-or-later
// The ITF1788 files, unmodified, statement by statement. What does not pass stands in
// tests/interval/itf1788_exclusions.txt, a line "FILE | START OF THE STATEMENT | reason"; a line that no
// failing statement needs, or that a passing one matches, is stale.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/interval/itf1788_operations.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

// What passes in each file; losing one is noticed, and so is gaining one.
const std::map<std::string, std::size_t> kPassing = {
    {"abs_rev.itl", 24},
    {"atan2.itl", 38},
    {"c-xsc.itl", 160},
    {"fi_lib.itl", 863},
    {"ieee1788-constructors.itl", 43},
    {"ieee1788-exceptions.itl", 3},
    {"libieeep1788_bool.itl", 392},
    {"libieeep1788_cancel.itl", 242},
    {"libieeep1788_class.itl", 204},
    {"libieeep1788_elem.itl", 3818},
    {"libieeep1788_mul_rev.itl", 347},
    {"libieeep1788_num.itl", 183},
    {"libieeep1788_overlap.itl", 77},
    {"libieeep1788_rec_bool.itl", 139},
    {"libieeep1788_reduction.itl", 15},
    {"libieeep1788_rev.itl", 764},
    {"libieeep1788_set.itl", 20},
    {"mpfi.itl", 1381},
    {"pow_rev.itl", 802},
};

std::string data_folder() { return test::data_dir() + "/itf1788"; }

struct Exclusion {
  std::string file, start, reason;
  std::size_t used = 0;
};
std::vector<Exclusion> exclusions() {
  std::ifstream in(test::source_dir() + "/tests/interval/itf1788_exclusions.txt");
  std::vector<Exclusion> out;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
    if (first == std::string::npos || second == std::string::npos || second + 3 >= line.size()) {
      ADD_FAILURE() << "no exclusion with a reason: " << line;
      continue;
    }
    out.push_back({line.substr(0, first), line.substr(first + 3, second - first - 3),
                   line.substr(second + 3)});
  }
  return out;
}

TEST(Itf1788, EveryStatementPassesOrIsListedWithAReason) {
  const std::string folder = data_folder();
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no ITF1788 files in " << folder;
  std::vector<Exclusion> listed = exclusions();
  std::size_t total = 0, passed = 0;
  for (const auto& [file, expected] : kPassing) {
    const std::vector<itf1788::Statement> statements = itf1788::read(folder + "/" + file);
    std::size_t good = 0;
    for (const itf1788::Statement& s : statements) {
      const std::optional<std::string> fault = itf1788::failure(s);
      const auto exclusion = std::find_if(listed.begin(), listed.end(), [&, &name = file](const Exclusion& e) {
        return e.file == name && s.source.starts_with(e.start);
      });
      if (exclusion != listed.end()) {
        ++exclusion->used;
        const bool wide = exclusion->reason.starts_with("not tightest");
        EXPECT_TRUE(!wide || itf1788::is_narrower(s)) << file << ": " << s.source;
      }
      if (!fault) ++good;
      const bool expected_fault = exclusion != listed.end();
      EXPECT_EQ(fault.has_value(), expected_fault)
          << file << ": " << s.source << ": " << fault.value_or("passes, but is listed");
    }
    std::printf("%-28s %5zu of %5zu statements\n", file.c_str(), good, statements.size());
    EXPECT_EQ(good, expected) << file;
    total += statements.size(), passed += good;
  }
  for (const Exclusion& e : listed)
    EXPECT_GT(e.used, 0u) << "stale: " << e.file << " | " << e.start;
  std::printf("%-28s %5zu of %5zu statements\n", "all", passed, total);
  EXPECT_EQ(total, 9542u);
}

}  // namespace
}  // namespace veritope
