// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/model_input.h: one input of a command, which is opened and read once, and only when its bytes are needed.
#pragma once
#include <optional>
#include <string>

#include "io/read_model.h"

namespace veritope::cli {

class ModelInput {
 public:
  /// REQUIRES that the options outlive it.
  ModelInput(std::string path, const ModelReadOptions& options)
      : path_(std::move(path)), options_(options) {}
  ModelInput(std::string, ModelReadOptions&&) = delete;

  /// Decided by --format or the ending of the name, else by the content; .itd files are read, since those with polygons
  /// only are meshes. An input that cannot be read or recognised
  /// counts as a mesh: take() reports what is wrong with it.
  ModelKind kind();

  /// Reads it as read_model_file does. The bytes are released.
  Result<ModelFile> take();

 private:
  const Result<ModelBytes>& bytes();
  /// Nothing: it cannot be read or recognised.
  std::optional<FormatId> format();

  std::string path_;
  const ModelReadOptions& options_;
  std::optional<Result<ModelBytes>> bytes_;
  std::optional<Result<ModelFile>> model_;
};

}  // namespace veritope::cli
