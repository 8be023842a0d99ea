// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_reader.cc: docs/certificates/reading-rule-1.md, section by section, except merging.
#include <sstream>

#include "mesh.h"
#include "../common/numbers.h"

namespace {

// PLY types are numbers from 0 to 7, with two names each; even numbers of integer types are signed.
const char* const kTypes[16] = {"char",   "int8",    "uchar",  "uint8",  "short", "int16",
                                "ushort", "uint16",  "int",    "int32",  "uint",  "uint32",
                                "float",  "float32", "double", "float64"};
const int kSize[8] = {1, 1, 2, 2, 4, 4, 4, 8}, kFloat = 6, kScalar = 8;
enum { kFace = 3, kStrips = 4, kOther = 5 };  // roles of PLY properties; 0, 1, 2 are x, y, z
struct Property {
  int count, type, role;  // count: the type of a list's count, or kScalar
};
struct Element {
  std::string name;
  int64_t count;
  std::vector<Property> properties;
};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_end(char c) { return c == '\n' || c == '\r'; }

struct Reader {
  std::string text;
  const char *begin, *end, *p, *at;  // the text; the place, and what a message points at
  bool binary = false, big = false;
  Model model;
  std::vector<uint32_t> corners;  // the current polygon's or strip's
  int64_t top_index = -1;         // the greatest index so far, and its place
  const char* top_at = nullptr;

  [[noreturn]] void refuse(const std::string& why) const {
    const auto line = 1 + std::max(std::count(begin, at, '\n'), std::count(begin, at, '\r'));
    const char* e = at;
    while (e != end && e - at < 40 && !is_blank(*e) && !is_end(*e)) ++e;
    throw Refused{binary ? "byte " + std::to_string(at - begin) + ": " + why
                         : "line " + std::to_string(line) + ": " + why + ", found '" +
                               std::string(at, e) + "'"};
  }

  void clean(bool joins) {  // '#' comments become blanks, a backslash joins lines
    size_t n = 0;
    bool comment = false;
    for (size_t i = 0; i < text.size(); ++i) {
      if (joins && text[i] == '\\' && is_end(text[i + 1])) {
        i += text.compare(i + 1, 2, "\r\n") == 0 ? 2 : 1;
        continue;
      }
      comment = !is_end(text[i]) && (comment || text[i] == '#');
      text[n++] = comment ? ' ' : text[i];
    }
    text.resize(n);
  }
  std::string word(bool any_line = true) {  // of the file or line; empty: no more words
    while (p != end && (is_blank(*p) || (any_line && is_end(*p)))) ++p;
    at = p;
    while (p != end && !is_blank(*p) && !is_end(*p)) ++p;
    return std::string(at, p);
  }
  std::string keyword() {  // STL's, in upper or lower case
    std::string s = word();
    for (char& c : s) c = c >= 'A' && c <= 'Z' ? char(c + 32) : c;
    return s;
  }
  void skip_line() {
    while (p != end && !is_end(*p)) ++p;
  }
  void expect(const std::string& found, const char* name) const {
    if (found != name) refuse(std::string("expected ") + name);
  }
  int64_t integer(const std::string& s) const {  // no index or count can be beyond +-2^40
    size_t i = s[0] == '+' || s[0] == '-' ? 1 : 0;
    int64_t v = i < s.size() ? 0 : -1;
    for (; i < s.size() && s[i] >= '0' && s[i] <= '9'; ++i)
      v = std::min<int64_t>(10 * v + (s[i] - '0'), int64_t(1) << 40);
    if (i < s.size() || v < 0) refuse("expected an integer");
    return s[0] == '-' ? -v : v;
  }

  // Values of a PLY type, in binary or as a word.
  uint64_t raw(int type) {
    const int size = kSize[type];
    at = p;
    if (end - p < size) refuse("the file ends too early");
    uint64_t v = 0;
    for (int i = 0; i < size; ++i) v |= uint64_t(uint8_t(p[big ? size - 1 - i : i])) << 8 * i;
    p += size;
    return v;
  }
  int64_t whole(int type) {
    if (!binary) return integer(word());
    const uint64_t v = raw(type), top = uint64_t(1) << (8 * kSize[type] - 1);
    return int64_t(type % 2 == 0 ? (v ^ top) - top : v);
  }
  int64_t coordinate(int type, bool any_line = true) {  // as a key
    int64_t key = 0;
    if (!binary && decimal_to_key(word(any_line), &key)) return key;
    if (!binary) refuse("expected a finite decimal number");
    int64_t v = type < kFloat ? whole(type) : int64_t(raw(type));
    uint64_t m = magnitude(v);
    int x = 0;
    if (type >= kFloat) {
      const int fraction = type == kFloat ? 23 : 52, most = type == kFloat ? 255 : 2047;
      const int e = int(v >> fraction) & most;
      if (e == most) refuse("a coordinate is not finite");
      m = (uint64_t(v) & ((uint64_t(1) << fraction) - 1)) | uint64_t(e != 0) << fraction;
      x = std::max(e, 1) - most / 2 - fraction;
      v = v >> (8 * kSize[type] - 1) != 0 ? -1 : 0;
    }
    round_to_key(m, false, x, &key);  // exact
    return v < 0 ? -key : key;
  }

