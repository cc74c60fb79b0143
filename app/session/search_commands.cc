// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/session/command_groups.h"

namespace loopscope {
namespace {

/// Shows a part of the search: without an argument all again.
Command PartCommand(const char* name, const char* title, const char* argument,
                    std::optional<int> SearchFilter::*part) {
  return StateCommand({name, title, "", {}, argument, HasSteps, {}},
                      [name, part](const Session&, const std::string& text, SessionState* state) {
                        (state->search.*part).reset();
                        if (!text.empty()) state->search.*part = IntArgument(name, text);
                      });
}

}  // namespace

std::vector<Command> SearchCommands() {
  return {
      PartCommand("search.visits", "Show the search after so many visits of its tree", "[K]",
                  &SearchFilter::num_visits),
      PartCommand("search.height", "Show one height of the search only", "[H]",
                  &SearchFilter::height),
      PartCommand("search.angle", "Show one angle of the search only", "[I]",
                  &SearchFilter::angle_index),
      StateCommand({"search.all", "All of the search", "Selection", {}, "", HasSteps, {}},
                   [](const Session&, const std::string&, SessionState* state) {
                     state->search = SearchFilter();
                   }),
  };
}

}  // namespace loopscope
