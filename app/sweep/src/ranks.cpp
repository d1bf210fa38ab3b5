#include "swayaw/app/sweep/ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "swayaw/core/refusal.hpp"

namespace swayaw::app {
namespace {

using namespace std::chrono_literals;

/// How long rank 0 sleeps where nothing has come; a block takes some milliseconds.
constexpr auto pause = 200us;

// ---------------------------------------------------------------- messages

/// What a message begins with.
enum class Kind : char { ready, block, trouble, work, end };

void put(std::vector<char>& bytes, const void* from, std::size_t size) {
  const auto* first = static_cast<const char*>(from);
  bytes.insert(bytes.end(), first, first + size);
}

template <class Number>
void put(std::vector<char>& bytes, Number number) {
  put(bytes, &number, sizeof number);
}

class Reader {
 public:
  explicit Reader(const std::vector<char>& bytes) : next_(bytes.data()) {}

  template <class Number>
  Number number() {
    Number number;
    take(&number, sizeof number);
    return number;
  }
  void take(void* to, std::size_t size) {
    std::memcpy(to, next_, size);
    next_ += size;
  }
  std::string text() {
    std::string text(number<std::size_t>(), '\0');
    take(text.data(), text.size());
    return text;
  }

 private:
  const char* next_;
};

std::vector<char> message(Kind kind) { return {static_cast<char>(kind)}; }

std::vector<char> message_of(const SweepBlock& block) {
  auto bytes = message(Kind::block);
  put(bytes, block.place), put(bytes, block.first), put(bytes, block.count), put(bytes, block.values.size());
  put(bytes, block.values.data(), block.values.size() * sizeof(double));
  for (const auto* texts : {&block.notes, &block.documents}) {
    put(bytes, texts->size());
    for (const auto& [item, text] : *texts) {
      put(bytes, item), put(bytes, text.size());
      put(bytes, text.data(), text.size());
    }
  }
  return bytes;
}

SweepBlock block_of(Reader& reader) {
  SweepBlock block;
  block.place = reader.number<std::size_t>();
  block.first = reader.number<std::size_t>();
  block.count = reader.number<std::size_t>();
  block.values.resize(reader.number<std::size_t>());
  reader.take(block.values.data(), block.values.size() * sizeof(double));
  for (auto* texts : {&block.notes, &block.documents}) {
    const auto count = reader.number<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
      const auto item = reader.number<std::size_t>();
      texts->emplace_back(item, reader.text());
    }
  }
  return block;
}

// ---------------------------------------------------------------- start

std::size_t count_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : 0;
}

/// As many as Open MPI, MPICH or Slurm say.
std::size_t ranks_started() {
  if (const auto n = count_in("OMPI_COMM_WORLD_SIZE")) return n;
  if (const auto n = count_in("PMI_SIZE")) return n;
  return std::getenv("SLURM_PROCID") ? count_in("SLURM_NTASKS") : 0;
}

/// Beside the program in the tree of a build, or in the folder of libraries where it is installed.
std::filesystem::path plugin() {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const auto built = folder / "sweep" / SWAYAW_MPI_PLUGIN;
  return std::filesystem::exists(built) ? built : folder / SWAYAW_TO_LIBRARIES / "swayaw" / SWAYAW_MPI_PLUGIN;
}

/// Ends so many ranks, each when it comes back.
void dismiss(Ranks& ranks, int others) {
  while (others > 0) {
    if (const auto received = ranks.received()) ranks.send(received->from, message(Kind::end)), --others;
    else std::this_thread::sleep_for(pause);
  }
}

/// No block.
constexpr auto none = static_cast<std::size_t>(-1);

/// Blocks in the order in which they are handed out.
class Pending {
 public:
  Pending(const SweepWork& work, const SweepStore& store) : work_(work), store_(store) {}

