// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QHeaderView>
#include <QtTest>

#include "app/studio/inspector_panel.h"
#include "app/studio/table_panel.h"
#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

class TablesTest : public WindowFixture {
 protected:
  QTableView* Table(const char* title) { return Find<QTableView>(Raise(title)); }

  int NumRows(const char* title) { return Table(title)->model()->rowCount(); }

  /// The text in a row that is shown, under the heading that begins like `column`.
  std::string CellText(QTableView* table, int row, const QString& column) {
    const QAbstractItemModel& model = *table->model();
    for (int i = 0; i < model.columnCount(); ++i) {
      if (!model.headerData(i, Qt::Horizontal).toString().startsWith(column)) continue;
      return model.index(row, i).data().toString().toStdString();
    }
    ADD_FAILURE() << "no column " << column.toStdString();
    return "";
  }

  void ClickRow(QTableView* table, int row, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(table->viewport(), Qt::LeftButton, modifiers, MiddleOf(table, row));
    WaitUntilIdle();
  }

  void DoubleClickRow(QTableView* table, int row) {
    ClickRow(table, row);
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, MiddleOf(table, row));
    WaitUntilIdle();
  }

  /// As a person does.
  void TypeQuery(const char* title, const QString& query) {
    auto* const line = Find<QLineEdit>(Raise(title));
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, query);
    QTest::keyClick(line, Qt::Key_Return);
    WaitUntilIdle();
  }

  std::string InspectorText() {
    QStringList text;
    auto* const inspector = window().findChild<InspectorPanel*>();
    for (QTreeWidgetItemIterator item(inspector); *item != nullptr; ++item) {
      for (int i = 0; i < inspector->columnCount(); ++i) text.append((*item)->text(i));
    }
    return text.join("|").toStdString();
  }

 private:
  static QPoint MiddleOf(QTableView* table, int row) {
    return table->visualRect(table->model()->index(row, 1)).center();
  }
};

TEST_F(TablesTest, AClickedLoopIsSelectedAndInspected) {
  OpenSmallLoop();
  QTableView* const table = Table("Loops");
  ASSERT_GT(table->model()->rowCount(), 2);
  const int step = state().step;
  ClickRow(table, 2);
  ASSERT_TRUE(state().node && state().submap);
  EXPECT_EQ(std::to_string(state().node->index), CellText(table, 2, "node"));
  EXPECT_EQ(std::to_string(state().submap->index), CellText(table, 2, "submap"));
  EXPECT_EQ(state().step, step);
  EXPECT_THAT(InspectorText(), testing::HasSubstr("more than " + CellText(table, 2, "min score")));
  EXPECT_THAT(InspectorText(), testing::HasSubstr("(0, " + CellText(table, 2, "node") + ")"));
  ExpectWindow("loop_selected");
}

TEST_F(TablesTest, ADoubleClickOnALoopGoesToItsStepAndFramesIt) {
  OpenSmallLoop();
  TypeQuery("Loops", "verdict = closed");
  QTableView* const table = Table("Loops");
  DoubleClickRow(table, 1);
  EXPECT_EQ(std::to_string(state().step), CellText(table, 1, "applied"));
  EXPECT_TRUE(state().views.at(ViewKind::kMap).camera.has_value());
  const auto candidate = session().SelectedCandidate();
  ASSERT_TRUE(candidate.has_value());
  EXPECT_EQ(session().recording().candidates()[*candidate].verdict, Verdict::kAccepted);
  ExpectWindow("loop_framed");
}

TEST_F(TablesTest, SeveralClickedLoopsAreMarkedAtOnce) {
  OpenSmallLoop();
  TypeQuery("Loops", "verdict = closed");
  Play({"view.graph"});
  QTableView* const table = Table("Loops");
  ClickRow(table, 3);
  ClickRow(table, 0, Qt::ControlModifier);
  ClickRow(table, 1, Qt::ControlModifier);
  EXPECT_EQ(std::to_string(state().node->index), CellText(table, 1, "node")) << "the last one";
  EXPECT_EQ(state().loops.size(), 2u);
  EXPECT_EQ(table->selectionModel()->selectedRows().size(), 3);
  ExpectWindow("loops_marked");
  ClickRow(table, 2);
  EXPECT_TRUE(state().loops.empty());
}

