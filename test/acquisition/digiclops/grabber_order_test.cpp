#include "frame_bytes.h"
#include "grabber_fixture.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/simulated_rig_grabber.h>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr ChannelOrder default_order{
    RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
constexpr ChannelOrder other_order{
    RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal};

/** A grey frame of a wall with a box in front of it, under a pattern. */
TrinocularFrame
makeFilm()
{
  constexpr SurfaceLook look{{168, 166, 160}, 2.0};
  SimulatedScene scene;
  scene.geometry.addRectangle(
      "wall", "wall", {{-8, 4, 3}, {16, 0, 4}, {0, -8, 0}}, look);
  scene.geometry.addBox("box", {-0.25, -0.25, 1.5}, {0.25, 0.25, 2.0}, look);
  scene.views = {Eigen::Isometry3d::Identity()};
  SimulatedRigGrabber simulation(scene, {RandomLinePattern().generate(3)});
  simulation.setNumberOfThreads(1); // ThreadSanitizer does not understand TBB's threads
  TrinocularFrame frame = *simulation.observe(0).back();
  for (CameraImage& image : frame.images) {
    CameraImage grey{image.width, image.height, 1, {}};
    for (std::size_t i = 1; i < image.values.size(); i += 3)
      grey.values.push_back(image.values[i]);
    image = grey;
  }
  return frame;
}

const TrinocularFrame&
film()
{
  static const TrinocularFrame made = makeFilm();
  return made;
}

/** A camera that observes the wall and sends its channels in a given order. */
class GrabberOrder : public testing::Test {
protected:
  void
  expectFilm(const TrinocularFrame& frame) const
  {
    for (const RigCamera camera : default_order) {
      // The frame counter overwrites four bytes in the upper left corner.
      CameraImage image = frame.image(camera);
      CameraImage want = film_.image(camera);
      std::fill_n(image.values.begin(), 2, 0);
      std::fill_n(want.values.begin(), 2, 0);
      EXPECT_TRUE(image == want) << nameOf(camera);
    }
  }

  const TrinocularFrame& film_ = film();
  ChannelOrder order_ = default_order;
  EmulatedIidcCamera emulated_{
      [this](const Exposure&) { return interleaved(film_, order_); }};
  UsbTestbed testbed_;
  EmulatedUsbCamera cable_{testbed_, emulated_};
};

TEST_F(GrabberOrder, IsFound)
{
  order_ = other_order;
  DigiclopsGrabber grabber(rigWith(true, true));
  EXPECT_EQ(grabber.getChannelOrder(), default_order);
  GrabberLog log(grabber);
  grabber.start();
  EXPECT_TRUE(log.awaitFrames(4));
  grabber.stop();
  for (const TrinocularFrame::ConstPtr& frame : log.frames())
    expectFilm(*frame);
  EXPECT_EQ(grabber.getChannelOrder(), other_order);
  const DigiclopsGrabberReport report = grabber.getReport();
  ASSERT_TRUE(report.order);
  EXPECT_TRUE(report.order->is_certain);
  EXPECT_THAT(report.remarks, ElementsAre(HasSubstr(textOf(other_order))));
}

TEST_F(GrabberOrder, ThatIsRightStays)
{
  DigiclopsGrabber grabber(rigWith(true, true));
  GrabberLog log(grabber);
  grabber.start();
  EXPECT_TRUE(log.awaitFrames(2));
  grabber.stop();
  expectFilm(*log.frames().front());
  EXPECT_EQ(grabber.getChannelOrder(), default_order);
  EXPECT_TRUE(grabber.getReport().order->is_certain);
  EXPECT_THAT(grabber.getReport().remarks, IsEmpty());
}

TEST_F(GrabberOrder, ThatWasSetIsDoubtedNotReplaced)
{
  DigiclopsGrabber grabber(rigWith(true, true));
  grabber.setChannelOrder(other_order);
  GrabberLog log(grabber);
  grabber.start();
  EXPECT_TRUE(log.awaitFrames(4));
  grabber.stop();
  EXPECT_EQ(grabber.getChannelOrder(), other_order);
  EXPECT_THAT(grabber.getReport().remarks, ElementsAre(HasSubstr("as was set")));
}

} // namespace
} // namespace pcl::acmap::test
