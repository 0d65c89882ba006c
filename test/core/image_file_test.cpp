#include "messages.h"
#include "temporary_folder.h"
#include "test_png.h"

#include <pcl/core/image_file.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdlib>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** An image with gradients, edges and noise; its size is not a multiple of a JPEG
 * block. */
RgbImage
sampleImage(std::int32_t width = 61, std::int32_t height = 43)
{
  RgbImage image;
  image.width = width;
  image.height = height;
  Random random(5);
  for (std::int32_t row = 0; row < height; ++row)
    for (std::int32_t column = 0; column < width; ++column)
      for (const double value : {2.0 * column, 3.0 * row, column > 30 ? 200.0 : 20.0})
        image.values.push_back(static_cast<std::uint8_t>(
            std::min(255.0, std::abs(value + 4 * random.normal()))));
  return image;
}

std::string
textOfBytes(const std::vector<std::uint8_t>& bytes)
{
  return {bytes.begin(), bytes.end()};
}

std::vector<std::uint16_t>
sampleDepths(std::size_t count)
{
  std::vector<std::uint16_t> depths = {0, 1, 255, 256, 32767, 32768, 65534, 65535};
  for (Random random(7); depths.size() < count;)
    depths.push_back(static_cast<std::uint16_t>(random.bits()));
  return depths;
}

class ImageFile : public testing::Test {
protected:
  RgbImage
  rgbOf(const std::string& bytes) const
  {
    return loadRgbImage(folder_.write("image", bytes));
  }

  GrayImage16
  grayOf(const std::string& bytes) const
  {
    return loadGrayImage16(folder_.write("image", bytes));
  }

  template <typename Load>
  static std::string
  faultOf(const Load& load)
  {
    return messageOf<InputFileException>(load, "no fault");
  }

  std::string
  rgbFault(const std::string& bytes) const
  {
    return faultOf([&] { rgbOf(bytes); });
  }

  std::string
  grayFault(const std::string& bytes) const
  {
    return faultOf([&] { grayOf(bytes); });
  }

  TemporaryFolder folder_;
};

TEST_F(ImageFile, PngComesBackAsItWas)
{
  const RgbImage image = sampleImage();
  const RgbImage read = rgbOf(textOfBytes(encodePng(image)));
  EXPECT_EQ(read.width, 61);
  EXPECT_EQ(read.height, 43);
  EXPECT_EQ(read.values, image.values);
  EXPECT_EQ(encodePng(image), encodePng(read));
}

TEST_F(ImageFile, JpegComesBackAlike)
{
  RgbImage image = sampleImage(64, 48);
  for (std::size_t i = 0; i < image.values.size(); ++i) // smooth, because the
                                                        // resolution of colour is
                                                        // halved
    image.values[i] = static_cast<std::uint8_t>(i / 3 % 64 + i % 3 * 60 + i / 192);
  const auto bytes = encodeJpeg(image, 95);
  EXPECT_EQ(encodeJpeg(image, 95), bytes);
  EXPECT_LT(encodeJpeg(image, 30).size(), bytes.size());
  const RgbImage read = rgbOf(textOfBytes(bytes));
  ASSERT_EQ(read.width, 64);
  ASSERT_EQ(read.height, 48);
  ASSERT_EQ(read.values.size(), image.values.size());
  for (std::size_t i = 0; i < read.values.size(); ++i)
    ASSERT_NEAR(read.values[i], image.values[i], 6) << i;
}

TEST_F(ImageFile, DepthsOfSixteenBitsAreExact)
{
  const auto depths = sampleDepths(31 * 17);
  const GrayImage16 read = grayOf(depthPngBytes(31, 17, depths));
  EXPECT_EQ(read.width, 31);
  EXPECT_EQ(read.height, 17);
  EXPECT_EQ(read.values, depths);
}

TEST_F(ImageFile, StoredValuesKnowNoGamma)
{
  const std::vector<std::uint8_t> rows = {0, 1, 2, 100, 254, 255, 7, 8};
  for (const double gamma : {0.45455, 1.0, 2.2}) {
    TestPng png{4, 2, 8, PNG_COLOR_TYPE_GRAY, false, gamma, rows};
    EXPECT_EQ(grayOf(pngBytes(png)).values,
              (std::vector<std::uint16_t>{0, 1, 2, 100, 254, 255, 7, 8}));
    png.width = 1;
    png.height = 4;
    png.bits = 16;
    EXPECT_EQ(grayOf(pngBytes(png)).values,
              (std::vector<std::uint16_t>{0x0001, 0x0264, 0xfeff, 0x0708}));
  }
}

