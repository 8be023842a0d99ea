// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/byte_buffer.h: the bytes of a file in one block, followed by line feeds.
#pragma once
#include <cstddef>
#include <memory>
#include <span>

namespace veritope {

/// Uninitialised memory with room for `capacity()` bytes and kPadding line feeds after the used ones, so that
/// a scan of text needs no end test within a line and may load words. Large blocks ask for huge pages.
class ByteBuffer {
 public:
  static constexpr std::size_t kPadding = 64;

  ByteBuffer() = default;
  explicit ByteBuffer(std::size_t capacity) { grow(capacity); }

  unsigned char* data() { return block_.get(); }
  const unsigned char* data() const { return block_.get(); }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }

  /// Keeps the used bytes. Throws std::bad_alloc.
  void grow(std::size_t capacity);

  /// Sets the number of used bytes and writes the padding. REQUIRES size <= capacity().
  void set_size(std::size_t size);

 private:
  struct Free {
    void operator()(unsigned char* block) const;
  };
  std::unique_ptr<unsigned char[], Free> block_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// A copy of `bytes` with padding.
ByteBuffer copy_to_buffer(std::span<const unsigned char> bytes);

}  // namespace veritope
