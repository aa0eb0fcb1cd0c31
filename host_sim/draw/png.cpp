#include "draw/png.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace nearfield::host::draw {
namespace {

constexpr std::size_t least_match = 3, greatest_match = 258, window = 32768;
constexpr std::size_t hash_bits = 15, chain_limit = 48;

void append_big_endian(std::string& text, std::uint32_t value) {
  for (unsigned shift = 32; shift != 0;) text += static_cast<char>((value >> (shift -= 8U)) & 0xFFU);
}

/// RFC 1951: bits fill bytes from the lowest up; codes come with their first bit first.
class BitWriter {
 public:
  void bits(std::uint32_t value, unsigned count) {
    held_ |= std::uint64_t{value} << count_;
    for (count_ += count; count_ >= 8; count_ -= 8) {
      bytes_ += static_cast<char>(held_ & 0xFFU);
      held_ >>= 8U;
    }
  }
  void code(std::uint32_t value, unsigned count) {
    std::uint32_t reversed = 0;
    for (unsigned i = 0; i < count; ++i) reversed |= ((value >> i) & 1U) << (count - 1 - i);
    bits(reversed, count);
  }
  void literal_or_length(std::uint32_t symbol) {
    if (symbol < 144)
      code(0x30 + symbol, 8);
    else if (symbol < 256)
      code(0x190 + symbol - 144, 9);
    else if (symbol < 280)
      code(symbol - 256, 7);
    else
      code(0xC0 + symbol - 280, 8);
  }
  std::string finish() {
    if (count_ != 0) bits(0, 8 - count_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t held_ = 0;
  unsigned count_ = 0;
};

/// A range of lengths or distances: from `base`, told apart by `extra` bits.
struct Range {
  std::uint32_t base;
  unsigned extra;
};

std::array<Range, 29> length_ranges() {
  std::array<Range, 29> ranges{};
  std::uint32_t base = least_match;
  for (std::size_t i = 0; i + 1 < ranges.size(); ++i) {
    const unsigned extra = i < 8 ? 0 : static_cast<unsigned>(i / 4 - 1);
    ranges[i] = {base, extra};
    base += 1U << extra;
  }
  ranges.back() = {greatest_match, 0};
  return ranges;
}
std::array<Range, 30> distance_ranges() {
  std::array<Range, 30> ranges{};
  std::uint32_t base = 1;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const unsigned extra = i < 4 ? 0 : static_cast<unsigned>(i / 2 - 1);
    ranges[i] = {base, extra};
    base += 1U << extra;
  }
  return ranges;
}

template <std::size_t N>
std::size_t index_in(const std::array<Range, N>& ranges, std::size_t value) {
  std::size_t index = N - 1;
  while (ranges[index].base > value) --index;
  return index;
}

struct Match {
  std::size_t length = 0, distance = 0;
};

/// Earlier places with the same three bytes, the latest first.
class Matcher {
 public:
  explicit Matcher(std::string_view bytes)
      : bytes_(bytes), head_(std::size_t{1} << hash_bits, none), previous_(bytes.size(), none) {}

  void add(std::size_t at) {
    if (at + least_match > bytes_.size()) return;
    std::size_t& head = head_[hash(at)];
    previous_[at] = head;
    head = at;
  }
  Match longest(std::size_t at) const {
    Match best;
    if (at + least_match > bytes_.size()) return best;
    const std::size_t limit = std::min(greatest_match, bytes_.size() - at);
    std::size_t candidate = head_[hash(at)];
    for (std::size_t i = 0; i < chain_limit && candidate != none && at - candidate <= window; ++i) {
      std::size_t length = 0;
      while (length < limit && bytes_[candidate + length] == bytes_[at + length]) ++length;
      if (length > best.length) best = {length, at - candidate};
      if (best.length == limit) break;
      candidate = previous_[candidate];
    }
    return best.length >= least_match ? best : Match{};
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t hash(std::size_t at) const {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < least_match; ++i)
      word = word << 8U | static_cast<std::uint8_t>(bytes_[at + i]);
    return (word * 0x9E3779B1U) >> (32U - hash_bits);
  }

