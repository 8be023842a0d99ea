// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/balls/read_ball.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace veritope {
namespace {

constexpr int kMostDigits = 18;

class BallReader {
 public:
  explicit BallReader(const Source& source) : source_(source), at_(source.begin) {}

  Result<BallFile> read() {
    BallFile file;
    file.bytes = source_.size();
    Ball& b = file.ball;
    const bool done = word("ball\n") && word("centre ") && number(b.centre[0]) && word(" ") &&
                      number(b.centre[1]) && word(" ") && number(b.centre[2]) &&
                      word("\nradius ") && number(b.radius) && word("\n");
    if (done && at_ != source_.end) fail(Code::kSyntax, "the file goes on behind the radius");
    if (error_) return std::move(*error_);
    return file;
  }

 private:
  bool fail(Code code, const std::string& why) {
    error_ = error_at_line(source_, at_, code, why);
    return false;
  }
  std::string_view rest() const { return {at_, static_cast<std::size_t>(source_.end - at_)}; }

  bool word(std::string_view expected) {
    if (!rest().starts_with(expected))
      return fail(Code::kSyntax, "expected " + quoted(expected) + ", found " + quoted(rest()));
    at_ += expected.size();
    return true;
  }

  bool number(ShortDecimal& out) {
    const bool is_negative = rest().starts_with('-');
    const char* p = at_ + (is_negative ? 1 : 0);
    int digits = 0, decimals = 0, last = 0;
    bool has_point = false;
    for (; p < source_.end && ((*p >= '0' && *p <= '9') || (*p == '.' && !has_point && digits > 0));
         ++p) {
      last = *p;
      has_point = has_point || *p == '.';
      if (*p == '.') continue;
      if (++digits > kMostDigits) return fail(Code::kOverLimit, "a number has more than 18 digits");
      if (has_point) ++decimals;
      out.digits = 10 * out.digits + (*p - '0');
    }
    if (digits == 0 || last == '.')
      return fail(Code::kSyntax, "expected a decimal, found " + quoted(rest()));
    for (; decimals > 0 && out.digits % 10 == 0; --decimals) out.digits /= 10;
    out.decimals = static_cast<std::uint8_t>(decimals);
    if (is_negative) out.digits = -out.digits;
    at_ = p;
    return true;
  }

  const Source& source_;
  const char* at_;
  std::optional<Error> error_;
};

}  // namespace

bool looks_like_ball(const Source& source) {
  return std::string_view(source.begin, static_cast<std::size_t>(source.size()))
      .starts_with("ball\n");
}

Result<BallFile> read_ball(BallFormat format, const Source& source, const ReadLimits&) {
  Result<BallFile> file = BallReader(source).read();
  if (file) file->format = format;
  return file;
}

}  // namespace veritope
