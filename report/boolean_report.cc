// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/boolean_report.h"

#include "report/json_text.h"
#include "verify/certify/certify.h"

namespace veritope::report {

std::string boolean_json(const BooleanReport& report) {
  Json out, operands = Json::array(), box = Json::array();
  for (const auto& o : report.operands)
    operands.push_back({{"name", o.name},
                        {"path", o.path},
                        {"sha256", o.sha256},
                        {"bytes", o.bytes},
                        {"format", o.format}});
  for (std::size_t i = 0; i < 6; ++i)
    box.push_back((i < 3 ? report.box[i].lo : report.box[i - 3].hi).to_string());
  out["schema"] = "veritope-boolean-1";
  out["tool"] = tool_name();
  out["output"] = {{"path", report.path}, {"sha256", report.sha256}, {"bytes", report.bytes}};
  out["expression"] = report.expression;
  out["normal_form"] = report.normal_form;
  out["size"] = {
      {"operands", report.leaves}, {"depth", report.depth}, {"variables", report.variables}};
  out["operands"] = operands;
  out["box"] = box;
  out["boundary"] = "not certified";
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

}  // namespace veritope::report
