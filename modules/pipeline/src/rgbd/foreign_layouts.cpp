#include "rgbd/foreign_layouts.h"

#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** \brief A format of files that are recognized but not read. */
struct ForeignFormat {
  const char* ending;
  const char* what;
  const char* advice; ///< a % is the folder
};

constexpr const char* tiff_advice =
    "python3 -c \"import sys, pathlib, numpy, cv2; [cv2.imwrite(str(f.with_suffix("
    "'.png')), cv2.imread(str(f), -1) if cv2.imread(str(f), -1).dtype == numpy.uint16 "
    "else (1000 * numpy.nan_to_num(cv2.imread(str(f), -1))).round().astype('uint16')) "
    "for f in pathlib.Path(sys.argv[1]).glob('*.tif*')]\" % writes PNGs in millimetres "
    "beside them";

/** Depth in metres, as floats. */
constexpr std::array<ForeignFormat, 5> depth_formats = {
    {{".npy",
      "arrays of numpy",
      "python3 -c \"import sys, pathlib, numpy, cv2; [cv2.imwrite(str(f.with_suffix("
      "'.png')), numpy.load(f)) if numpy.load(f).dtype == numpy.uint16 else "
      "cv2.imwrite("
      "str(f.with_suffix('.png')), (1000 * numpy.nan_to_num(numpy.load(f))).round()"
      ".astype('uint16')) for f in pathlib.Path(sys.argv[1]).glob('*.npy')]\" % writes "
      "PNGs in millimetres beside them"},
     {".exr",
      "images of OpenEXR",
      "OPENCV_IO_ENABLE_OPENEXR=1 python3 -c \"import sys, pathlib, numpy, cv2; "
      "[cv2.imwrite(str(f.with_suffix('.png')), (1000 * numpy.nan_to_num(cv2.imread("
      "str(f), -1), posinf=0, neginf=0)).round().astype('uint16')) for f in "
      "pathlib.Path(sys.argv[1]).glob('*.exr')]\" % writes PNGs in millimetres beside "
      "them"},
     {".tif", "TIFF images", tiff_advice},
     {".tiff", "TIFF images", tiff_advice},
     {".depth",
      "depths of Record3D, packed by LZFSE",
      "export the recording from Record3D as 'EXR + JPG sequence', whose depths can be "
      "converted"}}};

/** Recordings in one file, which stands in a folder. */
constexpr std::array<ForeignFormat, 6> recordings = {
    {{".sens",
      "a recording of ScanNet",
      "reader.py of ScanNet's SensReader (--filename FILE.sens --output_path FOLDER "
      "--export_color_images --export_depth_images --export_poses --export_intrinsics) "
      "writes folders that are read"},
     {".r3d",
      "a recording of Record3D",
      "export it from Record3D as 'EXR + JPG sequence', whose depths can be converted"},
     {".mkv",
      "a video, as an Azure Kinect records",
      "azure_kinect_mkv_reader.py of Open3D's reconstruction system (--input FILE.mkv "
      "--output FOLDER) writes folders that are read"},
     {".klg",
      "a log of Kintinuous or ElasticFusion",
      "klg2png or pyklg write its images with TUM's lists"},
     {".oni",
      "a recording of OpenNI",
      "a recorder of OpenNI 2 writes its images, which TUM's lists join"},
     {".bag",
      "a bag of ROS 1 or of a RealSense",
      "rosbags-convert --src FILE.bag --dst FOLDER makes a bag of ROS 2, and "
      "rs-convert "
      "-i FILE.bag -p PREFIX the images of a RealSense"}}};

std::string
filledIn(const std::string& text, const std::string& folder)
{
  std::string filled;
  for (const char letter : text)
    filled += letter == '%' ? folder : std::string(1, letter);
  return filled;
}

template <std::size_t Size>
void
refuseFormats(const std::array<ForeignFormat, Size>& formats, const std::string& folder)
{
  for (const fs::path& entry : folderEntries(folder))
    for (const ForeignFormat& format : formats)
      if (endingOf(entry) == format.ending)
        throw InputFileException(entry.string() + ": " + format.what +
                                 ", recognized but not read; " +
                                 filledIn(format.advice, folder));
}

} // namespace

void
refuseForeignDepths(const std::string& folder)
{
  refuseFormats(depth_formats, folder);
}

void
refuseForeignLayout(const std::string& folder)
{
  refuseFormats(recordings, folder);
  for (const char* name : {"rgbd", "EXR_RGBD/depth"}) {
    std::error_code error;
    if (fs::is_directory(fs::path(folder) / name, error))
      refuseFormats(depth_formats, (fs::path(folder) / name).string());
  }
}

} // namespace pcl::acmap
