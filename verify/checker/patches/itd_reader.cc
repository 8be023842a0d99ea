// SPDX-License-Identifier: Apache-2.0 OR MIT
// itd_reader.cc: spline models, docs/certificates/reading-rule-itd.md, section by section.
#include "star_model.h"

namespace {

typedef std::vector<std::string> Words;
const Words kPassedOver = {"NUMBER", "STRING", "POINT", "VECTOR", "PLANE", "MATRIX", "CTLPT"};
const Words kRefused = {"CURVE",    "TRIVAR",    "TRIMSRF",   "MODEL",  "POLYGON",
                        "POLYLINE", "POINTLIST", "POLYSTRIP", "TRISRF", "INSTANCE"};
const Words kNoAttribute = {"KV", "KVP", "SURFACE", "CURVE", "TRIMCRV"};
const Words kBases = {"BEZIER", "BSPLINE", "POWER"};
const uint64_t kMostOrder = 64;
// 5^27, and the odd primes below 64.
const int64_t kPrimes[] = {
    7450580596923828125, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61};

bool is_in(const Words& words, const std::string& w) {
  return std::find(words.begin(), words.end(), w) != words.end();
}

// Binomials of a degree below 64, and their least common multiple.
struct Binomials {
  std::vector<Big> c;
  Big common = 1;
  explicit Binomials(int64_t degree) {
    u128 binomial = 1;
    for (int64_t r = 0; r <= degree; ++r) {
      c.push_back(Big(int64_t(binomial)));
      common = common * divide(c.back(), gcd(common, c.back()), nullptr);
      binomial = binomial * u128(degree - r) / u128(r + 1);
    }
  }
  // Converts powers to Bernstein coefficients, times `common`.
  void transform(std::vector<Big>* a, size_t first, size_t step) const {
    const auto at = [&](size_t r) -> Big& { return (*a)[first + r * step]; };
    for (size_t r = 0; r < c.size(); ++r) at(r) = at(r) * divide(common, c[r], nullptr);
    for (size_t k = 1; k < c.size(); ++k)  // each step adds one to the i of C(i, r)
      for (size_t i = c.size(); i-- > k;) at(i) = at(i) + at(i - 1);
  }
};
// n / d in lowest terms. REQUIRES that d has no prime factor over 61 (powers of ten, and binomials of a degree below
// 64, have none): Euclid's algorithm would take a step for each other bit.
Ratio shortened(Big n, Big d) {
  const int64_t twos = std::min(n.zeros(), d.zeros());
  n = shifted(n, -twos), d = shifted(d, -twos);
  const auto divides = [&](int64_t q) {
    Big rest;
    const Big to = divide(n, Big(q), &rest);
    if (rest.sign() != 0) return false;
    const Big of = divide(d, Big(q), &rest);
    if (rest.sign() != 0) return false;
    n = to, d = of;
    return true;
  };
  for (const int64_t q : kPrimes)
    while (divides(q)) {
    }
  return Ratio(n, d);
}
// Converts the net of a surface, u fastest, from the power basis to Bernstein's, each component in integers, because
// sums of long fractions are slow.
void to_bernstein(std::vector<Ratio>* net, size_t components, const std::vector<int64_t>& degrees) {
  const Binomials u(degrees[0]), v(degrees[1]);
  for (size_t j = 0; j < components; ++j) {
    Big common = 1;
    for (size_t i = j; i < net->size(); i += components)
      common = common * divide((*net)[i].d, gcd(common, (*net)[i].d), nullptr);
    std::vector<Big> a;
    for (size_t i = j; i < net->size(); i += components)
      a.push_back((*net)[i].n * divide(common, (*net)[i].d, nullptr));
    for (size_t k = 0; k < v.c.size(); ++k) u.transform(&a, k * u.c.size(), 1);
    for (size_t i = 0; i < u.c.size(); ++i) v.transform(&a, i, u.c.size());
    common = common * u.common * v.common;
    for (size_t i = 0; i < a.size(); ++i) (*net)[j + i * components] = shortened(a[i], common);
  }
}

struct Reader {
  const std::string& text;
  size_t& at;

  // Section 1.
  void skip() { at = std::min(text.find_first_not_of(" \t\v\f\n\r", at), text.size()); }
  std::string word() {  // empty if a bracket, a string or the end comes first
    skip();
    const size_t begin = at;
    at = std::min(text.find_first_of(" \t\v\f\n\r[]\"", at), text.size());
    return text.substr(begin, at - begin);
  }
  bool take_if(char c) {
    skip();
    const bool is = at < text.size() && text[at] == c;
    at += is;
    return is;
  }
  void string() {  // starts after its first quote
    for (; at < text.size() && text[at] != '"'; ++at)
      if (text[at] == '\\') ++at;
    expect(at < text.size(), "a string does not end");
    ++at;
  }
  void group() {  // starts inside the group, ends after its ]
    for (uint64_t depth = 1; depth > 0;) {
      at = std::min(text.find_first_of("[]\"", at), text.size());
      expect(at < text.size(), "a group does not end");
      const char c = text[at++];
      if (c == '"') string();
      if (c == '[') ++depth;
      if (c == ']') --depth;
    }
  }
  uint64_t count() {
    const std::string w = word();
    const size_t sign = !w.empty() && (w[0] == '+' || w[0] == '-');
    expect(w.size() > sign && w.find_first_not_of("0123456789", sign) == w.npos,
           "expected a count");
    uint64_t v = 0;
    for (size_t i = sign; i < w.size(); ++i)
      v = std::min(10 * v + uint64_t(w[i] - '0'), uint64_t(1) << 40);
    expect(v > 0 && w[0] != '-', "a count is less than 1");
    return v;
  }
  Ratio decimal() {
    const std::string w = word();
    size_t i = !w.empty() && (w[0] == '+' || w[0] == '-'), digits = 0;
    for (bool point = false; i < w.size() && (isdigit(uint8_t(w[i])) || (w[i] == '.' && !point));
         ++i)
      w[i] == '.' ? point = true : ++digits;
    expect(digits > 0 && digits <= kMostDigits, "expected a decimal of at most 1000 digits");
    expect(i == w.size() || w[i] == 'e' || w[i] == 'E', "expected a decimal");
    return read_number(w);  // tests the exponent
  }

