#include "usb_camera_fixture.h"

#include <pcl/core/random.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

class UsbCameras : public UsbCameraFixture {
protected:
  static std::uint64_t
  guidOf(IidcBus& bus)
  {
    return std::uint64_t{bus.readQuadlet(iidc::config_rom + 12)} << 32 |
           bus.readQuadlet(iidc::config_rom + 16);
  }

  static CameraOptions
  secondCamera()
  {
    CameraOptions options;
    options.identity.guid = 0x00B09D0100ABCDEF;
    options.identity.model = "Second";
    return options;
  }
};

TEST_F(UsbCameras, AreListedWithWhoTheyAre)
{
  const std::vector<UsbCamera> cameras = listUsbCameras();
  ASSERT_EQ(1u, cameras.size());
  EXPECT_EQ(place(), cameras[0].place);
  EXPECT_EQ(0x1E10, cameras[0].vendor);
  EXPECT_EQ(0x2000, cameras[0].product);
  EXPECT_EQ("480 Mb/s", cameras[0].speed);
  EXPECT_EQ("00b09d0100c0ffee", cameras[0].serial);
  EXPECT_EQ("Point Grey Research", cameras[0].maker);
  EXPECT_EQ("Emulated Digiclops", cameras[0].model);
  EXPECT_EQ(CameraFault::None, cameras[0].fault);
  EXPECT_EQ("", cameras[0].message);
}

TEST_F(UsbCameras, AreNotThereWithoutOne)
{
  cable_.unplug();
  EXPECT_TRUE(listUsbCameras().empty());
  EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus(); }));
  EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus("00b09d0100c0ffee"); }));
  EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus("250:127"); }));
}

TEST_F(UsbCameras, OpenByAnyOfTheirNames)
{
  for (const std::string& name : {std::string(),
                                  place(),
                                  std::string("00B09D0100C0FFEE"),
                                  std::string("usb:1e10:2000")}) {
    const auto bus = openUsbBus(name);
    EXPECT_EQ(0x00B09D0100C0FFEEu, guidOf(*bus)) << name;
    EXPECT_EQ("usb " + place(), bus->place());
  }
}

TEST_F(UsbCameras, AreToldApart)
{
  EmulatedIidcCamera camera(imageOf, secondCamera());
  const EmulatedUsbCamera cable(testbed_, camera);
  EXPECT_EQ(2u, listUsbCameras().size());
  const auto first = openUsbBus("00b09d0100c0ffee");
  const auto second = openUsbBus("00b09d0100abcdef");
  EXPECT_EQ(0x00B09D0100C0FFEEu, guidOf(*first));
  EXPECT_EQ(0x00B09D0100ABCDEFu, guidOf(*second));
  EXPECT_EQ("usb 1:" + std::to_string(cable.address()), second->place());
}

TEST_F(UsbCameras, OfAnotherMakerAreOpenedByNameAlone)
{
  cable_.unplug();
  UsbIdentity bridge;
  bridge.vendor = 0x04B4;
  bridge.product = 0x00F1;
  const EmulatedUsbCamera cable(testbed_, camera_, bridge);
  EXPECT_TRUE(listUsbCameras().empty());
  EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus(); }));
  EXPECT_EQ(CameraFault::NotFound, faultOf([] { openUsbBus("usb:4b4:f2"); }));
  EXPECT_EQ(0x00B09D0100C0FFEEu, guidOf(*openUsbBus("usb:4b4:f1")));
}

TEST_F(UsbCameras, HaveNoNonsenseForAName)
{
  for (const char* name : {"first",
                           "1",
                           "1:",
                           ":4",
                           "1:4:",
                           "1:-4",
                           " 1:4",
                           "1:4 ",
                           "1:0x4",
                           "1:1000",
                           "usb:",
                           "usb:1e10",
                           "usb:1e10:",
                           "usb:1e10:g",
                           "usb:1e10:1 ",
                           "usb:11e10:1",
                           "usb::1",
                           "usb:1:2:3",
                           "USB:1e10:1",
                           "00b09d0100c0ffe",
                           "00b09d0100c0ffee0",
                           "00b09d0100c0ffeg"})
    EXPECT_THROW(openUsbBus(name), BadArgumentException) << name;
}

TEST_F(UsbCameras, ThatMayNotBeOpenedAreListedAndNameTheRemedy)
{
  cable_.setPermission(false);
  const std::vector<UsbCamera> cameras = listUsbCameras();
  ASSERT_EQ(1u, cameras.size());
  EXPECT_EQ(place(), cameras[0].place);
  EXPECT_EQ("", cameras[0].serial);
  EXPECT_EQ(CameraFault::PermissionDenied, cameras[0].fault);
  std::string message;
  for (const std::string& name :
       {std::string(), place(), std::string("00b09d0100c0ffee")})
    EXPECT_EQ(CameraFault::PermissionDenied,
              faultOf([&] { openUsbBus(name); }, &message));
  EXPECT_THAT(message, HasSubstr("usb " + place()));
  EXPECT_THAT(message, HasSubstr("70-acmap-digiclops.rules"));
  EXPECT_THAT(message, HasSubstr(cameras[0].message));
}

