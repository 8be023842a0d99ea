// SPDX-License-Identifier: LGPL-3.0-or-later
// VTK's unstructured grids with Bezier cells.
#include <algorithm>

#include "render/spline_view_internal.h"
#include "render/volume_net_internal.h"
#include "render/volume_view.h"
#include "render/vtu_text_internal.h"

namespace veritope {
namespace {

template <std::size_t N>
constexpr int kCellType = N == 1   ? 75
                          : N == 2 ? 77
                                   : 79;  // VTK_BEZIER_CURVE, _QUADRILATERAL, _HEXAHEDRON
constexpr int kTriangleType = 76;         // VTK_BEZIER_TRIANGLE
constexpr int kLineType = 3;              // VTK_LINE

class VtuWriter {
 public:
  VtuWriter() = default;
  /// Entities are cells of a V-model, which have colours and may be moved.
  explicit VtuWriter(const VolumeLayout& layout) : layout_(&layout) {}

  template <std::size_t N>
  Status add(const BSpline<Rational, N>& spline, std::uint64_t entity) {
    const auto s = internal::rounded_pieces(spline, entity);
    if (!s) return s.error();
    for (const auto& piece : s->pieces) {
      if (num_points_ + piece.grid().count() > internal::kMostViewPoints) return too_many(entity);
      add_piece(piece, entity);
    }
    return ok_status();
  }
  Status add(const ExactTriangle& exact, std::uint64_t entity) {
    const auto triangle = internal::rounded_triangle(exact, entity);
    if (!triangle) return triangle.error();
    if (num_points_ + triangle->count() > internal::kMostViewPoints) return too_many(entity);
    std::vector<std::size_t> order(triangle->count());
    for_each_triangle_index(triangle->degree(), [&](int i, int j, int k) {
      order[vtk_triangle_index(i, j, k)] = triangle_index(j, k);
    });
    add_cell(*triangle, order, {triangle->degree(), triangle->degree(), 1}, kTriangleType, entity);
    return ok_status();
  }
  /// The lines between neighbours among the control points. REQUIRES a layout.
  Status add_net(const ExactVolume& volume, std::uint64_t entity) {
    const auto lines = internal::net_lines(volume);
    const std::vector<Point3d> points = internal::rounded_net(volume);
    if (num_points_ + points.size() > internal::kMostViewPoints) return too_many(entity);
    const std::uint64_t first = num_points_;
    for (const Point3d& p : points) add_point(p, 1, entity);
    for (const auto& [a, b] : lines) {
      connectivity_ += std::to_string(first + a) + ' ' + std::to_string(first + b) + '\n';
      num_corners_ += 2;
      close_cell({1, 1, 1}, kLineType, entity);
    }
    return ok_status();
  }
  std::string write() const {
    using internal::vtu_array;
    std::string out = internal::vtu_begin(num_points_, num_cells_);
    out += "<PointData RationalWeights=\"RationalWeights\">\n" +
           vtu_array("Float64", "RationalWeights", 1, weights_) + "</PointData>\n";
    out += "<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n" +
           vtu_array("Float64", "HigherOrderDegrees", 3, degrees_) +
           vtu_array("Int64", layout_ == nullptr ? "entity" : "cell", 1, entities_);
    if (layout_ != nullptr)
      out += vtu_array("UInt8", "colour", 4, colours_) + vtu_array("Int64", "net", 1, nets_);
    out += "</CellData>\n";
    out += "<Points>\n" + vtu_array("Float64", "Points", 3, points_) + "</Points>\n<Cells>\n" +
           vtu_array("Int64", "connectivity", 1, connectivity_) +
           vtu_array("Int64", "offsets", 1, offsets_) + vtu_array("UInt8", "types", 1, types_) +
           "</Cells>\n" + std::string(internal::kVtuEnd);
    return out;
  }

