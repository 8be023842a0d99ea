// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about meshes, for people.
#include <algorithm>
#include <array>
#include <string_view>

#include "report/decimal_text.h"
#include "report/mesh_report_internal.h"

namespace veritope::report {
namespace {

using internal::decision_of;
using internal::reading_of;

// Singular and plural of what the rules count.
struct Noun {
  std::string_view one, many;
};
constexpr std::array<Noun, kNumMeshRules> kNouns = {{
    {"degenerate face", "degenerate faces"},
    {"duplicate face", "duplicate faces"},
    {"boundary edge", "boundary edges"},
    {"edge with more than two faces", "edges with more than two faces"},
    {"misoriented edge", "misoriented edges"},
    {"vertex with several fans", "vertices with several fans"},
    {"improper intersection", "improper intersections"},
    {"inward outer shell", "inward outer shells"},
    {"wrongly nested shell", "wrongly nested shells"},
}};

constexpr std::size_t kExactSize = 28;  // characters of a fraction before it is cut

std::string point_text(const Point3d& p) {
  return "(" + short_decimal(p[0]) + ", " + short_decimal(p[1]) + ", " + short_decimal(p[2]) + ")";
}

std::string valid_summary(const FileReport& report) {
  const MeshCounts& c = decision_of(report)->counts;
  std::string text = counted(c.bodies.value_or(0), "body", "bodies");
  if (c.genus) text += ", genus " + std::to_string(*c.genus);
  if (decision_of(report)->volume)
    text += ", volume " + short_decimal(*decision_of(report)->volume);
  return text;
}

std::string in_places(const ValidityReport& decision) {
  return " in " + counted(decision.places.size(), "place", "places");
}

std::string invalid_summary(const FileReport& report) {
  constexpr int kMost = 3;
  std::string text;
  int shown = 0;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const std::uint64_t count = decision_of(report)->rule_counts[i];
    if (count == 0) continue;
    if (++shown > kMost) return text + ", ...";
    text += (shown == 1 ? "" : ", ") + counted(count, kNouns[i].one, kNouns[i].many);
    if (rule_at(i) == MeshRule::kM7) text += in_places(*decision_of(report));
  }
  return text;
}

std::string counts_text(const FileReport& report) {
  const MeshCounts& c = decision_of(report)->counts;
  std::string text =
      counted(c.faces, "face", "faces") + ", " + internal::vertices_text(*reading_of(report)) +
      ", " + counted(c.edges, "edge", "edges") + ", " + counted(c.shells, "shell", "shells");
  if (reading_of(report)->polygons_split != 0) {
    text += "; " + counted(reading_of(report)->polygons_split, "polygon", "polygons") +
            " cut into triangles";
  }
  return detail_line("mesh", text);
}

std::string volume_text(const Rational& volume) {
  const std::string exact = volume.to_string(), decimal = short_decimal(volume, 12);
  return detail_line("volume",
                     exact == decimal ? exact : cut(exact, kExactSize) + ", about " + decimal);
}

std::string shells_text(const ValidityReport& decision) {
  if (!decision.nesting_decided || decision.shells.size() < 2) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(decision.shells.size(), internal::kMostShown); ++i) {
    const ShellReport& s = decision.shells[i];
    text += detail_line("shell " + std::to_string(i),
                        std::string(*s.outward ? "outward" : "inward") + ", depth " +
                            std::to_string(*s.depth) + ", genus " + std::to_string(*s.genus) +
                            ", volume " + short_decimal(*s.volume));
  }
  if (decision.shells.size() > internal::kMostShown) {
    text += detail_line("...", std::to_string(decision.shells.size() - internal::kMostShown) +
                                   " more shells (--json lists them)");
  }
  return text;
}

std::string place_text(const Finding& d) {
  std::string decimal, exact;
  bool differs = false;  // 1/3 and 0.333333; 1/2 and 0.5, too
  for (const Rational& c : d.witness.point->at) {
    const std::string fraction = c.to_string();
    const std::string shown = short_decimal(c);
    differs = differs || fraction != shown;
    decimal += (decimal.empty() ? "" : ", ") + shown;
    exact += (exact.empty() ? "" : ", ") + cut(fraction, kExactSize);
  }
  std::string text = "at (" + exact + ")";
  if (differs) text += ", about (" + decimal + ")";
  if (d.place.size > 0) text += ", size " + short_decimal(d.place.size);
  return text;
}

std::string defect_text(const Finding& d) {
  constexpr std::size_t kMost = 4;
  const std::vector<std::uint32_t>& polygons = d.place.polygons;
  std::string text = "    " + harmless(d.message) + "\n";
  text += "      " + place_text(d);
  for (std::size_t i = 0; i < std::min(kMost, polygons.size()); ++i) {
    text += (i == 0 ? "; polygons " : ", ") + std::to_string(polygons[i]);
  }
  text += polygons.size() > kMost ? ", ...\n" : "\n";
  return text;
}

