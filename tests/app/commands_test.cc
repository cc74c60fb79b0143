// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/geometry/pose2.h"
#include "core/io/recording_file.h"
#include "core/io/tum_file.h"
#include "render/picture.h"
#include "tests/app/command_test.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, InfoTellsOfLogs) {
  const ProgramRun run = Run("info a.log");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("100 in 19.8 s"));
  EXPECT_THAT(run.out, HasSubstr("361, 0.5 deg apart, from -90 deg to 90 deg"));
}

TEST_F(CommandTest, InfoTellsWhereTheScannerIsWithoutTheNoiseOfDifferences) {
  folder_.Write("turned.log",
                "ROBOTLASER1 0 -1.57 3.14 1.57 10 0.01 0 3 1 2 3 0 "
                "1.1000003 2.0000001 0.5 1.0 2.0 0.5 0 0 0 0 0 7.0 h 7.0\n");
  const ProgramRun run = Run("info turned.log");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("scanner    x 0.0878 m, y -0.0479 m, turned 0 deg"));
}

TEST_F(CommandTest, InfoTellsOfRecordings) {
  const ProgramRun run = Run("info run.loopscope");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("100 of 100 scans, finished in "));
  EXPECT_THAT(run.out, HasSubstr("matches    1 nowhere: not matched, first at scan 0\n"));
  EXPECT_THAT(run.out, HasSubstr("matches    99 where predicted\n"));
  EXPECT_THAT(run.out, HasSubstr("loopscope, but for:"));
  EXPECT_THAT(run.out, HasSubstr("TRAJECTORY_BUILDER_2D.submaps.num_range_data = 10"));
  EXPECT_THAT(run.out, Not(HasSubstr("POSE_GRAPH.constraint_builder.min_score")));
  EXPECT_THAT(Run("info run.loopscope --options").out,
              HasSubstr("POSE_GRAPH.constraint_builder.min_score"));
}

TEST_F(CommandTest, InfoRefusesWhatIsNeither) {
  folder_.Write("text.txt", "hello\n");
  ExpectRefused("info text.txt", "text.txt: no scan; expected a CARMEN log");
  ExpectRefused("info none", "none: cannot be opened: No such file");
}

TEST_F(CommandTest, RecordingsOfANewerSchemaOrCutOffAreRefusedByAll) {
  std::filesystem::copy(folder_.Path("run.loopscope"), folder_.Path("newer.loopscope"));
  SQLite::Database(folder_.Path("newer.loopscope"), SQLite::OPEN_READWRITE)
      .exec("PRAGMA user_version = 99");
  const std::string whole = ContentOf(folder_.Path("run.loopscope"));
  folder_.Write("cut.loopscope", whole.substr(0, whole.size() / 2));
  for (const std::string command :
       {"info %", "render %", "search % --node 1 --submap 0", "why % --node 1 --submap 0",
        "loops %", "evaluate % --reference a.tum", "export % --map m"}) {
    for (const std::string file : {"newer.loopscope", "cut.loopscope"}) {
      std::string arguments = command;
      arguments.replace(arguments.find('%'), 1, file);
      folder_.Write("a.tum", "0 0 0 0 0 0 0 1\n");
      ExpectRefused(arguments, file + ": ");
    }
  }
  ExpectRefused("info newer.loopscope", "schema 99, made by a newer Loopscope; expected at most 6");
}

TEST_F(CommandTest, SearchPrintsNumbersAndTreeAndDraws) {
  const ProgramRun run =
      Run("search run.loopscope --node 50 --submap 0 --min-score 0.1 -o s.png --size 400x300");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("node (0, 50), submap (0, 0)"));
  EXPECT_THAT(run.out, HasSubstr("way to the winner:"));
  EXPECT_EQ(ReadPng(folder_.Path("s.png")).width, 400);
}

TEST_F(CommandTest, SearchThatFindsNothingExitsWithOne) {
  EXPECT_EQ(Run("search run.loopscope --node 50 --submap 0 --min-score 0.95").exit_code, 1);
}

TEST_F(CommandTest, SearchPrintsTheWholeTreeAsJson) {
  const auto json = nlohmann::json::parse(
      Run("search run.loopscope --node 50 --submap 0 --min-score 0.1 --json").out);
  const auto& nodes = json.at("nodes");
  const int winner = json.at("winner");
  ASSERT_GE(winner, 0);
  EXPECT_EQ(nodes.at(winner).at("height"), 0);
  EXPECT_EQ(Rounded(nodes.at(winner).at("bound").get<double>()), json.at("score"));
}

