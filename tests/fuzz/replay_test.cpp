#include <algorithm>
#include <catch.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <sys/time.h>

#include "files.hpp"
#include "memory.hpp"
#include "mutator.hpp"
#include "targets.hpp"

/// Any bytes end in a result, or in one line that names the file: mutated inputs of every reader, the same in every
/// run. What libFuzzer found beyond them is kept in corpus/, as an input of its own (docs/bad_input.md).
namespace swayaw::fuzz {
namespace {

namespace fs = std::filesystem;
using test::Scratch;

/// Over all targets, but for those of a target with a share that is not 1.
constexpr unsigned inputs_per_target = 10'000;

/// Processor time of an input [s]: a thousand times what the slowest takes that is neither sailed nor inflated.
constexpr double longest_time = 5.0;

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> texts;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

/// Inputs of a target, with the ships of the project where it reads ships.
std::vector<std::string> corpus_of(const Target& target) {
  const auto folder = fs::path(SWAYAW_FUZZ_CORPUS) / target.name;
  auto corpus = fs::exists(folder) ? files_in(folder) : std::vector<std::string>{};
  if (std::string_view(target.file) == "ship.toml")
    for (auto& ship : files_in(test::ships)) corpus.push_back(std::move(ship));
  return corpus;
}

/// An input on which a reader hangs ends this program, too (SIGPROF).
void end_after(double seconds) {
  const itimerval time{{0, 0}, {static_cast<time_t>(seconds), 0}};
  ::setitimer(ITIMER_PROF, &time, nullptr);
}

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What became of many inputs.
struct Tally {
  unsigned read = 0, refused = 0;
  double longest = 0.0;         ///< processor time of an input [s]
  std::size_t most_memory = 0;  ///< of an input [B]
};

class Replay {
 public:
  Replay(const Target& target, const fs::path& scratch) : target_(target), scratch_(scratch) {}

  void take(const std::string& bytes, unsigned seed) {
    const auto why = broken_by(bytes);
    if (why.empty()) return;
    const auto kept =
        fs::temp_directory_path() / ("swayaw-fuzz-" + std::string(target_.name) + "-" + std::to_string(seed));
    fs::copy_file(last_input(), kept, fs::copy_options::overwrite_existing);
    if (++broken_ <= most_shown) std::printf("%s: %s\n", kept.c_str(), why.c_str());
  }

  const Tally& tally() const { return tally_; }
  unsigned broken() const { return broken_; }

 private:
  static constexpr unsigned most_shown = 5;  ///< of a target

  /// @return the promise that the input broke, in words; empty if none
  std::string broken_by(const std::string& bytes) {
    keep_for_post_mortem(bytes);
    end_after(2.0 * longest_time);
    const double begun = processor_time();
    const auto before = begin_counting();
    try {
      const auto end = end_of(target_, bytes, scratch_);
      ++(end.refusal.empty() ? tally_.read : tally_.refused);
    } catch (const BrokenPromise& broken) {
      return broken.what();
    }
    const auto memory = most_held() - before;
    const double seconds = processor_time() - begun;
    tally_.longest = std::max(tally_.longest, seconds);
    tally_.most_memory = std::max(tally_.most_memory, memory);
    if (seconds > longest_time) return "took " + std::to_string(seconds) + " s";
    return memory <= target_.memory.most(bytes.size()) ? "" : "took " + std::to_string(memory) + " bytes";
  }

  fs::path last_input() const { return fs::temp_directory_path() / (std::string("swayaw-fuzz-") + target_.name); }

  /// A crash or a hang ends the program: the input that it was at is left behind.
  void keep_for_post_mortem(const std::string& bytes) const { write(last_input(), bytes); }

  const Target& target_;
  fs::path scratch_;
  Tally tally_;
  unsigned broken_ = 0;
};

void replay(std::span<const Target> targets) {
  const Scratch scratch;
  const char* only = std::getenv("SWAYAW_FUZZ");  // the name of a target, to look into it alone
  for (const auto& target : targets) {
    if (only != nullptr && std::string_view(only) != target.name) continue;
    const auto corpus = corpus_of(target);
    REQUIRE(!corpus.empty());
    Replay replay(target, scratch / "");
    const double begun = processor_time();
    for (const auto& input : corpus) replay.take(input, 0);
    const auto count = static_cast<unsigned>(target.share * inputs_per_target);
    for (unsigned seed = 1; seed <= count; ++seed) replay.take(mutated(corpus, target.is_text, seed), seed);
    const auto& tally = replay.tally();
    std::printf("%-12s %6u inputs, %6u read, %6.2f s, longest %.4f s, memory %.2f MB\n", target.name,
                tally.read + tally.refused, tally.read, processor_time() - begun, tally.longest,
                1e-6 * static_cast<double>(tally.most_memory));
    std::fflush(stdout);
    CHECK(replay.broken() == 0);
    CHECK(tally.read > count / 200);
  }
}

TEST_CASE("mutated files end in a result or in one line that names them", "[fuzz][refusal]") { replay(file_targets()); }

TEST_CASE("mutated ships are refused in one line, or sail, or say why not", "[fuzz][refusal]") {
  replay(ship_targets());
}

}  // namespace
}  // namespace swayaw::fuzz
