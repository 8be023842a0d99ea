// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/checker_call.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

namespace fs = std::filesystem;

std::string model(const std::string& name) { return test::source_dir() + "/tests/models/" + name; }

std::string bytes_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class CertifyFile : public testing::Test {
 protected:
  CertifyFile()
      : folder_(fs::temp_directory_path() / ("certify_file_" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
  }
  ~CertifyFile() override { fs::remove_all(folder_); }
  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

TEST_F(CertifyFile, CertifiesMeshesAndPatchesAndKeepsWhatCheckersAccept) {
  for (const auto& [name, verdict] : {std::pair{"m3_nearest_valid.off", Verdict::kValid},
                                      std::pair{"m3_smallest.off", Verdict::kInvalid},
                                      std::pair{"patches/cube.itd", Verdict::kValid},
                                      std::pair{"splines/two_cubes.mesh", Verdict::kValid}}) {
    const Result<Certified> found = certify_file(model(name));
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->verdict, verdict) << name;
    const std::string path = in_folder("kept.cert");
    ASSERT_TRUE(write_certificate(*found, path)) << name;
    EXPECT_FALSE(fs::exists(copy_path(path, "vjson")));
    EXPECT_EQ(check_in_process(bytes_in(model(name)), bytes_in(path)).substr(0, 7), "ACCEPT ")
        << name;
  }
}

TEST_F(CertifyFile, KeepsTheCopyOfWhichACertificateOfVolumesSpeaks) {
  const std::string file = in_folder("block.itd");  // the ends of its first axis are not clamped
  std::ofstream(file) << "[TRIVAR BSPLINE 2 2 2 2 2 2 E3 [KV -1 0 1 1.5] [KV 0 0 1 1] [KV 0 0 1 1]"
                         " [0 0 0][1 0 0][0 1 0][1 1 0][0 0 1][1 0 1][0 1 1][1 1 1]]\n";
  const Result<Certified> found = certify_file(file);
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->copy);
  EXPECT_EQ(found->claim, "vmodel-1");
  const std::string path = in_folder("volume.cert");
  ASSERT_TRUE(write_certificate(*found, path));
  EXPECT_EQ(check_in_process(bytes_in(copy_path(path, "vjson")), bytes_in(path)).substr(0, 7),
            "ACCEPT ");
}

TEST_F(CertifyFile, KeepsTheCopyOfWhichACertificateOfPolygonsSpeaks) {
  const std::string file = in_folder("tet.itd");
  std::ofstream(file)
      << "[OBJECT TET [POLYGON 3 [0 0 0] [1 0 0] [0 1 0]] [POLYGON 3 [0 0 0] [0 0 1] [1 0 0]]"
         " [POLYGON 3 [0 0 0] [0 1 0] [0 0 1]] [POLYGON 3 [1 0 0] [0 0 1] [0 1 0]]]";
  const Result<Certified> found = certify_file(file);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->verdict, Verdict::kValid);
  ASSERT_TRUE(found->copy);
  EXPECT_EQ(found->copy->format, "off");
  const std::string path = in_folder("tet.cert");
  ASSERT_TRUE(write_certificate(*found, path));
  EXPECT_EQ(check_in_process(bytes_in(copy_path(path, "off")), bytes_in(path)).substr(0, 20),
            "ACCEPT mesh-valid-1:");
}

TEST_F(CertifyFile, NamesTheFileThatCannotBeRead) {
  const Result<Certified> none = certify_file(in_folder("none.stl"));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, Code::kCannotOpen);
  EXPECT_EQ(none.error().place.file, in_folder("none.stl"));
  EXPECT_FALSE(certify_file(model("unreadable_cut.stl")));
}

TEST_F(CertifyFile, WritesNoCertificateWithoutAVerdict) {
  const Result<Certified> open = certify_file(model("patches/not_certified_smallest.vjson"));
  ASSERT_TRUE(open);
  ASSERT_EQ(open->verdict, Verdict::kUndecided);
  const Status status = write_certificate(*open, in_folder("x.cert"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::kBadArgument);
  EXPECT_FALSE(fs::exists(in_folder("x.cert")));
}

TEST_F(CertifyFile, SaysWhereACertificateCannotBeWritten) {
  const Result<Certified> found = certify_file(model("m3_smallest.off"));
  ASSERT_TRUE(found);
  const Status status = write_certificate(*found, in_folder("no/such/folder.cert"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::kCannotWrite);
}

}  // namespace
}  // namespace veritope
