#include <sandglass/output/background_task.h>

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

using namespace Sandglass;

TEST(BackgroundTask, RunsBesideItsStarter)
{
  std::promise<void> go, done;
  BackgroundTask     task;
  task.start([&]() {
    go.get_future().wait();
    done.set_value();
  });
  auto       is_done = done.get_future();
  const auto status  = is_done.wait_for(std::chrono::milliseconds(1));
  EXPECT_EQ(status, std::future_status::timeout);
  go.set_value();
  task.finish();
  EXPECT_EQ(is_done.wait_for(std::chrono::milliseconds(0)),
            std::future_status::ready);
}

TEST(BackgroundTask, FailsWhereItsStarterWaits)
{
  BackgroundTask task;
  task.start([]() { throw std::runtime_error("disk full"); });
  EXPECT_THROW(task.finish(), std::runtime_error);
  EXPECT_NO_THROW(task.finish());

  task.start([]() { throw std::runtime_error("disk full"); });
  EXPECT_THROW(task.start([]() {}), std::runtime_error);
}

TEST(BackgroundTask, IsWaitedForByTheEnd)
{
  bool is_done = false;
  {
    BackgroundTask task;
    task.start([&]() {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      is_done = true;
    });
  }
  EXPECT_TRUE(is_done);
}
