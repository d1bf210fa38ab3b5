#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nmea_quantities.hpp"

/// Logs of sentences as series of numbers. Not installed.
namespace swayaw::inline core::detail {

/// What an instrument told at a time.
struct NmeaSample {
  double time;  ///< [s]
  double first, second;
};

/// All that one kind of sentence of one instrument told of a quantity.
struct NmeaSeries {
  std::string address;  ///< "HEHDT"
  NmeaQuantity quantity;
  Directness directness;
  int which;  ///< number of the shaft
  std::vector<NmeaSample> samples = {};
};

/// What a log holds besides its samples.
struct NmeaCounts {
  struct Dropped {
    std::size_t count = 0, first_line = 0;
    void add(std::size_t line) {
      if (count++ == 0) first_line = line;
    }
  };
  std::size_t sentences = 0;
  std::size_t lines_without = 0;  ///< lines without a sentence that are not empty
  Dropped wrong_checksum, unreadable, cut;
  std::map<std::string, std::size_t> invalid;           ///< status, by address
  std::map<std::string, std::size_t> not_used;          ///< by formatter
  std::map<std::string, std::size_t> without_checksum;  ///< taken nevertheless, by address
};

/// One file, times in seconds since 1970 UTC if `dated`.
struct NmeaLog {
  std::vector<NmeaSeries> series;
  NmeaCounts counts;
  std::vector<std::string> clock_notes;
  bool dated = false;
  double begin = 0.0, end = 0.0;  ///< times of the first and the last sentence [s]
};

/// @param begin  where a log goes on that tells no date
/// @throws FileError  if it holds no sentence, or none tells a time
NmeaLog read_nmea_log(const std::filesystem::path& file, std::optional<double> begin);

}  // namespace swayaw::core::detail
