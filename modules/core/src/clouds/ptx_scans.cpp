#include "clouds/e57_scans.h"
#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace pcl::acmap {

namespace {

using Kind = E57Field::Kind;

E57Field
fieldNamed(const char* name)
{
  E57Field field;
  field.name = name;
  field.kind = Kind::Double;
  return field;
}

/** \brief Reads the next numbers of a scan's header.
 * \return false at the end of the file
 * \throws InputFileException for another number of them */
template <std::size_t Count>
bool
readNumbers(ByteSource& source, std::array<double, Count>& numbers)
{
  std::string_view line, word;
  if (!source.readFilledLine(line))
    return false;
  Words words(line);
  for (double& number : numbers)
    if (!words.next(word) || !parseNumber(word, number))
      source.failAtLine("has not the " + std::to_string(Count) +
                        " numbers of a header of PTX");
  if (words.next(word))
    source.failAtLine("has more than the " + std::to_string(Count) +
                      " numbers of a header of PTX");
  return true;
}

/** \throws InputFileException for what is no pose */
Eigen::Isometry3d
readPose(ByteSource& source)
{
  constexpr double turned = 1e-2;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::array<double, 3> unused{};
  bool is_complete = true;
  for (int line = 0; line < 4;
       ++line) // place and axes of the scanner, as in the matrix
    is_complete = readNumbers(source, unused) && is_complete;
  for (int line = 0; line < 4; ++line) {
    std::array<double, 4> row{};
    is_complete = readNumbers(source, row) && is_complete;
    const Eigen::Vector3d part(row[0], row[1], row[2]);
    if (line < 3)
      pose.linear().col(line) = part; // of a matrix that rows are multiplied by
    else
      pose.translation() = part;
  }
  if (!is_complete)
    source.fail("ends within the header of a scan");
  const Eigen::Matrix3d product = pose.linear() * pose.linear().transpose();
  if (!pose.matrix().allFinite() ||
      !((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < turned) ||
      pose.linear().determinant() < 0)
    source.fail("a scan has a pose whose matrix is no rotation");
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return pose;
}

std::size_t
wordsIn(std::string_view line)
{
  Words words(line);
  std::size_t count = 0;
  for (std::string_view word; words.next(word);)
    ++count;
  return count;
}

/** The fields of rows with so many numbers.
 * \throws InputFileException for another number than those of PTX */
std::vector<E57Field>
fieldsOf(std::size_t columns, bool has_grid, const ByteSource& source)
{
  std::vector<E57Field> fields;
  const auto add = [&](std::initializer_list<const char*> names) {
    for (const char* name : names)
      fields.push_back(fieldNamed(name));
  };
  add({"cartesianX", "cartesianY", "cartesianZ"});
  if (columns == 4 || columns == 7)
    add({"intensity"});
  if (columns == 6 || columns == 7)
    add({"colorRed", "colorGreen", "colorBlue"});
  if (fields.size() != columns)
    source.fail("has rows of " + std::to_string(columns) +
                " numbers; 3, 4, 6 or 7 are those of PTX");
  add({"cartesianInvalidState"});
  if (has_grid)
    add({"columnIndex", "rowIndex"});
  return fields;
}

/** \brief Reads the rows of a scan. */
class PtxPoints : public ScanPoints {
public:
  PtxPoints(const E57Scan& scan, ByteSource& source)
  : scan_(scan)
  , source_(source)
  , values_(scan.fields.size())
  , invalid_(scan.fieldOf("cartesianInvalidState"))
  {
    source.moveTo(scan.section);
  }

  const std::vector<double>&
  next() override
  {
    std::string_view line, word;
    if (!source_.readFilledLine(line))
      source_.fail("ends within a scan");
    Words words(line);
    for (std::size_t i = 0; i < invalid_; ++i)
      if (!words.next(word) || !parseNumber(word, values_[i]))
        source_.fail("a scan has a row " + inQuotes(line) + " that is not " +
                     std::to_string(invalid_) + " numbers");
    const bool is_nowhere = values_[0] == 0 && values_[1] == 0 && values_[2] == 0;
    values_[invalid_] = is_nowhere ? 1 : 0;
    if (invalid_ + 1 < values_.size()) {
      values_[invalid_ + 1] = static_cast<double>(done_ / scan_.column_points);
      values_[invalid_ + 2] = static_cast<double>(done_ % scan_.column_points);
    }
    ++done_;
    return values_;
  }

private:
  const E57Scan& scan_;
  ByteSource& source_;
  std::vector<double> values_;
  std::size_t invalid_;
  std::uint64_t done_ = 0;
};

class PtxReader : public ScanReader {
public:
  explicit PtxReader(ByteSource& source)
  : source_(source)
  {}

  std::vector<E57Scan>
  scans() override
  {
    source_.moveTo(0);
    std::vector<E57Scan> scans;
    while (readScan(scans))
      ;
    if (scans.empty())
      source_.fail("has no scan");
    return scans;
  }

  std::unique_ptr<ScanPoints>
  open(const E57Scan& scan) override
  {
    return std::make_unique<PtxPoints>(scan, source_);
  }

  const ByteSource&
  source() const override
  {
    return source_;
  }

private:
  /** Number of rows up to the next line with a single number, before which it stops.
   * \param[out] columns of the first row */
  std::uint64_t
  countRows(std::size_t& columns)
  {
    std::uint64_t rows = 0, begin = position();
    for (std::string_view line; source_.readFilledLine(line); begin = position()) {
      const bool may_be_one = line.find_first_of(" \t") == line.npos || rows == 0;
      if (may_be_one && wordsIn(line) == 1) {
        source_.moveTo(begin);
        break;
      }
      if (rows++ == 0)
        columns = wordsIn(line);
    }
    return rows;
  }

  std::uint64_t
  position() const
  {
    return source_.size() - source_.remaining();
  }

  /** \return false at the end of the file */
  bool
  readScan(std::vector<E57Scan>& scans)
  {
    std::array<double, 1> columns{}, rows{};
    constexpr double most = 1e9;
    if (!readNumbers(source_, columns))
      return false;
    if (!readNumbers(source_, rows) || !(columns[0] >= 0 && columns[0] < most) ||
        !(rows[0] >= 0 && rows[0] < most))
      source_.fail("a scan has a header without its columns and rows");
    E57Scan scan;
    scan.T_map_scan = readPose(source_);
    scan.section = position();
    scan.color_limits = {0, 255, 0, 255, 0, 255};
    std::size_t numbers = 3;
    scan.points = countRows(numbers);
    const bool has_grid =
        rows[0] > 0 && static_cast<double>(scan.points) == columns[0] * rows[0];
    if (!has_grid)
      scan.remark = "a scan claims " + textOf(columns[0]) + " x " + textOf(rows[0]) +
                    " points, the file has " + std::to_string(scan.points) +
                    ": its rows and columns are not known";
    scan.column_points = static_cast<std::uint64_t>(rows[0]);
    scan.fields = fieldsOf(scan.points > 0 ? numbers : 3, has_grid, source_);
    scans.push_back(std::move(scan));
    return true;
  }

  ByteSource& source_;
};

} // namespace

std::unique_ptr<ScanReader>
readerOfPtx(ByteSource& source)
{
  return std::make_unique<PtxReader>(source);
}

} // namespace pcl::acmap
