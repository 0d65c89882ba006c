#pragma once

#include "light_pattern.h"
#include "lit_view.h"

#include <pcl/core/trinocular_frame.h>

#include <cstdint>

namespace pcl::acmap {

/** \brief Takes one picture of a view that was cast: light, blur, noise, 8 bits. Each row
 * has a random stream of its own; runs in all threads of the caller's arena, with the
 * same result for any number.
 * \param[in] pattern on the projector, nullptr when it is off
 * \param[in] stream seed of the noise of this picture */
CameraImage
shadeShot(const LitView& view,
          const LightPattern* pattern,
          const SimulatedLight& light,
          std::uint64_t stream);

} // namespace pcl::acmap
