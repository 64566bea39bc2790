#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/logs/array.h"

namespace handmap {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kMostValues = 64u << 20;
constexpr std::size_t kMostDimensions = 4;

struct NpyHeader {
  char order = '<';
  char kind = 'f';
  std::size_t bytes = 8;
  bool columns_first = false;
  std::vector<std::size_t> shape;
  std::size_t size = 0;  ///< of the header, bytes
};

/// What stands behind "'key':" in the header, up to `end`.
std::string_view valueOf(std::string_view header, std::string_view key, char end,
                         const std::string& source) {
  const std::size_t at = header.find(key);
  const std::size_t colon = at == std::string_view::npos ? at : header.find(':', at);
  const std::size_t stop = colon == std::string_view::npos ? colon : header.find(end, colon);
  if (stop == std::string_view::npos) {
    throwBadInput(source, phrase("header"), phrase("no {}", key), phrase("an array of numpy"));
  }
  return trimmed(header.substr(colon + 1, stop - colon - 1));
}

void parseType(std::string_view text, NpyHeader& header, const std::string& source) {
  const auto fail = [&] {
    throwBadInput(source, "descr", std::string(text.substr(0, 40)),
                  phrase("real or whole numbers: f4 f8 i1 to i8 u1 to u8 b1"));
  };
  if (text.size() != 5) fail();  // '<f4' in its quotes
  header.order = text[1];
  header.kind = text[2];
  header.bytes = static_cast<std::size_t>(text[3] - '0');
  const std::string_view kinds = header.bytes == 8 || header.bytes == 4 ? "fiu"
                                 : header.bytes == 2                    ? "iu"
                                 : header.bytes == 1                    ? "iub"
                                                                        : "";
  if (kinds.find(header.kind) == std::string_view::npos) fail();
  if (std::string_view("<>|=").find(header.order) == std::string_view::npos) fail();
}

NpyHeader parseHeader(std::string_view content, const std::string& source) {
  if (content.size() < 12 || !content.starts_with(kMagic)) {
    throwBadInput(source, "", phrase("no array"), phrase("a .npy of numpy"));
  }
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(content[i]));
  };
  const bool is_long = byte(6) >= 2;
  const std::size_t begin = is_long ? 12 : 10;
  const std::size_t length =
      byte(8) | byte(9) << 8U | (is_long ? byte(10) << 16U | byte(11) << 24U : 0U);
  if (length > content.size() - begin) {
    throwBadInput(source, "", phrase("{} bytes", content.size()), phrase("a whole header"));
  }
  const std::string_view text = content.substr(begin, length);
  NpyHeader header;
  header.size = begin + length;
  parseType(valueOf(text, "'descr'", ',', source), header, source);
  header.columns_first = valueOf(text, "'fortran_order'", ',', source) == "True";
  std::string_view shape = valueOf(text, "'shape'", ')', source);
  if (!shape.empty()) shape.remove_prefix(1);
  for (const std::string_view field : splitFields(shape, ',')) {
    if (field.empty()) continue;
    const auto extent = parseInteger(field);
    if (!extent || *extent < 0 || header.shape.size() == kMostDimensions) {
      throwBadInput(source, "shape", std::string(shape.substr(0, 60)),
                    phrase("at most {} extents", kMostDimensions));
    }
    header.shape.push_back(static_cast<std::size_t>(*extent));
  }
  return header;
}

template <typename Number>
double numberAt(const char* bytes, bool swapped) {
  std::array<char, sizeof(Number)> own{};
  std::memcpy(own.data(), bytes, sizeof(Number));
  if (swapped) std::reverse(own.begin(), own.end());
  return static_cast<double>(std::bit_cast<Number>(own));
}

double valueAt(const char* bytes, const NpyHeader& header) {
  const bool swapped = header.order == '>';
  const bool is_signed = header.kind == 'i';
  if (header.kind == 'f') {
    return header.bytes == 8 ? numberAt<double>(bytes, swapped) : numberAt<float>(bytes, swapped);
  }
  switch (header.bytes) {
    case 1:
      return is_signed ? numberAt<std::int8_t>(bytes, false) : numberAt<std::uint8_t>(bytes, false);
    case 2:
      return is_signed ? numberAt<std::int16_t>(bytes, swapped)
                       : numberAt<std::uint16_t>(bytes, swapped);
    case 4:
      return is_signed ? numberAt<std::int32_t>(bytes, swapped)
                       : numberAt<std::uint32_t>(bytes, swapped);
    default:
      return is_signed ? numberAt<std::int64_t>(bytes, swapped)
                       : numberAt<std::uint64_t>(bytes, swapped);
  }
}

/// Where the value stands in a file that runs through the first index the fastest.
std::size_t placeByColumns(std::size_t index, const std::vector<std::size_t>& shape) {
  std::size_t place = 0;
  std::size_t stride = 1;
  for (const std::size_t extent : shape) stride *= extent;
  for (std::size_t d = shape.size(); d-- > 0;) {
    stride /= shape[d];
    place += (index % shape[d]) * stride;
    index /= shape[d];
  }
  return place;
}

}  // namespace

Array parseNpy(std::string_view content, const std::string& source) {
  const NpyHeader header = parseHeader(content, source);
  std::size_t count = 1;
  for (const std::size_t extent : header.shape) {
    if (extent != 0 && count > kMostValues / extent) {
      throwBadInput(source, "shape", phrase("more values"), phrase("at most {}", kMostValues));
    }
    count *= extent;
  }
  if (content.size() - header.size < count * header.bytes) {
    throwBadInput(source, "", phrase("{} bytes", content.size()),
                  phrase("{} values of {} bytes", count, header.bytes));
  }
  Array array{header.shape, std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = header.columns_first ? placeByColumns(i, header.shape) : i;
    array.values[i] = valueAt(content.data() + header.size + at * header.bytes, header);
  }
  return array;
}

}  // namespace handmap