  // Triangles. Indices are compared with the number of vertices after the whole file has been read.
  void triangle(uint32_t a, uint32_t b, uint32_t c) {
    for (uint32_t v : {a, b, c}) model.tri.push_back(v);
  }
  void corner(int64_t i) {
    if (i < 0 || i >> 32 != 0) refuse("an index is out of range");
    if (i > top_index) top_index = i, top_at = at;
    corners.push_back(uint32_t(i));
  }
  void polygon() {
    if (corners.size() < 3) refuse("a polygon has fewer than three corners");
    for (size_t i = 2; i < corners.size(); ++i) triangle(corners[0], corners[i - 1], corners[i]);
    corners.clear();
  }
  void strip() {
    for (size_t k = 0; k + 2 < corners.size(); ++k) {
      const uint32_t a = corners[k + k % 2], b = corners[k + 1 - k % 2], c = corners[k + 2];
      if (a != b && b != c && c != a) triangle(a, b, c);
    }
    corners.clear();
  }

  void stl() {
    const uint64_t size = text.size();
    uint64_t facets = 0;
    for (int i = 3; i >= 0 && size >= 84; --i) facets = facets << 8 | uint8_t(begin[80 + i]);
    std::string s = keyword();
    binary = size == 84 + 50 * facets || s != "solid";
    for (; !binary && !s.empty(); s = keyword()) {
      expect(s, "solid");
      skip_line();
      for (s = keyword(); s == "facet"; s = keyword()) {
        for (int i = 0; i < 5 && !s.empty() && s != "outer"; ++i) s = keyword();
        expect(s, "outer");
        expect(keyword(), "loop");
        for (int i = 0; i < 9; ++i) {
          if (i % 3 == 0) expect(keyword(), "vertex");
          model.key.push_back(coordinate(kFloat));
        }
        expect(keyword(), "endloop");
        expect(keyword(), "endfacet");
      }
      expect(s, "endsolid");
      skip_line();
    }
    at = end;
    if (binary && size < 84 + 50 * facets)
      refuse("the file ends too early, its header says " + std::to_string(facets) + " facets");
    for (uint64_t i = 0; binary && i < 9 * facets; ++i) {
      if (i % 9 == 0) p = begin + 84 + 50 * (i / 9) + 12;
      model.key.push_back(coordinate(kFloat));
    }
    for (uint32_t v = 0; v < model.vertices(); v += 3) triangle(v, v + 1, v + 2);
  }

  void obj() {
    for (std::string s = word(); !s.empty(); skip_line(), s = word()) {
      for (int i = 0; i < 3 && s == "v"; ++i) model.key.push_back(coordinate(kFloat, false));
      if (s != "f" && s != "fo") continue;
      for (std::string c = word(false); !c.empty(); c = word(false)) {
        const int64_t i = integer(c.substr(0, c.find('/')));
        corner(i < 0 ? i + int64_t(model.vertices()) : i - 1);
      }
      polygon();
    }
  }

  void off() {
    std::string name = word();
    for (const char* prefix : {"ST", "C", "N"})
      if (name.find(prefix) == 0) name.erase(0, std::string(prefix).size());
    expect(name, "OFF");
    const int64_t vertices = whole(0), faces = whole(0);
    if (vertices < 0 || faces < 0) refuse("a count is negative");
    for (int64_t i = 0; i < 3 * vertices; ++i) {
      if (i % 3 == 0) skip_line();
      model.key.push_back(coordinate(kFloat, i % 3 == 0));
    }
    for (int64_t i = 0; i < faces; ++i) {
      skip_line();
      for (int64_t n = whole(0); n > 0; --n) corner(integer(word(false)));
      polygon();
    }
  }

