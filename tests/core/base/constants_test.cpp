// The numbers of the method's rooms: one header a room, each with its unit and its source.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include <gtest/gtest.h>

namespace handmap {
namespace {

namespace fs = std::filesystem;

/// `most` can only fall. Rooms of the method that are not here yet have their numbers where they
/// are used.
struct Room {
  const char* folder;
  std::size_t most;
};
constexpr Room kRooms[] = {{"core/map_match", 33},
                           {"core/outlines", 97},
                           {"core/explain", 15},
                           {"core/estimation/drawing", 5},
                           {"core/estimation/loops", 5},
                           {"core/estimation/labels", 21},
                           {"core/trajectory", 94},
                           {"core/pose_graph", 6},
                           {"core/perception", 68},
                           {"core/odometry", 48},
                           {"core/estimation", 29},
                           {"core/estimation/buildings", 51},
                           {"core/estimation/smoothing", 36},
                           {"core/estimation/walls", 41},
                           {"core/method", 40},
                           {"core/tape", 2}};

const std::regex kNumber(
    R"((?:^|\n)[ \t]*(?:(?:static|inline)[ \t]+)*constexpr[ \t]+)"
    R"((?:static[ \t]+|const[ \t]+)*(?:double|float|int|auto|(?:std::)?u?int\d+_t|)"
    R"(std::size_t|std::ptrdiff_t|long|std::array\b[^\n=]*?)[ \t]+(k[A-Z]\w*)(?:\[\w*\])?\s*[={][^;]*;([^\n]*(?:\n[ \t]*//[^\n]*)*))");
const std::regex kMember(R"(\n[ \t]*\.(\w+) = [^,;}\n]*[,;}]+([^\n]*(?:\n[ \t]*//[^\n]*)*))");
const std::regex kStruct(
    R"((?:^|\n)[^\n/]*constexpr[ \t]+(?:\w+::)*[A-Z]\w*[ \t]+(k[A-Z]\w*)\s*[={])");
const std::regex kSourced(R"(^\s*//\s*[^\s;]+; (choice|derived|limit|measured|paper): \S)");

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

struct Number {
  std::string name;
  std::string comment;
};

std::vector<Number> foundIn(const std::string& source, const std::regex& number) {
  std::vector<Number> numbers;
  for (std::sregex_iterator at(source.begin(), source.end(), number), end; at != end; ++at) {
    numbers.push_back({(*at)[1], (*at)[2]});
  }
  return numbers;
}

std::vector<Number> numbersIn(const std::string& source) { return foundIn(source, kNumber); }

/// And each member of what holds several.
std::vector<Number> numbersOfHeader(const fs::path& header) {
  const std::string source = contentOf(header);
  std::vector<Number> numbers = numbersIn(source);
  const std::vector<Number> members = foundIn(source, kMember);
  numbers.insert(numbers.end(), members.begin(), members.end());
  return numbers;
}

TEST(Constants, AreFoundHoweverTheyAreWritten) {
  const auto numbers = numbersIn(
      "constexpr double kA = 1.0;\n"
      "  static constexpr int kB{2};  // m; choice: so\n"
      "inline constexpr std::array<double, 2> kC = {1.0, 2.0};\n"
      "constexpr std::array kD{1.0};\n"
      "inline constexpr std::size_t kE = 1;  // s;\n    // choice: more\n"
      "constexpr auto kF = 3.0F;\nconstexpr double kG[] = {1.0};\nconstexpr double f(double x) { "
      "return x; }\n");
  ASSERT_EQ(numbers.size(), 7U);
  EXPECT_TRUE(std::regex_search(numbers[1].comment, kSourced));
  EXPECT_FALSE(std::regex_search(numbers[0].comment, kSourced));
  const auto members =
      foundIn("constexpr Noise kN{\n    .a = 0.1,  // m; choice: so\n    .b = 2e-5};\n", kMember);
  ASSERT_EQ(members.size(), 2U);
  EXPECT_TRUE(std::regex_search(members[0].comment, kSourced));
  EXPECT_FALSE(std::regex_search(members[1].comment, kSourced));
  EXPECT_EQ(foundIn("  constexpr Room::Noise kN{1.0};\n", kStruct).size(), 1U);
}

TEST(Constants, StandInOneHeaderOfTheirRoomWithUnitAndSource) {
  const fs::path sources = HANDMAP_SOURCES;
  for (const auto& [room, most] : kRooms) {
    const fs::path header = sources / room / "constants.h";
    const std::vector<Number> numbers = numbersOfHeader(header);
    EXPECT_FALSE(numbers.empty()) << room;
    EXPECT_LE(numbers.size(), most) << room;
    for (const Number& number : numbers) {
      EXPECT_TRUE(std::regex_search(number.comment, kSourced))
          << room << "/constants.h: " << number.name << ": found \"" << number.comment
          << "\", expected // UNIT; choice, derived, limit, measured or paper: WHERE FROM";
    }
    for (const auto& entry : fs::directory_iterator(sources / room)) {
      const bool is_source = entry.path().extension() == ".h" || entry.path().extension() == ".cpp";
      if (!is_source || entry.path() == header) continue;
      const std::string content = contentOf(entry.path());
      for (const auto& kind : {kNumber, kStruct}) {
        for (const Number& number : foundIn(content, kind)) {
          ADD_FAILURE() << entry.path().string() << ": found " << number.name << ", expected it in "
                        << header.string();
        }
      }
    }
  }
}

}  // namespace
}  // namespace handmap
