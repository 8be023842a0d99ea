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

// Threads that wait for the next round of work. A round is offered to the first `wanted` of them; run() returns when
// they have all finished it.
class WorkerScope::Crew {
 public:
  explicit Crew(unsigned size) {
    threads_.reserve(size);
    try {
      for (unsigned i = 0; i < size; ++i) threads_.emplace_back([this, i] { serve(i); });
    } catch (const std::system_error&) {
      // The system refuses another thread: those that run do the work.
    }
  }
  ~Crew() {
    wanted_ = threads_.size();
    work_ = nullptr;
    next_round();
  }
  bool is_busy() const { return work_ != nullptr; }

  template <typename Work>
  void run(std::size_t helpers, Work& work) {
    argument_ = &work;
    work_ = [](void* argument) { (*static_cast<Work*>(argument))(); };
    wanted_ = std::min(helpers, threads_.size());
    running_.store(threads_.size(), std::memory_order_relaxed);
    next_round();
    work();
    wait_while(running_, [](std::size_t n) { return n != 0; });
    work_ = nullptr;
  }

 private:
  void next_round() {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }

  template <typename T, typename Condition>
  static T wait_while(const std::atomic<T>& value, Condition&& holds) {
    for (int i = 0; i < kSpins; ++i) {
      const T now = value.load(std::memory_order_acquire);
      if (!holds(now)) return now;
      pause();
    }
    for (T now = value.load(std::memory_order_acquire);;
         now = value.load(std::memory_order_acquire)) {
      if (!holds(now)) return now;
      value.wait(now, std::memory_order_acquire);
    }
  }
  static void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }

  void serve(unsigned index) {
    for (std::uint32_t seen = 0;;) {
      seen = wait_while(round_, [seen](std::uint32_t round) { return round == seen; });
      if (work_ == nullptr) return;
      if (index < wanted_) work_(argument_);
      if (running_.fetch_sub(1, std::memory_order_acq_rel) == 1) running_.notify_all();
    }
  }

  static constexpr int kSpins = 2000;  // approximately 50 us

  // Written by the owner between rounds, read by the threads after the round's release.
  void (*work_)(void*) = nullptr;
  void* argument_ = nullptr;
  std::size_t wanted_ = 0;
  std::atomic<std::uint32_t> round_{0};
  std::atomic<std::size_t> running_{0};
  std::vector<std::jthread> threads_;  // last: joined before the rest goes
};

namespace {
thread_local WorkerScope::Crew* current_crew = nullptr;
}

WorkerScope::WorkerScope(unsigned jobs) {
  const unsigned size = std::min(jobs == 0 ? hardware_jobs() : jobs, hardware_jobs()) - 1;
  if (size == 0 || current_crew != nullptr) return;
  crew_ = std::make_unique<Crew>(size);
  current_crew = crew_.get();
}

WorkerScope::~WorkerScope() {
  if (crew_) current_crew = nullptr;
}

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
  WorkerScope::Crew* const crew = current_crew;
  if (crew != nullptr && !crew->is_busy()) {
    crew->run(workers - 1, work);
  } else {
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
