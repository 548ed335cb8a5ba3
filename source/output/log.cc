#include <deal.II/base/mpi.h>

#include <sandglass/output/log.h>
#include <sandglass/output/replace_file.h>

#include <unistd.h>

#include <fstream>
#include <iostream>
#include <streambuf>

namespace Sandglass
{
  class Log::Splitter : public std::streambuf
  {
  public:
    Splitter(const Screen screen, const bool has_terminal)
      : screen(screen)
      , has_terminal(has_terminal)
    {}

    ~Splitter() override
    {
      end_open_line();
    }

    void
    open_file(const std::string &filename, const bool appends)
    {
      file.open(filename, appends ? std::ios::app : std::ios::trunc);
      file << text_before_file << std::flush;
      if (!file)
        throw_unwritable(filename);
      text_before_file.clear();
    }

    void
    show_progress(const std::string &line)
    {
      if (!has_terminal)
        {
          const std::string text = line + '\n';
          if (screen != Screen::nothing)
            std::cout << text;
          write_file(text.data(), text.size());
          sync();
          return;
        }
      write_file(line.data(), line.size());
      write_file("\n", 1);
      if (screen != Screen::nothing)
        // Back to the line's start, and clear it.
        std::cout << "\r\033[K" << line << std::flush;
      has_open_line = screen != Screen::nothing;
    }

    void
    record_error(const std::string &line)
    {
      end_open_line();
      file.clear(); // a full disk may have room again
      const std::string text = line + '\n';
      write_file(text.data(), text.size());
      sync();
    }

  protected:
    int_type
    overflow(const int_type character) override
    {
      const char text = traits_type::to_char_type(character);
      xsputn(&text, 1);
      return character;
    }

    std::streamsize
    xsputn(const char *text, const std::streamsize size) override
    {
      if (screen == Screen::everything)
        {
          end_open_line();
          std::cout.write(text, size);
        }
      write_file(text, size);
      return size;
    }

    int
    sync() override
    {
      if (screen != Screen::nothing)
        std::cout.flush();
      if (file.is_open())
        file.flush();
      return 0;
    }

  private:
    void
    end_open_line()
    {
      if (has_open_line)
        std::cout << '\n';
      has_open_line = false;
    }

    void
    write_file(const char *text, const std::streamsize size)
    {
      if (file.is_open())
        file.write(text, size);
      else
        text_before_file.append(text, size);
    }

    const Screen  screen;
    const bool    has_terminal;
    bool          has_open_line = false;
    std::string   text_before_file;
    std::ofstream file;
  };



  Log::Log(const MPI_Comm communicator, const Screen screen)
    // mpirun connects each rank to a terminal of its own, whatever its own
    // output goes to.
    : splitter(std::make_unique<Splitter>(
        screen,
        isatty(STDOUT_FILENO) != 0 &&
          dealii::Utilities::MPI::n_mpi_processes(communicator) == 1))
    , split_stream(splitter.get())
    , output(split_stream,
             dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  {}



  Log::~Log() = default;



  void
  Log::warn(const std::vector<std::string> &warnings)
  {
    for (const std::string &warning : warnings)
      output << "Warning: " << warning << std::endl;
  }



  void
  Log::open_file(const std::string &filename, const bool appends)
  {
    if (output.is_active())
      splitter->open_file(filename, appends);
  }



  void
  Log::show_progress(const std::string &line)
  {
    if (output.is_active())
      splitter->show_progress(line);
  }



  void
  Log::record_error(const std::string &line)
  {
    if (output.is_active())
      splitter->record_error(line);
  }
} // namespace Sandglass
