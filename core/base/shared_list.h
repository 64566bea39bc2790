// Lists whose versions share what they have in common: a version costs a pointer a chunk, and what
// has changed since the one before.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace handmap {

/// One version: never changes.
template <typename T>
class SharedList {
 public:
  static constexpr std::size_t kChunk = 64;
  using Chunk = std::vector<T>;

  SharedList() = default;
  SharedList(std::vector<std::shared_ptr<const Chunk>> chunks, std::size_t size)
      : chunks_(std::move(chunks)), size_(size) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return (*chunks_[i / kChunk])[i % kChunk]; }
  const T& back() const { return (*this)[size_ - 1]; }
  std::vector<T> all() const {
    std::vector<T> items;
    items.reserve(size_);
    for (const auto& chunk : chunks_) items.insert(items.end(), chunk->begin(), chunk->end());
    return items;
  }

 private:
  std::vector<std::shared_ptr<const Chunk>> chunks_;
  std::size_t size_ = 0;
};

/// Writes the next version.
template <typename T>
class SharedListWriter {
 public:
  SharedListWriter() = default;
  explicit SharedListWriter(const std::vector<T>& items) {
    for (const T& item : items) push_back(item);
  }

  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return (*chunks_[i / kChunk].items)[i % kChunk]; }
  void push_back(T item) {
    if (size_ % kChunk == 0) {
      chunks_.push_back({std::make_shared<Chunk>(), true});
      chunks_.back().items->reserve(kChunk);
    }
    own(size_++).push_back(std::move(item));
  }
  void set(std::size_t i, T item) { own(i)[i % kChunk] = std::move(item); }
  /// The version as it is now.
  SharedList<T> share() {
    std::vector<std::shared_ptr<const Chunk>> shared;
    shared.reserve(chunks_.size());
    for (Part& part : chunks_) {
      part.own = false;
      shared.push_back(part.items);
    }
    return {std::move(shared), size_};
  }

 private:
  static constexpr std::size_t kChunk = SharedList<T>::kChunk;
  using Chunk = typename SharedList<T>::Chunk;
  struct Part {
    std::shared_ptr<Chunk> items;
    bool own;  ///< in no version yet
  };

  Chunk& own(std::size_t i) {
    Part& part = chunks_[i / kChunk];
    if (!part.own) {
      auto copy = std::make_shared<Chunk>();
      copy->reserve(kChunk);
      copy->assign(part.items->begin(), part.items->end());
      part = {std::move(copy), true};
    }
    return *part.items;
  }

  std::vector<Part> chunks_;
  std::size_t size_ = 0;
};

}  // namespace handmap
