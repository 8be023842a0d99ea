// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/volume_weld.h"

#include <utility>

#include "io/base/exact_number.h"
#include "io/splines/volumes.h"
#include "robust/base/stopwatch.h"

namespace veritope::cli {

std::string take_weld_distance(const std::string& text, std::optional<Rational>& eps) {
  Rational value;
  if (text.empty()) return "needs a distance";
  if (read_exact_number(text, {}, value) != DecimalFault::kNone)
    return "needs a decimal, fraction or hexadecimal number, not " + text;
  if (value.sign() <= 0) return "must be over 0, not " + text;
  eps = std::move(value);
  return "";
}

Result<report::WeldReport> weld_volumes(SplineFile& file, const std::string& path,
                                        const Rational& eps) {
  const auto placed = [&path](Error error) {
    error.place.file = path;
    return error;
  };
  Stopwatch watch;
  Result<std::vector<ExactVolume>> cells = volumes_of(file);
  if (!cells) {
    Error error = placed(cells.error());
    error.message += " (--weld is for files of volumes only)";
    return error;
  }
  report::WeldReport out;
  out.path = path;
  out.sha256 = file.sha256;
  out.eps = eps;
  out.num_cells = cells->size();
  Result<VWeld> welded = weld(std::move(*cells), eps);
  if (!welded) return placed(welded.error());
  for (const std::uint32_t c : welded->changed)
    file.model.entities[c].shape = std::move(welded->cells[c]);
  welded->cells.clear();
  out.weld = std::move(*welded);
  out.seconds = watch.lap();
  return out;
}

}  // namespace veritope::cli
