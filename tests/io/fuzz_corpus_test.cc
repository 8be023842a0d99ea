// SPDX-License-Identifier: LGPL-3.0-or-later
// The fuzz targets' corpora, findings included, in every build.
#include <filesystem>
#include <vector>

#include "fuzz/read_laws.h"
#include "fuzz/spline_laws.h"
#include "tests/io/io_test_util.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

void expect_laws(const std::string& folder, MeshFormat format) {
  int num = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_dir() + "/fuzz/corpus/" + folder)) {
    SCOPED_TRACE(entry.path().filename().string());
    const std::string text = io_test::slurp(entry.path().string());
    EXPECT_NO_THROW(fuzz::check_reader(format, io_test::bytes(text)));
    for (std::size_t size = 0; size < text.size(); size += 1 + size / 16) {
      EXPECT_NO_THROW(fuzz::check_reader(format, io_test::bytes(text).subspan(0, size))) << size;
    }
    ++num;
  }
  EXPECT_GE(num, 5);
}

TEST(FuzzCorpus, StlFilesKeepTheLaws) { expect_laws("read_stl", MeshFormat::kStl); }
TEST(FuzzCorpus, ObjFilesKeepTheLaws) { expect_laws("read_obj", MeshFormat::kObj); }
TEST(FuzzCorpus, PlyFilesKeepTheLaws) { expect_laws("read_ply", MeshFormat::kPly); }
TEST(FuzzCorpus, OffFilesKeepTheLaws) { expect_laws("read_off", MeshFormat::kOff); }

TEST(FuzzCorpus, SplineFilesKeepTheLaws) {
  int num = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_dir() + "/fuzz/corpus/spline_text")) {
    SCOPED_TRACE(entry.path().filename().string());
    EXPECT_NO_THROW(
        fuzz::check_spline_readers(io_test::bytes(io_test::slurp(entry.path().string()))));
    ++num;
  }
  EXPECT_GE(num, 5);
}

}  // namespace
}  // namespace veritope
