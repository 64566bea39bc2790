// ONNX files for tests, written byte by byte (the protocol buffers of onnx.proto3): one convolution
// of 1×1 from red, green and blue to some classes.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace handmap {

namespace onnx {

inline std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80U; value >>= 7U) bytes += static_cast<char>((value & 0x7FU) | 0x80U);
  return bytes + static_cast<char>(value);
}
inline std::string number(int field, std::uint64_t value) {
  return varint(static_cast<std::uint64_t>(field) << 3U) + varint(value);
}
inline std::string bytes(int field, const std::string& value) {
  return varint((static_cast<std::uint64_t>(field) << 3U) | 2U) + varint(value.size()) + value;
}

inline std::string tensor(const std::string& name, const std::vector<std::uint64_t>& sizes,
                          const std::vector<float>& values) {
  constexpr int kFloat = 1;
  std::string proto;
  for (const std::uint64_t size : sizes) proto += number(1, size);
  std::string raw(values.size() * sizeof(float), '\0');
  std::memcpy(raw.data(), values.data(), raw.size());
  return proto + number(2, kFloat) + bytes(8, name) + bytes(9, raw);
}

/// 1 × channels × any height × any width.
inline std::string images(const std::string& name, std::uint64_t channels) {
  const auto dimension = [](const std::string& what) { return bytes(1, what); };
  const std::string shape = dimension(number(1, 1)) + dimension(number(1, channels)) +
                            dimension(bytes(2, "height")) + dimension(bytes(2, "width"));
  return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

}  // namespace onnx

/// `weights`: one row a class, of red, green, blue; `bias`: one number a class.
inline std::string tinyNetwork(const std::vector<std::vector<float>>& weights,
                               const std::vector<float>& bias) {
  using namespace onnx;
  const std::uint64_t classes = weights.size();
  std::vector<float> flat;
  for (const auto& row : weights) flat.insert(flat.end(), row.begin(), row.end());
  constexpr int kInts = 7;
  const std::string kernel =
      bytes(1, "kernel_shape") + number(8, 1) + number(8, 1) + number(20, kInts);
  const std::string node = bytes(1, "image") + bytes(1, "weights") + bytes(1, "bias") +
                           bytes(2, "classes") + bytes(3, "convolution") + bytes(4, "Conv") +
                           bytes(5, kernel);
  const std::string graph = bytes(1, node) + bytes(2, "tiny") +
                            bytes(5, tensor("weights", {classes, 3, 1, 1}, flat)) +
                            bytes(5, tensor("bias", {classes}, bias)) +
                            bytes(11, images("image", 3)) + bytes(12, images("classes", classes));
  return number(1, 6) + bytes(7, graph) + bytes(8, number(2, 11));
}

/// What is redder than grey is class 2 of three, a building.
inline std::string redIsBuilding() {
  return tinyNetwork({{0.0F, 0.0F, 0.0F}, {0.0F, 8.0F, -8.0F}, {8.0F, -4.0F, -4.0F}},
                     {0.0F, -4.0F, -4.0F});
}

}  // namespace handmap
