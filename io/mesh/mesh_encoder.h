// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/mesh_encoder.h: the bytes of a mesh file, piece by piece.
#pragma once
#include <algorithm>
#include <charconv>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>

#include "io/mesh/write_mesh.h"

namespace veritope {

/// Collects text and passes it on in large pieces. After an error nothing more is passed on.
class ChunkedOutput {
 public:
  using Sink = std::function<Status(std::string_view)>;
  explicit ChunkedOutput(Sink sink) : sink_(std::move(sink)), status_(ok_status()) {}

  void text(std::string_view piece) {
    buffer_.append(piece);
    if (buffer_.size() >= kChunk) pass_on();
  }
  /// The shortest decimal that reads back as `value`, or an integer.
  template <typename Number>
  void number(Number value) {
    char digits[32];
    const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, value);
    text({digits, static_cast<std::size_t>(end.ptr - digits)});
  }
  /// The bytes of a number, in this order or reversed.
  template <typename Number>
  void binary(Number value, bool is_big_endian = false) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (is_big_endian) std::reverse(bytes, bytes + sizeof value);
    text({bytes, sizeof value});
  }
  Status finish() { return pass_on(), std::move(status_); }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 20;
  void pass_on() {
    if (status_ && !buffer_.empty()) status_ = sink_(buffer_);
    buffer_.clear();
  }
  Sink sink_;
  Status status_;
  std::string buffer_;
};

/// The nearest binary32, ties to even; nothing if that is infinite. -0 becomes +0.
std::optional<float> to_binary32(double value);

/// Whether the options round coordinates to binary32.
bool is_rounding(const WriteOptions& options);

/// REQUIRES a valid combination of options, and coordinates that to_binary32 accepts if
/// is_rounding(options).
void encode_mesh(const TriangleMesh& mesh, const WriteOptions& options, ChunkedOutput& out);

}  // namespace veritope
