#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "io/report/document.hpp"

namespace stemwise {

/// A page as a picture: rows from the top, RGBA, opaque.
struct PagePicture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgba;
};

/// The pages of a report as `report_pdf` lays them out, kept as drawings: each becomes a picture of any size when it is looked at.
class RecordedPages {
 public:
  struct Impl;
  explicit RecordedPages(std::unique_ptr<Impl> pages);
  ~RecordedPages();
  RecordedPages(RecordedPages&&) noexcept;
  RecordedPages& operator=(RecordedPages&&) noexcept;

  int count() const;
  /// Of page 0, 1, ... `count() - 1`. Not from two threads at once.
  PagePicture picture(int page, int width_px) const;

 private:
  std::unique_ptr<Impl> impl_;
};

RecordedPages report_pages(const ReportDocument& document);

}  // namespace stemwise
