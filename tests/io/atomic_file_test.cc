// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/atomic_file.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <array>
#include <csignal>

#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

using io_test::slurp;
using io_test::TempFolder;

AtomicFile create(const std::string& path) { return std::move(AtomicFile::create(path)).value(); }

std::string refusal(const std::string& path) {
  const auto file = AtomicFile::create(path);
  EXPECT_FALSE(file);
  if (file) return "";
  EXPECT_EQ(file.error().code, Code::kCannotWrite);
  EXPECT_EQ(file.error().place.file, path);
  return file.error().message;
}

TEST(AtomicFile, AppearsOnCommit) {
  const TempFolder folder;
  {
    AtomicFile file = create(folder / "a");
    EXPECT_TRUE(file.write("one "));
    EXPECT_TRUE(file.write("two"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    EXPECT_TRUE(file.commit());
    EXPECT_FALSE(file.commit()) << "once";
    EXPECT_FALSE(file.write("late"));
  }
  EXPECT_EQ(slurp(folder / "a"), "one two");
  EXPECT_EQ(folder.list(), "a ");
}

TEST(AtomicFile, LeavesTheOldFileUntilCommitAndNothingWithoutIt) {
  const TempFolder folder;
  folder.write("a", "old");
  {
    AtomicFile file = create(folder / "a");
    EXPECT_TRUE(file.write("new"));
    EXPECT_EQ(slurp(folder / "a"), "old");
  }
  EXPECT_EQ(slurp(folder / "a"), "old");
  EXPECT_EQ(folder.list(), "a ");
  AtomicFile file = create(folder / "a");
  AtomicFile moved = std::move(file);
  EXPECT_TRUE(moved.write("new"));
  EXPECT_TRUE(moved.commit());
  EXPECT_EQ(slurp(folder / "a"), "new");
}

TEST(AtomicFile, KeepsPermissionsAndFollowsLinks) {
  const TempFolder folder;
  folder.write("a", "old");
  ASSERT_EQ(::chmod((folder / "a").c_str(), 0640), 0);
  std::filesystem::create_symlink("a", folder / "link");
  AtomicFile file = create(folder / "link");
  EXPECT_TRUE(file.write("new"));
  EXPECT_TRUE(file.commit());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(slurp(folder / "a"), "new");
  struct stat status {};
  ASSERT_EQ(::stat((folder / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, RefusesWhatIsNoFileToReplace) {
  const TempFolder folder;
  EXPECT_NE(refusal(folder / "none/a").find("No such file"), std::string::npos);
  EXPECT_NE(refusal(folder / "").find("names no file"), std::string::npos);
  std::filesystem::create_directory(folder / "d");
  EXPECT_NE(refusal(folder / "d").find("directory"), std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("not a regular file"), std::string::npos);
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  EXPECT_NE(refusal(folder / "dangling").find("link to nowhere"), std::string::npos);
  EXPECT_NE(refusal("").find("names no file"), std::string::npos);
}

TEST(AtomicFile, AShortWriteIsAnErrorAndLeavesTheOldFile) {
  const TempFolder folder;
  folder.write("a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    AtomicFile file = create(folder / "a");
    const bool first = file.write(std::string(900, 'x')).has_value();
    const auto second = file.write(std::string(900, 'x'));
    const bool is_right = first && !second && second.error().code == Code::kCannotWrite &&
                          !file.commit() && folder.list() == "a ";
    ::_exit(is_right ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(slurp(folder / "a"), "old");
  EXPECT_EQ(folder.list(), "a ");
}

TEST(AtomicFile, ASignalHandlerCanRemoveTheTemporaries) {
  const TempFolder folder;
  folder.write("a", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGTERM, [](int) {
      const bool has_removed = remove_unfinished_files();
      ::_exit(has_removed && !remove_unfinished_files() ? 7 : 8);
    });
    AtomicFile first = create(folder / "a"), second = create(folder / "b");
    AtomicFile third = create(folder / "c");
    const bool is_right = first.write("half").has_value() && third.commit().has_value();
    if (is_right) ::raise(SIGTERM);
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 7);
  EXPECT_EQ(slurp(folder / "a"), "old");
  EXPECT_EQ(folder.list(), "a c ");
}

TEST(AtomicFile, AFinishedFileTakesNoMoreBytesAndCanStillBeCommitted) {
  const TempFolder folder;
  AtomicFile file = create(folder / "a");
  EXPECT_TRUE(file.write("all"));
  EXPECT_TRUE(file.finish());
  EXPECT_FALSE(file.write("late"));
  EXPECT_FALSE(file.finish()) << "once";
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
  EXPECT_TRUE(file.commit());
  EXPECT_EQ(slurp(folder / "a"), "all");
}

TEST(WriteFiles, NoneAppearsUnlessAllCanBeWritten) {
  const TempFolder folder;
  folder.write("old", "old");
  const std::string first = folder / "first", old = folder / "old";
  EXPECT_FALSE(write_files(std::array{WholeFile{first, "1"}, WholeFile{folder / "none/x", "2"}}));
  EXPECT_FALSE(write_files(std::array{WholeFile{old, "1"}, WholeFile{folder / "none/x", "2"}}));
  EXPECT_EQ(folder.list(), "old ");
  EXPECT_EQ(slurp(old), "old");
  EXPECT_TRUE(write_files(std::array{WholeFile{first, "1"}, WholeFile{old, "2"}}));
  EXPECT_EQ(slurp(first) + slurp(old), "12");
  EXPECT_EQ(folder.list(), "first old ");
}

TEST(AtomicFile, ManyMayBeOpenAtOnceAndThenNoMore) {
  const TempFolder folder;
  std::vector<AtomicFile> files;
  for (int i = 0; i < 64; ++i) files.push_back(create(folder / std::to_string(i)));
  EXPECT_NE(refusal(folder / "more").find("too many"), std::string::npos);
  files.pop_back();
  EXPECT_TRUE(create(folder / "more").commit());
  files.clear();
  EXPECT_EQ(folder.list(), "more ");
}

TEST(SameFile, SeesThroughLinksAndNames) {
  const TempFolder folder;
  folder.write("a", "");
  folder.write("b", "");
  std::filesystem::create_symlink("a", folder / "soft");
  std::filesystem::create_hard_link(folder / "a", folder / "hard");
  EXPECT_TRUE(same_file(folder / "a", folder / "./a"));
  EXPECT_TRUE(same_file(folder / "a", folder / "soft"));
  EXPECT_TRUE(same_file(folder / "a", folder / "hard"));
  EXPECT_FALSE(same_file(folder / "a", folder / "b"));
  EXPECT_FALSE(same_file(folder / "none", folder / "none"));
}

}  // namespace
}  // namespace veritope
