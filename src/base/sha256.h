// SHA-256 (FIPS 180-4): tells whether a file is still the one it was.
#pragma once

#include <string>
#include <string_view>

namespace phs {

/// The digest of `data` in 64 hexadecimal digits.
std::string Sha256(std::string_view data);

}  // namespace phs
