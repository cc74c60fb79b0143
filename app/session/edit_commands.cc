// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/command_groups.h"

namespace loopscope {

std::vector<Command> EditCommands() {
  return {{"edit.undo",
           "Undo",
           "Edit",
           {"Ctrl+Z"},
           "",
           [](const Session& session) { return session.can_undo(); },
           [](Session* session, SessionHost*, const std::string&) { session->Undo(); }},
          {"edit.redo",
           "Redo",
           "Edit",
           {"Ctrl+Y", "Ctrl+Shift+Z"},
           "",
           [](const Session& session) { return session.can_redo(); },
           [](Session* session, SessionHost*, const std::string&) { session->Redo(); }}};
}

}  // namespace loopscope
