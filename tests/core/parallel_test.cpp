#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/cancel.h"
#include "core/error.h"
#include "core/random.h"

namespace shatterpave {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
    std::vector<int> calls(count, 0);
    parallel_for(count, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(count, 1));
  }
}

TEST(ParallelFor, ChunksCoverTheRangeOnce) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 1000U}) {
    std::vector<int> calls(count, 0);
    parallel_for_chunks(count, 8, [&](std::size_t begin, std::size_t end) {
      ASSERT_EQ(begin % 8, 0U);
      ASSERT_TRUE(end == begin + 8 || end == count);
      for (std::size_t i = begin; i < end; ++i) ++calls[i];
    });
    EXPECT_EQ(calls, std::vector<int>(count, 1));
  }
  EXPECT_THROW(parallel_for_chunks(3, 0, [](std::size_t, std::size_t) {}), BrokenInvariant);
}

TEST(ParallelFor, ThrowsWhatItsBodyThrows) {
  EXPECT_THROW(parallel_for(100,
                            [](std::size_t i) {
                              if (i == 57) throw std::out_of_range("57");
                            }),
               std::out_of_range);
}

TEST(ParallelFor, StopsWhereItIsAskedTo) {
  std::atomic<int> calls = 0;
  const auto work = [&] { parallel_for(1000, [&](std::size_t) { parallel_for(1000, [&](std::size_t) { ++calls; }); }); };
  {
    const CancelScope scope([&] { return calls > 500; });
    EXPECT_THROW(work(), Interrupted);
    EXPECT_THROW(stop_if_cancelled(), Interrupted);
    const CancelScope inner{{}};
    EXPECT_NO_THROW(stop_if_cancelled());
  }
  EXPECT_LT(calls, 2000);
  EXPECT_NO_THROW(stop_if_cancelled());
  calls = 0;
  work();
  EXPECT_EQ(calls, 1000000);
}

// Each thread is asked by its own scope, whichever began and ended first.
TEST(ParallelFor, ScopesOfSeveralThreadsKnowNothingOfOneAnother) {
  std::atomic<int> stopped = 0;
  std::atomic<int> done = 0;
  {
    std::vector<std::jthread> callers;
    callers.reserve(8);
    for (int caller = 0; caller < 8; ++caller) {
      callers.emplace_back([&, caller] {
        for (int repeat = 0; repeat < 50; ++repeat) {
          const CancelScope scope([caller] { return caller % 2 == 0; });
          try {
            with_threads(caller % 3, [] { parallel_for(100, [](std::size_t) { parallel_for(10, [](std::size_t) {}); }); });
            ++done;
          } catch (const Interrupted&) {
            ++stopped;
          }
        }
      });
    }
  }
  EXPECT_EQ(stopped, 200);
  EXPECT_EQ(done, 200);
}

TEST(ThreadLimit, OfOneCallIsItsOwn) {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> now = 0;
    std::atomic<int> most = 0;
    with_threads(threads, [&] {
      parallel_for(200, [&](std::size_t) {
        const int here = ++now;
        int seen = most;
        while (seen < here && !most.compare_exchange_weak(seen, here)) {
        }
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        --now;
      });
    });
    EXPECT_LE(most, threads);
  }
  EXPECT_THROW(with_threads(2, [] { throw std::out_of_range("57"); }), std::out_of_range);
}

TEST(ParallelFor, ResultDoesNotShowTheNumberOfThreads) {
  const auto result = [](int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> values(5000);
    parallel_for(values.size(), [&](std::size_t i) {
      values[i] = normal(3, {Stream::turn, Id("slot"), static_cast<std::uint32_t>(i)});
    });
    return values;
  };
  const std::vector<double> one = result(1);
  EXPECT_EQ(one, result(2));
  EXPECT_EQ(one, result(7));
  EXPECT_EQ(one, result(0));
}

TEST(ThreadLimit, OfOneUsesOneThread) {
  const ThreadLimit limit(1);
  std::vector<std::thread::id> threads(500);
  parallel_for(threads.size(), [&](std::size_t i) { threads[i] = std::this_thread::get_id(); });
  EXPECT_EQ(std::set<std::thread::id>(threads.begin(), threads.end()).size(), 1U);
}

// Of the right limit it is only asked that one above 1 lets more than one thread in.
TEST(ThreadLimit, OfTwoUsesTwoThreads) {
  if (std::thread::hardware_concurrency() < 2) return;
  const ThreadLimit limit(2);
  std::atomic<int> inside = 0;
  std::atomic<bool> together = false;
  // Bodies wait for each other, at most some seconds in all, so that one thread cannot do all the work alone.
  parallel_for(64, [&](std::size_t) {
    ++inside;
    for (int i = 0; i < 50 && !together; ++i) {
      if (inside > 1) together = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    --inside;
  });
  EXPECT_TRUE(together);
}

TEST(ParallelHeartbeat, BeatsUntilItsEndFromAThreadOfItsOwn) {
  std::atomic<int> beats = 0;
  {
    const Heartbeat heartbeat(std::chrono::milliseconds(1), [&] { ++beats; });
    for (int i = 0; i < 5000 && beats < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const int at_the_end = beats;
  EXPECT_GE(at_the_end, 3);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(beats, at_the_end);
}

// It ends at once, not at its next beat.
TEST(ParallelHeartbeat, EndsBetweenBeats) {
  const auto begin = std::chrono::steady_clock::now();
  {
    const Heartbeat heartbeat(std::chrono::hours(1), [] {});
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(1));
}

}  // namespace
}  // namespace shatterpave
