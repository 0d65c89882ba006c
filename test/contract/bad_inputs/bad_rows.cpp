#include "bad_clouds.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/point_types.h>

#include <limits>

namespace pcl::acmap::test {

namespace {

using Rows = PCLPointCloud2;
using RowChange = std::function<void(Rows&)>;

struct NamedRowChange {
  std::string name;
  Answer answer;
  RowChange change;
};

PCLPointField&
fieldOf(Rows& rows, const std::string& name)
{
  for (PCLPointField& field : rows.fields)
    if (field.name == name)
      return field;
  return rows.fields.front();
}

/** \brief Changes a field: its place, type and number of values. */
RowChange
placed(const std::string& name, std::uint32_t offset)
{
  return [=](Rows& rows) { fieldOf(rows, name).offset = offset; };
}

RowChange
typed(const std::string& name, std::uint8_t type, std::uint32_t count = 1)
{
  return [=](Rows& rows) {
    fieldOf(rows, name).datatype = type;
    fieldOf(rows, name).count = count;
  };
}

RowChange
renamed(const std::string& name, const std::string& other)
{
  return [=](Rows& rows) { fieldOf(rows, name).name = other; };
}

RowChange
observedBy(std::int32_t view)
{
  return [=](Rows& rows) {
    const std::size_t offset = fieldOf(rows, "view").offset;
    for (std::size_t i = 0; i < rows.data.size() / rows.point_step; ++i)
      setValue(rows, i, offset, view);
  };
}

/** What contradicts the bytes. */
std::vector<NamedRowChange>
layoutChanges()
{
  using Field = PCLPointField;
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  return {
      {"with a byte less", Answer::Refused, [](Rows& r) { r.data.pop_back(); }},
      {"without bytes", Answer::Refused, [](Rows& r) { r.data.clear(); }},
      {"of a step of 0", Answer::Refused, [](Rows& r) { r.point_step = 0; }},
      {"of a step of 4", Answer::Refused, [](Rows& r) { r.point_step = 4; }},
      {"of a larger step", Answer::Refused, [](Rows& r) { r.point_step *= 2; }},
      {"of the largest step", Answer::Refused, [](Rows& r) { r.point_step = most; }},
      {"of rows of 0 bytes", Answer::Any, [](Rows& r) { r.row_step = 0; }},
      {"of shorter rows", Answer::Refused, [](Rows& r) { r.row_step -= 4; }},
      {"of longer rows", Answer::Refused, [](Rows& r) { r.row_step += 16; }},
      {"of the longest rows", Answer::Refused, [](Rows& r) { r.row_step = most; }},
      {"with colour outside", Answer::Refused, placed("rgb", 48)},
      {"with a view outside", Answer::Refused, placed("view", 4000)},
      {"with a normal of float64", Answer::Any, typed("normal_y", Field::FLOAT64)},
      {"with colour of count 2^31",
       Answer::Refused,
       typed("rgb", Field::FLOAT32, 1U << 31U)},
      {"with curvature of count 0", Answer::Any, typed("curvature", Field::FLOAT32, 0)},
      {"of big-endian bytes", Answer::Refused, [](Rows& r) { r.is_bigendian = 1; }},
      {"seen by view 3", Answer::Any, observedBy(3)},
      {"seen by view -7", Answer::Any, observedBy(-7)},
      {"seen by view 2^31 - 1",
       Answer::Any,
       observedBy(std::numeric_limits<std::int32_t>::max())}};
}

/** What coordinates need. */
std::vector<NamedRowChange>
coordinateChanges()
{
  using Field = PCLPointField;
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  return {
      {"with a normal outside", Answer::Refused, placed("normal_x", most - 1)},

      {"with overlapping fields", Answer::Refused, placed("y", 0)},
      {"with y apart", Answer::Refused, placed("y", 12)},
      {"with x at the end", Answer::Refused, placed("x", 48)},
      {"with x far outside", Answer::Refused, placed("x", most - 3)},
      {"with z outside", Answer::Refused, placed("z", most)},
      {"with x of float64", Answer::Refused, typed("x", Field::FLOAT64)},
      {"with x of uint8", Answer::Refused, typed("x", Field::UINT8)},
      {"with x of no type", Answer::Refused, typed("x", 99)},
      {"with x of type 0", Answer::Refused, typed("x", 0)},
      {"with x of count 0", Answer::Refused, typed("x", Field::FLOAT32, 0)},
      {"with x of count 2^31", Answer::Refused, typed("x", Field::FLOAT32, 1U << 31U)},
      {"without x", Answer::Refused, renamed("x", "a")},
      {"without y and z",
       Answer::Refused,
       [](Rows& r) {
         renamed("y", "b")(r);
         renamed("z", "c")(r);
       }},
      {"with two fields x", Answer::Any, renamed("curvature", "x")},
      {"with a field without name", Answer::Any, renamed("curvature", "")},
      {"without fields", Answer::Refused, [](Rows& r) { r.fields.clear(); }}};
}

} // namespace

Rows::Ptr
asRows(const Cloud::ConstPtr& cloud)
{
  if (!cloud)
    return nullptr;
  const auto colored = as<PointXYZRGBNormalView>(cloud);
  colored->width = static_cast<std::uint32_t>(colored->size());
  colored->height = 1;
  const auto rows = std::make_shared<Rows>();
  toPCLPointCloud2(*colored, *rows);
  if (cloud->width != 0 || cloud->height != 0) {
    rows->width = cloud->width;
    rows->height = cloud->height;
    rows->row_step = rows->width * rows->point_step;
  }
  return rows;
}

namespace {

Kinds<Rows::Ptr>
changedRows(const std::vector<NamedRowChange>& changes)
{
  Kinds<Rows::Ptr> kinds;
  for (const NamedRowChange& change : changes)
    kinds.push_back({"rows " + change.name, change.answer, [=] {
                       const Rows::Ptr rows = asRows(goodView().makeShared());
                       change.change(*rows);
                       return rows;
                     }});
  return kinds;
}

} // namespace

const Kinds<Rows::Ptr>&
badLayouts()
{
  static const Kinds<Rows::Ptr> kinds = changedRows(layoutChanges());
  return kinds;
}

const Kinds<Rows::Ptr>&
badRows()
{
  static const Kinds<Rows::Ptr> kinds = [] {
    Kinds<Rows::Ptr> made = badLayouts();
    for (const Kind<Cloud::Ptr>& kind : badClouds())
      made.push_back({kind.name, kind.answer, [=] { return asRows(kind.make()); }});
    const Kinds<Rows::Ptr> others = changedRows(coordinateChanges());
    made.insert(made.end(), others.begin(), others.end());
    return made;
  }();
  return kinds;
}

} // namespace pcl::acmap::test
