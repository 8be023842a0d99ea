// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/io/io_test_util.h: files written as text in a test.
#pragma once
#include <gtest/gtest.h>

#include <unistd.h>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/read_model.h"

namespace veritope::io_test {

inline std::span<const unsigned char> bytes(std::string_view text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

inline Result<MeshFile> read(MeshFormat format, std::string_view text,
                             ModelReadOptions options = {}) {
  options.format = format;
  return read_mesh_bytes(bytes(text), "model", options);
}

/// "code@line" or "code@byteN" of the error, "ok" without an error.
inline std::string outcome(const Result<MeshFile>& file) {
  if (file) return "ok";
  const Error& error = file.error();
  std::string text = code_name(error.code);
  if (error.place.line) text += "@" + std::to_string(*error.place.line);
  if (error.place.byte) text += "@byte" + std::to_string(*error.place.byte);
  return text;
}

/// "x,y,z x,y,z ... | a,b,c ..." of what was read, or the outcome.
inline std::string content(const Result<MeshFile>& file) {
  if (!file) return outcome(file) + ": " + to_string(file.error());
  std::string text;
  char number[100];
  for (const Vec3d& p : file->mesh.positions) {
    std::snprintf(number, sizeof number, "%.17g,%.17g,%.17g ", p.x, p.y, p.z);
    text += number;
  }
  text += "|";
  for (const auto& f : file->mesh.faces) {
    std::snprintf(number, sizeof number, " %u,%u,%u", f[0], f[1], f[2]);
    text += number;
  }
  return text;
}

/// How often the report says that `what` was ignored.
inline std::uint64_t ignored(const MeshFile& file, std::string_view what) {
  for (const auto& [name, count] : file.report.ignored) {
    if (name == what) return count;
  }
  return 0;
}

/// "code: message" of every notice, one a line.
inline std::string notices(const MeshFile& file) {
  std::string text;
  for (const ReadNotice& n : file.report.notices)
    text += (text.empty() ? "" : "\n") + n.code + ": " + n.message;
  return text;
}

/// The bytes of numbers, in memory order.
template <typename... Numbers>
std::string packed(Numbers... numbers) {
  std::string text;
  const auto append = [&](auto number) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    text.append(raw, sizeof number);
  };
  (append(numbers), ...);
  return text;
}

/// A folder of its own that goes away with the object.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "veritope-io-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }
  /// The names in it, sorted, each followed by a blank.
  std::string list() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::string text;
    for (const std::string& name : names) text += name + " ";
    return text;
  }

 private:
  std::filesystem::path path_;
};

inline std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace veritope::io_test
