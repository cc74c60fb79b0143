// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/session/command_groups.h"

namespace loopscope {
namespace {

using Kinds = std::set<Event::Kind>;

const Kinds kAllKinds{Event::Kind::kSubmapFinished, Event::Kind::kLoopClosed,
                      Event::Kind::kLoopRefused, Event::Kind::kOptimization};

/// Every command that moves in time: "step", so that many steps are undone at once.
Command SeekCommand(Command command,
                    const std::function<int(const Session&, const std::string&)>& target) {
  command.run = [target](Session* session, SessionHost*, const std::string& argument) {
    SessionState state = session->state();
    state.step = std::clamp(target(*session, argument), 0, session->last_step());
    session->Change("step", std::move(state));
  };
  return command;
}

Command Seek(const char* name, const char* title, std::vector<std::string> keys,
             const std::function<int(const Session&, const std::string&)>& target,
             const char* argument = "") {
  return SeekCommand({name, title, "Step", std::move(keys), argument, HasSteps, {}}, target);
}

/// To the next or the previous event of `kinds`; stays if there is none.
Command SeekEvent(const char* name, const char* title, std::vector<std::string> keys, Kinds kinds,
                  bool forward) {
  return Seek(name, title, std::move(keys), [=](const Session& session, const std::string&) {
    const int step = session.state().step;
    const Timeline& timeline = session.timeline();
    const auto event =
        forward ? timeline.NextEvent(step, kinds) : timeline.PreviousEvent(step, kinds);
    return event ? event->step : step;
  });
}

Command Play() {
  return {"play.toggle",
          "Play or pause",
          "Step",
          {"Space"},
          "",
          HasSteps,
          [](Session* session, SessionHost*, const std::string&) {
            session->Play(!session->playing());
          }};
}

Command Speed() {
  return {"play.speed",
          "Scans per second",
          "",
          {},
          "N",
          Always,
          [](Session* session, SessionHost*, const std::string& argument) {
            session->SetSpeed(NumberArgument("play.speed", argument));
          }};
}

Command PauseToggle(const char* name, const char* title, bool PauseConditions::*condition) {
  return {name,
          title,
          "Step",
          {},
          "",
          Always,
          [condition](Session* session, SessionHost*, const std::string&) {
            PauseConditions conditions = session->pause_conditions();
            conditions.*condition = !(conditions.*condition);
            session->SetPauseConditions(conditions);
          }};
}

Command PauseOnResidual() {
  return {"pause.residual",
          "Pause on a loop with a residual above [m] (none: never)",
          "",
          {},
          "X",
          Always,
          [](Session* session, SessionHost*, const std::string& argument) {
            PauseConditions conditions = session->pause_conditions();
            conditions.residual_above.reset();
            if (!argument.empty()) {
              conditions.residual_above = NumberArgument("pause.residual", argument);
            }
            session->SetPauseConditions(conditions);
          }};
}

}  // namespace

std::vector<Command> StepCommands() {
  const auto by = [](int scans) {
    return [scans](const Session& session, const std::string&) {
      return session.state().step + scans;
    };
  };
  const Kinds closed{Event::Kind::kLoopClosed};
  const Kinds refused{Event::Kind::kLoopRefused};
  const Kinds optimization{Event::Kind::kOptimization};
  const auto selected = [](const Session& session, const std::string&) {
    const std::optional<NodeId> node = session.state().node;
    return node ? session.recording().node(*node).step : session.state().step;
  };
  return {
      Play(),
      Seek("step.next", "Next scan", {"Right"}, by(1)),
      Seek("step.previous", "Previous scan", {"Left"}, by(-1)),
      Seek("step.first", "First scan", {"Home"}, [](const auto&, const auto&) { return 0; }),
      Seek("step.last", "Last scan", {"End"},
           [](const Session& session, const auto&) { return session.last_step(); }),
      Seek("step.forward", "100 scans forward", {"PgDown"}, by(100)),
      Seek("step.back", "100 scans back", {"PgUp"}, by(-100)),
      Seek(
          "step.seek", "Go to scan", {},
          [](const auto&, const std::string& argument) {
            return IntArgument("step.seek", argument);
          },
          "N"),
      Seek("step.node", "Scan of the selected node", {"N"}, selected),
      SeekEvent("event.next", "Next event", {"Ctrl+Right"}, kAllKinds, true),
      SeekEvent("event.previous", "Previous event", {"Ctrl+Left"}, kAllKinds, false),
      SeekEvent("event.next_loop", "Next closed loop", {"L"}, closed, true),
      SeekEvent("event.previous_loop", "Previous closed loop", {"Shift+L"}, closed, false),
      SeekEvent("event.next_refused", "Next refused loop", {"R"}, refused, true),
      SeekEvent("event.previous_refused", "Previous refused loop", {"Shift+R"}, refused, false),
      SeekEvent("event.next_optimization", "Next optimization", {"O"}, optimization, true),
      SeekEvent("event.previous_optimization", "Previous optimization", {"Shift+O"}, optimization,
                false),
      PauseToggle("pause.on_loop", "Pause on closed loops", &PauseConditions::on_loop),
      PauseToggle("pause.on_rejection", "Pause on refused loops", &PauseConditions::on_rejection),
      PauseOnResidual(),
      Speed(),
  };
}

}  // namespace loopscope
