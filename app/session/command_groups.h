// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/commands.h"

namespace loopscope {

// The commands by what they are about, and what these have in common.
std::vector<Command> FileCommands();
std::vector<Command> EditCommands();
std::vector<Command> StepCommands();
std::vector<Command> ViewCommands();
std::vector<Command> SelectionCommands();
std::vector<Command> SearchCommands();
std::vector<Command> ListCommands();
std::vector<Command> HelpCommands();

bool Always(const Session& session);
/// Whether there is a step to look at.
bool HasSteps(const Session& session);

/// What `argument` of command `name` says. Throw std::invalid_argument saying what was expected.
int IntArgument(const std::string& name, const std::string& argument);
double NumberArgument(const std::string& name, const std::string& argument);
std::vector<double> NumbersArgument(const std::string& name, const std::string& argument,
                                    int count);

/// A command that changes the state alone. `what` of Session::Change is its name.
Command StateCommand(Command command,
                     const std::function<void(const Session&, const std::string& argument,
                                              SessionState* state)>& change);

}  // namespace loopscope
