// What the command tells of long work in a log. The clock is the test's, so nothing waits.
#include "cli/progress_report.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace shatterpave::cli {
namespace {

using std::chrono::seconds;

class Reported : public testing::Test {
 protected:
  std::chrono::steady_clock::time_point now{};
  std::vector<std::string> lines;
  ProgressReport report{[this] { return now; }, [this](const std::string& line) { lines.push_back(line); }};
};

TEST_F(Reported, ShortWorkLeavesTheLogAlone) {
  for (int i = 0; i < 10; ++i) {
    report.take("generating window", 0.1 * i);
    report.tick();
    now += seconds(1);
  }
  EXPECT_TRUE(lines.empty());
}

TEST_F(Reported, LongWorkTellsFromTimeToTime) {
  report.take("generating window", 0.0);
  for (int second = 0; second <= 75; ++second) {
    report.tick();
    if (second == 25) report.take("rendering", 0.4);
    now += seconds(1);
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"generating window: 0 %, 10 s\n", "rendering: 40 %, 30 s\n",
                                             "rendering: 40 %, 50 s\n", "rendering: 40 %, 70 s\n"}));
}

TEST_F(Reported, AThousandStepsASecondMakeNoMoreLines) {
  for (int step = 0; step < 40'000; ++step) {
    report.take("measuring", step / 40'000.0);
    now += std::chrono::milliseconds(1);
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"measuring: 25 %, 10 s\n", "measuring: 75 %, 30 s\n"}));
}

// Nothing is done before all is done, whatever is reported.
TEST_F(Reported, PartsStayWithinTheWhole) {
  now += seconds(10);
  report.take("measuring", 0.999);
  now += seconds(20);
  report.take("measuring", 1.7);
  EXPECT_EQ(lines, (std::vector<std::string>{"measuring: 99 %, 10 s\n", "measuring: 100 %, 30 s\n"}));
}

TEST_F(Reported, NothingIsToldBeforeAnythingIsDone) {
  now += seconds(60);
  report.tick();
  EXPECT_TRUE(lines.empty());
}

}  // namespace
}  // namespace shatterpave::cli