 private:
  static Error too_many(std::uint64_t entity) {
    return internal::view_error(Code::kOverLimit, entity, "more than 33554432 control points");
  }
  template <std::size_t N>
  void add_piece(const Bezier<double, N>& piece, std::uint64_t entity) {
    const Grid<N> grid = piece.grid();
    std::vector<std::size_t> order(grid.count());
    for (std::size_t i = 0; i < grid.count(); ++i)
      order[vtk_point_index(internal::unflatten(i, grid), piece.degrees())] = i;
    std::array<int, 3> degrees{1, 1, 1};
    std::copy(piece.degrees().begin(), piece.degrees().end(), degrees.begin());
    add_cell(piece, order, degrees, kCellType<N>, entity);
  }
  // order[VTK's number of a control point] = ours.
  template <typename Map>
  void add_cell(const Map& piece, const std::vector<std::size_t>& order,
                const std::array<int, 3>& degrees, int type, std::uint64_t entity) {
    for (const std::size_t i : order) {
      connectivity_ += std::to_string(num_points_) + ' ';
      ++num_corners_;
      add_point(internal::control_point(piece, i),
                piece.is_rational() ? piece.component(piece.dimension())[i] : 1, entity);
    }
    connectivity_ += '\n';
    close_cell(degrees, type, entity);
  }
  void add_point(const Point3d& p, double weight, std::uint64_t entity) {
    for (std::size_t k = 0; k < 3; ++k) {
      internal::append_number(points_,
                              layout_ == nullptr ? p[k] : p[k] + layout_->offsets[entity][k]);
      points_ += k == 2 ? '\n' : ' ';
    }
    internal::append_number(weights_, weight);
    weights_ += '\n';
    ++num_points_;
  }
  // A cell whose points are those that were added to connectivity_.
  void close_cell(const std::array<int, 3>& degrees, int type, std::uint64_t entity) {
    for (std::size_t a = 0; a < 3; ++a)
      degrees_ += std::to_string(degrees[a]) + (a == 2 ? "\n" : " ");
    offsets_ += std::to_string(num_corners_) + '\n';
    types_ += std::to_string(type) + '\n';
    entities_ += std::to_string(entity) + '\n';
    ++num_cells_;
    if (layout_ == nullptr) return;
    const bool is_net = type == kLineType;
    const Colour c = is_net ? net_colour(cell_colour(entity)) : cell_colour(entity);
    for (const std::uint8_t channel : {c.red, c.green, c.blue})
      colours_ += std::to_string(channel) + ' ';
    colours_ += "255\n";
    nets_ += is_net ? "1\n" : "0\n";
  }

  const VolumeLayout* layout_ = nullptr;
  std::uint64_t num_points_ = 0, num_cells_ = 0, num_corners_ = 0;
  std::string points_, weights_, connectivity_, degrees_, offsets_, types_, entities_, colours_,
      nets_;
};

Status add_shape(VtuWriter& out, const SplineEntity& entity, std::uint64_t number) {
  if (const auto* t = std::get_if<TrimmedSurface>(&entity.shape))
    return out.add(t->surface, number);
  if (const auto* b = std::get_if<SplineBrep>(&entity.shape)) {
    for (const BrepFace& face : b->faces)
      if (Status status = out.add(face.surface, number); !status) return status;
    return ok_status();
  }
  if (const auto* t = std::get_if<ExactTriangle>(&entity.shape)) return out.add(*t, number);
  Status status = ok_status();
  for_each_spline(entity, [&](const auto& s) { status = out.add(s, number); });
  return status;
}

}  // namespace

namespace internal {

Result<std::string> vtu_bytes(const SplineModel& model) {
  VtuWriter out;
  for (std::size_t i = 0; i < model.entities.size(); ++i)
    if (Status status = add_shape(out, model.entities[i], i); !status) return status.error();
  return out.write();
}

}  // namespace internal

Result<std::string> volume_vtu(const SplineModel& model, const VolumeLayout& layout,
                               const VolumeViewOptions& options) {
  VtuWriter out(layout);
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    const ExactVolume& volume = std::get<ExactVolume>(model.entities[i].shape);
    if (Status status = out.add(volume, i); !status) return status.error();
  }
  for (std::size_t i = 0; i < model.entities.size() && options.has_nets; ++i) {
    const ExactVolume& volume = std::get<ExactVolume>(model.entities[i].shape);
    if (Status status = out.add_net(volume, i); !status) return status.error();
  }
  return out.write();
}

std::size_t vtk_point_index(const std::array<std::size_t, 1>& index,
                            const std::array<int, 1>& degrees) {
  const auto n = static_cast<std::size_t>(degrees[0]);
  return index[0] == 0 ? 0 : index[0] == n ? 1 : index[0] + 1;
}

std::size_t vtk_point_index(const std::array<std::size_t, 2>& index,
                            const std::array<int, 2>& degrees) {
  const auto m = static_cast<std::size_t>(degrees[0]), n = static_cast<std::size_t>(degrees[1]);
  const auto [i, j] = index;
  const bool i_edge = i == 0 || i == m, j_edge = j == 0 || j == n;
  if (i_edge && j_edge) return i != 0 ? (j != 0 ? 2 : 1) : (j != 0 ? 3 : 0);
  if (j_edge) return 4 + (i - 1) + (j != 0 ? m - 1 + n - 1 : 0);
  if (i_edge) return 4 + (j - 1) + (i != 0 ? m - 1 : 2 * (m - 1) + n - 1);
  return 4 + 2 * (m - 1 + n - 1) + (i - 1) + (m - 1) * (j - 1);
}

