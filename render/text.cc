// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/text.h"

#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utf8.h>
#include <vtkStdString.h>
#include <vtkTextRenderer.h>

namespace loopscope {
namespace {

constexpr int kDotsPerInch = 72;  // a point is a pixel

const char* FontFile(Weight weight) {
  return weight == Weight::kMedium ? LOOPSCOPE_FONT_FOLDER "/Roboto-Medium.ttf"
                                   : LOOPSCOPE_FONT_FOLDER "/Roboto-Regular.ttf";
}

void RequireFont(const char* file) {
  if (std::filesystem::exists(file)) return;
  throw std::runtime_error(std::string(file) +
                           ": no such font: expected Debian's package fonts-roboto-unhinted");
}

/// `text` without its last letter, which may be several bytes of UTF-8.
std::string WithoutLastLetter(std::string text) {
  while (!text.empty() && (text.back() & 0xc0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace

vtkSmartPointer<vtkTextProperty> MakeTextProperty(const TextStyle& style, Align align) {
  RequireFont(FontFile(style.weight));
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(FontFile(style.weight));
  property->SetFontSize(style.size);
  property->SetColor(style.color.r / 255.0, style.color.g / 255.0, style.color.b / 255.0);
  property->SetOpacity(style.color.a / 255.0);
  property->SetJustification(align == Align::kLeft     ? VTK_TEXT_LEFT
                             : align == Align::kCenter ? VTK_TEXT_CENTERED
                                                       : VTK_TEXT_RIGHT);
  property->SetVerticalJustificationToCentered();
  return property;
}

std::mutex& FontLock() {
  static std::mutex lock;
  return lock;
}

std::string ToUtf8(const std::string& text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  return valid;
}

double TextWidth(const std::string& text, const TextStyle& style) {
  if (text.empty()) return 0.0;
  const std::lock_guard<std::mutex> lock(FontLock());
  int box[4] = {0, 0, 0, 0};  // x from box[0] to box[1], both inside
  vtkTextRenderer::GetInstance()->GetBoundingBox(MakeTextProperty(style, Align::kLeft), text, box,
                                                 kDotsPerInch);
  return box[1] - box[0] + 1;
}

std::string ShortenToFit(const std::string& text, const TextStyle& style, double width) {
  if (TextWidth(text, style) <= width) return text;
  for (std::string kept = WithoutLastLetter(text); !kept.empty(); kept = WithoutLastLetter(kept)) {
    const std::string shortened = kept + "…";
    if (TextWidth(shortened, style) <= width) return shortened;
  }
  return "";
}

std::string JoinToFit(const std::vector<std::string>& parts, const TextStyle& style, double width) {
  std::string joined;
  for (const std::string& part : parts) {
    const std::string longer = joined.empty() ? part : joined + " · " + part;
    if (TextWidth(longer, style) > width) break;
    joined = longer;
  }
  return joined.empty() && !parts.empty() ? ShortenToFit(parts.front(), style, width) : joined;
}

vtkSmartPointer<vtkTextActor> MakeText(const std::string& text, const TextStyle& style, Align align,
                                       double x, double y) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetTextProperty(MakeTextProperty(style, align));
  actor->SetPosition(x, y);
  return actor;
}

}  // namespace loopscope
