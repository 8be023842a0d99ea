// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_reader.cc: files of docs/formats/dms-files.md.
#include "../patches/json_reader.h"
#include "dms.h"

namespace {

const size_t kMostAttributes = 256;

struct DmsReader : JsonReader {
  DmsReader(const std::string& text, size_t* begin) : JsonReader(text, begin) {}

  DmsFile out;
  size_t coordinates = 3;                           // of a value; 0 in an attribute domain
  std::map<std::string, bool> seen_names;           // those of the geometry, too
  size_t attributes = 0, points = 0, kinds = 0;     // kinds: bit 0: shared, bit 1: separate
  std::vector<size_t> sizes;                        // of clouds
  std::map<std::vector<uint32_t>, uint32_t> at_of;  // shared control points
  std::vector<bool> is_used;

  uint64_t natural(uint64_t most) {
    expect(next() != '-', "an integer has a sign");
    const int64_t v = integer();
    expect(v >= 0 && uint64_t(v) <= most, "an integer is out of range");
    return uint64_t(v);
  }
  Ratio number() {
    next();
    Ratio r = read_number(string());
    expect(r.n.bits() <= kMostKnotBits && r.d.bits() <= kMostKnotBits,
           "a number has more than 2048 bits");
    return r;
  }
  // At most so many items; the result is how many.
  template <class Item>
  size_t items(size_t most, const char* why, Item item) {
    size_t i = 0;
    list([&] {
      expect(i < most, why);
      item(i++);
    });
    return i;
  }

  void names() {
    const size_t most = kMostAttributes - seen_names.size();
    attributes = items(most, "more than 256 attributes", [&](size_t) {
      next();
      const std::string s = string();
      expect(!s.empty(), "an attribute has no name");
      expect(seen_names.emplace(s, true).second, "two attributes have one name");
    });
    expect(coordinates + attributes > 0, "an attribute domain has no attributes");
  }
  void knot() {
    expect(
        items(3, "a knot has three numbers", [&](size_t) { out.knots.push_back(number()); }) == 3,
        "a knot has three numbers");
  }
  void cloud() {
    const size_t n = size_t(out.n), first = out.knots.size() / 3;
    const size_t size = items(n + 1, "a cloud has too many knots", [&](size_t) { knot(); });
    expect(size == 1 || size == n || size == n + 1, "a cloud has not 1, n or n + 1 knots");
    std::vector<uint32_t> knots;
    for (size_t i = 0; i <= n; ++i) knots.push_back(uint32_t(first + (i < size ? i : 0)));
    out.clouds.push_back(std::move(knots));
    sizes.push_back(size);
  }
  void tetrahedron() {
    std::array<uint32_t, 4> t;
    expect(items(4, "a tetrahedron has four vertices",
                 [&](size_t i) { t[i] = uint32_t(natural(out.clouds.size() - 1)); }) == 4,
           "a tetrahedron has four vertices");
    for (size_t i = 0; i < 4; ++i)
      for (size_t j = 0; j < i; ++j) expect(t[i] != t[j], "a tetrahedron has a vertex twice");
    out.tetrahedra.push_back(t);
  }

