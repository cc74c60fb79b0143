// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/studio/window_fixture.h"

#include <QApplication>
#include <QSettings>
#include <QTabBar>
#include <QtTest>
#include <cstring>
#include <filesystem>

#include "app/studio/theme.h"
#include "app/studio/tile.h"
#include "core/io/carmen_writer.h"
#include "core/io/recording_file.h"
#include "tests/render/pictures/expect_picture.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

constexpr int kTimeoutMilliseconds = 30000;
const char kResults[] = LOOPSCOPE_BINARY_DIR "/pictures/studio";

Picture PictureOf(const QImage& any_image) {
  const QImage image = any_image.convertToFormat(QImage::Format_RGB888);
  Picture picture{image.width(), image.height(), {}};
  const std::size_t row_size = 3 * static_cast<std::size_t>(picture.width);
  picture.rgb.resize(row_size * picture.height);
  for (int y = 0; y < picture.height; ++y) {
    std::memcpy(&picture.rgb[y * row_size], image.constScanLine(y), row_size);
  }
  return picture;
}

/// A button that fades in, for one, looks like nothing in particular meanwhile.
void WaitForAnimations(QWidget* widget) {
  const bool rests = QTest::qWaitFor(
      [&] {
        const auto animations = widget->findChildren<QAbstractAnimation*>();
        return std::none_of(animations.begin(), animations.end(),
                            [](QAbstractAnimation* animation) {
                              return animation->state() == QAbstractAnimation::Running;
                            });
      },
      kTimeoutMilliseconds);
  EXPECT_TRUE(rests) << "something moves without end";
}

/// Where the files are that all tests of the program read.
const TemporaryFolder& SharedFolder() {
  static const TemporaryFolder folder;
  return folder;
}

const ScanLog& SmallLoop() {
  static const ScanLog log = SimulateSmallLoop().log;
  return log;
}

std::string CopyInto(const TemporaryFolder& folder, const std::filesystem::path& file) {
  const std::string copy = folder.Path(file.filename().string());
  std::filesystem::copy_file(file, copy);
  return copy;
}

}  // namespace

WindowFixture::WindowFixture() {
  QSettings().clear();
  OpenWindowAnew();
}

WindowFixture::~WindowFixture() { CloseWindow(); }

void WindowFixture::OpenWindowAnew() {
  CloseWindow();
  ApplyWindowTheme(QSettings().value("theme", "light").toString());
  QCursor::setPos(1279, 799);  // where it points at nothing
  window_ = std::make_unique<MainWindow>();
  window_->setFixedSize(1280, 800);
  window_->show();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  WaitUntilIdle();
}

void WindowFixture::CloseWindow() {
  if (window_) window_->close();
  window_.reset();
}

void WindowFixture::Play(std::initializer_list<std::string> lines) {
  for (const std::string& line : lines) {
    SCOPED_TRACE(line);
    window_->Run(line);
    WaitUntilIdle();
    ASSERT_EQ(window_->message(), "");
  }
}

void WindowFixture::OpenSmallLoop() { Play({"file.open " + SmallLoopRecording()}); }

void WindowFixture::WaitFor(const std::function<bool()>& condition, const char* what) {
  ASSERT_TRUE(QTest::qWaitFor(condition, kTimeoutMilliseconds)) << "waited in vain until " << what;
}

void WindowFixture::WaitUntilIdle() {
  WaitFor([this] { return window_->IsIdle(); }, "the window is idle");
  QApplication::processEvents();
}

Picture WindowFixture::Screenshot() {
  WaitForAnimations(window_.get());
  return PictureOf(window_->grab().toImage());
}

Picture WindowFixture::ViewPicture(int tile) { return PictureOf(View(tile)->grabFramebuffer()); }

void WindowFixture::ExpectSame(const Picture& actual, const Picture& expected,
                               const std::string& name) {
  const PictureComparison comparison = Compare(actual, expected);
  if (comparison.equal) return;
  std::filesystem::create_directories(kResults);
  WriteComparison(actual, expected, kResults, name);
  ADD_FAILURE() << name << ": " << 100.0 * comparison.differing_share << " % of the pixels differ";
}

void WindowFixture::ExpectWindow(const std::string& name) { ExpectWidget(window_.get(), name); }

void WindowFixture::ExpectWidget(QWidget* widget, const std::string& name) {
  WaitForAnimations(widget);
  ExpectPicture(PictureOf(widget->grab().toImage()), name,
                {LOOPSCOPE_SOURCE_DIR "/tests/baselines/studio", kResults});
}

QWidget* WindowFixture::Raise(const char* title) {
  for (QTabBar* const bar : window_->findChildren<QTabBar*>()) {
    for (int i = 0; i < bar->count(); ++i) {
      if (bar->tabText(i) != title) continue;
      QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
      WaitUntilIdle();
    }
  }
  auto* const dock = window_->findChild<QDockWidget*>(title);
  EXPECT_TRUE(dock != nullptr && dock->widget()->isVisible()) << title;
  return dock->widget();
}

ViewWidget* WindowFixture::View(int tile) {
  return window_->findChildren<Tile*>().at(tile)->view();
}

const std::string& WindowFixture::SmallLoopRecording() {
  static const std::string path = [] {
    const std::string file = SharedFolder().Path("small_loop.loopscope");
    RecordingWriter writer(file, SmallLoop(), SmallLoopOptions());
    Slam slam(SmallLoop(), SmallLoopOptions(), 1);
    for (int scan = 0; scan < static_cast<int>(SmallLoop().scans.size()); ++scan) {
      writer.Append(slam.AddScan(scan));
    }
    writer.Finish(1.0);
    return file;
  }();
  return path;
}

const std::string& WindowFixture::SmallLoopLog() {
  static const std::string path = [] {
    const std::string file = SharedFolder().Path("small_loop.log");
    WriteCarmenLog(file, SmallLoop());
    return file;
  }();
  return path;
}

std::string WindowFixture::CopyOfLog() const { return CopyInto(folder_, SmallLoopLog()); }

std::string WindowFixture::CopyOfLongLog() const {
  return CopyInto(folder_, LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz");
}

}  // namespace loopscope