// The largest places first.
std::string places_text(const ValidityReport& decision) {
  std::vector<ImproperPlace> places = decision.places;
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.pairs > b.pairs; });
  std::string out;
  for (std::size_t i = 0; i < std::min(places.size(), internal::kMostShown); ++i) {
    const Box3d& box = places[i].box;
    out += "    " + counted(places[i].pairs, "pair", "pairs") + " of " +
           counted(places[i].faces, "face", "faces") + " in the box " + point_text(box.lo) +
           " to " + point_text(box.hi) + "\n";
  }
  if (places.size() > internal::kMostShown)
    out += "    ... " + std::to_string(places.size() - internal::kMostShown) +
           " more places (--json lists them)\n";
  return out;
}

std::string listed_text(const FileReport& report, MeshRule rule, std::uint64_t count) {
  std::string out;
  std::uint64_t listed = 0;
  for (const Finding& d : report.defects) {
    if (rule_of(d) != rule) continue;
    ++listed;
    out += defect_text(d);
  }
  return listed < count ? out + "    ... " + std::to_string(count - listed) + " more\n" : out;
}

std::string rule_section(const FileReport& report, MeshRule rule, const TextOptions& options) {
  const RuleText& text = rule_text(rule);
  const ValidityReport& decision = *decision_of(report);
  const std::uint64_t count = decision.rule_counts[rule_index(rule)];
  const bool is_in_places = rule == MeshRule::kM7;
  std::string out = "  " + options.style.bold(std::string(text.id) + " " + std::string(text.name)) +
                    ": " + std::to_string(count) + (is_in_places ? in_places(decision) : "") + "\n";
  if (is_in_places) out += places_text(decision);
  if (!is_in_places || options.lists_pairs) out += listed_text(report, rule, count);
  return out;
}

std::string invalid_text(const FileReport& report, const TextOptions& options) {
  std::string out, first;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    if (decision_of(report)->rule_counts[i] == 0) continue;
    out += rule_section(report, rule_at(i), options);
    if (first.empty()) first = rule_text(rule_at(i)).id;
  }
  if (!decision_of(report)->nesting_decided) {
    out += options.style.dim("  M8 and M9 (which side is inside) are decided once M1 to M7 hold.") +
           "\n";
  }
  return out +
         options.style.dim("  What it means and what helps: veritope explain " + first +
                           ".  More defects: --max-defects N; for programs, with --json F.") +
         "\n";
}

}  // namespace

namespace internal {

std::string ignored_text(const ReadReport& reading) {
  std::string text;
  for (const auto& [what, count] : reading.ignored) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + harmless(what);
  }
  return text.empty() ? text : detail_line("ignored", text);
}

std::string notices_text(const ReadReport& reading) {
  std::string text;
  for (const ReadNotice& n : reading.notices) text += detail_line("notice", harmless(n.message));
  return text;
}

std::string file_text(const ReadReport& reading) {
  std::string text = reading.variant + ", " + counted(reading.bytes, "byte", "bytes");
  if (reading.as_indexed) text += ", as indexed";
  return detail_line("file", text);
}

std::string vertices_text(const ReadReport& r) {
  std::string text = counted(r.file_vertices, "vertex", "vertices");
  if (r.distinct_vertices != r.file_vertices) {
    text += " (" + std::to_string(r.distinct_vertices) + " distinct)";
  }
  if (r.unreferenced_vertices != 0) {
    text += " (" + std::to_string(r.unreferenced_vertices) + " unreferenced)";
  }
  return text;
}

std::string box_text(const Box3d& box) {
  return detail_line("box", point_text(box.lo) + " to " + point_text(box.hi));
}

std::string mesh_summary(const FileReport& report) {
  return report.verdict == Verdict::kValid ? valid_summary(report) : invalid_summary(report);
}

std::string mesh_details(const FileReport& report, const TextOptions&) {
  const ValidityReport* const d = decision_of(report);
  if (d == nullptr) return "";
  std::string out = file_text(*reading_of(report));
  out += counts_text(report);
  out += ignored_text(*reading_of(report));
  out += notices_text(*reading_of(report));
  out += box_text(d->box);
  if (d->volume && d->is_valid) out += volume_text(*d->volume);
  return out + shells_text(*d);
}

std::string mesh_last_details(const FileReport& report, const TextOptions& options) {
  return report.verdict == Verdict::kInvalid ? invalid_text(report, options) : "";
}

}  // namespace internal
}  // namespace veritope::report
