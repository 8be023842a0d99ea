// SPDX-License-Identifier: LGPL-3.0-or-later
// What the four readers have in common: names, limits, foreign data, merging, the hash.
#include "io/read_model.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <chrono>
#include <thread>

#include "tests/io/io_test_util.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

using io_test::content;
using io_test::outcome;
using io_test::packed;
using io_test::read;
using io_test::TempFolder;
using namespace std::string_literals;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 "
    "2\n";
const std::string kStl =
    "solid\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid\n";
const std::string kBinaryStl = std::string(80, ' ') + packed(1u) + packed(0.f, 0.f, 0.f) +
                               packed(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f) + "\0\0"s;
constexpr const char* kTriangle = "0,0,0 1,0,0 0,1,0 | 0,1,2";

Result<MeshFile> read_as(const std::string& name, std::string_view text) {
  return read_mesh_bytes(io_test::bytes(text), name, {});
}

TEST(ReadMesh, TheExtensionDecidesElseTheContent) {
  for (const std::string& text : {kObj, kOff, kPly, kStl, kBinaryStl}) {
    EXPECT_EQ(content(read_as("model", text)), kTriangle) << text;
    EXPECT_EQ(content(read_as("model.bin", text)), kTriangle) << text;
  }
  EXPECT_EQ(content(read_as("x.OBJ", kObj)), kTriangle);
  EXPECT_EQ(content(read_as("x", "# a comment first\n" + kObj)), kTriangle);
  EXPECT_EQ(content(read_as("x", "# a comment first\n" + kOff)), kTriangle);
  EXPECT_EQ(outcome(read_as("x.off", kObj)), "syntax@1");
  EXPECT_EQ(outcome(read_as("x", "hello world")), "unknown-format");
  EXPECT_EQ(outcome(read_as("x.txt", "   ")), "unknown-format");
  ModelReadOptions options;
  options.format = MeshFormat::kObj;
  EXPECT_EQ(content(read_mesh_bytes(io_test::bytes(kObj), "x.off", options)), kTriangle);
}

