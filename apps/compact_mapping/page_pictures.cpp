#include "report_page.h"

#include "page_text.h"

#include <pcl/core/image_file.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace pcl::acmap {

namespace {

std::vector<std::uint8_t>
bytesOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool
isPng(const std::vector<std::uint8_t>& bytes)
{
  constexpr std::uint8_t signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return bytes.size() > std::size(signature) &&
         std::equal(std::begin(signature), std::end(signature), bytes.begin());
}

/** Checks the picture completely: a browser would show half of a damaged picture, or
 * none, without a message. */
std::string
imageTag(const std::string& path, const std::string& description)
{
  const RgbImage image = loadRgbImage(path);
  const std::vector<std::uint8_t> bytes = bytesOf(path);
  if (!isPng(bytes))
    throw InputFileException(path + ": is no PNG");
  return "<img width=\"" + std::to_string(image.width) + "\" height=\"" +
         std::to_string(image.height) + "\" alt=\"" + htmlText(description) +
         "\" src=\"data:image/png;base64," + base64(bytes) + "\">";
}

} // namespace

std::string
base64(const std::vector<std::uint8_t>& bytes)
{
  constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr unsigned shifts[] = {18, 12, 6, 0};
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[bits >> shifts[k] & 63U] : '=';
  }
  return text;
}

std::string
pictureFigure(const std::string& path,
              const std::string& name,
              const std::string& caption)
{
  const std::string& description = caption.empty() ? name : caption;
  try {
    return "<figure>\n" + imageTag(path, description) + "\n<figcaption>" +
           htmlText(description) + "</figcaption>\n</figure>\n";
  }
  catch (const InputFileException&) {
    return "<p class=\"missing\">No picture \xE2\x80\x9C" + htmlText(description) +
           "\xE2\x80\x9D: " + htmlText(name) + " is missing or damaged.</p>\n";
  }
}

} // namespace pcl::acmap
