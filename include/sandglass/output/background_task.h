#ifndef sandglass_output_background_task_h
#define sandglass_output_background_task_h

#include <functional>
#include <future>

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
      last = std::async(std::launch::async, std::move(task));
    }

    /// Wait for the last task. Throws what it has thrown, once.
    void
    finish()
    {
      if (last.valid())
        last.get();
    }

  private:
    std::future<void> last; // waits when it is destroyed
  };
} // namespace Sandglass

#endif
