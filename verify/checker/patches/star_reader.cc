// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_reader.cc: spline models, docs/formats/spline-json.md. Where no claim is made about a model that has entities of
// other kinds than those asked for, their shapes are read as JSON only.
#include "star_model.h"

namespace {

const int kMostDepth = 100;   // nesting of such a shape, docs/certificates/star-box.md
const size_t kMostWord = 15;  // characters of an integer

bool is_utf8(const std::string& s) {
  for (size_t i = 0; i < s.size();) {
    const uint8_t c = uint8_t(s[i++]);
    if (c < 0x80) continue;
    if (c < 0xc0 || c >= 0xf8) return false;
    const int more = c >= 0xf0 ? 3 : c >= 0xe0 ? 2 : 1;
    uint32_t v = c & (0x3fu >> more);
    for (int k = 0; k < more; ++k, ++i) {
      if (i == s.size() || uint8_t(s[i]) >> 6 != 2) return false;
      v = v << 6 | (uint8_t(s[i]) & 0x3f);
    }
    const uint32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
    if (v < least || v > 0x10ffff || v >> 11 == 0x1b) return false;
  }
  return true;
}

struct Reader {
  const std::string& text;
  size_t& at;
  const bool has_volumes;
  uint64_t groups = 0;
  Numbers last;  // of the entity before, whose copies share them

  Reader(const std::string& file, bool volumes, size_t* begin)
      : text(file), at(*begin), has_volumes(volumes) {}
  char next() {
    for (; at < text.size(); ++at)
      if (text[at] != ' ' && text[at] != '\n' && text[at] != '\t' && text[at] != '\r')
        return text[at];
    return '\0';
  }
  bool take_if(char c) {
    const bool is = next() == c;
    at += is;
    return is;
  }
  void take(char c) {
    if (!take_if(c)) throw Refused{std::string("expected '") + c + "'"};
  }
  uint32_t hexadecimal() {  // four digits
    uint32_t v = 0;
    for (int i = 0; i < 4; ++i, ++at) {
      const int c = at < text.size() ? tolower(uint8_t(text[at])) : 0;
      expect(isxdigit(c) != 0, "no four hexadecimal digits behind \\u");
      v = 16 * v + uint32_t(isdigit(c) != 0 ? c - '0' : c - 'a' + 10);
    }
    return v;
  }
  void escaped(std::string* to) {  // after a backslash
    static const std::string kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
    const char c = at < text.size() ? text[at++] : '\0';
    const size_t known = kFrom.find(c);
    if (known != kFrom.npos) return to->push_back(kTo[known]);
    expect(c == 'u', "an unknown escape in a string");
    uint32_t v = hexadecimal();
    if (v >> 10 == 0x36) {
      expect(text.compare(at, 2, "\\u") == 0, "half of a surrogate pair");
      at += 2;
      const uint32_t low = hexadecimal();
      expect(low >> 10 == 0x37, "half of a surrogate pair");
      v = 0x10000 + ((v & 0x3ff) << 10) + (low & 0x3ff);
    }
    expect(v >> 10 != 0x37, "half of a surrogate pair");
    const int more = v < 0x80 ? 0 : v < 0x800 ? 1 : v < 0x10000 ? 2 : 3;  // bytes after the first
    const uint32_t first[] = {0, 0xc0, 0xe0, 0xf0};
    to->push_back(char(first[more] | v >> 6 * more));
    for (int k = more; k-- > 0;) to->push_back(char(0x80 | (v >> 6 * k & 0x3f)));
  }
  std::string string() {
    std::string r;
    take('"');
    for (;;) {
      expect(at < text.size(), "a string does not end");
      const char c = text[at++];
      if (c == '"') return r;
      expect(uint8_t(c) >= 32, "a control character in a string");
      if (c == '\\')
        escaped(&r);
      else
        r += c;
    }
  }
  std::string word() {  // true, false, null, an integer
    next();
    const size_t begin = at;
    while (at < text.size() && (isalnum(uint8_t(text[at])) != 0 || text[at] == '-')) ++at;
    return text.substr(begin, at - begin);
  }
  static bool is_integer(const std::string& w) {
    const size_t sign = !w.empty() && w[0] == '-';
    return w.size() <= kMostWord && is_natural(w.substr(sign));
  }
  int64_t integer() {
    const std::string w = word();
    expect(is_integer(w), "expected an integer");
    return std::stoll(w);
  }
  bool boolean() {
    const std::string w = word();
    expect(w == "true" || w == "false", "expected true or false");
    return w == "true";
  }
  void index() {  // null, or of a group read before
    if (next() == 'n') return expect(word() == "null", "expected null");
    const int64_t i = integer();
    expect(i >= 0 && uint64_t(i) < groups, "an index of a group is out of range");
  }
  template <class Item>
  void list(Item item) {
    take('[');
    if (take_if(']')) return;
    do item();
    while (take_if(','));
    take(']');
  }
  // Calls value(i) to read the value of keys[i].
  template <class Value>
  void object(std::initializer_list<const char*> keys, Value value) {
    uint64_t seen = 0;  // a bit for each key
    take('{');
    if (next() != '}') do {
        next();
        const std::string key = string();
        const size_t i = size_t(std::find(keys.begin(), keys.end(), key) - keys.begin());
        expect(i < keys.size() && (seen >> i & 1) == 0, "a key is unknown or occurs twice");
        seen |= uint64_t(1) << i;
        take(':');
        value(i);
      } while (take_if(','));
    take('}');
    expect(seen + 1 == uint64_t(1) << keys.size(), "a key is missing");
  }
  void any(int depth) {
    expect(depth < kMostDepth, "nested too deep");
    const char c = next();
    if (c == '"') {
      string();
    } else if (c == '[') {
      list([&] { any(depth + 1); });
    } else if (c == '{') {
      std::map<std::string, bool> keys;
      take('{');
      if (take_if('}')) return;
      do {
        expect(keys.emplace(string(), true).second, "a key occurs twice");
        take(':');
        any(depth + 1);
      } while (take_if(','));
      take('}');
    } else {
      const std::string w = word();
      expect(w == "true" || w == "false" || w == "null" || is_integer(w), "expected a value");
    }
  }

