// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/render_command_line.h"

#include <optional>
#include <stdexcept>
#include <string_view>

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

Value ValueOf(const std::optional<Eigen::Vector2d>& point) {
  return point ? Value(fmt::format("{},{}", point->x(), point->y())) : std::nullopt;
}

Value ValueOf(const std::optional<std::set<LayerKind>>& layers) {
  if (!layers) return std::nullopt;
  if (layers->empty()) {
    throw std::invalid_argument("no layers: expected one at least for a command line");
  }
  std::string names;
  for (const LayerKind layer : *layers) names += (names.empty() ? "" : ",") + ToString(layer);
  return names;
}

Value SizeOf(const ViewRequest& request) {
  const ViewRequest usual;
  if (request.width == usual.width && request.height == usual.height) return std::nullopt;
  return fmt::format("{}x{}", request.width, request.height);
}

Value ThemeOf(const ViewRequest& request) {
  switch (request.theme) {
    case Theme::kDefault:
      return std::nullopt;
    case Theme::kColorBlind:
      return "color-blind";
  }
  return std::nullopt;
}

Value TitleOf(const ViewRequest& request) {
  return request.title.empty() ? std::nullopt : Value(request.title);
}

class CommandLine {
 public:
  explicit CommandLine(const std::string& run) : text_("loopscope render " + PathWord(run)) {}

  void Add(const std::string& option, const Value& value) {
    if (!value) return;
    // A value that looks like an option must be tied to its own.
    const char* const separator = value->front() == '-' ? "=" : " ";
    text_ += " " + option + separator + QuotedForShell(*value);
  }

  void AddOutput(const std::string& path) { text_ += " -o " + PathWord(path); }

  const std::string& text() const { return text_; }

 private:
  /// A path that does not look like an option.
  static std::string PathWord(const std::string& path) {
    return QuotedForShell(path.rfind('-', 0) == 0 ? "./" + path : path);
  }

  std::string text_;
};

}  // namespace

std::string RenderCommandLine(const std::string& run, const ViewRequest& request,
                              const std::string& output) {
  CommandLine line(run);
  line.Add("--view", ToString(request.view));
  line.Add("--step", ValueOf(request.step));
  line.Add("--node", ValueOfId(request.node));
  line.Add("--submap", ValueOfId(request.submap));
  line.Add("--layers", ValueOf(request.layers));
  line.Add("--center", ValueOf(request.center));
  line.Add("--width", ValueOf(request.width_in_meters));
  line.Add("--size", SizeOf(request));
  line.Add("--theme", ThemeOf(request));
  line.Add("--title", TitleOf(request));
  line.AddOutput(output);
  return line.text();
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
