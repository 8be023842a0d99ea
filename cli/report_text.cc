// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/report_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/bounding_box.h"
#include "cli/decimal_text.h"

namespace veritope::cli {
namespace {

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
constexpr std::size_t kMostShells = 8;

std::string shown_path(const std::string& path) {
  return path == "-" ? "standard input" : harmless(path);
}

std::string point_text(const Vec3d& p) {
  return "(" + short_decimal(p.x) + ", " + short_decimal(p.y) + ", " + short_decimal(p.z) + ")";
}

std::string valid_summary(const FileReport& report) {
  const MeshCounts& c = report.decision->counts;
  std::string text = counted(c.bodies.value_or(0), "body", "bodies");
  if (c.genus) text += ", genus " + std::to_string(*c.genus);
  if (report.decision->volume) text += ", volume " + short_decimal(*report.decision->volume);
  return text;
}

std::string invalid_summary(const FileReport& report) {
  constexpr int kMost = 3;
  std::string text;
  int shown = 0;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const std::uint64_t count = report.decision->rule_counts[i];
    if (count == 0) continue;
    if (++shown > kMost) return text + ", ...";
    text += (shown == 1 ? "" : ", ") + counted(count, kNouns[i].one, kNouns[i].many);
  }
  return text;
}

std::string summary(const FileReport& report) {
  const bool is_verdict =
      report.verdict == FileVerdict::kValid || report.verdict == FileVerdict::kInvalid;
  if (!is_verdict) return report.fault ? harmless(fault_text(*report.fault)) : "";
  const std::string what = report.patches                              ? patch_summary(*report.patches)
                           : report.verdict == FileVerdict::kValid ? valid_summary(report)
                                                                   : invalid_summary(report);
  const bool is_checked = report.certificate && report.certificate->is_checked;
  return what + (is_checked ? " (checked)" : " (not checked)");
}

std::string coloured_verdict(FileVerdict verdict, const Style& style) {
  const std::string name = verdict_name(verdict);
  if (verdict == FileVerdict::kValid) return style.green(name);
  return verdict == FileVerdict::kInvalid ? style.red(name) : style.yellow(name);
}

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

std::string file_text(const ReadReport& reading, bool as_indexed) {
  std::string text = reading.variant + ", " + counted(reading.bytes, "byte", "bytes");
  if (as_indexed) text += ", as indexed";
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

std::string counts_text(const FileReport& report) {
  const MeshCounts& c = report.decision->counts;
  std::string text = counted(c.faces, "face", "faces") + ", " + vertices_text(*report.reading) +
                     ", " + counted(c.edges, "edge", "edges") + ", " +
                     counted(c.shells, "shell", "shells");
  if (report.reading->polygons_split != 0) {
    text += "; " + counted(report.reading->polygons_split, "polygon", "polygons") +
            " cut into triangles";
  }
  return detail_line("mesh", text);
}

std::string volume_text(const Rational& volume) {
  const std::string exact = volume.to_string(), decimal = short_decimal(volume, 12);
  return detail_line("volume", exact == decimal ? exact : cut(exact, kExactSize) + ", about " + decimal);
}

std::string shells_text(const ValidityReport& decision) {
  if (!decision.nesting_decided || decision.shells.size() < 2) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(decision.shells.size(), kMostShells); ++i) {
    const ShellReport& s = decision.shells[i];
    text += detail_line("shell " + std::to_string(i), std::string(*s.outward ? "outward" : "inward") +
                                                   ", depth " + std::to_string(*s.depth) +
                                                   ", genus " + std::to_string(*s.genus) +
                                                   ", volume " + short_decimal(*s.volume));
  }
  if (decision.shells.size() > kMostShells) {
    text += detail_line("...", std::to_string(decision.shells.size() - kMostShells) +
                            " more shells (--json lists them)");
  }
  return text;
}

std::string place_text(const Defect& d) {
  std::string decimal, exact;
  bool differs = false;  // 1/3 and 0.333333; 1/2 and 0.5, too
  for (const Rational& c : d.point.at) {
    const std::string fraction = c.to_string();
    const std::string shown = short_decimal(c);
    differs = differs || fraction != shown;
    decimal += (decimal.empty() ? "" : ", ") + shown;
    exact += (exact.empty() ? "" : ", ") + cut(fraction, kExactSize);
  }
  std::string text = "at (" + exact + ")";
  if (differs) text += ", about (" + decimal + ")";
  if (d.size > 0) text += ", size " + short_decimal(d.size);
  return text;
}

std::string defect_text(const ListedDefect& listed) {
  constexpr std::size_t kMost = 4;
  std::string text = "    " + harmless(listed.defect.message) + "\n";
  text += "      " + place_text(listed.defect);
  for (std::size_t i = 0; i < std::min(kMost, listed.polygons.size()); ++i) {
    text += (i == 0 ? "; polygons " : ", ") + std::to_string(listed.polygons[i]);
  }
  text += listed.polygons.size() > kMost ? ", ...\n" : "\n";
  return text;
}

std::string rule_section(const FileReport& report, MeshRule rule, const Style& style) {
  const RuleText& text = rule_text(rule);
  const std::uint64_t count = report.decision->rule_counts[rule_index(rule)];
  std::string out = "  " + style.bold(std::string(text.id) + " " + std::string(text.name)) + ": " +
                    std::to_string(count) + "\n";
  std::uint64_t listed = 0;
  for (const ListedDefect& d : report.defects) {
    if (d.defect.rule != rule) continue;
    ++listed;
    out += defect_text(d);
  }
  if (listed < count) out += "    ... " + std::to_string(count - listed) + " more\n";
  return out;
}

std::string invalid_text(const FileReport& report, const Style& style) {
  std::string out, first;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    if (report.decision->rule_counts[i] == 0) continue;
    out += rule_section(report, rule_at(i), style);
    if (first.empty()) first = rule_text(rule_at(i)).id;
  }
  if (!report.decision->nesting_decided) {
    out += style.dim("  M8 and M9 (which side is inside) are decided once M1 to M7 hold.") + "\n";
  }
  return out +
         style.dim("  What it means and what helps: veritope explain " + first +
                   ".  More defects: --max-defects N; for programs, with --json F.") +
         "\n";
}