  void group() {
    object({"name", "parent", "attributes"}, [&](size_t key) {
      if (key == 0) string();
      if (key == 1) index();
      if (key == 2) list([&] { string(); });
    });
    ++groups;
  }
  void points(std::vector<Ratio>* flat, uint64_t* count) {
    size_t each = 0;  // numbers of the first one
    list([&] {
      const size_t before = flat->size();
      list([&] { flat->push_back(read_number(string())); });
      if ((*count)++ == 0) each = flat->size();
      expect(flat->size() - before == each, "points have different numbers of components");
    });
  }
  Entity shape(Entity::Kind kind) {  // kOther: of a volume
    Entity e;
    e.kind = kind;
    std::vector<bool> periodic;
    std::vector<Ratio> flat;
    uint64_t count = 0;
    if (kind != Entity::kTriangle) {
      object({"points", "rational", "components", "degrees", "periodic", "knots"}, [&](size_t key) {
        if (key == 0) points(&flat, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) list([&] { e.degrees.push_back(integer()); });
        if (key == 4) list([&] { periodic.push_back(boolean()); });
        if (key == 5)
          list([&] {
            std::vector<Ratio> axis;
            list([&] { axis.push_back(read_number(string())); });
            e.knots.push_back(axis);
          });
      });
    } else {
      object({"points", "rational", "components", "degree"}, [&](size_t key) {
        if (key == 0) points(&flat, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) e.degrees.assign(1, integer());
      });
      periodic.push_back(false);
    }
    expect(e.components >= 0 && flat.size() == count * uint64_t(e.components),
           "a point has another number of components");
    const std::vector<Ratio>& known = last;
    if (flat != known) last = std::move(flat);
    e.numbers = last;
    e.places.reserve(count);
    for (uint64_t i = 0; i < count; ++i) e.places.push_back(i);
    check_entity(e, periodic);
    return e;
  }

  Entity entity() {
    Entity e;
    bool known = false;
    std::string kind;
    object({"kind", "group", "attributes", "shape"}, [&](size_t key) {
      if (key == 0) kind = string(), known = true;
      if (key == 1) index();
      if (key == 2) list([&] { string(); });
      if (key != 3) return;
      expect(known, "the shape stands before its kind");
      expect(!has_volumes || kind == "volume", "an entity is no volume");
      if (kind == "surface") e = shape(Entity::kSurface);
      if (kind == "triangle") e = shape(Entity::kTriangle);
      if (has_volumes) e = shape(Entity::kOther);
      if (kind == "surface" || kind == "triangle" || has_volumes) return;
      expect(kind == "curve" || kind == "volume" || kind == "trimmed" || kind == "model",
             "unknown kind");
      expect(next() == '{', "a shape is no object");
      any(0);
    });
    return e;
  }
  std::vector<Entity> model() {
    std::vector<Entity> entities;
    bool grouped = false;
    object({"format", "groups", "entities"}, [&](size_t key) {
      if (key == 0) expect(string() == "veritope-spline-1", "unknown format");
      if (key == 1) list([&] { group(); }), grouped = true;
      if (key != 2) return;
      expect(grouped, "the entities stand before the groups");
      list([&] { entities.push_back(entity()); });
    });
    expect(next() == '\0' && at == text.size(), "something follows the model");
    return entities;
  }
};

}  // namespace

std::vector<Entity> read_json_model(const std::string& file, bool has_volumes, size_t* at) {
  expect(is_utf8(file), "the file is not UTF-8");
  return Reader(file, has_volumes, at).model();
}
