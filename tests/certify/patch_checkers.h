// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/patch_checkers.h: what both checkers, as programs, say of a certificate about patches.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/certify/patch_round_trip.h"
#include "tests/support/paths.h"

namespace veritope {

/// Both checkers accept the certificate.
inline void expect_accepted(const CertifiedPatches& c, const std::string& what) {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("veritope_patches_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "model.vjson", std::ios::binary) << c.file;
  std::ofstream(folder / "model.cert", std::ios::binary)
      << std::string(c.bytes.begin(), c.bytes.end());
  for (const std::string& program : {"'" + test::program_dir() + "/veritope-check'",
                                     "'" + test::python() + "' -B '" + test::source_dir() +
                                         "/verify/checker/veritope_check.py'"}) {
    const std::string command = program + " '" + (folder / "model.vjson").string() + "' '" +
                                (folder / "model.cert").string() + "' 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string out;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) out.append(part, n);
    const int status = ::pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
        << what << ", " << program << ": " << out.substr(0, 400);
  }
  fs::remove_all(folder);
}

}  // namespace veritope
