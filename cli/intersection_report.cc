// SPDX-License-Identifier: LGPL-3.0-or-later
// Intersections as JSON, text and curves. The schema: docs/report.schema.json, intersection.
#include "cli/intersection_report.h"

#include <cstdio>

#include "interval/numeric.h"
#include "interval/upward.h"
#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "robust/base/box3d.h"
#include "verify/certify/certify.h"

namespace veritope::cli {

using namespace report;
namespace {

Json interval_json(const Interval& a) {
  return Json::array({number_json(a.lo()), number_json(a.hi())});
}
template <std::size_t N>
Json box_json(const Box<N>& box) {
  Json out = Json::array();
  for (const Interval& side : box) out.push_back(interval_json(side));
  return out;
}
Json surface_json(const NamedSurface& s) {
  return {{"entity", s.entity}, {"face", optional_json(s.face)}, {"trimmed", s.is_trimmed}};
}

Json branch_json(const IntersectionBranch& b) {
  Json boxes = Json::array();
  for (const CurveSegment& s : b.segments)
    boxes.push_back({{"parameters", box_json(s.parameters)}, {"space", box_json(s.space)}});
  return {{"closed", b.is_closed},     {"partial", b.is_partial},
          {"num_boxes", b.num_boxes},  {"length", interval_json(b.length)},
          {"gap", number_json(b.gap)}, {"boxes", boxes}};
}

const char* shape_name(IntersectionContact::Shape shape) {
  switch (shape) {
    case IntersectionContact::Shape::kElliptic: return "elliptic";
    case IntersectionContact::Shape::kHyperbolic: return "hyperbolic";
    case IntersectionContact::Shape::kUnknown: return "unknown";
  }
  return "unknown";
}

Json contact_json(const IntersectionContact& c, const SurfaceIntersection& in) {
  Json out = {{"parameters", box_json(c.parameters)},
              {"space", box_json(c.space)},
              {"num_boxes", c.num_boxes}};
  if (c.kind == IntersectionContact::Kind::kTangency) {
    out["shape"] = shape_name(c.shape);
    out["separation"] = interval_json(c.separation);
  }
  if (c.kind == IntersectionContact::Kind::kUnresolved) {
    out["reason"] = c.reason;
    out["spent"] = {{"pairs", in.pairs}, {"proofs", in.proofs}};
  }
  return out;
}

/// The elements of one list of all pairs, each with its surfaces.
template <typename List, typename ToJson>
Json all_of(const IntersectionReport& report, List list, ToJson to_json) {
  Json out = Json::array();
  for (const PairIntersection& p : report.pairs)
    for (const auto& element : list(p.found)) {
      Json one = {{"first", surface_json(p.first)}, {"second", surface_json(p.second)}};
      one.update(to_json(element, p.found));
      out.push_back(one);
    }
  return out;
}

Json head_json(const IntersectionReport& report, const char* schema) {
  Json files = Json::array();
  for (std::size_t k = 0; k < 2; ++k)
    files.push_back({{"path", report.paths[k]}, {"sha256", report.sha256[k]}});
  return {{"schema", schema}, {"tool", tool_name()}, {"files", files}};
}

std::string range_text(const Interval& a) {
  return short_decimal(a.lo(), 9) + (a.lo() == a.hi() ? "" : " to " + short_decimal(a.hi(), 9));
}
std::string place_text(const Box3& box) {
  return "(" + range_text(box[0]) + ", " + range_text(box[1]) + ", " + range_text(box[2]) + ")";
}
std::string name_text(const NamedSurface& s) {
  return std::to_string(s.entity) + (s.face ? " face " + std::to_string(*s.face) : "");
}

std::string lines_of(const PairIntersection& p) {
  std::string out = "  surfaces " + name_text(p.first) + " and " + name_text(p.second) + "\n";
  for (const IntersectionBranch& b : p.found.branches)
    out += std::string("    ") +
           (b.is_partial ? "piece of a branch" : (b.is_closed ? "loop" : "arc")) + "  length " +
           range_text(b.length) + "  gap at most " + short_decimal(b.gap, 3) + "  " +
           std::to_string(b.num_boxes) + " boxes\n";
  for (const IntersectionContact& c : p.found.overlaps)
    out += "    overlap  in " + place_text(c.space) + "\n";
  for (const IntersectionContact& c : p.found.tangencies)
    out += std::string("    tangency, ") + shape_name(c.shape) + "  separation " +
           range_text(c.separation) + "  in " + place_text(c.space) + "\n";
  for (const IntersectionContact& c : p.found.unresolved)
    out += "    undecided: " + c.reason + "  in " + place_text(c.space) + "\n";
  return out;
}

/// A point of a cubic, in doubles.
Point4 cubic_at(const std::array<Point4, 4>& c, double t) {
  const double s = 1 - t;
  Point4 out{};
  for (std::size_t i = 0; i < 4; ++i)
    out[i] = s * s * (s * c[0][i] + 3 * t * c[1][i]) + t * t * (3 * s * c[2][i] + t * c[3][i]);
  return out;
}

struct Polygon {
  std::vector<Point3d> points;
  bool is_closed = false;
  double gap = 0;
};
std::vector<Polygon> polygons_of(const IntersectionReport& report) {
  constexpr int kPieces = 8;
  std::vector<Polygon> out;
  const ScopedUpward upward;
  for (const PairIntersection& p : report.pairs) {
    const auto s1 = EnclosedSurface::make(*p.first.surface);
    for (const IntersectionBranch& b : p.found.branches) {
      Polygon& polygon = out.emplace_back();
      polygon.is_closed = b.is_closed, polygon.gap = b.gap;
      const auto add = [&](const std::array<Point4, 4>& control, double t) {
        const Point4 x = cubic_at(control, t);
        const Box3 at = s1->point(x[0], x[1]);
        polygon.points.push_back({mid(at[0]), mid(at[1]), mid(at[2])});
      };
      for (const CurveSegment& s : b.segments)
        for (int k = 0; k < kPieces; ++k) add(s.control, static_cast<double>(k) / kPieces);
      add(b.segments.back().control, 1);
    }
  }
  return out;
}

std::string number_text(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", v);
  return text;
}

}  // namespace

std::vector<NamedSurface> surfaces_of(const SplineModel& model) {
  std::vector<NamedSurface> out;
  for (std::size_t e = 0; e < model.entities.size(); ++e) {
    const auto& shape = model.entities[e].shape;
    if (const auto* s = std::get_if<ExactSurface>(&shape)) out.push_back({e, {}, s, false});
    if (const auto* t = std::get_if<TrimmedSurface>(&shape))
      out.push_back({e, {}, &t->surface, !t->loops.empty()});
    if (const auto* m = std::get_if<SplineBrep>(&shape))
      for (std::size_t f = 0; f < m->faces.size(); ++f)
        out.push_back({e, f, &m->faces[f].surface, !m->faces[f].loops.empty()});
  }
  return out;
}

bool IntersectionReport::is_complete() const {
  for (const PairIntersection& p : pairs)
    if (!p.found.is_complete()) return false;
  return true;
}

std::string intersection_json(const IntersectionReport& report) {
  Json out = head_json(report, "veritope-intersect-1");
  const auto contact = [](const IntersectionContact& c, const SurfaceIntersection& in) {
    return contact_json(c, in);
  };
  out["branches"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.branches; },
      [](const IntersectionBranch& b, const SurfaceIntersection&) { return branch_json(b); });
  out["overlaps"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.overlaps; }, contact);
  out["tangencies"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.tangencies; }, contact);
  out["unresolved"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.unresolved; }, contact);
  out["pairs_of_surfaces"] = report.num_pairs;
  out["trimming_ignored"] = report.ignores_trimming;
  out["triangles_ignored"] = report.ignored_triangles;
  out["complete"] = report.is_complete();
  return dump(out) + "\n";
}