TEST_F(ImageFile, InterlacedRowsFallIntoPlace)
{
  TestPng png;
  png.width = 13;
  png.height = 11;
  for (int i = 0; i < 143; ++i)
    png.rows.push_back(static_cast<std::uint8_t>(i));
  png.is_interlaced = true;
  const auto values = grayOf(pngBytes(png)).values;
  EXPECT_EQ(values, std::vector<std::uint16_t>(png.rows.begin(), png.rows.end()));
  const RgbImage colors = rgbOf(pngBytes(png));
  for (std::int32_t i = 0; i < 143; ++i)
    EXPECT_EQ(*colors.at(i % 13, i / 13), i);
}

TEST_F(ImageFile, EveryKindBecomesColour)
{
  using Values = std::vector<std::uint8_t>;
  const auto read = [&](int bits, int type, const Values& rows) {
    return rgbOf(pngBytes({2, 1, bits, type, false, {}, rows})).values;
  };
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_GRAY, {9, 200}), (Values{9, 9, 9, 200, 200, 200}));
  EXPECT_EQ(read(1, PNG_COLOR_TYPE_GRAY, {0x40}), (Values{0, 0, 0, 255, 255, 255}));
  EXPECT_EQ(read(16, PNG_COLOR_TYPE_GRAY, {9, 9, 255, 255}),
            (Values{9, 9, 9, 255, 255, 255}));
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 0, 200, 255}),
            (Values{9, 9, 9, 200, 200, 200}));
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 0, 4, 5, 6, 128}),
            (Values{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read(8, PNG_COLOR_TYPE_PALETTE, {7, 250}), (Values{7, 0, 0, 250, 0, 0}));
  for (const int type : {PNG_COLOR_TYPE_PALETTE, PNG_COLOR_TYPE_GRAY}) {
    TestPng png{2, 1, 8, type, false, {}, {0, 250}, true};
    const std::uint8_t other = type == PNG_COLOR_TYPE_GRAY ? 250 : 0;
    EXPECT_EQ(rgbOf(pngBytes(png)).values, (Values{0, 0, 0, 250, other, other}));
  }
}

TEST_F(ImageFile, WhatIsNoImageIsNamed)
{
  EXPECT_THAT(faultOf([&] { loadRgbImage(folder_.path("none.png")); }),
              HasSubstr("none.png: No such file"));
  EXPECT_THAT(faultOf([&] { loadGrayImage16(folder_.path("")); }),
              HasSubstr("is a folder"));
  EXPECT_THAT(rgbFault(""), HasSubstr("image: is empty"));
  EXPECT_THAT(rgbFault("P4 1 1 255 abc"), HasSubstr("is no PNG, JPEG, PGM or PPM"));
  EXPECT_THAT(rgbFault("x"), HasSubstr("is no PNG, JPEG, PGM or PPM"));
  EXPECT_THAT(rgbFault("\xff\xd8\xff"), HasSubstr("image: has no pixels"));
  EXPECT_THAT(rgbFault("\x89PNG\r\n\x1a\n"), HasSubstr("image: PNG: is truncated"));
  EXPECT_THAT(grayFault(textOfBytes(encodeJpeg(sampleImage(), 80))),
              HasSubstr("image: is no PNG"));
}

TEST_F(ImageFile, ReadsPgmAndPpm)
{
  using Values = std::vector<std::uint8_t>;
  const RgbImage color = rgbOf("P6 # made by hand\n2 1\n255\nabcdef");
  EXPECT_EQ(color.width, 2);
  EXPECT_EQ(color.height, 1);
  EXPECT_EQ(color.values, (Values{'a', 'b', 'c', 'd', 'e', 'f'}));
  const RgbImage grey = rgbOf("P5\n1 2 255\n #");
  EXPECT_EQ(grey.height, 2);
  EXPECT_EQ(grey.values, (Values{' ', ' ', ' ', '#', '#', '#'}));

  EXPECT_THAT(rgbFault("P6 2 1 255 abcde"), HasSubstr("6 bytes, 5 follow"));
  EXPECT_THAT(rgbFault("P5 2 1 255 abc"), HasSubstr("2 bytes, 3 follow"));
  EXPECT_THAT(rgbFault("P5 2 1 65535 abcd"), HasSubstr("8 bits"));
  EXPECT_THAT(rgbFault("P5 2 # 1 255 ab"), HasSubstr("lacks a number"));
  EXPECT_THAT(rgbFault("P5 -2 1 255 ab"), HasSubstr("lacks a number"));
  EXPECT_THAT(rgbFault("P5 2 1 255"), HasSubstr("lacks a space"));
  EXPECT_THAT(rgbFault("P5 0 1 255 "), HasSubstr("has no pixels"));
  EXPECT_THAT(rgbFault("P5 99999999999999999999 1 255 a"), HasSubstr("header"));
  EXPECT_THAT(rgbFault("P6 40000 40000 255 abc"), HasSubstr("at most"));
  EXPECT_THAT(rgbFault("P6 16384 16384 255 abc"), HasSubstr("is truncated"));
}

