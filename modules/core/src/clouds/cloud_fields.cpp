
#include <pcl/common/io.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/input_check.h>

#include <algorithm>
#include <set>

namespace pcl::acmap {

const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name)
{
  const auto found =
      std::find_if(cloud.fields.begin(),
                   cloud.fields.end(),
                   [&](const PCLPointField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

const PCLPointField*
findField(const PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype)
{
  const PCLPointField* field = findField(cloud, name);
  return field && field->datatype == datatype && field->count == 1 ? field : nullptr;
}

const PCLPointField*
findColor(const PCLPointCloud2& cloud)
{
  for (const char* name : {"rgb", "rgba"}) {
    const PCLPointField* field = findField(cloud, name);
    if (field && field->count == 1 && getFieldSize(field->datatype) == 4)
      return field;
  }
  return nullptr;
}

PCLPointCloud2
layoutWith(const PCLPointCloud2& cloud, const std::vector<FieldWish>& wishes)
{
  PCLPointCloud2 layout;
  layout.header = cloud.header;
  layout.fields = cloud.fields;
  layout.point_step = cloud.point_step;
  layout.is_dense = cloud.is_dense;
  for (const FieldWish& wish : wishes) {
    if (findField(layout, wish.name, wish.datatype))
      continue;
    layout.fields.erase(std::remove_if(layout.fields.begin(),
                                       layout.fields.end(),
                                       [&](const PCLPointField& field) {
                                         return field.name == wish.name;
                                       }),
                        layout.fields.end());
    PCLPointField added;
    added.name = wish.name;
    added.offset = layout.point_step;
    added.datatype = wish.datatype;
    added.count = 1;
    layout.fields.push_back(added);
    layout.point_step += static_cast<uindex_t>(getFieldSize(wish.datatype));
  }
  return layout;
}

PCLPointCloud2
withFields(PCLPointCloud2 cloud, const std::vector<FieldWish>& wishes)
{
  PCLPointCloud2 wider = layoutWith(cloud, wishes);
  if (wider.point_step == cloud.point_step)
    return cloud;
  const std::size_t rows = rowsOf(cloud);
  resizeRows(wider, rows);
  wider.width = cloud.width;
  wider.height = cloud.height;
  wider.row_step = wider.width * wider.point_step;
  for (std::size_t row = 0; row < rows; ++row)
    std::memcpy(&wider.data[row * wider.point_step],
                &cloud.data[row * cloud.point_step],
                cloud.point_step);
  return wider;
}

void
dropUnwritableFields(PCLPointCloud2& cloud)
{
  std::set<std::string> names;
  std::vector<PCLPointField> kept;
  for (const PCLPointField& field : cloud.fields) {
    const bool is_word = !field.name.empty() &&
                         std::all_of(field.name.begin(), field.name.end(), [](char c) {
                           return c > ' ' && c < 127;
                         });
    if (is_word && names.insert(field.name).second)
      kept.push_back(field);
  }
  cloud.fields = std::move(kept);
}

void
resizeRows(PCLPointCloud2& cloud, std::size_t rows)
{
  cloud.height = 1;
  cloud.width = static_cast<uindex_t>(rows);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(rows * cloud.point_step);
}

namespace {

/** Three float32 fields side by side. \return the first one, or nullptr */
const PCLPointField*
findTriple(const PCLPointCloud2& cloud, const std::array<const char*, 3>& names)
{
  std::array<const PCLPointField*, 3> fields{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fields[axis] = findField(cloud, names[axis], PCLPointField::FLOAT32);
    if (!fields[axis] || fields[axis]->offset != fields[0]->offset + 4 * axis)
      return nullptr;
  }
  return fields[0];
}

constexpr bool is_native_big = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/** \throws InitFailedException if a field is outside of its point, there are fewer or more
 * bytes than points, rows have other bytes than their points, or values another order of
 * bytes */
void
requireBytes(const CloudRows& rows)
{
  const PCLPointCloud2& cloud = rows.layout();
  for (const PCLPointField& field : cloud.fields)
    if (std::size_t{field.offset} +
            std::size_t{std::max(field.count, 1U)} * getFieldSize(field.datatype) >
        cloud.point_step)
      throw acmap::InitFailed("field ", field.name, " is outside of its point");
  requireShape(cloud.width,
               cloud.height,
               rows.bytes() / std::max<std::size_t>(cloud.point_step, 1));
  const std::size_t row = std::size_t{cloud.width} * cloud.point_step;
  if (cloud.height > 1 && cloud.row_step != 0 && cloud.row_step != row)
    throw acmap::InitFailed(
        "the rows of the cloud have ", cloud.row_step, " bytes, their points ", row);
  if (rows.size() > 0 && (cloud.is_bigendian != 0) != is_native_big)
    throw acmap::InitFailed("the values of the cloud have their bytes in another order "
                            "than those of this machine");
}

} // namespace

PointView
requirePoints(const CloudRows& rows, const Indices* indices)
{
  requireGiven(rows);
  const PCLPointCloud2& cloud = rows.layout();
  const PCLPointField* const x = findTriple(cloud, {"x", "y", "z"});
  if (!x)
    throw acmap::InitFailed("the cloud has no float32 fields x, y, z side by side");
  requireBytes(rows);
  if (!indices)
    return {rows.size() ? rows.data() + x->offset : nullptr,
            cloud.point_step,
            rows.size(),
            rows.shares().get()};
  requireIndices(*indices, rows.size());
  return {rows.data() + x->offset, cloud.point_step, indices->size(), indices->data()};
}

PointView
normalsOf(const CloudRows& rows)
{
  const PCLPointField* const x =
      rows.size() > 0 ? findTriple(rows.layout(), normal_field_names) : nullptr;
  if (!x)
    return {};
  requireBytes(rows);
  return {rows.data() + x->offset, rows.layout().point_step, rows.size()};
}

SensorView
sensorsOf(const CloudRows& cloud,
          const std::vector<Eigen::Vector3f>& viewpoints,
          const std::optional<Eigen::Vector3f>& origin,
          const Indices* indices)
{
  const PCLPointField* const view =
      findField(cloud.layout(), "view", PCLPointField::INT32);
  if (view && cloud.bytes() > 0)
    return SensorView(cloud.data() + view->offset,
                      cloud.layout().point_step,
                      viewpoints,
                      indices ? indices->data() : nullptr);
  return origin ? SensorView(*origin) : SensorView();
}

ColorView
colorsOf(const CloudRows& cloud)
{
  const PCLPointField* const color = findColor(cloud.layout());
  if (!color || cloud.bytes() == 0)
    return {};
  return {cloud.data() + color->offset, cloud.layout().point_step};
}

} // namespace pcl::acmap
