#include "drivers/serial/port_address.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"

namespace handmap {

namespace {

constexpr std::string_view kTcp = "tcp://";
constexpr std::size_t kLongest = 300;
constexpr std::int64_t kSlowest = 300;  // baud
constexpr std::int64_t kFastest = 12'000'000;

[[noreturn]] void refuse(std::string_view text) {
  throwBadInput(phrase("port"), "", fmt::format("\"{}\"", text.substr(0, kLongest)),
                phrase("a device as in /dev/ttyUSB0@9600, or tcp://host:port"));
}

std::int64_t integerIn(std::string_view text, std::int64_t low, std::int64_t high,
                       std::string_view whole) {
  const std::optional<std::int64_t> value = parseInteger(text);
  if (!value || *value < low || *value > high) refuse(whole);
  return *value;
}

bool isPlain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte > 0x20 && byte != 0x7f;
}

/// 192.168.0.10, robot.local, host:10940, [::1]: no file is called so.
bool isOfNetwork(std::string_view text) {
  if (text.find_first_of("/@") != std::string_view::npos) return false;
  return text.find_first_of(".:") != std::string_view::npos;
}

TcpAddress parseTcp(std::string_view rest, std::string_view whole, std::uint16_t default_port) {
  const bool bracketed = rest.starts_with('[');
  const std::size_t end = bracketed ? rest.find(']') : rest.rfind(':');
  std::size_t colon = end;
  if (bracketed) colon = end == std::string_view::npos ? end : rest.find(':', end);
  std::string_view host = rest.substr(0, std::min(colon, rest.size()));
  if (bracketed) {
    if (!host.ends_with(']')) refuse(whole);
    host = host.substr(1, host.size() - 2);
  }
  if (host.empty() || (!bracketed && host.find(':') != std::string_view::npos)) refuse(whole);
  if (host.find_first_of("/@[]") != std::string_view::npos) refuse(whole);
  if (colon == std::string_view::npos) {
    if (default_port == 0) refuse(whole);
    return {std::string(host), default_port};
  }
  const std::int64_t port = integerIn(rest.substr(colon + 1), 1, 65535, whole);
  return {std::string(host), static_cast<std::uint16_t>(port)};
}

}  // namespace

PortAddress parsePortAddress(std::string_view text, std::int32_t default_baud,
                             std::uint16_t default_port) {
  if (text.empty() || text.size() > kLongest || !std::all_of(text.begin(), text.end(), isPlain)) {
    refuse(text);
  }
  if (text.starts_with(kTcp)) return parseTcp(text.substr(kTcp.size()), text, default_port);
  if (text.find("://") != std::string_view::npos) refuse(text);
  if (isOfNetwork(text)) return parseTcp(text, text, default_port);
  const std::size_t at = text.rfind('@');
  if (at == 0) refuse(text);
  SerialAddress serial{std::string(text.substr(0, at)), default_baud};
  if (at != std::string_view::npos) {
    serial.baud =
        static_cast<std::int32_t>(integerIn(text.substr(at + 1), kSlowest, kFastest, text));
  }
  return serial;
}

std::string formatPortAddress(const PortAddress& address) {
  if (const auto* serial = std::get_if<SerialAddress>(&address)) {
    return fmt::format("{}@{}", serial->path, serial->baud);
  }
  const auto& tcp = std::get<TcpAddress>(address);
  if (tcp.host.find(':') == std::string::npos)
    return fmt::format("tcp://{}:{}", tcp.host, tcp.port);
  return fmt::format("tcp://[{}]:{}", tcp.host, tcp.port);
}

}  // namespace handmap
