// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "render/spline_view_internal.h"

namespace veritope {
namespace {

using internal::RoundedPieces;
using internal::unflatten;

constexpr std::size_t kMostPerSpan = 256;

// The largest second difference of control points along an axis.
template <std::size_t N>
double second_difference(const Bezier<double, N>& piece, std::size_t axis) {
  const Grid<N> grid = piece.grid();
  const std::size_t stride = grid.stride(axis);
  double most = 0;
  grid.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i + 2 < grid.size[axis]; ++i) {
      const Point3d a = internal::control_point(piece, first + i * stride),
                    b = internal::control_point(piece, first + (i + 1) * stride),
                    c = internal::control_point(piece, first + (i + 2) * stride);
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += (a[k] - 2 * b[k] + c[k]) * (a[k] - 2 * b[k] + c[k]);
      most = std::max(most, std::sqrt(square));
    }
  });
  return most;
}

// The greatest length of b[i+1][j+1] - b[i+1][j] - b[i][j+1] + b[i][j] over neighbours along both axes.
template <std::size_t N>
double mixed_difference(const Bezier<double, N>& piece, std::size_t axis, std::size_t other) {
  const Grid<N> grid = piece.grid();
  const std::size_t along = grid.stride(axis), across = grid.stride(other);
  double most = 0;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto index = grid.index_of(i);
    if (index[axis] + 1 >= grid.size[axis] || index[other] + 1 >= grid.size[other]) continue;
    double square = 0;
    const Point3d p = internal::control_point(piece, i),
                  q = internal::control_point(piece, i + along),
                  r = internal::control_point(piece, i + across),
                  t = internal::control_point(piece, i + along + across);
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = t[k] - q[k] - r[k] + p[k];
      square += d * d;
    }
    most = std::max(most, std::sqrt(square));
  }
  return most;
}

// The number of pieces for each span of an axis. A chord over 1/n of a Bezier curve of degree p deviates by at most p
// (p - 1) max |second difference| / (8 n^2). A surface adds up both axes and the twist of its cells: two triangles
// deviate from the bilinear cell by a quarter of its twist, p q max |mixed difference| / (4 n m). Each of the three
// terms gets a third of the chord.
template <std::size_t N>
std::vector<std::size_t> divisions(const RoundedPieces<N>& s, std::size_t axis, double chord) {
  const Grid<N> cells = s.grid();
  std::vector<std::size_t> out(cells.size[axis], 1);
  for (std::size_t cell = 0; cell < s.pieces.size(); ++cell) {
    const int p = s.pieces[cell].degree(axis);
    const double bend =
        p * (p - 1) * second_difference(s.pieces[cell], axis) * (N > 1 ? 3.0 : 1.0) / 8;
    double n = std::ceil(std::sqrt(bend / chord));
    for (std::size_t other = 0; other < N; ++other) {
      if (other == axis) continue;
      const double twist =
          p * s.pieces[cell].degree(other) * mixed_difference(s.pieces[cell], axis, other) * 3 / 4;
      n = std::max(n, std::ceil(std::sqrt(twist / chord)));
    }
    if (!(n >= 1)) n = 1;
    std::size_t& most = out[unflatten(cell, cells)[axis]];
    most = std::max(most, n > kMostPerSpan ? kMostPerSpan : static_cast<std::size_t>(n));
  }
  return out;
}

// A grid line of an axis: its span, and its place in the span.
struct Sample {
  std::size_t span;
  double t;
};
std::vector<Sample> samples(const std::vector<std::size_t>& divisions) {
  std::vector<Sample> out;
  for (std::size_t span = 0; span < divisions.size(); ++span)
    for (std::size_t i = 0; i < divisions[span]; ++i)
      out.push_back({span, static_cast<double>(i) / static_cast<double>(divisions[span])});
  out.push_back({divisions.size() - 1, 1});
  return out;
}

template <std::size_t N>
Point3d value(const RoundedPieces<N>& s, const std::array<Sample, N>& at) {
  std::array<std::size_t, N> cell;
  std::array<double, N> t;
  for (std::size_t a = 0; a < N; ++a) cell[a] = at[a].span, t[a] = at[a].t;
  const auto& piece = s.pieces[s.grid().at(cell)];
  return internal::to_point(evaluate(piece, t), piece.is_rational());
}