  std::vector<Element> ply_header() {  // sets binary and big; p is then at the first instance
    const char* const start = p;
    expect(word(), "ply");
    const std::string line_end(p, p + (text.compare(size_t(p - begin), 2, "\r\n") == 0 ? 2 : 1));
    if (at != start || !is_end(line_end[0])) refuse("the first line is not ply");
    std::vector<Element> elements;
    std::string format;
    std::map<std::string, int> named;  // how many elements have the name
    int roles[kOther + 1] = {0};       // how many properties have the role
    for (std::vector<std::string> w; w.empty() || w[0] != "end_header";) {
      at = p += line_end.size();
      p = std::search(p, end, line_end.begin(), line_end.end());
      if (p == end || std::find_if(at, p, is_end) != p) refuse("a header line ends otherwise");
      std::istringstream stream(std::string(at, p));
      w.clear();
      for (std::string s; stream >> s;) w.push_back(s);
      if (w.empty() || (!format.empty() && (w[0] == "comment" || w[0] == "obj_info"))) continue;
      const auto type = [&](size_t i) {
        const int n = int(std::find(kTypes, kTypes + 16, w[i]) - kTypes) / 2;
        return n < 8 ? n : (refuse("unknown type " + w[i]), 0);
      };
      const bool list = w.size() == 5 && w[0] == "property" && w[1] == "list";
      if (format.empty()) {
        if (w.size() == 3 && w[0] == "format" && w[2] == "1.0") format = w[1];
        binary = format != "ascii", big = format == "binary_big_endian";
        if (binary && !big && format != "binary_little_endian") refuse("expected a format");
      } else if (w[0] == "element" && w.size() == 3) {
        elements.push_back(Element{w[1], integer(w[2]), {}});
        if (elements.back().count < 0) refuse("a count is negative");
        ++named[w[1]];
      } else if (!elements.empty() && (list || (w[0] == "property" && w.size() == 3))) {
        const std::string &element = elements.back().name, &name = w.back();
        Property q = {list ? type(2) : kScalar, type(list ? 3 : 1), kOther};
        if (list && (name == "vertex_indices" || name == "vertex_index"))
          q.role = element == "face" ? kFace : element == "tristrips" ? kStrips : kOther;
        if (!list && element == "vertex" && (name == "x" || name == "y" || name == "z"))
          q.role = name[0] - 'x';
        if (list && (q.count >= kFloat || (q.role != kOther && q.type >= kFloat)))
          refuse("a list count or an index is no integer");
        ++roles[q.role];
        elements.back().properties.push_back(q);
      } else if (w.size() != 1 || w[0] != "end_header") {
        refuse("not a line of a header");
      }
    }
    if (named["vertex"] != 1 || std::count(roles, roles + 3, 1) != 3 || roles[kFace] > 1 ||
        roles[kStrips] > 1 || roles[kFace] != named["face"] || roles[kStrips] != named["tristrips"])
      refuse("the header lacks vertex x y z or an index list, or has one twice");
    p += line_end.size();
    return elements;
  }

  void ply() {
    for (const Element& element : ply_header())
      for (int64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        int64_t xyz[3] = {0, 0, 0};
        for (const Property& q : element.properties) {
          int64_t n = q.count == kScalar ? 1 : whole(q.count);
          if (n < 0) refuse("a list count is negative");
          for (; n > 0; --n) {
            if (q.role < kFace) xyz[q.role] = coordinate(q.type);
            if (q.role == kOther && binary) raw(q.type);
            if (q.role == kOther && !binary && word().empty()) refuse("the file ends too early");
            if (q.role < kFace || q.role == kOther) continue;
            const int64_t id = whole(q.type);
            if (q.role == kFace || id != -1) corner(id);
            if (q.role == kStrips && id == -1) strip();
          }
          if (q.role == kFace) polygon();
          if (q.role == kStrips) strip();
        }
        if (element.name == "vertex") model.key.insert(model.key.end(), xyz, xyz + 3);
      }
  }
};

}  // namespace

Model read_triangles(std::string file, const std::string& format) {
  Reader r;
  r.text.swap(file);
  const bool is_marked = r.text.compare(0, 3, "\xef\xbb\xbf") == 0;  // before lines are joined
  if (format == "obj" || format == "off") r.clean(format == "obj");
  r.p = (r.begin = r.text.data()) + (is_marked ? 3 : 0);
  r.end = r.begin + r.text.size();
  if (format == "stl") r.stl();
  if (format == "obj") r.obj();
  if (format == "ply") r.ply();
  if (format == "off") r.off();
  r.at = r.end;
  if (r.model.tri.empty()) r.refuse("the file has no triangle");
  if (r.model.key.size() / 3 >= kNone || r.model.tri.size() / 3 > 1 << 30)  // NOT COVERED: 12 GB
    r.refuse("over a limit of this checker: 2^30 triangles");               // NOT COVERED: 12 GB
  r.at = r.top_at;
  if (r.top_index >= int64_t(r.model.vertices())) r.refuse("an index is out of range");
  return std::move(r.model);
}
