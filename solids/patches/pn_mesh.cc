// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/pn_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "robust/binary64.h"
#include "robust/dyadic.h"
#include "solids/patches/finite_points_internal.h"

namespace veritope {
namespace {

using DyadicPoint = std::array<Dyadic, 3>;
DyadicPoint exact(const Vec3d& v) {
  return {Dyadic::from_double(v.x), Dyadic::from_double(v.y), Dyadic::from_double(v.z)};
}
PnPoint rational(const DyadicPoint& p) {
  return {p[0].to_rational(), p[1].to_rational(), p[2].to_rational()};
}
Error at_face(Code code, std::size_t face, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.face = face;
  return error;
}
Error at_vertex(Code code, std::size_t vertex, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.vertex = vertex;
  return error;
}

Status check_mesh(const TriangleMesh& mesh, std::size_t num_normals) {
  const std::size_t count = mesh.positions.size();
  if (num_normals != count)
    return Error{
        Code::kBadArgument,
        {},
        std::to_string(num_normals) + " normals for " + std::to_string(count) + " vertices"};
  for (std::size_t v = 0; v < count; ++v)
    if (!internal::is_finite(mesh.positions[v]))
      return at_vertex(Code::kNotFinite, v, "the position is not finite");
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const std::uint32_t v : mesh.faces[f])
      if (v >= count)
        return at_face(Code::kIndexOutOfRange, f,
                       "vertex " + std::to_string(v) + " of " + std::to_string(count));
  return ok_status();
}

}  // namespace

class PnMeshBuilder {
 public:
  static Result<PnMesh<Rational>> exact_mesh(const TriangleMesh& mesh,
                                             std::span<const PnDirection> directions) {
    if (Status status = check_mesh(mesh, directions.size()); !status) return status.error();
    std::vector<DyadicPoint> points;
    for (const Vec3d& p : mesh.positions) points.push_back(exact(p));
    PnMesh<Rational> out;
    out.faces_ = mesh.faces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& face = mesh.faces[f];
      const PnCorners<Dyadic> corners{at_corners(points, face), at_corners(directions, face)};
      if (Status status = check_face(corners, f, face); !status) return status.error();
      out.centres_.push_back(pn_centre(corners));
    }
    list_edges(out);
    for (auto& edge : out.edges_) {
      const DyadicPoint &p = points[edge.a], &q = points[edge.b];
      const DyadicPoint &n = directions[edge.a], &m = directions[edge.b];
      edge.points = {pn_edge_point(p, q, n), pn_edge_point(q, p, m)};
      edge.normal = pn_edge_normal(p, q, n, m);
    }
    for (const DyadicPoint& p : points) out.corners_.push_back(rational(p));
    for (const DyadicPoint& n : directions) out.corner_normals_.push_back(rational(n));
    return out;
  }

  static Result<PnMesh<double>> rounded_mesh(const PnMesh<Rational>& mesh) {
    PnMesh<double> out;
    out.faces_ = mesh.faces_;
    out.edges_of_face_ = mesh.edges_of_face_;
    for (const auto& p : mesh.corners_) out.corners_.push_back(nearest(p));
    for (const auto& n : mesh.corner_normals_) out.corner_normals_.push_back(nearest(n));
    for (const auto& e : mesh.edges_)
      out.edges_.push_back(
          {e.a, e.b, {nearest(e.points[0]), nearest(e.points[1])}, nearest(e.normal)});
    for (const auto& c : mesh.centres_) out.centres_.push_back(nearest(c));
    for (std::size_t f = 0; f < out.faces_.size(); ++f)
      for (const auto& map : {out.points(f), out.normals(f)})
        for (const double v : map.coefficients())
          if (!veritope::is_finite(v))
            return at_face(Code::kNotFinite, f, "a control point is beyond the largest double");
    return out;
  }

  template <typename Values>
  static std::array<typename Values::value_type, 3> at_corners(
      const Values& values, const std::array<std::uint32_t, 3>& face) {
    return {values[face[0]], values[face[1]], values[face[2]]};
  }
  // For each edge of a face, from corner e + 1 to corner e + 2.
  template <Ring R>
  static std::array<std::array<std::array<R, 3>, 2>, 3> edge_points(const PnMesh<R>& mesh,
                                                                    std::size_t face) {
    std::array<std::array<std::array<R, 3>, 2>, 3> out;
    for (std::size_t e = 0; e < 3; ++e) {
      const auto& edge = mesh.edges_[mesh.edges_of_face_[face][e]];
      out[e] = edge.points;
      if (mesh.faces_[face][(e + 1) % 3] != edge.a) std::swap(out[e][0], out[e][1]);
    }
    return out;
  }

 private:
  static Status check_face(const PnCorners<Dyadic>& corners, std::size_t f,
                           const std::array<std::uint32_t, 3>& face) {
    Status status = check_pn_triangle(corners);
    if (status) return status;
    Error error = status.error();
    error.place.face = f;
    if (error.place.vertex)
      error.place.vertex = face[static_cast<std::size_t>(*error.place.vertex)];
    return error;
  }

  static void list_edges(PnMesh<Rational>& mesh) {
    using Ends = std::pair<std::uint32_t, std::uint32_t>;
    const auto ends = [](const std::array<std::uint32_t, 3>& face, std::size_t e) -> Ends {
      return std::minmax({face[(e + 1) % 3], face[(e + 2) % 3]});
    };
    std::vector<Ends> all;
    for (const auto& face : mesh.faces_)
      for (std::size_t e = 0; e < 3; ++e) all.push_back(ends(face, e));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const auto& [a, b] : all) mesh.edges_.push_back({a, b, {}, {}});
    for (const auto& face : mesh.faces_) {
      auto& edges = mesh.edges_of_face_.emplace_back();
      for (std::size_t e = 0; e < 3; ++e)
        edges[e] = static_cast<std::uint32_t>(
            std::lower_bound(all.begin(), all.end(), ends(face, e)) - all.begin());
    }
  }

  static Point3d nearest(const PnPoint& p) {
    return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
  }
};

