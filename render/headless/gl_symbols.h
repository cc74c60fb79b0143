// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace loopscope {

/// Address of an OpenGL function by name, nullptr if there is none.
using GlLoader = void (*(*)(const char* name))();

// Debian builds VTK and GLEW for GLX: GLEW asks glXGetProcAddressARB for every function, and then
// reports an error because there is no display. A program that draws without one has to put two
// symbols of its own before theirs. They stand in gl_symbols.cc, and come into every program that
// calls the function below.

/// Whom glXGetProcAddressARB answers with from now on.
void SetGlLoader(GlLoader loader);

}  // namespace loopscope