TEST(ReadMesh, NamesForeignDataWhateverTheFormatAskedFor) {
  const std::pair<std::string, const char*> cases[] = {
      {"\x1F\x8B\x08..."s, "gzip"},
      {"PK\3\4....", "zip"},
      {"PK\5\6....", "zip"},
      {"BZh91AY", "bzip2"},
      {"\xFD"
       "7zXZ\0..."s,
       "xz"},
      {"\x28\xB5\x2F\xFD...", "zstd"},
      {"\xFF\xFEv\0 \0"s, "UTF-16"},
      {"\xFE\xFF\0v"s, "UTF-16"},
      {"\xFF\xFE\0\0v\0\0\0"s, "UTF-32"},
      {"\0\0\xFE\xFF\0\0\0v"s, "UTF-32"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:00", "git-lfs"}};
  for (const auto& [text, name] : cases) {
    for (const MeshFormat format :
         {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff}) {
      const auto file = read(format, text);
      EXPECT_EQ(outcome(file), "foreign-format@byte0");
      EXPECT_NE(file.error().message.find(name), std::string::npos) << file.error().message;
    }
  }
  EXPECT_EQ(outcome(read(MeshFormat::kStl, "")), "empty@byte0");
}

TEST(ReadMesh, EqualPositionsMergeInEveryFormatUnlessAsIndexed) {
  // 0 and 2 are equal, 1 is referenced by nobody.
  const std::string obj = "v 0 0 -0\nv 9 9 9\nv -0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n";
  const auto merged = read(MeshFormat::kObj, obj);
  EXPECT_EQ(content(merged), "0,0,0 9,9,9 1,0,0 0,1,0 | 0,2,3");
  EXPECT_EQ(merged->report.file_vertices, 5u);
  EXPECT_EQ(merged->report.distinct_vertices, 4u);
  EXPECT_EQ(merged->report.referenced_vertices, 3u);
  EXPECT_EQ(merged->report.unreferenced_vertices, 1u);
  ModelReadOptions options;
  options.as_indexed = true;
  const auto indexed = read(MeshFormat::kObj, obj, options);
  EXPECT_EQ(content(indexed), "0,0,0 9,9,9 0,0,0 1,0,0 0,1,0 | 2,3,4");
  EXPECT_EQ(indexed->report.distinct_vertices, 4u);
  EXPECT_EQ(indexed->report.unreferenced_vertices, 2u);
  EXPECT_EQ(content(read(MeshFormat::kOff, "OFF 4 1\n0 0 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3")),
            kTriangle);
}

TEST(ReadMesh, TheHashIsThatOfTheBytesForAnyNumberOfJobs) {
  std::string text = kObj;
  while (text.size() < 1 << 17) text += "# padding that makes hashing in parallel worth while\n";
  const std::string expected = to_hex(sha256(io_test::bytes(text)));
  for (const int jobs : {1, 2, 8}) {
    ModelReadOptions options;
    options.jobs = jobs;
    const auto file = read(MeshFormat::kObj, text, options);
    EXPECT_EQ(content(file), kTriangle);
    EXPECT_EQ(file->sha256, expected);
    EXPECT_EQ(file->report.bytes, text.size());
    EXPECT_EQ(outcome(read(MeshFormat::kObj, text + "f 1 1 9", options)).substr(0, 12),
              "index-out-of");
  }
  ModelReadOptions options;
  options.jobs = 0;
  EXPECT_EQ(outcome(read(MeshFormat::kObj, text, options)), "bad-argument");
}

TEST(ReadMesh, OffendingValuesAreCutAndEscaped) {
  const auto file = read(MeshFormat::kObj, "v 1 2 \x1b[31m" + std::string(100, 'x') + "\n");
  ASSERT_FALSE(file);
  EXPECT_EQ(
      file.error().message,
      "a decimal number expected, but there is '\\x1b[31mxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...'");
}

// A refusal by the reader of one format says which one the content looks like.
TEST(ReadMesh, ARefusalSaysWhatTheContentLooksLike) {
  const auto message = [](MeshFormat format, std::string_view text) {
    return to_string(read(format, text).error());
  };
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_NE(message(MeshFormat::kStl, off).find("it looks like off (--format off)"),
            std::string::npos);
  EXPECT_NE(message(MeshFormat::kObj, off).find("it looks like off (--format off)"),
            std::string::npos);
  EXPECT_NE(message(MeshFormat::kOff, "v 0 0 0\n").find("it looks like obj (--format obj)"),
            std::string::npos);
  EXPECT_EQ(message(MeshFormat::kOff, "OFF\n3 1\n").find("looks like"), std::string::npos);
  const std::string utf16("O\0F\0F\0\n\0", 8);
  EXPECT_NE(message(MeshFormat::kOff, utf16).find("it looks like UTF-16 text"), std::string::npos);
  std::string stl = "solid made by a program" + std::string(57, '\0') + std::string("\2\0\0\0", 4) +
                    std::string(51, '\0');
  EXPECT_NE(message(MeshFormat::kStl, stl)
                .find("its header announces 2 facets, 184 bytes, but it has 135"),
            std::string::npos)
      << message(MeshFormat::kStl, stl);
  // A file that was read as binary has this number in its own message.
  stl.replace(0, 5, "plain");
  EXPECT_EQ(message(MeshFormat::kStl, stl).find("its header announces"), std::string::npos);
  for (const MeshFormat text : {MeshFormat::kObj, MeshFormat::kOff})
    EXPECT_NE(message(text, std::string("\x7F" "ELF\1\0\0\0", 8))
                  .find("it looks like binary data: byte 5 is 0"),
              std::string::npos);
}

TEST(ReadMesh, ErrorsNameTheFile) {
  EXPECT_EQ(to_string(read_as("part.obj", "v 0 0\n").error()),
            "part.obj: line 1: a decimal number expected, but there is the end of the line");
}

TEST(ReadLimitsTest, BytesFaceCountsDigitsAndExponentsHoldAtNAndFailAtNPlusOne) {
  const std::pair<MeshFormat, std::string> files[] = {
      {MeshFormat::kObj, kObj + "f 1 2 3 1\n"},
      {MeshFormat::kOff, "OFF 3 2\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4 0 1 2 0"},
      {MeshFormat::kPly,
       [] {
         std::string text = kPly + "4 0 1 2 0";
         return text.replace(text.find("face 1"), 6, "face 2");
       }()},
      {MeshFormat::kStl, kStl + kStl + kStl}};
  for (const auto& [format, text] : files) {
    ModelReadOptions options;
    options.limits.max_bytes = text.size();
    options.limits.max_faces = 3;
    EXPECT_EQ(outcome(read(format, text, options)), "ok");
    options.limits.max_bytes = text.size() - 1;
    EXPECT_EQ(outcome(read(format, text, options)), "over-limit");
    options.limits.max_bytes = text.size();
    options.limits.max_faces = 2;
    const auto refused = read(format, text, options);
    EXPECT_EQ(outcome(refused).substr(0, 11), "over-limit@");
    EXPECT_EQ(refused.error().message, "more than 2 faces (--max-faces 2)");
    options.limits.max_faces = 1;
    EXPECT_EQ(outcome(read(format, text, options)).substr(0, 11), "over-limit@");
  }
}

TEST(ReadLimitsTest, AnnouncedFacesOverTheLimitAreRefusedWhereTheyAreAnnounced) {
  ModelReadOptions options;
  options.limits.max_faces = 0;
  EXPECT_EQ(outcome(read(MeshFormat::kOff, kOff, options)), "over-limit@2");
  EXPECT_EQ(outcome(read(MeshFormat::kPly, kPly, options)), "over-limit@7");
}

TEST(ReadLimitsTest, BinaryFacesHoldAtNAndFailAtNPlusOne) {
  ModelReadOptions options;
  options.limits.max_faces = 1;
  EXPECT_EQ(outcome(read(MeshFormat::kStl, kBinaryStl, options)), "ok");
  options.limits.max_faces = 0;
  EXPECT_EQ(outcome(read(MeshFormat::kStl, kBinaryStl, options)), "over-limit@byte80");
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\n"
      "property char z\nelement tristrips 1\nproperty list uchar uchar vertex_indices\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  const std::string body(
      "\1\2\3"
      "\1\0"
      "\5\0\0\0\0\0",
      11);
  options.limits.max_faces = 3;
  EXPECT_EQ(outcome(read(MeshFormat::kPly, header + body, options)), "ok");
  options.limits.max_faces = 2;
  EXPECT_EQ(outcome(read(MeshFormat::kPly, header + body, options)),
            "over-limit@byte" + std::to_string(header.size() + 6));
}

TEST(ReadLimitsTest, DigitsAndExponentsAreLimitedInEveryTextFormat) {
  const auto with = [](const std::string& number, const std::string& index, MeshFormat format) {
    switch (format) {
      case MeshFormat::kObj: return "v 0 0 0\nv 1 0 0\nv 0 1 " + number + "\nf 1 2 " + index + "\n";
      case MeshFormat::kOff:
        return "OFF 4 1\n0 0 0\n1 0 0\n0 1 0\n0 1 " + number + "\n3 0 1 " + index + "\n";
      case MeshFormat::kStl:
        return std::string(kStl).replace(kStl.find("0 1 0"), 5, "0 1 " + number);
      case MeshFormat::kPly: break;
    }
    return std::string(kPly)
        .replace(kPly.find("3 0 1 2"), 7, "3 0 1 " + index)
        .replace(kPly.find("0 0 0"), 5, "0 0 " + number);
  };
  ModelReadOptions options;
  options.limits.max_digits = 12;
  options.limits.max_exponent = 99;
  for (const MeshFormat format :
       {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly, MeshFormat::kStl}) {
    const auto outcome_of = [&](const std::string& number, const std::string& index) {
      return outcome(read(format, with(number, index, format), options)).substr(0, 10);
    };
    EXPECT_EQ(outcome_of("0", "2"), "ok");
    EXPECT_EQ(outcome_of("1234567.12345", "2"), "ok");
    EXPECT_EQ(outcome_of("1234567.123456", "2"), "over-limit");
    EXPECT_EQ(outcome_of("1e-99", "2"), "ok");
    EXPECT_EQ(outcome_of("1e-100", "2"), "over-limit");
    EXPECT_EQ(outcome_of("1e99", "2"), "ok");
    EXPECT_EQ(outcome_of("1E+100", "2"), "over-limit");
    if (format == MeshFormat::kStl) continue;
    EXPECT_EQ(outcome_of("0", "000000000002"), "ok");
    EXPECT_EQ(outcome_of("0", "0000000000002"), "over-limit");
  }
  const auto digits =
      read(MeshFormat::kObj, with("1234567.123456", "3", MeshFormat::kObj), options);
  EXPECT_EQ(digits.error().message,
            "more than 12 digits in a number (--max-digits 12): '1234567.123456'");
  const auto exponent = read(MeshFormat::kObj, with("1e100", "3", MeshFormat::kObj), options);
  EXPECT_EQ(exponent.error().message, "an exponent larger than 99 (--max-exponent 99): '1e100'");
}

TEST(ReadLimitsTest, TheDefaultsAreThoseOfTheManual) {
  const auto with = [](const std::string& number) {
    return outcome(read(MeshFormat::kObj, "v 0 0 " + number + "\nv 0 1 0\nv 1 0 0\nf 1 2 3"));
  };
  EXPECT_EQ(with(std::string(1000, '0')), "ok");
  EXPECT_EQ(with(std::string(1001, '0')), "over-limit@1");
  EXPECT_EQ(with("1e-4096"), "ok");
  EXPECT_EQ(with("1e-4097"), "over-limit@1");
  EXPECT_EQ(with("1e4096"), "not-finite@1");
  EXPECT_EQ(with("1e4097"), "over-limit@1");
}

TEST(ReadMeshFile, ReadsAFileAndStandardInput) {
  const TempFolder folder;
  const std::string path = folder.write("a.obj", kObj);
  const auto file = read_mesh_file(path, {});
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(outcome(read_mesh_file("-", {})), "bad-argument");
  const int saved = ::dup(STDIN_FILENO), input = ::open(path.c_str(), O_RDONLY);
  ::dup2(input, STDIN_FILENO);
  ModelReadOptions options;
  options.format = MeshFormat::kObj;
  EXPECT_EQ(content(read_mesh_file("-", options)), kTriangle);
  ::lseek(STDIN_FILENO, 0, SEEK_SET);
  options.limits.max_bytes = kObj.size() - 1;
  EXPECT_EQ(outcome(read_mesh_file("-", options)), "over-limit");
  ::dup2(saved, STDIN_FILENO);
  ::close(saved);
  ::close(input);
}

TEST(ReadMeshFile, ReadsAPipeOfAnyLength) {
  std::string text = kObj;
  while (text.size() < 300000) text += "# more than the first buffer holds\n";
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::thread writer([&] {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t put = ::write(ends[1], text.data() + at, text.size() - at);
      if (put > 0) at += static_cast<std::size_t>(put);
    }
    ::close(ends[1]);
  });
  const int saved = ::dup(STDIN_FILENO);
  ::dup2(ends[0], STDIN_FILENO);
  ModelReadOptions options;
  options.format = MeshFormat::kObj;
  const auto file = read_mesh_file("-", options);
  writer.join();
  ::dup2(saved, STDIN_FILENO);
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.bytes, text.size());
}

