#pragma once

#include "register_access.h"

#include <pcl/acquisition/iidc_types.h>

#include <variant>

namespace pcl::acmap {

/** \brief Reads the capabilities and the state of a feature. */
IidcFeatureState
readFeature(const RegisterAccess& camera, IidcFeature feature);

/** \brief The ways to set a feature: automatic, in the camera's units, in physical
 * units. */
struct AutomaticSetting {};
struct StepSetting {
  unsigned value;
};
struct PhysicalSetting {
  float value;
};
using FeatureSetting = std::variant<AutomaticSetting, StepSetting, PhysicalSetting>;

/** \brief Sets a feature.
 * \throws BadArgumentException naming the valid range of the value
 * \throws CameraException Unsupported if the camera cannot do this */
void
writeFeature(const RegisterAccess& camera,
             IidcFeature feature,
             const FeatureSetting& setting);

/** \brief Sets the trigger. \throws CameraException Unsupported without a trigger
 * input */
void
writeTrigger(const RegisterAccess& camera, IidcTrigger trigger);

} // namespace pcl::acmap
