#include <mpi.h>

#include "swayaw/app/sweep/ranks.hpp"

/// The plugin that links MPI.
namespace {

class MpiRanks final : public swayaw::app::Ranks {
 public:
  MpiRanks() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiRanks() override { MPI_Finalize(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, const std::vector<char>& message) override {
    MPI_Send(message.data(), static_cast<int>(message.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
  }

  std::optional<Message> received() override {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &there, &status);
    if (!there) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    Message message{status.MPI_SOURCE, std::vector<char>(static_cast<std::size_t>(size))};
    MPI_Recv(message.bytes.data(), size, MPI_CHAR, status.MPI_SOURCE, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  static constexpr int tag = 1;

  int rank_ = 0, size_ = 1;
};

}  // namespace

extern "C" swayaw::app::Ranks* swayaw_begin_ranks() { return new MpiRanks; }
