// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QElapsedTimer>
#include <fstream>
#include <random>
#include <unistd.h>

#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

using SoakTest = WindowFixture;

/// Memory of this program that is in use [MB].
double UsedMegabytes() {
  double total = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE) / 1e6;
}

/// What somebody without a plan does.
class Monkey {
 public:
  explicit Monkey(unsigned seed) : random_(seed) {}

  std::string NextLine(const Recording& recording) {
    const int num_nodes = static_cast<int>(recording.nodes().size());
    const int num_submaps = static_cast<int>(recording.submaps().size());
    const int num_loops = static_cast<int>(recording.candidates().size());
    switch (Below(15)) {
      case 0:
        return OneOf({"view.map", "view.submap", "view.update", "view.match", "view.search",
                      "view.graph", "view.time", "view.chart", "chart.kind residuals",
                      "chart.kind score-histogram"});
      case 1:
        return OneOf({"tiles.one", "tiles.two", "tiles.four", "tile.next"});
      case 2:
        return OneOf({"select.pair " + Number(num_nodes) + " " + Number(num_submaps),
                      "select.loops " + Number(num_loops) + " " + Number(num_loops)});
      case 3:
        return "go.loop " + Number(num_loops);
      case 4:
        return "camera.set " + Number(10) + " " + Number(8) + " " + Number(40) + ".5";
      case 5:
        return OneOf({"camera.fit", "camera.frame", "select.none", "layer.reset"});
      case 6:
        return OneOf({"table.filter loops score > 0.6", "table.filter loops verdict = closed",
                      "table.filter nodes time >", "table.filter nodes", "table.filter loops",
                      "table.sort nodes time", "table.sort_down loops residual"});
      case 7:
        return OneOf({"layer.toggle grid", "layer.toggle trajectory", "layer.toggle scan",
                      "layer.toggle inter", "window.dark", "window.light"});
      case 8:
        return OneOf({"edit.undo", "edit.undo", "edit.redo"});
      case 9:
        return OneOf({"search.visits 7", "search.visits", "search.height 2", "search.angle 1",
                      "search.all", "layer.opacity grid 0.3", "layer.opacity grid 1"});
      case 10:
        return OneOf(
            {"theme.color_blind", "theme.default", "event.next", "event.previous", "play.toggle"});
      default:
        return "step.seek " + Number(recording.num_steps());
    }
  }

 private:
  int Below(int count) { return std::uniform_int_distribution<>(0, count - 1)(random_); }
  std::string Number(int count) { return std::to_string(Below(count)); }
  std::string OneOf(const std::vector<std::string>& lines) {
    return lines[Below(static_cast<int>(lines.size()))];
  }

  std::mt19937 random_;
};

TEST_F(SoakTest, RandomCommandsNeitherCrashNorLeak) {
  constexpr qint64 kMilliseconds = 20000;
  constexpr double kMaxGrowth = 60.0;  // [MB]
  OpenSmallLoop();
  Monkey monkey(1);
  QElapsedTimer time;
  time.start();
  double half_way = 0.0;
  int num_commands = 0;
  while (time.elapsed() < kMilliseconds) {
    window().Run(monkey.NextLine(session().recording()));
    ++num_commands;
    // Mostly faster than pictures come, sometimes with time to look at one.
    if (num_commands % 10 == 0) WaitUntilIdle();
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    if (half_way == 0.0 && time.elapsed() > kMilliseconds / 2) half_way = UsedMegabytes();
  }
  WaitUntilIdle();
  EXPECT_LT(UsedMegabytes() - half_way, kMaxGrowth);
  RecordProperty("commands", num_commands);
  RecordProperty("megabytes", static_cast<int>(UsedMegabytes()));
}

}  // namespace
}  // namespace loopscope
