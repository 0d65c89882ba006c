#include "reading_options.h"

#include "setter_option.h"

#include <locale>
#include <sstream>
#include <string>

namespace pcl::acmap {

namespace {

/** Three numbers with commas.
 * \return false for other texts */
bool
readTriple(const std::string& text, Eigen::Vector3d& triple)
{
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  char comma = ',';
  for (int i = 0; i < 3; ++i)
    if ((i > 0 && !(numbers >> comma)) || comma != ',' || !(numbers >> triple[i]))
      return false;
  return numbers.peek() == std::istringstream::traits_type::eof() && triple.allFinite();
}

/** The direction of x, -x, y, -y, z or -z, or of three numbers with commas.
 * \throws CLI::ValidationError for other texts */
Eigen::Vector3d
directionOf(const std::string& text)
{
  const bool is_opposite = !text.empty() && text[0] == '-';
  const std::string axis = text.substr(is_opposite ? 1 : 0);
  if (axis == "x" || axis == "y" || axis == "z")
    return (is_opposite ? -1 : 1) * Eigen::Vector3d::Unit(axis[0] - 'x');
  Eigen::Vector3d direction;
  if (!readTriple(text, direction) || direction.isZero(0))
    throw CLI::ValidationError("--up",
                               text + " is no direction: x, y, z, one of these with a "
                                      "minus, or three numbers as 0.1,-1,0");
  return direction;
}

void
stateSensor(PointCloudReader& reader, const std::string& text)
{
  Eigen::Vector3d origin;
  if (text == "none")
    reader.setWithoutSensor();
  else if (readTriple(text, origin))
    reader.setSensorOrigin(origin.cast<float>());
  else
    throw CLI::ValidationError("--sensor-at",
                               text + " is neither none nor three numbers as 0,0,1.5");
}

} // namespace

void
addScale(CLI::App& app, PointCloudReader& reader)
{
  addSetter(app,
            "--scale",
            reader,
            &PointCloudReader::setScale,
            &PointCloudReader::getScale,
            "Metres in a unit of the input: 0.001 for a file in millimetres",
            "M")
      ->group(input_group);
}

void
addUp(CLI::App& app, PointCloudReader& reader, const std::string& more)
{
  addSetter<std::string>(
      app,
      "--up",
      [&reader](const std::string& text) { reader.setUpDirection(directionOf(text)); },
      "Direction of the input that points up, as z, -y or 0.1,-1,0" + more +
          " [default: found from floors and walls, else assumed and told]",
      "DIRECTION")
      ->group(input_group);
}

void
addReading(CLI::App& app, PointCloudReader& reader)
{
  addScale(app, reader);
  addUp(app, reader);
  addSetter<std::string>(
      app,
      "--sensor-at",
      [&reader](const std::string& text) { stateSensor(reader, text); },
      "Where the one sensor of a cloud was, metres, as 0,0,1.5; none: there was no "
      "single one [default: the file's, or the origin where the points prove it]",
      "X,Y,Z|none")
      ->group(input_group);
}

} // namespace pcl::acmap
