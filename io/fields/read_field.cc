// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/fields/read_field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/base/decimal.h"
#include "io/base/exact_number.h"
#include "solids/micro/cage/principal_axes.h"

namespace veritope {
namespace {

constexpr std::size_t kMostTokenBytes = 4096;
// What columns may hold; the last one is a thickness.
constexpr std::array<std::string_view, 13> kNames = {"x",  "y",  "z",  "dx", "dy", "dz", "xx",
                                                     "yy", "zz", "xy", "yz", "zx", "t"};
constexpr std::size_t kVector = 3, kTensor = 6, kThickness = 12;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::string short_text(double x) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

class FieldReader {
 public:
  FieldReader(const Source& source, const ReadLimits& limits)
      : source_(source), limits_(limits), decimals_(limits) {}

  Result<FieldFile> read() {
    const char* at = skip_byte_order_mark(source_);
    while (at < source_.end) {
      const char* const end =
          std::find_if(at, source_.end, [](char c) { return c == '\n' || c == '\r'; });
      ++line_;
      if (const Status status = read_line({at, static_cast<std::size_t>(end - at)}); !status)
        return status.error();
      at = end;
      if (at < source_.end && *at == '\r') ++at;
      if (at < source_.end && *at == '\n' && (at == end || at[-1] == '\r')) ++at;
    }
    if (out_.field.size() == 0)
      return error_in_file(*source_.name, Code::kEmpty, "there is no vector in it");
    return std::move(out_);
  }

 private:
  Error error(Code code, std::string message) const {
    Error out = error_in_file(*source_.name, code, std::move(message));
    out.place.line = line_;
    return out;
  }

  Status read_line(std::string_view line) {
    const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
    if (start == line.size() || line[start] == '#') return ok_status();
    if (const Status status = split(line.substr(start)); !status) return status;
    if (columns_.empty()) {
      if (is_heading()) return read_heading();
      if (const Status status = count_columns(); !status) return status;
    }
    return read_row();
  }

  // Between two tokens: blanks with at most one comma or semicolon.
  Status split(std::string_view line) {
    tokens_.clear();
    bool is_open = true;  // a token has to follow
    for (std::size_t i = 0; i < line.size();) {
      if (is_blank(line[i])) {
        ++i;
      } else if (line[i] == ',' || line[i] == ';') {
        if (is_open) return error(Code::kSyntax, "a number is missing before a comma or semicolon");
        is_open = true;
        ++i;
      } else {
        const std::size_t begin = i;
        while (i < line.size() && !is_blank(line[i]) && line[i] != ',' && line[i] != ';') ++i;
        tokens_.push_back(line.substr(begin, i - begin));
        is_open = false;
      }
    }
    if (is_open)
      return error(Code::kSyntax, "a number is missing after the last comma or semicolon");
    return ok_status();
  }

  // The first line, if each of its words begins with a letter and none of them is a name of NaN or infinity.
  bool is_heading() const {
    return std::ranges::all_of(tokens_, [](std::string_view word) {
      if (word.front() == '"') word.remove_prefix(1);
      Rational unused;
      return !word.empty() && 'a' <= lower(word).front() && lower(word).front() <= 'z' &&
             read_exact_decimal(word, {}, unused) != DecimalFault::kNotFinite;
    });
  }

  Status read_heading() {
    std::array<bool, kNames.size()> is_there{};
    for (const std::string_view token : tokens_) {
      std::string name = lower(token);
      std::erase(name, '"');
      if (name == "thickness") name = "t";
      if (name == "xz" || name == "yx" || name == "zy") std::swap(name[0], name[1]);
      const auto found = std::ranges::find(kNames, name);
      if (found == kNames.end())
        return error(Code::kSyntax, "the column " + quoted(token) +
                                        " is not known; columns are x y z, dx dy dz or xx yy zz xy "
                                        "yz zx, and t");
      const auto number = static_cast<std::size_t>(found - kNames.begin());
      if (std::exchange(is_there[number], true))
        return error(Code::kSyntax, "the column " + quoted(token) + " is there twice");
      columns_.push_back(number);
    }
    return check_columns(is_there);
  }

  Status check_columns(const std::array<bool, kNames.size()>& is_there) {
    out_.has_tensors =
        std::any_of(&is_there[kTensor], &is_there[kThickness], [](bool b) { return b; });
    for (std::size_t i = 0; i < kThickness; ++i) {
      const bool is_needed = i < kVector || (i >= kTensor) == out_.has_tensors;
      if (is_needed && !is_there[i])
        return error(Code::kSyntax, "there is no column " + std::string(kNames[i]));
      if (!is_needed && is_there[i])
        return error(Code::kSyntax, "the column " + std::string(kNames[i]) +
                                        " does not go with those of a tensor");
    }
    return ok_status();
  }

