#pragma once

#include <filesystem>

namespace swayaw::bench {

/// Lines that take minutes: a diagnosis of each case in a folder, ship.toml with the recordings of train/, reference/
/// and holdout/, in the order of their names; and of a voyage of three hours.
void register_diagnoses(const std::filesystem::path& folder);

}  // namespace swayaw::bench
