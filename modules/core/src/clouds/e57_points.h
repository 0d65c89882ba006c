#pragma once

#include "clouds/e57_pages.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pugi {
class xml_node;
}

namespace pcl::acmap {

/** \brief A field of the points of a scan. */
struct E57Field {
  enum class Kind { Single, Double, Integer };

  std::string name;
  Kind kind = Kind::Integer;
  std::int64_t minimum = 0; ///< of an integer
  unsigned bits = 0;        ///< of a value in the file
  double scale = 1, offset = 0;
  double least = 0, most = 0; ///< as the file states them
};

/** \brief Reads the fields of a prototype.
 * \throws InputFileException for a field that is no number, or too many of them */
std::vector<E57Field>
e57FieldsIn(const pugi::xml_node& prototype, const ByteSource& source);

/** \brief The points of a scan one after the other. */
class ScanPoints {
public:
  virtual ~ScanPoints() = default;

  /** \brief The values of the next point, one per field; valid until the next call. To be
   * called as often as there are points.
   * \throws InputFileException if there are fewer than stated, or one is malformed */
  virtual const std::vector<double>&
  next() = 0;
};

/** \brief Those of an E57 file, packet by packet. */
class E57Points : public ScanPoints {
public:
  /** \param[in] section logical offset of their section
   * \throws InputFileException if there is none */
  E57Points(const std::vector<E57Field>& fields,
            std::uint64_t section,
            std::uint64_t count,
            E57Pages& pages);

  const std::vector<double>&
  next() override;

private:
  /** \brief Bytes of a field that were not used yet. */
  struct Stream {
    std::string bytes;
    std::uint64_t position = 0; ///< bits of them that were used
  };

  void
  require(std::uint64_t offset, std::uint64_t length) const;

  bool
  hasNext(std::size_t field) const;

  void
  readPacket();

  std::uint64_t
  nextBits(std::size_t field);

  const std::vector<E57Field>& fields_;
  E57Pages& pages_;
  std::uint64_t count_, done_ = 0;     ///< points
  std::uint64_t packet_ = 0, end_ = 0; ///< logical offsets
  std::vector<Stream> streams_;
  std::vector<double> values_;
};

} // namespace pcl::acmap
