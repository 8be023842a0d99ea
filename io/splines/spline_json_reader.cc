// SPDX-License-Identifier: LGPL-3.0-or-later
// Our exact text form: docs/formats/spline-json.md. Keys come in any order; none is unknown, none
// is missing.
#include <algorithm>

#include "io/splines/spline_json_lexer.h"

namespace veritope {
namespace {

class JsonReader : SplineJsonLexer {
 public:
  using SplineJsonLexer::SplineJsonLexer;
  using SplineTextReader::take;
  using SplineTextReader::take_error;

  bool read();

 private:
  bool read_strings(std::vector<std::string>& texts);
  bool read_index(const char* what, std::optional<std::size_t>& index, std::size_t below);
  bool read_group();
  bool read_entity();
  bool read_shape(const std::string& kind, SplineEntity& entity);
  struct RawNet {
    const char* at = nullptr;
    bool is_rational = false;
    std::int64_t components = 0;
    std::uint64_t num_points = 0;
    std::size_t per_point = 0;  // numbers in the first
    bool is_even = true;        // and in all others
    std::vector<Rational> points;
  };
  struct RawMap : RawNet {
    std::vector<std::int64_t> degrees;
    std::vector<bool> periodic;
    std::vector<std::vector<Rational>> knots;
  };
  bool read_points(RawNet& raw);
  bool check_components(const RawNet& raw);
  std::vector<Rational> take_coefficients(RawNet& raw);
  bool check_weights(const RawNet& raw, std::span<const Rational> weights);
  bool read_raw(RawMap& raw);
  template <std::size_t N>
  bool finish(RawMap& raw, std::optional<BSpline<Rational, N>>& spline);
  template <std::size_t N>
  bool read_map(std::optional<BSpline<Rational, N>>& spline);
  bool read_triangle(std::optional<ExactTriangle>& triangle);
  bool read_optional_curve(std::optional<ExactCurve>& curve);
  bool read_loops(std::vector<TrimLoop>& loops);
  bool read_brep_face(SplineBrep& brep);
  bool read_brep_segment(SplineBrep& brep);
  bool check_brep(const SplineBrep& brep);
};

bool JsonReader::read_strings(std::vector<std::string>& texts) {
  return read_list([&] { return read_string(texts.emplace_back()); });
}

bool JsonReader::read_index(const char* what, std::optional<std::size_t>& index,
                            std::size_t below) {
  if (take_null()) return true;
  skip();
  const char* const at = p_;
  std::int64_t value = 0;
  if (!read_integer(what, value)) return false;
  if (value < 0 || static_cast<std::uint64_t>(value) >= below)
    return fail(at, Code::kIndexOutOfRange,
                std::string(what) + " must be below " + std::to_string(below) + ", not " +
                    std::to_string(value));
  index = static_cast<std::size_t>(value);
  return true;
}

bool JsonReader::read_group() {
  SplineGroup group;
  const bool ok = read_object({"name", "parent", "attributes"}, [&](std::size_t key) {
    if (key == 0) return read_string(group.name);
    if (key == 1) return read_index("the parent of a group", group.parent, model_.groups.size());
    return read_strings(group.attributes);
  });
  model_.groups.push_back(std::move(group));
  return ok;
}

bool JsonReader::read_points(RawNet& raw) {
  return read_list([&] {
    const std::size_t before = raw.points.size();
    if (!read_list([&] { return read_exact(raw.points.emplace_back()); })) return false;
    const std::size_t numbers = raw.points.size() - before;
    if (raw.num_points++ == 0) raw.per_point = numbers;
    raw.is_even = raw.is_even && numbers == raw.per_point;
    return true;
  });
}

bool JsonReader::check_components(const RawNet& raw) {
  const std::int64_t least = raw.is_rational ? 2 : 1;
  const auto components = static_cast<std::uint64_t>(raw.components);
  const bool fits = raw.num_points == 0 || (raw.is_even && raw.per_point == components);
  if (raw.components >= least && raw.components <= 1001 && fits) return true;
  return fail(raw.at, Code::kBadSpline,
              "every point must have as many numbers as there are components, " +
                  std::to_string(raw.components));
}

// Takes the coefficients component by component. REQUIRES check_components(raw); leaves it without
// points.
std::vector<Rational> JsonReader::take_coefficients(RawNet& raw) {
  const auto components = static_cast<std::size_t>(raw.components);
  std::vector<Rational> coefficients(raw.points.size());
  for (std::size_t i = 0; i < raw.num_points; ++i)
    for (std::size_t c = 0; c < components; ++c)
      coefficients[c * raw.num_points + i] = std::move(raw.points[i * components + c]);
  raw.points.clear();
  return coefficients;
}

bool JsonReader::check_weights(const RawNet& raw, std::span<const Rational> weights) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i].sign() != Sign::kPositive)
      return fail(raw.at, Code::kBadSpline,
                  "the weight of control point " + std::to_string(i) + ", " +
                      weights[i].to_string() + ", is not positive");
  return true;
}

