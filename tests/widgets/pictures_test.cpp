// Pictures under a drawing: their files, hostile ones too, and the tool that lays them.
#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/map/tangent_plane.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/pictures/picture_file.h"
#include "widgets/pictures/raster.h"
#include "widgets/tools/picture_tool.h"

#ifdef HANDMAP_GDAL
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#endif

namespace handmap {

namespace {

constexpr double kScale = 0.1;   // metres per pixel of the canvas
const QSize kPicture(200, 100);  // pixels
using Mode = PictureTool::Mode;

ToolEvent at(const Vec2& point, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  ToolEvent event;
  event.position = event.snapped = point;
  event.metres_per_pixel = kScale;
  event.modifiers = modifiers;
  return event;
}

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

QString messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

}  // namespace

class PicturesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    document_ = std::make_unique<MapDocument>();
    Map map;
    map.underlays = {{"plan.png", 10.0, 60.0, 0.5, 0.0, 0.6, {}}};  // 100 m × 50 m
    document_->reset(map);
    tool_ = std::make_unique<PictureTool>(*document_, [](std::size_t) { return kPicture; });
    tool_->activate();
  }

  // --- Tool

  void thePictureIsDraggedAsOneStep() {
    QCOMPARE(document_->selection(), QStringList{pictureKey(0)});
    drag({30.0, 40.0}, {35.0, 42.0});
    QCOMPARE(underlay().x, 15.0);
    QCOMPARE(underlay().y, 62.0);
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QCOMPARE(underlay().x, 10.0);
    drag({-30.0, 40.0}, {35.0, 42.0});
    QCOMPARE(document_->undoStack().count(),
             1);  // beside the picture: only the undone step is left
    QCOMPARE(underlay().x, 10.0);
  }

  void cornersScaleAboutTheOppositeOne() {
    drag({110.0, 10.0}, {210.0, -40.0});
    QVERIFY(std::abs(underlay().metres_per_pixel - 1.0) < 1e-9);
    QVERIFY(std::abs(underlay().x - 10.0) < 1e-9 && std::abs(underlay().y - 60.0) < 1e-9);
    tool_->press(at({210.0, -40.0}));
    tool_->move(at({9.0, 70.0}));
    QVERIFY(tool_->preview());
    QVERIFY(tool_->cancel());
    QVERIFY(std::abs(underlay().metres_per_pixel - 1.0) < 1e-9);
  }

  void theRoundHandleTurnsAboutTheCentre() {
    const Rectangle box{{60.0, 35.0}, 100.0, 50.0, 0.0};
    drag(handlePosition(box, {0, 0}, kScale), {160.0, 35.0}, Qt::ShiftModifier);
    QVERIFY(std::abs(normalizedAngle(underlay().heading + kPi / 2.0)) < 1e-9);
    QVERIFY((pointOf(underlay(), {100.0, 50.0}) - Vec2(60.0, 35.0)).norm() < 1e-9);
  }

  void keysMoveTurnAndScale() {
    QVERIFY(key(Qt::Key_Right));
    QVERIFY(key(Qt::Key_Up, Qt::ShiftModifier));
    QCOMPARE(underlay().x, 11.0);
    QCOMPARE(underlay().y, 70.0);
    QVERIFY(key(Qt::Key_Up, Qt::ControlModifier));
    QVERIFY(std::abs(underlay().metres_per_pixel - 0.505) < 1e-9);
    QVERIFY(key(Qt::Key_Left, Qt::ControlModifier));
    QVERIFY(std::abs(toDegrees(underlay().heading) - 0.5) < 1e-9);
    QVERIFY(!key(Qt::Key_A));
  }

  void aLengthIsTypedOnTheCanvas() {
    tool_->setMode(Mode::Scale);
    click({20.0, 40.0});
    QVERIFY(!tool_->measured());
    click({40.0, 40.0});
    QCOMPARE(tool_->measured(), std::optional(20.0));
    const Vec2 first = pixelOf(underlay(), {20.0, 40.0});
    const Vec2 second = pixelOf(underlay(), {40.0, 40.0});
    for (const int k :
         {Qt::Key_3, Qt::Key_5, Qt::Key_Backspace, Qt::Key_0, Qt::Key_Period, Qt::Key_5})
      QVERIFY(key(k));
    QVERIFY(key(Qt::Key_Return));
    const double length = (pointOf(underlay(), first) - pointOf(underlay(), second)).norm();
    QVERIFY(std::abs(length - 30.5) < 1e-9);
    QVERIFY((pointOf(underlay(), first) - Vec2(20.0, 40.0)).norm() < 1e-9);
    QVERIFY(!tool_->measured());  // done
    QVERIFY(!tool_->setLength(10.0));
    QCOMPARE(document_->undoStack().count(), 1);
  }

  void pairsOfPointsFitThePicture() {
    const Underlay wanted{"plan.png", -40.0, 20.0, 0.25, toRadians(20.0), 0.6, {}};
    tool_->setMode(Mode::Fit);
    const Underlay before = underlay();
    int pair = 0;
    for (const Vec2& pixel : {Vec2(20.0, 20.0), Vec2(180.0, 30.0), Vec2(90.0, 90.0)}) {
      QVERIFY(pair++ >= 2 || !tool_->fit());
      click(pointOf(before, pixel));
      click(pointOf(wanted, pixel));
    }
    QCOMPARE(tool_->pairs(), std::size_t(3));
    QVERIFY(key(Qt::Key_Return));
    QVERIFY(std::abs(underlay().metres_per_pixel - 0.25) < 1e-9);
    QVERIFY(std::abs(underlay().heading - wanted.heading) < 1e-9);
    QVERIFY(std::hypot(underlay().x - wanted.x, underlay().y - wanted.y) < 1e-6);
    document_->undoStack().undo();
    QCOMPARE(underlay(), before);
  }

  void lockedAndHiddenPicturesStayWhereTheyAre() {
    for (bool Flags::*const flag : {&Flags::locked, &Flags::hidden}) {
      Underlay locked = underlay();
      locked.unknown.clear();
      locked.flags.*flag = true;
      document_->setUnderlays({locked}, "Lock");
      QVERIFY(!tool_->current());
      drag({30.0, 40.0}, {35.0, 42.0});
      QVERIFY(!key(Qt::Key_Right));
      QCOMPARE(underlay(), locked);
    }
  }

  void aPictureIsRemovedLikeEverythingElse() {
    document_->addUnderlay({"b.png", 0.0, 0.0, 1.0, 0.0, 1.0, {}});
    document_->setSelection({pictureKey(0)});
    document_->removeSelected();
    QCOMPARE(document_->map().underlays.size(), std::size_t(1));
    QCOMPARE(underlay().image, std::string("b.png"));
    QVERIFY(document_->selection().isEmpty());
    document_->undoStack().undo();
    QCOMPARE(underlay().image, std::string("plan.png"));
  }

  // --- Files

  void theHeadTellsSizeAndPlace() {
    const QString path = folder_.filePath("photo.png");
    QVERIFY(QImage(40, 20, QImage::Format_RGB32).save(path));
    QCOMPARE(readPictureHead(path).size, QSize(40, 20));
    QVERIFY(!readPictureHead(path).geometry);
    write(folder_.filePath("PHOTO.PGW"), "0.5\n0\n0\n-0.5\n500000\n4100000\n");
    const PictureHead head = readPictureHead(path);
    QVERIFY(head.geometry && head.geometry->kind == PictureGeometry::Kind::Metres);
    const auto placed = grounded({}, *head.geometry, std::nullopt, Vec2(7.0, 8.0));
    QVERIFY(placed);
    QCOMPARE(placed->fit.underlay.metres_per_pixel, 0.5);
    write(folder_.filePath("PHOTO.PGW"), "0.000005\n0\n0\n-0.000005\n137.4\n34.7\n");
    QVERIFY(readPictureHead(path).geometry->kind == PictureGeometry::Kind::LongitudeLatitude);
    write(folder_.filePath("PHOTO.PGW"), "what?");
    QVERIFY(messageOf([&] { readPictureHead(path); }).contains("six numbers"));
  }

  void hostileFilesAreRefusedWithAWord() {
    const auto refused = [&](const QString& name, const QByteArray& bytes) {
      const QString path = folder_.filePath(name);
      write(path, bytes);
      return !messageOf([&] { readPictureHead(path); }).isEmpty() ||
             !messageOf([&] { readPicture(path); }).isEmpty();
    };
    QVERIFY(refused("empty.png", {}));
    QVERIFY(refused("text.jpg", "not a picture at all"));
    QVERIFY(refused("text.tif", "II*\0 not a picture at all"));
    QVERIFY(refused("list.tif", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"/>"));
    QByteArray torn;
    {
      QBuffer buffer(&torn);
      QImage(300, 300, QImage::Format_RGB32).save(&buffer, "PNG");
    }
    QVERIFY(refused("torn.png", torn.left(60)));
    // A head that promises four thousand million pixels.
    QByteArray bomb = torn;
    for (const int place : {16, 20}) bomb.replace(place, 4, QByteArray::fromHex("0000ffff"));
    QVERIFY(refused("bomb.png", bomb));
    QVERIFY(messageOf([&] { readPictureHead(folder_.path()); }).contains("not a file"));
    QVERIFY(messageOf([&] { readPictureHead("/no/such.png"); }).contains("no such file"));
  }

