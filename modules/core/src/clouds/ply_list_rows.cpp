#include "clouds/ply_list_rows.h"

#include "files/record_moves.h"

namespace pcl::acmap {

std::optional<PlyListRow>
planListRow(const PlyElement& element, PlyHeader::Encoding encoding)
{
  if (encoding == PlyHeader::Encoding::ascii)
    return std::nullopt;
  PlyListRow row;
  row.swap = encoding == PlyHeader::Encoding::big_endian;
  for (const PlyProperty& property : element.properties) {
    if (!property.isList()) {
      (row.list ? row.after : row.before) += sizeOfType(property.datatype);
      continue;
    }
    if (row.list)
      return std::nullopt;
    row.list = &property;
    row.length_bytes = sizeOfType(property.length_datatype);
    row.value_bytes = sizeOfType(property.datatype);
  }
  return row.list ? std::optional(row) : std::nullopt;
}

} // namespace pcl::acmap
