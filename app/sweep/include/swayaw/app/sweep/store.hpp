#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "swayaw/app/sweep/work.hpp"

/// Results of a sweep in one SQLite file, DIR/sweep.sqlite (docs/sweep.md has its tables). Blocks are written whole or
/// not at all: whatever kills the program, the file holds the blocks of the last commit.
namespace swayaw::app {

class SweepStore {
 public:
  /// Opens the results of the same plan, or begins them.
  /// @throws Refusal  if the folder cannot be written, holds the results of another plan, or another sweep works in it
  SweepStore(const std::filesystem::path& folder, const SweepWork& work);
  ~SweepStore();
  SweepStore(const SweepStore&) = delete;
  SweepStore& operator=(const SweepStore&) = delete;

  const std::filesystem::path& file() const { return file_; }

  /// Blocks that are there.
  const std::vector<bool>& done() const { return done_; }

  /// All of these blocks or none.
  /// @throws Refusal  if they cannot be written; what was there stays
  void write(std::span<const SweepBlock> blocks);

  /// A column of every item of a ship that is there, in the order of the items; not a number where there is none.
  std::vector<double> column(std::size_t subject, std::size_t column) const;

  /// How often each word stands at that path of the documents, "$.verdict", most often first; "-" where there is none.
  std::vector<std::pair<std::string, std::size_t>> counts(const std::string& path) const;

  /// Notes by item, the first so many.
  std::vector<std::pair<std::size_t, std::string>> notes(std::size_t most) const;
  std::size_t note_count() const;

 private:
  struct Database;

  std::filesystem::path file_;
  const SweepWork& work_;
  int lock_ = -1;
  std::unique_ptr<Database> database_;
  std::vector<bool> done_;
};

}  // namespace swayaw::app
