// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"

namespace veritope::cli {

Result<DmsFile> read_dms_file(const std::string& path, ModelReadOptions reading) {
  reading.kind = ModelKind::kDms;
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  return std::get<DmsFile>(std::move(*file));
}

}  // namespace veritope::cli
