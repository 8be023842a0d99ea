// SPDX-License-Identifier: LGPL-3.0-or-later
// Our exact text form: docs/formats/spline-json.md. Keys come in any order; none is unknown, none
// is missing.
#include "io/splines/spline_json_maps.h"

namespace veritope {
namespace {

class JsonReader : SplineJsonMaps {
 public:
  using SplineJsonMaps::SplineJsonMaps;
  using SplineTextReader::take;
  using SplineTextReader::take_error;

  bool read();
  /// As read, for an object at `at` that other text may follow.
  bool read_part(const char* at);
  const char* cursor() const { return p_; }

 private:
  bool read_model();
  bool read_strings(std::vector<std::string>& texts);
  bool read_index(const char* what, std::optional<std::size_t>& index, std::size_t below);
  bool read_group();
  bool read_entity();
  bool read_shape(const std::string& kind, SplineEntity& entity);
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

bool JsonReader::read_model() {
  bool has_groups = false;
  return read_object({"format", "groups", "entities"}, [&](std::size_t key) {
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
}

bool JsonReader::read() {
  return read_model() && (is_at_end() || fail_expected("the end of the file"));
}

bool JsonReader::read_part(const char* at) {
  p_ = at;
  return read_model();
}

}  // namespace

Result<SplineFile> read_spline_json(const Source& source, const ReadLimits& limits) {
  return run_reader<JsonReader>(source, limits);
}

Result<SplineFile> read_spline_json_part(const Source& source, const ReadLimits& limits,
                                         const char*& at) {
  JsonReader reader(source, limits);
  if (!reader.read_part(at)) return reader.take_error();
  at = reader.cursor();
  return reader.take();
}

}  // namespace veritope
