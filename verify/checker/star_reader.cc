// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_reader.cc: spline models, docs/formats/spline-json.md. Entities that are neither surfaces nor
// triangles are read as JSON only: no claim is made about a model that has one.
#include "star.h"

namespace {

const size_t kMostDigits = 1000, kMostExponent = 4096;  // the page's limits
const int kMostDepth = 100, kMostSplineDegree = 63;

struct Reader {
  const std::string& text;
  size_t at = 0;
  uint64_t groups = 0;

  explicit Reader(const std::string& file) : text(file) {}
  [[noreturn]] void refuse(const std::string& why) const {
    throw Refused{"byte " + std::to_string(at) + ": " + why};
  }
  void expect(bool holds, const char* why) const {
    if (!holds) refuse(why);
  }
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
    if (!take_if(c)) refuse(std::string("expected '") + c + "'");
  }
  std::string string() {  // with its escapes as they are: no key or number has one
    take('"');
    const size_t begin = at;
    for (; at < text.size() && text[at] != '"'; ++at) {
      expect(uint8_t(text[at]) >= 32, "a control character in a string");
      if (text[at] == '\\') ++at;
    }
    expect(at < text.size(), "a string does not end");
    return text.substr(begin, at++ - begin);
  }
  std::string word() {  // true, false, null, an integer
    next();
    const size_t begin = at;
    while (at < text.size() && (isalnum(uint8_t(text[at])) != 0 || text[at] == '-')) ++at;
    return text.substr(begin, at - begin);
  }
  int64_t integer() {
    const std::string w = word();
    const size_t sign = !w.empty() && w[0] == '-';
    expect(w.size() > sign && w.size() < 18 && w.find_first_not_of("0123456789", sign) == w.npos &&
               (w[sign] != '0' || w.size() == sign + 1),
           "expected an integer");
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
  // value(i) reads the value of keys[i].
  template <class Value>
  void object(const std::vector<std::string>& keys, Value value) {
    std::vector<bool> seen(keys.size());
    take('{');
    if (next() != '}') do {
        next();
        const std::string key = string();
        const size_t i = size_t(std::find(keys.begin(), keys.end(), key) - keys.begin());
        expect(i < keys.size() && !seen[i], "a key is unknown or occurs twice");
        seen[i] = true;
        take(':');
        value(i);
      } while (take_if(','));
    take('}');
    expect(std::find(seen.begin(), seen.end(), false) == seen.end(), "a key is missing");
  }
  void any(int depth) {
    expect(depth < kMostDepth, "nested too deep");
    const char c = next();
    if (c == '"') {
      string();
    } else if (c == '[') {
      list([&] { any(depth + 1); });
    } else if (c == '{') {
      take('{');
      if (take_if('}')) return;
      do string(), take(':'), any(depth + 1);
      while (take_if(','));
      take('}');
    } else {
      expect(!word().empty(), "expected a value");
    }
  }

  static Big power(uint64_t base, uint64_t exponent) {
    Big r = 1, b = int64_t(base);
    for (; exponent != 0; exponent /= 2, b = b * b)
      if (exponent % 2 != 0) r = r * b;
    return r;
  }
  Big digits(const std::string& s, size_t most, int base) const {
    expect(!s.empty() && s.size() <= most, "no digits, or too many");
    Big r;
    for (size_t i = 0; i < s.size();) {
      int64_t part = 0, scale = 1;
      for (; i < s.size() && scale < int64_t(1) << 58; ++i, scale *= base) {
        const int c = tolower(uint8_t(s[i])), d = c >= 'a' ? c - 'a' + 10 : c - '0';
        expect(d >= 0 && d < base && isalnum(c) != 0, "not a number");
        part = part * base + d;
      }
      r = r * Big(scale) + Big(part);
    }
    return r;
  }
  int64_t exponent(std::string s) const {
    const bool below = !s.empty() && s[0] == '-';
    if (!s.empty() && (below || s[0] == '+')) s.erase(0, 1);
    s.erase(0, std::min(s.find_first_not_of('0'), s.size() - !s.empty()));
    expect(!s.empty() && s.find_first_not_of("0123456789") == s.npos, "not a number");
    expect(s.size() < 5 && std::stoul(s) <= kMostExponent, "an exponent over the limit");
    return below ? -std::stol(s) : std::stol(s);
  }
  Ratio number() {
    std::string s = string();
    const bool below = !s.empty() && s[0] == '-';
    if (!s.empty() && (below || s[0] == '+')) s.erase(0, 1);
    Ratio r;
    const size_t slash = s.find('/');
    if (slash != s.npos) {
      r.n = digits(s.substr(0, slash), kMostDigits + kMostExponent, 10);
      r.d = digits(s.substr(slash + 1), kMostDigits + kMostExponent, 10);
      expect(r.d.sign() > 0, "a denominator is 0");
    } else {
      const bool is_hex = s.size() > 1 && s[0] == '0' && (s[1] == 'x' || s[1] == 'X');
      if (is_hex) s.erase(0, 2);
      const size_t e = std::min(s.find_first_of(is_hex ? "pP" : "eE"), s.size());
      int64_t scale = e < s.size() ? exponent(s.substr(e + 1)) : 0;
      const bool is_integer = e == s.size() && s.find('.') == s.npos && !is_hex;
      s.erase(e);
      const size_t point = std::min(s.find('.'), s.size());
      if (point < s.size()) s.erase(point, 1);
      scale -= int64_t(s.size() - point) * (is_hex ? 4 : 1);
      const size_t most = is_integer ? kMostDigits + kMostExponent : kMostDigits;
      r.n = digits(s, most, is_hex ? 16 : 10);
      (scale < 0 ? r.d : r.n) =
          (scale < 0 ? r.d : r.n) * power(is_hex ? 2 : 10, uint64_t(scale < 0 ? -scale : scale));
    }
    if (below) r.n = -r.n;
    return lowest(r);
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
    list([&] {
      ++*count;
      list([&] { flat->push_back(number()); });
    });
  }
  Entity shape(Entity::Kind kind) {
    Entity e;
    e.kind = kind;
    std::vector<bool> periodic(2);
    uint64_t count = 0;
    if (kind == Entity::kSurface) {
      periodic.clear();
      object({"points", "rational", "components", "degrees", "periodic", "knots"}, [&](size_t key) {
        if (key == 0) points(&e.points, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) list([&] { e.degrees.push_back(integer()); });
        if (key == 4) list([&] { periodic.push_back(boolean()); });
        if (key == 5)
          list([&] {
            std::vector<Ratio> axis;
            list([&] { axis.push_back(number()); });
            e.knots.push_back(axis);
          });
      });
    } else {
      object({"points", "rational", "components", "degree"}, [&](size_t key) {
        if (key == 0) points(&e.points, &count);
        if (key == 1) e.is_rational = boolean();
        if (key == 2) e.components = integer();
        if (key == 3) e.degrees.assign(1, integer());
      });
    }
    check(e, periodic, count);
    return e;
  }

  // The number of control points along an axis.
  uint64_t axis(const Entity& e, size_t a, bool is_periodic) const {
    const std::vector<Ratio>& t = e.knots[a];
    const size_t p = size_t(e.degrees[a]);
    expect(t.size() >= 2 * (p + 1), "too few knots");
    for (size_t i = 1; i < t.size(); ++i) {
      expect(compare(t[i - 1], t[i]) <= 0, "a knot is less than the one before it");
      expect(i < p + 1 || compare(t[i - p - 1], t[i]) < 0, "a knot occurs too often");
    }
    const size_t n = t.size() - p - 1;
    expect(compare(t[p], t[n]) < 0, "the domain is empty");
    for (size_t i = 0; is_periodic && i + n - p < t.size(); ++i)
      expect(compare(t[i + n - p] - t[i], t[n] - t[p]) == 0, "the knots do not repeat");
    return n;
  }
  void check(const Entity& e, const std::vector<bool>& periodic, uint64_t count) const {
    const std::vector<Ratio>& flat = e.points;
    for (int64_t d : e.degrees)
      expect(d >= 1 && d <= kMostSplineDegree, "a degree is out of range");
    expect(e.components > e.is_rational && e.components <= 1001 &&
               flat.size() == count * uint64_t(e.components),
           "a point has another number of components");
    const size_t c = size_t(e.components);
    uint64_t size[2] = {1, 1};
    if (e.kind == Entity::kSurface) {
      expect(e.degrees.size() == 2 && periodic.size() == 2 && e.knots.size() == 2, "no two axes");
      for (size_t a = 0; a < 2; ++a) size[a] = axis(e, a, periodic[a]);
    } else {
      size[1] = uint64_t((e.degrees[0] + 1) * (e.degrees[0] + 2) / 2);
    }
    expect(count % size[1] == 0 && count / size[1] == size[0], "another number of control points");
    for (uint64_t i = 0; e.is_rational && i < count; ++i)
      expect(flat[i * c + c - 1].n.sign() > 0, "a weight is not positive");
    for (size_t a = 0; a < 2; ++a)
      for (uint64_t i = 0; periodic[a] && i < count; ++i) {
        const uint64_t step = a == 0 ? size[1] : 1, k = i / step % size[a];
        const uint64_t turn = (size[a] - uint64_t(e.degrees[a])) * step;
        for (size_t j = 0; k < uint64_t(e.degrees[a]) && j < c; ++j)
          expect(compare(flat[i * c + j], flat[(i + turn) * c + j]) == 0,
                 "the control points of a periodic axis do not repeat");
      }
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
      if (kind == "surface") e = shape(Entity::kSurface);
      if (kind == "triangle") e = shape(Entity::kTriangle);
      if (kind == "surface" || kind == "triangle") return;
      expect(kind == "curve" || kind == "volume" || kind == "trimmed" || kind == "model",
             "unknown kind");
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

std::vector<Entity> read_spline_model(const std::string& file) {
  Reader r(file);
  if (file.compare(0, 3, "\xef\xbb\xbf") == 0) r.at = 3;
  return r.model();
}