Sample locate(const std::vector<double>& breaks, double u) {
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, u);
  const auto span = static_cast<std::size_t>(above - breaks.begin()) - 1;
  const double width = breaks[span + 1] - breaks[span];
  return {span, width > 0 ? std::clamp((u - breaks[span]) / width, 0.0, 1.0) : 0.0};
}

class Tessellator {
 public:
  /// @param divisions  for the sides of triangles
  Tessellator(std::uint64_t entity, double chord, std::size_t divisions, std::string name)
      : entity_(entity), chord_(chord), divisions_(divisions) {
    out_.name = std::move(name);
  }

  Status add(const ExactCurve& curve) {
    const auto s = internal::rounded_pieces(curve, entity_);
    if (!s) return s.error();
    std::vector<std::uint32_t> line;
    for (const Sample& t : samples(divisions(*s, 0, chord_)))
      line.push_back(put(value<1>(*s, {t})));
    out_.lines.push_back(std::move(line));
    return ok_status();
  }
  Status add(const ExactSurface& surface) {
    const auto s = internal::rounded_pieces(surface, entity_);
    if (!s) return s.error();
    const auto u = samples(divisions(*s, 0, chord_)), v = samples(divisions(*s, 1, chord_));
    return sheet(u.size(), v.size(), false, [&](std::size_t i, std::size_t j) {
      return value<2>(*s, {u[i], v[j]});
    });
  }
  // The six sides, outward if the volume is right-handed.
  Status add(const ExactVolume& volume) {
    const auto s = internal::rounded_pieces(volume, entity_);
    if (!s) return s.error();
    std::array<std::vector<Sample>, 3> lines;
    for (std::size_t a = 0; a < 3; ++a) lines[a] = samples(divisions(*s, a, chord_));
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool is_end : {false, true}) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const Status status =
            sheet(lines[b].size(), lines[c].size(), !is_end, [&](std::size_t i, std::size_t j) {
              std::array<Sample, 3> at;
              at[a] = is_end ? lines[a].back() : lines[a].front();
              at[b] = lines[b][i], at[c] = lines[c][j];
              return value<3>(*s, at);
            });
        if (!status) return status;
      }
    return ok_status();
  }
  // Adds a trimming curve, mapped to space by the surface.
  Status add(const ExactCurve& parameter, const ExactSurface& surface) {
    const auto s = internal::rounded_pieces(surface, entity_);
    const auto c = internal::rounded_pieces(parameter, entity_);
    if (!s || !c) return !s ? s.error() : c.error();
    std::vector<std::uint32_t> line;
    for (const Sample& t : samples(std::vector<std::size_t>(c->grid().size[0], 8))) {
      const Point3d uv = value<1>(*c, {t});
      line.push_back(put(value<2>(*s, {locate(s->breaks[0], uv[0]), locate(s->breaks[1], uv[1])})));
    }
    out_.lines.push_back(std::move(line));
    return ok_status();
  }
  Status add(const TrimmedSurface& trimmed) {
    if (Status status = add(trimmed.surface); !status) return status;
    for (const TrimLoop& loop : trimmed.loops)
      for (const TrimCurve& piece : loop) {
        Status status = piece.parameter ? add(*piece.parameter, trimmed.surface)
                        : piece.space   ? add(*piece.space)
                                        : ok_status();
        if (!status) return status;
      }
    return ok_status();
  }
  Status add(const SplineBrep& brep) {
    for (const BrepFace& face : brep.faces)
      if (Status status = add(face.surface); !status) return status;
    for (const BrepSegment& s : brep.segments) {
      Status status = ok_status();
      if (s.space) {
        status = add(*s.space);
      } else if (s.parameter[0] && s.faces[0] != 0) {
        status = add(*s.parameter[0], brep.faces[s.faces[0] - 1].surface);
      } else if (s.parameter[1] && s.faces[1] != 0) {
        status = add(*s.parameter[1], brep.faces[s.faces[1] - 1].surface);
      }
      if (!status) return status;
    }
    return ok_status();
  }
  Status add(const ExactTriangle& exact) {
    const auto triangle = internal::rounded_triangle(exact, entity_);
    if (!triangle) return triangle.error();
    out_.points = internal::triangle_grid(*triangle, divisions_);
    internal::append_triangle_grid(divisions_, 0, out_.triangles);
    return ok_status();
  }
  Tessellation take() { return std::move(out_); }

 private:
  std::uint32_t put(const Point3d& p) {
    out_.points.push_back(p);
    return static_cast<std::uint32_t>(out_.points.size() - 1);
  }
  template <typename At>
  Status sheet(std::size_t m, std::size_t n, bool is_reversed, At at) {
    if (out_.points.size() + m * n > internal::kMostViewPoints)
      return internal::view_error(Code::kOverLimit, entity_,
                                  "more than 33554432 points; a larger chord gives fewer");
    const auto first = static_cast<std::uint32_t>(out_.points.size());
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) put(at(i, j));
    const auto id = [&](std::size_t i, std::size_t j) {
      return first + static_cast<std::uint32_t>(i * n + j);
    };
    for (std::size_t i = 0; i + 1 < m; ++i)
      for (std::size_t j = 0; j + 1 < n; ++j) {
        std::array<std::uint32_t, 3> a = {id(i, j), id(i + 1, j), id(i + 1, j + 1)},
                                     b = {id(i, j), id(i + 1, j + 1), id(i, j + 1)};
        if (is_reversed) std::swap(a[1], a[2]), std::swap(b[1], b[2]);
        out_.triangles.push_back(a);
        out_.triangles.push_back(b);
      }
    return ok_status();
  }

  std::uint64_t entity_;
  double chord_;
  std::size_t divisions_;
  Tessellation out_;
};