TEST_F(ImageFile, ReadsDepthsAsPgm)
{
  using Values = std::vector<std::uint16_t>;
  const auto read = [&](const std::string& bytes) {
    return loadGrayImage16(folder_.write("depth.pgm", bytes));
  };
  EXPECT_EQ(read("P5 2 1 65535 \x01\x02\x03\x04").values, (Values{0x102, 0x304}));
  EXPECT_EQ(read("P5 1 2 255 ab").values, (Values{'a', 'b'}));
  EXPECT_THAT(grayFault("P5 2 1 65535 abc"), HasSubstr("4 bytes, 3 follow"));
  EXPECT_THAT(grayFault("P5 2 1 65536 abcd"), HasSubstr("brightest value"));
  EXPECT_THAT(grayFault("P5 2 1 0 ab"), HasSubstr("brightest value"));
  EXPECT_THAT(grayFault("P6 1 1 255 abc"), HasSubstr("one channel"));
}

TEST_F(ImageFile, SavedPngsReadBackEqual)
{
  const RgbImage image = sampleImage();
  savePng(folder_.path("color.png"), image);
  EXPECT_EQ(loadRgbImage(folder_.path("color.png")).values, image.values);
  savePng(folder_.path("grey.png"), 2, 1, {7, 250});
  EXPECT_EQ(loadGrayImage16(folder_.path("grey.png")).values,
            (std::vector<std::uint16_t>{7, 250}));
  EXPECT_THROW(savePng(folder_.path("none.png"), 2, 1, {7}), BadArgumentException);
  EXPECT_THROW(savePng(folder_.path("none/x.png"), image), OutputFileException);
}

TEST_F(ImageFile, DepthHasOneChannelOfWholeBytes)
{
  EXPECT_THAT(grayFault(textOfBytes(encodePng(sampleImage()))),
              HasSubstr("image: PNG: one channel of 8 or 16 bits"));
  EXPECT_THAT(grayFault(pngBytes({2, 1, 4, PNG_COLOR_TYPE_GRAY, false, {}, {0x12}})),
              HasSubstr("one channel"));
  EXPECT_THAT(grayFault(pngBytes({1, 1, 8, PNG_COLOR_TYPE_PALETTE, false, {}, {1}})),
              HasSubstr("one channel"));
  EXPECT_THAT(
      grayFault(pngBytes({1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, false, {}, {1, 2}})),
      HasSubstr("one channel"));
}

/** Lengths to which a file is truncated: all that end in its headers or near its end,
 * and some that end in its data. */
std::vector<std::size_t>
lengthsShortOf(std::size_t size)
{
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length < size; ++length)
    if (length < 50 || length + 50 > size || length % 11 == 0)
      lengths.push_back(length);
  return lengths;
}

TEST_F(ImageFile, TruncatedAnywhereIsRefused)
{
  const std::string jpeg = textOfBytes(encodeJpeg(sampleImage(), 80));
  const std::string png = textOfBytes(encodePng(sampleImage(20, 10)));
  const std::string depth = depthPngBytes(31, 17, sampleDepths(31 * 17));
  for (const std::size_t length : lengthsShortOf(jpeg.size()))
    ASSERT_THAT(rgbFault(jpeg.substr(0, length)), HasSubstr("image: ")) << length;
  for (const std::size_t length : lengthsShortOf(png.size()))
    ASSERT_THAT(rgbFault(png.substr(0, length)), HasSubstr("image: ")) << length;
  for (const std::size_t length : lengthsShortOf(depth.size()))
    ASSERT_THAT(grayFault(depth.substr(0, length)), HasSubstr("image: ")) << length;
}

TEST_F(ImageFile, FlippedBytesOfAPngAreNoticed)
{
  const std::string good = depthPngBytes(9, 5, sampleDepths(45));
  for (std::size_t place = 0; place < good.size(); ++place) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ 0x10);
    ASSERT_THAT(grayFault(bad), HasSubstr("image: ")) << place;
  }
}

