#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swayaw/app/sweep/plan.hpp"

/// The items of a sweep and what comes of them. An item is a point of a ship; blocks of items are worked on, written
/// and resumed as a whole.
namespace swayaw::app {

struct SweepColumn {
  std::string name;
  std::string unit;
  bool varied;  ///< a parameter that varies; else a result
};

/// Columns of a block of items; what an item does not have is not a number.
struct SweepBlock {
  std::size_t place = 0;  ///< among the blocks
  std::size_t first = 0;  ///< item
  std::size_t count = 0;
  std::vector<double> values{};                                  ///< [column · count + item]
  std::vector<std::pair<std::size_t, std::string>> notes{};      ///< why an item has no result
  std::vector<std::pair<std::size_t, std::string>> documents{};  ///< JSON of an item, of recordings

  double& at(std::size_t column, std::size_t item) { return values[column * count + item]; }
};

/// Work that a plan lays out. Blocks may be worked on from many threads at once, in any order, on any machine: what
/// comes of them is the same.
class SweepWork {
 public:
  /// @throws FileError  if a ship cannot be read, or a parameter of the plan is none of hers
  explicit SweepWork(const SweepPlan& plan);
  ~SweepWork();
  SweepWork(const SweepWork&) = delete;
  SweepWork& operator=(const SweepWork&) = delete;

  const SweepPlan& plan() const { return plan_; }
  const std::vector<std::string>& subjects() const { return subjects_; }  ///< names of the ships; "cases" of recordings
  const std::vector<SweepColumn>& columns() const { return columns_; }    ///< those that vary come first
  std::size_t points() const { return points_; }                          ///< of each ship
  std::size_t varied() const { return varied_; }                          ///< how many columns vary
  std::size_t items() const { return points_ * subjects_.size(); }
  std::size_t blocks() const { return blocks_of_subject_ * subjects_.size(); }
  std::size_t block_size(std::size_t block) const;

  /// The name of an item of recordings; empty of others.
  std::string name_of(std::size_t item) const;

  /// Changes with the plan, the ships, the recordings and the version of the program.
  const std::string& fingerprint() const { return fingerprint_; }

  SweepBlock block(std::size_t place) const;

  /// The parameters of an item, in the units of the columns that vary.
  std::vector<double> parameters_of(std::size_t item) const;

 private:
  struct Subject;

  SweepPlan plan_;
  std::vector<std::unique_ptr<Subject>> ships_;
  std::vector<std::string> subjects_;
  std::vector<SweepColumn> columns_;
  std::size_t points_ = 0, varied_ = 0, most_ = 1, blocks_of_subject_ = 0;
  std::string fingerprint_;
};

}  // namespace swayaw::app
