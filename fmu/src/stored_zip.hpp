#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swayaw::fmu {

struct ZipEntry {
  std::string name;  ///< with "/" between folders
  std::string_view content;
};

/// A zip file whose entries are stored as they are, without compression: the same entries make the same bytes.
/// Source: PKWARE, APPNOTE.TXT 6.3, sections 4.3.7, 4.3.12 and 4.3.16. Entries and the whole must be below 4 GiB.
std::string stored_zip(const std::vector<ZipEntry>& entries);

}  // namespace swayaw::fmu
