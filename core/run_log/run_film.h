// A run as a film: a picture of the map a frame, in a video or as numbered pictures.
#pragma once

#include <filesystem>
#include <memory>

#include "core/method/snapshot.h"

namespace handmap {

class RunFilm {
 public:
  /// An ending of videos (.mp4, .avi, .mkv, .webm), 10 pictures a second; another path is a folder
  /// for 000000.png and so on, which may not be there or is to be empty. What is shown does not
  /// move: the drawing, and a little around. A video is runPartOf(path) until finish(). Throws
  /// RunFailed, as add() does.
  RunFilm(const std::filesystem::path& path, const Map& drawing);
  ~RunFilm();
  RunFilm(const RunFilm&) = delete;
  RunFilm& operator=(const RunFilm&) = delete;

  /// Of each frame once: what comes again is passed over.
  void add(const Snapshot& snapshot);
  /// Throws RunFailed where the video was not written whole.
  void finish();

  static bool isVideo(const std::filesystem::path& path);

 private:
  struct Camera;
  std::unique_ptr<Camera> camera_;
};

}  // namespace handmap
