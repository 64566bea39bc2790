# Headers of others that most files read, parsed once for all targets that are compiled alike: most of
# what a small file costs. Every file still includes what it uses itself: clang (./dev lint and fuzz) and
# a build with CMAKE_DISABLE_PRECOMPILE_HEADERS do without.
set(precompiled_core
  <algorithm> <array> <chrono> <cmath> <cstdint> <deque> <filesystem> <functional> <limits> <map> <memory>
  <mutex> <numeric> <optional> <set> <span> <stop_token> <string> <string_view> <unordered_map> <utility>
  <vector> <fmt/format.h> <Eigen/Cholesky> <Eigen/Geometry> <nlohmann/json.hpp> <opencv2/core/mat.hpp>)
set(precompiled_core_of fmt::fmt Eigen3::Eigen nlohmann_json::nlohmann_json opencv_core)
set(precompiled_qt
  <QByteArray> <QCoreApplication> <QElapsedTimer> <QFile> <QJsonObject> <QObject> <QString> <QTimer>)
set(precompiled_widgets
  <QAction> <QApplication> <QCheckBox> <QComboBox> <QFileInfo> <QFormLayout> <QGraphicsItem> <QGraphicsScene>
  <QGraphicsView> <QHash> <QHeaderView> <QImage> <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QLocale>
  <QMainWindow> <QMenu> <QMouseEvent> <QPainter> <QPushButton> <QSet> <QSettings> <QTableWidget> <QToolBar>
  <QToolButton> <QUndoStack> <QVBoxLayout>)

# The target that owns what is parsed; others take it by handmap_use_precompiled(). GCC
# takes it where the same or more macros are defined, so it has none of its own.
function(handmap_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "OF;HEADERS")
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "// Nothing but the headers.\n")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE handmap_options ${arg_OF})
  if(Qt6::Core IN_LIST arg_OF)
    target_compile_definitions(${name} PRIVATE QT_NO_KEYWORDS)
  endif()
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  set_target_properties(${name} PROPERTIES handmap_of "${arg_OF}")
endfunction()

function(handmap_use_precompiled target precompiled)
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
  get_target_property(libraries ${precompiled} handmap_of)
  target_link_libraries(${target} PRIVATE ${libraries})
endfunction()
