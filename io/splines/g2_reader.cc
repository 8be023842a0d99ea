// SPDX-License-Identifier: LGPL-3.0-or-later
// GoTools' .g2: a sequence of objects, each "class major minor n aux..." and its numbers. The reader takes splines, and
// lines, planes and linear extrusions where that needs no square root. The other elementary shapes are left out.
#include "io/splines/g2_shape_reader.h"

namespace veritope {
namespace {

class G2Reader : G2ShapeReader {
 public:
  using G2ShapeReader::G2ShapeReader;
  using SplineTextReader::take;
  using SplineTextReader::take_error;

  bool read() {
    while (!is_at_end())
      if (!read_object()) return false;
    return true;
  }

 private:
  bool read_object();
  bool read_bounded(SplineEntity& entity, bool& is_known);
  bool read_piece(TrimCurve& piece);
  bool read_cloud(std::uint64_t numbers_each, const char* what);
  template <typename Spline>
  bool keep(G2Shape<Spline> shape, std::int64_t type, SplineEntity& entity, bool& is_known);
};

// Reads a curve on a surface: which of two curves counts, the classes of both, then both curves.
bool G2Reader::read_piece(TrimCurve& piece) {
  std::uint64_t prefers_parameter = 0;
  std::int64_t types[2] = {0, 0};
  if (!read_count("the preference flag", 0, 1, prefers_parameter) ||
      !read_integer("a class of curves", types[0]) || !read_integer("a class of curves", types[1]))
    return false;
  std::optional<ExactCurve>* const to[2] = {&piece.parameter, &piece.space};
  constexpr const char* kNames[2] = {"parameter", "space"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (types[i] == 0) continue;
    G2Shape<ExactCurve> shape;
    if (!read_curve(types[i], shape)) return false;
    *to[i] = std::move(shape.spline);
    if (shape.reason.empty()) continue;
    const std::string what = std::string(kNames[i]) + " " + g2_class_name(types[i]);
    piece.omitted += (piece.omitted.empty() ? "" : "; ") + what + ": " + shape.reason;
    leave_out(what + "s of trimming loops", shape.reason, i == 0);
  }
  return true;
}

bool G2Reader::read_bounded(SplineEntity& entity, bool& is_known) {
  std::int64_t type = 0;
  G2Shape<ExactSurface> shape;
  std::uint64_t num_loops = 0;
  if (!read_integer("a class of surfaces", type) || !read_surface(type, shape) ||
      !read_count("a number of loops", 0, bytes_left(), num_loops))
    return false;
  std::vector<TrimLoop> loops;
  for (std::uint64_t i = 0; i < num_loops; ++i) {
    std::uint64_t num_curves = 0;
    Rational tolerance;
    if (!read_count("a number of curves", 0, bytes_left(), num_curves) || !read_number(tolerance))
      return false;
    TrimLoop& loop = loops.emplace_back();
    while (loop.size() < num_curves)
      if (!read_piece(loop.emplace_back())) return false;
  }
  is_known = shape.spline.has_value();
  if (is_known) {
    entity.shape = TrimmedSurface{std::move(*shape.spline), std::move(loops)};
  } else {
    leave_out(std::string("trimmed ") + g2_class_name(type) + "s", shape.reason, true);
  }
  return true;
}

bool G2Reader::read_cloud(std::uint64_t numbers_each, const char* what) {
  std::uint64_t count = 0;
  Rational ignored;
  if (!read_count("a number of points", 1, bytes_left(), count)) return false;
  for (std::uint64_t i = 0; i < count * numbers_each; ++i)
    if (!read_number(ignored)) return false;
  leave_out(what, "", true);
  return true;
}

template <typename Spline>
bool G2Reader::keep(G2Shape<Spline> shape, std::int64_t type, SplineEntity& entity,
                    bool& is_known) {
  is_known = shape.spline.has_value();
  if (is_known) {
    has_converted_shapes_ =
        has_converted_shapes_ || (type != kSplineCurve && type != kSplineSurface);
    entity.shape = std::move(*shape.spline);
  } else {
    leave_out(std::string(g2_class_name(type)) + "s", shape.reason, true);
  }
  return true;
}

bool G2Reader::read_object() {
  skip();
  const char* const open = p_;
  SplineEntity entity = begin_entity(open);
  std::int64_t type = 0, version = 0;
  std::uint64_t num_extra = 0;
  if (!read_integer("a class of objects", type) || !read_integer("a version", version) ||
      !read_integer("a version", version) ||
      !read_count("a number of extra data", 0, bytes_left(), num_extra))
    return false;
  std::string extra;
  for (std::uint64_t i = 0; i < num_extra; ++i) {
    std::int64_t value = 0;
    if (!read_integer("an extra datum", value)) return false;
    extra += " " + std::to_string(value);
  }
  if (!extra.empty()) entity.attributes.push_back("g2-extra" + extra);
  bool is_known = true;
  if (type == kSplineVolume) {
    std::optional<ExactVolume> volume;
    if (!read_spline(volume)) return false;
    entity.shape = std::move(*volume);
  } else if (type == kBoundedSurface) {
    if (!read_bounded(entity, is_known)) return false;
  } else if (type == kPointCloud || type == kLineCloud) {
    is_known = false;
    if (!read_cloud(type == kPointCloud ? 3 : 6,
                    type == kPointCloud ? "point clouds" : "line clouds"))
      return false;
  } else if (type == kCurveOnSurface) {
    TrimCurve piece;
    is_known = false;
    if (!read_piece(piece)) return false;
    leave_out("curves on surfaces", "their surface is not said", true);
  } else if (type >= kSplineCurve && type < kSplineSurface) {
    G2Shape<ExactCurve> shape;
    if (!read_curve(type, shape) || !keep(std::move(shape), type, entity, is_known)) return false;
  } else if (type >= kSplineSurface && type < 300) {
    G2Shape<ExactSurface> shape;
    if (!read_surface(type, shape) || !keep(std::move(shape), type, entity, is_known)) return false;
  } else {
    return fail(open, Code::kSyntax,
                "objects of class " + std::to_string(type) + " are not known here");
  }
  if (is_known) return end_entity(std::move(entity));
  entity_.reset();
  return true;
}

}  // namespace

Result<SplineFile> read_g2(const Source& source, const ReadLimits& limits) {
  return run_reader<G2Reader>(source, limits);
}

}  // namespace veritope
