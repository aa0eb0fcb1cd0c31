// PNG files, read by an inflate and unfilter of this test's own.
#include "draw/png.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace nearfield::host::draw {
namespace {

class BitReader {
 public:
  explicit BitReader(const std::string& bytes) : bytes_(bytes) {}
  unsigned bit() {
    if (at_ / 8 >= bytes_.size()) throw std::runtime_error("the stream ends early");
    const unsigned byte = static_cast<unsigned char>(bytes_[at_ / 8]);
    const unsigned result = byte >> at_ % 8 & 1U;
    ++at_;
    return result;
  }
  unsigned bits(unsigned count) {
    unsigned value = 0;
    for (unsigned i = 0; i < count; ++i) value |= bit() << i;
    return value;
  }
  std::size_t bytes_used() const { return (at_ + 7) / 8; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// The literal or length symbol of a fixed code, by the table of RFC 1951, 3.2.6.
unsigned fixed_symbol(BitReader& reader) {
  unsigned code = 0;
  for (unsigned length = 1; length <= 9; ++length) {
    code = code << 1U | reader.bit();
    if (length == 7 && code <= 23) return 256 + code;
    if (length == 8 && code >= 48 && code <= 191) return code - 48;
    if (length == 8 && code >= 192 && code <= 199) return 280 + code - 192;
    if (length == 9 && code >= 400) return 144 + code - 400;
  }
  throw std::runtime_error("no such code");
}

std::string inflated(const std::string& zlib) {
  constexpr unsigned length_base[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                      31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
  constexpr unsigned length_bits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                      2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
  constexpr unsigned distance_base[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                        33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                        1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
  if (zlib.size() < 6 || zlib[0] != '\x78' || (0x7800 + static_cast<unsigned char>(zlib[1])) % 31 != 0) {
    throw std::runtime_error("no zlib header");
  }
  const std::string body = zlib.substr(2, zlib.size() - 6);
  BitReader reader(body);
  if (reader.bits(1) != 1 || reader.bits(2) != 1) throw std::runtime_error("not one block with fixed codes");
  std::string text;
  for (unsigned symbol = fixed_symbol(reader); symbol != 256; symbol = fixed_symbol(reader)) {
    if (symbol < 256) {
      text += static_cast<char>(symbol);
      continue;
    }
    if (symbol > 285) throw std::runtime_error("no such length");
    const unsigned length = length_base[symbol - 257] + reader.bits(length_bits[symbol - 257]);
    unsigned code = 0;
    for (int i = 0; i < 5; ++i) code = code << 1U | reader.bit();
    if (code > 29) throw std::runtime_error("no such distance");
    const unsigned distance = distance_base[code] + reader.bits(code < 4 ? 0 : code / 2 - 1);
    if (distance > text.size()) throw std::runtime_error("a distance before the start");
    for (unsigned i = 0; i < length; ++i) text += text[text.size() - distance];
  }
  if (reader.bytes_used() != body.size()) throw std::runtime_error("bytes after the end");
  return text;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

RgbImage decoded(const std::string& file) {
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1A\n");
  std::map<std::string, std::string> chunks;
  std::string order;
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t size = big_endian(file, at);
    const std::string type = file.substr(at + 4, 4);
    EXPECT_EQ(big_endian(file, at + 8 + size), crc32(file.substr(at + 4, 4 + size))) << type;
    chunks[type] = file.substr(at + 8, size);
    order += type + " ";
    at += 12 + size;
  }
  EXPECT_EQ(order, "IHDR sRGB IDAT IEND ");
  RgbImage image;
  image.width = big_endian(chunks["IHDR"], 0);
  image.height = big_endian(chunks["IHDR"], 4);
  EXPECT_EQ(chunks["IHDR"].substr(8), (std::string{8, 2, 0, 0, 0}));
  const std::string zlib = chunks["IDAT"], text = inflated(zlib);
  EXPECT_EQ(big_endian(zlib, zlib.size() - 4), adler32(text));
  const std::size_t stride = 3 * image.width;
  EXPECT_EQ(text.size(), (stride + 1) * image.height);
  image.bytes.assign(stride * image.height, 0);
  for (std::size_t y = 0; y < image.height; ++y) {
    const int filter = text[y * (stride + 1)];
    for (std::size_t i = 0; i < stride; ++i) {
      const auto at = [&](std::size_t back, std::size_t up) {
        return i < back || y < up ? 0 : int{image.bytes[(y - up) * stride + i - back]};
      };
      const int a = at(3, 0), b = at(0, 1), c = at(3, 1), p = a + b - c;
      const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
      const int predicted[] = {0, a, b, (a + b) / 2, pa <= pb && pa <= pc ? a : pb <= pc ? b : c};
      image.bytes[y * stride + i] = static_cast<std::uint8_t>(
          static_cast<unsigned char>(text[y * (stride + 1) + 1 + i]) + predicted[filter]);
    }
  }
  return image;
}

void expect_same(const RgbImage& image) {
  const RgbImage read = decoded(png_of(image));
  EXPECT_EQ(read.width, image.width);
  EXPECT_EQ(read.height, image.height);
  EXPECT_EQ(read.bytes, image.bytes);
}

TEST(Png, ChecksumsOfKnownBytes) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32("IEND"), 0xAE426082U);
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(adler32("Wikipedia"), 0x11E60398U);
  EXPECT_EQ(adler32(""), 1U);
}

TEST(Png, StreamsOfEveryLengthAndDistance) {
  std::mt19937 random(5);
  SCOPED_TRACE("seed 5");
  for (const std::size_t size : {0U, 1U, 2U, 3U, 257U, 258U, 259U, 262U, 1000U}) {
    EXPECT_EQ(inflated(zlib_of(std::string(size, 'x'))), std::string(size, 'x')) << size;
  }
  std::string bytes;
  while (bytes.size() < 80000) {
    if (bytes.size() < 50 || random() % 3 == 0) {
      for (auto i = random() % 40; i != 0; --i) bytes += static_cast<char>(random() & 0xFFU);
    } else {
      const std::size_t from = random() % bytes.size(), count = random() % 400;
      for (std::size_t i = 0; i < count; ++i) bytes += bytes[from + i];
    }
  }
  const std::string stream = zlib_of(bytes);
  EXPECT_EQ(inflated(stream), bytes);
  EXPECT_LT(stream.size(), bytes.size() / 2);
}

TEST(Png, ImagesComeBack) {
  std::mt19937 random(6);
  SCOPED_TRACE("seed 6");
  for (const auto& [width, height] :
       {std::pair<std::size_t, std::size_t>{1, 1}, {1, 7}, {7, 1}, {33, 20}, {128, 64}}) {
    RgbImage noise{width, height, {}}, slope{width, height, {}}, plain{width, height, {}};
    for (std::size_t i = 0; i < 3 * width * height; ++i) {
      noise.bytes.push_back(static_cast<std::uint8_t>(random() & 0xFFU));
      slope.bytes.push_back(
          static_cast<std::uint8_t>((i / 3 % width + 2 * (i / 3 / width) + 40 * (i % 3)) & 0xFFU));
      plain.bytes.push_back(200);
    }
    expect_same(noise);
    expect_same(slope);
    expect_same(plain);
  }
}

TEST(Png, RefusesWhatIsNoImage) {
  EXPECT_THROW(png_of({0, 1, {}}), std::invalid_argument);
  EXPECT_THROW(png_of({1, 1, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(png_of({greatest_image_side + 1, 1, std::vector<std::uint8_t>(3 * (greatest_image_side + 1))}),
               std::invalid_argument);
}

}  // namespace
}  // namespace nearfield::host::draw