TEST_F(TablesTest, ATypedFilterListsTheRowsThatFit) {
  OpenSmallLoop();
  const auto& candidates = session().recording().candidates();
  const auto count = [&](Verdict verdict) {
    return std::count_if(candidates.begin(), candidates.end(),
                         [&](const LoopCandidate& c) { return c.verdict == verdict; });
  };
  EXPECT_EQ(NumRows("Loops"), candidates.size() - count(Verdict::kNotSampled));
  TypeQuery("Loops", "verdict = closed");
  EXPECT_EQ(NumRows("Loops"), count(Verdict::kAccepted));
  EXPECT_EQ(state().tables.at(TableKind::kLoops).filter, "verdict = closed");
  Find<QLineEdit>(Raise("Loops"))->clear();
  WaitUntilIdle();
  EXPECT_EQ(NumRows("Loops"), candidates.size());
}

TEST_F(TablesTest, LettersTypedIntoAFilterAreNoCommands) {
  OpenSmallLoop();
  const int step = state().step;
  TypeQuery("Nodes", "hlrof123 ?");
  EXPECT_EQ(state().step, step);
  EXPECT_EQ(state().tiles, std::vector<ViewKind>{ViewKind::kMap});
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_F(TablesTest, AFilterThatMakesNoSenseIsToldBesideIt) {
  OpenSmallLoop();
  const int num_rows = NumRows("Nodes");
  TypeQuery("Nodes", "time >");
  EXPECT_EQ(window().message(), "");
  EXPECT_EQ(NumRows("Nodes"), num_rows);
  const auto labels = Raise("Nodes")->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [](QLabel* label) { return label->text().contains("expected"); }));
  ExpectWindow("filter_wrong");
}

TEST_F(TablesTest, AFilterThatMakesNoSenseStaysHarmlessInAnotherRun) {
  OpenSmallLoop();
  TypeQuery("Nodes", "time >");
  window().Run("file.open " + CopyOfLog());
  WaitUntilIdle();
  Screenshot();
  EXPECT_EQ(NumRows("Nodes"), 0);
  TypeQuery("Nodes", "time > 0");
  EXPECT_EQ(NumRows("Nodes"), session().recording().nodes().size() - 1);
}

TEST_F(TablesTest, ClicksOnAHeadingSortUpAndDown) {
  OpenSmallLoop();
  QTableView* const table = Table("Loops");
  QHeaderView* const header = table->horizontalHeader();
  const QPoint score(header->sectionViewportPosition(4) + 10, header->height() / 2);
  for (const bool descending : {false, true}) {
    QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, score);
    WaitUntilIdle();
    const TableSettings& settings = state().tables.at(TableKind::kLoops);
    EXPECT_EQ(settings.sort_by, "score");
    EXPECT_EQ(settings.descending, descending);
    const double first = std::stod(CellText(table, 0, "score"));
    const double second = std::stod(CellText(table, 1, "score"));
    EXPECT_TRUE(descending ? first >= second : first <= second);
  }
}

TEST_F(TablesTest, WhatIsSelectedByACommandIsTheRowInTheTable) {
  OpenSmallLoop();
  QTableView* const submaps = Table("Submaps");
  Play({"select.submap 2"});
  EXPECT_EQ(CellText(submaps, submaps->currentIndex().row(), "index"), "2");
  Play({"select.none"});
  EXPECT_FALSE(submaps->currentIndex().isValid());
}

TEST_F(TablesTest, TheTablesOfSubmapsAndNodesListThoseOfTheRun) {
  OpenSmallLoop();
  EXPECT_EQ(NumRows("Submaps"), session().recording().submaps().size());
  ExpectWidget(Raise("Submaps"), "submaps");
  EXPECT_EQ(NumRows("Nodes"), session().recording().nodes().size());
  ExpectWidget(Raise("Nodes"), "nodes");
}

}  // namespace
}  // namespace loopscope
