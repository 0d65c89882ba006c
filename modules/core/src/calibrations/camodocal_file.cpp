#include "calibrations/calibration_kinds.h"
#include "calibrations/camera_values.h"

#include <array>

namespace pcl::acmap {

namespace {

constexpr double largest_camodocal_value = 1e6; // px

bool
isCamodocal(const YamlNode& map)
{
  return map.find("model_type") && map.find("projection_parameters");
}

/** One camera, of which another file of the program has the pose on the body. */
void
readCamodocal(const YamlNode& map, Calibration& calibration)
{
  const auto valueIn = [](const YamlNode& node, const char* key) {
    return node.at(key).number(-largest_camodocal_value, largest_camodocal_value);
  };
  const YamlNode& model = map.at("model_type");
  const YamlNode& projection = map.at("projection_parameters");
  if (model.text() != "PINHOLE") {
    CameraCalibration none;
    setDistortion(model.text(), {}, model, none);
  }
  CalibratedView view = viewOf(valueIn(projection, "fx"),
                               valueIn(projection, "fy"),
                               valueIn(projection, "cx"),
                               valueIn(projection, "cy"),
                               projection);
  readSize(map, "image_width", "image_height", view);
  std::vector<double> coefficients;
  if (const YamlNode* const distortion = map.find("distortion_parameters"))
    for (const char* const key : {"k1", "k2", "p1", "p2"})
      coefficients.push_back(distortion->find(key) ? valueIn(*distortion, key) : 0.0);
  setDistortion("", coefficients, model, view.camera);
  CalibratedCamera camera{"camera", {}, {}};
  (view.camera.distortion == std::array<double, 5>{} ? camera.rectified
                                                     : camera.built) = view;
  calibration.cameras.push_back(camera);
}

} // namespace

const CalibrationKind camodocal_kind{
    "camodocal's camera (VINS)",
    "fx, fy, cx, cy in pixels; where the other camera stands is not in the file",
    isCamodocal,
    readCamodocal};

} // namespace pcl::acmap
