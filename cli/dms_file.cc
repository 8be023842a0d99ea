// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"
#include "report/text_style.h"

namespace veritope::cli {

Result<DmsFile> read_dms_file(const std::string& path, ModelReadOptions reading) {
  reading.kind = ModelKind::kDms;
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  return std::get<DmsFile>(std::move(*file));
}

Result<std::size_t> dms_component(const DmsModel& model, const std::string& attribute) {
  std::string names;
  for (std::size_t a = 0; a < model.attributes.size(); ++a) {
    if (model.attributes[a] == attribute) return 3 + a;
    names += (a == 0 ? "" : ", ") + model.attributes[a];
  }
  return bad_argument("--attribute " + attribute + ": the model has " +
                      (names.empty() ? "no attributes" : "the attributes " + names));
}

std::string dms_refusal(const std::string& path, const DmsDefects& defects) {
  const DmsDefect& first = defects.first.at(0);
  return path + ": " + fault_name(first.fault) + ": " + to_string(first) +
         (defects.count > 1
              ? "; " + report::counted(defects.count - 1, "more defect", "more defects")
              : "");
}

}  // namespace veritope::cli
