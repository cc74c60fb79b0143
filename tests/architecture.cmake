# SPDX-FileCopyrightText: 2026 The Loopscope Authors
# SPDX-License-Identifier: Apache-2.0
# Fails if a file of ROOT includes or calls what its module may not:
#   cmake -D ROOT=<folder with core, render and app> -P architecture.cmake
cmake_minimum_required(VERSION 3.25)

# What each module may include beside itself: app -> render -> core, and the order inside core.
set(core_geometry "")
set(core_sensor core/geometry)
set(core_grid core/geometry core/sensor)
set(core_matching ${core_grid} core/grid)
set(core_local ${core_matching} core/matching)
set(core_graph ${core_local} core/local)
set(core_slam ${core_graph} core/graph)
set(core_evaluation ${core_slam} core/slam)
set(core_simulation core/geometry core/sensor)
set(core_io ${core_slam} core/slam core/evaluation core/simulation)
set(render ${core_io} core/io)
set(app ${render} render)
set(app_session ${app})
set(app_cli ${app} app)
set(app_studio ${app} app app/session)

# The window draws with the system's OpenGL: drawing without a display has none of it.
set(forbidden_includes_app_studio "render/headless/")

# Headers and calls that have no place in a layer, as regular expressions; more for some modules.
set(forbidden_headers_core "vtk|opencv2|Q[A-Z]|GL/|EGL/|iostream|chrono|ctime|spdlog|fmt/(chrono|color)")
set(forbidden_headers_render "Q[A-Z]|iostream|spdlog")
set(forbidden_headers_app "^$")
set(forbidden_headers_app_session "vtk|Q[A-Z]|iostream")
set(forbidden_headers_app_cli "Q[A-Z]")
set(forbidden_calls_core "std::(cout|cerr|clog|puts|printf|random_device|rand|time)[^a-z_]|[^a-z_:](printf|puts)\\(|stdout|stderr|getenv")
set(forbidden_calls_render "std::(cout|cerr|clog|puts|printf)[^a-z_]|[^a-z_:](printf|puts)\\(")
set(forbidden_calls_app "nothing is forbidden here")

# "core/grid" for core/grid/cell.h, "render" for render/layers/submap.h.
function(module_of path result)
  string(REGEX MATCH "^(core/[a-z]+|render|app/[a-z]+/|app)" module "${path}")
  string(REGEX REPLACE "/$" "" module "${module}")
  set(${result} "${module}" PARENT_SCOPE)
endfunction()

function(check_file file)
  module_of(${file} module)
  string(REPLACE "/" "_" name "${module}")
  string(REGEX MATCH "^[a-z]+" layer "${module}")
  if(NOT DEFINED ${name})
    message(SEND_ERROR "${file}: module ${module} is not in tests/architecture.cmake")
    return()
  endif()
  set(headers "${forbidden_headers_${layer}}")
  if(DEFINED forbidden_headers_${name})
    set(headers "${forbidden_headers_${name}}")
  endif()
  file(STRINGS ${ROOT}/${file} lines REGEX "#include|${forbidden_calls_${layer}}")
  foreach(line IN LISTS lines)
    if(line MATCHES "#include \"([^\"]+)\"")
      set(path "${CMAKE_MATCH_1}")
      module_of("${path}" included)
      if((NOT included STREQUAL module AND NOT included IN_LIST ${name}) OR
         (DEFINED forbidden_includes_${name} AND path MATCHES "^${forbidden_includes_${name}}"))
        message(SEND_ERROR "${file} must not include ${path}")
      endif()
    elseif(line MATCHES "#include <((${headers}).*)>")
      message(SEND_ERROR "${file} must not include <${CMAKE_MATCH_1}>")
    elseif(line MATCHES "${forbidden_calls_${layer}}" AND NOT line MATCHES "^ *//")
      message(SEND_ERROR "${file} must not call this: ${line}")
    endif()
  endforeach()
endfunction()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/core/*.h ${ROOT}/core/*.cc
  ${ROOT}/render/*.h ${ROOT}/render/*.cc ${ROOT}/app/*.h ${ROOT}/app/*.cc)
if(NOT files)
  message(SEND_ERROR "no sources in ${ROOT}")
endif()
foreach(file IN LISTS files)
  check_file(${file})
endforeach()
