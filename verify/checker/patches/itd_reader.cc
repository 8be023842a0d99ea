// SPDX-License-Identifier: Apache-2.0 OR MIT
// itd_reader.cc: spline models, docs/certificates/reading-rule-itd.md, section by section.
#include "star_model.h"

namespace {

typedef std::vector<std::string> Words;
const Words kPassedOver = {"NUMBER", "STRING", "POINT", "VECTOR", "PLANE", "MATRIX", "CTLPT"};
const Words kRefused = {
    "CURVE",    "SURFACE",   "TRIVAR",    "TRIMSRF", "MODEL",   "POLYGON",
    "POLYLINE", "POINTLIST", "POLYSTRIP", "TRISRF",  "INSTANCE"};  // entities are excepted
const Words kNoAttribute = {"KV", "KVP", "SURFACE", "CURVE", "TRIMCRV"};
const Words kBases = {"BEZIER", "BSPLINE", "POWER"};
const uint64_t kMostItdOrder = 64;

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
// Converts control points, first axis fastest, from the power basis to Bernstein's, each component in integers, because
// sums of long fractions are slow.
void to_bernstein(std::vector<Ratio>* net, size_t components, const std::vector<int64_t>& degrees) {
  std::vector<Binomials> axes;
  for (int64_t d : degrees) axes.push_back(Binomials(d));
  for (size_t j = 0; j < components; ++j) {
    Big common = 1;
    for (size_t i = j; i < net->size(); i += components)
      common = common * divide((*net)[i].d, gcd(common, (*net)[i].d), nullptr);
    std::vector<Big> a;
    for (size_t i = j; i < net->size(); i += components)
      a.push_back((*net)[i].n * divide(common, (*net)[i].d, nullptr));
    size_t step = 1;
    for (const Binomials& axis : axes) {
      for (size_t i = 0; i < a.size(); ++i)  // where a row along the axis begins
        if (i / step % axis.c.size() == 0) axis.transform(&a, i, step);
      step *= axis.c.size();
      common = common * axis.common;
    }
    for (size_t i = 0; i < a.size(); ++i) (*net)[j + i * components] = shortened(a[i], common);
  }
}

struct ItdReader {
  const std::string& text;
  size_t& at;
  const bool has_volumes;

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

  // Sections 3 and 4.
  // Reads a group for each axis; an axis of KVP has more control points than the file lists.
  void knots(const std::vector<uint64_t>& given, std::vector<uint64_t>* stored, Entity* e) {
    for (size_t a = 0; a < given.size(); ++a) {
      expect(take_if('['), "expected a group of knots");
      const std::string w = word();
      expect(w == "KV" || w == "KVP", "expected KV or KVP");
      const uint64_t order = uint64_t(e->degrees[a]) + 1;
      (*stored)[a] = given[a] + (w == "KVP" ? order - 1 : 0);
      std::vector<Ratio> t;
      for (uint64_t i = 0; i < (*stored)[a] + order; ++i) t.push_back(read_decimal(word()));
      expect(take_if(']'), "more knots than belong there");
      e->knots.push_back(std::move(t));
    }
  }
  std::vector<Ratio> points(uint64_t number, size_t components, bool is_rational) {
    std::vector<Ratio> flat;
    for (uint64_t i = 0; i < number; ++i) {
      expect(take_if('['), "expected a control point");
      for (size_t k = 0; k < components; ++k) flat.push_back(read_decimal(word()));
      const auto first = flat.end() - int64_t(components);
      if (is_rational) std::rotate(first, first + 1, flat.end());
      expect(take_if(']'), "more numbers than a point has");
    }
    expect(take_if(']'), "more control points than belong there");
    return flat;
  }
  Entity entity(bool is_multivariate) {  // starts after its keyword
    const size_t axes = has_volumes ? 3 : 2;
    const std::string basis = word();
    expect(is_in(kBases, basis), "expected BEZIER, BSPLINE or POWER");
    while (take_if('[')) {
      expect(!is_in(kNoAttribute, word()), "expected an attribute");
      group();
    }
    expect(!is_multivariate || count() == axes, "a multivariate of another number of parameters");
    Entity e;
    e.kind = has_volumes ? Entity::kOther : Entity::kSurface;
    std::vector<uint64_t> given;
    for (size_t a = 0; a < axes; ++a) given.push_back(count());
    std::vector<uint64_t> order = given, stored = given;
    for (uint64_t& k : order) k = basis == "BSPLINE" ? count() : k;
    uint64_t number = 1;
    for (size_t a = 0; a < axes; ++a) {
      expect(order[a] <= std::min(given[a], kMostItdOrder), "an order is too large");
      e.degrees.push_back(int64_t(order[a]) - 1);
      expect(number <= text.size() / given[a], "more control points than the file can hold");
      number *= given[a];
    }
    const std::string type = word();
    expect(type.size() == 2 && (type[0] == 'E' || type[0] == 'P') &&
               (has_volumes ? type[1] >= '1' && type[1] <= '9' : type[1] == '3'),
           has_volumes ? "expected E1 to E9, or P1 to P9" : "expected E3 or P3");
    e.is_rational = type[0] == 'P';
    e.components = type[1] - '0' + e.is_rational;
    if (basis == "BSPLINE") knots(given, &stored, &e);
    for (size_t a = 0; a < axes && basis != "BSPLINE"; ++a) {
      std::vector<Ratio> t(2 * order[a]);
      std::fill(t.begin() + int64_t(order[a]), t.end(), Ratio(Big(1)));
      e.knots.push_back(std::move(t));
    }
    std::vector<Ratio> flat = points(number, size_t(e.components), e.is_rational);
    if (basis == "POWER") to_bernstein(&flat, size_t(e.components), e.degrees);
    e.numbers = std::move(flat);
    e.places = first_axis_fastest(stored, given);
    check_entity(e, std::vector<bool>(axes));
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
        const bool is_object = w == "OBJECT", is_multivariate = w == "MULTIVAR";
        const bool is_entity = is_multivariate || w == (has_volumes ? "TRIVAR" : "SURFACE");
        expect(is_entity || !is_in(kRefused, w),
               has_volumes ? "geometry other than volumes" : "geometry other than surfaces");
        expect(is_object || is_entity || !has_name.empty() || is_in(kPassedOver, w),
               "neither an object nor data");
        if (is_object)
          has_name.push_back(false);
        else if (is_entity)
          entities.push_back(entity(is_multivariate));
        else
          group();
      }
    }
    expect(!is_empty, "there is no group in the file");
    return entities;
  }
};

}  // namespace

std::vector<Entity> read_itd_model(const std::string& file, bool has_volumes, size_t* at) {
  return ItdReader{file, *at, has_volumes}.model();
}
