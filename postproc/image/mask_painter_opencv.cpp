#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "postproc/image/mask_painter.h"

// The only file that uses OpenCV; it is built as a shared module.

namespace gouge {
namespace {

cv::Mat view_of(Mask& mask) { return {mask.height, mask.width, CV_8UC1, mask.grey.data()}; }

std::vector<cv::Point> points_of(const std::vector<MaskPoint>& points) {
  std::vector<cv::Point> out;
  out.reserve(points.size());
  for (const MaskPoint& p : points) out.emplace_back(p.x, p.y);
  return out;
}

template <class Paint>
Outcome painted(const Paint& paint) {
  try {
    paint();
    return Done{};
  } catch (const cv::Exception& failure) {
    const bool is_memory = failure.code == cv::Error::StsNoMem;
    Diagnostic error;  // this module uses only headers of the others
    error.code = is_memory ? "out-of-memory" : "picture-not-encoded";
    error.message = std::string("the picture could not be painted: ") + failure.what();
    return error;
  }
}

class OpenCvPainter : public MaskPainter {
 public:
  // Only for_each_chunk starts threads, because it knows their maximum number and can do without any.
  OpenCvPainter() { cv::setNumThreads(1); }

  Outcome draw(Mask& mask, const std::vector<std::vector<MaskPoint>>& strokes, int thickness) const override {
    return painted([&] {
      cv::Mat image = view_of(mask);
      for (const std::vector<MaskPoint>& stroke : strokes)
        cv::polylines(image, points_of(stroke), false, cv::Scalar(255), thickness, cv::LINE_AA, kMaskUnitBits);
    });
  }

  Outcome fill(Mask& mask, const std::vector<MaskPoint>& outline) const override {
    return painted([&] {
      cv::Mat image = view_of(mask);
      const std::vector<std::vector<cv::Point>> outlines{points_of(outline)};
      cv::fillPoly(image, outlines, cv::Scalar(255), cv::LINE_AA, kMaskUnitBits);
    });
  }

  Outcome write(Mask& mask, const std::string& ascii, int x, int y, double scale, int thickness) const override {
    return painted([&] {
      cv::Mat image = view_of(mask);
      cv::putText(image, ascii, {x, y}, cv::FONT_HERSHEY_SIMPLEX, scale, cv::Scalar(255), thickness, cv::LINE_AA);
    });
  }

  [[nodiscard]] double width(const std::string& ascii, double scale) const override {
    double pixels = 0;
    // Measures at a fixed large scale, so that widths grow smoothly with the size.
    constexpr double kMeasured = 4;
    const Outcome measured = painted([&] {
      int base_line = 0;
      pixels = cv::getTextSize(ascii, cv::FONT_HERSHEY_SIMPLEX, kMeasured, 1, &base_line).width;
    });
    return measured ? pixels * scale / kMeasured : 0;
  }

  Outcome shrink(const std::vector<std::uint8_t>& from, int width, int height, int factor,
                 std::vector<std::uint8_t>& to) const override {
    return painted([&] {
      const cv::Mat whole(height, width, CV_8UC3, const_cast<std::uint8_t*>(from.data()));
      const cv::Size size(width / factor, height / factor);
      to.resize(static_cast<std::size_t>(size.area()) * 3);
      cv::Mat small(size, CV_8UC3, to.data());
      cv::resize(whole, small, size, 0, 0, cv::INTER_AREA);
    });
  }
};

}  // namespace
}  // namespace gouge

extern "C" __attribute__((visibility("default"))) const gouge::MaskPainter* gougecheck_mask_painter() {
  static const gouge::OpenCvPainter painter;
  return &painter;
}