std::string intersection_text(const IntersectionReport& report) {
  std::size_t loops = 0, arcs = 0, others = 0;
  for (const PairIntersection& p : report.pairs) {
    for (const IntersectionBranch& b : p.found.branches) ++(b.is_closed ? loops : arcs);
    others += p.found.overlaps.size() + p.found.tangencies.size();
  }
  std::string out = std::string(report.is_complete() ? "COMPLETE" : "UNDECIDED") + "  " +
                    harmless(report.paths[0]) + " and " + harmless(report.paths[1]) + "  " +
                    std::to_string(loops) + " loops, " + std::to_string(arcs) + " arcs, " +
                    std::to_string(others) + " tangencies and overlaps\n";
  if (report.ignores_trimming)
    out += "  Trimming curves were not looked at: these are the whole surfaces.\n";
  if (report.ignored_triangles != 0)
    out += "  Not looked at: " +
           counted(report.ignored_triangles, "Bezier triangle", "Bezier triangles") + ".\n";
  for (const PairIntersection& p : report.pairs) out += lines_of(p);
  return out;
}

std::string curves_json(const IntersectionReport& report) {
  Json out = head_json(report, "veritope-curves-1");
  out["curves"] = all_of(
      report, [](const SurfaceIntersection& s) { return s.branches; },
      [](const IntersectionBranch& b, const SurfaceIntersection&) {
        Json segments = Json::array();
        for (const CurveSegment& s : b.segments) {
          Json points = Json::array();
          for (const Point4& p : s.control) points.push_back(Json(p));
          segments.push_back({{"control", points}, {"gap", number_json(s.gap)}});
        }
        return Json{{"closed", b.is_closed}, {"partial", b.is_partial}, {"segments", segments}};
      });
  return dump(out) + "\n";
}

std::string curves_vtu(const IntersectionReport& report) {
  const std::vector<Polygon> polygons = polygons_of(report);
  std::string points, connectivity, offsets, types, closed, gaps;
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    for (const auto& p : polygon.points) {
      points += number_text(p[0]) + " " + number_text(p[1]) + " " + number_text(p[2]) + "\n";
      connectivity += std::to_string(count++) + " ";
    }
    connectivity += "\n";
    offsets += std::to_string(count) + " ", types += "4 ";  // VTK_POLY_LINE
    closed += polygon.is_closed ? "1 " : "0 ", gaps += number_text(polygon.gap) + " ";
  }
  const auto array = [](const std::string& type, const std::string& name, const std::string& data) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">\n" + data +
           "\n</DataArray>\n";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
         std::to_string(count) + "\" NumberOfCells=\"" + std::to_string(polygons.size()) +
         "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n" +
         points + "</DataArray>\n</Points>\n<Cells>\n" +
         array("Int64", "connectivity", connectivity) + array("Int64", "offsets", offsets) +
         array("UInt8", "types", types) + "</Cells>\n<CellData>\n" +
         array("UInt8", "closed", closed) + array("Float64", "gap", gaps) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace veritope::cli
