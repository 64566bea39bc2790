#include "widgets/calibration/calibration_words.h"

#include <QObject>

namespace handmap {

QString inWords(BoardNeed need) {
  switch (need) {
    case BoardNeed::AtLeft:
      return QObject::tr("at the left edge");
    case BoardNeed::AtRight:
      return QObject::tr("at the right edge");
    case BoardNeed::AtTop:
      return QObject::tr("at the top edge");
    case BoardNeed::AtBottom:
      return QObject::tr("at the bottom edge");
    case BoardNeed::Near:
      return QObject::tr("near: half as wide as the image");
    case BoardNeed::Far:
      return QObject::tr("far: a quarter of the image");
    case BoardNeed::LeftNearer:
      return QObject::tr("turned, its left side nearer");
    case BoardNeed::RightNearer:
      return QObject::tr("turned, its right side nearer");
    case BoardNeed::TopNearer:
      return QObject::tr("tilted, its top nearer");
    case BoardNeed::BottomNearer:
      return QObject::tr("tilted, its bottom nearer");
  }
  return {};
}

QString inWords(BoardVerdict verdict, const std::vector<BoardNeed>& missing) {
  QString next = missing.empty() ? QObject::tr("Move or tilt it: any new view helps.")
                                 : QObject::tr("Next: %1.").arg(inWords(missing.front()));
  switch (verdict) {
    case BoardVerdict::NotSeen:
      return QObject::tr("No whole board is seen.");
    case BoardVerdict::InOneImage:
      return QObject::tr("Only one camera sees the whole board.");
    case BoardVerdict::Moving:
      return QObject::tr("Hold still.");
    case BoardVerdict::Known:
      return next;
    case BoardVerdict::Blurred:
      return QObject::tr("Not sharp: more light, or hold it stiller.");
    case BoardVerdict::Taken:
      return QObject::tr("Taken.") + ' ' + next;
  }
  return {};
}

QString inWords(const CalibrationResult& result) {
  const StereoCalibration& calibration = result.calibration;
  return QObject::tr(
             "Found with %1 pairs: the corners are off by %2 px in the left and %3 px in the right "
             "image, rows by %4 px. Baseline %5 m, focal length %6 px. What lies on a line on the "
             "left lies on it on the right.")
      .arg(result.used.size())
      .arg(result.left_error_px, 0, 'f', 2)
      .arg(result.right_error_px, 0, 'f', 2)
      .arg(result.epipolar_error_px, 0, 'f', 2)
      .arg(cv::norm(calibration.translation), 0, 'f', 4)
      .arg(calibration.left.matrix(0, 0), 0, 'f', 1);
}

}  // namespace handmap
