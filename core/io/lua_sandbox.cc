// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/lua_sandbox.h"

#include <cassert>
#include <charconv>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <lua.hpp>

#include "core/io/file_error.h"
#include "core/io/text_file.h"

namespace loopscope {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxMemory = 4 << 20;  // [bytes]
constexpr int kMaxInstructions = 200000;
constexpr int kInstructionsPerCheck = 1000;
constexpr int kMaxTables = 10000;  // in the result
constexpr int kMaxDepth = 30;

// Lua leaves functions by longjmp on errors: no object with a destructor may live in a function
// that Lua calls while it calls Lua. What such functions need is kept here.
class Sandbox {
 public:
  Sandbox(const LuaSource& main, LuaLibrary library)
      : folder_(fs::path(main.path).parent_path()), library_(library) {
    AddSource(main);
  }

  LuaRun Run();

 private:
  struct Chunk {
    LuaSource source;
    std::string name;  // "=" and the index, which Lua puts before its messages
  };

  static Sandbox& Of(lua_State* lua) { return **static_cast<Sandbox**>(lua_getextraspace(lua)); }
  static void* Allocate(void* sandbox, void* block, size_t old_size, size_t new_size);
  static void CountInstructions(lua_State* lua, lua_Debug*);
  static int RunMain(lua_State* lua);
  static int Include(lua_State* lua);
  static int Choose(lua_State* lua);
  static void OpenLibraries(lua_State* lua);
  static void RunChunk(lua_State* lua, const Chunk& chunk);

  void AddSource(LuaSource source);
  bool FindInclude(const char* name) noexcept;
  std::optional<LuaSource> FindSource(const std::string& name) const;
  [[noreturn]] void ThrowLuaError(lua_State* lua, int status) const;
  void Flatten(lua_State* lua, const std::string& prefix, int depth);

  fs::path folder_;
  LuaLibrary library_;
  std::deque<Chunk> chunks_;  // does not move what it holds
  std::string include_error_;
  size_t memory_ = 0;
  int num_instructions_ = 0;
  int num_tables_ = 0;  // read from the result
  std::map<std::string, ConfigValue> values_;
};

void* Sandbox::Allocate(void* sandbox, void* block, size_t old_size, size_t new_size) {
  size_t& memory = static_cast<Sandbox*>(sandbox)->memory_;
  if (!block) old_size = 0;  // then it is the kind of the new object
  if (new_size == 0) {
    std::free(block);
    memory -= old_size;
    return nullptr;
  }
  if (new_size > old_size && memory - old_size + new_size > kMaxMemory) return nullptr;
  void* const new_block = std::realloc(block, new_size);
  if (new_block) memory = memory - old_size + new_size;
  return new_block;
}

void Sandbox::CountInstructions(lua_State* lua, lua_Debug*) {
  int& count = Of(lua).num_instructions_;
  count += kInstructionsPerCheck;
  if (count < kMaxInstructions) return;
  luaL_where(lua, 0);
  lua_pushfstring(lua, "ran %d instructions without coming to an end", kMaxInstructions);
  lua_concat(lua, 2);
  lua_error(lua);
}

void Sandbox::OpenLibraries(lua_State* lua) {
  luaL_requiref(lua, "_G", luaopen_base, 1);
  luaL_requiref(lua, "math", luaopen_math, 1);
  lua_pop(lua, 2);
  // What reads files, catches the errors that stop a run, or loops where no instructions are
  // counted.
  for (const char* name : {"collectgarbage", "dofile", "load", "loadfile", "pcall", "xpcall",
                           "warn", "require", "setmetatable"}) {
    lua_pushnil(lua);
    lua_setglobal(lua, name);
  }
  lua_getglobal(lua, "math");
  for (const char* name : {"random", "randomseed"}) {
    lua_pushnil(lua);
    lua_setfield(lua, -2, name);
  }
  lua_pop(lua, 1);
  lua_register(lua, "print", [](lua_State*) { return 0; });
  lua_register(lua, "include", Include);
  lua_register(lua, "choose", Choose);
}

void Sandbox::RunChunk(lua_State* lua, const Chunk& chunk) {
  const std::string& text = chunk.source.text;
  if (luaL_loadbufferx(lua, text.data(), text.size(), chunk.name.c_str(), "t") != LUA_OK) {
    lua_error(lua);
  }
  lua_call(lua, 0, 1);
}

int Sandbox::RunMain(lua_State* lua) {
  OpenLibraries(lua);
  lua_sethook(lua, CountInstructions, LUA_MASKCOUNT, kInstructionsPerCheck);
  RunChunk(lua, Of(lua).chunks_.front());
  return 1;
}

int Sandbox::Include(lua_State* lua) {
  Sandbox& sandbox = Of(lua);
  if (!sandbox.FindInclude(luaL_checkstring(lua, 1))) {
    return luaL_error(lua, "%s", sandbox.include_error_.c_str());
  }
  RunChunk(lua, sandbox.chunks_.back());
  return 1;
}

int Sandbox::Choose(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TBOOLEAN);
  luaL_checkany(lua, 3);
  lua_pushvalue(lua, lua_toboolean(lua, 1) ? 2 : 3);
  return 1;
}

