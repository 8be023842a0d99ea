// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/model_input.h"

#include <new>

#include "io/formats.h"

namespace veritope::cli {

std::optional<FormatId> ModelInput::format() {
  if (options_.format) return options_.format;
  if (const ModelFormat* const row = format_from_path(path_)) return row->id;
  if (!bytes()) return std::nullopt;
  const Result<FormatId> format = choose_format(*bytes(), options_);
  return format ? std::optional(*format) : std::nullopt;
}

ModelKind ModelInput::kind() {
  try {
    const std::optional<FormatId> id = format();
    if (!id) return ModelKind::kMesh;
    if (*id != FormatId(SplineFormat::kItd)) return kind_of(*id);
    if (!model_) model_.emplace(take());
    return *model_ ? kind_of(**model_) : kind_of(*id);
  } catch (const std::bad_alloc&) {
    return ModelKind::kMesh;  // take() throws it where a report can say so
  }
}

Result<ModelFile> ModelInput::take() {
  if (model_) {
    Result<ModelFile> out = std::move(*model_);
    model_.reset();
    return out;
  }
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