std::string certificate_text(const FileReport& report) {
  if (!report.certificate) return "";
  const CertificateReport& c = *report.certificate;
  std::string text = c.path ? harmless(*c.path) : "not kept (--certificate F keeps it)";
  text += ", " + counted(c.bytes, "byte", "bytes");
  text += c.is_checked ? ", accepted by veritope-check" : ", not checked (--no-check)";
  return detail_line("certificate", text);
}

}  // namespace

std::string verdict_line(const FileReport& report, const Style& style) {
  return coloured_verdict(report.verdict, style) + "  " + shown_path(report.path) + "  " +
         summary(report) + "\n";
}

std::string details_text(const FileReport& report, const Style& style) {
  if (report.patches) return patch_details(report) + certificate_text(report);
  const bool is_verdict =
      report.verdict == FileVerdict::kValid || report.verdict == FileVerdict::kInvalid;
  if (!is_verdict || !report.decision) return "";
  const ValidityReport& d = *report.decision;
  std::string out = file_text(*report.reading, report.as_indexed);
  out += counts_text(report);
  out += ignored_text(*report.reading);
  out += notices_text(*report.reading);
  out += detail_line("box", point_text(d.box_lo) + " to " + point_text(d.box_hi));
  if (d.volume && report.verdict == FileVerdict::kValid) out += volume_text(*d.volume);
  out += shells_text(d);
  out += certificate_text(report);
  if (report.verdict == FileVerdict::kInvalid) out += invalid_text(report, style);
  return out;
}

std::string info_text(const InfoReport& report, const Style& style) {
  const std::string path = style.bold(shown_path(report.path));
  if (!report.file) {
    return style.yellow(verdict_name(FileVerdict::kUnreadable)) + "  " + path + "  " +
           (report.fault ? harmless(fault_text(*report.fault)) : "") + "\n";
  }
  const ReadReport& r = report.file->report;
  const Box box = bounding_box(report.file->mesh);
  std::string out = path + "\n" + file_text(r, report.as_indexed);
  out += detail_line("sha256", report.file->sha256);
  out += detail_line("mesh",
              counted(report.file->mesh.faces.size(), "face", "faces") + ", " + vertices_text(r));
  if (r.polygons_split != 0) {
    out += detail_line("polygons", std::to_string(r.polygons_split) + " cut into triangles");
  }
  if (r.strip_joints != 0)
    out += detail_line("strips", std::to_string(r.strip_joints) + " joints dropped");
  out += ignored_text(r);
  out += notices_text(r);
  out += detail_line("box", point_text(box.lo) + " to " + point_text(box.hi));
  std::string names;
  for (const std::string& name : report.lossless) names += (names.empty() ? "" : ", ") + name;
  out += detail_line("lossless as", report.holds_everywhere ? "every format" : names);
  return out + style.dim("  Whether it bounds a solid: veritope certify FILE") + "\n";
}

}  // namespace veritope::cli
