#pragma once

namespace pcl::acmap {

/** \brief The page, with marks such as {{map}} for what is filled in. */
const char*
mapPageTemplate();

const char*
mapPageStyle();

/** \brief All that the page runs, in one script, with the licences of three.js,
 * camera-controls and three-mesh-bvh; empty if acmap was built without these. */
const char*
mapPageScript();

} // namespace pcl::acmap
