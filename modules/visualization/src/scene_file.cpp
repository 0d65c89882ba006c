#include <pcl/visualization/scene_file.h>

#include <pcl/core/mesh_file.h>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace pcl::acmap {

namespace {

[[noreturn]] void
fail(const std::string& path, const std::string& fault)
{
  throw InputFileException(path + ": " + fault);
}

void
requireFile(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    fail(path, "No such file or directory");
  if (std::filesystem::is_directory(status))
    fail(path, "is a folder, not a file");
  if (!std::filesystem::is_regular_file(status))
    fail(path, "is not a regular file");
  if (std::filesystem::file_size(path, error) == 0)
    fail(path, "is empty");
}

/** \brief A keyword of the format, and the minimum bytes of each item that it
 * counts. */
struct Claim {
  const char* word;
  int bytes;
};

/** \brief Rejects a line that announces more items than its file can contain, because
 * VTK allocates the memory before it reads them. */
void
requireClaimFits(const std::string& path, const std::string& line, double file_size)
{
  // an ASCII number takes at least two characters, a value of point data at least one
  // byte
  constexpr Claim claims[] = {{"POINTS", 6},
                              {"VERTICES", 2},
                              {"LINES", 2},
                              {"POLYGONS", 2},
                              {"TRIANGLE_STRIPS", 2},
                              {"POINT_DATA", 1},
                              {"CELL_DATA", 1}};
  for (const Claim& claim : claims) {
    const std::size_t length = std::strlen(claim.word);
    if (line.compare(0, length, claim.word) != 0)
      continue;
    double counts[] = {0, 0};
    std::sscanf(line.c_str() + length, " %lf %lf", &counts[0], &counts[1]);
    for (const double count : counts)
      if (!(count >= 0 && count * claim.bytes <= file_size + 1))
        fail(path, "claims more " + std::string(claim.word) + " than it can hold");
  }
}

void
requireClaimsFit(const std::string& path)
{
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);)
    requireClaimFits(path, line, size);
}

/** \brief Suppresses the messages of VTK during its lifetime. */
class QuietVtk {
public:
  QuietVtk()
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }

  ~QuietVtk()
  {
    vtkLogger::SetStderrVerbosity(before_);
  }

  QuietVtk(const QuietVtk&) = delete;
  QuietVtk&
  operator=(const QuietVtk&) = delete;

private:
  vtkLogger::Verbosity before_ = vtkLogger::GetCurrentVerbosityCutoff();
};

/** \brief Runs the reader and turns its error messages into an exception. */
void
update(vtkPolyDataReader* reader, const std::string& path)
{
  const QuietVtk quiet;
  bool complained = false;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&complained);
  note->SetCallback([](vtkObject*, unsigned long, void* flag, void*) {
    *static_cast<bool*>(flag) = true;
  });
  reader->AddObserver(vtkCommand::ErrorEvent, note);
  reader->AddObserver(vtkCommand::WarningEvent, note);
  reader->Update();
  reader->RemoveObserver(note);
  if (complained)
    fail(path, "is no legacy VTK file of polygons, or a damaged one");
}

void
takePoints(vtkPolyData* data, PCLPointCloud2& cloud)
{
  const auto* const colors =
      vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetScalars());
  const bool colored = colors && colors->GetNumberOfComponents() >= 3;
  const char* const names[] = {"x", "y", "z", "rgb"};
  const std::uint32_t fields = colored ? 4 : 3;
  for (std::uint32_t i = 0; i < fields; ++i) {
    PCLPointField field;
    field.name = names[i];
    field.offset = i * 4;
    field.datatype = PCLPointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  cloud.width = static_cast<std::uint32_t>(data->GetNumberOfPoints());
  cloud.height = 1;
  cloud.point_step = fields * 4;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize(std::size_t{cloud.point_step} * cloud.width);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    std::uint8_t* const place =
        cloud.data.data() + static_cast<std::size_t>(i) * cloud.point_step;
    const Eigen::Vector3f p = Eigen::Vector3d(data->GetPoint(i)).cast<float>();
    std::memcpy(place, p.data(), sizeof(float) * 3);
    for (int c = 0; colored && c < 3; ++c)
      place[12 + 2 - c] = colors->GetTypedComponent(i, c);
  }
}

/** \brief Are the cells and their point indices valid? */
bool
isSound(vtkCellArray* cells, vtkIdType points)
{
  const vtkIdType corners = cells->GetNumberOfConnectivityIds();
  vtkIdType next = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    const vtkIdType size = cells->GetCellSize(cell);
    if (size < 0 || size > corners - next)
      return false;
    next += size;
  }
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
       iterator->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
      if (ids[i] < 0 || ids[i] >= points)
        return false;
  }
  return true;
}

/** \brief Adds polygons as triangle fans, or triangle strips, in which every second
 * triangle has the opposite orientation. */
void
takeTriangles(vtkCellArray* cells, bool strips, TriangleMesh& mesh)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal();
       iterator->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType i = 2; i < size; ++i) {
      const bool turned = strips && i % 2 != 0;
      mesh.triangles.push_back(
          {static_cast<std::int32_t>(strips ? ids[i - 2] : ids[0]),
           static_cast<std::int32_t>(turned ? ids[i] : ids[i - 1]),
           static_cast<std::int32_t>(turned ? ids[i - 1] : ids[i])});
    }
  }
}

/** \brief Reads a legacy VTK file of polygons.
 * \throws InputFileException */
SceneFile
readVtkMesh(const std::string& path)
{
  requireFile(path);
  requireClaimsFit(path);
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  update(reader, path);
  vtkPolyData* const data = reader->GetOutput();
  if (!data || data->GetNumberOfPoints() == 0)
    fail(path, "has no points");
  SceneFile scene;
  takePoints(data, scene.points.cloud);
  for (const bool strips : {false, true}) {
    vtkCellArray* const cells = strips ? data->GetStrips() : data->GetPolys();
    if (!isSound(cells, data->GetNumberOfPoints()))
      fail(path, "has polygons with corners outside of its points");
    takeTriangles(cells, strips, scene.mesh);
  }
  return scene;
}

} // namespace

} // namespace pcl::acmap

namespace pcl {

SceneFile
loadScene(const std::string& path, const PointCloudReader& reader)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  SceneFile scene;
  if (ending == ".vtk") {
    scene = acmap::readVtkMesh(path);
    reader.apply(scene.points);
    return scene;
  }
  scene.points = reader.read(path);
  if (ending == ".ply" || ending == ".obj")
    scene.mesh = loadTriangleMesh(path);
  return scene;
}

} // namespace pcl
