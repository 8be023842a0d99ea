// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace veritope {
namespace {

TEST(Parallel, VisitsEveryIndexOnceInFixedChunksForEveryNumberOfJobs) {
  for (const unsigned jobs : {0u, 1u, 2u, 7u, 64u}) {
    for (const std::size_t size : {0u, 1u, 9u, 10u, 11u, 1000u}) {
      std::vector<int> visits(size);
      std::vector<std::size_t> begins(num_chunks(size, 10));
      parallel_for(size, 10, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        begins[chunk] = begin;
        EXPECT_EQ(begin, chunk * 10);
        EXPECT_LE(end, size);
        EXPECT_LE(end - begin, 10u);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const int v : visits) EXPECT_EQ(v, 1);
    }
  }
}

TEST(Parallel, RunsInTheCallersThreadWhenThereIsOneJobOrOneChunk) {
  const auto here = std::this_thread::get_id();
  const auto check = [&](std::size_t, std::size_t, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), here);
  };
  parallel_for(100, 10, 1, check);
  parallel_for(100, 100, 8, check);
}

TEST(Parallel, GivesTheSameSumForEveryNumberOfJobs) {
  // A floating-point sum depends on its order; the order within and between chunks is fixed.
  const std::size_t size = 12345;
  std::vector<double> sums;
  for (const unsigned jobs : {1u, 2u, 3u, 16u}) {
    std::vector<double> partial(num_chunks(size, 100));
    parallel_for(size, 100, jobs, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) partial[chunk] += 1.0 / static_cast<double>(i + 1);
    });
    double sum = 0;
    for (const double p : partial) sum += p;
    sums.push_back(sum);
  }
  for (const double s : sums) EXPECT_EQ(s, sums[0]);
}

TEST(Parallel, RethrowsTheExceptionOfTheLowestChunkThatThrew) {
  for (const unsigned jobs : {1u, 2u, 8u}) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::atomic<int> running{0};
      try {
        parallel_for(1000, 1, jobs, [&](std::size_t chunk, std::size_t, std::size_t) {
          ++running;
          if (chunk % 100 == 37) {
            --running;
            throw std::runtime_error(std::to_string(chunk));
          }
          --running;
        });
        FAIL() << "no exception";
      } catch (const std::runtime_error& e) {
        EXPECT_STREQ(e.what(), "37");
        EXPECT_EQ(running.load(), 0);
      }
    }
  }
}

TEST(Parallel, AcceptsAConstantBody) {
  std::atomic<int> count{0};
  const auto body = [&count](std::size_t, std::size_t, std::size_t) { ++count; };
  parallel_for(10, 1, 2, body);
  EXPECT_EQ(count.load(), 10);
}

TEST(WorkerScope, ManyLoopsOfAllSizesVisitEveryIndexOnce) {
  for (const unsigned crew : {0u, 1u, 2u, 5u}) {
    const WorkerScope scope(crew);
    for (int round = 0; round < 2000; ++round) {
      const auto size = static_cast<std::size_t>(round % 50);
      std::vector<int> visits(size);
      parallel_for(size, 1, static_cast<unsigned>(round % 7),
                   [&](std::size_t, std::size_t begin, std::size_t) { ++visits[begin]; });
      for (const int v : visits) ASSERT_EQ(v, 1) << crew << ' ' << round;
    }
  }
}

TEST(WorkerScope, ThreadsThatSleptWorkAgain) {
  const WorkerScope scope(2);
  for (int round = 0; round < 20; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::atomic<int> count{0};
    parallel_for(8, 1, 2, [&](std::size_t, std::size_t, std::size_t) { ++count; });
    EXPECT_EQ(count.load(), 8);
  }
}

TEST(WorkerScope, LoopsMayNestAndScopesToo) {
  const WorkerScope scope(2);
  std::atomic<int> count{0};
  parallel_for(6, 1, 2, [&](std::size_t, std::size_t, std::size_t) {
    const WorkerScope inner(2);
    parallel_for(5, 1, 2, [&](std::size_t, std::size_t, std::size_t) { ++count; });
  });
  EXPECT_EQ(count.load(), 30);
  parallel_for(5, 1, 2, [&](std::size_t, std::size_t, std::size_t) { ++count; });
  EXPECT_EQ(count.load(), 35);
}

TEST(WorkerScope, AnExceptionLeavesTheThreadsUsable) {
  const WorkerScope scope(2);
  for (int round = 0; round < 50; ++round) {
    try {
      parallel_for(100, 1, 2, [](std::size_t chunk, std::size_t, std::size_t) {
        if (chunk % 10 == 3) throw std::runtime_error(std::to_string(chunk));
      });
      FAIL() << "no exception";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "3");
    }
  }
}

TEST(Parallel, KnowsAtLeastOneThread) { EXPECT_GE(hardware_jobs(), 1u); }

}  // namespace
}  // namespace veritope
