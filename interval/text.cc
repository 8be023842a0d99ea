// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/text.h"

#include <optional>

#include "interval/infinity_internal.h"

namespace veritope {

namespace {

using internal::kInfinity;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
int hex_value(char c) {
  if (is_digit(c)) return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

Rational ten_to(std::int64_t n) {
  Integer power(1), base(10);
  for (std::int64_t m = n < 0 ? -n : n; m != 0; m /= 2) {
    if (m % 2 != 0) power *= base;
    base *= base;
  }
  return n < 0 ? Rational(Integer(1), power) : Rational(power);
}

// A cursor over lower-case text. Each method consumes what it names, or reports that it is not there.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void skip_blanks() {
    while (take(" ") || take("\t")) {
    }
  }
  bool negative_sign() { return take("-") || (take("+"), false); }

  // The digits of a number in one base, with at most one point; `fraction` counts those after it.
  struct Digits {
    Integer value;
    int count = 0, fraction = 0;
  };
  std::optional<Digits> digits(int base, bool with_point) {
    Digits out;
    bool point = false;
    for (; !rest_.empty(); rest_.remove_prefix(1)) {
      const char c = rest_.front();
      if (with_point && !point && c == '.') {
        point = true;
        continue;
      }
      const int v = base == 16 ? hex_value(c) : (is_digit(c) ? c - '0' : -1);
      if (v < 0) break;
      if (++out.count > kMaxLiteralDigits) return std::nullopt;
      out.value *= Integer(base);
      out.value += Integer(v);
      out.fraction += point ? 1 : 0;
    }
    if (out.count == 0) return std::nullopt;
    return out;
  }
  // A signed exponent after its letter, whose absolute value is at most kMaxLiteralDigits.
  std::optional<std::int64_t> exponent() {
    const bool negative = negative_sign();
    const std::optional<Digits> d = digits(10, false);
    if (!d || !(d->value <= Integer(kMaxLiteralDigits))) return std::nullopt;
    return negative ? -d->value.to_int64() : d->value.to_int64();
  }

