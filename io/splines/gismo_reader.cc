// SPDX-License-Identifier: LGPL-3.0-or-later
// G+Smo's .xml: <Geometry type="BSpline|Nurbs|TensorBSpline2|TensorNurbs3|..."> with a tree of <Basis>, its
// <KnotVector>s, <weights> and <coefs>. Coefficients are not multiplied by the weights, the first axis runs fastest.
#include <algorithm>
#include <charconv>

#include "io/splines/spline_text_reader.h"

namespace veritope {
namespace {

struct Tag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool is_end = false;    // </name>
  bool is_empty = false;  // <name/>
  const char* at = nullptr;

  std::string_view attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes)
      if (key == wanted) return value;
    return {};
  }
};

struct KnotList {
  int degree = 0;
  std::vector<Rational> knots;
  const char* at = nullptr;
};

// What a <Geometry> holds, before its type is known to fit.
struct Geometry {
  std::string_view type;
  const char* at = nullptr;
  std::vector<KnotList> axes;
  std::vector<Rational> weights, coefficients;
  std::uint64_t dimension = 0;
  bool has_weights = false, has_coefficients = false, has_transform = false;
};

class GismoReader : SplineTextReader {
 public:
  using SplineTextReader::SplineTextReader;
  using SplineTextReader::take;
  using SplineTextReader::take_error;

  bool read();

 private:
  /// The next tag; text before it is skipped. is_end_of_file: no tag follows.
  bool next_tag(Tag& tag, bool& is_end_of_file);
  bool read_tag(Tag& tag);
  bool read_attribute(Tag& tag);
  bool skip_comment(const char* closing, const char* what);
  /// Numbers up to the next '<'.
  bool read_text_numbers(std::vector<Rational>& into);
  bool read_geometry(const Tag& open);
  bool read_part(const Tag& tag, Geometry& geometry);
  bool read_degree(const Tag& tag, int& degree);
  template <std::size_t N>
  bool finish(Geometry geometry, SplineEntity& entity);
  bool skip_element(const Tag& open);
  bool refuse_format(const Tag& tag);

  std::vector<std::string_view> open_;
};

bool GismoReader::skip_comment(const char* closing, const char* what) {
  const std::string_view rest(p_, bytes_left());
  const std::size_t end = rest.find(closing);
  if (end == rest.npos) return fail(p_, Code::kTruncated, std::string(what) + " does not end");
  p_ += end + std::string_view(closing).size();
  return true;
}

bool is_name(char c) {
  return is_digit(c) || (static_cast<unsigned char>((c | 0x20) - 'a') < 26) || c == '_' ||
         c == '-' || c == ':' || c == '.';
}

bool GismoReader::read_attribute(Tag& tag) {
  const char* const key = p_;
  while (p_ < source_.end && is_name(*p_)) ++p_;
  const std::string_view name(key, static_cast<std::size_t>(p_ - key));
  skip();
  if (name.empty() || p_ >= source_.end || *p_ != '=') return fail_expected("an attribute and '='");
  ++p_;
  skip();
  if (p_ >= source_.end || (*p_ != '"' && *p_ != '\'')) return fail_expected("a quoted value");
  const char quote = *p_++;
  const char* const value = p_;
  while (p_ < source_.end && *p_ != quote) ++p_;
  if (p_ >= source_.end) return fail(value, Code::kTruncated, "a quoted value does not end");
  tag.attributes.emplace_back(name, std::string_view(value, static_cast<std::size_t>(p_ - value)));
  ++p_;
  return true;
}

