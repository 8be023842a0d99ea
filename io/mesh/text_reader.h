// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/text_reader.h: numbers as whole tokens of a text, with the errors that go with them.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "io/base/decimal.h"
#include "io/base/scan.h"
#include "io/base/source.h"
#include "io/mesh/parsed_mesh.h"

namespace veritope {

/// The base of the text readers. Functions return false after they set the error.
class TextReader {
 public:
  /// `ends`: kTokenEnd or kTokenEndOrComment.
  TextReader(const Source& source, const ReadLimits& limits, std::uint8_t ends)
      : source_(source), limits_(limits), decimals_(limits), ends_(ends), text_end_(source.end) {}

 protected:
  /// Reads one decimal at p, up to the end of its token.
  bool read_decimal(const char*& p, double& value) {
    const char* q = p;
    if (decimals_.read_fast(q, value) && has_class(*q, ends_)) [[likely]] {
      p = q;
      return true;
    }
    return read_decimal_slowly(p, value);
  }
  /// Reads three decimals after blanks, all on this line.
  bool read_position(const char*& p, Vec3d& position) {
    double xyz[3];
    for (double& value : xyz) {
      p = skip_blanks(p);
      if (!read_decimal(p, value)) return false;
    }
    // + 0.0 turns -0 into +0.
    position = {xyz[0] + 0.0, xyz[1] + 0.0, xyz[2] + 0.0};
    return true;
  }
  /// Reads one integer at p; the token must end after it.
  bool read_integer(const char*& p, ScannedInteger& value) {
    const char* const token = p;
    value = scan_integer(p);
    if (value.is_valid && has_class(*p, ends_) && value.num_digits <= limits_.max_digits) {
      return true;
    }
    return fail_integer(token, value);
  }

  /// Sets the error and returns false. The place is the line of `at`.
  bool fail(const char* at, Code code, std::string message);
  bool fail_integer(const char* token, const ScannedInteger& value);
  bool fail_faces(const char* at);
  bool fail_vertices(const char* at);
  /// Fails with "<expected> instead of <token at `at`>": kSyntax, or kTruncated at the end of the
  /// file.
  bool fail_expected(const char* at, const std::string& expected);
  /// Finds the line only now, because a joined line may fail once and then be read well. REQUIRES that a function
  /// failed.
  Error take_error();

  const Source& source_;
  const ReadLimits& limits_;
  const DecimalReader decimals_;
  const std::uint8_t ends_;
  const char* text_end_;          ///< end of the text being read: the source's, or a joined line's
  const char* anchor_ = nullptr;  ///< where in the source a joined line begins

 private:
  struct Fault {
    const char* at;
    Code code;
    std::string message;
  };
  bool read_decimal_slowly(const char*& p, double& value);
  std::optional<Fault> fault_;
};

}  // namespace veritope
