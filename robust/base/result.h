// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/result.h: a value, or an error with its code, its place and a sentence.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "robust/base/check.h"

namespace veritope {

/// Why a request was refused. One line of meaning each; the sentence in Error says the rest.
enum class Code {
  kCannotOpen,       ///< the file does not exist, is a directory, or may not be read
  kEmpty,            ///< there is nothing in it: no bytes, or no triangle
  kForeignFormat,    ///< it is recognisably something else (gzip, UTF-16, a git-lfs pointer, ...)
  kUnknownFormat,    ///< neither the name nor the content says which reader applies
  kSyntax,           ///< a token, keyword or header line that the format does not allow there
  kTruncated,        ///< the data end before what the header or the grammar announces
  kNotFinite,        ///< a coordinate is NaN, infinite, or rounds to infinity
  kIndexOutOfRange,  ///< an index that names no vertex
  kOverLimit,        ///< a limit (bytes, faces, digits, exponent) is exceeded
  kLossy,            ///< the requested conversion would change the model
  kCannotWrite,      ///< the output could not be written; nothing was left behind
  kInterrupted,      ///< the user stopped it
  kBadArgument,      ///< a parameter outside its documented range
  kBadSpline,        ///< knots, a degree, a weight or a number of control points that no spline has
  kBadEnvironment,   ///< this process computes in a way that the predicates do not allow (fp_guard.h)
};

/// The stable lower-case name of a code, for reports: "index-out-of-range".
const char* code_name(Code code);

/// Where in the input: only what is known is set. Lines count from 1; bytes, faces, vertices and entities (the curves,
/// surfaces and volumes of a spline file, in file order) from 0.
struct Place {
  std::string file;
  std::optional<std::uint64_t> line;
  std::optional<std::uint64_t> byte;
  std::optional<std::uint64_t> face;
  std::optional<std::uint64_t> vertex;
  std::optional<std::uint64_t> entity;
};

struct Error {
  Code code = Code::kBadArgument;
  Place place;
  std::string message;  ///< a sentence with the offending value, without the place
};

/// The error of a parameter outside its documented range.
inline Error bad_argument(std::string message) {
  return Error{Code::kBadArgument, {}, std::move(message)};
}

/// "part.obj: line 12: <message>"
std::string to_string(const Error& error);

/// Either a T or an Error.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// REQUIRES has_value().
  T& value() & { return require(), std::get<0>(state_); }
  const T& value() const& { return require(), std::get<0>(state_); }
  T&& value() && { return require(), std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// REQUIRES !has_value().
  const Error& error() const {
    VT_CHECK(!has_value(), "error() of a Result that holds a value");
    return std::get<1>(state_);
  }

 private:
  void require() const { VT_CHECK(has_value(), "value() of a Result that holds an error"); }
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
using Status = Result<std::monostate>;
inline Status ok_status() { return Status(std::monostate{}); }

}  // namespace veritope
