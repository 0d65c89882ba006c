#include "record_reader.h"

#include "byte_source.h"

#include <algorithm>
#include <vector>

namespace pcl::acmap {

void
swapRecords(const FieldLayout& layout, std::uint8_t* records, std::size_t count)
{
  for (const SourceField& field : layout.source) {
    const std::size_t size = sizeOfType(field.datatype);
    for (std::size_t at = 0; size > 1 && at < field.bytes(); at += size)
      swapValues(records + field.offset + at, size, layout.source_step, count);
  }
}

void
readRecords(ByteSource& source,
            const FieldLayout& layout,
            bool swap_bytes,
            std::size_t count,
            std::uint8_t* points)
{
  const std::size_t step = layout.source_step;
  if (layout.same && !swap_bytes) {
    source.read(points, count * step);
    return;
  }
  // Chunks fit into the cache, and are long enough to bypass the buffer of the source.
  const std::size_t chunk =
      std::min(count, ByteSource::maximum_line / std::max<std::size_t>(step, 1) + 1);
  std::vector<std::uint8_t> records(chunk * step);
  const auto moves = layout.moves();
  for (std::size_t done = 0; done < count; done += chunk) {
    const std::size_t now = std::min(chunk, count - done);
    source.read(records.data(), now * step);
    if (swap_bytes)
      swapRecords(layout, records.data(), now);
    moveRecords(moves,
                records.data(),
                step,
                points + done * layout.point_step,
                layout.point_step,
                now);
  }
}

} // namespace pcl::acmap
