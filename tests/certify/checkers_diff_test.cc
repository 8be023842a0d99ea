// SPDX-License-Identifier: LGPL-3.0-or-later
// Certificates against the two checkers as programs, as users run them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/certify/round_trip.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

namespace fs = std::filesystem;
using shapes::Cap;

class CheckersDiff : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("veritope_checkers_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Exit code and first line of what it prints.
  std::pair<int, std::string> run(const std::string& program, const fs::path& model,
                                  const fs::path& certificate) {
    const std::string command =
        program + " '" + model.string() + "' '" + certificate.string() + "' 2>&1";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string out;
    char part[4096];
    for (std::size_t n; (n = std::fread(part, 1, sizeof part, pipe)) > 0;) out.append(part, n);
    const int status = ::pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out.substr(0, out.find('\n'))};
  }

  void expect_accepted(const TriangleMesh& mesh, bool as_indexed = false) {
    const CertifiedMesh c = certified(mesh, as_indexed);
    const fs::path model = folder_ / "model.ply", certificate = folder_ / "model.cert";
    std::ofstream(model, std::ios::binary) << c.file;
    std::ofstream(certificate, std::ios::binary) << c.certificate();
    const std::string claim = c.report.is_valid ? "ACCEPT mesh-valid-1" : "ACCEPT mesh-invalid-1";
    for (const std::string& program : {"'" + test::program_dir() + "/veritope-check'",
                                       "'" + test::python() + "' -B '" + test::source_dir() +
                                           "/verify/checker/veritope_check.py'"}) {
      const auto [code, line] = run(program, model, certificate);
      EXPECT_EQ(code, 0) << program << ": " << line << "\n"
                         << shapes::to_text(c.mesh).substr(0, 4000);
      EXPECT_EQ(line.substr(0, claim.size()), claim) << program;
    }
  }

  fs::path folder_;
};

TEST_F(CheckersDiff, AcceptWhatTheKernelSaysOfEveryGenerator) {
  Random random(1);
  for (const TriangleMesh& mesh :
       {shapes::box({0, 0, 0}, {1, 2, 3}, 3), shapes::prism(17, 3, 1), shapes::torus(15, 9, 3, 1),
        shapes::star_polyhedron(random, 3), shapes::bipyramid(90), shapes::cone(70),
        shapes::tilted_cylinder(120, Cap::kCentreFan), shapes::tilted_cylinder(120, Cap::kRimFan),
        shapes::tilted_cylinder(120, Cap::kZigzag), shapes::hyperboloid(90, 30), shapes::saddle(),
        shapes::wave(12, 30), shapes::nested_boxes(7), shapes::box_grid(3, 0.25),
        shapes::nested_scene(random, 30), shapes::needles(random, 30),
        shapes::reversed(shapes::torus(5, 5, 3, 1)), shapes::scaled(shapes::saddle(), -1060),
        shapes::scaled(shapes::saddle(), 1000)})
    expect_accepted(mesh);
}

TEST_F(CheckersDiff, AcceptWhatTheKernelSaysOfRandomModels) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(15)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto n = [&](int low, int high) { return static_cast<int>(random.between(low, high)); };
    expect_accepted(shapes::grid_soup(random, n(1, 20), 3), true);
    expect_accepted(shapes::random_indexed(random, n(1, 20), n(3, 9), 3), random.below(2) == 0);
    expect_accepted(shapes::random_polycube(random, 3, n(1, 14)));
    expect_accepted(
        shapes::mapped(shapes::wave(2 * n(2, 9), 9), shapes::random_matrix(random, 4), {1, 2, 3}));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace veritope