TEST_F(CommandTest, SearchRefusesPairsThatCannotBeSearched) {
  ExpectRefused("search run.loopscope --node 50 --submap 99", "there is no submap 99");
  ExpectRefused("search run.loopscope --node 9999 --submap 0", "there is no node 9999");
  ExpectRefused("search run.loopscope --node 1 --submap 0", "expected a finished submap");
  ExpectRefused("search run.loopscope --node 50 --submap 0 --min-score nan", "expected a number");
}

TEST_F(CommandTest, WhyAnswersWithItsExitCode) {
  const ProgramRun far_away = Run("why run.loopscope --node 53 --submap 0");
  EXPECT_EQ(far_away.exit_code, 1);
  EXPECT_THAT(far_away.out, HasSubstr("Not closed: too far apart"));
  EXPECT_THAT(far_away.out, HasSubstr("\nAnywhere in the submap the best place scores 0."));
  const Recording recording = ReadRecording(folder_.Path("run.loopscope"));
  const auto& candidates = recording.candidates();
  const auto closed = std::find_if(candidates.begin(), candidates.end(), [](const auto& candidate) {
    return candidate.verdict == Verdict::kAccepted;
  });
  ASSERT_NE(closed, candidates.end());
  EXPECT_EQ(Run("why run.loopscope --node " + std::to_string(closed->node.index) + " --submap " +
                std::to_string(closed->submap.index))
                .exit_code,
            0);
  ExpectRefused("why run.loopscope --node 9999 --submap 0", "there is no node 9999");
}

TEST_F(CommandTest, SearchLooksEverywhereInTheSubmapIfAsked) {
  const std::string pair = "search run.loopscope --node 50 --submap 0 --whole-submap";
  const ProgramRun run = Run(pair + " --min-score 0.1");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("everywhere in the submap, at every angle"));
  EXPECT_THAT(run.out, HasSubstr("from the guess"));
  const auto window = nlohmann::json::parse(
      Run("search run.loopscope --node 50 --submap 0 --min-score 0.1 --json").out);
  const auto whole = nlohmann::json::parse(Run(pair + " --min-score 0.1 --json").out);
  EXPECT_GE(whole.at("score"), window.at("score"));
  EXPECT_EQ(Run(pair + " --min-score 0.89").exit_code, 1);
  EXPECT_EQ(Run(pair + " -o s.png").exit_code, 2);
}

TEST_F(CommandTest, LoopsListsTheSamePairsInEveryFormat) {
  const std::size_t num_candidates =
      ReadRecording(folder_.Path("run.loopscope")).candidates().size();
  ASSERT_GT(num_candidates, 0u);
  const auto num_lines = [](const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  EXPECT_EQ(num_lines(Run("loops run.loopscope").out), num_candidates + 1);
  EXPECT_EQ(num_lines(Run("loops run.loopscope --csv").out), num_candidates + 1);
  EXPECT_EQ(nlohmann::json::parse(Run("loops run.loopscope --json").out).size(), num_candidates);
}

TEST_F(CommandTest, LoopsRefusesNodesAndSubmapsThatAreNotThere) {
  ExpectRefused("loops run.loopscope --node -1", "there is no node -1; expected 0 to ");
  ExpectRefused("loops run.loopscope --submap 999", "there is no submap 999; expected 0 to ");
}

TEST_F(CommandTest, LoopsLeavesEmptyInCsvWhatAPairHasNotThatWasNotSearched) {
  const std::string csv = Run("loops run.loopscope --csv --verdict 'not sampled'").out;
  EXPECT_THAT(csv, HasSubstr(",not sampled,,,,,,,,,,,,,skipped by sampling_ratio\n"));
}

TEST_F(CommandTest, LoopsTellWhetherAClosedLoopHeld) {
  const auto json = nlohmann::json::parse(Run("loops run.loopscope --json --verdict closed").out);
  ASSERT_FALSE(json.empty());
  for (const auto& loop : json) {
    EXPECT_EQ(loop.at("held"), loop.at("residual_m") < 0.3) << loop;
    EXPECT_EQ(loop.at("reason"), "passed every gate");
  }
}

TEST_F(CommandTest, LoopsTellHowFarASearchMovedTheNode) {
  const Recording recording = ReadRecording(folder_.Path("run.loopscope"));
  const auto json = nlohmann::json::parse(Run("loops run.loopscope --json").out);
  double most_degrees = 0.0;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    ASSERT_EQ(json[i].contains("moved_m"),
              candidate.verdict == Verdict::kAccepted || IsRefused(candidate.verdict));
    if (!json[i].contains("moved_m")) continue;
    const double moved = json[i].at("moved_m");
    EXPECT_NEAR(moved,
                (candidate.submap_from_node_searched.translation -
                 candidate.submap_from_node_guess.translation)
                    .norm(),
                1e-9);
    most_degrees = std::max(most_degrees, json[i].at("moved_deg").get<double>());
  }
  EXPECT_GT(most_degrees, 0.1);
  EXPECT_LT(most_degrees, 5.0);
}

