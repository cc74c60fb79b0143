// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "core/io/carmen_line.h"
#include "core/io/line_reader.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

struct ScanKind {
  std::string_view word;
  bool rear;
};

/// Best first.
constexpr std::array<ScanKind, 14> kScanKinds = {{
    {"ROBOTLASER1", false},
    {"FLASER", false},
    {"ROBOTLASER0", false},
    {"RAWLASER1", false},
    {"RAWLASER0", false},
    {"ROBOTLASER3", false},
    {"ROBOTLASER4", false},
    {"RAWLASER3", false},
    {"RAWLASER4", false},
    {"RAWLASER5", false},
    {"ROBOTLASER5", false},
    {"RLASER", true},
    {"ROBOTLASER2", true},
    {"RAWLASER2", true},
}};

/// Lines that CARMEN logs are known to have and that say nothing that we use.
constexpr std::array<std::string_view, 18> kUnusedWords = {
    "SYNC",   "TRUEPOS", "NMEAGGA",  "NMEARMC", "NMEAGGAALT",      "NMEARMCALT",
    "SONAR",  "BUMPER",  "POSITION", "NEFF",    "REMISSIONFLASER", "LASER3",
    "LASER4", "IMU",     "GPS",      "VISION",  "SEGWAY",          "MARKER"};

struct Parameter {
  double value = 0.0;
  int line = 0;
};

using Parameters = std::map<std::string, Parameter, std::less<>>;

/// The parameters of lasers that are numbers; the last value of each counts.
void TakeParameter(const std::vector<std::string_view>& words, int line, Parameters* parameters) {
  constexpr std::array<std::string_view, 8> kNames = {
      "robot_frontlaser_offset",         "robot_frontlaser_side_offset",
      "robot_frontlaser_angular_offset", "robot_front_laser_max",
      "robot_rearlaser_offset",          "robot_rearlaser_side_offset",
      "robot_rearlaser_angular_offset",  "robot_rear_laser_max"};
  if (words.size() < 3 || std::find(kNames.begin(), kNames.end(), words[1]) == kNames.end()) return;
  const std::optional<double> value = ParseDouble(words[2]);
  if (value && std::isfinite(*value)) (*parameters)[std::string(words[1])] = {*value, line};
}

double ValueOf(const Parameters& parameters, const std::string& name, LogNotes* notes) {
  const auto found = parameters.find(name);
  if (found == parameters.end() || found->second.value == 0.0) return 0.0;
  notes->Add(fmt::format("PARAM {} {:g} taken", name, found->second.value), found->second.line);
  return found->second.value;
}

struct WordCounts {
  std::array<int, kScanKinds.size()> count{};
  std::array<int, kScanKinds.size()> first_line{};
};

/// Whether `word` begins a line with a scan, which is then counted.
bool CountScan(std::string_view word, int line, WordCounts* counts) {
  for (std::size_t i = 0; i < kScanKinds.size(); ++i) {
    if (kScanKinds[i].word != word) continue;
    if (counts->count[i]++ == 0) counts->first_line[i] = line;
    return true;
  }
  return false;
}

void NoteUnused(std::string_view word, int line, LogNotes* notes) {
  const bool known =
      std::find(kUnusedWords.begin(), kUnusedWords.end(), word) != kUnusedWords.end();
  notes->Add(known ? fmt::format("{} lines, not used", word) : "lines of unknown kind, skipped",
             line);
}

/// Takes the best kind there is and tells of the others.
const ScanKind* ChooseScans(const WordCounts& counts, LogNotes* notes) {
  const ScanKind* chosen = nullptr;
  for (std::size_t i = 0; i < kScanKinds.size(); ++i) {
    if (counts.count[i] == 0) continue;
    if (chosen == nullptr) {
      chosen = &kScanKinds[i];
    } else {
      notes->Add(fmt::format("{} lines, not used: {} taken", kScanKinds[i].word, chosen->word),
                 counts.first_line[i], counts.count[i]);
    }
  }
  return chosen;
}

}  // namespace

CarmenSurvey SurveyCarmenLog(const std::string& path, LogNotes* notes) {
  LineReader lines(path);
  std::vector<std::string_view> words;
  Parameters parameters;
  WordCounts counts;
  while (const auto line = lines.Next()) {
    const std::string_view head = line->substr(0, 256);
    SplitWords(head, &words);
    if (words.empty() || words.front().front() == '#' || words.front() == "ODOM") continue;
    if (words.front() == "PARAM") {
      TakeParameter(words, lines.line_number(), &parameters);
    } else if (!CountScan(words.front(), lines.line_number(), &counts)) {
      NoteUnused(words.front(), lines.line_number(), notes);
    }
  }
  CarmenSurvey survey;
  const ScanKind* const chosen = ChooseScans(counts, notes);
  if (chosen == nullptr) return survey;
  const std::string side = chosen->rear ? "robot_rear" : "robot_front";
  const auto value = [&](const std::string& name) {
    return ValueOf(parameters, side + name, notes);
  };
  survey.scan_word = std::string(chosen->word);
  survey.base_from_laser =
      Pose2(value("laser_offset"), value("laser_side_offset"),
            NormalizeAngle(value("laser_angular_offset") + (chosen->rear ? M_PI : 0.0)));
  if (const double max_range = value("_laser_max"); max_range > 0.0) survey.max_range = max_range;
  return survey;
}

}  // namespace loopscope
