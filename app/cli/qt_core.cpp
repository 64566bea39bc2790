#include "app/cli/qt_core.h"

#include <clocale>

namespace handmap {

std::unique_ptr<QCoreApplication> qtCore() {
  static int count = 1;
  static char name[] = "handmap-cli";
  static char* names[] = {name, nullptr};
  auto application = std::make_unique<QCoreApplication>(count, names);
  std::setlocale(LC_ALL, "C");  // Qt takes that of the person
  return application;
}

}  // namespace handmap