  std::string_view bytes_;
  std::vector<std::size_t> head_, previous_;
};

std::uint8_t paeth(int left, int above, int above_left) {
  const int estimate = left + above - above_left;
  const int from_left = std::abs(estimate - left), from_above = std::abs(estimate - above);
  const int from_above_left = std::abs(estimate - above_left);
  if (from_left <= from_above && from_left <= from_above_left) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(from_above <= from_above_left ? above : above_left);
}

/// Each row after the number of its filter: the one of the five whose bytes, as signed numbers, have the
/// least sum of magnitudes.
std::string filtered_rows(const RgbImage& image) {
  const std::size_t stride = 3 * image.width;
  std::string text;
  text.reserve((stride + 1) * image.height);
  const std::vector<std::uint8_t> blank(stride, 0);
  std::string row(stride, '\0'), best;
  for (std::size_t y = 0; y < image.height; ++y) {
    const std::uint8_t* now = image.bytes.data() + y * stride;
    const std::uint8_t* above = y == 0 ? blank.data() : now - stride;
    long best_sum = -1;
    int best_filter = 0;
    for (int filter = 0; filter < 5; ++filter) {
      long sum = 0;
      for (std::size_t i = 0; i < stride; ++i) {
        const int a = i < 3 ? 0 : now[i - 3], b = above[i], c = i < 3 ? 0 : above[i - 3];
        const int predicted = filter == 0   ? 0
                              : filter == 1 ? a
                              : filter == 2 ? b
                              : filter == 3 ? (a + b) / 2
                                            : paeth(a, b, c);
        const auto byte = static_cast<std::uint8_t>(now[i] - predicted);
        row[i] = static_cast<char>(byte);
        sum += std::min<int>(byte, 256 - byte);
      }
      if (best_sum >= 0 && sum >= best_sum) continue;
      best_sum = sum;
      best_filter = filter;
      best = row;
    }
    text += static_cast<char>(best_filter);
    text += best;
  }
  return text;
}

void append_chunk(std::string& file, const std::string& type, const std::string& data) {
  append_big_endian(file, static_cast<std::uint32_t>(data.size()));
  file += type + data;
  append_big_endian(file, crc32(type + data));
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t low = 1, high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<std::uint8_t>(byte)) % 65521U;
    high = (high + low) % 65521U;
  }
  return high << 16U | low;
}

std::string zlib_of(std::string_view bytes) {
  static const std::array<Range, 29> lengths = length_ranges();
  static const std::array<Range, 30> distances = distance_ranges();
  BitWriter writer;
  writer.bits(1, 1);  // the last block
  writer.bits(1, 2);  // fixed codes
  Matcher matcher(bytes);
  for (std::size_t at = 0; at < bytes.size();) {
    const Match match = matcher.longest(at);
    if (match.length == 0) {
      writer.literal_or_length(static_cast<std::uint8_t>(bytes[at]));
    } else {
      const std::size_t length = index_in(lengths, match.length),
                        distance = index_in(distances, match.distance);
      writer.literal_or_length(static_cast<std::uint32_t>(257 + length));
      writer.bits(static_cast<std::uint32_t>(match.length) - lengths[length].base, lengths[length].extra);
      writer.code(static_cast<std::uint32_t>(distance), 5);
      writer.bits(static_cast<std::uint32_t>(match.distance) - distances[distance].base,
                  distances[distance].extra);
    }
    for (const std::size_t end = at + std::max<std::size_t>(match.length, 1); at < end; ++at) matcher.add(at);
  }
  writer.literal_or_length(256);
  std::string stream = "\x78\x9C" + writer.finish();
  append_big_endian(stream, adler32(bytes));
  return stream;
}

std::string png_of(const RgbImage& image) {
  const auto valid_side = [](std::size_t side) { return side >= 1 && side <= greatest_image_side; };
  if (!valid_side(image.width) || !valid_side(image.height) ||
      image.bytes.size() != 3 * image.width * image.height) {
    throw std::invalid_argument("draw: an image needs sides from 1 to 16384 pixels and three bytes a pixel");
  }
  std::string header;
  append_big_endian(header, static_cast<std::uint32_t>(image.width));
  append_big_endian(header, static_cast<std::uint32_t>(image.height));
  header += std::string{8, 2, 0, 0, 0};  // bits, colour type, compression, filters, no interlace
  std::string file = "\x89PNG\r\n\x1A\n";
  append_chunk(file, "IHDR", header);
  append_chunk(file, "sRGB", std::string(1, '\0'));
  append_chunk(file, "IDAT", zlib_of(filtered_rows(image)));
  append_chunk(file, "IEND", "");
  return file;
}

}  // namespace nearfield::host::draw
