#include "widgets/importing/import_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "widgets/rig/rig_preview.h"

namespace handmap {

class ImportDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tellsWhatItHoldsAndReadsAgainWithOtherUnits();
  void asksForWhatCannotBeSeen();
  void takesThePosesOfAnotherFile();

 private:
  QString written(const QString& name, const std::string& text) const {
    const QString path = folder_.filePath(name);
    std::ofstream(path.toStdString()) << text;
    return path;
  }
  static QString wordsOf(const ImportDialog& dialog) {
    return dialog.findChild<QLabel*>("import_words")->text();
  }
  QTemporaryDir folder_;
};

void ImportDialogTest::tellsWhatItHoldsAndReadsAgainWithOtherUnits() {
  std::string text = "t,px,py\n";
  for (int row = 0; row < 40; ++row) {
    text += std::to_string(row / 10) + "," + std::to_string(3 + row) + ",2\n";
  }
  ImportDialog dialog({written("a.csv", text)});
  QTRY_VERIFY(dialog.log());
  QCOMPARE(dialog.log()->scans.size(), std::size_t{4});
  QCOMPARE(dialog.log()->scans[0].points[0].x, 3.0F);
  QVERIFY2(wordsOf(dialog).startsWith("4 scan"), qPrintable(wordsOf(dialog)));
  dialog.findChild<QComboBox*>("import_metres")->setCurrentIndex(2);
  QVERIFY(!dialog.log());
  QTRY_VERIFY(dialog.log());
  QCOMPARE(dialog.log()->scans[0].points[0].x, 0.03F);
  auto* sensor = dialog.findChild<QLineEdit*>("import_sensor");
  sensor->setText("1,0");
  Q_EMIT sensor->editingFinished();
  QVERIFY(dialog.findChild<RigPreviewView*>()->accessibleDescription().contains("--sensor"));
  dialog.findChild<QComboBox*>("import_metres")->setCurrentIndex(0);
  sensor->setText("1,0,0.5");
  Q_EMIT sensor->editingFinished();
  QTRY_VERIFY(dialog.log());
  QCOMPARE(dialog.log()->scans[0].points[0].x, 4.0F);
}

void ImportDialogTest::asksForWhatCannotBeSeen() {
  std::string text = "time";
  for (int i = 0; i < 17; ++i) text += ",r" + std::to_string(i);
  text += "\n0";
  for (int i = 0; i < 17; ++i) text += "," + std::to_string(5 + i);
  ImportDialog dialog({written("b.csv", text + "\n")});
  dialog.open();
  QTRY_VERIFY2(wordsOf(dialog).startsWith("FIRST:STEP"), qPrintable(wordsOf(dialog)));
  auto* import = dialog.findChild<QPushButton*>("import_import");
  QVERIFY(!dialog.log());
  auto* angles = dialog.findChild<QLineEdit*>("import_angles");
  QCOMPARE(dialog.focusWidget(), angles);
  angles->setText("0:5");
  Q_EMIT angles->editingFinished();
  QTRY_VERIFY(dialog.log());
  QVERIFY(import->isEnabled());
  Q_EMIT angles->editingFinished();  // the focus goes to the button
  QVERIFY(import->isEnabled());
}

void ImportDialogTest::takesThePosesOfAnotherFile() {
  ImportDialog dialog({written("poses.csv", "t,x,y,yaw\n0,1,2,0\n1,2,2,0\n")});
  bool is_wanted = false;
  connect(&dialog, &ImportDialog::anotherFileWanted, &dialog, [&] { is_wanted = true; });
  QTRY_VERIFY2(wordsOf(dialog).contains("poses", Qt::CaseInsensitive), qPrintable(wordsOf(dialog)));
  dialog.findChild<QPushButton*>("import_another")->click();
  QVERIFY(is_wanted);
  dialog.add({});
  QVERIFY(!dialog.log());
  std::string scans = "t,px,py\n";
  for (int row = 0; row < 20; ++row) scans += std::to_string(row / 10) + ",3,2\n";
  dialog.add(written("scans.csv", scans));
  QTRY_VERIFY(dialog.log());
  QCOMPARE(dialog.log()->scans.size(), std::size_t{2});
  QCOMPARE(dialog.log()->poses.size(), std::size_t{2});
}

}  // namespace handmap

QTEST_MAIN(handmap::ImportDialogTest)
#include "import_dialog_test.moc"
