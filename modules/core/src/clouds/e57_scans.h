#pragma once

#include "clouds/e57_points.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A scan: where its points are in the file, and its pose. Those of a PTX file are
 * described as those of an E57 file. */
struct E57Scan {
  std::vector<E57Field> fields;
  std::uint64_t section = 0; ///< logical offset, of a PTX file that of the first row
  std::uint64_t points = 0;
  Eigen::Isometry3d T_map_scan = Eigen::Isometry3d::Identity();
  std::array<double, 6> color_limits{}; ///< least and most of red, green, blue

  std::uint64_t column_points = 0; ///< of a PTX file: points of a column of its grid
  std::string remark;              ///< what its header claims wrongly

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /** \brief Number of the field of a name, or \ref none. */
  std::size_t
  fieldOf(const char* name) const
  {
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name == name)
        return i;
    return none;
  }
};

/** \brief Reads what a file says of its scans.
 * \throws InputFileException if it has none, or if they claim more points than the file can
 * have */
std::vector<E57Scan>
scansIn(E57Pages& pages);

/** \brief A file of scans. */
class ScanReader {
public:
  virtual ~ScanReader() = default;

  /** \brief Reads what the file says of its scans, at least one.
   * \throws InputFileException if it has none, or they are malformed */
  virtual std::vector<E57Scan>
  scans() = 0;

  /** \brief Opens a scan. The points of one scan are read at a time. */
  virtual std::unique_ptr<ScanPoints>
  open(const E57Scan& scan) = 0;

  virtual const ByteSource&
  source() const = 0;
};

/** \brief Reads an E57 file.
 * \param[in] verifies compares all pages with their checksums */
std::unique_ptr<ScanReader>
readerOfE57(ByteSource& source, bool verifies);

/** \brief Reads a PTX file: grids, each with ten lines of header, whose last four are its
 * pose, and a row x y z, with intensity or red green blue or both, for each point. (0, 0, 0)
 * is no point. */
std::unique_ptr<ScanReader>
readerOfPtx(ByteSource& source);

} // namespace pcl::acmap