std::size_t vtk_triangle_index(int i, int j, int k) {
  const int ring = std::min({i, j, k});  // triangles around the one whose boundary it is on
  std::size_t offset = 0;
  for (int r = 0, n = i + j + k; r < ring; ++r, n -= 3) offset += static_cast<std::size_t>(3 * n);
  i -= ring, j -= ring, k -= ring;
  const int n = i + j + k;
  const auto at = [&](int number) { return offset + static_cast<std::size_t>(number); };
  if (i == n || j == n || k == n) return at(i == n ? 0 : j == n ? 1 : 2);
  if (k == 0) return at(3 + j - 1);
  return i == 0 ? at(3 + (n - 1) + k - 1) : at(3 + 2 * (n - 1) + i - 1);
}

std::size_t vtk_tetrahedron_index(std::array<int, 4> index) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kEdges = {
      {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  constexpr std::array<std::array<std::size_t, 3>, 4> kFaces = {
      {{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}}};
  std::size_t offset = 0;
  int n = index[0] + index[1] + index[2] + index[3];
  while (*std::min_element(index.begin(), index.end()) > 0) {
    offset += static_cast<std::size_t>(2 * (n * n + 1));  // the points on the boundary
    n -= 4;
    for (int& i : index) --i;
  }
  const auto at = [&](int number) { return offset + static_cast<std::size_t>(number); };
  for (std::size_t m = 0; m < 4; ++m)
    if (index[m] == n) return offset + m;
  for (std::size_t e = 0; e < 6; ++e) {
    const int i = index[kEdges[e][0]], j = index[kEdges[e][1]];
    if (i + j == n) return at(4 + static_cast<int>(e) * (n - 1) + j - 1);
  }
  const int inside = (n - 1) * (n - 2) / 2;
  for (std::size_t f = 0; f < 4; ++f) {
    const int i = index[kFaces[f][0]], j = index[kFaces[f][1]], k = index[kFaces[f][2]];
    if (i + j + k == n)
      return at(4 + 6 * (n - 1) + static_cast<int>(f) * inside - 3 * n) +
             vtk_triangle_index(i, j, k);
  }
  return offset;
}

std::size_t vtk_point_index(const std::array<std::size_t, 3>& index,
                            const std::array<int, 3>& degrees) {
  const auto l = static_cast<std::size_t>(degrees[0]), m = static_cast<std::size_t>(degrees[1]),
             n = static_cast<std::size_t>(degrees[2]);
  const auto [i, j, k] = index;
  const bool i_end = i == 0 || i == l, j_end = j == 0 || j == m, k_end = k == 0 || k == n;
  const int ends = (i_end ? 1 : 0) + (j_end ? 1 : 0) + (k_end ? 1 : 0);
  if (ends == 3) return (i != 0 ? (j != 0 ? 2 : 1) : (j != 0 ? 3 : 0)) + (k != 0 ? 4 : 0);
  std::size_t offset = 8;
  const std::size_t ring = 2 * (l + m - 2);
  if (ends == 2) {
    if (!i_end) return offset + (i - 1) + (j != 0 ? l + m - 2 : 0) + (k != 0 ? ring : 0);
    if (!j_end)
      return offset + (j - 1) + (i != 0 ? l - 1 : 2 * (l - 1) + m - 1) + (k != 0 ? ring : 0);
    const std::size_t edge = i != 0 ? (j != 0 ? 2 : 1) : (j != 0 ? 3 : 0);
    return offset + 2 * ring + (k - 1) + (n - 1) * edge;
  }
  offset += 4 * (l + m + n - 3);
  const std::size_t i_face = (m - 1) * (n - 1), j_face = (n - 1) * (l - 1),
                    k_face = (l - 1) * (m - 1);
  if (ends == 1) {
    if (i_end) return offset + (j - 1) + (m - 1) * (k - 1) + (i != 0 ? i_face : 0);
    offset += 2 * i_face;
    if (j_end) return offset + (i - 1) + (l - 1) * (k - 1) + (j != 0 ? j_face : 0);
    return offset + 2 * j_face + (i - 1) + (l - 1) * (j - 1) + (k != 0 ? k_face : 0);
  }
  return offset + 2 * (i_face + j_face + k_face) + (i - 1) +
         (l - 1) * ((j - 1) + (m - 1) * (k - 1));
}

}  // namespace veritope
