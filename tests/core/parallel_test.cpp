#include "swayaw/core/parallel.hpp"

#include <atomic>
#include <catch.hpp>
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

TEST_CASE("parts of a part stay on its thread", "[core][limit]") {
  std::atomic<int> strayed = 0, done = 0;
  in_parallel(6, 3, [&](std::size_t) {
    const auto here = std::this_thread::get_id();
    in_parallel(5, 3, [&](std::size_t) { strayed += std::this_thread::get_id() != here, ++done; });
  });
  CHECK(strayed == 0);
  CHECK(done == 30);
  CHECK(threads_of_two_parts() == 2);  // the calling thread shares its work again once a part is done
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
