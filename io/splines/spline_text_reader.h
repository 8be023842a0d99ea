// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_text_reader.h: what the readers of spline texts share: tokens, exact numbers, counts, errors with
// an entity.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "io/base/exact_number.h"
#include "io/base/scan.h"
#include "io/base/source.h"
#include "io/splines/number_budget.h"
#include "io/splines/read_splines.h"
#include "io/splines/spline_builder.h"

namespace veritope {

/// Functions return false after they set the error. p_ is the cursor.
class SplineTextReader {
 public:
  SplineTextReader(const Source& source, const ReadLimits& limits)
      : source_(source),
        limits_(limits),
        known_(within_default(limits)),
        p_(skip_byte_order_mark(source)),
        budget_(source.size()) {}

  /// REQUIRES that a function failed.
  Error take_error();
  /// The model as it is, and what was left out.
  SplineFile take() {
    SplineFile file;
    file.model = std::move(model_);
    file.left_out = std::move(left_out_);
    file.has_converted_shapes = has_converted_shapes_;
    file.beyond_default_limits = std::move(beyond_default_limits_);
    return file;
  }

 protected:
  /// Sets an error; its place is the line of `at`, and the entity if one is being read.
  bool fail(const char* at, Code code, std::string message);
  /// Fails with "<expected> expected, but there is <token>": kSyntax, or kTruncated at the end.
  bool fail_expected(const std::string& expected);
  /// Passes on an error of a library function: its code and sentence, with our place.
  bool fail_with(const char* at, const Error& error) { return fail(at, error.code, error.message); }
  /// Passes on an error of another reader of this file, which has its place.
  bool fail_as(Error error) {
    if (!error_) error_ = std::move(error);
    return false;
  }

  /// Skips blanks (VT and FF unless is_json_, too), line ends and, if has_comments_, # comments.
  void skip();
  /// The token at the cursor after blanks, not consumed; empty at the end of the file.
  std::string_view peek();
  bool is_at_end() { return peek().empty(); }

  bool read_number(Rational& value);
  /// Reads one number for each element of `into`.
  bool read_all(std::vector<Rational>& into);
  /// Reads `token` as `read` does (read_exact_decimal, read_exact_number); an error is placed at `at`.
  bool read_token(const char* at, std::string_view token, Rational& value,
                  DecimalFault (*read)(std::string_view, const ReadLimits&, Rational&));
  /// For numbers computed from those of the file: whether the budget allows one more.
  bool charge(const char* at, const Rational& value);
  /// x *= factor, if the budget allows its growth.
  bool multiply(const char* at, Rational& x, const Rational& factor);
  /// Reads an integer from `least` to `most`; `what` names it in errors.
  bool read_count(const char* what, std::uint64_t least, std::uint64_t most, std::uint64_t& value);
  bool read_integer(const char* what, std::int64_t& value);
  /// Whether the file can hold so many more numbers, at two bytes each; otherwise fails with
  /// kTruncated.
  bool check_announced(std::uint64_t count, const char* what);
  /// For N counts and a factor: their product, if it passes check_announced.
  template <std::size_t N>
  bool check_grid(const std::array<std::uint64_t, N>& counts, std::uint64_t components,
                  std::uint64_t& total);

  /// Builds the spline; an error is placed at `at`.
  template <std::size_t N>
  std::optional<BSpline<Rational, N>> build(const char* at, RawSpline<N> raw) {
    if (!charge_repeated(at, raw.points, raw.is_periodic)) return std::nullopt;
    auto spline = build_spline(std::move(raw));
    if (spline) return std::move(*spline);
    fail_with(at, spline.error());
    return std::nullopt;
  }

  /// The line of `at`, found without counting from the start again.
  std::uint64_t line_of(const char* at);
  Place place_of(const char* at);

  /// Begins the next entity, found at `at`; its shape comes later.
  SplineEntity begin_entity(const char* at);
  /// Adds the entity to the model.
  bool end_entity(SplineEntity entity);

  void leave_out(std::string what, std::string reason, bool is_geometry, std::uint64_t count = 1);

  std::uint64_t bytes_left() const { return static_cast<std::uint64_t>(source_.end - p_); }

  const Source& source_;
  const ReadLimits& limits_;
  const ReadLimits known_;  ///< the same, but digits and exponents within the default limits
  const char* p_;
  std::uint8_t ends_ = kTokenEnd;        ///< what ends a token
  bool has_comments_ = false;            ///< # to the end of the line
  bool is_json_ = false;                 ///< VT and FF are no blanks
  std::string_view own_tokens_;          ///< characters that are tokens of their own
  std::optional<std::uint64_t> entity_;  ///< the entity that is being read
  SplineModel model_;
  std::vector<LeftOut> left_out_;
  bool has_converted_shapes_ = false;
  NumberBudget budget_;

 private:
  /// Charges the budget for the points that periodic axes repeat: each axis at most doubles their number.
  bool charge_repeated(const char* at, const std::vector<Rational>& points,
                       std::span<const bool> is_periodic);

  static ReadLimits within_default(ReadLimits limits);
  /// Remembers a token that was read, perhaps under wider limits, if it is beyond the default limits.
  void note_long(const char* at, std::string_view token,
                 DecimalFault (*read)(std::string_view, const ReadLimits&, Rational&));
  Error limit_error(const char* at, std::string_view token, DecimalFault fault,
                    const ReadLimits& limits);

  std::optional<Error> error_, beyond_default_limits_;
  std::map<std::pair<std::string, std::string>, std::size_t> left_out_index_;
  const char* counted_ = nullptr;  ///< line_of has counted up to here
  std::uint64_t line_ = 1;
};

/// Runs the reader of a format: bool read(), take_error(), take().
template <typename Reader>
Result<SplineFile> run_reader(const Source& source, const ReadLimits& limits) {
  Reader reader(source, limits);
  if (!reader.read()) return reader.take_error();
  return reader.take();
}

/// Valid UTF-8 is unchanged; in other texts every byte is the Latin-1 character with its number.
std::string to_utf8(std::string_view text);

/// The formats. Errors as read_splines.
Result<SplineFile> read_itd(const Source& source, const ReadLimits& limits);
Result<SplineFile> read_g2(const Source& source, const ReadLimits& limits);
Result<SplineFile> read_mfem(const Source& source, const ReadLimits& limits);
Result<SplineFile> read_gismo(const Source& source, const ReadLimits& limits);
Result<SplineFile> read_spline_json(const Source& source, const ReadLimits& limits);

/// Reads the object of read_spline_json at `at`, which lies in another text, and moves `at` past it.
Result<SplineFile> read_spline_json_part(const Source& source, const ReadLimits& limits,
                                         const char*& at);

// ---- bodies

template <std::size_t N>
bool SplineTextReader::check_grid(const std::array<std::uint64_t, N>& counts,
                                  std::uint64_t components, std::uint64_t& total) {
  total = components;
  for (const std::uint64_t count : counts) {
    if (count != 0 && total > source_.size() / count) {
      std::string text;
      for (const std::uint64_t c : counts) text += (text.empty() ? "" : " x ") + std::to_string(c);
      return fail(p_, Code::kTruncated,
                  "a net of " + text + " control points is announced, more than the file can hold");
    }
    total *= count;
  }
  return check_announced(total, "numbers");
}

}  // namespace veritope
