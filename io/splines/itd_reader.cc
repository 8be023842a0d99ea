// SPDX-License-Identifier: LGPL-3.0-or-later
// IRIT's .itd: a tree of [OBJECT attributes name data] with curves, surfaces, trimmed surfaces, trivariates, models.
// Brackets, quoted strings and words are the tokens; text before the first bracket of an object is a comment.
#include <algorithm>

#include "io/splines/itd_spline_reader.h"

namespace veritope {
namespace {

class ItdReader : ItdSplineReader {
 public:
  using ItdSplineReader::ItdSplineReader;
  using SplineTextReader::take_error;

  bool read();
  SplineFile take();

 private:
  bool read_object_item();
  bool read_data(const char* open, const std::string& keyword, bool& is_data);
  bool add(SplineEntity entity);

  bool read_trimmed(SplineEntity& entity);
  bool read_trim_loop(TrimmedSurface& trimmed);
  bool read_model(SplineEntity& entity);
  bool read_model_face(SplineBrep& brep);
  bool read_model_segment(SplineBrep& brep);
  bool check_model(const char* open, const SplineBrep& brep);

  struct Open {
    std::optional<std::size_t> group;
    bool has_name = false;
    const char* at = nullptr;
  };
  std::vector<Open> open_;
};

bool ItdReader::read_trim_loop(TrimmedSurface& trimmed) {
  if (!open_keyword("TRIMCRV")) return false;
  TrimLoop loop;
  while (at('[')) {
    const char* const open = p_;
    ++p_;
    if (peek() != "TRIMCRVSEG") {
      std::vector<std::string> attributes;
      if (!read_attribute(attributes)) return false;
      drop_attributes(attributes);
      continue;
    }
    p_ = open;
    if (!open_keyword("TRIMCRVSEG")) return false;
    std::vector<std::string> attributes;
    if (!read_attributes(attributes)) return false;
    drop_attributes(attributes);
    TrimCurve piece;
    if (!read_inner("CURVE", piece.parameter)) return false;
    if (at('[') && !read_inner("CURVE", piece.space)) return false;
    if (!take_bracket(']')) return false;
    loop.push_back(std::move(piece));
  }
  trimmed.loops.push_back(std::move(loop));
  return take_bracket(']');
}

bool ItdReader::read_trimmed(SplineEntity& entity) {
  std::optional<ExactSurface> surface;
  if (!read_attributes(entity.attributes) || !read_inner("SURFACE", surface)) return false;
  TrimmedSurface trimmed{std::move(*surface), {}};
  while (at('['))
    if (!read_trim_loop(trimmed)) return false;
  entity.shape = std::move(trimmed);
  return take_bracket(']');
}

bool ItdReader::read_model_face(SplineBrep& brep) {
  std::uint64_t num_loops = 0;
  std::optional<ExactSurface> surface;
  if (!open_keyword("MDLTSRF") || !read_count("a number of loops", 0, bytes_left(), num_loops) ||
      !read_inner("SURFACE", surface))
    return false;
  BrepFace face{std::move(*surface), {}};
  for (std::uint64_t i = 0; i < num_loops; ++i) {
    if (!open_keyword("MDLLOOP")) return false;
    auto& loop = face.loops.emplace_back();
    while (!at(']')) {
      loop.emplace_back();
      if (!read_integer("a segment's number", loop.back())) return false;
    }
    ++p_;
  }
  brep.faces.push_back(std::move(face));
  return take_bracket(']');
}

bool ItdReader::read_model_segment(SplineBrep& brep) {
  std::uint64_t mask = 0;
  BrepSegment segment;
  if (!open_keyword("MDLTSEG") || !read_count("a mask of curves", 0, 7, mask) ||
      !read_count("a surface's number", 0, brep.faces.size(), segment.faces[0]) ||
      !read_count("a surface's number", 0, brep.faces.size(), segment.faces[1]))
    return false;
  if ((mask & 1) != 0 && !read_inner("CURVE", segment.parameter[0])) return false;
  if ((mask & 2) != 0 && !read_inner("CURVE", segment.parameter[1])) return false;
  if ((mask & 4) != 0 && !read_inner("CURVE", segment.space)) return false;
  brep.segments.push_back(std::move(segment));
  return take_bracket(']');
}

bool ItdReader::check_model(const char* open, const SplineBrep& brep) {
  const auto most = static_cast<std::int64_t>(brep.segments.size());
  for (const BrepFace& face : brep.faces)
    for (const auto& loop : face.loops)
      for (const std::int64_t number : loop)
        if (number == 0 || number > most || number < -most)
          return fail(
              open, Code::kIndexOutOfRange,
              "a loop names segment " + std::to_string(number) + " of " + std::to_string(most));
  return true;
}

bool ItdReader::read_model(SplineEntity& entity) {
  const char* const open = p_;
  std::uint64_t num_faces = 0, num_segments = 0;
  if (!read_attributes(entity.attributes) ||
      !read_count("a number of surfaces", 0, bytes_left(), num_faces) ||
      !read_count("a number of segments", 0, bytes_left(), num_segments))
    return false;
  SplineBrep brep;
  while (brep.faces.size() < num_faces)
    if (!read_model_face(brep)) return false;
  while (brep.segments.size() < num_segments)
    if (!read_model_segment(brep)) return false;
  if (!take_bracket(']') || !check_model(open, brep)) return false;
  entity.shape = std::move(brep);
  return true;
}

struct Skipped {
  const char* keyword;
  const char* what;
  bool is_geometry;
};
constexpr Skipped kSkipped[] = {
    {"POLYGON", "polygons", true},
    {"POLYLINE", "polylines", true},
    {"POINTLIST", "point lists", true},
    {"POLYSTRIP", "polygon strips", true},
    {"TRISRF", "triangular patches", true},
    {"INSTANCE", "instances of objects", true},
    {"NUMBER", "numbers", false},
    {"STRING", "strings", false},
    {"POINT", "points", false},
    {"VECTOR", "vectors", false},
    {"PLANE", "planes", false},
    {"MATRIX", "matrices", false},
    {"CTLPT", "control points", false},
};

bool ItdReader::add(SplineEntity entity) {
  if (!open_.empty()) entity.group = open_.back().group;
  return end_entity(std::move(entity));
}

// Starts after the keyword. is_data: it was an entity, or something that is known to be left out.
bool ItdReader::read_data(const char* open, const std::string& keyword, bool& is_data) {
  is_data = true;
  for (const Skipped& s : kSkipped)
    if (keyword == s.keyword) {
      leave_out(s.what, "", s.is_geometry);
      return skip_brackets();
    }
  SplineEntity entity = begin_entity(open);
  if (keyword == "CURVE") {
    std::optional<ExactCurve> curve;
    if (!read_spline(open, curve, entity.attributes)) return false;
    entity.shape = std::move(*curve);
  } else if (keyword == "SURFACE") {
    std::optional<ExactSurface> surface;
    if (!read_spline(open, surface, entity.attributes)) return false;
    entity.shape = std::move(*surface);
  } else if (keyword == "TRIVAR") {
    std::optional<ExactVolume> volume;
    if (!read_spline(open, volume, entity.attributes)) return false;
    entity.shape = std::move(*volume);
  } else if (keyword == "TRIMSRF") {
    if (!read_trimmed(entity)) return false;
  } else if (keyword == "MODEL") {
    if (!read_model(entity)) return false;
  } else if (keyword == "MULTIVAR") {
    bool is_known = true;
    if (!read_multivariate(open, entity, is_known)) return false;
    if (!is_known) {
      entity_.reset();
      return true;
    }
  } else {
    entity_.reset();
    is_data = false;
    return true;
  }
  return add(std::move(entity));
}

// Reads an item of an object: an attribute, data, another object, its name, or its end.
bool ItdReader::read_object_item() {
  Open& object = open_.back();
  if (at(']')) {
    ++p_;
    open_.pop_back();
    return true;
  }
  if (at('"')) {
    const char* const start = p_;
    if (!skip_string()) return false;
    if (std::exchange(object.has_name, true))
      return fail(start, Code::kSyntax, "a second name of an object");
    model_.groups[*object.group].name =
        to_utf8({start + 1, static_cast<std::size_t>(p_ - start) - 2});
    return true;
  }
  if (!at('[')) {
    skip();
    const char* const start = p_;
    std::string word;
    if (!take_word(word)) return false;
    if (std::exchange(object.has_name, true))
      return fail(start, Code::kSyntax, "a second name of an object: " + quoted(word));
    model_.groups[*object.group].name = to_utf8(word);
    return true;
  }
  const char* const open = p_++;
  const std::string keyword(peek());
  const char* const word_at = p_;
  p_ += keyword.size();
  if (keyword == "OBJECT") {
    model_.groups.push_back({"", {}, object.group});
    open_.push_back({model_.groups.size() - 1, false, open});
    return true;
  }
  bool is_data = false;
  if (!read_data(open, keyword, is_data)) return false;
  if (is_data) return true;
  p_ = word_at;
  return read_attribute(model_.groups[*object.group].attributes);
}

bool ItdReader::read() {
  // A file of comments only is not a model without splines: it was cut off, or is something else.
  if (std::find(p_, source_.end, '[') == source_.end) return fail_expected("'['");
  for (;;) {
    if (!open_.empty()) {
      if (is_at_end()) return fail(open_.back().at, Code::kTruncated, "an object is not closed");
      if (!read_object_item()) return false;
      continue;
    }
    while (p_ < source_.end && *p_ != '[') ++p_;  // comments between objects
    if (p_ >= source_.end) return true;
    const char* const open = p_++;
    const std::string keyword(peek());
    p_ += keyword.size();
    if (keyword == "OBJECT") {
      model_.groups.push_back({});
      open_.push_back({model_.groups.size() - 1, false, open});
      continue;
    }
    bool is_data = false;
    if (!read_data(open, keyword, is_data)) return false;
    if (!is_data)
      return fail(open, Code::kSyntax,
                  "OBJECT or a kind of data expected, but there is " + quoted(keyword));
  }
}

// Drops groups without splines (cameras, numbers); keeps the order of the rest.
SplineFile ItdReader::take() {
  std::vector<bool> is_used(model_.groups.size());
  for (const SplineEntity& e : model_.entities)
    for (auto g = e.group; g && !is_used[*g]; g = model_.groups[*g].parent) is_used[*g] = true;
  std::vector<std::size_t> renamed(model_.groups.size());
  SplineModel model;
  for (std::size_t g = 0; g < model_.groups.size(); ++g) {
    if (!is_used[g]) {
      leave_out("groups without splines", "", false);
      continue;
    }
    renamed[g] = model.groups.size();
    SplineGroup& group = model_.groups[g];
    if (group.parent) group.parent = renamed[*group.parent];
    model.groups.push_back(std::move(group));
  }
  for (SplineEntity& e : model_.entities)
    if (e.group) e.group = renamed[*e.group];
  model.entities = std::move(model_.entities);
  model_ = std::move(model);
  return ItdSplineReader::take();
}

}  // namespace

Result<SplineFile> read_itd(const Source& source, const ReadLimits& limits) {
  return run_reader<ItdReader>(source, limits);
}

}  // namespace veritope
