#include "plan/plan_text.h"

#include "plan/plan_drawing.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace pcl::acmap {

std::string
fixed(double value, int decimals)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(decimals);
  text << value;
  return text.str();
}

double
readableAngle(const Eigen::Vector2d& along)
{
  const double angle = std::atan2(along.y(), along.x());
  if (angle > 3 * half_turn / 4)
    return angle - half_turn;
  return angle <= -half_turn / 4 ? angle + half_turn : angle;
}

std::string
areaText(double area)
{
  return fixed(area, 1);
}

} // namespace pcl::acmap
