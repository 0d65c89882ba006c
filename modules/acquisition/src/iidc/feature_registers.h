#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <variant>

namespace pcl::acmap {

/** \brief What a camera says of a feature. */
IidcFeatureState
readFeature(const RegisterAccess& camera, IidcFeature feature);

/** \brief How a feature is set. */
struct AutomaticSetting {};
struct StepSetting {
  unsigned value;
};
struct PhysicalSetting {
  float value;
};
using FeatureSetting = std::variant<AutomaticSetting, StepSetting, PhysicalSetting>;

/** \brief Sets it.
 * \throws BadArgumentException naming the range of a value
 * \throws CameraException Unsupported where the camera cannot */
void
writeFeature(const RegisterAccess& camera,
             IidcFeature feature,
             const FeatureSetting& setting);

/** \brief \throws CameraException Unsupported without a trigger input */
void
writeTrigger(const RegisterAccess& camera, IidcTrigger trigger);

} // namespace pcl::acmap
