#ifndef sandglass_output_background_task_h
#define sandglass_output_background_task_h

#include <functional>
#include <future>
#include <memory>
#include <system_error>

namespace Sandglass
{
  /**
   * One task at a time on a thread of its own, beside the run. What the task
   * uses must be left alone until finish(), or until this object is gone.
   */
  class BackgroundTask
  {
  public:
    /// Start a task after the last one; throws what the last one has thrown.
    void
    start(std::function<void()> task)
    {
      finish();
      const auto shared =
        std::make_shared<const std::function<void()>>(std::move(task));
      const auto work = [shared]() { (*shared)(); };
      try
        {
          last = std::async(std::launch::async, work);
        }
      catch (const std::system_error &)
        {
          // There is no room for a thread: in finish(), then.
          last = std::async(std::launch::deferred, work);
        }
    }

    /// Wait for the last task. Throws what it has thrown, once.
    void
    finish()
    {
      if (last.valid())
        last.get();
    }

    /// Waits.
    ~BackgroundTask()
    {
      if (last.valid())
        last.wait();
    }

  private:
    std::future<void> last;
  };
} // namespace Sandglass

#endif
