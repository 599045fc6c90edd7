#pragma once
#include <atomic>
#include <functional>
#include <string>

namespace stemwise {

/// Thrown by `Progress::check` and caught by whoever started the job.
struct Cancelled {};

/// How long work tells how far it is and learns that nobody wants it any more. Copies report to the same place;
/// `stage(a, b)` is a part of the whole. A default one reports to nobody and is never cancelled.
class Progress {
 public:
  using Report = std::function<void(double fraction, const std::string& text)>;

  Progress() = default;
  Progress(Report report, const std::atomic<bool>* cancel) : report_(std::move(report)), cancel_(cancel) {}

  /// `fraction` is 0..1 of this stage. Checks cancel too. Callable from any thread if `Report` is.
  void at(double fraction, const std::string& text) const {
    check();
    if (report_) report_(from_ + (to_ - from_) * fraction, text);
  }
  /// Throws Cancelled when cancel was asked for. Long loops call it at least every 50 ms.
  void check() const {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) throw Cancelled{};
  }
  /// The same with a few words before every text: "Aligning 2018: " before "searching poses".
  Progress prefixed(const std::string& words) const {
    Progress part = *this;
    if (report_) part.report_ = [report = report_, words](double fraction, const std::string& text) { report(fraction, words + text); };
    return part;
  }
  Progress stage(double from, double to) const {
    Progress part = *this;
    part.from_ = from_ + (to_ - from_) * from;
    part.to_ = from_ + (to_ - from_) * to;
    return part;
  }

 private:
  Report report_;
  const std::atomic<bool>* cancel_ = nullptr;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace stemwise
