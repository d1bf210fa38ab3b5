#include "swayaw/core/parallel.hpp"

#include <atomic>
#include <catch.hpp>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace swayaw {

TEST_CASE("every part of a work is done once", "[core][limit]") {
  for (const std::size_t parts : {0u, 1u, 2u, 17u}) {
    std::vector<std::atomic<int>> done(parts);
    in_parallel(parts, 4, [&](std::size_t i) { ++done[i]; });
    for (const auto& count : done) CHECK(count == 1);
  }
}

namespace {

/// How many threads two parts take that wait for each other, so that one could not do both.
std::size_t threads_of_two_parts() {
  std::mutex guard;
  std::set<std::thread::id> threads;
  std::atomic<int> waiting = 2;
  in_parallel(2, 2, [&](std::size_t) {
    for (--waiting; waiting > 0;) std::this_thread::yield();
    const std::scoped_lock lock(guard);
    threads.insert(std::this_thread::get_id());
  });
  return threads.size();
}

}  // namespace

namespace {

/// The most threads that were at work at one time.
struct Crowd {
  std::atomic<int> now = 0, most = 0;

  void work() {
    const int here = ++now;
    for (int seen = most; seen < here && !most.compare_exchange_weak(seen, here);) {}
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    --now;
  }
};

}  // namespace

TEST_CASE("parts of a part take no more threads than the work has", "[core][limit]") {
  std::atomic<int> strayed = 0, done = 0;
  Crowd crowd;
  in_parallel(6, 3, [&](std::size_t) {
    in_parallel(5, 3, [&](std::size_t) { in_parallel(2, 0, [&](std::size_t) { crowd.work(), ++done; }); });
  });
  CHECK(crowd.most <= 3);
  CHECK(done == 60);
  in_parallel(3, 1, [&](std::size_t) {
    const auto here = std::this_thread::get_id();
    in_parallel(5, 3, [&](std::size_t) { strayed += std::this_thread::get_id() != here; });
  });
  CHECK(strayed == 0);
  CHECK(threads_of_two_parts() == 2);  // the calling thread shares its work again once a part is done
}

TEST_CASE("a part that lasts gets the threads that have none left", "[core][limit]") {
  std::atomic<bool> other_ended = false, helped = false;
  in_parallel(2, 2, [&](std::size_t part) {
    if (part == 1) {
      other_ended = true;
      return;
    }
    while (!other_ended) std::this_thread::yield();
    for (int attempt = 0; attempt < 10'000 && !helped;
         ++attempt) {  // until the other thread has seen that none is left
      const auto here = std::this_thread::get_id();
      in_parallel(2, 0, [&](std::size_t) {
        if (std::this_thread::get_id() != here) helped = true;
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      });
    }
  });
  CHECK(helped);
}

TEST_CASE("a part of which it is said from outside that it is one keeps to its thread", "[core][limit]") {
  on_a_part = true;  // as a process that works on a part of another's work
  const auto here = std::this_thread::get_id();
  std::atomic<int> strayed = 0;
  in_parallel(8, 4, [&](std::size_t) { strayed += std::this_thread::get_id() != here; });
  on_a_part = false;
  CHECK(strayed == 0);
}

TEST_CASE("what fails in a part reaches the caller, and later work is shared as before", "[core][refusal]") {
  CHECK_THROWS_AS(in_parallel(4, 2,
                              [](std::size_t i) {
                                if (i == 2) throw std::runtime_error("part");
                              }),
                  std::runtime_error);
  CHECK_FALSE(on_a_part);
  CHECK_THROWS_AS(
      in_parallel(3, 2, [](std::size_t) { in_parallel(2, 2, [](std::size_t) { throw std::runtime_error("inner"); }); }),
      std::runtime_error);
  CHECK_FALSE(on_a_part);
}

}  // namespace swayaw
