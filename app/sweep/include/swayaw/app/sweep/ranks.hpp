#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swayaw/app/sweep/run.hpp"

/// A sweep on the ranks of mpirun or srun, on one machine or many.
namespace swayaw::app {

/// Messages between ranks; a plugin that links MPI has them, so that the program itself starts without it.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual void send(int to, const std::vector<char>& message) = 0;

  struct Message {
    int from;
    std::vector<char> bytes;
  };
  /// A message that has come, if there is one.
  virtual std::optional<Message> received() = 0;
};

/// The ranks that this program was started with; nothing if it was started alone.
/// @throws Refusal  if there are several and the plugin for MPI is not there
std::unique_ptr<Ranks> ranks_of_this_program();

/// `run_sweep` of rank 0: it hands out blocks, writes what comes back, and works on blocks itself on one thread.
SweepCount run_sweep_with_ranks(const SweepWork& work, SweepStore& store, Ranks& ranks,
                                const std::function<bool(const SweepCount&)>& go_on);

/// What every other rank does: it works on blocks until there are none.
void serve_sweep(const SweepWork& work, Ranks& ranks);

/// Of a rank that cannot begin: the first one hears why.
void give_up(Ranks& ranks, const std::string& why);

/// Tells the other ranks that there is nothing to do, where rank 0 has to give up before it begins.
void dismiss(Ranks& ranks);

}  // namespace swayaw::app

/// What the plugin has: it begins MPI; the end of the object ends it.
extern "C" swayaw::app::Ranks* swayaw_begin_ranks();
