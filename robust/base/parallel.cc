// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace veritope {

unsigned hardware_jobs() { return std::max(1u, std::thread::hardware_concurrency()); }

namespace internal {

void run_chunks(std::size_t size, std::size_t chunk_size, unsigned jobs, ChunkCall call,
                void* body) {
  const std::size_t chunks = num_chunks(size, chunk_size);
  const std::size_t workers = std::min<std::size_t>(jobs == 0 ? hardware_jobs() : jobs, chunks);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::size_t first_failed = chunks;  // guarded by mutex, like failure
  std::exception_ptr failure;

  // Chunks are claimed in order, so every chunk below a failing one has been claimed and runs to
  // its end: the lowest failure is the same for every schedule.
  auto work = [&] {
    while (!stop.load(std::memory_order_relaxed)) {
      const std::size_t chunk = next.fetch_add(1, std::memory_order_relaxed);
      if (chunk >= chunks) return;
      const std::size_t begin = chunk * chunk_size;
      try {
        call(body, chunk, begin, std::min(size - begin, chunk_size) + begin);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        stop.store(true, std::memory_order_relaxed);
        if (chunk < first_failed) {
          first_failed = chunk;
          failure = std::current_exception();
        }
      }
    }
  };
  {
    std::vector<std::jthread> threads;  // joined at the end of this block
    threads.reserve(workers > 0 ? workers - 1 : 0);
    try {
      for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
    } catch (const std::system_error&) {
      // The system refuses another thread: those that run, and this one, share the chunks.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace internal
}  // namespace veritope
