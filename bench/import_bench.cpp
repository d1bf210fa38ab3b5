#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

#include "reference_loops.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/import.hpp"

namespace swayaw::bench {
namespace {

/// A log of 24 hours at 1 Hz with 40 columns, as a spreadsheet writes it, removed at the end.
class DayLog {
 public:
  DayLog() : file_(std::filesystem::temp_directory_path() / ("swayaw-bench-" + std::to_string(::getpid()) + ".csv")) {
    std::string text = "Datum;Uhrzeit;Kurs [°];Wendegeschw. [°/min];Ruderlage [°];Fahrt ü. Grund [kn]";
    for (int k = 0; k < 34; ++k) text += ";Sensor " + std::to_string(k) + " [bar]";
    for (int i = 0; i < 86400; ++i) {
      char row[128];
      std::snprintf(row, sizeof row, "\n12.03.2024;%02d:%02d:%02d;%d,%d;%d,%d;%d,%d;12,%d", i / 3600, i / 60 % 60,
                    i % 60, i / 60 % 360, i % 10, i % 30, i % 7, i / 100 % 35, i % 5, i % 9);
      text += row;
      for (int k = 0; k < 34; ++k) {
        std::snprintf(row, sizeof row, ";%d,%03d", (i + k) % 10, i % 1000);
        text += row;
      }
    }
    write_text(file_, text + "\n");
  }
  ~DayLog() { std::filesystem::remove(file_); }
  DayLog(const DayLog&) = delete;
  DayLog& operator=(const DayLog&) = delete;

  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

double seconds_to_read(const std::filesystem::path& file) {
  const auto begin = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(read_text(file));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// From the file to the text of the recording; x_read tells it in units of reading the bytes.
void import_day_40_columns(benchmark::State& state) {
  const DayLog log;
  double reading = seconds_to_read(log.file()), spent = 0.0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(import_table({log.file()}, {}));
    spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    reading = std::min(reading, seconds_to_read(log.file()));
  }
  state.counters["x_read"] = spent / static_cast<double>(state.iterations()) / reading;
  tell_ratio(state);
}
BENCHMARK(import_day_40_columns)->Unit(benchmark::kMillisecond)->Iterations(3);

}  // namespace
}  // namespace swayaw::bench
