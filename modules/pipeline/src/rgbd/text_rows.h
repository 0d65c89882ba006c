#pragma once

#include <Eigen/Core>

#include <istream>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A line of a text file, split at blanks. */
struct TextRow {
  std::size_t line; ///< line number, from 1
  std::vector<std::string> words;
};

/** \brief Reads a text file without its comments (#) and blank lines. At most 64 MB.
 * \throws InputFileException when it is missing, empty, unreadable or too long */
std::vector<TextRow>
loadTextRows(const std::string& path);

/** \brief Reads the same from a stream.
 * \param[in] path name of the stream in messages
 * \throws InputFileException when it is empty or cannot be read to its end */
std::vector<TextRow>
readTextRows(std::istream& stream, const std::string& path);

/** \brief Throws an InputFileException that names file, line and word.
 * \param[in] fault text after the word, such as "is no finite number" */
[[noreturn]] void
refuseWord(const std::string& path,
           const TextRow& row,
           std::size_t word,
           const std::string& fault);

/** \brief Converts a word to a number.
 * \throws InputFileException naming file, line and word when it is no finite number */
double
numberOf(const std::string& path, const TextRow& row, std::size_t word);

/** \brief The same for a number that may be infinite or nan. */
double
anyNumberOf(const std::string& path, const TextRow& row, std::size_t word);

/** \brief Reads a square matrix, row by row.
 * \throws InputFileException naming file and fault when it does not have size rows of
 * size finite numbers */
std::vector<double>
loadSquareMatrix(const std::string& path, std::size_t size);

/** Tolerance for numbers that are written with few digits. */
constexpr double text_slack = 0.01;

/** \brief Is a matrix a proper rotation, within the precision of a text file? */
bool
isRotation(const Eigen::Matrix3d& matrix);

} // namespace pcl::acmap
