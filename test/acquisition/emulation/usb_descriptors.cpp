#include "usb_descriptors.h"

namespace pcl::acmap::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint8_t
low(unsigned value)
{
  return static_cast<std::uint8_t>(value);
}

std::uint8_t
high(unsigned value)
{
  return static_cast<std::uint8_t>(value >> 8);
}

void
append(Bytes& bytes, const Bytes& more)
{
  for (const std::uint8_t byte : more)
    bytes.push_back(byte);
}

} // namespace

std::vector<std::uint8_t>
descriptorsOf(const UsbIdentity& identity)
{
  if (!identity.descriptors.empty())
    return identity.descriptors;
  const unsigned packet = identity.super_speed ? 1024 : 512;
  Bytes endpoint;
  if (identity.bulk_endpoint) {
    endpoint = {7, 5, 0x81, 2, low(packet), high(packet), 0};
    if (identity.super_speed)
      append(endpoint, {6, 0x30, 15, 0, 0, 0});
  }
  const auto endpoints = static_cast<std::uint8_t>(identity.bulk_endpoint);
  const std::uint8_t release = identity.super_speed ? 3 : 2;
  const std::uint8_t control = identity.super_speed ? 9 : 64;
  Bytes all = {18, 1, 0, release, 0xFF, 0xFF, 0xFF, control};
  append(all, {low(identity.vendor), high(identity.vendor)});
  append(all, {low(identity.product), high(identity.product)});
  append(all, {0, 1, 1, 2, 3, 1});
  const auto total = static_cast<unsigned>(9 + 9 + endpoint.size());
  append(all, {9, 2, low(total), high(total), 1, 1, 0, 0x80, 250});
  append(all, {9, 4, 0, 0, endpoints, 0xFF, 0xFF, 0xFF, 0});
  append(all, endpoint);
  return all;
}

std::vector<std::uint8_t>
stringDescriptor(const UsbIdentity& identity, unsigned number)
{
  if (number == 0)
    return {4, 3, 0x09, 0x04};
  if (number > 3)
    return {};
  const std::string& text = number == 1   ? identity.manufacturer
                            : number == 2 ? identity.name
                                          : identity.serial;
  Bytes descriptor = {low(static_cast<unsigned>(2 + 2 * text.size())), 3};
  for (const char letter : text)
    append(descriptor, {static_cast<std::uint8_t>(letter), 0});
  return descriptor;
}

} // namespace pcl::acmap::test
