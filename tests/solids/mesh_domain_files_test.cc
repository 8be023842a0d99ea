// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/mesh_domain_files_test.cc: the domains of real meshes. bench/soak_dms_domains.cc takes larger ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "io/read_model.h"
#include "solids/dms/domain/mesh_domain.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/mesh_domain_check.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

namespace fs = std::filesystem;

TEST(MeshDomainFiles, AreFilledExactly) {
  constexpr std::size_t kMostFacets = 1000;
  const fs::path folder = fs::path(test::data_dir()) / "mesh";
  if (!fs::exists(folder)) GTEST_SKIP() << "no folder " << folder;
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const Result<MeshFile> file = read_mesh_file(entry.path().string(), {});
    if (!file || file->mesh.faces.size() > kMostFacets) continue;
    if (!decide_validity(file->mesh, {}).is_valid) continue;
    const Result<MeshDomain> domain = domain_of_mesh(file->mesh, {});
    ASSERT_TRUE(domain.has_value()) << entry.path();
    EXPECT_EQ(mesh_domain_fault(file->mesh, domain->model), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 40);
}

}  // namespace
}  // namespace veritope
