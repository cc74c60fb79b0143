// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>
#include <QString>

namespace loopscope {

/// Fonts, style and colours of the whole window: "light" or "dark".
void ApplyWindowTheme(const QString& name);

/// The icon of a command in the colours of the window; none if the command has none.
QIcon IconOf(const std::string& command);

}  // namespace loopscope
