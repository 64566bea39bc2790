#include "core/tape/perceived.h"

#include <cstring>
#include <type_traits>

namespace handmap {

namespace {

class Packer {
 public:
  explicit Packer(std::size_t expected) { bytes_.reserve(expected); }

  template <typename T>
  bool operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof(T));
    return true;
  }
  template <typename T>
  bool operator()(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    (*this)(values.size());
    append(values.data(), values.size() * sizeof(T));
    return true;
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* const from = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), from, from + size);
  }

  std::vector<std::byte> bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <typename T>
  bool operator()(T& value) {
    return take(&value, sizeof(T));
  }
  template <typename T>
  bool operator()(std::vector<T>& values) {
    std::size_t count = 0;
    if (!(*this)(count) || count > bytes_.size() / sizeof(T)) return false;
    values.resize(count);
    return take(values.data(), count * sizeof(T));
  }

 private:
  bool take(void* to, std::size_t size) {
    if (size > bytes_.size()) return false;
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return true;
  }

  std::span<const std::byte> bytes_;
};

/// Everything that a tape keeps, in one order for both ways.
template <typename Each, typename Of>
bool forEach(Each& each, Of& of) {
  auto& observation = of.observation;
  auto& odometry = observation.odometry;
  auto& variance = observation.odometry_variance;
  auto& percept = of.percept;
  return each(observation.frame) && each(observation.time_s) && each(observation.standing) &&
         each(odometry.x) && each(odometry.y) && each(odometry.heading) && each(variance(0, 0)) &&
         each(variance(0, 1)) && each(variance(1, 0)) && each(variance(1, 1)) &&
         each(variance(2, 2)) && each(observation.read_ms) && each(observation.odometry_guessed) &&
         each(observation.blind_s) && each(percept.walls) && each(percept.points) &&
         each(percept.scan.rays) && each(percept.scan.bias_sigma_per_m) && each(percept.joined) &&
         each(percept.ids) && each(percept.moved) && each(percept.scan.ray_by_ray) &&
         each(percept.scan.first_looked_at) && each(percept.stereo_ms) && each(percept.classify_ms);
}

}  // namespace

std::size_t bytesOf(const Perceived& perceived) {
  const Percept& percept = perceived.percept;
  return sizeof(Perceived) + percept.walls.capacity() * sizeof(WallPoint) +
         percept.points.capacity() * sizeof(RangePoint) +
         percept.ids.capacity() * sizeof(std::uint32_t) +
         percept.scan.rays.capacity() * sizeof(Ray) +
         percept.scan.first_looked_at.capacity() * sizeof(float);
}

std::vector<std::byte> packed(const Perceived& perceived) {
  Packer packer(bytesOf(perceived));
  forEach(packer, perceived);
  return packer.take();
}

std::shared_ptr<const Perceived> unpacked(std::span<const std::byte> bytes) {
  auto perceived = std::make_shared<Perceived>();
  Unpacker unpacker(bytes);
  if (!forEach(unpacker, *perceived)) return nullptr;
  return perceived;
}

}  // namespace handmap
