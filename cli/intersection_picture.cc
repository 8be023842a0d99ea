// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/intersection_picture.h"

#include <cstdio>

#include "interval/numeric.h"
#include "interval/upward.h"

namespace veritope::cli {

using namespace report;
namespace {

/// A point of a cubic, in doubles.
Point4 cubic_at(const std::array<Point4, 4>& c, double t) {
  const double s = 1 - t;
  Point4 out{};
  for (std::size_t i = 0; i < 4; ++i)
    out[i] = s * s * (s * c[0][i] + 3 * t * c[1][i]) + t * t * (3 * s * c[2][i] + t * c[3][i]);
  return out;
}

struct Polygon {
  std::vector<std::array<double, 3>> points;
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