bool GismoReader::read_tag(Tag& tag) {
  tag = Tag{};
  tag.at = p_++;
  if (p_ < source_.end && *p_ == '/') {
    tag.is_end = true;
    ++p_;
  }
  const char* const name = p_;
  while (p_ < source_.end && is_name(*p_)) ++p_;
  tag.name = {name, static_cast<std::size_t>(p_ - name)};
  if (tag.name.empty()) return fail(tag.at, Code::kSyntax, "a tag without a name");
  for (;;) {
    skip();
    if (p_ >= source_.end) return fail(tag.at, Code::kTruncated, "a tag does not end");
    if (*p_ == '>') return ++p_, true;
    if (*p_ == '/' && p_ + 1 < source_.end && p_[1] == '>') {
      tag.is_empty = true;
      p_ += 2;
      return true;
    }
    if (tag.is_end) return fail_expected("'>'");
    if (!read_attribute(tag)) return false;
  }
}

bool GismoReader::next_tag(Tag& tag, bool& is_end_of_file) {
  for (;;) {
    while (p_ < source_.end && *p_ != '<') ++p_;
    is_end_of_file = p_ >= source_.end;
    if (is_end_of_file) return true;
    const std::string_view rest(p_, bytes_left());
    if (rest.starts_with("<!--")) {
      if (!skip_comment("-->", "a comment")) return false;
    } else if (rest.starts_with("<?")) {
      if (!skip_comment("?>", "a processing instruction")) return false;
    } else if (rest.starts_with("<!")) {
      return fail(p_, Code::kSyntax, "declarations and character data are not read");
    } else {
      return read_tag(tag);
    }
  }
}

bool GismoReader::read_text_numbers(std::vector<Rational>& into) {
  for (;;) {
    skip();
    if (p_ >= source_.end) return fail_expected("a number or a tag");
    if (*p_ == '<') {
      if (!std::string_view(p_, bytes_left()).starts_with("<!--")) return true;
      if (!skip_comment("-->", "a comment")) return false;
      continue;
    }
    into.emplace_back();
    if (!read_number(into.back())) return false;
  }
}

bool GismoReader::read_degree(const Tag& tag, int& degree) {
  const std::string_view text = tag.attribute("degree");
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), degree);
  if (error != std::errc() || end != text.data() + text.size())
    return fail(tag.at, Code::kSyntax,
                "a knot vector's degree must be an integer, not " + quoted(text));
  if (degree > kMaxSplineDegree)
    return fail(tag.at, Code::kOverLimit,
                "the degree " + std::to_string(degree) + " is over the limit " +
                    std::to_string(kMaxSplineDegree));
  return true;
}

bool GismoReader::refuse_format(const Tag& tag) {
  const std::string_view format = tag.attribute("format");
  if (!format.empty() && !is_word(format, "ascii"))
    return fail(tag.at, Code::kSyntax, "numbers in the format " + quoted(format) + " are not read");
  if (!tag.attribute("order").empty() || !tag.attribute("mode").empty())
    return fail(tag.at, Code::kSyntax, "the attributes order and mode are not read");
  return true;
}

// Reads an element within <Geometry>; tags of bases are skipped, and their knots kept in order.
bool GismoReader::read_part(const Tag& tag, Geometry& g) {
  if (tag.name == "Geometry")
    return fail(tag.at, Code::kSyntax, "a <Geometry> within a <Geometry> is not read");
  if (tag.name == "Basis") {
    const std::string_view type = tag.attribute("type");
    if (type.starts_with("H") || type.starts_with("TH") || type.find("HTensor") != type.npos)
      return fail(tag.at, Code::kSyntax, "hierarchical bases are not read: " + quoted(type));
    return true;
  }
  if (tag.name == "transform") {
    g.has_transform = true;
    return true;
  }
  if (tag.is_empty || (tag.name != "KnotVector" && tag.name != "weights" && tag.name != "coefs"))
    return true;
  if (!refuse_format(tag)) return false;
  ends_ = kTokenEnd;
  own_tokens_ = "<";
  bool ok = true;
  if (tag.name == "KnotVector") {
    KnotList list;
    list.at = tag.at;
    ok = read_degree(tag, list.degree) && read_text_numbers(list.knots);
    g.axes.push_back(std::move(list));
  } else if (tag.name == "weights") {
    g.has_weights = true;
    ok = read_text_numbers(g.weights);
  } else {
    g.has_coefficients = true;
    const std::string_view text = tag.attribute("geoDim");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), g.dimension);
    if (error != std::errc() || end != text.data() + text.size() || g.dimension < 1 ||
        g.dimension > 1000)
      return fail(tag.at, Code::kSyntax, "geoDim must be from 1 to 1000, not " + quoted(text));
    ok = read_text_numbers(g.coefficients);
  }
  own_tokens_ = {};
  return ok;
}

