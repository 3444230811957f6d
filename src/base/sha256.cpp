#include "base/sha256.hpp"

#include <sha2.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace moat {

std::string sha256_of(std::string_view bytes) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits;
  if (SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits.data()) == nullptr)
    throw std::runtime_error{"libmd could not compute a SHA-256."};
  return digits.data();
}

std::string sha256_in_base64(std::string_view bytes) {
  constexpr std::string_view signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  // 256 bits and two zeros are 43 groups of six.
  const std::string digits = sha256_of(bytes) + "00";
  std::string text;
  for (std::size_t i = 0; text.size() < 43; i += 3) {
    const std::size_t twelve_bits = std::stoul(digits.substr(i, 3), nullptr, 16);
    text += signs[twelve_bits >> 6];
    if (text.size() < 43) text += signs[twelve_bits & 0x3F];
  }
  return text + "=";
}

std::optional<std::string> sha256_of_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits;
  if (SHA256File(path.c_str(), digits.data()) == nullptr) return std::nullopt;
  return digits.data();
}

}  // namespace moat