bool JsonReader::read_raw(RawMap& raw) {
  skip();
  raw.at = p_;
  return read_object(
      {"degrees", "periodic", "knots", "rational", "components", "points"}, [&](std::size_t key) {
        switch (key) {
          case 0:
            return read_list([&] { return read_integer("a degree", raw.degrees.emplace_back()); });
          case 1:
            return read_list([&] {
              bool value = false;
              const bool ok = read_bool(value);
              raw.periodic.push_back(value);
              return ok;
            });
          case 2:
            return read_list([&] {
              auto& knots = raw.knots.emplace_back();
              return read_list([&] { return read_exact(knots.emplace_back()); });
            });
          case 3: return read_bool(raw.is_rational);
          case 4: return read_integer("a number of components", raw.components);
          default: return read_points(raw);
        }
      });
}

template <std::size_t N>
bool JsonReader::finish(RawMap& raw, std::optional<BSpline<Rational, N>>& spline) {
  if (raw.degrees.size() != N || raw.knots.size() != N || raw.periodic.size() != N)
    return fail(raw.at, Code::kBadSpline,
                "degrees, periodic and knots must have " + std::to_string(N) + " entries");
  if (!check_components(raw)) return false;
  std::array<KnotAxis<Rational>, N> axes;
  Grid<N> grid;
  std::uint64_t total = 1;
  for (std::size_t a = 0; a < N; ++a) {
    const std::int64_t degree = std::clamp<std::int64_t>(raw.degrees[a], -1, kMaxSplineDegree + 1);
    auto axis = make_knot_axis(static_cast<int>(degree), std::move(raw.knots[a]), raw.periodic[a]);
    if (!axis) {
      Error error = axis.error();
      if (error.code == Code::kBadArgument) error.code = Code::kBadSpline;
      return fail_with(raw.at, error);
    }
    axes[a] = std::move(*axis);
    grid.size[a] = axes[a].num_control();
    total = grid.size[a] > source_.size() / total ? source_.size() + 1 : total * grid.size[a];
    if (total > source_.size()) break;
  }
  if (total != raw.num_points)
    return fail(raw.at, Code::kBadSpline,
                std::to_string(raw.num_points) + " points do not fit the knots");
  BSpline<Rational, N> built(std::move(axes), static_cast<int>(raw.components), raw.is_rational,
                             take_coefficients(raw));
  if (raw.is_rational && !check_weights(raw, built.component(built.num_components() - 1)))
    return false;
  for (std::size_t a = 0; a < N; ++a) {
    if (!built.axis(a).is_periodic) continue;
    const std::size_t n = grid.size[a], p = static_cast<std::size_t>(built.axis(a).degree),
                      stride = grid.stride(a);
    bool repeats = n >= p;
    for (int c = 0; c < built.num_components(); ++c)
      grid.for_each_line(a, [&](std::size_t first) {
        for (std::size_t i = 0; repeats && i < p; ++i)
          repeats = built.component(c)[first + i * stride] ==
                    built.component(c)[first + (n - p + i) * stride];
      });
    if (!repeats)
      return fail(raw.at, Code::kBadSpline, "the control points of a periodic axis do not repeat");
  }
  spline = std::move(built);
  return true;
}

