#pragma once

#include "e57_pages.h"

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

/** \brief Reads the points of a scan one after the other. */
class E57Points {
public:
  /** \param[in] section logical offset of their section
   * \throws InputFileException if there are fewer than stated, or a packet is
   * malformed */
  E57Points(const std::vector<E57Field>& fields,
            std::uint64_t section,
            std::uint64_t count,
            const E57Pages& pages,
            const ByteSource& source);

  /** \brief The values of the next point, one per field; valid until the next call. To be
   * called as often as there are points. */
  const std::vector<double>&
  next();

private:
  void
  collect(std::uint64_t section,
          std::uint64_t count,
          const E57Pages& pages,
          const ByteSource& source);

  std::uint64_t
  nextBits(std::size_t field);

  const std::vector<E57Field>& fields_;
  std::vector<std::string> streams_;    ///< bytes of each field
  std::vector<std::uint64_t> position_; ///< bits that were read of each
  std::vector<double> values_;
};

} // namespace pcl::acmap
