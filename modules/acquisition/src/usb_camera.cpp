#include <pcl/acquisition/usb_camera.h>

#include "iidc/config_rom.h"
#include "session/fault_text.h"
#include "usb/usb_camera_name.h"
#include "usb/usb_iidc_bus.h"

#include <optional>

namespace pcl {

namespace {

using namespace acmap;

ConfigRom
readRom(libusb_device_handle& handle, const std::string& place)
{
  UsbRegisters registers(handle, place);
  return readConfigRom([&](std::size_t index) {
    return registers.read(config_rom_address + index * sizeof(std::uint32_t));
  });
}

/** \brief Reads the identity of a camera. */
void
introduce(libusb_device& device, UsbCamera& camera)
{
  try {
    const UsbHandle handle = openUsbDevice(device);
    const ConfigRom rom = readRom(*handle, "usb " + camera.place);
    camera.serial = textOfGuid(rom.guid);
    camera.maker = rom.maker;
    camera.model = rom.model;
  }
  catch (const CameraException& exception) {
    camera.fault = exception.fault();
    camera.message = faultText(exception.what());
  }
}

/** \brief Opens the device as a bus; returns null if it is not the named one. */
std::unique_ptr<IidcBus>
openIfWanted(const UsbContext& context,
             libusb_device& device,
             const std::string& place,
             const UsbCameraName& name)
{
  UsbHandle handle = openUsbDevice(device);
  if (!name.serial.empty() && textOfGuid(readRom(*handle, place).guid) != name.serial)
    return nullptr;
  return std::make_unique<UsbIidcBus>(context, std::move(handle), place);
}

} // namespace

std::vector<UsbCamera>
listUsbCameras()
{
  const UsbContext context = makeUsbContext();
  std::vector<UsbCamera> cameras;
  for (const UsbDevice& device : usbDevices(*context)) {
    UsbCamera camera = describe(*device);
    if (camera.vendor != point_grey)
      continue;
    introduce(*device, camera);
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

std::unique_ptr<IidcBus>
openUsbBus(const std::string& device)
{
  const UsbCameraName name = parseUsbCameraName(device);
  const UsbContext context = makeUsbContext();
  std::optional<CameraException> first_fault;
  for (const UsbDevice& candidate : usbDevices(*context)) {
    const UsbCamera camera = describe(*candidate);
    if (!name.fits(camera))
      continue;
    try {
      if (auto bus = openIfWanted(context, *candidate, "usb " + camera.place, name))
        return bus;
    }
    catch (const CameraException& exception) {
      // A camera that was removed meanwhile counts as not found.
      if (!first_fault && exception.fault() != CameraFault::Unplugged)
        first_fault = exception;
    }
  }
  if (first_fault)
    throw *first_fault;
  throw CameraException(CameraFault::NotFound,
                        device.empty()
                            ? "there is no camera on the USB"
                            : "there is no camera '" + device + "' on the USB");
}

} // namespace pcl
