// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/read_splines.h"

#include <unistd.h>

#include "io/base/file_bytes.h"
#include "io/base/foreign_content.h"
#include "io/base/read_limits.h"
#include "io/splines/spline_text_reader.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

Result<SplineFile> parse(SplineFormat format, const Source& source, const ReadLimits& limits) {
  switch (format) {
    case SplineFormat::kItd: return read_itd(source, limits);
    case SplineFormat::kG2: return read_g2(source, limits);
    case SplineFormat::kMfem: return read_mfem(source, limits);
    case SplineFormat::kGismo: return read_gismo(source, limits);
    case SplineFormat::kJson: return read_spline_json(source, limits);
  }
  return error_in_file(*source.name, Code::kBadArgument, "no such format");
}

Result<SplineFormat> choose_format(const Source& source, const SplineReadOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = spline_format_from_path(*source.name)) return *format;
  if (const auto format = spline_format_from_content(source)) return *format;
  return error_in_file(*source.name, Code::kUnknownFormat,
                       "neither the extension nor the content says whether this is itd, g2, mfem, "
                       "gismo or vjson (--format)");
}

Result<SplineFile> read_buffer(const ByteBuffer& buffer, const std::string& name,
                               const SplineReadOptions& options) {
  const Source source = source_of(buffer, name);
  if (std::optional<Error> foreign = refuse_foreign(source)) return std::move(*foreign);
  const Result<SplineFormat> format = choose_format(source, options);
  if (!format) return format.error();
  Result<SplineFile> file = read_splines(*format, source, options.limits);
  if (!file) return file.error();
  Sha256 sha;
  sha.update({buffer.data(), buffer.size()});
  file->sha256 = to_hex(sha.finish());
  return file;
}

}  // namespace

Result<SplineFile> read_splines(SplineFormat format, const Source& source,
                                const ReadLimits& limits) {
  Result<SplineFile> file = parse(format, source, limits);
  if (!file) {
    Error error = file.error();
    const auto other = spline_format_from_content(source);
    const bool is_syntax = error.code == Code::kSyntax || error.code == Code::kTruncated;
    if (is_syntax && other && *other != format)
      error.message += std::string("; it looks like ") + spline_format_name(*other) +
                       " (--format " + spline_format_name(*other) + ")";
    return error;
  }
  file->format = format;
  file->bytes = source.size();
  return file;
}

Result<SplineFile> read_spline_file(const std::string& path, const SplineReadOptions& options) {
  if (path == "-" && !options.format)
    return error_in_file(path, Code::kBadArgument, "standard input needs a format (--format)");
  const std::uint64_t max_bytes = options.limits.max_bytes;
  const Result<ByteBuffer> buffer = path == "-" ? read_descriptor(STDIN_FILENO, path, 0, max_bytes)
                                                : read_file_bytes(path, max_bytes);
  if (!buffer) return buffer.error();
  return read_buffer(*buffer, path, options);
}

Result<SplineFile> read_spline_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                     const SplineReadOptions& options) {
  if (bytes.size() > options.limits.max_bytes)
    return error_in_file(name, Code::kOverLimit,
                         over_limit("bytes", "--max-bytes", options.limits.max_bytes));
  return read_buffer(copy_to_buffer(bytes), name, options);
}

}  // namespace veritope
