#include "widgets/importing/bag_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "core/bags/mcap_writer.h"

namespace handmap {

class BagDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void proposesTopicsAndTakesOthers();
  void saysWhatIsNoBag();
  void asksForNoChoiceWhereThereIsNone();

 private:
  static bool mayImport(const BagDialog& dialog) {
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
      if (button->text() == "Import…") return button->isEnabled();
    }
    return false;
  }
  QTemporaryDir folder_;
};

void BagDialogTest::proposesTopicsAndTakesOthers() {
  const QString path = folder_.filePath("a.mcap");
  {
    McapWriter writer(path.toStdString());
    for (const char* scan : {"/front/scan", "/rear/scan"}) {
      const auto topic = writer.addTopic(scan, "sensor_msgs/msg/LaserScan", "");
      writer.write(topic, 1.0, "");
    }
    writer.finish();
  }
  BagDialog dialog(path);
  QTRY_VERIFY(dialog.bag());
  auto* scan = dialog.findChild<QComboBox*>("bag_scan");
  QCOMPARE(scan->count(), 3);
  QCOMPARE(dialog.topics().at("scan"), std::string("/front/scan"));
  QCOMPARE(dialog.topics().at("left"), std::string("none"));
  QVERIFY(!dialog.findChild<QComboBox*>("bag_left")->isEnabled());
  QVERIFY(mayImport(dialog));
  dialog.setVisible(true);
  QTest::keyClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                  Qt::Key_Return);
  QCOMPARE(dialog.result(), int(QDialog::Accepted));
  scan->setCurrentIndex(2);
  QCOMPARE(dialog.topics().at("scan"), std::string("/rear/scan"));
  auto* sensor = dialog.findChild<QLineEdit*>("bag_sensor");
  QVERIFY(!dialog.topics().contains("sensor"));
  sensor->setText("0.3,0");
  QVERIFY(!mayImport(dialog));
  QVERIFY(dialog.findChild<QLabel*>("bag_words")->text().contains("X,Y,Z"));
  sensor->setText("0.3,0,1.7,90");
  QVERIFY(mayImport(dialog));
  QCOMPARE(dialog.topics().at("sensor"), std::string("0.3,0,1.7,90"));
  scan->setCurrentIndex(0);
  QVERIFY(!mayImport(dialog));
  QVERIFY(dialog.findChild<QLabel*>("bag_words")->text().startsWith("Nothing in it sees"));
}

void BagDialogTest::saysWhatIsNoBag() {
  const QString path = folder_.filePath("b.bag");
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write("something else");
  file.close();
  const BagDialog dialog(path);
  const auto* words = dialog.findChild<QLabel*>("bag_words");
  QTRY_VERIFY2(words->text().contains("b.bag: found another beginning"), qPrintable(words->text()));
  QVERIFY(!mayImport(dialog));
  for (const QComboBox* choice : dialog.findChildren<QComboBox*>()) QVERIFY(!choice->isEnabled());
}

void BagDialogTest::asksForNoChoiceWhereThereIsNone() {
  const QString path = folder_.filePath("c.mcap");
  McapWriter writer(path.toStdString());
  writer.write(writer.addTopic("/odom", "nav_msgs/msg/Odometry", ""), 1.0, "");
  writer.finish();
  const BagDialog dialog(path);
  QTRY_VERIFY(dialog.bag());
  QVERIFY(dialog.findChild<QComboBox*>("bag_odometry")->isEnabled());
  QVERIFY(dialog.findChild<QLabel*>("bag_words")->text().contains("neither scans nor points"));
  QVERIFY(!mayImport(dialog));
}

}  // namespace handmap

QTEST_MAIN(handmap::BagDialogTest)
#include "bag_dialog_test.moc"
