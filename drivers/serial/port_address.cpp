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

TcpAddress parseTcp(std::string_view rest, std::string_view whole) {
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos || colon == 0) refuse(whole);
  std::string_view host = rest.substr(0, colon);
  const bool bracketed = host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);
  if (host.empty() || (!bracketed && host.find(':') != std::string_view::npos)) refuse(whole);
  if (host.find_first_of("/@[]") != std::string_view::npos) refuse(whole);
  const std::int64_t port = integerIn(rest.substr(colon + 1), 1, 65535, whole);
  return {std::string(host), static_cast<std::uint16_t>(port)};
}

}  // namespace

PortAddress parsePortAddress(std::string_view text, std::int32_t default_baud) {
  if (text.empty() || text.size() > kLongest || !std::all_of(text.begin(), text.end(), isPlain)) {
    refuse(text);
  }
  if (text.starts_with(kTcp)) return parseTcp(text.substr(kTcp.size()), text);
  if (text.find("://") != std::string_view::npos) refuse(text);
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
