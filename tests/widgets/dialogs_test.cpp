#include "widgets/messages/dialogs.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidget>

namespace handmap {

class DialogsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSavedHasTheEndingOfTheChosenKind();
  void aNameWithAnotherEndingGetsTheRightOne();
  void whatIsTypedReplacesWhatIsProposed();
};

void DialogsTest::whatIsSavedHasTheEndingOfTheChosenKind() {
  const QTemporaryDir folder;
  QWidget window;
  QTimer::singleShot(0, &window, [&window] {
    auto* dialog = window.findChild<QFileDialog*>();
    QVERIFY(dialog);
    auto* kinds = dialog->findChild<QComboBox*>("fileTypeCombo");
    QVERIFY(kinds);
    QTest::keyClick(kinds, Qt::Key_Down);
    static_cast<QDialog*>(dialog)->accept();
  });
  const QString path = systemDialogs(window)->fileToSave(
      {"Save", folder.path(), "A (*.a);;B (*.bb *.c)", "town.a", "a"});
  QCOMPARE(path, folder.filePath("town.bb"));
}

void DialogsTest::aNameWithAnotherEndingGetsTheRightOne() {
  const QTemporaryDir folder;
  QWidget window;
  const auto saved = [&](const QString& typed) {
    QTimer::singleShot(0, &window, [&window, typed] {
      auto* dialog = window.findChild<QFileDialog*>();
      QVERIFY(dialog);
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(typed);
      static_cast<QDialog*>(dialog)->accept();
    });
    return systemDialogs(window)->fileToSave(
        {"Save", folder.path(), "A (*.a);;B (*.b *.x.b)", "town.a", "a"});
  };
  QCOMPARE(saved("Campus v1.2"), folder.filePath("Campus v1.2.a"));
  QCOMPARE(saved("town"), folder.filePath("town.a"));
  QCOMPARE(saved("town.B"), folder.filePath("town.B"));
  QFile there(folder.filePath("page.html.a"));
  QVERIFY(there.open(QIODevice::WriteOnly));
  QTimer::singleShot(300, &window, [] {
    auto* question = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    QVERIFY(question);
    question->reject();
  });
  QCOMPARE(saved("page.html"), QString());
}

void DialogsTest::whatIsTypedReplacesWhatIsProposed() {
  QWidget window;
  const auto type = [&window](const QString& text) {
    QTimer::singleShot(0, &window, [&window, text] {
      auto* dialog = window.findChild<QDialog*>();
      QVERIFY(dialog);
      QVERIFY(QTest::qWaitForWindowActive(dialog));
      QTest::keyClicks(dialog->focusWidget(), text);
      dialog->accept();
    });
  };
  type("150");
  QCOMPARE(systemDialogs(window)->numbers("Size", {{"Width", 200.0, 1.0, 1e5, 0, " m"}}),
           QList<double>{150.0});
  type("b.avi");
  QCOMPARE(systemDialogs(window)->typedOrKnown("Camera", "Device", {"/dev/video0"}), "b.avi");
}

}  // namespace handmap

QTEST_MAIN(handmap::DialogsTest)
#include "dialogs_test.moc"
