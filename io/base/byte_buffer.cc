// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/byte_buffer.h"

#include <sys/mman.h>

#include <cstdlib>
#include <cstring>
#include <new>

#include "robust/base/check.h"

namespace veritope {

void ByteBuffer::Free::operator()(unsigned char* block) const { std::free(block); }

void ByteBuffer::grow(std::size_t capacity) {
  constexpr std::size_t kHugePage = std::size_t{2} << 20;
  if (capacity > SIZE_MAX - kPadding - kHugePage) throw std::bad_alloc();
  const std::size_t bytes = capacity + kPadding;
  const std::size_t alignment = bytes >= 2 * kHugePage ? kHugePage : 64;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  auto* block = static_cast<unsigned char*>(std::aligned_alloc(alignment, rounded));
  if (block == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (alignment == kHugePage) ::madvise(block, rounded, MADV_HUGEPAGE);  // advice: may fail
#endif
  if (size_ > 0) std::memcpy(block, block_.get(), size_);
  block_.reset(block);
  capacity_ = capacity;
}

void ByteBuffer::set_size(std::size_t size) {
  VT_CHECK(size <= capacity_, "more bytes than the buffer has room for");
  size_ = size;
  std::memset(block_.get() + size, '\n', kPadding);
}

ByteBuffer copy_to_buffer(std::span<const unsigned char> bytes) {
  ByteBuffer buffer(bytes.size());
  if (!bytes.empty()) std::memcpy(buffer.data(), bytes.data(), bytes.size());
  buffer.set_size(bytes.size());
  return buffer;
}

}  // namespace veritope
