// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/commands.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "app/session/command_groups.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

std::vector<Command> AllCommands() {
  std::vector<Command> all;
  for (const auto& group : {FileCommands, EditCommands, StepCommands, ViewCommands,
                            SelectionCommands, SearchCommands, ListCommands, HelpCommands}) {
    for (Command& command : group()) all.push_back(std::move(command));
  }
  return all;
}

/// Length of what two names have in common at their beginning.
std::size_t CommonPrefix(const std::string& a, const std::string& b) {
  const auto ends = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(ends.first - a.begin());
}

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

bool Always(const Session&) { return true; }

bool HasSteps(const Session& session) { return session.has_steps(); }

int IntArgument(const std::string& name, const std::string& argument) {
  if (const auto value = ParseInt(argument)) return *value;
  throw std::invalid_argument(name + " '" + argument + "': expected a whole number");
}

double NumberArgument(const std::string& name, const std::string& argument) {
  return NumbersArgument(name, argument, 1).front();
}

std::vector<double> NumbersArgument(const std::string& name, const std::string& argument,
                                    int count) {
  std::vector<std::string_view> words;
  SplitWords(argument, &words);
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const auto number = ParseDouble(word);
    if (number && std::isfinite(*number)) numbers.push_back(*number);
  }
  if (words.size() == numbers.size() && static_cast<int>(numbers.size()) == count) return numbers;
  throw std::invalid_argument(name + " '" + argument + "': expected " + std::to_string(count) +
                              (count == 1 ? " number" : " numbers"));
}

Command StateCommand(Command command,
                     const std::function<void(const Session&, const std::string& argument,
                                              SessionState* state)>& change) {
  command.run = [name = command.name, change](Session* session, SessionHost*,
                                              const std::string& argument) {
    SessionState state = session->state();
    change(*session, argument, &state);
    session->Change(name, std::move(state));
  };
  return command;
}

const std::vector<Command>& Commands() {
  static const std::vector<Command> commands = AllCommands();
  return commands;
}

const Command& CommandNamed(const std::string& name) {
  const std::vector<Command>& all = Commands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Command& command) { return command.name == name; });
  if (found != all.end()) return *found;
  const auto near = std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return CommonPrefix(a.name, name) < CommonPrefix(b.name, name);
  });
  throw std::invalid_argument("no command '" + name + "'; there is " + near->name);
}

void RunCommand(const std::string& line, Session* session, SessionHost* host) {
  const std::size_t space = std::min(line.find(' '), line.size());
  const Command& command = CommandNamed(line.substr(0, space));
  if (!command.is_possible(*session)) return;
  command.run(session, host, line.substr(std::min(space + 1, line.size())));
}

bool MatchesPalette(const Command& command, const std::string& text) {
  const std::string title = Lower(command.menu + " " + command.title + " " + command.name);
  std::vector<std::string_view> words;
  const std::string wanted = Lower(text);
  SplitWords(wanted, &words);
  return std::all_of(words.begin(), words.end(),
                     [&](std::string_view word) { return title.find(word) != std::string::npos; });
}

}  // namespace loopscope
