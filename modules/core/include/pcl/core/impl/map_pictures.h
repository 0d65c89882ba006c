#pragma once

#include <pcl/core/compact_map.h>

#include <type_traits>
#include <vector>

namespace pcl::acmap {

/** \brief Pointers to the pictures of a map: those of its charts, followed by those of its
 * cylinders, if there are any. \ingroup core */
template <typename Map>
auto
picturesOf(Map& map)
{
  using Picture =
      std::conditional_t<std::is_const_v<Map>, const TexturePicture, TexturePicture>;
  std::vector<Picture*> pictures;
  for (auto& chart : map.charts)
    pictures.push_back(&chart);
  for (auto& picture : map.cylinder_pictures)
    pictures.push_back(&picture);
  return pictures;
}

/** \brief Has any texel of a picture a colour? \ingroup core */
inline bool
hasColor(const TexturePicture& picture)
{
  for (const TexelKind kind : picture.kinds)
    if (kind != TexelKind::None)
      return true;
  return false;
}

} // namespace pcl::acmap
