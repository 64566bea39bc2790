#include "core/bags/packed.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

enum class Step { More, Done, Broken };

/// Input that is left, and room that is to be filled.
struct Window {
  std::string_view in;
  char* out;
  std::size_t room;
};

class Bzip2 {
 public:
  Bzip2() { is_ready_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK; }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream_); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  Step operator()(Window& window) {
    if (!is_ready_) return Step::Broken;
    constexpr std::size_t kMost = 1u << 30;  // it counts in 32 bits
    const std::size_t given = std::min(window.in.size(), kMost);
    stream_.next_in = const_cast<char*>(window.in.data());
    stream_.avail_in = static_cast<unsigned>(given);
    stream_.next_out = window.out;
    stream_.avail_out = static_cast<unsigned>(window.room);
    const int result = BZ2_bzDecompress(&stream_);
    window.in.remove_prefix(given - stream_.avail_in);
    window.room = stream_.avail_out;
    return result == BZ_STREAM_END ? Step::Done : result == BZ_OK ? Step::More : Step::Broken;
  }

 private:
  bz_stream stream_{};
  bool is_ready_ = false;
};

class Lz4 {
 public:
  Lz4() { LZ4F_createDecompressionContext(&context_, LZ4F_VERSION); }
  ~Lz4() { LZ4F_freeDecompressionContext(context_); }
  Lz4(const Lz4&) = delete;
  Lz4& operator=(const Lz4&) = delete;

  Step operator()(Window& window) {
    std::size_t written = window.room;
    std::size_t taken = window.in.size();
    const std::size_t result =
        LZ4F_decompress(context_, window.out, &written, window.in.data(), &taken, nullptr);
    if (LZ4F_isError(result) != 0) return Step::Broken;
    window.in.remove_prefix(taken);
    window.room -= written;
    return result == 0 ? Step::Done : Step::More;
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};

class Zstandard {
 public:
  Zstandard() : stream_(ZSTD_createDStream(), ZSTD_freeDStream) {}

  Step operator()(Window& window) {
    ZSTD_outBuffer out{window.out, window.room, 0};
    ZSTD_inBuffer in{window.in.data(), window.in.size(), 0};
    const std::size_t result = ZSTD_decompressStream(stream_.get(), &out, &in);
    if (ZSTD_isError(result) != 0) return Step::Broken;
    window.in.remove_prefix(in.pos);
    window.room -= out.pos;
    return result == 0 ? Step::Done : Step::More;
  }

 private:
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream_;
};

/// nullopt: damaged or cut off.
template <typename Unpack>
std::optional<std::string> unpackedBy(Unpack&& unpack, std::string_view in, std::size_t most) {
  constexpr std::size_t kBlock = 1u << 20;
  std::string all;
  while (true) {
    const std::size_t before = all.size();
    if (before > most) return all;
    all.resize(before + kBlock);
    Window window{in, all.data() + before, kBlock};
    const Step step = unpack(window);
    const bool stands = window.in.size() == in.size() && window.room == kBlock;
    in = window.in;
    all.resize(all.size() - window.room);
    if (step == Step::Done) return all;
    if (step == Step::Broken || stands) return std::nullopt;
  }
}

}  // namespace

std::string unpacked(std::string_view packing, std::string_view bytes, const std::string& source,
                     const std::string& place, std::size_t most) {
  std::optional<std::string> all;
  if (packing.empty() || packing == "none") {
    all = std::string(bytes);
  } else if (packing == "bz2") {
    all = unpackedBy(Bzip2(), bytes, most);
  } else if (packing == "lz4") {
    all = unpackedBy(Lz4(), bytes, most);
  } else if (packing == "zstd") {
    all = unpackedBy(Zstandard(), bytes, most);
  } else {
    throwBadInput(source, place, fmt::format("\"{}\"", packing.substr(0, 40)),
                  "none, bz2, lz4, zstd");
  }
  if (!all) throwBadInput(source, place, phrase("damaged bytes"), std::string(packing));
  if (all->size() > most) {
    throwBadInput(source, place, phrase("more than {} bytes", most),
                  phrase("at most {} bytes", most));
  }
  return std::move(*all);
}

}  // namespace handmap
