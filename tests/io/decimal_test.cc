// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/decimal.h"

#include <gmp.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

ReadLimits wide_limits() {
  ReadLimits limits;
  limits.max_digits = 100000;
  limits.max_exponent = 100000;
  return limits;
}

DecimalFault fault_of(std::string_view token, const ReadLimits& limits = {}) {
  double value = 0;
  return DecimalReader(limits).read_slowly(token, value);
}

// What the readers get: the fast path if it answers, else the slow one. Infinity: refused as not finite.
double value_of(const std::string& token) {
  static const DecimalReader reader(wide_limits());
  const std::string padded = token + "\n" + std::string(64, '\n');
  const char* p = padded.data();
  double fast = NAN, slow = NAN;
  const bool is_fast = reader.read_fast(p, fast) && p == padded.data() + token.size();
  const DecimalFault fault = reader.read_slowly(token, slow);
  if (fault == DecimalFault::kNotFinite) slow = kInfinity;
  if (is_fast) {
    EXPECT_TRUE(std::isfinite(fast)) << token;
    EXPECT_EQ(fast, slow) << token << ": the two paths differ";
  }
  return slow;
}

class Exact {
 public:
  Exact() { mpq_init(value_); }
  ~Exact() { mpq_clear(value_); }
  Exact(const Exact&) = delete;
  mpq_ptr get() { return value_; }

 private:
  mpq_t value_;
};

// An oracle of its own: the exact decimal lies between the midpoints to the neighbours of `value`; on a midpoint only
// if the mantissa is even. REQUIRES a token without sign, `value` >= 0, exponents of at most four digits.
bool is_correctly_rounded(const std::string& token, double value) {
  const std::size_t e = token.find_first_of("eE");
  std::string digits = token.substr(0, e);
  long exponent = e == token.npos ? 0 : std::stol(token.substr(e + 1));
  if (const std::size_t dot = digits.find('.'); dot != digits.npos) {
    exponent -= static_cast<long>(digits.size() - dot - 1);
    digits.erase(dot, 1);
  }
  Exact exact, power, below, above, half;
  mpq_set_str(exact.get(), digits.c_str(), 10);
  mpz_ui_pow_ui(mpq_numref(power.get()), 10, static_cast<unsigned long>(std::labs(exponent)));
  exponent < 0 ? mpq_div(exact.get(), exact.get(), power.get())
               : mpq_mul(exact.get(), exact.get(), power.get());
  // Above the largest number the next would be 2^1024.
  const bool is_infinite = std::isinf(value);
  const double finite = is_infinite ? kLargest : value;
  mpq_set_d(above.get(), finite);
  if (finite == kLargest) {
    mpq_set_d(half.get(), std::ldexp(1.0, 970));
    mpq_add(above.get(), above.get(), half.get());
  } else {
    mpq_set_d(half.get(), std::nextafter(finite, kInfinity));
    mpq_add(above.get(), above.get(), half.get());
    mpq_div_2exp(above.get(), above.get(), 1);
  }
  if (is_infinite) return mpq_cmp(exact.get(), above.get()) >= 0;
  mpq_set_d(below.get(), value == 0 ? -kLeast : std::nextafter(value, -kInfinity));
  mpq_set_d(half.get(), value);
  mpq_add(below.get(), below.get(), half.get());
  mpq_div_2exp(below.get(), below.get(), 1);
  const bool is_even = (std::bit_cast<std::uint64_t>(value) & 1) == 0;
  const int low = mpq_cmp(exact.get(), below.get()), high = mpq_cmp(exact.get(), above.get());
  return is_even ? low >= 0 && high <= 0 : low > 0 && high < 0;
}

void expect_right(const std::string& token) {
  const double value = value_of(token);
  EXPECT_TRUE(is_correctly_rounded(token, value)) << token << " gave " << std::hexfloat << value;
}

