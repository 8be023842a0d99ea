// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/read_splines.h"

#include "io/splines/spline_text_reader.h"

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

}  // namespace

Result<SplineFile> read_splines(SplineFormat format, const Source& source,
                                const ReadLimits& limits) {
  Result<SplineFile> file = parse(format, source, limits);
  if (!file) return file.error();
  file->format = format;
  file->bytes = source.size();
  return file;
}

}  // namespace veritope
