#include <sandglass/run/parameter_file.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

using namespace Sandglass;

namespace
{
  /// A directory with parameter files, which goes in the end.
  class ParameterFiles : public testing::Test
  {
  protected:
    ParameterFiles()
      : directory(testing::TempDir() + "sandglass_parameters_" +
                  std::to_string(getpid()))
    {
      std::filesystem::create_directories(directory / "parts");
      prm.enter_subsection("Scene");
      prm.declare_entry("Half width", "1", dealii::Patterns::Double());
      prm.declare_entry("Wall height", "1", dealii::Patterns::Double());
      prm.declare_entry("Mesh file", "", dealii::Patterns::FileName());
      prm.leave_subsection();
    }

    ~ParameterFiles() override
    {
      std::filesystem::remove_all(directory);
    }

    void
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(directory / name, std::ios::binary) << text;
    }

    /// Write `text` as a file of this name and read it.
    void
    read(const std::string &text, const std::string &name = "scene.prm")
    {
      write(name, text);
      file = std::make_unique<ParameterFile>((directory / name).string(),
                                             std::vector<std::string>(),
                                             MPI_COMM_SELF);
      file->parse(prm);
    }

    /// The message with which a text is refused.
    std::string
    refusal(const std::string &text)
    {
      try
        {
          read(text);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    std::string
    value(const std::string &name)
    {
      prm.enter_subsection("Scene");
      const std::string result = prm.get(name);
      prm.leave_subsection();
      return result;
    }

    const std::filesystem::path    directory;
    dealii::ParameterHandler       prm;
    std::unique_ptr<ParameterFile> file;
  };

  /// The text in UTF-16 with a byte order mark.
  std::string
  utf_16(const std::string &text, const bool is_little_endian)
  {
    std::string result = is_little_endian ? "\xFF\xFE" : "\xFE\xFF";
    for (const char character : text)
      {
        const char zero = '\0';
        result += is_little_endian ? character : zero;
        result += is_little_endian ? zero : character;
      }
    return result;
  }

  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace



TEST_F(ParameterFiles, AnyEncodingAndEndsOfLinesAreRead)
{
  const std::string text =
    "subsection Scene\n  set Half width = 3\n  set Wall height = 4\nend\n";
  std::string windows, macintosh;
  for (const char character : text)
    {
      windows +=
        character == '\n' ? std::string("\r\n") : std::string(1, character);
      macintosh += character == '\n' ? '\r' : character;
    }
  for (const std::string &variant : {text,
                                     windows,
                                     macintosh,
                                     "\xEF\xBB\xBF" + windows,
                                     utf_16(text, true),
                                     utf_16(windows, false)})
    {
      prm.clear();
      prm.enter_subsection("Scene");
      prm.declare_entry("Half width", "1", dealii::Patterns::Double());
      prm.declare_entry("Wall height", "1", dealii::Patterns::Double());
      prm.leave_subsection();
      read(variant);
      EXPECT_EQ(value("Half width"), "3");
      EXPECT_EQ(value("Wall height"), "4");
    }
}



TEST_F(ParameterFiles, ErrorsNameTheLineAtAnyEndsOfLines)
{
  EXPECT_TRUE(contains(refusal("subsection Scene\rset Half width = x\rend\r"),
                       "scene.prm:2: section 'Scene', parameter 'Half width'"));
}



TEST_F(ParameterFiles, ALineGoesOnAfterABackslash)
{
  read("subsection Scene\n"
       "  # a comment doesn't go on \\\n"
       "  set Half width \\\n"
       "     = 3 # m\n"
       "  set Mesh file = long/\\\n"
       "    path.msh\n"
       "end\n");
  EXPECT_EQ(value("Half width"), "3");
  EXPECT_EQ(value("Mesh file"), "long/path.msh");

  EXPECT_TRUE(contains(refusal("subsection Scene\n"
                               "  set Half width \\\n"
                               "     = wide\n"
                               "end\n"),
                       "scene.prm:2: section 'Scene'"));
  EXPECT_TRUE(contains(refusal("subsection Scene\nend\\"),
                       "scene.prm:2: the line ends with \\"));
}



TEST_F(ParameterFiles, AHashInsideAWordIsPartOfIt)
{
  read("subsection Scene # comment\n"
       "  set Mesh file = silo#2.msh # comment\n"
       "  set Half width = 3#m\n"
       "  set Wall height = 4# m\n"
       "end# comment\n");
  EXPECT_EQ(value("Mesh file"), "silo#2.msh");
  EXPECT_EQ(value("Half width"), "3");
  EXPECT_EQ(value("Wall height"), "4");
}



TEST_F(ParameterFiles, AnIncludeStandsForItsFilesLines)
{
  write("parts/inner.prm", "set Half width = 5\n");
  write("parts/part.prm",
        "subsection Scene\n"
        "  set Half width = 3\n"
        "  set Wall height = 3\n"
        "  include \"inner.prm\"\n"
        "end\n");
  // What comes later wins.
  read("subsection Scene\n"
       "  set Half width = 2\n"
       "end\n"
       "include parts/part.prm # comment\n"
       "subsection Scene\n"
       "  set Wall height = 4\n"
       "end\n");
  EXPECT_EQ(value("Half width"), "5");
  EXPECT_EQ(value("Wall height"), "4");
}



TEST_F(ParameterFiles, ErrorsNameTheIncludedFileAndItsLine)
{
  write("parts/part.prm", "subsection Scene\n  set Half width = x\nend\n");
  EXPECT_TRUE(
    contains(refusal("include parts/part.prm\n"), "parts/part.prm:2: section"));

  EXPECT_TRUE(contains(refusal("\ninclude nothing.prm\n"),
                       "scene.prm:2: include 'nothing.prm': there is no such "
                       "file"));
  EXPECT_TRUE(
    contains(refusal("include scene.prm\n"), "the file includes itself"));
}



TEST_F(ParameterFiles, LinesWithoutMeaningAreRefused)
{
  EXPECT_TRUE(contains(refusal("subsection Scene\n  Half width = 3\nend\n"),
                       "scene.prm:2: 'Half width = 3' can't be understood"));
  EXPECT_TRUE(contains(refusal("subsection Scene\nend\nend\n"),
                       "scene.prm:3: 'end' can't be understood"));
  EXPECT_TRUE(contains(refusal("# comment\nsubsection Scene\n"),
                       "scene.prm:2: 'subsection Scene'"));
  EXPECT_TRUE(contains(refusal("subsection Scenery\nend\n"),
                       "scene.prm:1: there is no section 'Scenery'"));
  EXPECT_TRUE(contains(refusal(std::string("set a = 1\0\n", 11)),
                       "the file is not a text"));
}



TEST_F(ParameterFiles, AFileThatSetsNothingSaysSo)
{
  read("# nothing\nsubsection Scene\nend\n");
  ASSERT_EQ(file->warnings(prm).size(), 1u);
  EXPECT_TRUE(contains(file->warnings(prm)[0], "scene.prm sets no parameter"));
  read("subsection Scene\n  set Half width = 3\nend\n");
  EXPECT_TRUE(file->warnings(prm).empty());
}
