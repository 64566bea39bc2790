// Where a device is connected, as a person writes it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace handmap {

struct SerialAddress {
  std::string path;
  std::int32_t baud = 0;
  bool operator==(const SerialAddress&) const = default;
};

struct TcpAddress {
  std::string host;
  std::uint16_t port = 0;
  bool operator==(const TcpAddress&) const = default;
};

using PortAddress = std::variant<SerialAddress, TcpAddress>;

/// "/dev/ttyUSB0", "/dev/ttyUSB0@9600" (8N1), "tcp://host:port" or "tcp://[::1]:port". Throws
/// BadInput.
PortAddress parsePortAddress(std::string_view text, std::int32_t default_baud);

/// As parsePortAddress() reads it.
std::string formatPortAddress(const PortAddress& address);

}  // namespace handmap
