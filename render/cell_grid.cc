// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/cell_grid.h"

#include "render/spline_view_internal.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr int kTriangle = 5, kHexahedron = 12;  // VTK_TRIANGLE, VTK_HEXAHEDRON

// Corner i of a box; the bits of i select ends along x, y, z.
Point3d corner(const Box3d& box, unsigned bits) {
  Point3d out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = (bits >> k & 1) != 0 ? box.hi[k] : box.lo[k];
  return out;
}

void open_array(std::string& out, const char* type, const std::string& name, int components) {
  out += std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n";
}
constexpr const char* kCloseArray = "</DataArray>\n";

// VTK writes texts as numbers of their bytes, each text with a 0 at its end.
void append_texts(std::string& out, const CellGrid& grid) {
  const auto& [name, texts] = grid.texts;
  if (texts.empty()) return;
  out += "<FieldData>\n<DataArray type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" +
         std::to_string(texts.size()) + "\" format=\"ascii\">\n";
  for (const std::string& text : texts) {
    for (const char c : text) out += std::to_string(static_cast<unsigned char>(c)) + ' ';
    out += "0\n";
  }
  out += std::string(kCloseArray) + "</FieldData>\n";
}

void append_colours(std::string& out, const CellGrid& grid) {
  if (grid.colours.empty()) return;
  VT_CHECK(grid.colours.size() == grid.num_cells(), "one colour for each cell");
  open_array(out, "UInt8", "colour", 4);
  for (const auto& [red, green, blue, opacity] : grid.colours)
    out += std::to_string(red) + ' ' + std::to_string(green) + ' ' + std::to_string(blue) + ' ' +
           std::to_string(opacity) + '\n';
  out += kCloseArray;
}

void append_cells(std::string& out, const CellGrid& grid) {
  const std::size_t n = grid.corners_per_cell();
  out += "<Cells>\n";
  open_array(out, "Int64", "connectivity", 1);
  for (std::size_t i = 0; i < grid.corners.size(); ++i)
    out += std::to_string(grid.corners[i]) + ((i + 1) % n == 0 ? '\n' : ' ');
  out += kCloseArray;
  open_array(out, "Int64", "offsets", 1);
  for (std::size_t i = 1; i <= grid.num_cells(); ++i) out += std::to_string(n * i) + '\n';
  out += kCloseArray;
  open_array(out, "UInt8", "types", 1);
  const int type = grid.kind == CellGrid::Kind::kHexahedra ? kHexahedron : kTriangle;
  for (std::size_t i = 0; i < grid.num_cells(); ++i) out += std::to_string(type) + '\n';
  out += std::string(kCloseArray) + "</Cells>\n";
}

}  // namespace

void CellGrid::add_box(const Box3d& box) {
  VT_CHECK(kind == Kind::kHexahedra, "a grid has cells of one kind");
  for (const unsigned bits : {0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u}) {
    corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(corner(box, bits));
  }
}

CellGrid triangle_grid(const TriangleMesh& mesh) {
  CellGrid out;
  out.kind = CellGrid::Kind::kTriangles;
  for (const Vec3d& p : mesh.positions) out.points.push_back({p.x, p.y, p.z});
  for (const auto& f : mesh.faces) out.corners.insert(out.corners.end(), f.begin(), f.end());
  return out;
}

TriangleMesh box_mesh(const std::vector<Box3d>& boxes) {
  constexpr std::uint32_t kFaces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                           {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                           {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  TriangleMesh out;
  for (const Box3d& box : boxes) {
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (unsigned bits = 0; bits < 8; ++bits) {
      const auto p = corner(box, bits);
      out.positions.push_back({p[0], p[1], p[2]});
    }
    for (const auto& f : kFaces) out.faces.push_back({first + f[0], first + f[1], first + f[2]});
  }
  return out;
}

std::string vtu_bytes(const CellGrid& grid) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  append_texts(out, grid);
  out += "<Piece NumberOfPoints=\"" + std::to_string(grid.points.size()) + "\" NumberOfCells=\"" +
         std::to_string(grid.num_cells()) + "\">\n<CellData" +
         (grid.colours.empty() ? "" : " Scalars=\"colour\"") + ">\n";
  append_colours(out, grid);
  for (const auto& [name, values] : grid.values) {
    VT_CHECK(values.size() == grid.num_cells(), "one value for each cell");
    open_array(out, "Int64", name, 1);
    for (const std::int64_t v : values) out += std::to_string(v) + '\n';
    out += kCloseArray;
  }
  out += "</CellData>\n<Points>\n";
  open_array(out, "Float64", "Points", 3);
  for (const auto& p : grid.points)
    for (std::size_t k = 0; k < 3; ++k) {
      internal::append_number(out, p[k]);
      out += k == 2 ? '\n' : ' ';
    }
  out += std::string(kCloseArray) + "</Points>\n";
  append_cells(out, grid);
  return out + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace veritope