  /// @return none  where there is no further one
  std::size_t next() {
    while (place_ < work_.blocks() && store_.done()[place_]) ++place_;
    return place_ < work_.blocks() ? place_++ : none;
  }

 private:
  const SweepWork& work_;
  const SweepStore& store_;
  std::size_t place_ = 0;
};

}  // namespace

std::unique_ptr<Ranks> ranks_of_this_program() {
  if (ranks_started() < 2) return nullptr;
  const auto file = plugin();
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);  // Open MPI looks for its own symbols
  if (!library)
    throw Refusal(
        fmt::format("started with {} ranks, but there is no MPI in this swayaw: {}; where libopenmpi-dev is "
                    "installed it is built with it",
                    ranks_started(), ::dlerror()));
  const auto begin = reinterpret_cast<decltype(&swayaw_begin_ranks)>(::dlsym(library, "swayaw_begin_ranks"));
  return std::unique_ptr<Ranks>(begin());
}

// ---------------------------------------------------------------- rank 0

SweepCount run_sweep_with_ranks(const SweepWork& work, SweepStore& store, Ranks& ranks,
                                const std::function<bool(const SweepCount&)>& go_on) {
  auto count = counted(work, store);
  Pending pending(work, store);
  std::vector<SweepBlock> waiting;
  auto written = std::chrono::steady_clock::now();
  bool stop = false;
  int others = ranks.size() - 1;
  std::string trouble;
  const auto write = [&] {
    if (!waiting.empty()) store.write(waiting);
    for (const auto& b : waiting) count.done += b.count;
    waiting.clear();
    written = std::chrono::steady_clock::now();
    stop = stop || !go_on(count);
  };
  try {
    std::size_t own = pending.next();  // that rank 0 works on
    while (others > 0 || own != none) {
      const auto received = ranks.received();
      if (received) {
        Reader reader(received->bytes);
        const auto kind = reader.number<Kind>();
        if (kind == Kind::block) waiting.push_back(block_of(reader));
        if (kind == Kind::trouble) trouble = reader.text(), stop = true;
        const auto next = stop || kind == Kind::trouble ? none : pending.next();
        auto answer = message(next != none ? Kind::work : Kind::end);
        if (next != none) put(answer, next);
        else --others;
        ranks.send(received->from, answer);
      } else if (own != none) {
        waiting.push_back(work.block(own));
        own = pending.next();
      } else {
        std::this_thread::sleep_for(pause);
      }
      if (stop) own = none;
      if (std::chrono::steady_clock::now() - written > commit_after) write();
    }
    write();
  } catch (...) {
    dismiss(ranks, others);  // the disk is full, say
    throw;
  }
  if (!trouble.empty()) throw Refusal(trouble);
  return count;
}

void dismiss(Ranks& ranks) { dismiss(ranks, ranks.size() - 1); }

// ---------------------------------------------------------------- the others

namespace {

std::vector<char> trouble_of(const std::string& why) {
  auto bytes = message(Kind::trouble);
  put(bytes, why.size());
  put(bytes, why.data(), why.size());
  return bytes;
}

/// What rank 0 says to a message.
std::vector<char> answer_to(Ranks& ranks, const std::vector<char>& told) {
  ranks.send(0, told);
  while (true) {
    if (auto answer = ranks.received()) return std::move(answer->bytes);
    std::this_thread::sleep_for(pause / 4);
  }
}

}  // namespace

void serve_sweep(const SweepWork& work, Ranks& ranks) {
  auto told = message(Kind::ready);
  while (true) {
    const auto answer = answer_to(ranks, told);
    Reader reader(answer);
    if (reader.number<Kind>() == Kind::end) return;
    try {
      told = message_of(work.block(reader.number<std::size_t>()));
    } catch (const std::exception& e) {
      told = trouble_of(e.what());
    }
  }
}

void give_up(Ranks& ranks, const std::string& why) { answer_to(ranks, trouble_of(why)); }

}  // namespace swayaw::app