// The exact decimal of m * 2^e.
std::string exact_decimal(std::uint64_t m, int e) {
  Exact value;
  mpz_set_ui(mpq_numref(value.get()), m);
  if (e >= 0) {
    mpz_mul_2exp(mpq_numref(value.get()), mpq_numref(value.get()), static_cast<unsigned long>(e));
  } else {
    // m 2^e = m 5^-e / 10^-e
    for (int i = 0; i < -e; ++i) mpz_mul_ui(mpq_numref(value.get()), mpq_numref(value.get()), 5);
  }
  char* const text = mpz_get_str(nullptr, 10, mpq_numref(value.get()));
  std::string result = text;
  std::free(text);
  return e >= 0 ? result : result + "e" + std::to_string(e);
}

TEST(Decimal, AdmitsExactlyTheGrammarOfTheReadingRule) {
  for (const char* token : {"0", "1", "-1", "+1", "1.", ".5", "-.5", "+1.e5", "1e5", "1E+5", "1e-5",
                            "00012", "1.50", "0e0", "-0", "12345678901234567890.5e-3"}) {
    EXPECT_EQ(fault_of(token), DecimalFault::kNone) << token;
  }
  for (const char* token : {"",
                            "+",
                            "-",
                            ".",
                            "-.",
                            "e5",
                            ".e5",
                            "1e",
                            "1e+",
                            "1,5",
                            "0x10",
                            "1.5.2",
                            "1e5.0",
                            "--1",
                            "+-1",
                            "1f",
                            "nan",
                            "inf",
                            "Infinity",
                            "1_0",
                            "1 ",
                            " 1",
                            "1e5e5",
                            "\xE2\x88\x92"
                            "1"}) {
    EXPECT_EQ(fault_of(token), DecimalFault::kSyntax) << token;
  }
}

TEST(Decimal, TheFastPathTakesNoWordThatTheGrammarRefuses) {
  const DecimalReader reader((ReadLimits()));
  for (const char* token : {"", "+", "-", ".", "-.", "e5", "x", "1e", "1e+", "1ex"}) {
    const std::string padded = token + std::string(64, '\n');
    const char* p = padded.data();
    double value = 0;
    EXPECT_FALSE(reader.read_fast(p, value)) << token;
    EXPECT_EQ(p, padded.data());
  }
}

TEST(Decimal, MinusZeroBecomesZero) {
  EXPECT_FALSE(std::signbit(value_of("-0")));
  EXPECT_FALSE(std::signbit(value_of("-0.000e-5")));
  EXPECT_FALSE(std::signbit(value_of("-1e-4000")));
  const DecimalReader reader((ReadLimits()));
  const std::string padded = "-0.0" + std::string(64, '\n');
  const char* p = padded.data();
  double value = -1;
  ASSERT_TRUE(reader.read_fast(p, value));
  EXPECT_FALSE(std::signbit(value));
}

TEST(Decimal, TheRangeEndsWhereRoundingSays) {
  EXPECT_EQ(fault_of("1e400"), DecimalFault::kNotFinite);
  EXPECT_EQ(fault_of("-1e309"), DecimalFault::kNotFinite);
  EXPECT_EQ(value_of("1e-400"), 0);
  EXPECT_EQ(value_of("1.7976931348623157e308"), kLargest);
  EXPECT_EQ(value_of("1.7976931348623158e308"), kLargest);
  EXPECT_EQ(fault_of("1.7976931348623159e308"), DecimalFault::kNotFinite);
  EXPECT_EQ(value_of("4.9406564584124654e-324"), kLeast);
  EXPECT_EQ(value_of("2.4703282292062328e-324"), kLeast);
  EXPECT_EQ(value_of("2.4703282292062327e-324"), 0);
  // Exactly half of the largest number's last bit above it: 2^1024 - 2^970.
  EXPECT_EQ(fault_of(exact_decimal((std::uint64_t{1} << 54) - 1, 970)), DecimalFault::kNotFinite);
  // Exactly half of the least number: a tie that goes to zero.
  EXPECT_EQ(value_of(exact_decimal(1, -1075)), 0);
}