 private:
  std::string_view rest_;
};

std::optional<Rational> hexadecimal(Reader& r) {
  const auto d = r.digits(16, true);
  if (!d || !r.take("p")) return std::nullopt;
  const auto e = r.exponent();
  if (!e) return std::nullopt;
  return Rational(d->value) * Rational::power_of_two(*e - 4 * d->fraction);
}

std::optional<Rational> decimal_or_ratio(Reader& r) {
  const auto d = r.digits(10, true);
  if (!d) return std::nullopt;
  if (r.take("e")) {
    const auto e = r.exponent();
    if (!e) return std::nullopt;
    return Rational(d->value) * ten_to(*e - d->fraction);
  }
  if (r.take("/")) {
    const auto q = r.digits(10, false);
    if (!q || q->value.is_zero() || d->fraction != 0) return std::nullopt;
    return Rational(d->value, q->value);
  }
  return Rational(d->value) * ten_to(-d->fraction);
}

// A bound as written: exact or infinite.
struct Bound {
  int infinite = 0;
  Rational value;
};

std::optional<Bound> bound(Reader& r) {
  const bool negative = r.negative_sign();
  if (r.take("infinity") || r.take("inf")) return Bound{negative ? -1 : 1, Rational()};
  std::optional<Rational> v = r.take("0x") ? hexadecimal(r) : decimal_or_ratio(r);
  if (!v) return std::nullopt;
  return Bound{0, negative ? -*v : *v};
}

// What a literal says, before rounding.
struct Written {
  bool empty = false;
  Bound lo{-1, Rational()}, hi{1, Rational()};
};

// Reads what follows "[", to the closing bracket.
std::optional<Written> bracketed(Reader& r) {
  Written out;
  r.skip_blanks();
  const auto closed = [&] { return r.skip_blanks(), r.take("]"); };
  if (r.take("]") || (r.take("empty") && closed())) {
    out.empty = true;
    return out;
  }
  if (r.take("entire")) return closed() ? std::optional(out) : std::nullopt;
  bool one = false;
  if (!r.take(",")) {
    const auto lo = bound(r);
    if (!lo || lo->infinite > 0) return std::nullopt;
    out.lo = *lo;
    r.skip_blanks();
    one = !r.take(",");
  }
  if (one) {
    out.hi = out.lo;
    return out.lo.infinite == 0 && closed() ? std::optional(out) : std::nullopt;
  }
  r.skip_blanks();
  if (r.take("]")) return out;
  const auto hi = bound(r);
  if (!hi || hi->infinite < 0 || !closed()) return std::nullopt;
  out.hi = *hi;
  if (out.lo.infinite == 0 && out.hi.infinite == 0 && out.hi.value < out.lo.value)
    return std::nullopt;
  return out;
}

// "3.56?1u e4" without the blank.
std::optional<Written> uncertain(Reader& r) {
  const bool negative = r.negative_sign();
  const auto d = r.digits(10, true);
  if (!d || !r.take("?")) return std::nullopt;
  const bool unbounded = r.take("?");
  Rational radius(Integer(1), Integer(2));
  if (!unbounded)
    if (Reader ahead = r; const auto units = ahead.digits(10, false)) {
      radius = Rational(units->value);
      r = ahead;
    }
  const bool up = r.take("u"), down = !up && r.take("d");
  std::int64_t exponent = 0;
  if (r.take("e")) {
    const auto e = r.exponent();
    if (!e) return std::nullopt;
    exponent = *e;
  }
  const Rational unit = ten_to(exponent - d->fraction),
                 center = Rational(negative ? -d->value : d->value) * unit;
  Written out;
  if (up) out.lo = {0, center};
  if (down) out.hi = {0, center};
  if (!unbounded && !up) out.lo = {0, center - radius * unit};
  if (!unbounded && !down) out.hi = {0, center + radius * unit};
  return out;
}

std::optional<Written> written(Reader& r) { return r.take("[") ? bracketed(r) : uncertain(r); }

Interval rounded(const Written& w) {
  if (w.empty) return Interval::empty();
  return Interval::from_bounds(w.lo.infinite != 0 ? -kInfinity : round_down(w.lo.value),
                               w.hi.infinite != 0 ? kInfinity : round_up(w.hi.value));
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::optional<Decoration> decoration_suffix(Reader& r) {
  if (r.take("_com")) return Decoration::kCom;
  if (r.take("_dac")) return Decoration::kDac;
  if (r.take("_def")) return Decoration::kDef;
  if (r.take("_trv")) return Decoration::kTrv;
  return std::nullopt;
}

}  // namespace

Signalled<Interval> text_to_interval(std::string_view text) {
  const std::string lower = lower_case(text);
  Reader r(lower);
  r.skip_blanks();
  const std::optional<Written> w = written(r);
  r.skip_blanks();
  if (!w || !r.at_end()) return {Interval::empty(), Signal::kUndefinedOperation};
  return {rounded(*w)};
}

Signalled<DecoratedInterval> text_to_decorated(std::string_view text) {
  const Signalled<DecoratedInterval> refused{DecoratedInterval::nai(), Signal::kUndefinedOperation};
  const std::string lower = lower_case(text);
  Reader r(lower);
  r.skip_blanks();
  if (Reader nai = r; nai.take("[")) {
    nai.skip_blanks();
    if (nai.take("nai")) {
      nai.skip_blanks();
      const bool closed = nai.take("]");
      nai.skip_blanks();
      return closed && nai.at_end() ? Signalled<DecoratedInterval>{DecoratedInterval::nai()}
                                    : refused;
    }
  }
  const std::optional<Written> w = written(r);
  if (!w) return refused;
  const std::optional<Decoration> d = decoration_suffix(r);
  r.skip_blanks();
  if (!r.at_end()) return refused;
  if (!d) return {DecoratedInterval(rounded(*w))};
  const bool bounded = w->lo.infinite == 0 && w->hi.infinite == 0;
  const Decoration most =
      w->empty ? Decoration::kTrv : (bounded ? Decoration::kCom : Decoration::kDac);
  if (*d > most) return refused;
  return {DecoratedInterval(rounded(*w), *d)};
}

std::string exact_text(const Interval& x) {
  if (x.is_empty()) return "[empty]";
  if (x.is_entire()) return "[entire]";
  const auto bound_text = [](double v) {
    if (internal::is_infinite(v)) return std::string();
    return internal::number_text("%a", internal::order_key(v) == 0 ? 0.0 : v);
  };
  return "[" + bound_text(x.lo()) + "," + bound_text(x.hi()) + "]";
}

std::string exact_text(const DecoratedInterval& x) {
  if (x.is_nai()) return "[nai]";
  const std::string whole = to_string(x);
  return exact_text(x.interval()) + whole.substr(whole.size() - 4);
}

}  // namespace veritope
