#pragma once

#include "checks.h"
#include "files/byte_source.h"

namespace pcl::acmap::test {

/** \brief \ref acceptedBy for an internal reader of core that reads bytes. */
template <typename Reader>
auto
acceptedBy(const Reader& reader, const void* data, std::size_t size)
{
  return acceptedBy([&] {
    ByteSource source("input", data, size);
    return reader(source);
  });
}

} // namespace pcl::acmap::test