TEST(Decimal, KnownHardCasesAreRight) {
  for (const char* token : {"9007199254740993",
                            "9007199254740992.5",
                            "9007199254740993.0000000000000000000000000001",
                            "2.2250738585072011e-308",
                            "2.2250738585072012e-308",
                            "2.2250738585072014e-308",
                            "6.631236846766476e-316",
                            "1.448997445238699",
                            "0.500000000000000166533453693773481063544750213623046875",
                            "3.518437208883201171875e13",
                            "62.5364939768271845828",
                            "8.10109172351e-10",
                            "1.50000000000000011102230246251565",
                            "0.99999999999999989",
                            "1e23",
                            "8.5e22",
                            "5e-324",
                            "7.2057594037927933e16",
                            "123456789012345678",
                            "9223372036854775808",
                            "18446744073709551615",
                            "18446744073709551616",
                            "0.1",
                            "1e22",
                            "1e-22",
                            "12345678901234567e22",
                            "7.4505805969238281e-09",
                            "0.30000000000000004",
                            "0.50000000000000000",
                            "1.00000000000000000000",
                            "9999999999999999999",
                            "0.00012345678901234567",
                            "1e308",
                            "1e-308"}) {
    expect_right(token);
  }
}

TEST(Decimal, HalfwayPointsAndTheirNeighboursAreRight) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::uint64_t m = (random() >> 11) | (std::uint64_t{1} << 52);
    const int e = static_cast<int>(random() % 400) - 200;
    const std::string tie = exact_decimal(2 * m + 1, e - 1);
    expect_right(tie);
    // One in a far digit above it, and below.
    const std::size_t at = tie.find('e');
    const std::string digits = tie.substr(0, at), tail = at == tie.npos ? "" : tie.substr(at);
    expect_right(digits + ".000000000000000000000000000000000000000001" + tail);
    if (digits.back() == '0') continue;
    std::string less = digits;
    less.back() = static_cast<char>(less.back() - 1);
    expect_right(less + ".99999999999999999999999999999999999" + tail);
  }
}

TEST(Decimal, TiesThatFitIntoTheFastPathGoToEven) {
  // m 2^e with a mantissa of 54 bits and at most 19 digits: a table cut after 128 bits sees them just below the tie.
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::uint64_t m = (random() >> 10) | (std::uint64_t{1} << 53) | 1;
    for (int e = -4; e <= 12; ++e) expect_right(exact_decimal(m, e));
  }
}

TEST(Decimal, SubnormalsAndTheirMidpointsAreRight) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 500; ++trial) {
    const std::uint64_t m = random() >> (12 + random() % 52);
    expect_right(exact_decimal(m, -1074));
    expect_right(exact_decimal(2 * m + 1, -1075));
  }
}

TEST(Decimal, ManyDigitsAreRight) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 500; ++trial) {
    std::string token;
    const std::size_t length = 1 + random() % 800;
    for (std::size_t i = 0; i < length; ++i) token += static_cast<char>('0' + random() % 10);
    token.insert(random() % (length + 1), ".");
    if (random() % 2 == 0) token += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
    expect_right(token);
  }
}

TEST(Decimal, AgreesWithFromCharsOnEveryShape) {
  std::mt19937_64 random(4);
  const char* const scale_text = std::getenv("VT_TEST_SCALE");
  const int scale = scale_text != nullptr ? std::atoi(scale_text) : 1;
  for (int trial = 0; trial < 200000 * scale; ++trial) {
    char token[64];
    const double value = std::bit_cast<double>(random() & 0x7FFFFFFFFFFFFFFF);
    if (!std::isfinite(value)) continue;
    const int digits = static_cast<int>(random() % 21);
    const char* const shapes[] = {"%.*g", "%.*e", "%#.*g"};
    std::snprintf(token, sizeof token, shapes[random() % 3], digits, value);
    double expected = 0;
    const std::from_chars_result result =
        std::from_chars(token, token + std::strlen(token), expected);
    if (result.ec != std::errc()) continue;  // the exact tests look there
    ASSERT_EQ(value_of(token), expected) << token;
  }
}