TEST_F(UsbCameras, ThatMayNotBeOpenedAreLeftOut)
{
  EmulatedIidcCamera camera(imageOf, secondCamera());
  const EmulatedUsbCamera cable(testbed_, camera);
  cable_.setPermission(false);
  EXPECT_EQ(0x00B09D0100ABCDEFu, guidOf(*openUsbBus()));
  EXPECT_EQ(0x00B09D0100ABCDEFu, guidOf(*openUsbBus("00b09d0100abcdef")));
}

TEST_F(UsbCameras, ServeOneProgram)
{
  auto bus = openUsbBus();
  std::string message;
  EXPECT_EQ(CameraFault::Busy, faultOf([&] { openUsbBus(place()); }, &message));
  EXPECT_THAT(message, HasSubstr("usb " + place()));
  EXPECT_EQ(CameraFault::None, listUsbCameras().at(0).fault) << "it can be asked";
  bus.reset();
  EXPECT_NE(nullptr, openUsbBus(place()));
}

TEST_F(UsbCameras, WithoutStreamAreMalformed)
{
  cable_.unplug();
  UsbIdentity identity;
  identity.bulk_endpoint = false;
  const EmulatedUsbCamera cable(testbed_, camera_, identity);
  EXPECT_EQ(CameraFault::Malformed, faultOf([] { openUsbBus(); }));
}

/** Opens a camera with these descriptors; returns the fault, which may be any. */
CameraFault
faultOfDescriptors(UsbTestbed& testbed,
                   EmulatedIidcCamera& camera,
                   const std::vector<std::uint8_t>& descriptors)
{
  UsbIdentity identity;
  identity.descriptors = descriptors;
  const EmulatedUsbCamera cable(testbed, camera, identity);
  return faultOf([] { openUsbBus(); });
}

TEST_F(UsbCameras, MayLieInTheirDescriptors)
{
  cable_.unplug();
  const std::vector<std::uint8_t> honest = descriptorsOf({});
  EXPECT_EQ(CameraFault::None, faultOfDescriptors(testbed_, camera_, honest));

  auto lying = honest; // packet size 0
  lying.at(18 + 9 + 9 + 4) = lying.at(18 + 9 + 9 + 5) = 0;
  EXPECT_EQ(CameraFault::Malformed, faultOfDescriptors(testbed_, camera_, lying));
  lying = honest; // packet size that no bus supports
  lying.at(18 + 9 + 9 + 5) = 0xFF;
  EXPECT_EQ(CameraFault::Malformed, faultOfDescriptors(testbed_, camera_, lying));
  lying = honest; // isochronous endpoint
  lying.at(18 + 9 + 9 + 3) = 1;
  EXPECT_EQ(CameraFault::Malformed, faultOfDescriptors(testbed_, camera_, lying));
  for (std::size_t length = 18; length < honest.size(); ++length) {
    lying.assign(honest.begin(), honest.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_NE(CameraFault::None, faultOfDescriptors(testbed_, camera_, lying))
        << length;
  }
  Random random(3);
  for (int run = 0; run < 100; ++run) {
    lying = honest;
    for (int i = 0; i < 3; ++i) // bytes after the device descriptor, which libusb and
                                // acmap interpret
      lying[18 + random.bits() % (honest.size() - 18)] =
          static_cast<std::uint8_t>(random.bits());
    faultOfDescriptors(testbed_, camera_, lying);
  }
}

TEST_F(UsbCameras, WithAMalformedRomAreListed)
{
  for (const RomFault fault : {RomFault::Cut,
                               RomFault::Zero,
                               RomFault::WrongBus,
                               RomFault::FarUnit,
                               RomFault::FarLeaves,
                               RomFault::HugeLeaf}) {
    camera_.faults().breakRom(fault);
    const std::vector<UsbCamera> cameras = listUsbCameras();
    ASSERT_EQ(1u, cameras.size());
    EXPECT_EQ(CameraFault::Malformed, cameras[0].fault) << static_cast<int>(fault);
    EXPECT_THAT(cameras[0].message, HasSubstr("configuration ROM"));
    EXPECT_EQ(CameraFault::Malformed, faultOf([] { openUsbBus("00b09d0100c0ffee"); }));
  }
}

} // namespace
} // namespace pcl::acmap::test
