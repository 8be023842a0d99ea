// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/reversal.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"
#include "topology/face_orientation.h"

namespace veritope {
namespace {

std::uint64_t count_of(const ValidityReport& report, MeshRule rule) {
  return report.rule_counts[rule_index(rule)];
}

void reverse_faces(const std::vector<bool>& which, TriangleMesh& mesh) {
  for (std::size_t f = 0; f < which.size(); ++f)
    if (which[f]) std::swap(mesh.faces[f][1], mesh.faces[f][2]);
}

// The shells that M8 and M9 count.
std::vector<bool> shells_inside_out(const ValidityReport& report) {
  VT_CHECK(report.nesting_decided, "closed surfaces that agree are not nested");
  std::vector<bool> out;
  for (const ShellReport& s : report.shells) out.push_back(*s.outward != (*s.depth % 2 == 0));
  return out;
}

// What the decision would say after whole shells are reversed: stars and nesting have no orientation.
void report_reversed(const std::vector<bool>& which, ValidityReport& report) {
  Rational sum;
  for (std::size_t s = 0; s < which.size(); ++s) {
    ShellReport& shell = report.shells[s];
    if (which[s]) {
      shell.volume = -*shell.volume;
      shell.outward = !*shell.outward;
    }
    sum += *shell.volume;
  }
  report.volume = std::move(sum);
  for (const MeshRule rule : {MeshRule::kM8, MeshRule::kM9})
    report.rule_counts[rule_index(rule)] = 0;
  report.evidence = {};
  report.is_valid = true;
}

Reversal summary_of(std::vector<bool> is_reversed, const FaceOrientation& orientation) {
  Reversal out;
  out.shells.resize(orientation.num_shells);
  for (std::size_t f = 0; f < is_reversed.size(); ++f) {
    Reversal::OfShell& shell = out.shells[orientation.shell_of_face[f]];
    ++shell.faces;
    shell.reversed += is_reversed[f];
  }
  for (const Reversal::OfShell& shell : out.shells) {
    out.faces += shell.reversed;
    const bool is_whole = shell.reversed == shell.faces;
    out.whole_shells += is_whole;
    out.mixed_shells += shell.reversed != 0 && !is_whole;
  }
  out.is_reversed = std::move(is_reversed);
  return out;
}

}  // namespace

bool is_valid_once_reversed(const ValidityReport& report) {
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const MeshRule rule = rule_at(i);
    const bool is_of_direction =
        rule == MeshRule::kM5 || rule == MeshRule::kM8 || rule == MeshRule::kM9;
    if (!is_of_direction && report.rule_counts[i] != 0) return false;
  }
  return !report.is_valid;
}

ReversedSolid reverse_to_solid(TriangleMesh mesh, ValidityReport report, unsigned jobs) {
  VT_CHECK(is_valid_once_reversed(report), "reversing faces does not make this mesh valid");
  const Incidence incidence = Incidence::build(
      mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), std::max(1u, jobs));
  std::optional<FaceOrientation> orientation = agreeing_orientation(mesh.faces, incidence);
  VT_CHECK(orientation.has_value(), "an embedded closed surface is one-sided");
  if (count_of(report, MeshRule::kM5) != 0) {
    reverse_faces(orientation->is_reversed, mesh);
    ValidityOptions options;
    options.jobs = jobs;
    options.max_defects = 0;
    report = decide_validity(mesh, options);
  }
  const std::vector<bool> turned = shells_inside_out(report);
  std::vector<bool> rest(mesh.faces.size()), all = orientation->is_reversed;
  for (std::size_t f = 0; f < rest.size(); ++f) {
    rest[f] = turned[orientation->shell_of_face[f]];
    all[f] = all[f] != rest[f];
  }
  reverse_faces(rest, mesh);
  report_reversed(turned, report);
  return {std::move(mesh), std::move(report), summary_of(std::move(all), *orientation)};
}

}  // namespace veritope
