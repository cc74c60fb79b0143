// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/render_command_line.h"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace loopscope {
namespace {

// Each returns what stands behind an option, or nothing if the option is to be left out. Numbers
// have as many digits as give the same value again.
using Value = std::optional<std::string>;

Value ValueOf(const std::optional<int>& number) {
  return number ? Value(fmt::format("{}", *number)) : std::nullopt;
}

Value ValueOf(const std::optional<double>& number) {
  return number ? Value(fmt::format("{}", *number)) : std::nullopt;
}

template <typename Id>
Value ValueOfId(const std::optional<Id>& id) {
  return id ? Value(std::to_string(id->index)) : std::nullopt;
}

Value ValueOf(const std::vector<LoopPair>& pairs) {
  std::string text;
  for (const LoopPair& pair : pairs) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",", pair.node.index, pair.submap.index);
  }
  return text.empty() ? std::nullopt : Value(text);
}

Value ValueOf(const std::optional<Eigen::Vector2d>& point) {
  return point ? Value(fmt::format("{},{}", point->x(), point->y())) : std::nullopt;
}

/// The layers that are drawn, if they are not the view's own, with their opacities.
Value LayersOf(const ViewRequest& request) {
  if (!request.layers && request.opacities.empty()) return std::nullopt;
  std::string names;
  for (const LayerKind layer : request.layers.value_or(DefaultLayersOf(request.view))) {
    names += (names.empty() ? "" : ",") + ToString(layer);
    const auto opacity = request.opacities.find(layer);
    if (opacity != request.opacities.end()) names += fmt::format(":{}", opacity->second);
  }
  if (names.empty()) {
    throw std::invalid_argument("no layers: expected one at least for a command line");
  }
  return names;
}

Value SizeOf(const ViewRequest& request) {
  const ViewRequest usual;
  if (request.width == usual.width && request.height == usual.height) return std::nullopt;
  return fmt::format("{}x{}", request.width, request.height);
}

Value ThemeOf(const ViewRequest& request) {
  if (request.theme == ViewRequest().theme) return std::nullopt;
  return ToString(request.theme);
}

Value TitleOf(const ViewRequest& request) {
  return request.title.empty() ? std::nullopt : Value(request.title);
}

Value ChartOf(const ViewRequest& request) {
  if (request.chart == ViewRequest().chart) return std::nullopt;
  return ToString(request.chart);
}

/// A path that does not look like an option.
std::string PathWord(const std::string& path) {
  return path.rfind('-', 0) == 0 ? "./" + path : path;
}

/// Collects the words of a command line.
class Words {
 public:
  void Add(const std::string& option, const Value& value) {
    if (!value) return;
    if (value->front() == '-') {  // it looks like an option, so it is tied to its own
      words_.push_back(option + "=" + *value);
    } else {
      words_.insert(words_.end(), {option, *value});
    }
  }

  void Add(const std::string& word) { words_.push_back(word); }

  const std::vector<std::string>& words() const { return words_; }

 private:
  std::vector<std::string> words_;
};

/// The options of a view that pictures and films have in common.
void AddView(const ViewRequest& request, Words* words) {
  words->Add("--node", ValueOfId(request.node));
  words->Add("--submap", ValueOfId(request.submap));
  words->Add("--mark", ValueOf(request.marked));
  words->Add("--visits", ValueOf(request.search.num_visits));
  words->Add("--height", ValueOf(request.search.height));
  words->Add("--angle", ValueOf(request.search.angle_index));
  words->Add("--layers", LayersOf(request));
  words->Add("--center", ValueOf(request.center));
  words->Add("--width", ValueOf(request.width_in_meters));
  words->Add("--min-height", ValueOf(request.height_in_meters));
  words->Add("--chart", ChartOf(request));
  words->Add("--azimuth", ValueOf(request.azimuth));
  words->Add("--elevation", ValueOf(request.elevation));
  words->Add("--size", SizeOf(request));
  words->Add("--text", ValueOf(request.text_height));
  words->Add("--theme", ThemeOf(request));
  if (request.plain) words->Add("--plain");
  words->Add("--title", TitleOf(request));
}

}  // namespace

std::vector<std::string> RenderArguments(const std::string& run, const ViewRequest& request,
                                         const std::string& output) {
  Words words;
  words.Add("render");
  words.Add(PathWord(run));
  words.Add("--view", ToString(request.view));
  words.Add("--step", ValueOf(request.step));
  AddView(request, &words);
  words.Add("-o");
  words.Add(PathWord(output));
  return words.words();
}

std::vector<std::string> FilmArguments(const std::string& run, const ViewRequest& request,
                                       const FilmSteps& steps, const std::string& output) {
  Words words;
  words.Add("film");
  words.Add(PathWord(run));
  words.Add("--view", ToString(request.view));
  words.Add("--steps", fmt::format("{}:{}:{}", steps.first, steps.last, steps.stride));
  words.Add("--fps", fmt::format("{}", steps.frames_per_second));
  AddView(request, &words);
  words.Add("-o");
  words.Add(PathWord(output));
  return words.words();
}

std::string CommandLine(const std::vector<std::string>& arguments) {
  std::string line = "loopscope";
  for (const std::string& word : arguments) line += " " + QuotedForShell(word);
  return line;
}

std::string QuotedForShell(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace loopscope
