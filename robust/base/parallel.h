// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/parallel.h: a loop over fixed chunks whose result does not depend on the number of
// threads.
#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace veritope {

/// Threads that this machine can run at once; at least 1.
unsigned hardware_jobs();

/// While it lives, the parallel_for calls of the thread that made it share its threads, instead of starting and
/// joining their own (30 to 100 us each time). The constructor starts min(jobs, hardware_jobs()) - 1 threads (jobs = 0:
/// hardware_jobs() - 1), the destructor joins them; a scope inside another does nothing. Results do not depend on it.
/// Between two calls the threads spin for approximately 50 us, then sleep.
class WorkerScope {
 public:
  explicit WorkerScope(unsigned jobs);
  ~WorkerScope();
  WorkerScope(const WorkerScope&) = delete;
  WorkerScope& operator=(const WorkerScope&) = delete;

  class Crew;

 private:
  std::unique_ptr<Crew> crew_;
};

namespace internal {
using ChunkCall = void (*)(void* body, std::size_t chunk, std::size_t begin, std::size_t end);
void run_chunks(std::size_t size, std::size_t chunk_size, unsigned jobs, ChunkCall call,
                void* body);
}  // namespace internal

/// Number of chunks that parallel_for makes. REQUIRES chunk_size > 0.
constexpr std::size_t num_chunks(std::size_t size, std::size_t chunk_size) {
  return size / chunk_size + (size % chunk_size != 0 ? 1 : 0);
}

/// Calls body(chunk, begin, end) once for each chunk of [0, size), where chunk k is
/// [k * chunk_size, min(size, (k + 1) * chunk_size)). At most `jobs` calls run at once (0 =
/// hardware_jobs()), the caller's thread among them; with one job or one chunk all run there, in
/// order, and nothing is started. Laws:
///   (1) the chunks depend on size and chunk_size alone, so a body that writes only to slots
///       indexed by `chunk` (or by the indices in it) gives the same result for every `jobs`;
///   (2) if bodies throw, the exception of the lowest chunk that threw is rethrown after all
///       started calls have ended, and which chunk that is does not depend on `jobs`; later chunks
///       may not have been started.
/// REQUIRES chunk_size > 0.
template <typename Body>
void parallel_for(std::size_t size, std::size_t chunk_size, unsigned jobs, Body&& body) {
  using Plain = std::remove_reference_t<Body>;
  if (jobs == 1 || size <= chunk_size) {
    for (std::size_t chunk = 0, begin = 0; begin < size; ++chunk) {
      const std::size_t end = size - begin > chunk_size ? begin + chunk_size : size;
      body(chunk, begin, end);
      begin = end;
    }
    return;
  }
  internal::run_chunks(
      size, chunk_size, jobs,
      [](void* b, std::size_t chunk, std::size_t begin, std::size_t end) {
        (*static_cast<Plain*>(b))(chunk, begin, end);
      },
      const_cast<void*>(static_cast<const void*>(&body)));
}

}  // namespace veritope
