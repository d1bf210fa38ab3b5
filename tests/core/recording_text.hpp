#pragma once

#include <string>

#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"

/// Recordings from text, as tests write them.
namespace swayaw::test {

inline RecordingFile file_of(const std::string& text) { return parse_recording(text, "run.csv"); }

inline Recording recording_of(const std::string& text) { return file_of(text).recording; }

/// What the reader says of a bad text; empty if it finds nothing bad.
inline std::string refusal_of(const std::string& text) {
  try {
    file_of(text);
    return {};
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace swayaw::test
