#include "widgets/importing/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

namespace handmap {

class ImportDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tellsWhatItHoldsAndReadsAgainWithOtherUnits();
  void asksForWhatCannotBeSeen();

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
}

void ImportDialogTest::asksForWhatCannotBeSeen() {
  std::string text = "time";
  for (int i = 0; i < 17; ++i) text += ",r" + std::to_string(i);
  text += "\n0";
  for (int i = 0; i < 17; ++i) text += "," + std::to_string(5 + i);
  ImportDialog dialog({written("b.csv", text + "\n")});
  QTRY_VERIFY2(wordsOf(dialog).startsWith("--angles"), qPrintable(wordsOf(dialog)));
  auto* import = dialog.findChild<QDialogButtonBox*>()->buttons().constLast();
  QVERIFY(!dialog.log());
  auto* angles = dialog.findChild<QLineEdit*>("import_angles");
  angles->setText("0:5");
  Q_EMIT angles->editingFinished();
  QTRY_VERIFY(dialog.log());
  QVERIFY(import->isEnabled());
}

}  // namespace handmap

QTEST_MAIN(handmap::ImportDialogTest)
#include "import_dialog_test.moc"
