#pragma once

#include <string>
#include <string_view>

namespace swayaw {

/// Bytes in the letters of RFC 4648.
std::string base64(std::string_view bytes);

}  // namespace swayaw
