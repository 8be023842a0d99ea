// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/totals.h"

#include <vector>

#include "interval/numeric.h"
#include "io/formats.h"
#include "report/decimal_text.h"
#include "report/mesh_report_internal.h"
#include "report/patch_report_internal.h"
#include "report/report_text.h"

namespace veritope::report {
namespace {

constexpr std::array<const char*, 12> kColumns = {"file",   "verdict", "exit",    "checked",
                                                  "format", "bytes",   "seconds", "bodies",
                                                  "genus",  "volume",  "codes",   "summary"};

std::string joined(const std::vector<std::string>& fields) {
  std::string out;
  for (const std::string& field : fields) out += (out.empty() ? "" : "\t") + field;
  return out + "\n";
}

template <typename T>
std::string number_text(const std::optional<T>& value) {
  return value ? std::to_string(*value) : "";
}

// harmless, and each backslash of the name as \\x5c: the bytes of the name can be found again.
std::string reversible(const std::string& path) {
  std::string out;
  for (const char c : path) out += c == '\\' ? std::string("\\x5c") : std::string(1, c);
  return harmless(out);
}

// Bodies, genus, volume, and "M3:4 M7:2" or "side-open".
struct Facets {
  std::string bodies, genus, volume, codes;
};

Facets facets_of(const MeshFacts& facts, const FileReport& report) {
  const ValidityReport& d = facts.decision;
  Facets out;
  for (std::size_t i = 0; i < kNumMeshRules; ++i)
    if (d.rule_counts[i] != 0)
      out.codes += (out.codes.empty() ? "" : " ") + std::string(rule_text(rule_at(i)).id) + ":" +
                   std::to_string(d.rule_counts[i]);
  if (report.verdict != Verdict::kValid) return out;
  out.bodies = number_text(d.counts.bodies);
  out.genus = number_text(d.counts.genus);
  if (d.volume) out.volume = short_decimal(*d.volume, 17);
  return out;
}

Facets facets_of(const PatchFacts& facts, const FileReport& report) {
  Facets out;
  if (!report.defects.empty()) out.codes = report.defects.front().code;
  if (report.verdict != Verdict::kValid) return out;
  out.bodies = std::to_string(facts.bodies);
  out.genus = std::to_string(facts.genus);
  if (facts.volume) out.volume = short_decimal(mid(*facts.volume));
  return out;
}

Facets facets_of(const MicroFacts& facts, const FileReport& report) {
  Facets out;
  if (!report.defects.empty()) out.codes = report.defects.front().code;
  if (report.verdict != Verdict::kValid) return out;
  out.bodies = std::to_string(facts.counts.components);
  out.genus = std::to_string(facts.counts.genus);
  return out;
}

Facets facets_of(const DmsFacts& facts, const FileReport& report) {
  Facets out;
  if (!report.defects.empty()) out.codes = report.defects.front().code;
  if (report.verdict != Verdict::kValid) return out;
  std::uint64_t genus = 0;
  for (const std::uint64_t g : facts.genera) genus += g;
  out.bodies = std::to_string(facts.bodies);
  out.genus = std::to_string(genus);
  if (facts.volume) out.volume = short_decimal(mid(*facts.volume));
  return out;
}

Facets facets_of(const std::monostate&, const FileReport&) { return {}; }

}  // namespace

std::pair<double, PhaseTime> total_and_longest(const PhaseSeconds& seconds) {
  double total = 0;
  PhaseTime longest;
  for (const auto& [name, part] : {std::pair{"reading", seconds.read},
                                   {"deciding", seconds.decide},
                                   {"looking for a collar", seconds.collar},
                                   {"certifying", seconds.certify},
                                   {"drawing", seconds.draw},
                                   {"checking", seconds.check}}) {
    total += part.value_or(0);
    if (part.value_or(0) > longest.seconds) longest = {name, *part};
  }
  return {total, longest};
}

void Totals::add(const FileReport& report) {
  ++files_;
  const std::size_t which = !report.verdict                         ? 3
                            : report.verdict == Verdict::kUndecided ? 2
                            : report.verdict == Verdict::kInvalid   ? 1
                                                                    : 0;
  ++verdicts_[which];
}

std::string Totals::text() const {
  constexpr std::array<const char*, 4> kNames = {"valid", "invalid", "undecided", "unreadable"};
  std::string out = counted(files_, "file", "files");
  const char* separator = ": ";
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (verdicts_[i] == 0) continue;
    out += separator + std::to_string(verdicts_[i]) + " " + kNames[i];
    separator = ", ";
  }
  return out + "\n";
}

std::string tsv_head() { return joined({kColumns.begin(), kColumns.end()}); }

std::string tsv_row(const FileReport& report) {
  const Facets facets =
      std::visit([&](const auto& facts) { return facets_of(facts, report); }, report.facts);
  const bool is_checked = report.certificate && report.certificate->is_checked;
  const std::string codes =
      report.has_verdict() || !report.fault ? facets.codes : report.fault->code;
  return joined({reversible(report.path), verdict_word(report.verdict),
                 std::to_string(static_cast<int>(report.exit)), is_checked ? "yes" : "no",
                 format_name(report).value_or(""), number_text(num_bytes(report)),
                 short_decimal(total_and_longest(report.seconds).first, 6), facets.bodies,
                 facets.genus, facets.volume, codes, summary_text(report)});
}

}  // namespace veritope::report