#ifdef HANDMAP_GDAL
  void aGeoTiffTellsWhereItLies() {
    const QString path = folder_.filePath("aerial.tif");
    writeGeoTiff(path);
    const PictureHead head = readPictureHead(path);
    QCOMPARE(head.size, QSize(80, 60));
    QVERIFY(head.geometry && head.geometry->kind == PictureGeometry::Kind::LongitudeLatitude);
    const auto placed = grounded({}, *head.geometry, std::nullopt, Vec2::Zero());
    QVERIFY(placed && placed->georeference);
    // UTM zone 53 north, two degrees from its middle: the grid is turned against north.
    QVERIFY(std::abs(toDegrees(placed->fit.underlay.heading)) > 0.5);
    QVERIFY(std::abs(placed->fit.underlay.metres_per_pixel - 0.5) < 0.001);
    QVERIFY(std::abs(placed->georeference->longitude - 137.4) < 0.1);
    QVERIFY(placed->fit.residual < 0.01);
    const Picture picture = readPicture(path);
    QCOMPARE(picture.size, QSize(80, 60));
    QCOMPARE(picture.image.pixelColor(10, 10), QColor(200, 30, 40));
  }
#endif

 private:
  static void writeGeoTiff(const QString& path);

  const Underlay& underlay() const { return document_->map().underlays.front(); }
  void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    tool_->press(at(from, modifiers));
    tool_->move(at(to, modifiers));
    tool_->release(at(to, modifiers));
  }
  void click(const Vec2& point) { drag(point, point); }
  bool key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return tool_->key({code, modifiers, 1.0});
  }

  QTemporaryDir folder_;
  std::unique_ptr<MapDocument> document_;
  std::unique_ptr<PictureTool> tool_;
};

#ifdef HANDMAP_GDAL
void PicturesTest::writeGeoTiff(const QString& path) {
  GDALRegister_GTiff();
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), QFile::encodeName(path).constData(),
                                 80, 60, 3, GDT_Byte, nullptr);
  QVERIFY(file != nullptr);
  double affine[6] = {719'700.0, 0.5, 0.0, 3'842'300.0, 0.0, -0.5};
  GDALSetGeoTransform(file, affine);
  OGRSpatialReferenceH system = OSRNewSpatialReference(nullptr);
  QVERIFY(OSRImportFromEPSG(system, 32653) == OGRERR_NONE);
  GDALSetSpatialRef(file, system);
  OSRDestroySpatialReference(system);
  const int colour[] = {200, 30, 40};
  for (int band = 0; band < 3; ++band)
    GDALFillRaster(GDALGetRasterBand(file, band + 1), colour[band], 0.0);
  GDALClose(file);
}
#endif

}  // namespace handmap

QTEST_MAIN(handmap::PicturesTest)
#include "pictures_test.moc"