  // Without a heading the number of columns tells what they are.
  Status count_columns() {
    const std::size_t n = tokens_.size();
    if (n != 6 && n != 7 && n != 9 && n != 10)
      return error(Code::kSyntax,
                   "a line has 6 numbers (x y z dx dy dz) or 9 (x y z and the tensor xx "
                   "yy zz xy yz zx), and one more with a thickness, but there are " +
                       std::to_string(n));
    out_.has_tensors = n >= 9;
    for (std::size_t i = 0; i < kThickness; ++i)
      if (i < kVector || (i >= kTensor) == out_.has_tensors) columns_.push_back(i);
    if (n == 7 || n == 10) columns_.push_back(kThickness);
    return ok_status();
  }

  std::string why_not(DecimalFault fault) const {
    switch (fault) {
      case DecimalFault::kNotFinite: return "is not finite";
      case DecimalFault::kDigits:
        return "has more digits than --max-digits " + std::to_string(limits_.max_digits);
      case DecimalFault::kExponent:
        return "has an exponent over --max-exponent " + std::to_string(limits_.max_exponent);
      default: return "is not a number";
    }
  }

  Status read_number(std::string_view token, std::size_t column, double& value) const {
    DecimalFault fault = DecimalFault::kSyntax;
    if (token.size() <= kMostTokenBytes) {
      const char* p = token.data();
      if (decimals_.read_fast(p, value) && p == token.data() + token.size()) return ok_status();
      fault = decimals_.read_slowly(token, value);
      if (fault == DecimalFault::kSyntax) {
        Rational exact;  // knows fractions, hexadecimal numbers, and the words for NaN and infinity
        fault = read_exact_number(token, limits_, exact);
        if (fault == DecimalFault::kNone) value = nearest_double(exact);
      }
    }
    if (fault == DecimalFault::kNone && std::isfinite(value)) return ok_status();
    if (fault == DecimalFault::kNone) fault = DecimalFault::kNotFinite;
    const bool is_limit = fault == DecimalFault::kDigits || fault == DecimalFault::kExponent;
    return error(is_limit ? Code::kOverLimit : Code::kSyntax,
                 std::string(kNames[column]) + ": " + quoted(token) + " " + why_not(fault));
  }

  Status read_row() {
    if (tokens_.size() != columns_.size())
      return error(Code::kSyntax, "a line has " + std::to_string(columns_.size()) +
                                      " numbers, like the first one, but there are " +
                                      std::to_string(tokens_.size()));
    if (out_.field.size() == kMaxFitVectors)
      return error(Code::kOverLimit,
                   "there are more than " + std::to_string(kMaxFitVectors) + " vectors");
    std::array<double, kNames.size()> values{};
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (const Status status = read_number(tokens_[i], columns_[i], values[columns_[i]]); !status)
        return status;
    Point3d axis = {values[kVector], values[kVector + 1], values[kVector + 2]};
    if (out_.has_tensors) {
      SymmetricTensor tensor;
      std::copy_n(&values[kTensor], 6, tensor.begin());
      const PrincipalAxes axes = approx_principal_axes(tensor);
      if (!axes.has_first())
        return error(Code::kBadArgument,
                     "the tensor has no first principal direction: its greatest principal values "
                     "are " +
                         short_text(axes.values[0]) + " and " + short_text(axes.values[1]));
      axis = axes.directions[0];
    } else if (axis == Point3d{}) {
      return error(Code::kBadArgument, "the direction is 0");
    }
    out_.field.points.push_back({values[0], values[1], values[2]});
    out_.field.axes.push_back(axis);
    if (std::ranges::find(columns_, kThickness) != columns_.end())
      out_.field.thickness.push_back(values[kThickness]);
    out_.lines.push_back(line_);
    return ok_status();
  }

  const Source& source_;
  ReadLimits limits_;
  DecimalReader decimals_;
  std::uint64_t line_ = 0;
  std::vector<std::string_view> tokens_;
  std::vector<std::size_t> columns_;  // numbers of names
  FieldFile out_;
};

}  // namespace

Result<FieldFile> read_field(const Source& source, const ReadLimits& limits) {
  return FieldReader(source, limits).read();
}

}  // namespace veritope
