// SPDX-License-Identifier: LGPL-3.0-or-later
// IRIT's .itd: a tree of [OBJECT attributes name data] with curves, surfaces, trimmed surfaces, trivariates, models.
// Brackets, quoted strings and words are the tokens; text before the first bracket of an object is a comment.
#include <algorithm>

#include "io/spline_text_reader.h"

namespace veritope {
namespace {

enum class Basis { kBezier, kBspline, kPower };

// What stands behind CURVE, SURFACE or TRIVAR, before the knots.
template <std::size_t N>
struct Header {
  Basis basis = Basis::kBspline;
  RawSpline<N> raw;
  std::array<std::uint64_t, N> orders{};
};

class ItdReader : SplineTextReader {
 public:
  ItdReader(const Source& source, const ReadLimits& limits) : SplineTextReader(source, limits) {
    own_tokens_ = "[]\"";
  }
  using SplineTextReader::take_error;

  bool read();
  SplineFile take();

 private:
  bool at(char c) { return peek() == std::string_view(&c, 1); }
  bool take_bracket(char c);
  bool take_word(std::string& word);
  bool open_keyword(const char* keyword);
  bool skip_string();
  /// From behind an opening bracket to behind its closing one.
  bool skip_brackets();
  bool read_attribute(std::vector<std::string>& into);
  bool read_attributes(std::vector<std::string>& into);
  void count_splines_in(std::string_view attribute);
  void drop_attributes(const std::vector<std::string>& inner);

  bool read_element(const char* open, std::string_view keyword, bool& is_data);
  bool read_object_item();
  bool read_data(const char* open, const std::string& keyword, bool& is_data);
  bool add(const char* open, SplineEntity entity);

  template <std::size_t N>
  bool read_header(Header<N>& header, std::vector<std::string>& attributes);
  bool read_point_type(int& components, bool& is_rational);
  template <std::size_t N>
  bool read_knots(Header<N>& header);
  template <std::size_t N>
  bool read_points(RawSpline<N>& raw);
  /// From behind the keyword to behind the closing bracket.
  template <std::size_t N>
  bool read_spline(const char* open, std::optional<BSpline<Rational, N>>& spline,
                   std::vector<std::string>& attributes);
  template <std::size_t N>
  bool read_body(const char* open, Header<N>& header, std::optional<BSpline<Rational, N>>& spline);
  /// A whole [KEYWORD ...] whose attributes are dropped.
  template <std::size_t N>
  bool read_inner(const char* keyword, std::optional<BSpline<Rational, N>>& spline);
  bool read_multivariate(const char* open, SplineEntity& entity, bool& is_known);
  template <std::size_t N>
  bool read_multivariate_of(const char* open, Basis basis, SplineEntity& entity);
  bool read_trimmed(SplineEntity& entity);
  bool read_trim_loop(TrimmedSurface& trimmed);
  bool read_model(SplineEntity& entity);
  bool read_model_face(SplineBrep& brep);
  bool read_model_segment(SplineBrep& brep);
  bool check_model(const char* open, const SplineBrep& brep);

