#pragma once

namespace pcl::acmap {

/** \brief The page with placeholders for what follows, and for the map. */
const char*
mapPageTemplate();

/** \name three.js, https://threejs.org, MIT licence */
///@{
const char*
threeScript();

const char*
gltfLoaderScript();

const char*
orbitControlsScript();
///@}

} // namespace pcl::acmap
