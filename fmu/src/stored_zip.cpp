#include "stored_zip.hpp"

#include <boost/crc.hpp>
#include <cstdint>

namespace swayaw::fmu {
namespace {

void put(std::string& bytes, std::uint16_t x) {
  bytes += static_cast<char>(x & 0xff), bytes += static_cast<char>(x >> 8);
}

void put(std::string& bytes, std::uint32_t x) {
  put(bytes, static_cast<std::uint16_t>(x & 0xffff)), put(bytes, static_cast<std::uint16_t>(x >> 16));
}

std::uint32_t size_of(std::string_view text) { return static_cast<std::uint32_t>(text.size()); }
std::uint16_t count_of(std::size_t n) { return static_cast<std::uint16_t>(n); }

std::uint32_t crc_of(std::string_view content) {
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return crc.checksum();
}

/// What local header and directory have in common. The date is the first that zip knows, 1 January 1980.
void put_common(std::string& bytes, const ZipEntry& entry, std::uint32_t crc) {
  constexpr std::uint16_t version = 20, names_in_utf8 = 0x0800, stored = 0, time = 0, date = (1 << 5) | 1;
  for (const std::uint16_t x : {version, names_in_utf8, stored, time, date}) put(bytes, x);
  put(bytes, crc), put(bytes, size_of(entry.content)), put(bytes, size_of(entry.content));
  put(bytes, count_of(entry.name.size())), put(bytes, std::uint16_t{0});
}

}  // namespace

std::string stored_zip(const std::vector<ZipEntry>& entries) {
  std::string bytes, directory;
  for (const auto& entry : entries) {
    const auto crc = crc_of(entry.content), offset = size_of(bytes);
    put(bytes, std::uint32_t{0x04034b50}), put_common(bytes, entry, crc);
    bytes.append(entry.name).append(entry.content);
    // of a regular file under Unix that everyone may read and its owner write
    constexpr std::uint16_t made_by_unix = (3 << 8) | 20;
    constexpr std::uint32_t mode = 0100644u << 16;
    put(directory, std::uint32_t{0x02014b50}), put(directory, made_by_unix), put_common(directory, entry, crc);
    for (int i = 0; i < 3; ++i) put(directory, std::uint16_t{0});  // comment, disk, attributes within
    put(directory, mode), put(directory, offset), directory += entry.name;
  }
  const auto offset = size_of(bytes), size = size_of(directory);
  bytes += directory;
  put(bytes, std::uint32_t{0x06054b50}), put(bytes, std::uint32_t{0});
  for (int i = 0; i < 2; ++i) put(bytes, count_of(entries.size()));
  put(bytes, size), put(bytes, offset), put(bytes, std::uint16_t{0});
  return bytes;
}

}  // namespace swayaw::fmu
