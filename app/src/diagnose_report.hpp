#pragma once

#include <filesystem>

#include "commands.hpp"
#include "json.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::app {

/// @throws FileError  if there is no folder for the page: better before the work than after it
void require_folder(const std::filesystem::path& page);

/// Writes the page of a diagnosis whose pictures were asked for.
/// @param document     the diagnosis as JSON
/// @param needed_gain  in log evidence, of an effect that is called found
void write_diagnosis_report(const Json& document, const Ship& ship, const Diagnosis& diagnosis, double needed_gain,
                            const DiagnoseArguments& asked);

}  // namespace swayaw::app
