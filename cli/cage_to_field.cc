// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/cage_to_field.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/base/file_bytes.h"
#include "io/fields/read_field.h"
#include "solids/micro/cage/fit_cage.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

constexpr std::uint64_t kSpans = 4;
constexpr int kDegree = 3;

report::CageReport::Fit report_of(const FieldFile& file, const FitCage& fit) {
  report::CageReport::Fit out;
  out.vectors = file.field.size();
  out.has_tensors = file.has_tensors;
  out.steps = fit.steps;
  out.shortened = fit.shortened;
  std::vector<double> angles = fit.approx_angles;
  const auto worst = std::ranges::max_element(angles);
  out.worst = *worst;
  out.worst_line = file.lines[static_cast<std::size_t>(worst - angles.begin())];
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::ranges::nth_element(angles, middle);
  out.median = *middle;
  if (fit.stop) {
    const auto& span = fit.stop->span;
    out.stop_span = {span[0], span[1], span[2]};
    out.stop_near = fit.stop->near;
  }
  if (!fit.approx_thickness_errors.empty())
    out.thickness_error = *std::ranges::max_element(fit.approx_thickness_errors);
  return out;
}

}  // namespace

Result<FittedCage> fitted_cage(const CageOptions& options, const CageContent* content) {
  const std::string& path = *options.field;
  const Result<ByteBuffer> bytes = read_file_bytes(path, options.reading.limits.max_bytes);
  if (!bytes) return bytes.error();
  const Source source = source_of(*bytes, path);
  const Result<FieldFile> file = read_field(source, options.reading.limits);
  if (!file) return file.error();
  const CageContent none;
  const CageContent& inside = content != nullptr ? *content : none;
  FitCageOptions fit_options;
  fit_options.grid = options.grid(kSpans, kDegree);
  fit_options.margin = margin_length(box_of(file->field, inside), options.margin_part());
  fit_options.jobs = static_cast<unsigned>(options.reading.jobs);
  if (fit_options.margin.sign() == Sign::kZero) {
    Error error = bad_argument(
        "all vectors are at one place, around which there is no box; --around gives one");
    error.place.file = path;
    return error;
  }
  Result<FitCage> fit = fit_cage(file->field, inside, fit_options);
  if (!fit) return fit.error();
  const auto digest = sha256({reinterpret_cast<const unsigned char*>(source.begin),
                              static_cast<std::size_t>(source.size())});
  return FittedCage{std::move(fit->cell), report_of(*file, *fit), to_hex(digest)};
}

}  // namespace veritope::cli
