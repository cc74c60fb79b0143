// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/studio/search_bar.h"

#include <QHBoxLayout>

#include <fmt/format.h>

namespace loopscope {
namespace {

QString PartText(const char* name, const std::optional<int>& value, int count) {
  return QString::fromStdString(value ? fmt::format("{} {} of {}", name, *value, count)
                                      : fmt::format("all {}s", name));
}

}  // namespace

SearchBar::SearchBar(RunLine run, QWidget* parent) : QWidget(parent), run_(std::move(run)) {
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 4);
  visits_ = Add("search.visits", true);
  height_ = Add("search.height", false);
  angle_ = Add("search.angle", false);
  visits_.slider->setToolTip("The order in which the tree was visited; at the right: all of it");
  height_.slider->setToolTip("One height of the tree; at the left: all");
  angle_.slider->setToolTip("One angle; at the left: all");
}

SearchBar::Part SearchBar::Add(const char* command, bool all_is_right) {
  Part part;
  part.label = new QLabel(this);
  part.label->setMinimumWidth(80);
  part.label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  part.slider = new QSlider(Qt::Horizontal, this);
  part.slider->setFocusPolicy(Qt::NoFocus);
  layout()->addWidget(part.label);
  layout()->addWidget(part.slider);
  QSlider* const slider = part.slider;
  connect(slider, &QSlider::valueChanged, this, [this, command, slider, all_is_right](int value) {
    if (is_showing_) return;
    const bool all = value == (all_is_right ? slider->maximum() : slider->minimum());
    run_(all ? command : fmt::format("{} {}", command, value));
  });
  return part;
}

void SearchBar::Show(const SearchSize& size, const SearchFilter& filter) {
  is_showing_ = true;
  setEnabled(size.num_visits > 0);
  visits_.slider->setRange(0, size.num_visits);
  visits_.slider->setValue(filter.num_visits.value_or(size.num_visits));
  visits_.label->setText(PartText("visit", filter.num_visits, size.num_visits));
  height_.slider->setRange(-1, size.root_height);
  height_.slider->setValue(filter.height.value_or(-1));
  height_.label->setText(PartText("height", filter.height, size.root_height));
  const int steps = size.num_angular_steps;
  angle_.slider->setRange(-steps - 1, steps);
  angle_.slider->setValue(filter.angle_index.value_or(-steps - 1));
  angle_.label->setText(PartText("angle", filter.angle_index, steps));
  is_showing_ = false;
}

}  // namespace loopscope
