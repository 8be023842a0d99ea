// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/kept_copy.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/base/file_bytes.h"
#include "verify/certify/certify_file.h"
#include "verify/format/claims.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

// Nothing if the name is not that of a copy.
std::optional<std::string> certificate_beside(const std::string& path) {
  for (const char* const format : kCopyFormats) {
    const std::string certificate = path.substr(0, path.rfind('.'));
    if (certificate.ends_with(".cert") && copy_path(certificate, format) == path)
      return certificate;
  }
  return std::nullopt;
}

bool is_file(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_regular_file(path, none);
}

// Bytes from the start of a file that are more than the longest statement.
std::vector<unsigned char> head_of(const std::string& path) {
  std::vector<unsigned char> out(std::size_t{1} << 17);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(file.gcount()));
  return out;
}

}  // namespace

std::optional<std::string> kept_copy_sha256(const std::string& path) {
  const std::optional<std::string> certificate = certificate_beside(path);
  if (!certificate || !is_file(*certificate) || !is_file(path)) return std::nullopt;
  const auto subject = certificate::stated_subject(head_of(*certificate));
  if (!subject) return std::nullopt;
  const Result<ByteBuffer> bytes = read_file_bytes(path, subject->bytes);
  if (!bytes || bytes->size() != subject->bytes) return std::nullopt;
  std::string hash = to_hex(sha256({bytes->data(), bytes->size()}));
  if (hash != subject->sha256) return std::nullopt;
  return hash;
}

}  // namespace veritope::cli
