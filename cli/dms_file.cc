// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "io/base/exact_number.h"
#include "report/text_style.h"
#include "solids/dms/dms_validity.h"

namespace veritope::cli {

Result<DmsFile> read_dms_file(const std::string& path, ModelReadOptions reading) {
  reading.kind = ModelKind::kDms;
  if (path == "-" && !reading.format) reading.format = FormatId(DmsFormat::kDms);
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  return std::get<DmsFile>(std::move(*file));
}

Status try_dms_outputs(std::vector<std::string> inputs, const std::optional<std::string>& output,
                       const std::optional<std::string>& json) {
  std::erase(inputs, "-");
  if (output == "-" && json == "-")
    return bad_argument("--output and --json would both write standard output");
  const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, json);
  if (!plan) return plan.error();
  if (output)
    if (const Status status = check_output("--output", *output, inputs, *plan, json); !status)
      return status;
  return try_outputs(*plan, {output, json});
}

Result<DmsComponent> dms_component(const DmsModel& model, const std::string& attribute) {
  if (const auto found = find_attribute(model, attribute)) return *found;
  std::string names;
  for (const std::string& name : all_attributes(model)) names += (names.empty() ? "" : ", ") + name;
  return bad_argument("--attribute " + attribute + ": the model has " +
                      (names.empty() ? "no attributes" : "the attributes " + names));
}

Error in_dms_model(Error error, const std::string& path) {
  error.place.file = path;
  if (error.place.entity)
    error.message = "tetrahedron " + std::to_string(*error.place.entity) + ": " + error.message;
  error.place.entity.reset();
  return error;
}

std::string dms_refusal(const std::string& path, const DmsDefects& defects) {
  const DmsDefect& first = defects.first.at(0);
  return path + ": " + fault_name(first.fault) + ": " + to_string(first) +
         (defects.count > 1
              ? "; " + report::counted(defects.count - 1, "more defect", "more defects")
              : "");
}

std::string take_dms_point(std::string_view text, DmsPoint& point) {
  if (std::ranges::count(text, ',') != 2)
    return "must be x,y,z without spaces, not " + std::string(text);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string_view token = text.substr(0, end);
    if (read_exact_number(token, {}, point[c]) != DecimalFault::kNone)
      return "needs decimals, fractions or hexadecimal numbers, not '" + std::string(token) + "'";
    if (const Status status = check_dms_number(point[c]); !status) return status.error().message;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return "";
}

}  // namespace veritope::cli