TEST_F(ImageFile, FlippedBytesOfAJpegDoNoHarm)
{
  const std::string good = textOfBytes(encodeJpeg(sampleImage(), 80));
  std::size_t refused = 0;
  for (std::size_t place = 0; place < good.size(); place += place < 700 ? 1 : 7) {
    std::string bad = good;
    bad[place] = static_cast<char>(bad[place] ^ (place % 2 ? '\x01' : '\x80'));
    refused += rgbFault(bad) == "no fault" ? 0 : 1;
  }
  EXPECT_GT(refused, 50u); // undetected errors change colours
}

std::string
withBytes(std::string file, std::size_t place, const std::string& bytes)
{
  return file.replace(place, bytes.size(), bytes);
}

/** The header of a PNG with another size and a valid checksum. */
std::string
pngClaiming(std::uint32_t width, std::uint32_t height)
{
  TestPng png;
  png.width = png.height = 1;
  png.bits = 16;
  png.rows = {1, 2};
  std::string file = pngBytes(png);
  const auto bytesOf = [](std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0})
      bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  file = withBytes(file, 16, bytesOf(width) + bytesOf(height));
  std::uint32_t checksum = 0xffffffff;
  for (std::size_t i = 12; i < 29; ++i) {
    checksum ^= static_cast<std::uint8_t>(file[i]);
    for (int bit = 0; bit < 8; ++bit)
      checksum = checksum >> 1 ^ (checksum & 1 ? 0xedb88320 : 0);
  }
  return withBytes(file, 29, bytesOf(~checksum));
}

TEST_F(ImageFile, LyingHeadersAreRefused)
{
  ASSERT_EQ(grayFault(pngClaiming(1, 1)), "no fault"); // the checksum is valid
  EXPECT_THAT(grayFault(pngClaiming(60000, 60000)), HasSubstr("60000 x 60000"));
  EXPECT_THAT(rgbFault(pngClaiming(60000, 60000)), HasSubstr("at most 268435456"));
  EXPECT_THAT(grayFault(pngClaiming(1 << 30, 1)), HasSubstr("at most 268435456"));
  EXPECT_THAT(grayFault(pngClaiming(16000, 16000)), HasSubstr("is truncated: claims"));
  EXPECT_THAT(grayFault(pngClaiming(20, 1)), HasSubstr("image: PNG: "));
  EXPECT_THAT(grayFault(pngClaiming(0, 1)), HasSubstr("image: PNG: "));
  EXPECT_THAT(grayFault(pngClaiming(0x80000000, 1)), HasSubstr("image: PNG: "));

  const std::string jpeg = textOfBytes(encodeJpeg(sampleImage(), 80));
  const std::size_t frame = jpeg.find("\xff\xc2");
  ASSERT_NE(frame, std::string::npos);
  const auto claiming = [&](const std::string& height_and_width) {
    return withBytes(jpeg, frame + 5, height_and_width);
  };
  EXPECT_THAT(rgbFault(claiming("\xea\x60\xea\x60")), HasSubstr("60000 x 60000"));
  EXPECT_THAT(rgbFault(claiming("\x3e\x80\x3e\x80")), HasSubstr("is truncated"));
  EXPECT_THAT(rgbFault(claiming("\x01\x2b")), HasSubstr("image: JPEG: "));
}

TEST_F(ImageFile, WhatIsNoPictureIsNotEncoded)
{
  RgbImage image;
  EXPECT_THROW(encodePng(image), BadArgumentException);
  EXPECT_THROW(encodeJpeg(image, 80), BadArgumentException);
  image = sampleImage(4, 4);
  EXPECT_THROW(encodeJpeg(image, 0), BadArgumentException);
  EXPECT_THROW(encodeJpeg(image, 101), BadArgumentException);
  image.values.pop_back();
  EXPECT_THROW(encodePng(image), BadArgumentException);
  EXPECT_THROW(encodeJpeg(image, 80), BadArgumentException);
  image.width = -4;
  image.height = -4;
  EXPECT_THROW(encodePng(image), BadArgumentException);
  image.width = 65501;
  image.height = 1;
  image.values.assign(3 * 65501, 9);
  EXPECT_THROW(encodeJpeg(image, 80), BadArgumentException);
  EXPECT_EQ(rgbOf(textOfBytes(encodePng(image))).values, image.values);
}

} // namespace
} // namespace pcl::acmap::test