TEST_F(CommandTest, EvaluateMeasuresAgainstRelationsAndReference) {
  const std::string truth = LOOPSCOPE_SOURCE_DIR "/datasets/office";
  const ProgramRun run = Run("evaluate run.loopscope " + truth + ".tum --json --reference " +
                             truth + ".tum --max-error 0.1");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_GT(json[0].at("ate_rmse_m"), 1e-6);
  EXPECT_LT(json[0].at("ate_rmse_m"), 0.05);
  EXPECT_LT(json[1].at("ate_rmse_m"), 1e-9);
  EXPECT_EQ(Run("evaluate run.loopscope --max-error 1e-6 --reference " + truth + ".tum").exit_code,
            1);
  EXPECT_THAT(Run("evaluate " + truth + ".tum --relations " + truth + ".relations --csv").out,
              HasSubstr("run,relations,translation_mean_m"));
  std::filesystem::copy(truth + ".tum", folder_.Path("a,b.tum"));
  EXPECT_THAT(Run("evaluate a,b.tum --relations " + truth + ".relations --csv").out,
              HasSubstr("\n\"a,b.tum\",166,"));
}

TEST_F(CommandTest, EvaluatePrintsALineForEachRun) {
  const std::string truth = LOOPSCOPE_SOURCE_DIR "/datasets/office";
  const std::string arguments = "evaluate run.loopscope " + truth + ".tum --relations " + truth +
                                ".relations --reference " + truth + ".tum";
  const std::string out = Run(arguments).out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 3);
  EXPECT_EQ(out.find("\nrun.loopscope "), out.find('\n'));
  const std::string last_line = out.substr(out.find("office.tum"));
  EXPECT_THAT(last_line, HasSubstr("0.0000"));
  EXPECT_EQ(last_line.substr(last_line.size() - 3), " -\n");  // a trajectory has no map
}

TEST_F(CommandTest, EvaluateTellsOfARecordingWithoutAnyReference) {
  const auto json = nlohmann::json::parse(Run("evaluate run.loopscope --json").out);
  EXPECT_FALSE(json[0].contains("ate_rmse_m"));
  EXPECT_FALSE(json[0].contains("loop_recall"));
  EXPECT_GT(json[0].at("loops"), 0);
  EXPECT_GT(json[0].at("loops_self_consistent"), 0.9);
  EXPECT_GT(json[0].at("wall_thickness_m"), 0.001);
  EXPECT_LT(json[0].at("wall_thickness_m"), 0.1);
}

TEST_F(CommandTest, EvaluatePlotsErrors) {
  const std::string truth = LOOPSCOPE_SOURCE_DIR "/datasets/office";
  const std::string plot = "evaluate run.loopscope --size 400x300 --plot ";
  ASSERT_EQ(Run(plot + "a.png --reference " + truth + ".tum").exit_code, 0);
  ASSERT_EQ(Run(plot + "b.png --relations " + truth + ".relations").exit_code, 0);
  EXPECT_FALSE(ReadPng(folder_.Path("a.png")) == ReadPng(folder_.Path("b.png")));
  ExpectRefused(plot + "c.png", "no errors to plot; expected --relations or --reference");
  ExpectRefused("evaluate a b --plot c.png", "expected a single RUN");
  ExpectRefused(plot + "c.jpg", "c.jpg");
}