template <std::size_t N>
bool GismoReader::finish(Geometry g, SplineEntity& entity) {
  if (g.axes.size() != N)
    return fail(
        g.at, Code::kBadSpline,
        std::to_string(g.axes.size()) + " knot vectors for " + std::to_string(N) + " parameters");
  RawSpline<N> raw;
  std::uint64_t total = 1;
  for (std::size_t a = 0; a < N; ++a) {
    const auto order = static_cast<std::uint64_t>(std::max(g.axes[a].degree, 0)) + 1;
    if (g.axes[a].knots.size() <= order)
      return fail(g.axes[a].at, Code::kBadSpline,
                  std::to_string(g.axes[a].knots.size()) + " knots are too few for the degree " +
                      std::to_string(g.axes[a].degree));
    raw.num_control[a] = g.axes[a].knots.size() - order;
    raw.degrees[a] = g.axes[a].degree;
    raw.knots[a] = std::move(g.axes[a].knots);
    // Each count is below the size of the file; so is the product of valid ones.
    if (raw.num_control[a] > source_.size() / total) {
      total = source_.size() + 1;
      break;
    }
    total *= raw.num_control[a];
  }
  if (g.coefficients.size() / g.dimension != total || g.coefficients.size() % g.dimension != 0)
    return fail(g.at, Code::kBadSpline,
                std::to_string(g.coefficients.size()) + " coefficients of dimension " +
                    std::to_string(g.dimension) + " do not fit the knots");
  if (g.has_weights && g.weights.size() != total)
    return fail(g.at, Code::kBadSpline,
                std::to_string(g.weights.size()) + " weights for " + std::to_string(total) +
                    " control points");
  raw.is_rational = g.has_weights;
  raw.num_components = static_cast<int>(g.dimension) + (g.has_weights ? 1 : 0);
  if (!g.has_weights) {
    raw.points = std::move(g.coefficients);
  } else {
    for (std::uint64_t i = 0; i < total; ++i) {
      for (std::uint64_t c = 0; c < g.dimension; ++c) {
        Rational& x = g.coefficients[i * g.dimension + c];
        if (!multiply(g.at, x, g.weights[i])) return false;
        raw.points.push_back(std::move(x));
      }
      raw.points.push_back(g.weights[i]);
    }
  }
  auto spline = build(g.at, std::move(raw));
  if (!spline) return false;
  entity.shape = std::move(*spline);
  return true;
}

// Skips an element with its content.
bool GismoReader::skip_element(const Tag& open) {
  if (open.is_empty) return true;
  for (std::uint64_t depth = 1; depth > 0;) {
    Tag tag;
    bool is_end_of_file = false;
    if (!next_tag(tag, is_end_of_file)) return false;
    if (is_end_of_file)
      return fail(open.at, Code::kTruncated, "<" + escaped(open.name) + "> is not closed");
    if (!tag.is_empty) depth += tag.is_end ? ~std::uint64_t{0} : 1u;
  }
  return true;
}