void Sandbox::AddSource(LuaSource source) {
  chunks_.push_back({std::move(source), "=" + std::to_string(chunks_.size())});
}

bool Sandbox::FindInclude(const char* name) noexcept {
  try {
    std::optional<LuaSource> source = FindSource(name);
    if (source) {
      AddSource(std::move(*source));
      return true;
    }
    include_error_ = fmt::format(
        "cannot include \"{}\": expected a file in the folder of the options file, or the name of "
        "one of Cartographer's stock files",
        name);
  } catch (const std::exception& error) {
    include_error_ = error.what();
  }
  return false;
}

std::optional<LuaSource> Sandbox::FindSource(const std::string& name) const {
  const fs::path relative = fs::path(name).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") return std::nullopt;
  const std::string path = (folder_ / relative).string();
  std::optional<LuaSource> source;
  if (fs::is_regular_file(path)) {
    source = {path, ReadTextFile(path)};
  } else if (std::optional<std::string> text = library_(name)) {
    source = {"(stock " + name + ")", std::move(*text)};
  }
  for (const Chunk& chunk : chunks_) {
    if (source && source->path == chunk.source.path) {
      throw FileError(source->path, "included a second time");
    }
  }
  return source;
}

// The message begins with "index:line: " of a chunk if it belongs to a line.
void Sandbox::ThrowLuaError(lua_State* lua, int status) const {
  const std::string& main_path = chunks_.front().source.path;
  if (status == LUA_ERRMEM) {
    throw FileError(main_path, fmt::format("needs more than {} MB of memory", kMaxMemory >> 20));
  }
  if (lua_type(lua, -1) != LUA_TSTRING) throw FileError(main_path, "raised an error without text");
  const std::string message = lua_tostring(lua, -1);
  const char* const end = message.data() + message.size();
  size_t index = 0;
  int line = 0;
  const auto [colon, index_error] = std::from_chars(message.data(), end, index);
  if (index_error != std::errc() || index >= chunks_.size() || colon == end || *colon != ':') {
    throw FileError(main_path, message);
  }
  const auto [text, line_error] = std::from_chars(colon + 1, end, line);
  if (line_error != std::errc() || end - text < 2) throw FileError(main_path, message);
  throw FileError(chunks_[index].source.path, line, text + 2);
}

// Reads the table on top of the stack. Calls nothing of Lua that can fail.
void Sandbox::Flatten(lua_State* lua, const std::string& prefix, int depth) {
  if (depth > kMaxDepth || ++num_tables_ > kMaxTables || !lua_checkstack(lua, 3)) {
    throw FileError(chunks_.front().source.path,
                    "has too many tables in what it returns, or a table in itself");
  }
  for (lua_pushnil(lua); lua_next(lua, -2); lua_pop(lua, 1)) {
    // A number is copied, as lua_tostring would change the key in place.
    const std::string name = lua_type(lua, -2) == LUA_TSTRING ? lua_tostring(lua, -2)
                             : lua_isnumber(lua, -2) ? fmt::format("[{}]", lua_tonumber(lua, -2))
                                                     : luaL_typename(lua, -2);
    const std::string key = prefix + name;
    switch (lua_type(lua, -1)) {
      case LUA_TTABLE:
        Flatten(lua, key + ".", depth + 1);
        break;
      case LUA_TBOOLEAN:
        values_[key] = lua_toboolean(lua, -1) != 0;
        break;
      case LUA_TNUMBER:
        values_[key] = lua_tonumber(lua, -1);
        break;
      case LUA_TSTRING:
        values_[key] = std::string(lua_tostring(lua, -1));
        break;
    }
  }
}

LuaRun Sandbox::Run() {
  const std::unique_ptr<lua_State, decltype(&lua_close)> lua(lua_newstate(Allocate, this),
                                                             lua_close);
  assert(lua);
  *static_cast<Sandbox**>(lua_getextraspace(lua.get())) = this;
  lua_pushcfunction(lua.get(), RunMain);
  const int status = lua_pcall(lua.get(), 0, 1, 0);
  if (status != LUA_OK) ThrowLuaError(lua.get(), status);
  if (!lua_istable(lua.get(), -1)) {
    throw FileError(chunks_.front().source.path,
                    "expected \"return options\" with a table at the end");
  }
  Flatten(lua.get(), "", 0);
  LuaRun run;
  for (auto& [key, value] : values_) run.values.push_back({key, std::move(value)});
  for (Chunk& chunk : chunks_) run.sources.push_back(std::move(chunk.source));
  return run;
}

}  // namespace

LuaRun RunLua(const LuaSource& main, LuaLibrary library) { return Sandbox(main, library).Run(); }

}  // namespace loopscope
