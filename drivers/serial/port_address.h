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

/// "/dev/ttyUSB0", "/dev/ttyUSB0@9600" (8N1), "tcp://host:port" or "tcp://[::1]:port"; what looks
/// like an address of the network, as 192.168.0.10, is one also without "tcp://". `default_port`:
/// where none is said; 0: one has to be. Throws BadInput.
PortAddress parsePortAddress(std::string_view text, std::int32_t default_baud,
                             std::uint16_t default_port = 0);

/// As parsePortAddress() reads it.
std::string formatPortAddress(const PortAddress& address);

}  // namespace handmap
