#include "swayaw/app/sweep/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "case_tasks.hpp"
#include "swayaw/app/sweep/points.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/version.hpp"
#include "tasks.hpp"
#include "varied_ship.hpp"

namespace swayaw::app {
namespace {

/// Fowler, Noll and Vo's hash FNV-1a of 64 bits, which tells a text from the same one with a change.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

bool same_columns(const std::vector<SweepColumn>& a, const std::vector<SweepColumn>& b) {
  return std::ranges::equal(a, b, {}, &SweepColumn::name, &SweepColumn::name);
}

}  // namespace

struct SweepWork::Subject {
  VariedShip ship;
};

SweepWork::SweepWork(const SweepPlan& plan) : plan_(plan) {
  std::uint64_t hash = hash_of(version(), hash_of(plan.text, 0xcbf29ce484222325));
  if (of_recordings(plan.task)) {
    for (const auto& c : plan.cases) {
      if (!c.ship.empty()) hash = hash_of(ship_text(c.ship), hash);
      for (const auto* runs : {&c.runs, &c.reference, &c.holdout})
        for (const auto& run : *runs) hash = hash_of(read_text(run), hash);
    }
    subjects_ = {"cases"};
    columns_ = results_of_case(plan);
    points_ = blocks_of_subject_ = plan.cases.size();
    fingerprint_ = fmt::format("{:016x}", hash);
    return;
  }
  for (const auto& file : plan.ships) {
    auto subject = std::make_unique<Subject>(Subject{VariedShip(plan, file)});
    const auto& ship = subject->ship;
    if (plan.task == SweepTask::turn && std::holds_alternative<LinearShip>(ship.ship()))
      throw FileError(plan.ships_place,
                      fmt::format("{} is a linear ship, whose turn has no end; a zigzag or indices", ship.name()));
    if (!ships_.empty() && !same_columns(ships_.front()->ship.columns(), ship.columns()))
      throw FileError(plan.ships_place, fmt::format("other parameters vary in {} than in {}; sweep them one by one",
                                                    ship.name(), subjects_.front()));
    hash = hash_of(ship.text(), hash);
    most_ = ships_.empty() ? block_size_of(plan, ship) : std::min(most_, block_size_of(plan, ship));
    subjects_.push_back(ship.name());
    ships_.push_back(std::move(subject));
  }
  const auto& first = ships_.front()->ship;
  columns_ = first.columns();
  varied_ = columns_.size();
  const auto results = results_of(plan);
  for (auto& column : columns_)
    if (std::ranges::find(results, column.name, &SweepColumn::name) != results.end()) column.name += "_given";
  columns_.insert(columns_.end(), results.begin(), results.end());
  points_ = point_count(plan.design, plan.size, first.laws());
  blocks_of_subject_ = (points_ + most_ - 1) / most_;
  fingerprint_ = fmt::format("{:016x}", hash);
}

SweepWork::~SweepWork() = default;

std::size_t SweepWork::block_size(std::size_t place) const {
  return std::min(most_, points_ - place % blocks_of_subject_ * most_);
}

SweepBlock SweepWork::block(std::size_t place) const {
  if (of_recordings(plan_.task)) return block_of_case(plan_, place);
  const auto subject = place / blocks_of_subject_, first = place % blocks_of_subject_ * most_;
  const auto& ship = ships_[subject]->ship;
  SweepBlock block{.place = place, .first = subject * points_ + first, .count = block_size(place)};
  block.values.assign(columns_.size() * block.count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < block.count; ++i) {
    const auto values = parameters_of(block.first + i);
    for (std::size_t d = 0; d < varied_; ++d) block.at(d, i) = values[d];
  }
  fill_results(plan_, ship, block);
  return block;
}

std::vector<double> SweepWork::parameters_of(std::size_t item) const {
  std::vector<double> values(varied_);
  if (varied_ == 0) return values;
  values_of_point(plan_.design, plan_.seed, ships_[item / points_]->ship.laws(), item % points_, values);
  return values;
}

std::string SweepWork::name_of(std::size_t item) const {
  return of_recordings(plan_.task) ? plan_.cases[item].name : std::string();
}

}  // namespace swayaw::app