// A length that fits the model: 1/1000 of the diagonal of its control points.
double default_chord(const SplineModel& model) {
  Point3d lo, hi;
  lo.fill(HUGE_VAL), hi.fill(-HUGE_VAL);
  for (const SplineEntity& e : model.entities) {
    const auto grow = [&](const auto& s) {
      for (std::size_t i = 0; i < s.component(0).size(); ++i) {
        const double w = s.is_rational() ? nearest_double(s.component(s.dimension())[i]) : 1;
        for (int c = 0; c < 3 && c < s.dimension(); ++c) {
          const double x = nearest_double(s.component(c)[i]) / w;
          const auto k = static_cast<std::size_t>(c);
          lo[k] = std::min(lo[k], x), hi[k] = std::max(hi[k], x);
        }
      }
    };
    if (const auto* t = std::get_if<TrimmedSurface>(&e.shape)) {
      grow(t->surface);
    } else if (const auto* b = std::get_if<SplineBrep>(&e.shape)) {
      for (const BrepFace& face : b->faces) grow(face.surface);
    } else if (const auto* triangle = std::get_if<ExactTriangle>(&e.shape)) {
      grow(*triangle);
    } else {
      for_each_spline(e, grow);
    }
  }
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (hi[k] > lo[k]) square += (hi[k] - lo[k]) * (hi[k] - lo[k]);
  const double chord = std::sqrt(square) / 1000;
  return std::isfinite(chord) && chord > 0 ? chord : 1;
}

// The number of parts into which the sides of all triangles are cut, the same for all so that they
// fit together.
Result<std::size_t> common_divisions(const SplineModel& model, double chord) {
  std::size_t most = 1, num_triangles = 0, last = 0;
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    const auto* exact = std::get_if<ExactTriangle>(&model.entities[i].shape);
    if (exact == nullptr) continue;
    const auto triangle = internal::rounded_triangle(*exact, i);
    if (!triangle) return triangle.error();
    most = std::max(most, internal::triangle_divisions(*triangle, chord));
    ++num_triangles, last = i;
  }
  if (num_triangles * num_triangle_coefficients(static_cast<int>(most)) > internal::kMostViewPoints)
    return internal::view_error(
        Code::kOverLimit, last,
        "the triangles up to this one give more than 33554432 points; a larger chord gives fewer");
  return most;
}

std::string name_of(const SplineModel& model, const SplineEntity& entity) {
  for (auto g = entity.group; g; g = model.groups[*g].parent)
    if (!model.groups[*g].name.empty()) return model.groups[*g].name;
  return "";
}

}  // namespace

Result<std::vector<Tessellation>> tessellate(const SplineModel& model, const ViewOptions& options) {
  const double chord = options.chord.value_or(default_chord(model));
  const auto divisions = common_divisions(model, chord);
  if (!divisions) return divisions.error();
  std::vector<Tessellation> parts;
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    Tessellator one(i, chord, *divisions, name_of(model, model.entities[i]));
    const Status status =
        std::visit([&](const auto& s) { return one.add(s); }, model.entities[i].shape);
    if (!status) return status.error();
    parts.push_back(one.take());
  }
  return parts;
}

}  // namespace veritope
