#include "core/run_log/run_film.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"
#include "core/run_log/run_part.h"

namespace handmap {

namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr double kPictures_hz = 10.0;
constexpr double kAround_m = 15.0;  // of the drawing
constexpr int kShift = 4;           // bits of a pixel's fraction

// As the window has them (blue first): drawing, corrected map, truth, particles, odometry.
const cv::Scalar kPaper(252, 252, 252);
const cv::Scalar kInk(90, 90, 90);
const cv::Scalar kCorrected(217, 89, 0);
const cv::Scalar kTruth(60, 160, 30);
const cv::Scalar kParticle(40, 140, 240);
const cv::Scalar kOdometry(170, 170, 170);

}  // namespace

/// The pixels of a stretch of the map.
class FilmPlan {
 public:
  explicit FilmPlan(const Map& drawing) {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = -low;
    const auto include = [&](const Vec2& point) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    };
    for (const Building& building : drawing.buildings) {
      for (const Vec2& corner : building.footprint()) include(corner);
    }
    if (drawing.start) include(drawing.start->position());
    for (const Vec2& point : drawing.route) include(point);
    const Vec2 size = (high - low).array() + 2.0 * kAround_m;
    scale_ = std::min(kWidth / size.x(), kHeight / size.y());
    middle_ = 0.5 * (low + high);
  }

  cv::Point operator()(const Vec2& point) const {
    const Vec2 at = scale_ * (point - middle_);
    const auto fixed = [](double pixel) {
      return static_cast<int>(std::lround(std::clamp(pixel, -1e5, 1e5) * (1 << kShift)));
    };
    return {fixed(0.5 * kWidth + at.x()), fixed(0.5 * kHeight - at.y())};
  }
  int pixels(double metres) const {
    return static_cast<int>(std::lround(scale_ * metres * (1 << kShift)));
  }

 private:
  double scale_ = 1.0;
  Vec2 middle_ = Vec2::Zero();
};

namespace {

void drawLine(cv::Mat& picture, const FilmPlan& plan, const std::vector<Vec2>& line, bool closed,
              const cv::Scalar& colour, int width) {
  if (line.size() < 2) return;
  std::vector<cv::Point> points;
  for (const Vec2& point : line) points.push_back(plan(point));
  cv::polylines(picture, points, closed, colour, width, cv::LINE_AA, kShift);
}

void drawWay(cv::Mat& picture, const FilmPlan& plan, const SharedList<StampedPose>& way,
             const cv::Scalar& colour) {
  std::vector<Vec2> line;
  for (const StampedPose& stamped : way.all()) line.push_back(stamped.pose.position());
  drawLine(picture, plan, line, false, colour, 1);
}

void drawRobot(cv::Mat& picture, const FilmPlan& plan, const Pose2& pose,
               const cv::Scalar& colour) {
  constexpr double kRobot_m = 1.5;
  const Vec2 tip = pose.toOuter({2.0 * kRobot_m, 0.0});
  cv::circle(picture, plan(pose.position()), std::max(plan.pixels(kRobot_m), 4 << kShift), colour,
             cv::FILLED, cv::LINE_AA, kShift);
  cv::line(picture, plan(pose.position()), plan(tip), colour, 2, cv::LINE_AA, kShift);
}

}  // namespace

struct RunFilm::Camera {
  Camera(fs::path to, const Map& its_drawing)
      : path(std::move(to)), drawing(its_drawing), plan(its_drawing) {}

  [[noreturn]] void fail(const std::string& why) const {
    throw Error(ErrorCode::RunFailed, phrase("{}: cannot be written: {}", path.string(), why));
  }

  /// OpenCV does not tell why.
  [[noreturn]] void failOrFull(const std::string& why) const {
    constexpr std::uintmax_t kFull = 1 << 20;  // bytes that are left
    std::error_code error;
    const auto space =
        fs::space(path.has_parent_path() ? path.parent_path() : fs::path("."), error);
    const bool is_full = !error && space.available < kFull;
    fail(is_full ? std::generic_category().message(ENOSPC) : why);
  }

  cv::Mat pictureOf(const Snapshot& snapshot) const {
    cv::Mat picture(kHeight, kWidth, CV_8UC3, kPaper);
    for (const Building& building : drawing.buildings) {
      drawLine(picture, plan, building.footprint(), true, kInk, 1);
    }
    drawWay(picture, plan, snapshot.odometry, kOdometry);
    drawWay(picture, plan, snapshot.trajectory, kCorrected);
    for (const ParticleView& particle : snapshot.particles) {
      cv::circle(picture, plan(particle.pose.position()), 2 << kShift, kParticle, cv::FILLED,
                 cv::LINE_AA, kShift);
    }
    if (snapshot.map) {
      const auto map = snapshot.map.again();
      for (const Building& building : map->buildings) {
        const bool is_seen = building.estimate && building.estimate->observations > 0;
        if (is_seen) drawLine(picture, plan, building.footprint(), true, kCorrected, 2);
      }
    }
    if (snapshot.truth) drawRobot(picture, plan, *snapshot.truth, kTruth);
    drawRobot(picture, plan, snapshot.report.pose, kCorrected);
    return picture;
  }

  fs::path path;
  Map drawing;
  FilmPlan plan;
  cv::VideoWriter video;
  int frame = -1;
  int pictures = 0;
};

bool RunFilm::isVideo(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".mp4" || ending == ".avi" || ending == ".mkv" || ending == ".webm";
}

RunFilm::RunFilm(const fs::path& path, const Map& drawing)
    : camera_(std::make_unique<Camera>(path, drawing)) {
  if (isVideo(path)) {
    const std::string ending = path.extension().string();
    const int code = ending == ".webm"  ? cv::VideoWriter::fourcc('V', 'P', '8', '0')
                     : ending == ".mp4" ? cv::VideoWriter::fourcc('m', 'p', '4', 'v')
                                        : cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
    camera_->video.open(runPartOf(path).string(), cv::CAP_FFMPEG, code, kPictures_hz,
                        {kWidth, kHeight});
    if (!camera_->video.isOpened()) camera_->failOrFull(phrase("no such video can be made here"));
    return;
  }
  std::error_code error;
  if (fs::exists(path) && !fs::is_empty(path, error)) camera_->fail(phrase("it is not empty"));
  fs::create_directories(path, error);
  if (error) camera_->fail(error.message());
}

RunFilm::~RunFilm() = default;

void RunFilm::add(const Snapshot& snapshot) {
  Camera& camera = *camera_;
  if (snapshot.report.frame <= camera.frame) return;
  camera.frame = snapshot.report.frame;
  const cv::Mat picture = camera.pictureOf(snapshot);
  if (camera.video.isOpened()) {
    camera.video.write(picture);
  } else {
    writePng(picture, camera.path / fmt::format("{:06}.png", camera.pictures));
  }
  ++camera.pictures;
}

/// A full disk is told by nobody: whether all is there shows what can be read again.
void RunFilm::finish() {
  if (!camera_->video.isOpened()) return;
  camera_->video.release();
  const fs::path part = runPartOf(camera_->path);
  cv::VideoCapture written(part.string(), cv::CAP_FFMPEG);
  int read = 0;
  while (written.isOpened() && written.grab()) ++read;
  if (read < camera_->pictures) {
    std::error_code ignored;
    fs::remove(part, ignored);
    camera_->failOrFull(phrase("the disk took but a part of it"));
  }
  takePlace(camera_->path);
}

}  // namespace handmap