bool GismoReader::read_geometry(const Tag& open) {
  constexpr std::pair<std::string_view, int> kTypes[] = {
      {"BSpline", 1},        {"Nurbs", 1},        {"TensorBSpline1", 1}, {"TensorNurbs1", 1},
      {"TensorBSpline2", 2}, {"TensorNurbs2", 2}, {"TensorBSpline3", 3}, {"TensorNurbs3", 3}};
  Geometry geometry;
  geometry.type = open.attribute("type");
  geometry.at = open.at;
  const auto* const known = std::find_if(std::begin(kTypes), std::end(kTypes),
                                         [&](const auto& t) { return t.first == geometry.type; });
  if (known == std::end(kTypes)) {
    const bool has_type = !geometry.type.empty();
    leave_out(
        has_type ? "geometries of type " + escaped(geometry.type) : "geometries without a type",
        has_type ? "this type is not known here" : "", true);
    return skip_element(open);
  }
  SplineEntity entity = begin_entity(open.at);
  const std::string_view label = open.attribute("label"), id = open.attribute("id");
  if (!id.empty()) entity.attributes.push_back("id " + to_utf8(id));
  if (!label.empty()) {
    entity.group = model_.groups.size();
    model_.groups.push_back({to_utf8(label), {}, {}});
  }
  std::vector<std::string_view> inner;
  for (Tag tag; !open.is_empty;) {
    bool is_end_of_file = false;
    if (!next_tag(tag, is_end_of_file)) return false;
    if (is_end_of_file) return fail(open.at, Code::kTruncated, "<Geometry> is not closed");
    if (tag.is_end) {
      const std::string_view expected = inner.empty() ? std::string_view("Geometry") : inner.back();
      if (tag.name != expected)
        return fail(tag.at, Code::kSyntax,
                    "</" + escaped(expected) + "> expected, not </" + escaped(tag.name) + ">");
      if (inner.empty()) break;
      inner.pop_back();
      continue;
    }
    if (!tag.is_empty) inner.push_back(tag.name);
    if (!read_part(tag, geometry)) return false;
  }
  if (!geometry.has_coefficients)
    return fail(open.at, Code::kSyntax, "a <Geometry> without <coefs>");
  if (geometry.has_transform)
    return fail(open.at, Code::kSyntax, "a <transform> of a geometry is not read");
  const bool is_nurbs = geometry.type.find("Nurbs") != geometry.type.npos;
  if (is_nurbs != geometry.has_weights)
    return fail(
        open.at, Code::kSyntax,
        std::string(is_nurbs ? "no" : "unexpected") + " <weights> of " + quoted(geometry.type));
  const bool ok = known->second == 1   ? finish<1>(std::move(geometry), entity)
                  : known->second == 2 ? finish<2>(std::move(geometry), entity)
                                       : finish<3>(std::move(geometry), entity);
  return ok && end_entity(std::move(entity));
}

bool GismoReader::read() {
  skip();
  if (p_ >= source_.end || *p_ != '<') return fail_expected("XML");
  bool has_root = false;
  for (;;) {
    Tag tag;
    bool is_end_of_file = false;
    if (!next_tag(tag, is_end_of_file)) return false;
    if (is_end_of_file) break;
    if (!has_root && !tag.is_end && tag.name != "xml" && tag.name != "Geometry")
      return fail(tag.at, Code::kForeignFormat,
                  "a G+Smo file begins with <xml>, and this one with <" + escaped(tag.name) + ">");
    has_root = true;
    if (tag.is_end) {
      if (open_.empty() || open_.back() != tag.name)
        return fail(tag.at, Code::kSyntax, "</" + escaped(tag.name) + "> closes nothing");
      open_.pop_back();
    } else if (tag.name == "Geometry") {
      if (!read_geometry(tag)) return false;
    } else if (tag.name == "xml") {
      if (!tag.is_empty) open_.push_back(tag.name);
    } else {
      leave_out("elements <" + escaped(tag.name) + ">", "", false);
      if (!skip_element(tag)) return false;
    }
  }
  if (!has_root) return fail(p_, Code::kTruncated, "there is no element");
  if (!open_.empty())
    return fail(p_, Code::kTruncated, "<" + escaped(open_.back()) + "> is not closed");
  return true;
}

}  // namespace

Result<SplineFile> read_gismo(const Source& source, const ReadLimits& limits) {
  return run_reader<GismoReader>(source, limits);
}

}  // namespace veritope
