#pragma once

#include <pcl/core/trinocular_frame.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief The frames of a raw session, in their order. */
std::vector<TrinocularFrame::ConstPtr>
framesOf(const std::string& session);

/** \brief Mean grey level over all channels. */
double
meanOf(const CameraImage& image);

} // namespace pcl::acmap::test