TEST_F(CommandTest, EvaluateListsFalseAndMissedLoops) {
  const std::string arguments =
      "evaluate run.loopscope --loops --reference " LOOPSCOPE_SOURCE_DIR "/datasets/office.tum";
  const auto json = nlohmann::json::parse(Run(arguments + " --json --loop-tolerance 0 0").out);
  EXPECT_EQ(json[0].at("loop_precision"), 0.0);
  EXPECT_EQ(json[0].at("false_loops").size(), json[0].at("loops_in_force"));
  EXPECT_EQ(json[0].at("loops_false"), json[0].at("loops_in_force"));
  EXPECT_LE(json[0].at("loops_false_by_their_scans"), json[0].at("loops_false"));
  EXPECT_GT(json[0].at("false_loops")[0].at("score"), 0.3);
  EXPECT_GT(json[0].at("false_loops")[0].at("score_in_reference"), 0.3);
  EXPECT_THAT(Run(arguments + " --loop-tolerance 0 0").out, HasSubstr("false   submap (0, "));
  EXPECT_THAT(Run(arguments).out, HasSubstr(": 0 of "));
  ExpectRefused(arguments + " --loop-tolerance -1 5", "--loop-tolerance -1 5: expected");
}

TEST_F(CommandTest, EvaluateRefusesWhatItCannotCompare) {
  folder_.Write("way.tum", "5 0 0 0 0 0 0 1\n6 0 0 0 0 0 0 1\n");
  ExpectRefused("evaluate way.tum", "expected --relations or --reference");
  ExpectRefused("evaluate run.loopscope --max-error 1", "expected --relations or --reference");
  ExpectRefused("evaluate run.loopscope --max-error nan", "--max-error");
  ExpectRefused("evaluate run.loopscope --max-error -1", "--max-error");
  ExpectRefused("mop run.loopscope", "no command 'mop': expected map, info, render,");
  ExpectRefused("evaluate run.loopscope --delta 0", "--delta 0: expected metres above 0");
  for (const std::string count : {"1.5", "1e10"}) {
    ExpectRefused("evaluate run.loopscope --delta-unit f --delta " + count, "a number of frames");
  }
  ExpectRefused("evaluate run.loopscope --reference none.tum", "none.tum: cannot be opened");
  folder_.Write("other.tum", "5 0 0 0 0 0 0 1\n6 0 0 0 0 0 0 1\n");
  ExpectRefused("evaluate run.loopscope --reference other.tum", "nothing in common");
  folder_.Write("other.relations", "5 6 1 0 0 0 0 0\n");
  ExpectRefused("evaluate run.loopscope --relations other.relations", "nothing in common");
  ExpectRefused("evaluate a.log --reference other.tum", "a.log:");
}

TEST_F(CommandTest, ExportWritesMapTrajectoryAndGraph) {
  const ProgramRun run =
      Run("export run.loopscope --map map --trajectory nodes.tum --graph graph.g2o");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "map.pgm\nmap.yaml\nnodes.tum\ngraph.g2o\n");
  const Recording recording = ReadRecording(folder_.Path("run.loopscope"));
  EXPECT_EQ(ReadTum(folder_.Path("nodes.tum")).size(), recording.nodes().size());
  EXPECT_THAT(ContentOf(folder_.Path("graph.g2o")), HasSubstr("EDGE_SE2"));
  ASSERT_EQ(Run("export run.loopscope --trajectory dense.tum --dense").exit_code, 0);
  EXPECT_EQ(ReadTum(folder_.Path("dense.tum")).size(), recording.log().odometry.size());
  ASSERT_EQ(Run("export run.loopscope --map raw.pgm --raw --step 50").exit_code, 0);
  EXPECT_THAT(ContentOf(folder_.Path("raw.yaml")), HasSubstr("mode: trinary"));
}

TEST_F(CommandTest, ExportRefusesWhatItCannotDo) {
  ExpectRefused("export run.loopscope", "nothing to export");
  ExpectRefused("export run.loopscope --dense --map m", "--trajectory");
  ExpectRefused("export run.loopscope --map none/m", "none/m.pgm: cannot be written");
  ExpectRefused("export run.loopscope --graph /dev/full", "/dev/full: cannot be written");
  ExpectRefused("export run.loopscope --map m --step 100", "expected 0 to 99");
  ExpectRefused("export a.log --map m", "a.log: not a Loopscope recording");
  EXPECT_FALSE(Exists("m.pgm"));
}

}  // namespace
}  // namespace loopscope
