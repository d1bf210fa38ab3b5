#pragma once

#include <span>
#include <string_view>

namespace swayaw::fmu {

/// A file that is part of the program.
struct Content {
  std::string_view name;  ///< within the unit
  std::string_view bytes;
};

/// The shared library of the unit, those that it is linked to, and their licences. Made by EmbedFiles.cmake.
std::span<const Content> contents();

}  // namespace swayaw::fmu
