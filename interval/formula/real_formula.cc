// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/formula/real_formula.h"

#include <algorithm>
#include <array>
#include <optional>

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr std::string_view kPiName = "pi", kRandomName = "rand";

struct FormulaFunction {
  std::string_view name;
  FormulaOp op;
  bool is_of_many;  // two arguments or more, and not one
};
constexpr std::array<FormulaFunction, 7> kFunctions = {{
    {"abs", FormulaOp::kAbs, false},
    {"cos", FormulaOp::kCos, false},
    {"exp", FormulaOp::kExp, false},
    {"max", FormulaOp::kMax, true},
    {"min", FormulaOp::kMin, true},
    {"sin", FormulaOp::kSin, false},
    {"sqrt", FormulaOp::kSqrt, false},
}};

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_decimal_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter_or_digit(char c) { return is_letter(c) || is_decimal_digit(c); }

bool is_variable_name(std::string_view name) {
  const auto is_function = [&](const FormulaFunction& f) { return f.name == name; };
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), is_letter_or_digit) && name != kPiName &&
         name != kRandomName && std::none_of(kFunctions.begin(), kFunctions.end(), is_function);
}

std::string joined_names(std::span<const std::string> names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out.empty() ? "none" : out;
}

}  // namespace

std::string quoted_formula(std::string_view text) {
  constexpr std::size_t kMostShown = 60;
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text.substr(0, kMostShown)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte <= '~') {
      out += c;
    } else {
      out += "\\x";
      out += kHexDigits[byte / 16];
      out += kHexDigits[byte % 16];
    }
  }
  return out + (text.size() > kMostShown ? "...\"" : "\"");
}

bool RealFormula::depends_on(std::size_t variable) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const FormulaNode& node) {
    return node.op == FormulaOp::kVariable && node.a == variable;
  });
}
bool RealFormula::is_random() const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [](const FormulaNode& node) { return node.op == FormulaOp::kRandom; });
}

