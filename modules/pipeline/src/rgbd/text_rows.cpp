#include "rgbd/text_rows.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/trajectory.h>

#include <Eigen/LU>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr std::uintmax_t max_bytes = 64 * 1024 * 1024;

[[noreturn]] void
fail(const std::string& path, const std::string& fault)
{
  throw InputFileException(path + ": " + fault);
}

std::string
placeOf(const TextRow& row)
{
  return "line " + std::to_string(row.line) + ": ";
}

/** \brief A word for a message, shortened and made printable. */
std::string
quoted(const std::string& word)
{
  constexpr std::size_t longest = 24;
  std::string text = word.substr(0, longest);
  for (char& c : text)
    if (c < ' ' || c > '~')
      c = '?';
  return "'" + text + (word.size() > longest ? "..." : "") + "'";
}

void
requireText(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    fail(path, "is missing");
  if (!std::filesystem::is_regular_file(status))
    fail(path, "is no file");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error)
    fail(path, error.message());
  if (bytes > max_bytes)
    fail(path, "is too long: " + std::to_string(bytes) + " bytes");
}

} // namespace

std::vector<TextRow>
loadTextRows(const std::string& path)
{
  requireText(path);
  std::ifstream file(path);
  if (!file)
    fail(path, "cannot be read");
  return readTextRows(file, path);
}

std::vector<TextRow>
readTextRows(std::istream& stream, const std::string& path)
{
  std::vector<TextRow> rows;
  std::size_t line = 0;
  for (std::string text; std::getline(stream, text);) {
    TextRow row{++line, {}};
    std::istringstream words(text.substr(0, text.find('#')));
    for (std::string word; words >> word;)
      row.words.push_back(word);
    if (!row.words.empty())
      rows.push_back(std::move(row));
  }
  if (stream.bad())
    fail(path, "cannot be read to its end");
  if (rows.empty())
    fail(path, "is empty");
  return rows;
}

void
refuseWord(const std::string& path,
           const TextRow& row,
           std::size_t word,
           const std::string& fault)
{
  fail(path, placeOf(row) + quoted(row.words[word]) + " " + fault);
}

double
anyNumberOf(const std::string& path, const TextRow& row, std::size_t word)
{
  const std::string& text = row.words[word];
  const char* const begin = text.data() + (text[0] == '+' ? 1 : 0);
  const char* const end = text.data() + text.size();
  double value = 0;
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc() || result.ptr != end)
    refuseWord(path, row, word, "is no finite number");
  return value;
}

double
numberOf(const std::string& path, const TextRow& row, std::size_t word)
{
  const double value = anyNumberOf(path, row, word);
  if (!std::isfinite(value))
    refuseWord(path, row, word, "is no finite number");
  return value;
}

std::vector<double>
loadSquareMatrix(const std::string& path, std::size_t size)
{
  const std::vector<TextRow> rows = loadTextRows(path);
  if (rows.size() != size)
    fail(path,
         "has " + std::to_string(rows.size()) + " rows, " + std::to_string(size) +
             " are needed");
  std::vector<double> values;
  for (const TextRow& row : rows) {
    if (row.words.size() != size)
      fail(path,
           placeOf(row) + "has " + std::to_string(row.words.size()) + " numbers, " +
               std::to_string(size) + " are needed");
    for (std::size_t word = 0; word < size; ++word)
      values.push_back(numberOf(path, row, word));
  }
  return values;
}

bool
isRotation(const Eigen::Matrix3d& matrix)
{
  return isRigid(Eigen::Isometry3d(matrix), text_slack);
}

} // namespace pcl::acmap
