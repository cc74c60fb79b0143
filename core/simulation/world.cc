// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/world.h"

#include <stdexcept>
#include <utility>

#include "core/simulation/worlds.h"

namespace loopscope {
namespace {

struct NamedWorld {
  const char* name;
  World (*make)();
};

constexpr NamedWorld kWorlds[] = {{"office", OfficeWorld},
                                  {"loop", LoopWorld},
                                  {"warehouse", WarehouseWorld},
                                  {"corridor", CorridorWorld},
                                  {"hotel", HotelWorld}};

}  // namespace

std::vector<std::string> WorldNames() {
  std::vector<std::string> names;
  for (const NamedWorld& world : kWorlds) names.emplace_back(world.name);
  return names;
}

World MakeWorld(const std::string& name) {
  std::string known;
  for (const NamedWorld& candidate : kWorlds) {
    if (name == candidate.name) {
      World world = candidate.make();
      world.name = name;
      return world;
    }
    known += (known.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw std::invalid_argument("unknown world \"" + name + "\"; expected one of: " + known);
}

}  // namespace loopscope