template <Ring R>
BezierTriangle<R> PnMesh<R>::points(std::size_t face) const {
  return pn_points<R>(PnMeshBuilder::at_corners(corners_, faces_[face]),
                      PnMeshBuilder::edge_points(*this, face), centres_[face]);
}

template <Ring R>
BezierTriangle<R> PnMesh<R>::normals(std::size_t face) const {
  std::array<Point, 3> edge_normals;
  for (std::size_t e = 0; e < 3; ++e) edge_normals[e] = edges_[edges_of_face_[face][e]].normal;
  return pn_normals<R>(PnMeshBuilder::at_corners(corner_normals_, faces_[face]), edge_normals);
}

template class PnMesh<Rational>;
template class PnMesh<double>;

Result<PnMesh<Rational>> make_pn_mesh(const TriangleMesh& mesh,
                                      std::span<const PnDirection> normals) {
  return PnMeshBuilder::exact_mesh(mesh, normals);
}

Result<PnMesh<Rational>> make_pn_mesh(const TriangleMesh& mesh, std::span<const Vec3d> normals) {
  std::vector<PnDirection> directions;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    if (!internal::is_finite(normals[v]))
      return at_vertex(Code::kNotFinite, v, "the normal is not finite");
    directions.push_back(exact(normals[v]));
  }
  return make_pn_mesh(mesh, directions);
}

std::vector<PnDirection> area_normals(const TriangleMesh& mesh) {
  std::vector<PnDirection> out(mesh.positions.size());
  for (const auto& face : mesh.faces) {
    const DyadicPoint a = exact(mesh.positions[face[0]]), b = exact(mesh.positions[face[1]]),
                      c = exact(mesh.positions[face[2]]);
    DyadicPoint u, v;
    for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const Dyadic area = u[i] * v[j] - u[j] * v[i];
      for (const std::uint32_t vertex : face) out[vertex][k] += area;
    }
  }
  return out;
}
Result<PnMesh<double>> rounded(const PnMesh<Rational>& mesh) {
  return PnMeshBuilder::rounded_mesh(mesh);
}

}  // namespace veritope
