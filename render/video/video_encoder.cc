// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/video/video_encoder.h"

#include <cstdint>

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace loopscope {
namespace {

int FourCcOf(VideoCodec codec) {
  return codec == VideoCodec::kMpeg4 ? cv::VideoWriter::fourcc('m', 'p', '4', 'v')
                                     : cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
}

class FfmpegEncoder : public VideoEncoder {
 public:
  bool Open(const std::string& path, VideoCodec codec, double frames_per_second, int width,
            int height) override {
    return video_.open(path, cv::CAP_FFMPEG, FourCcOf(codec), frames_per_second, {width, height});
  }

  void Add(const Picture& picture) override {
    const cv::Mat rgb(picture.height, picture.width, CV_8UC3,
                      const_cast<std::uint8_t*>(picture.rgb.data()));
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    video_.write(bgr);
  }

  void Close() override { video_.release(); }

  int NumFramesOf(const std::string& path) const override {
    return static_cast<int>(cv::VideoCapture(path, cv::CAP_FFMPEG).get(cv::CAP_PROP_FRAME_COUNT));
  }

 private:
  cv::VideoWriter video_;
};

}  // namespace
}  // namespace loopscope

extern "C" loopscope::VideoEncoder* LoopscopeMakeVideoEncoder() {
  return new loopscope::FfmpegEncoder;
}