  void value() {
    const size_t all = coordinates + attributes;
    expect(items(all, "a value has too many numbers",
                 [&](size_t i) {
                   Ratio r = number();
                   if (i < coordinates) out.values.push_back(std::move(r));
                 }) == all,
           "a value has too few numbers");
  }
  void control_point() {
    const size_t n = size_t(out.n);
    size_t seen = 0;
    std::vector<uint32_t> at_list;
    uint64_t tetrahedron = 0;
    DmsIndex beta = {{0, 0, 0, 0}};
    object(
        {"value", "at", "tetrahedron", "beta"},
        [&](size_t key) {
          seen |= size_t(1) << key;
          if (key == 0) value();
          if (key == 1)
            items(n, "at has not n numbers",
                  [&](size_t) { at_list.push_back(uint32_t(natural(out.clouds.size() - 1))); });
          if (key == 2) tetrahedron = natural(out.tetrahedra.size() - 1);
          if (key == 3) {
            int sum = 0;
            const size_t size = items(4, "beta has not four numbers", [&](size_t i) {
              beta[i] = int(natural(n));
              sum += beta[i];
            });
            expect(size == 4 && sum == out.n, "beta has not four numbers with the sum n");
          }
        },
        3);
    expect(seen == 3 || seen == 13, "a control point has a wrong set of keys");
    kinds |= seen == 3 ? 1 : 2;
    expect(kinds != 3, "shared and separate control points");
    const uint32_t number = uint32_t(points++);
    if (seen == 3) {
      expect(at_list.size() == n, "at has not n numbers");
      expect(std::is_sorted(at_list.begin(), at_list.end()), "the numbers of at decrease");
      expect(at_of.emplace(at_list, number).second, "two control points have the same at");
      return;
    }
    uint32_t& place = out.control[tetrahedron * out.of_each() + dms_place(beta, out.n)];
    expect(place == kNoPair, "two control points have the same beta");
    place = number;
  }
  void control() {
    out.control.assign(out.tetrahedra.size() * out.of_each(), kNoPair);
    list([&] { control_point(); });
    expect(kinds != 0, "no control points");
    out.is_separate = kinds == 2;
    if (kinds == 1) share();
    for (uint32_t c : out.control) expect(c != kNoPair, "a control point is missing");
    for (size_t size : sizes)
      expect(kinds == 1 || size == 1 || size == size_t(out.n) + 1,
             "with separate control points a cloud has 1 or n + 1 knots");
  }
  void share() {
    is_used.assign(at_of.size(), false);
    const std::vector<DmsIndex> all = dms_indices(out.n);
    std::vector<uint32_t> key;
    for (size_t t = 0; t < out.tetrahedra.size(); ++t)
      for (const DmsIndex& beta : all) {
        key.clear();
        for (size_t c = 0; c < 4; ++c) key.insert(key.end(), size_t(beta[c]), out.tetrahedra[t][c]);
        std::sort(key.begin(), key.end());
        const auto found = at_of.find(key);
        expect(found != at_of.end(), "a control point is missing");
        out.control[t * out.of_each() + dms_place(beta, out.n)] = found->second;
        is_used[found->second] = true;
      }
    for (bool used : is_used) expect(used, "a control point belongs to no tetrahedron");
  }

  void member(size_t key) {
    if (key == 0) out.n = int(natural(kMostDmsDegree));
    if (key == 0) expect(out.n >= 1, "the degree is 0");
    if (key == 1) names();
    if (key == 2) items(kMostDmsItems, "too many vertices", [&](size_t) { cloud(); });
    if (key == 2) expect(out.clouds.size() >= 4, "fewer than four vertices");
    if (key == 3) items(kMostDmsItems, "too many tetrahedra", [&](size_t) { tetrahedron(); });
    if (key == 3) expect(!out.tetrahedra.empty(), "no tetrahedra");
    if (key == 4) control();
  }
  // What an attribute domain says is read and forgotten.
  void attribute_domain() {
    DmsReader own(text, &at);
    own.coordinates = 0;
    own.seen_names = seen_names;
    size_t expected = 0;
    own.object({"degree", "attributes", "vertices", "tetrahedra", "control"}, [&](size_t key) {
      expect(key == expected++, "the keys of the attribute domain are in another order");
      own.member(key);
    });
  }
  void file() {
    size_t expected = 0;
    object(
        {"format", "degree", "attributes", "vertices", "tetrahedra", "control", "attribute_domain"},
        [&](size_t key) {
          expect(key == expected++, "the keys of the file are in another order");
          if (key == 0) expect(next() == '"' && string() == "veritope-dms-1", "unknown format");
          if (key > 0 && key < 6) member(key - 1);
          if (key == 6) attribute_domain();
        },
        1);
    expect(next() == '\0' && at == text.size(), "something follows the file's object");
  }
};

}  // namespace

std::vector<DmsIndex> dms_indices(int sum) {
  std::vector<DmsIndex> r;
  for (int a = 0; a <= sum; ++a)
    for (int b = 0; b <= a; ++b)
      for (int l = 0; l <= b; ++l) r.push_back(DmsIndex{{sum - a, a - b, b - l, l}});
  return r;
}
DmsFile read_dms(const std::string& text) {
  size_t at = begin_of_text(text);
  try {
    DmsReader reader(text, &at);
    reader.file();
    return std::move(reader.out);
  } catch (const Refused& r) {
    const size_t line = size_t(std::count(text.begin(), text.begin() + int64_t(at), '\n')) + 1;
    throw Refused{"line " + std::to_string(line) + ": " + r.why};
  }
}