  // Section 3.
  // Reads two groups; an axis of KVP has more control points than the file lists.
  void knots(const uint64_t* given, uint64_t* stored, Entity* e) {
    for (size_t a = 0; a < 2; ++a) {
      expect(take_if('['), "expected a group of knots");
      const std::string w = word();
      expect(w == "KV" || w == "KVP", "expected KV or KVP");
      const uint64_t order = uint64_t(e->degrees[a]) + 1;
      stored[a] = given[a] + (w == "KVP" ? order - 1 : 0);
      for (uint64_t i = 0; i < stored[a] + order; ++i) e->knots[a].push_back(decimal());
      expect(take_if(']'), "more knots than belong there");
    }
  }
  std::vector<Ratio> points(uint64_t number, size_t components, bool is_rational) {
    std::vector<Ratio> flat;
    for (uint64_t i = 0; i < number; ++i) {
      expect(take_if('['), "expected a control point");
      for (size_t k = 0; k < components; ++k) flat.push_back(decimal());
      if (is_rational) std::rotate(flat.end() - 4, flat.end() - 3, flat.end());
      expect(take_if(']'), "more numbers than a point has");
    }
    expect(take_if(']'), "more control points than belong there");
    return flat;
  }
  Entity surface(bool is_multivariate) {  // starts after its keyword
    const std::string basis = word();
    expect(is_in(kBases, basis), "expected BEZIER, BSPLINE or POWER");
    while (take_if('[')) {
      expect(!is_in(kNoAttribute, word()), "expected an attribute");
      group();
    }
    expect(!is_multivariate || count() == 2, "a multivariate of another number of parameters");
    Entity e;
    e.kind = Entity::kSurface;
    const uint64_t given[2] = {count(), count()};  // m before n
    uint64_t order[2] = {given[0], given[1]}, stored[2] = {given[0], given[1]};
    for (uint64_t& k : order) k = basis == "BSPLINE" ? count() : k;
    for (size_t a = 0; a < 2; ++a) {
      expect(order[a] <= std::min(given[a], kMostOrder), "an order is too large");
      e.degrees.push_back(int64_t(order[a]) - 1);
    }
    expect(given[0] <= text.size() / given[1], "more control points than the file can hold");
    const std::string type = word();
    expect(type == "E3" || type == "P3", "expected E3 or P3");
    e.is_rational = type == "P3";
    e.components = e.is_rational ? 4 : 3;
    e.knots.resize(2);
    if (basis == "BSPLINE") knots(given, stored, &e);
    for (size_t a = 0; a < 2 && basis != "BSPLINE"; ++a) {
      e.knots[a].assign(2 * order[a], Ratio());
      std::fill(e.knots[a].begin() + int64_t(order[a]), e.knots[a].end(), Ratio(Big(1)));
    }
    const size_t c = size_t(e.components);
    std::vector<Ratio> flat = points(given[0] * given[1], c, e.is_rational);
    const size_t row = size_t(given[0]) * c;  // numbers with one index along v
    if (basis == "POWER") to_bernstein(&flat, c, e.degrees);
    for (uint64_t i = 0; i < stored[0]; ++i)
      for (uint64_t k = 0; k < stored[1]; ++k) {
        const auto from = flat.begin() + int64_t(k % given[1] * row + i % given[0] * c);
        e.points.insert(e.points.end(), from, from + int64_t(c));
      }
    check_entity(e, {false, false}, stored[0] * stored[1]);
    return e;
  }

  // Section 2.
  std::vector<Entity> model() {
    std::vector<Entity> entities;
    std::vector<bool> has_name;  // for each open object
    bool is_empty = true;
    for (;;) {
      if (has_name.empty()) at = std::min(text.find('[', at), text.size());
      if (has_name.empty() && at == text.size()) break;
      skip();
      expect(at < text.size(), "an object does not end");
      if (take_if(']')) {
        has_name.pop_back();
      } else if (!take_if('[')) {
        if (take_if('"'))
          string();
        else
          word();
        expect(!has_name.back(), "a second name of an object");
        has_name.back() = true;
      } else {
        is_empty = false;
        const std::string w = word();
        expect(!is_in(kRefused, w), "geometry other than surfaces");
        const bool is_object = w == "OBJECT", is_multivariate = w == "MULTIVAR";
        expect(is_object || is_multivariate || w == "SURFACE" || !has_name.empty() ||
                   is_in(kPassedOver, w),
               "neither an object nor data");
        if (is_object)
          has_name.push_back(false);
        else if (is_multivariate || w == "SURFACE")
          entities.push_back(surface(is_multivariate));
        else
          group();
      }
    }
    expect(!is_empty, "there is no group in the file");
    return entities;
  }
};

}  // namespace

std::vector<Entity> read_itd_model(const std::string& file, size_t* at) {
  return Reader{file, *at}.model();
}
