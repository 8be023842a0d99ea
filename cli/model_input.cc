// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/model_input.h"

#include <new>

#include "io/formats.h"

namespace veritope::cli {

ModelKind ModelInput::kind() {
  if (options_.format) return kind_of(*options_.format);
  if (const ModelFormat* const row = format_from_path(path_)) return row->kind();
  try {
    if (!bytes()) return ModelKind::kMesh;
    const Result<FormatId> format = choose_format(*bytes(), options_);
    return format ? kind_of(*format) : ModelKind::kMesh;
  } catch (const std::bad_alloc&) {
    return ModelKind::kMesh;  // take() throws it where a report can say so
  }
}

Result<ModelFile> ModelInput::take() {
  if (!bytes()) return bytes().error();
  const Result<ModelBytes> taken = std::move(*bytes_);
  bytes_.reset();
  return read_model(*taken, options_);
}

const Result<ModelBytes>& ModelInput::bytes() {
  if (!bytes_) bytes_.emplace(load_model(path_, options_));
  return *bytes_;
}

}  // namespace veritope::cli
