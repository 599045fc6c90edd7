#include "app/window/job_runner.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

void run_dry(JobRunner& jobs) {
  while (jobs.is_busy()) {
    jobs.wait_for_news();
    jobs.poll();
  }
}

TEST(JobRunner, AResultIsDeliveredOnThePollingThread) {
  JobRunner jobs;
  const std::thread::id here = std::this_thread::get_id();
  int got = 0;
  jobs.start<int>("Count", JobLane::person, [](const Progress&) { return 42; },
                  [&](int value) {
                    EXPECT_EQ(std::this_thread::get_id(), here);
                    got = value;
                    return JobVerdict{true, "counted"};
                  });
  run_dry(jobs);
  EXPECT_EQ(got, 42);
  ASSERT_EQ(jobs.views().size(), 1u);
  EXPECT_EQ(jobs.views().front().state, ui::JobView::State::done);
  EXPECT_EQ(jobs.views().front().outcome, "counted");
}

TEST(JobRunner, ACancelledJobDeliversNothing) {
  JobRunner jobs;
  bool delivered = false;
  const int id = jobs.start<int>("Wait", JobLane::person,
                                 [](const Progress& progress) {
                                   while (true) progress.check();
                                   return 0;
                                 },
                                 [&](int) {
                                   delivered = true;
                                   return JobVerdict{};
                                 });
  jobs.cancel(id);
  run_dry(jobs);
  EXPECT_FALSE(delivered);
  EXPECT_EQ(jobs.views().front().state, ui::JobView::State::cancelled);
}

TEST(JobRunner, AProgrammersErrorInAJobBecomesASentenceNotACrash) {
  JobRunner jobs;
  jobs.start<int>("Break", JobLane::person, [](const Progress&) -> int { throw std::logic_error("index 7"); }, [](int) { return JobVerdict{}; });
  run_dry(jobs);
  EXPECT_EQ(jobs.views().front().state, ui::JobView::State::failed);
  EXPECT_NE(jobs.views().front().outcome.find("index 7"), std::string::npos);
}

TEST(JobRunner, ProgressAndStageAreSeenWhileItRuns) {
  JobRunner jobs;
  std::atomic<bool> go_on{false};
  jobs.start<int>("Slow", JobLane::person,
                  [&](const Progress& progress) {
                    progress.at(0.5, "Half way");
                    while (!go_on) progress.check();
                    return 1;
                  },
                  [](int) { return JobVerdict{}; });
  while (jobs.views().front().stage.empty()) jobs.wait_for_news(), jobs.poll();
  EXPECT_DOUBLE_EQ(jobs.views().front().fraction, 0.5);
  EXPECT_EQ(jobs.views().front().stage, "Half way");
  go_on = true;
  run_dry(jobs);
}

}  // namespace
}  // namespace stemwise
