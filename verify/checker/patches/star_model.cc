// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_model.cc: numbers and checks of spline models, docs/formats/spline-json.md; the two formats.
#include "star_model.h"

namespace {

const int kMostSplineDegree = 63;

Big power(uint64_t base, uint64_t exponent) {
  Big r = 1, b = int64_t(base);
  for (; exponent != 0; exponent /= 2, b = b * b)
    if (exponent % 2 != 0) r = r * b;
  return r;
}
Big digits(const std::string& s, size_t most, int base) {
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
int64_t exponent(std::string s) {
  const bool below = !s.empty() && s[0] == '-';
  if (!s.empty() && (below || s[0] == '+')) s.erase(0, 1);
  s.erase(0, std::min(s.find_first_not_of('0'), s.size() - !s.empty()));
  expect(!s.empty() && s.find_first_not_of("0123456789") == s.npos, "not a number");
  expect(s.size() < 5 && std::stoul(s) <= kMostExponent, "an exponent over the limit");
  return below ? -std::stol(s) : std::stol(s);
}

}  // namespace

Ratio read_number(std::string s) {
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

namespace {

// The number of control points along an axis.
uint64_t axis(const Entity& e, size_t a, bool is_periodic) {
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

}  // namespace

void check_entity(const Entity& e, const std::vector<bool>& periodic, uint64_t count) {
  const std::vector<Ratio>& flat = e.points;
  for (int64_t d : e.degrees) expect(d >= 1 && d <= kMostSplineDegree, "a degree is out of range");
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

std::vector<Entity> read_spline_model(const std::string& file, const std::string& format) {
  size_t at = file.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  try {
    if (format != "itd" && format != "vjson")
      throw Refused{"models in the format " + format + " are not read yet"};
    return format == "itd" ? read_itd_model(file, &at) : read_json_model(file, &at);
  } catch (const Refused& r) {
    throw Refused{"byte " + std::to_string(at) + ": " + r.why};
  }
}
