#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nearfield::host::draw {

/// An image of 8 bits a channel: red, green, blue of the upper left pixel, then rightwards, then downwards.
struct RgbImage {
  std::size_t width = 0;   ///< pixels
  std::size_t height = 0;  ///< pixels
  std::vector<std::uint8_t> bytes;
};

inline constexpr std::size_t greatest_image_side = 16384;  ///< pixels

/// The bytes of a PNG file: colour type 2, 8 bits, sRGB, each row filtered and compressed. The same image
/// gives the same bytes. Throws std::invalid_argument when a side is 0 or above greatest_image_side, or bytes
/// do not fit the sides.
std::string png_of(const RgbImage& image);

/// ISO 3309, as chunks of a PNG end with.
std::uint32_t crc32(std::string_view bytes);
/// RFC 1950, as a zlib stream ends with.
std::uint32_t adler32(std::string_view bytes);
/// A zlib stream of one block with fixed Huffman codes (RFC 1951).
std::string zlib_of(std::string_view bytes);

}  // namespace nearfield::host::draw
