#include "measuring.h"

#include "map_actors.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/plane_distance.h>

#include <vtkBillboardTextActor3D.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <cstdio>

namespace pcl::acmap {

namespace {

constexpr Color measured_color = {0.761, 0.094, 0.357};

std::string
metresText(double metres)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m", metres);
  return text;
}

/** \brief "3.412 m ± 4.2 mm", of two standard deviations. */
std::string
describeDistance(const PlaneDistance& distance)
{
  std::string text = metresText(distance.distance);
  if (!std::isfinite(distance.deviation))
    return text;
  char more[48];
  std::snprintf(more,
                sizeof more,
                " \u00b1 %s%.1f mm",
                distance.is_at_least ? "at least " : "",
                2000 * distance.deviation);
  return text + more;
}

/** \brief The parts of a distance that are level and upright. */
std::string
describeParts(const Eigen::Vector3d& way, const Eigen::Vector3d& up)
{
  constexpr double nothing = 0.0005; // metres
  const double upright = std::abs(way.dot(up));
  const double level = (way - way.dot(up) * up).norm();
  if (upright < nothing)
    return "level";
  if (level < nothing)
    return "upright";
  return "level " + metresText(level) + ", upright " + metresText(upright);
}

} // namespace

Measuring::Measuring(LayerStage& stage, const CompactMap& map)
: stage_(stage)
, map_(map)
{}

void
Measuring::measureNext()
{
  const bool has_planes = map_.planes.size() > 1;
  between_ = between_ == Between::Nothing                ? Between::Points
             : between_ == Between::Points && has_planes ? Between::Planes
                                                         : Between::Nothing;
  clear();
}

void
Measuring::pick(double column, double row)
{
  const bool snaps = between_ == Between::Points;
  const auto place = stage_.placeAt(column, row, snaps);
  if (!place || (!snaps && (!place->surface || *place->surface >= map_.planes.size())))
    return;
  if (picks_.size() == 2)
    clear();
  picks_.push_back(*place);
  if (picks_.size() == 2)
    finish();
}

std::string
Measuring::told() const
{
  if (!result_.empty() || between_ == Between::Nothing)
    return result_;
  const std::string what = between_ == Between::Points ? "point" : "plane";
  return "measure between " + what + "s: click on a " +
         (picks_.empty() ? "" : "second ") + what +
         "   m: " + (between_ == Between::Points ? "between planes" : "end");
}

void
Measuring::clear()
{
  for (const auto& prop : drawn_)
    stage_.renderer()->RemoveViewProp(prop);
  drawn_.clear();
  picks_.clear();
  result_.clear();
}

void
Measuring::finish()
{
  const Eigen::Vector3d from = picks_[0].point, to = picks_[1].point;
  if (between_ == Between::Points) {
    const std::string length = metresText((to - from).norm());
    result_ = length + " (" + describeParts(to - from, stage_.up()) + ")";
    draw(from, to, length);
    return;
  }
  try {
    const std::size_t other = *picks_[1].surface;
    const PlaneDistance distance = distanceBetween(map_, *picks_[0].surface, other);
    const Eigen::Vector4d& plane = map_.planes[other].coefficients;
    const double height = plane.dot(distance.place.homogeneous());
    result_ = describeDistance(distance);
    draw(distance.place, distance.place - height * plane.head<3>(), result_);
  }
  catch (const PCLException& e) {
    result_ = e.what();
  }
}

void
Measuring::draw(const Eigen::Vector3d& from,
                const Eigen::Vector3d& to,
                const std::string& text)
{
  constexpr double pixels = 3;
  constexpr int font_size = 18;
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(text.c_str());
  label->SetPosition(Eigen::Vector3d((from + to) / 2).data());
  label->GetTextProperty()->SetFontSize(font_size);
  label->GetTextProperty()->SetBold(1);
  label->GetTextProperty()->SetColor(1, 1, 1);
  label->GetTextProperty()->SetBackgroundColor(
      measured_color[0], measured_color[1], measured_color[2]);
  label->GetTextProperty()->SetBackgroundOpacity(1);
  drawn_ = {actorOfLines(
                {{0, {from.cast<float>(), to.cast<float>()}}}, measured_color, pixels),
            label.Get()};
  for (const auto& prop : drawn_)
    stage_.renderer()->AddViewProp(prop);
}

} // namespace pcl::acmap