/// Descends along the grammar. A method returns the number of its node, or nothing once error_ is set.
class FormulaParser {
 public:
  FormulaParser(std::string_view text, std::span<const std::string> variables) : text_(text) {
    out_.text_ = text;
    out_.variables_.assign(variables.begin(), variables.end());
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const auto others = variables.first(i);
      VT_CHECK(is_variable_name(variables[i]) &&
                   std::find(others.begin(), others.end(), variables[i]) == others.end(),
               "the name of a variable of a formula");
    }
  }

  Result<RealFormula> parse() {
    if (text_.size() > RealFormula::kMostCharacters)
      return Error{Code::kOverLimit,
                   {},
                   "the formula has " + std::to_string(text_.size()) + " characters; at most " +
                       std::to_string(RealFormula::kMostCharacters) + " are allowed"};
    skip_blanks();
    const Node formula = sum();
    if (formula && at_ < text_.size()) {
      if (text_[at_] == ')') {
        fail(at_, "this parenthesis was not opened");
      } else {
        expected("an operator");
      }
    }
    if (error_) return *error_;
    return std::move(out_);
  }

 private:
  using Node = std::optional<std::uint32_t>;

  Node fail(std::size_t at, const std::string& what, Code code = Code::kSyntax) {
    if (!error_) error_ = Error{code, {}, "column " + std::to_string(at + 1) + ": " + what};
    return std::nullopt;
  }
  // `why` completes the sentence where the symbol alone does not explain itself.
  Node expected(const std::string& what, const std::string& why = "") {
    return fail(at_, what + " expected, but there is " + next_token() + why);
  }
  std::string next_token() const {
    if (at_ == text_.size()) return "the end";
    return quoted_formula(is_letter_or_digit(text_[at_]) ? word_at(at_) : text_.substr(at_, 1));
  }
  std::string_view word_at(std::size_t begin) const {
    std::size_t end = begin;
    while (end < text_.size() && is_letter_or_digit(text_[end])) ++end;
    return text_.substr(begin, end - begin);
  }

  void skip_blanks() {
    constexpr std::string_view kBlanks = " \t\r\n";
    while (at_ < text_.size() && kBlanks.find(text_[at_]) != kBlanks.npos) ++at_;
  }
  bool sees(char c) const { return at_ < text_.size() && text_[at_] == c; }
  // Takes bytes up to `end` and the blanks after them.
  void take_until(std::size_t end) {
    end_ = at_ = end;
    skip_blanks();
  }
  bool take(char c) {
    if (!sees(c)) return false;
    take_until(at_ + 1);
    return true;
  }

  Node add(FormulaNode node, std::size_t begin) {
    node.begin = static_cast<std::uint32_t>(begin);
    node.end = static_cast<std::uint32_t>(end_);
    out_.nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(out_.nodes_.size() - 1);
  }
  Node add(FormulaOp op, std::uint32_t a, std::uint32_t b, std::size_t begin) {
    FormulaNode node;
    node.op = op, node.a = a, node.b = b;
    return add(std::move(node), begin);
  }

  // first { symbol next } for one of two symbols of equal strength, from the left.
  template <typename Next>
  Node chain(char first_symbol, FormulaOp first_op, char second_symbol, FormulaOp second_op,
             Next next) {
    const std::size_t begin = at_;
    Node left = next();
    while (left && (sees(first_symbol) || sees(second_symbol))) {
      const FormulaOp op = sees(first_symbol) ? first_op : second_op;
      take_until(at_ + 1);
      const Node right = next();
      left = right ? add(op, *left, *right, begin) : std::nullopt;
    }
    return left;
  }
  Node sum() {
    return chain('+', FormulaOp::kAdd, '-', FormulaOp::kSubtract, [&] { return product(); });
  }
  Node product() {
    return chain('*', FormulaOp::kMultiply, '/', FormulaOp::kDivide, [&] { return factor(); });
  }

  Node factor() {
    const std::size_t begin = at_;
    if (!sees('-')) return power();
    return deeper([&]() -> Node {
      take('-');
      const Node operand = factor();
      return operand ? add(FormulaOp::kNegate, *operand, 0, begin) : std::nullopt;
    });
  }
  Node power() {
    const std::size_t begin = at_;
    const Node base = atom();
    if (!base || !sees('^')) return base;
    return deeper([&]() -> Node {
      take('^');
      const Node exponent = factor();
      return exponent ? add(FormulaOp::kPower, *base, *exponent, begin) : std::nullopt;
    });
  }

  Node atom() {
    if (at_ == text_.size()) return expected("a number, a name, - or (");
    const char c = text_[at_];
    if (is_decimal_digit(c) || c == '.') return number();
    if (is_letter(c)) return named();
    if (c != '(') return expected("a number, a name, - or (");
    return deeper([&]() -> Node {
      const std::size_t open = at_;
      take('(');
      const Node inside = sum();
      return inside && close(open) ? inside : std::nullopt;
    });
  }
  bool close(std::size_t open) {
    if (take(')')) return true;
    if (at_ == text_.size()) {
      fail(open, "the parenthesis of " + quoted_formula(text_.substr(open)) + " is not closed");
    } else {
      expected("an operator or )");
    }
    return false;
  }

  // What `inside` reads is one level deeper.
  template <typename Inside>
  Node deeper(Inside inside) {
    if (depth_ == RealFormula::kMostDepth)
      return fail(at_,
                  "parentheses, functions, signs and exponents are nested more than " +
                      std::to_string(RealFormula::kMostDepth) + " deep at " +
                      quoted_formula(text_.substr(at_)),
                  Code::kOverLimit);
    ++depth_;
    const Node out = inside();
    --depth_;
    return out;
  }

  Node named() {
    const std::size_t begin = at_;
    const std::string_view name = word_at(begin);
    take_until(begin + name.size());
    const auto& variables = out_.variables_;
    const auto variable = std::find(variables.begin(), variables.end(), name);
    if (variable != variables.end())
      return add(FormulaOp::kVariable, static_cast<std::uint32_t>(variable - variables.begin()), 0,
                 begin);
    if (name == kPiName) return add(FormulaOp::kPi, 0, 0, begin);
    const auto function = std::find_if(kFunctions.begin(), kFunctions.end(),
                                       [&](const FormulaFunction& f) { return f.name == name; });
    if (function == kFunctions.end() && name != kRandomName) return unknown(name, begin);
    if (!sees('(')) return expected("(", " after the function " + std::string(name));
    return deeper(
        [&] { return name == kRandomName ? random_value(begin) : call(*function, begin); });
  }
  Node unknown(std::string_view name, std::size_t begin) {
    if (sees('('))
      return fail(begin, quoted_formula(name) +
                             " is not a function; the functions are abs, cos, exp, max, "
                             "min, rand, sin and sqrt");
    return fail(begin, quoted_formula(name) + " is not a variable here; the variables are " +
                           joined_names(out_.variables_) + ", and pi is a constant");
  }

  Node call(const FormulaFunction& function, std::size_t begin) {
    const std::size_t open = at_;
    take('(');
    Node value = sum();
    if (!value) return value;
    if (function.is_of_many) {
      if (!sees(','))
        return expected("a comma",
                        ": " + std::string(function.name) + " has two arguments or more");
      while (take(',')) {
        const Node other = sum();
        if (!other) return other;
        value = add(function.op, *value, *other, begin);
      }
    } else if (sees(',')) {
      return expected(")", ": " + std::string(function.name) + " has one argument");
    }
    if (!close(open)) return std::nullopt;
    if (!function.is_of_many) return add(function.op, *value, 0, begin);
    // Only now the text of the call is known.
    out_.nodes_[*value].end = static_cast<std::uint32_t>(end_);
    return value;
  }

  Node random_value(std::size_t begin) {
    const std::size_t open = at_;
    take('(');
    const std::string_view digits = word_at(at_);
    FormulaNode node;
    node.op = FormulaOp::kRandom;
    constexpr std::size_t kMostDigits = 20;
    if (digits.empty() || digits.size() > kMostDigits ||
        !std::all_of(digits.begin(), digits.end(), is_decimal_digit) ||
        Integer::from_decimal(digits).bit_length() > 64)
      return expected("a seed", ": seeds of rand are integers from 0 to 18446744073709551615");
    node.seed = Integer::from_decimal(digits).low_bits();
    take_until(at_ + digits.size());
    if (!sees(')') && at_ < text_.size()) return expected(")", " after the seed of rand");
    return close(open) ? add(std::move(node), begin) : std::nullopt;
  }

  Node number() {
    const std::size_t begin = at_;
    std::string digits;
    std::int64_t exponent = 0;  // of ten
    std::size_t end = begin;
    bool has_point = false;
    for (; end < text_.size(); ++end) {
      if (text_[end] == '.' && !has_point) {
        has_point = true;
        continue;
      }
      if (!is_decimal_digit(text_[end])) break;
      digits += text_[end];
      exponent -= has_point ? 1 : 0;
    }
    if (digits.empty()) return expected("a digit beside the point");
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      const std::optional<std::int64_t> written = decimal_exponent(begin, &end);
      if (!written) return std::nullopt;
      exponent += *written;
    }
    FormulaNode node;
    const Integer ten(10);
    node.number = Rational(Integer::from_decimal(digits));
    if (exponent > 0) node.number *= Rational(power_of(ten, exponent));
    if (exponent < 0) node.number /= Rational(power_of(ten, -exponent));
    if (Rational::power_of_two(RealFormula::kMostExponent) < node.number)
      return fail(begin,
                  "the number " + quoted_formula(text_.substr(begin, end - begin)) + " exceeds 2^" +
                      std::to_string(RealFormula::kMostExponent),
                  Code::kOverLimit);
    take_until(end);
    return add(std::move(node), begin);
  }
  static Integer power_of(const Integer& base, std::int64_t n) {
    return veritope::power(base, static_cast<std::uint64_t>(n));
  }
  // *end is the place of the letter, and then that after the exponent.
  std::optional<std::int64_t> decimal_exponent(std::size_t begin, std::size_t* end) {
    std::size_t i = *end + 1;
    const bool is_negative = i < text_.size() && text_[i] == '-';
    if (i < text_.size() && (text_[i] == '-' || text_[i] == '+')) ++i;
    const std::size_t first = i;
    std::int64_t value = 0;
    for (; i < text_.size() && is_decimal_digit(text_[i]); ++i)
      value = std::min<std::int64_t>(10 * value + (text_[i] - '0'),
                                     RealFormula::kMostDecimalExponent + 1);
    const std::string shown = quoted_formula(text_.substr(begin, i - begin));
    if (i == first)
      return fail(begin, "the exponent of the number " + shown + " has no digits"), std::nullopt;
    if (value > RealFormula::kMostDecimalExponent)
      return fail(begin,
                  "the exponent of the number " + shown + " is beyond " +
                      std::to_string(RealFormula::kMostDecimalExponent),
                  Code::kOverLimit),
             std::nullopt;
    *end = i;
    return is_negative ? -value : value;
  }

  std::string_view text_;
  std::size_t at_ = 0, end_ = 0;  // the next symbol, and the end of the last one
  int depth_ = 0;
  std::optional<Error> error_;
  RealFormula out_;
};

Result<RealFormula> parse_formula(std::string_view text, std::span<const std::string> variables) {
  return FormulaParser(text, variables).parse();
}

}  // namespace veritope
