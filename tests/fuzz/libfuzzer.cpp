#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "targets.hpp"

/// One of the targets under clang's libFuzzer: SWAYAW_FUZZ=recording swayaw_fuzz_files … (run.sh does it).
namespace {

using namespace swayaw::fuzz;

const Target& chosen() {
  const char* name = std::getenv("SWAYAW_FUZZ");
  for (const auto& target : SWAYAW_FUZZ_TARGETS())
    if (name != nullptr && std::string_view(target.name) == name) return target;
  for (const auto& target : SWAYAW_FUZZ_TARGETS()) std::printf("%s\t%s\n", target.name, target.covers);
  std::fflush(stdout);
  ::_exit(name == nullptr ? 0 : 1);  // libFuzzer takes an orderly exit for a finding
}

/// In the memory of the machine, so that files cost no more than their bytes.
std::filesystem::path scratch_folder() {
  const auto folder = std::filesystem::path("/dev/shm") / ("swayaw-fuzz-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::atexit([] { std::filesystem::remove_all("/dev/shm/swayaw-fuzz-" + std::to_string(::getpid())); });
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Target& target = chosen();
  static const auto scratch = scratch_folder();
  try {
    end_of(target, {reinterpret_cast<const char*>(data), size}, scratch);
  } catch (const BrokenPromise& broken) {
    std::fprintf(stderr, "broken promise: %s\n", broken.what());
    std::abort();
  }
  return 0;
}
