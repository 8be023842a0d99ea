// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/sweep_report.h"

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

const char* short_word(Answer a) {
  return a == Answer::kTrue ? "yes" : a == Answer::kFalse ? "no" : "undecided";
}

std::uint64_t num_boxes(const SweepRow& row) {
  return row.face_boxes + row.edge_boxes + row.vertex_boxes;
}

Json condition_json(const ConditionResult& c) {
  return {{"answer", to_string(c.answer)},
          {"checked", c.checked},
          {"reason", c.offences.empty() ? Json(nullptr) : Json(to_string(c.offences.front()))}};
}

Json row_json(const SweepRow& row) {
  Json conditions, collar;
  for (std::size_t c = 0; c < kNumPaperConditions; ++c)
    conditions[name_of(static_cast<PaperCondition>(c))] = condition_json(row.conditions[c]);
  for (std::size_t k = 0; k < row.collar.size(); ++k)
    collar["K" + std::to_string(k + 1)] = to_string(row.collar[k]);
  return {
      {"eps", row.eps},
      {"boxes", {{"face", row.face_boxes}, {"edge", row.edge_boxes}, {"vertex", row.vertex_boxes}}},
      {"conditions", conditions},
      {"cells", row.cells},
      {"collar", collar},
      {"limit", row.why_not.empty() ? Json(nullptr) : Json(row.why_not)}};
}

}  // namespace

const SweepRow* finest_row(const std::vector<SweepRow>& rows) {
  const SweepRow* out = nullptr;
  for (const SweepRow& row : rows)
    if (num_boxes(row) > 0) out = &row;
  return out;
}

std::string sweep_text(const std::vector<SweepRow>& rows) {
  std::string out = to_table(rows);
  const SweepRow* const last = finest_row(rows);
  if (last == nullptr) return out;
  for (std::size_t c = 0; c < kNumPaperConditions; ++c) {
    const ConditionResult& r = last->conditions[c];
    if (r.answer == Answer::kTrue || r.offences.empty()) continue;
    out += detail_line(name_of(static_cast<PaperCondition>(c)),
                       std::string(short_word(r.answer)) + " at eps " +
                           short_decimal(last->eps, 9) + ": " + to_string(r.offences.front()));
  }
  return out;
}

std::string sweep_json(const std::string& path, const std::string& sha256,
                       const std::vector<SweepRow>& rows) {
  Json list = Json::array();
  for (const SweepRow& row : rows) list.push_back(row_json(row));
  return dump({{"schema", "veritope-sweep-1"},
               {"tool", tool_name()},
               {"path", path},
               {"sha256", sha256},
               {"rows", list}}) +
         "\n";
}

}  // namespace veritope::report
