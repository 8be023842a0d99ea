// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/vertex_table.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <new>
#include <random>

#include "robust/base/check.h"

namespace veritope {
namespace {

std::uint64_t process_key() {
  static const std::uint64_t key = [] {
    std::random_device device;
    return (std::uint64_t{device()} << 32) | device();
  }();
  return key;
}

std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
  __extension__ using Word2 = unsigned __int128;
  const Word2 product = static_cast<Word2>(a) * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

}  // namespace

VertexTable::VertexTable() : VertexTable(process_key()) {}

void VertexTable::Free::operator()(Slot* slots) const { std::free(slots); }

std::uint64_t VertexTable::hash(const Vec3d& p) const {
  const std::uint64_t xy = fold(std::bit_cast<std::uint64_t>(p.x) ^ key_,
                                std::bit_cast<std::uint64_t>(p.y) ^ 0x9E3779B97F4A7C15);
  return fold(xy ^ 0xD6E8FEB86659FD93, std::bit_cast<std::uint64_t>(p.z) ^ std::rotl(key_, 32));
}

void VertexTable::reserve(std::size_t num) {
  VT_CHECK(num_ == 0, "reserve() after insert()");
  if (num > 0) rehash(std::bit_ceil(num + num / 2), nullptr);
}

void VertexTable::rehash(std::size_t num_slots, const Vec3d* store) {
  constexpr std::size_t kHugePage = std::size_t{2} << 20;
  const std::size_t bytes = num_slots * sizeof(Slot);
  void* block = nullptr;
  if (bytes >= kHugePage) {
    block = std::aligned_alloc(kHugePage, bytes);
    if (block == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    ::madvise(block, bytes, MADV_HUGEPAGE);
#endif
    std::fill_n(static_cast<Slot*>(block), num_slots, Slot{0, 0});
  } else {
    block = std::calloc(num_slots, sizeof(Slot));
    if (block == nullptr) throw std::bad_alloc();
  }
  slots_.reset(static_cast<Slot*>(block));
  num_slots_ = num_slots;
  for (std::size_t id = 0; id < num_; ++id) {
    const std::uint64_t h = hash(store[id]);
    std::size_t at = h & (num_slots_ - 1);
    while (slots_[at].id_plus_1 != 0) at = (at + 1) & (num_slots_ - 1);
    slots_[at] = {static_cast<std::uint32_t>(h >> 32), static_cast<std::uint32_t>(id + 1)};
  }
}

void VertexTable::insert(std::span<const Vec3d> points, Vec3d* store, std::uint32_t* ids) {
  // The table is at most 3/4 full.
  if ((num_ + points.size()) * 4 > num_slots_ * 3) {
    rehash(std::bit_ceil(std::max<std::size_t>(256, (num_ + points.size()) * 2)), store);
  }
  std::uint64_t hashes[kBatch];
  for (std::size_t i = 0; i < points.size(); ++i) {
    hashes[i] = hash(points[i]);
    __builtin_prefetch(&slots_[hashes[i] & (num_slots_ - 1)], 1);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto tag = static_cast<std::uint32_t>(hashes[i] >> 32);
    std::size_t at = hashes[i] & (num_slots_ - 1);
    for (;; at = (at + 1) & (num_slots_ - 1)) {
      Slot& slot = slots_[at];
      if (slot.id_plus_1 == 0) {
        store[num_++] = points[i];
        slot = {tag, static_cast<std::uint32_t>(num_)};
        ids[i] = slot.id_plus_1 - 1;
        break;
      }
      if (slot.tag == tag && store[slot.id_plus_1 - 1] == points[i]) {
        ids[i] = slot.id_plus_1 - 1;
        break;
      }
    }
  }
}

std::size_t merge_equal_positions(TriangleMesh& mesh) {
  std::vector<Vec3d>& positions = mesh.positions;
  VertexTable table;
  table.reserve(positions.size());
  std::vector<std::uint32_t> ids(positions.size());
  for (std::size_t i = 0; i < positions.size(); i += VertexTable::kBatch) {
    const std::size_t num = std::min(VertexTable::kBatch, positions.size() - i);
    table.insert(std::span(positions).subspan(i, num), positions.data(), ids.data() + i);
  }
  const std::size_t num = table.num_positions();
  if (num == positions.size()) return num;  // then ids[i] = i
  positions.resize(num);
  for (auto& face : mesh.faces) {
    for (std::uint32_t& v : face) v = ids[v];
  }
  return num;
}

std::size_t count_distinct_positions(const TriangleMesh& mesh) {
  VertexTable table;
  table.reserve(mesh.positions.size());
  std::vector<Vec3d> store(mesh.positions.size());
  std::uint32_t ids[VertexTable::kBatch];
  for (std::size_t i = 0; i < mesh.positions.size(); i += VertexTable::kBatch) {
    const std::size_t num = std::min(VertexTable::kBatch, mesh.positions.size() - i);
    table.insert(std::span(mesh.positions).subspan(i, num), store.data(), ids);
  }
  return table.num_positions();
}

}  // namespace veritope
