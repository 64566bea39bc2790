// Lists whose versions share what they have in common: items lie in chunks, chunks in pages, and a
// version costs a pointer a page and what has changed since the one before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace handmap {

/// One version: never changes.
template <typename T>
class SharedList {
 public:
  static constexpr std::size_t kChunk = 64;  ///< items in a chunk, and chunks in a page
  using Chunk = std::vector<T>;
  using Page = std::vector<std::shared_ptr<const Chunk>>;

  SharedList() = default;
  SharedList(std::vector<std::shared_ptr<const Page>> pages, std::size_t size)
      : pages_(std::move(pages)), size_(size) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const {
    const std::size_t chunk = i / kChunk;
    return (*(*pages_[chunk / kChunk])[chunk % kChunk])[i % kChunk];
  }
  const T& back() const { return (*this)[size_ - 1]; }
  std::vector<T> all() const {
    std::vector<T> items;
    items.reserve(size_);
    for (const auto& page : pages_) {
      for (const auto& chunk : *page) items.insert(items.end(), chunk->begin(), chunk->end());
    }
    return items;
  }

 private:
  std::vector<std::shared_ptr<const Page>> pages_;
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
  void push_back(T item) {  // NOLINT(readability-identifier-naming): as std::vector has it
    if (size_ % kChunk == 0) chunks_.emplace_back();
    own(size_++).push_back(std::move(item));
  }
  void set(std::size_t i, T item) { own(i)[i % kChunk] = std::move(item); }
  /// The version as it is now.
  SharedList<T> share() {
    for (const std::size_t chunk : own_chunks_) {
      chunks_[chunk].own = false;
      pages_[chunk / kChunk].own = false;
    }
    own_chunks_.clear();
    std::vector<std::shared_ptr<const Page>> shared;
    shared.reserve(pages_.size());
    for (const auto& page : pages_) shared.push_back(page.items);
    return {std::move(shared), size_};
  }

 private:
  static constexpr std::size_t kChunk = SharedList<T>::kChunk;
  using Chunk = typename SharedList<T>::Chunk;
  using Page = typename SharedList<T>::Page;
  template <typename Items>
  struct Part {
    std::shared_ptr<Items> items;
    bool own = false;  ///< in no version yet
  };

  /// For writing: where a version has it, a copy takes its place.
  template <typename Items>
  static Items& owned(Part<Items>& part) {
    if (!part.own) {
      auto copy = std::make_shared<Items>();
      copy->reserve(part.items ? std::min(kChunk, part.items->size() + 1) : 1);  // many are kept
      if (part.items) copy->assign(part.items->begin(), part.items->end());
      part = {std::move(copy), true};
    }
    return *part.items;
  }

  /// The chunk of item i. A chunk that is new is new in its page.
  Chunk& own(std::size_t i) {
    const std::size_t at = i / kChunk;
    const bool is_new = !chunks_[at].own;
    Chunk& chunk = owned(chunks_[at]);
    if (!is_new) return chunk;
    own_chunks_.push_back(at);
    if (at / kChunk == pages_.size()) pages_.emplace_back();
    Page& page = owned(pages_[at / kChunk]);
    if (at % kChunk == page.size()) page.emplace_back();
    page[at % kChunk] = chunks_[at].items;
    return chunk;
  }

  std::vector<Part<Chunk>> chunks_;
  std::vector<Part<Page>> pages_;
  std::vector<std::size_t> own_chunks_;  ///< of chunks_
  std::size_t size_ = 0;
};

}  // namespace handmap
