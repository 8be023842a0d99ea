// SPDX-License-Identifier: LGPL-3.0-or-later
// io/formats.h: the table of formats. A new format needs a new row in io/formats.cc, and nothing else outside its
// folder.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/base/source.h"
#include "io/model_file.h"

namespace veritope {

struct ModelFormat {
  FormatId id;
  const char* name;  ///< as in certificates, reports and --format: "stl"
  /// Endings of file names, in lower case, without the dot. Each ending and the name itself denote this format.
  std::vector<std::string_view> endings;
  /// Whether the bytes look like this format. The first row that accepts them wins.
  bool (*looks_like)(const Source& source);
  /// REQUIRES that the source is not empty. Does not set sha256 and the seconds. The file is of this format's kind, or
  /// a mesh: the polygons of an .itd file, unless options.kind is kSplines.
  Result<ModelFile> (*read)(const Source& source, const ModelReadOptions& options);
  /// For messages; may be null. What a refused file of this format may have been meant to be; may be empty.
  std::string (*second_guess)(const Source& source);
  /// Null: this format is not written. REQUIRES a file of this format's kind.
  Result<std::string> (*write)(const ModelFile& file, const ReadLimits& limits);

  ModelKind kind() const { return kind_of(id); }
};

/// All rows. Their order is the order of lists in messages, and of the attempts to recognise a content.
std::span<const ModelFormat> model_formats();

/// The row of a format.
const ModelFormat& model_format(const FormatId& id);

/// Each returns null if no row fits. If a kind is given, only formats of that kind count. Letters
/// of either case are equal. The ending of a path is the part of its file name after the last dot.
const ModelFormat* format_from_name(std::string_view name,
                                    std::optional<ModelKind> kind = std::nullopt);
const ModelFormat* format_from_path(std::string_view path,
                                    std::optional<ModelKind> kind = std::nullopt);
const ModelFormat* format_from_content(const Source& source,
                                       std::optional<ModelKind> kind = std::nullopt);

/// "stl, obj, ply or off" for the conjunction "or": the names of the formats of a kind, or of all formats.
std::string format_names(std::string_view conjunction,
                         std::optional<ModelKind> kind = std::nullopt);

}  // namespace veritope