  SplineModel model_;
  struct Open {
    std::optional<std::size_t> group;
    bool has_name = false;
    const char* at = nullptr;
  };
  std::vector<Open> open_;
};

bool ItdReader::take_bracket(char c) {
  if (!at(c)) return fail_expected(quoted(std::string_view(&c, 1)));
  ++p_;
  return true;
}

bool ItdReader::take_word(std::string& word) {
  const std::string_view token = peek();
  if (token.empty() || own_tokens_.find(token[0]) != own_tokens_.npos)
    return fail_expected("a word");
  word = std::string(token);
  p_ += token.size();
  return true;
}

bool ItdReader::open_keyword(const char* keyword) {
  if (!take_bracket('[')) return false;
  if (peek() != keyword) return fail_expected(keyword);
  p_ += std::string_view(keyword).size();
  return true;
}

bool ItdReader::skip_string() {
  const char* const start = p_++;
  for (; p_ < source_.end && *p_ != '"'; ++p_)
    if (*p_ == '\\' && p_ + 1 < source_.end) ++p_;
  if (p_ >= source_.end) return fail(start, Code::kTruncated, "a string does not end");
  ++p_;
  return true;
}

bool ItdReader::skip_brackets() {
  const char* const start = p_;
  for (std::uint64_t depth = 1; depth > 0;) {
    while (p_ < source_.end && *p_ != '[' && *p_ != ']' && *p_ != '"') ++p_;
    if (p_ >= source_.end) return fail(start, Code::kTruncated, "a '[' is not closed");
    if (*p_ == '"') {
      if (!skip_string()) return false;
      continue;
    }
    depth += *p_ == '[' ? 1u : ~std::uint64_t{0};
    ++p_;
  }
  return true;
}

// From behind its '['.
bool ItdReader::read_attribute(std::vector<std::string>& into) {
  skip();
  const char* const start = p_;
  if (!skip_brackets()) return false;
  const char* last = p_ - 1;
  while (last > start && has_class(last[-1], kTokenEnd)) --last;
  into.push_back(to_utf8({start, static_cast<std::size_t>(last - start)}));
  count_splines_in(into.back());
  return true;
}

// An attribute may hold whole objects (animations, textures): they stay text, but are mentioned.
void ItdReader::count_splines_in(std::string_view attribute) {
  constexpr std::pair<std::string_view, const char*> kWords[] = {
      {"CURVE ", "curves within attributes"},
      {"SURFACE ", "surfaces within attributes"},
      {"TRIVAR ", "volumes within attributes"}};
  for (std::size_t at = attribute.find('['); at != attribute.npos; at = attribute.find('[', at + 1))
    for (const auto& [word, what] : kWords)
      if (attribute.substr(at + 1).starts_with(word)) leave_out(what, "kept as text", false);
}

bool ItdReader::read_attributes(std::vector<std::string>& into) {
  while (at('[')) {
    const char* const open = p_++;
    const std::string_view word = peek();
    if (word == "KV" || word == "KVP" || word == "SURFACE" || word == "TRIMCRV" ||
        word == "CURVE") {
      p_ = open;
      return true;
    }
    if (!read_attribute(into)) return false;
  }
  return true;
}

void ItdReader::drop_attributes(const std::vector<std::string>& inner) {
  if (!inner.empty())
    leave_out("attributes within trimmed surfaces and models", "", false, inner.size());
}

bool ItdReader::read_point_type(int& components, bool& is_rational) {
  const std::string_view token = peek();
  const bool is_type = token.size() == 2 && (token[0] == 'E' || token[0] == 'P') &&
                       token[1] >= '1' && token[1] <= '9';
  if (!is_type) return fail_expected("a point type, E1 to E9 or P1 to P9,");
  is_rational = token[0] == 'P';
  components = token[1] - '0' + (is_rational ? 1 : 0);
  p_ += 2;
  return true;
}

template <std::size_t N>
bool ItdReader::read_header(Header<N>& header, std::vector<std::string>& attributes) {
  std::string word;
  skip();
  const char* const start = p_;
  if (!take_word(word)) return false;
  if (word == "BEZIER") {
    header.basis = Basis::kBezier;
  } else if (word == "POWER") {
    header.basis = Basis::kPower;
  } else if (word != "BSPLINE") {
    return fail(start, Code::kSyntax,
                "BSPLINE, BEZIER or POWER expected, but there is " + quoted(word));
  }
  if (!read_attributes(attributes)) return false;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  for (auto& count : header.raw.num_control)
    if (!read_count("a number of control points", 1, kMost, count)) return false;
  header.orders = header.raw.num_control;
  if (header.basis == Basis::kBspline)
    for (auto& order : header.orders)
      if (!read_count("an order", 1, kMost, order)) return false;
  return read_point_type(header.raw.num_components, header.raw.is_rational);
}

template <std::size_t N>
bool ItdReader::read_knots(Header<N>& header) {
  for (std::size_t a = 0; a < N; ++a) {
    if (!take_bracket('[')) return false;
    const std::string_view word = peek();
    const bool is_periodic = word == "KVP";
    if (!is_periodic && word != "KV") return fail_expected("KV or KVP");
    p_ += word.size();
    const std::uint64_t order = header.orders[a];
    const std::uint64_t count = header.raw.num_control[a] + order + (is_periodic ? order - 1 : 0);
    if (!check_announced(count, "knots")) return false;
    header.raw.is_periodic[a] = is_periodic;
    auto& knots = header.raw.knots[a];
    for (knots.reserve(count); knots.size() < count;) {
      if (at(']'))
        return fail(p_, Code::kBadSpline,
                    std::to_string(knots.size()) + " knots instead of " + std::to_string(count) +
                        " for " + std::to_string(header.raw.num_control[a]) +
                        " control points of order " + std::to_string(order));
      knots.emplace_back();
      if (!read_number(knots.back())) return false;
    }
    if (!take_bracket(']')) return false;
  }
  return true;
}

template <std::size_t N>
bool ItdReader::read_points(RawSpline<N>& raw) {
  std::uint64_t total = 0;
  const auto components = static_cast<std::uint64_t>(raw.num_components);
  if (!check_grid(raw.num_control, components, total)) return false;
  raw.points.resize(total);
  for (std::uint64_t i = 0; i < total; i += components) {
    if (!take_bracket('[')) return false;
    // IRIT lists the weight first.
    for (std::uint64_t c = 0; c < components; ++c) {
      const std::uint64_t to = !raw.is_rational ? c : c == 0 ? components - 1 : c - 1;
      if (!read_number(raw.points[i + to])) return false;
    }
    if (!take_bracket(']')) return false;
  }
  return true;
}

template <std::size_t N>
bool ItdReader::read_body(const char* open, Header<N>& header,
                          std::optional<BSpline<Rational, N>>& spline) {
  RawSpline<N>& raw = header.raw;
  for (std::size_t a = 0; a < N; ++a) {
    if (header.orders[a] > raw.num_control[a])
      return fail(open, Code::kBadSpline,
                  "the order " + std::to_string(header.orders[a]) +
                      " is larger than the number of control points, " +
                      std::to_string(raw.num_control[a]));
    if (header.orders[a] > kMaxSplineDegree + 1)
      return fail(open, Code::kOverLimit,
                  "the degree " + std::to_string(header.orders[a] - 1) + " is over the limit " +
                      std::to_string(kMaxSplineDegree));
    raw.degrees[a] = static_cast<int>(header.orders[a]) - 1;
    if (header.basis != Basis::kBspline) raw.knots[a] = bezier_knots(raw.degrees[a]);
  }
  if (header.basis == Basis::kBspline && !read_knots(header)) return false;
  if (!read_points(raw) || !take_bracket(']')) return false;
  if (header.basis == Basis::kPower && !power_to_bernstein(raw, budget_))
    return fail(open, Code::kOverLimit, budget_.message() + ", in Bernstein's basis");
  spline = build(open, std::move(raw));
  return spline.has_value();
}

template <std::size_t N>
bool ItdReader::read_spline(const char* open, std::optional<BSpline<Rational, N>>& spline,
                            std::vector<std::string>& attributes) {
  Header<N> header;
  return read_header(header, attributes) && read_body(open, header, spline);
}

template <std::size_t N>
bool ItdReader::read_inner(const char* keyword, std::optional<BSpline<Rational, N>>& spline) {
  skip();
  const char* const open = p_;
  std::vector<std::string> attributes;
  if (!open_keyword(keyword) || !read_spline(open, spline, attributes)) return false;
  drop_attributes(attributes);
  return true;
}

template <std::size_t N>
bool ItdReader::read_multivariate_of(const char* open, Basis basis, SplineEntity& entity) {
  Header<N> header;
  header.basis = basis;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  for (auto& count : header.raw.num_control)
    if (!read_count("a number of control points", 1, kMost, count)) return false;
  header.orders = header.raw.num_control;
  if (basis == Basis::kBspline)
    for (auto& order : header.orders)
      if (!read_count("an order", 1, kMost, order)) return false;
  if (!read_point_type(header.raw.num_components, header.raw.is_rational)) return false;
  std::optional<BSpline<Rational, N>> spline;
  if (!read_body(open, header, spline)) return false;
  entity.shape = std::move(*spline);
  return true;
}

bool ItdReader::read_multivariate(const char* open, SplineEntity& entity, bool& is_known) {
  std::string word;
  if (!take_word(word)) return false;
  const Basis basis = word == "BEZIER"  ? Basis::kBezier
                      : word == "POWER" ? Basis::kPower
                                        : Basis::kBspline;
  if (basis == Basis::kBspline && word != "BSPLINE")
    return fail(open, Code::kSyntax,
                "BSPLINE, BEZIER or POWER expected, but there is " + quoted(word));
  if (!read_attributes(entity.attributes)) return false;
  std::uint64_t dimension = 0;
  if (!read_count("a number of parameters", 1, 1000, dimension)) return false;
  is_known = dimension <= 3;
  if (dimension == 1) return read_multivariate_of<1>(open, basis, entity);
  if (dimension == 2) return read_multivariate_of<2>(open, basis, entity);
  if (dimension == 3) return read_multivariate_of<3>(open, basis, entity);
  leave_out("multivariates of " + std::to_string(dimension) + " parameters", "at most 3 are known",
            true);
  return skip_brackets();
}

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

bool ItdReader::add(const char* open, SplineEntity entity) {
  if (!open_.empty()) entity.group = open_.back().group;
  entity.place = place_of(open);
  model_.entities.push_back(std::move(entity));
  entity_.reset();
  return true;
}

// The cursor is behind the keyword. is_data: it was an entity or something known to be left out.
bool ItdReader::read_data(const char* open, const std::string& keyword, bool& is_data) {
  is_data = true;
  for (const Skipped& s : kSkipped)
    if (keyword == s.keyword) {
      leave_out(s.what, "", s.is_geometry);
      return skip_brackets();
    }
  SplineEntity entity{
      ExactCurve({KnotAxis<Rational>{1, bezier_knots(1)}}, 0, false, {}), {}, {}, {}};
  entity_ = model_.entities.size();
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
  return add(open, std::move(entity));
}

// What stands within an object: an attribute, data, another object, its name, or its end.
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
  // A file of comments only is no model without splines: it was cut off, or is something else.
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

// Groups without splines (cameras, numbers) go; the rest keeps its order.
SplineFile ItdReader::take() {
  std::vector<bool> is_used(model_.groups.size());
  for (const SplineEntity& e : model_.entities)
    for (auto g = e.group; g && !is_used[*g]; g = model_.groups[*g].parent) is_used[*g] = true;
  std::vector<std::size_t> renamed(model_.groups.size());
  SplineFile file;
  for (std::size_t g = 0; g < model_.groups.size(); ++g) {
    if (!is_used[g]) {
      leave_out("groups without splines", "", false);
      continue;
    }
    renamed[g] = file.model.groups.size();
    SplineGroup& group = model_.groups[g];
    if (group.parent) group.parent = renamed[*group.parent];
    file.model.groups.push_back(std::move(group));
  }
  for (SplineEntity& e : model_.entities)
    if (e.group) e.group = renamed[*e.group];
  file.model.entities = std::move(model_.entities);
  file.left_out = std::move(left_out_);
  return file;
}

}  // namespace

Result<SplineFile> read_itd(const Source& source, const ReadLimits& limits) {
  ItdReader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  return reader.take();
}

}  // namespace veritope
