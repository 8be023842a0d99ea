// SPDX-License-Identifier: LGPL-3.0-or-later
// What reports say about meshes, for people.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "report/decimal_text.h"
#include "report/mesh_report_internal.h"

namespace veritope::report {
namespace {

using internal::decision_of;
using internal::reading_of;
using internal::reversal_of;

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

// Rules in the order in which repairs make sense: docs/rules/README.md.
constexpr std::array<MeshRule, kNumMeshRules> kRepairOrder = {
    MeshRule::kM1, MeshRule::kM2, MeshRule::kM4, MeshRule::kM6, MeshRule::kM3,
    MeshRule::kM5, MeshRule::kM7, MeshRule::kM8, MeshRule::kM9};

std::string valid_summary(const FileReport& report) {
  const MeshCounts& c = decision_of(report)->counts;
  std::string text = counted(c.bodies.value_or(0), "body", "bodies");
  if (c.genus) text += ", genus " + std::to_string(*c.genus);
  if (decision_of(report)->volume)
    text += ", volume " + short_decimal(*decision_of(report)->volume);
  if (const Reversal* const reversal = reversal_of(report)) {
    const std::string what = reversal->mixed_shells != 0
                                 ? counted(reversal->faces, "face is", "faces are")
                                 : counted(reversal->whole_shells, "shell is", "shells are");
    text += ", once " + what + " reversed";
  }
  return text;
}

std::string in_places(const ValidityReport& decision) {
  return " in " + counted(decision.places.size(), "place", "places");
}

std::string invalid_summary(const FileReport& report) {
  std::string text;
  for (const MeshRule rule : kRepairOrder) {
    const std::uint64_t count = decision_of(report)->rule_counts[rule_index(rule)];
    if (count == 0) continue;
    const Noun& noun = kNouns[rule_index(rule)];
    text += (text.empty() ? "" : ", ") + counted(count, noun.one, noun.many);
    if (rule == MeshRule::kM7) text += in_places(*decision_of(report));
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

// Characters of an exact value that is printed beside its decimal; longer ones are in the JSON.
constexpr std::size_t kExactSize = 28;

std::string volume_text(const Rational& volume) {
  std::string text = short_decimal(volume, 12);
  if (is_short_decimal(volume, 12)) return detail_line("volume", text);
  const std::string exact = volume.to_string();
  return detail_line("volume",
                     "about " + text + (exact.size() <= kExactSize ? ", exactly " + exact : ""));
}

// "2 shells of 3 were inside out, and faces of 1 shell disagreed; 25 faces are taken reversed"
std::string reversed_text(const Reversal& r) {
  std::string text;
  if (r.whole_shells != 0)
    text = counted(r.whole_shells, "shell", "shells") + " of " + std::to_string(r.shells.size()) +
           (r.whole_shells == 1 ? " was" : " were") + " inside out";
  if (r.mixed_shells != 0)
    text += (text.empty() ? "" : ", and ") +
            ("faces of " + counted(r.mixed_shells, "shell", "shells") + " disagreed");
  return detail_line("reversed",
                     text + "; " + counted(r.faces, "face is", "faces are") + " taken reversed");
}

// How much of a shell is reversed, if anything is.
std::string reversed_part(const Reversal* reversal, std::size_t shell) {
  if (reversal == nullptr || reversal->shells[shell].reversed == 0) return "";
  const auto& [faces, reversed] = reversal->shells[shell];
  return reversed == faces ? ", taken reversed"
                           : ", " + counted(reversed, "face", "faces") + " taken reversed";
}

std::string shells_text(const ValidityReport& decision, const Reversal* reversal) {
  if (!decision.nesting_decided || decision.shells.size() < 2) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(decision.shells.size(), internal::kMostShown); ++i) {
    const ShellReport& s = decision.shells[i];
    text += detail_line("shell " + std::to_string(i),
                        std::string(*s.outward ? "outward" : "inward") + ", depth " +
                            std::to_string(*s.depth) + ", genus " + std::to_string(*s.genus) +
                            ", volume " + short_decimal(*s.volume) + reversed_part(reversal, i));
  }
  if (decision.shells.size() > internal::kMostShown) {
    text += detail_line("...", std::to_string(decision.shells.size() - internal::kMostShown) +
                                   " more shells (--json lists them)");
  }
  return text;
}

std::string decimal_text(const RationalPoint& p) {
  return unbroken("(" + short_decimal(p.at[0]) + ", " + short_decimal(p.at[1]) + ", " +
                  short_decimal(p.at[2]) + ")");
}

// Nothing if the decimals are exact, or if the fractions are long.
std::string exact_text(const RationalPoint& p) {
  std::string text;
  bool is_exact = true;
  for (const Rational& c : p.at) {
    is_exact = is_exact && is_short_decimal(c);
    text += (text.empty() ? "" : ", ") + c.to_string();
  }
  return is_exact || text.size() > kExactSize ? "" : ", exactly (" + text + ")";
}

// "; 1.1e-16 from edge 1-8"
std::string near_text(const Finding& d) {
  if (!d.place.near_edge) return "";
  return "; " + short_decimal(*d.witness.approx_distance, 2) + " from edge " +
         std::to_string(d.place.near_edge->first) + "-" + std::to_string(d.place.near_edge->second);
}

std::string size_text(double size) {
  return std::isfinite(size) ? short_decimal(size) : "beyond binary64";
}

std::string place_text(const Finding& d) {
  const MeshRule rule = rule_of(d);
  const bool is_edge = rule == MeshRule::kM3 || rule == MeshRule::kM4 || rule == MeshRule::kM5;
  if (d.witness.ends)
    return "from " + decimal_text(d.witness.ends->at(0)) + " to " +
           decimal_text(d.witness.ends->at(1)) + ", length " + size_text(d.place.size) +
           near_text(d);
  std::string text = "at " + decimal_text(*d.witness.point) + exact_text(*d.witness.point);
  if (d.place.size > 0) text += (is_edge ? ", length " : ", size ") + size_text(d.place.size);
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
  return text + (polygons.size() > kMost ? " and more\n" : "\n");
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
           counted(places[i].faces, "face", "faces") + " in the box " + report::box_text(box) +
           "\n";
  }
  if (places.size() > internal::kMostShown)
    out += "    ... " + std::to_string(places.size() - internal::kMostShown) +
           " more places (--json lists them)\n";
  return out;
}

// "1.1e-16 to 3e-05"
std::string gaps_text(const OpenEdges& open) {
  const auto [least, greatest] = range_ends(open.least_gap, open.greatest_gap, 2);
  return least == greatest ? greatest : least + " to " + greatest;
}

// "; 4 edges lie within 1.1e-16 of another open edge: cracks", or what is known of them.
std::string cracks_text(const OpenEdges& open, std::uint64_t count) {
  if (open.near_edges == 0) return open.unsearched_edges == 0 ? ", no cracks" : ", no cracks found";
  const bool are_all = open.near_edges == count;
  const bool is_one = open.near_edges == 1;
  const std::string edges =
      are_all ? (is_one ? "it lies" : "each lies")
              : counted(open.near_edges, "edge", "edges") + (is_one ? " lies" : " lie");
  if (open.greatest_gap == 0) return "; " + edges + " on another open edge: cracks without a gap";
  return "; " + edges + " within " + gaps_text(open) + " of another open edge: cracks" +
         (open.touching_edges == 0
              ? ""
              : ", " + std::to_string(open.touching_edges) + " of these edges without a gap");
}

// " in 3 borders (2 without cracks); ..."
std::string open_text(const OpenEdges* open, std::uint64_t count) {
  if (open == nullptr) return "";
  std::string out = " in " + counted(open->borders, "border", "borders");
  if (open->near_edges != 0 && open->holes != 0)
    out += " (" + std::to_string(open->holes) + " without cracks)";
  out += cracks_text(*open, count);
  if (open->unsearched_edges != 0)
    out +=
        " (the search was given up for " + counted(open->unsearched_edges, "edge", "edges") + ")";
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
  std::string out =
      "  " + options.style.bold(std::string(text.id) + " " + std::string(text.name)) + ": " +
      std::to_string(count) + (is_in_places ? in_places(decision) : "") +
      (rule == MeshRule::kM3 ? open_text(internal::open_edges_of(report), count) : "") + "\n";
  if (is_in_places) out += places_text(decision);
  if (!is_in_places || options.lists_pairs) out += listed_text(report, rule, count);
  return out;
}

std::string invalid_text(const FileReport& report, const TextOptions& options) {
  const ValidityReport& decision = *decision_of(report);
  std::string out, first;
  for (const MeshRule rule : kRepairOrder) {
    if (decision.rule_counts[rule_index(rule)] == 0) continue;
    out += rule_section(report, rule, options);
    if (first.empty()) first = rule_text(rule).id;
  }
  if (!decision.nesting_decided)
    out += options.style.dim("  M8 and M9 (which side is inside) are decided once M1 to M7 hold.") +
           "\n";
  const std::string reversing =
      is_valid_once_reversed(decision)
          ? "veritope certify --orient auto FILE reverses faces, and the mesh is VALID; "
          : "";
  return out + detail_line("what helps", reversing + "veritope explain " + first +
                                             "; --picture F draws them, --max-defects N lists "
                                             "more, --json F has exact coordinates");
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

std::string box_text(const Box3d& box) { return detail_line("box", report::box_text(box)); }

std::string mesh_summary(const FileReport& report) {
  return report.verdict == Verdict::kValid ? valid_summary(report) : invalid_summary(report);
}

std::string mesh_findings(const FileReport& report, const TextOptions& options) {
  return report.verdict == Verdict::kInvalid ? invalid_text(report, options) : "";
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
  const Reversal* const reversal = reversal_of(report);
  if (reversal != nullptr) out += reversed_text(*reversal);
  return out + shells_text(*d, reversal);
}

}  // namespace internal
}  // namespace veritope::report