template <std::size_t N>
bool JsonReader::read_map(std::optional<BSpline<Rational, N>>& spline) {
  RawMap raw;
  return read_raw(raw) && finish(raw, spline);
}

bool JsonReader::read_triangle(std::optional<ExactTriangle>& triangle) {
  RawNet raw;
  std::int64_t degree = 0;
  skip();
  raw.at = p_;
  const bool ok = read_object({"degree", "rational", "components", "points"}, [&](std::size_t key) {
    switch (key) {
      case 0: return read_integer("a degree", degree);
      case 1: return read_bool(raw.is_rational);
      case 2: return read_integer("a number of components", raw.components);
      default: return read_points(raw);
    }
  });
  if (!ok || !check_components(raw)) return false;
  if (degree < 1 || degree > kMaxSplineDegree)
    return fail(raw.at, degree < 1 ? Code::kBadSpline : Code::kOverLimit,
                "a triangle's degree must be from 1 to " + std::to_string(kMaxSplineDegree) +
                    ", not " + std::to_string(degree));
  const std::size_t needed = num_triangle_coefficients(static_cast<int>(degree));
  if (raw.num_points != needed)
    return fail(raw.at, Code::kBadSpline,
                "a triangle of degree " + std::to_string(degree) + " has " +
                    std::to_string(needed) + " points, not " + std::to_string(raw.num_points));
  ExactTriangle built(static_cast<int>(degree), static_cast<int>(raw.components), raw.is_rational,
                      take_coefficients(raw));
  if (built.is_rational() && !check_weights(raw, built.component(built.num_components() - 1)))
    return false;
  triangle = std::move(built);
  return true;
}

bool JsonReader::read_optional_curve(std::optional<ExactCurve>& curve) {
  return take_null() || read_map(curve);
}

bool JsonReader::read_loops(std::vector<TrimLoop>& loops) {
  return read_list([&] {
    TrimLoop& loop = loops.emplace_back();
    return read_list([&] {
      TrimCurve& piece = loop.emplace_back();
      return read_object({"parameter", "space", "omitted"}, [&](std::size_t key) {
        if (key == 2) return read_string(piece.omitted);
        return read_optional_curve(key == 0 ? piece.parameter : piece.space);
      });
    });
  });
}

bool JsonReader::read_brep_face(SplineBrep& brep) {
  std::optional<ExactSurface> surface;
  std::vector<std::vector<std::int64_t>> loops;
  const bool ok = read_object({"map", "loops"}, [&](std::size_t key) {
    if (key == 0) return read_map(surface);
    return read_list([&] {
      auto& loop = loops.emplace_back();
      return read_list([&] { return read_integer("a segment's number", loop.emplace_back()); });
    });
  });
  if (ok) brep.faces.push_back({std::move(*surface), std::move(loops)});
  return ok;
}

bool JsonReader::read_brep_segment(SplineBrep& brep) {
  BrepSegment segment;
  const auto exactly_two = [&](std::size_t count) {
    return count == 2 ||
           fail(p_, Code::kSyntax, "a segment has two surfaces and two parameter curves");
  };
  const bool ok = read_object({"surfaces", "parameter", "space"}, [&](std::size_t key) {
    std::size_t count = 0;
    std::uint64_t unused = 0;
    std::optional<ExactCurve> ignored;
    if (key == 0)
      return read_list([&] {
               const std::size_t i = count++;
               return read_count("a surface's number", 0, std::uint64_t{1} << 60,
                                 i < 2 ? segment.faces[i] : unused);
             }) &&
             exactly_two(count);
    if (key == 1)
      return read_list([&] {
               const std::size_t i = count++;
               return read_optional_curve(i < 2 ? segment.parameter[i] : ignored);
             }) &&
             exactly_two(count);
    return read_optional_curve(segment.space);
  });
  if (ok) brep.segments.push_back(std::move(segment));
  return ok;
}