TEST(ReadMeshFile, NamesWhatIsNoRegularFile) {
  const TempFolder folder;
  const auto message = [&](const std::string& path) {
    const auto file = read_mesh_file(path, {});
    EXPECT_FALSE(file);
    EXPECT_EQ(file.error().code, Code::kCannotOpen);
    EXPECT_EQ(file.error().place.file, path);
    return file.error().message;
  };
  EXPECT_NE(message(folder / "").find("a directory"), std::string::npos);
  ASSERT_EQ(::mkfifo((folder / "f.stl").c_str(), 0600), 0);
  EXPECT_NE(message(folder / "f.stl").find("a FIFO"), std::string::npos);
  EXPECT_NE(message("/dev/null").find("a character device"), std::string::npos);
  EXPECT_NE(message(folder / "none.stl").find("No such file"), std::string::npos);
}

TEST(ReadMeshFile, RefusesALargeFileBeforeReadingIt) {
  const TempFolder folder;
  const std::string path = folder.write("a.stl", "");
  ASSERT_EQ(::truncate(path.c_str(), off_t{5} << 30), 0);  // a hole
  const auto file = read_mesh_file(path, {});
  EXPECT_EQ(outcome(file), "over-limit");
  EXPECT_EQ(file.error().message, "more than 4294967296 bytes (--max-bytes 4294967296)");
}

TEST(ReadMesh, AnnouncedCountsCostNothing) {
  const std::string lies[] = {
      "OFF\n4000000000 4000000000 0\n" + kOff,
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty "
      "float y\nproperty "
      "float z\nelement face 4000000000\nproperty list uint int vertex_indices\nend_header\n" +
          std::string(60, 0),
      "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nelement vertex 1\nproperty "
      "float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0 "
      "4000000000 0 0 0",
      std::string(80, ' ') + packed(4000000000u) + std::string(50, 0)};
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& lie : lies) {
    const char* const name = lie.starts_with(' ') ? "lie.stl" : "lie";
    EXPECT_EQ(outcome(read_as(name, lie)).substr(0, 9), "truncated");
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(50));
}

}  // namespace
}  // namespace veritope
