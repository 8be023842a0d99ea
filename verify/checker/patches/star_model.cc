// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_model.cc: numbers and checks of spline models, docs/formats/spline-json.md; the table of formats.
#include "star_model.h"

namespace {

// 5^27, and the odd primes below 64.
const int64_t kPrimes[] = {
    7450580596923828125, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61};

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
  if (s.size() < 19 && is_natural(s)) return Big(below ? -std::stoll(s) : std::stoll(s));
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

Ratio read_decimal(const std::string& w) {
  size_t i = !w.empty() && (w[0] == '+' || w[0] == '-'), digits = 0;
  for (bool point = false; i < w.size() && (isdigit(uint8_t(w[i])) || (w[i] == '.' && !point)); ++i)
    w[i] == '.' ? point = true : ++digits;
  expect(digits > 0 && digits <= kMostDigits, "expected a decimal of at most 1000 digits");
  expect(i == w.size() || w[i] == 'e' || w[i] == 'E', "expected a decimal");
  return read_number(w);  // tests the exponent
}

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

uint64_t check_knots(const std::vector<Ratio>& t, int64_t degree, bool is_periodic) {
  expect(degree >= 1 && degree <= kMostSplineDegree, "a degree is out of range");
  const size_t p = size_t(degree);
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

void check_entity(const Entity& e, const std::vector<bool>& periodic) {
  const uint64_t count = e.places.size();
  expect(e.components > e.is_rational && e.components <= 1001,
         "a point has another number of components");
  const size_t c = size_t(e.components);
  std::vector<uint64_t> size;  // the number of control points along each axis
  if (e.kind == Entity::kTriangle) {
    expect(e.degrees[0] >= 1 && e.degrees[0] <= kMostSplineDegree, "a degree is out of range");
    size.push_back(uint64_t((e.degrees[0] + 1) * (e.degrees[0] + 2) / 2));
  } else {
    const size_t axes = e.kind == Entity::kSurface ? 2 : 3;
    expect(e.degrees.size() == axes && periodic.size() == axes && e.knots.size() == axes,
           "another number of axes");
    for (size_t a = 0; a < axes; ++a)
      size.push_back(check_knots(e.knots[a], e.degrees[a], periodic[a]));
  }
  uint64_t rest = count;
  for (uint64_t n : size) rest = rest % n == 0 ? rest / n : 0;
  expect(rest == 1, "another number of control points");
  for (uint64_t i = 0; e.is_rational && i < count; ++i)
    expect(e.number(i, c - 1).n.sign() > 0, "a weight is not positive");
  uint64_t step = count;
  for (size_t a = 0; a < size.size(); ++a) {
    step /= size[a];
    for (uint64_t i = 0; periodic[a] && i < count; ++i) {
      const uint64_t k = i / step % size[a], turn = (size[a] - uint64_t(e.degrees[a])) * step;
      for (size_t j = 0; k < uint64_t(e.degrees[a]) && j < c; ++j)
        expect(compare(e.number(i, j), e.number(i + turn, j)) == 0,
               "the control points of a periodic axis do not repeat");
    }
  }
}

std::vector<uint64_t> first_axis_fastest(const std::vector<uint64_t>& stored,
                                         const std::vector<uint64_t>& given) {
  std::vector<uint64_t> places(1, 0), next;
  uint64_t step = 1;
  for (size_t a = 0; a < given.size(); step *= given[a++], places.swap(next), next.clear())
    for (uint64_t at : places)
      for (uint64_t k = 0; k < stored[a]; ++k) next.push_back(at + k % given[a] * step);
  return places;
}

namespace {

std::vector<Entity> read_entities(const std::string& file, const std::string& format,
                                  bool has_volumes) {
  size_t at = begin_of_text(file);
  try {
    return format == "itd"    ? read_itd_model(file, has_volumes, &at)
           : format == "g2"   ? read_g2_model(file, &at)
           : format == "mfem" ? read_mfem_model(file, &at)
                              : read_json_model(file, has_volumes, &at);
  } catch (const Refused& r) {
    if (format == "vjson" || format == "itd")
      throw Refused{"byte " + std::to_string(at) + ": " + r.why};
    throw Refused{line_and_token(file, at) + r.why};
  }
}

}  // namespace

std::vector<Entity> read_spline_model(const std::string& file, const std::string& format) {
  const size_t end = std::min(format.find("-faces"), format.size());
  const bool has_volumes = end < format.size();
  std::vector<Entity> entities = read_entities(file, format.substr(0, end), has_volumes);
  if (has_volumes) return boundary_faces(std::move(entities));
  return entities;
}

std::vector<Entity> read_volumes(const std::string& file, const std::string& format) {
  return volumes_in_space(read_entities(file, format, true));
}