bool JsonReader::check_brep(const SplineBrep& brep) {
  const auto most = static_cast<std::int64_t>(brep.segments.size());
  for (const BrepFace& face : brep.faces)
    for (const auto& loop : face.loops)
      for (const std::int64_t n : loop)
        if (n == 0 || n > most || n < -most)
          return fail(p_, Code::kIndexOutOfRange,
                      "a loop names segment " + std::to_string(n) + " of " + std::to_string(most));
  for (const BrepSegment& s : brep.segments)
    for (const std::uint64_t face : s.faces)
      if (face > brep.faces.size())
        return fail(p_, Code::kIndexOutOfRange,
                    "a segment names surface " + std::to_string(face) + " of " +
                        std::to_string(brep.faces.size()));
  return true;
}

bool JsonReader::read_shape(const std::string& kind, SplineEntity& entity) {
  const auto keep = [&](auto spline) {
    entity.shape = std::move(*spline);
    return true;
  };
  if (kind == "curve") {
    std::optional<ExactCurve> curve;
    return read_map(curve) && keep(std::move(curve));
  }
  if (kind == "surface") {
    std::optional<ExactSurface> surface;
    return read_map(surface) && keep(std::move(surface));
  }
  if (kind == "volume") {
    std::optional<ExactVolume> volume;
    return read_map(volume) && keep(std::move(volume));
  }
  if (kind == "triangle") {
    std::optional<ExactTriangle> triangle;
    return read_triangle(triangle) && keep(std::move(triangle));
  }
  if (kind == "trimmed") {
    std::optional<ExactSurface> surface;
    std::vector<TrimLoop> loops;
    if (!read_object({"map", "loops"}, [&](std::size_t key) {
          return key == 0 ? read_map(surface) : read_loops(loops);
        }))
      return false;
    entity.shape = TrimmedSurface{std::move(*surface), std::move(loops)};
    return true;
  }
  SplineBrep brep;
  const bool ok = read_object({"surfaces", "segments"}, [&](std::size_t key) {
    return key == 0 ? read_list([&] { return read_brep_face(brep); })
                    : read_list([&] { return read_brep_segment(brep); });
  });
  if (!ok || !check_brep(brep)) return false;
  entity.shape = std::move(brep);
  return true;
}

bool JsonReader::read_entity() {
  skip();
  SplineEntity entity = begin_entity(p_);
  std::string kind;
  const bool ok = read_object({"kind", "group", "attributes", "shape"}, [&](std::size_t key) {
    if (key == 1) return read_index("the group of an entity", entity.group, model_.groups.size());
    if (key == 2) return read_strings(entity.attributes);
    if (key == 3) {
      if (kind.empty()) return fail(p_, Code::kSyntax, "the key 'kind' must come before 'shape'");
      return read_shape(kind, entity);
    }
    if (!read_string(kind)) return false;
    for (const char* known : {"curve", "surface", "volume", "trimmed", "model", "triangle"})
      if (kind == known) return true;
    return fail(p_, Code::kSyntax, "unknown kind of entity " + quoted(kind));
  });
  return ok && end_entity(std::move(entity));
}

bool JsonReader::read() {
  bool has_groups = false;
  const bool ok = read_object({"format", "groups", "entities"}, [&](std::size_t key) {
    if (key == 0) {
      std::string format;
      skip();
      const char* const at = p_;
      if (!read_string(format)) return false;
      return format == "veritope-spline-1" ||
             fail(at, Code::kUnknownFormat,
                  "the format must be 'veritope-spline-1', not " + quoted(format));
    }
    if (key == 1) {
      has_groups = true;
      return read_list([&] { return read_group(); });
    }
    if (!has_groups) return fail(p_, Code::kSyntax, "the key 'groups' must come before 'entities'");
    return read_list([&] { return read_entity(); });
  });
  if (!ok) return false;
  return is_at_end() || fail_expected("the end of the file");
}

}  // namespace

Result<SplineFile> read_spline_json(const Source& source, const ReadLimits& limits) {
  return run_reader<JsonReader>(source, limits);
}

}  // namespace veritope
