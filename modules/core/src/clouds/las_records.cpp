#include "clouds/las_records.h"

#include "files/byte_source.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <string>

namespace pcl::acmap {

namespace {

/** \brief Contents of the records that describe the reference system. */
struct ReferenceSystem {
  std::string text, keys, numbers;

  std::string*
  find(std::uint16_t record)
  {
    switch (record) {
    case 2112:
      return &text;
    case 34735:
      return &keys;
    case 34736:
      return &numbers;
    default:
      return nullptr;
    }
  }
};

struct RecordHead {
  bool is_of_projection = false;
  std::uint16_t number = 0;
  std::uint64_t bytes = 0; ///< that follow
};

RecordHead
readHead(bool is_extended, ByteSource& source)
{
  constexpr char user[] = "LASF_Projection";
  std::array<char, 60> bytes{};
  source.read(bytes.data(), is_extended ? 60 : 54);
  RecordHead head;
  head.is_of_projection = std::memcmp(&bytes[2], user, sizeof user) == 0;
  std::memcpy(&head.number, &bytes[18], sizeof head.number);
  std::memcpy(&head.bytes, &bytes[20], is_extended ? 8 : 2);
  return head;
}

} // namespace

CoordinateUnits
unitsOfRecords(const LasRecords& records, ByteSource& source)
{
  const std::uint64_t head_bytes = records.are_extended ? 60 : 54;
  constexpr std::uint64_t longest = 65535; // of what tells units
  ReferenceSystem system;
  for (std::uint64_t at = records.begin; at + head_bytes <= records.end;) {
    source.moveTo(at);
    const RecordHead head = readHead(records.are_extended, source);
    at += head_bytes;
    if (head.bytes > records.end - at)
      break;
    if (std::string* const content = system.find(head.number);
        content && head.is_of_projection && head.bytes <= longest) {
      content->resize(static_cast<std::size_t>(head.bytes));
      source.read(content->data(), content->size());
    }
    at += head.bytes;
  }
  const CoordinateUnits by_text = unitsOfWkt(system.text);
  return by_text.across || by_text.are_degrees
             ? by_text
             : unitsOfGeoKeys(system.keys, system.numbers);
}

} // namespace pcl::acmap
