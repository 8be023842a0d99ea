// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/report_text.h: a report of decide_validity as exact text, to compare reports with each other and with
// golden ones.
#pragma once
#include <cstdio>
#include <string>

#include "solids/polyhedron/validity.h"

namespace veritope {

/// A report with its list of defects.
struct ListedReport : ValidityReport {
  std::vector<Finding> defects;
};
inline ListedReport decide_and_list(const TriangleMesh& mesh, const ValidityOptions& options) {
  ListedReport out{decide_validity(mesh, options), {}};
  out.defects = list_defects(mesh, out, options.jobs).defects;
  return out;
}

inline std::string spelled(const std::optional<Rational>& r) { return r ? r->to_string() : "unknown"; }

/// Counts, shells, volumes, depths and verdict in one line.
inline std::string summary(const ValidityReport& r) {
  std::string out = r.is_valid ? "valid" : "invalid";
  for (std::uint64_t n : r.rule_counts) out += " " + std::to_string(n);
  const MeshCounts& c = r.counts;
  out += " F" + std::to_string(c.faces) + " V" + std::to_string(c.referenced_vertices) + " E" + std::to_string(c.edges) + " euler " +
         std::to_string(c.euler) + " bodies " + (c.bodies ? std::to_string(*c.bodies) : "unknown") + " genus " +
         (c.genus ? std::to_string(*c.genus) : "unknown") + " volume " + spelled(r.volume) + " shells";
  for (const ShellReport& s : r.shells)
    out += " (" + std::to_string(s.first_face) + ", " + std::to_string(s.euler) + ", " + (s.genus ? std::to_string(*s.genus) : "unknown") + ", " +
           spelled(s.volume) + ", " + (s.depth ? std::to_string(*s.depth) : "unknown") + ", " + (s.outward ? (*s.outward ? "out" : "in") : "unknown") + ")";
  return out;
}

/// The summary, every listed defect, and everything that the certificate is made from.
inline std::string full_text(const ListedReport& r) {
  std::string out = summary(r) + (r.long_thin ? "\nlong thin" : "\nordinary") + "\nbox";
  const auto number = [](double v) {
    char text[64];
    std::snprintf(text, sizeof text, " %a", v);
    return std::string(text);
  };
  for (const Point3d& p : {r.box.lo, r.box.hi})
    for (const double c : p) out += number(c);
  for (const Finding& d : r.defects) {
    out += "\n" + d.code + " faces";
    for (std::uint32_t f : d.place.faces) out += " " + std::to_string(f);
    out += " edges";
    for (const auto& [a, b] : d.place.edges) out += " " + std::to_string(a) + "-" + std::to_string(b);
    out += " vertices";
    for (std::uint32_t v : d.place.vertices) out += " " + std::to_string(v);
    out += " at";
    for (const Rational& c : d.witness.point->at) out += " " + c.to_string();
    if (d.witness.ends)
      for (const RationalPoint& end : *d.witness.ends)
        for (const Rational& c : end.at) out += " " + c.to_string();
    out += " size" + number(d.place.size);
    if (d.place.near_edge)
      out += " near " + std::to_string(d.place.near_edge->first) + "-" + std::to_string(d.place.near_edge->second) + " " +
             d.witness.squared_gap->to_string() + number(*d.witness.approx_distance);
    out += " " + d.message;
  }
  out += "\nstars";
  for (std::uint8_t c : r.stars.code) out += " " + std::to_string(c);
  for (const auto& [v, d] : r.stars.own)
    out += " (" + std::to_string(v) + ": " + std::to_string(d[0]) + " " + std::to_string(d[1]) + " " + std::to_string(d[2]) + ")";
  out += "\nrays";
  for (std::uint8_t c : r.nesting.axis_code) out += " " + std::to_string(c);
  return out + "\n";
}

}  // namespace veritope
