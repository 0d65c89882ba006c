#include "reading_options.h"

#include "setter_option.h"

#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

/** Numbers with commas.
 * \return false for other texts */
template <int count>
bool
readNumbers(const std::string& text, Eigen::Matrix<double, count, 1>& values)
{
  std::istringstream numbers(text);
  numbers.imbue(std::locale::classic());
  char comma = ',';
  for (int i = 0; i < count; ++i)
    if ((i > 0 && !(numbers >> comma)) || comma != ',' || !(numbers >> values[i]))
      return false;
  return numbers.peek() == std::istringstream::traits_type::eof() && values.allFinite();
}

/** The parts between commas. */
std::vector<std::string>
wordsOf(const std::string& text)
{
  std::vector<std::string> words;
  std::istringstream parts(text);
  for (std::string word; std::getline(parts, word, ',');)
    words.push_back(word);
  return words;
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
  if (!readNumbers(text, direction) || direction.isZero(0))
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
  else if (readNumbers(text, origin))
    reader.setSensorOrigin(origin);
  else
    throw CLI::ValidationError("--sensor-at",
                               text + " is neither none nor three numbers as 0,0,1.5");
}

void
stateMounting(BagSettings& bag, const std::string& text)
{
  Eigen::Vector3d place;
  Eigen::Matrix<double, 6, 1> pose;
  pose.setZero();
  bag.ignores_poses = text == "none";
  if (bag.ignores_poses)
    return;
  if (readNumbers(text, place))
    pose.head<3>() = place;
  else if (!readNumbers(text, pose))
    throw CLI::ValidationError("--sensor-pose",
                               text + " is neither none nor three or six numbers, as "
                                      "0.1,0,0.3 or 0.1,0,0.3,0,-15,0");
  const Eigen::Vector3d turn = pose.tail<3>() * (M_PI / 180);
  bag.T_robot_sensor = Eigen::Translation3d(pose.head<3>()) *
                       Eigen::AngleAxisd(turn.z(), Eigen::Vector3d::UnitZ()) *
                       Eigen::AngleAxisd(turn.y(), Eigen::Vector3d::UnitY()) *
                       Eigen::AngleAxisd(turn.x(), Eigen::Vector3d::UnitX());
}

} // namespace

CLI::Option*
addSensorPose(CLI::App& app, BagSettings& bag)
{
  return addSetter<std::string>(
      app,
      "--sensor-pose",
      [&bag](const std::string& text) { stateMounting(bag, text); },
      "Where the sensor is on the robot, for a bag whose transforms do not say it: "
      "metres ahead, left and up, then degrees of roll, pitch and yaw (0, looking "
      "ahead, without them); none: the poses of the bag are not taken",
      "X,Y,Z[,R,P,Y]|none");
}

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
  addSetter<std::string>(
      app,
      "--shift",
      [&reader](const std::string& text) {
        Eigen::Vector3d shift;
        if (!readNumbers(text, shift))
          throw CLI::ValidationError("--shift",
                                     text + " is no three numbers as 665000,5648000,0");
        reader.setShift(shift);
      },
      "Metres to subtract from all coordinates, as 665000,5648000,0 [default: whole "
      "kilometres where the points are beyond 10 km]",
      "X,Y,Z")
      ->group(input_group);
  addSetter<std::string>(
      app,
      "--columns",
      [&reader](const std::string& text) { reader.setColumns(wordsOf(text)); },
      "What the columns of a text are, as x,y,z,-,red,green,blue; - leaves one out "
      "[default: by their names, else by their numbers]",
      "NAMES")
      ->group(input_group);
  addUp(app, reader);
  addSetter<std::string>(
      app,
      "--sensor-at",
      [&reader](const std::string& text) { stateSensor(reader, text); },
      "Where the one sensor of a cloud was, metres, in the coordinates of the file, as "
      "0,0,1.5; none: there was no "
      "single one [default: the file's, or the origin where the points prove it]",
      "X,Y,Z|none")
      ->group(input_group);
}

} // namespace pcl::acmap