TEST(Decimal, ModelCoordinatesComeBackFromSeventeenDigits) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  const DecimalReader reader((ReadLimits()));
  int num_fast = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const double value = std::ldexp(uniform(random), static_cast<int>(random() % 40) - 30);
    char token[128] = {};
    std::snprintf(token, sizeof token, "%.17g", value);
    std::memset(token + std::strlen(token), '\n', 64);
    const char* p = token;
    double result = 0;
    if (!reader.read_fast(p, result)) continue;
    ++num_fast;
    ASSERT_EQ(result, value) << token;
  }
  EXPECT_GT(num_fast, 99990);  // the exact path is for the rare ones
}

TEST(Decimal, LimitsHoldAtNAndFailAtNPlusOne) {
  ReadLimits limits;
  limits.max_digits = 5;
  limits.max_exponent = 30;
  EXPECT_EQ(fault_of("123.45", limits), DecimalFault::kNone);
  EXPECT_EQ(fault_of("123.456", limits), DecimalFault::kDigits);
  EXPECT_EQ(fault_of("000001", limits), DecimalFault::kDigits);
  EXPECT_EQ(fault_of("1e30", limits), DecimalFault::kNone);
  EXPECT_EQ(fault_of("1e-30", limits), DecimalFault::kNone);
  EXPECT_EQ(fault_of("1e31", limits), DecimalFault::kExponent);
  EXPECT_EQ(fault_of("1e-31", limits), DecimalFault::kExponent);
  EXPECT_EQ(fault_of("0e99999999999999999999999", limits), DecimalFault::kExponent);
  const DecimalReader reader(limits);
  for (const char* token : {"123.456", "1e31", "000001"}) {
    const std::string padded = token + std::string(64, '\n');
    const char* p = padded.data();
    double value = 0;
    EXPECT_FALSE(reader.read_fast(p, value)) << token;
  }
}

TEST(PowersOfTen, AreCutAfter128Bits) {
  const internal::PowerOfTen* powers = internal::powers_of_ten();
  for (int q = internal::kMinPower; q <= internal::kMaxPower; ++q) {
    const internal::PowerOfTen& power = powers[q - internal::kMinPower];
    // low <= 10^q / 2^exponent < low + 1
    Exact lower, exact, ten;
    mpz_set_ui(mpq_numref(lower.get()), power.high);
    mpz_mul_2exp(mpq_numref(lower.get()), mpq_numref(lower.get()), 64);
    mpz_add_ui(mpq_numref(lower.get()), mpq_numref(lower.get()), power.low);
    mpz_ui_pow_ui(mpq_numref(ten.get()), 10, static_cast<unsigned long>(std::abs(q)));
    mpq_set_ui(exact.get(), 1, 1);
    q < 0 ? mpq_div(exact.get(), exact.get(), ten.get())
          : mpq_mul(exact.get(), exact.get(), ten.get());
    power.exponent < 0
        ? mpq_mul_2exp(exact.get(), exact.get(), static_cast<unsigned long>(-power.exponent))
        : mpq_div_2exp(exact.get(), exact.get(), static_cast<unsigned long>(power.exponent));
    EXPECT_GE(power.high >> 63, 1u) << q;
    EXPECT_LE(mpq_cmp(lower.get(), exact.get()), 0) << q;
    mpq_set_ui(ten.get(), 1, 1);
    mpq_add(lower.get(), lower.get(), ten.get());
    EXPECT_GT(mpq_cmp(lower.get(), exact.get()), 0) << q;
  }
}

}  // namespace
}  // namespace veritope
