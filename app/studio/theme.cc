// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QStyleFactory>
#include <map>

namespace loopscope {
namespace {

QPalette LightPalette() {
  QPalette palette(QColor(0xf4f5f7));
  palette.setColor(QPalette::Window, QColor(0xf4f5f7));
  palette.setColor(QPalette::WindowText, QColor(0x1d2129));
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf4f6f9));
  palette.setColor(QPalette::Text, QColor(0x1d2129));
  palette.setColor(QPalette::Button, QColor(0xeceef2));
  palette.setColor(QPalette::ButtonText, QColor(0x1d2129));
  palette.setColor(QPalette::Highlight, QColor(0x2f6fde));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(0x2b303b));
  palette.setColor(QPalette::ToolTipText, Qt::white);
  return palette;
}

QPalette DarkPalette() {
  QPalette palette(QColor(0x2a2d34));
  palette.setColor(QPalette::Window, QColor(0x24272e));
  palette.setColor(QPalette::WindowText, QColor(0xe3e6eb));
  palette.setColor(QPalette::Base, QColor(0x1b1d22));
  palette.setColor(QPalette::AlternateBase, QColor(0x21242a));
  palette.setColor(QPalette::Text, QColor(0xe3e6eb));
  palette.setColor(QPalette::Button, QColor(0x333740));
  palette.setColor(QPalette::ButtonText, QColor(0xe3e6eb));
  palette.setColor(QPalette::Highlight, QColor(0x4a86f0));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, QColor(0x3b404b));
  palette.setColor(QPalette::ToolTipText, QColor(0xe3e6eb));
  palette.setColor(QPalette::Link, QColor(0x7fb0ff));
  return palette;
}

void Fade(QPalette* palette) {
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    QColor color = palette->color(role);
    color.setAlpha(110);
    palette->setColor(QPalette::Disabled, role, color);
  }
}

QString FontFamily(const char* file) {
  const QStringList families =
      QFontDatabase::applicationFontFamilies(QFontDatabase::addApplicationFont(file));
  return families.isEmpty() ? QString() : families.front();
}

/// Letters of the icon font.
const std::map<std::string, ushort>& Glyphs() {
  static const std::map<std::string, ushort> glyphs{
      {"file.open", 0xf07c},      {"file.demo", 0xf02d},         {"file.map_again", 0xf021},
      {"file.export", 0xf030},    {"file.copy_command", 0xf120}, {"file.stop_mapping", 0xf04d},
      {"edit.undo", 0xf0e2},      {"edit.redo", 0xf01e},         {"play.toggle", 0xf04b},
      {"play.pause", 0xf04c},     {"step.next", 0xf105},         {"step.previous", 0xf104},
      {"step.first", 0xf049},     {"step.last", 0xf050},         {"event.next", 0xf051},
      {"event.previous", 0xf048}, {"tiles.one", 0xf0c8},         {"tiles.two", 0xf0db},
      {"tiles.four", 0xf009},     {"camera.fit", 0xf0b2},        {"camera.frame", 0xf05b},
      {"help.palette", 0xf002},   {"help.keys", 0xf11c}};
  return glyphs;
}

QPixmap GlyphPixmap(ushort glyph, const QColor& color) {
  constexpr int kSize = 64;
  static const QString family = FontFamily(LOOPSCOPE_ICON_FONT);
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setPen(color);
  QFont font(family);
  font.setPixelSize(kSize * 3 / 4);
  painter.setFont(font);
  painter.drawText(pixmap.rect(), Qt::AlignCenter, QString(QChar(glyph)));
  return pixmap;
}

}  // namespace

void ApplyWindowTheme(const QString& name) {
  static const QString family = FontFamily(LOOPSCOPE_TEXT_FONT);
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QFont font(family);
  font.setPixelSize(13);
  QApplication::setFont(font);
  QPalette palette = name == "dark" ? DarkPalette() : LightPalette();
  Fade(&palette);
  QApplication::setPalette(palette);
}

QIcon IconOf(const std::string& command) {
  const auto glyph = Glyphs().find(command);
  if (glyph == Glyphs().end()) return {};
  const QPalette palette = QApplication::palette();
  QIcon icon(GlyphPixmap(glyph->second, palette.color(QPalette::ButtonText)));
  icon.addPixmap(
      GlyphPixmap(glyph->second, palette.color(QPalette::Disabled, QPalette::ButtonText)),
      QIcon::Disabled);
  return icon;
}

}  // namespace loopscope
