#include <sandglass/base/exceptions.h>
#include <sandglass/run/checkpoint_files.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "output_silo.h"
#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using Damage = std::function<std::string(std::string)>;

  /// 40 ways in which a file may be damaged, some at random places.
  std::vector<std::pair<std::string, Damage>>
  all_damage(const std::string &other_checkpoint)
  {
    std::mt19937                                random = random_engine();
    std::vector<std::pair<std::string, Damage>> all;
    const auto add = [&all](const std::string &name, const Damage &damage) {
      all.emplace_back(name, damage);
    };
    // As a share of the file.
    const auto place = [&random]() {
      return std::uniform_real_distribution<double>(0., 1.)(random);
    };

    // Too short, as after a crash or a broken copy.
    for (const double share : {0., 0.001, 0.1, 0.5, 0.9, 0.999})
      add("cut to " + std::to_string(share), [share](const std::string &text) {
        return text.substr(0, share * text.size());
      });
    for (const std::size_t missing : {1, 7, 8, 9, 4096})
      add("without the last " + std::to_string(missing),
          [missing](const std::string &text) {
            return text.substr(0, text.size() - missing);
          });
    for (const std::size_t missing : {1, 22, 23})
      add("without the first " + std::to_string(missing),
          [missing](const std::string &text) { return text.substr(missing); });

    // Too long.
    add("with a byte more", [](const std::string &text) { return text + '0'; });
    add("with zeros behind",
        [](const std::string &text) { return text + std::string(4096, '\0'); });
    add("with a byte in front",
        [](const std::string &text) { return 'S' + text; });
    add("twice", [](const std::string &text) { return text + text; });
    add("with a byte more inside", [share = place()](std::string text) {
      return text.insert(share * text.size(), 1, 'x');
    });

    // Single bits.
    for (unsigned int bit = 0; bit < 8; ++bit)
      add("bit " + std::to_string(bit),
          [bit, share = place()](std::string text) {
            text[share * text.size()] ^= static_cast<char>(1u << bit);
            return text;
          });
    add("first bit", [](std::string text) {
      text.front() ^= 1;
      return text;
    });
    add("last bit", [](std::string text) {
      text.back() ^= 1;
      return text;
    });
    add("version", [](std::string text) {
      text[text.find('\n') - 1] ^= 1;
      return text;
    });

    // Blocks, as a disk has them.
    add("zeroed block", [](std::string text) {
      std::size_t i = text.size() / 2;
      while (text[i] == '\0')
        ++i;
      return text.replace(i, 512, 512, '\0');
    });
    add("zeroed end", [](std::string text) {
      return text.replace(text.size() - 512, 512, 512, '\0');
    });
    add("zeroed beginning",
        [](std::string text) { return text.replace(0, 512, 512, '\0'); });
    add("all zeros",
        [](const std::string &text) { return std::string(text.size(), '\0'); });
    add("exchanged blocks", [](const std::string &text) {
      return text.substr(0, 1024) + text.substr(1536, 512) +
             text.substr(1024, 512) + text.substr(2048);
    });
    add("a block twice", [](std::string text) {
      return text.replace(2048, 512, text.substr(1024, 512));
    });
    add("another checkpoint's end",
        [other_checkpoint](const std::string &text) {
          return text.substr(0, text.size() / 2) +
                 other_checkpoint.substr(other_checkpoint.size() / 2);
        });
    add("exchanged bytes", [](std::string text) {
      std::size_t i = text.size() / 3;
      while (text[i] == text[i + 1])
        ++i;
      std::swap(text[i], text[i + 1]);
      return text;
    });

    // Copied as text.
    add("ends of lines", [](const std::string &text) {
      std::string result;
      for (const char character : text)
        result +=
          character == '\n' ? std::string("\r\n") : std::string(1, character);
      return result;
    });
    add("seven bits", [](std::string text) {
      for (char &character : text)
        character &= 0x7f;
      return text;
    });
    return all;
  }



  void
  write_text(const std::string &filename, const std::string &text)
  {
    std::ofstream(filename, std::ios::binary) << text;
  }



  /// The message with which a silo's checkpoint is refused; empty: it isn't.
  std::string
  refusal(const SmallRun &run)
  {
    try
      {
        run.find_checkpoint();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }



  /// Run to an end, and ask for a later one.
  void
  leave_two_checkpoints(SmallSilo &silo)
  {
    silo.stage.end_time             = 0.002;
    silo.output.checkpoint_interval = 0.001;
    SmallRun(silo).run();
    silo.stage.end_time = 0.003;
  }



  TEST(CheckpointFiles, forty_kinds_of_damage_are_refused_by_name)
  {
    SmallSilo silo;
    leave_two_checkpoints(silo);
    const SmallRun        run(silo);
    const CheckpointFiles files(silo.output.directory);
    const std::string     whole  = read_text(files.last);
    const std::string     before = read_text(files.before);
    EXPECT_EQ(refusal(run), "");

    const auto all = all_damage(before);
    EXPECT_EQ(all.size(), 40);
    for (const auto &[name, damage] : all)
      {
        const std::string damaged = damage(whole);
        ASSERT_NE(damaged, whole) << name;
        write_text(files.last, damaged);
        const std::string message = refusal(run);
        EXPECT_NE(message.find('\'' + files.last + "' is damaged"),
                  std::string::npos)
          << name << ": " << message;
        // The one before it is offered.
        EXPECT_NE(message.find("--restart-from " + files.before),
                  std::string::npos)
          << name << ": " << message;
      }
  }



  TEST(CheckpointFiles, damaged_one_before_is_not_offered)
  {
    SmallSilo silo;
    leave_two_checkpoints(silo);
    const SmallRun        run(silo);
    const CheckpointFiles files(silo.output.directory);
    for (const std::string &name : {files.last, files.before})
      write_text(name, "Sandglass checkpoint 9\n");
    EXPECT_EQ(refusal(run).find("--restart-from"), std::string::npos);
  }



  TEST(CheckpointFiles, another_version_is_told_from_damage)
  {
    SmallSilo silo;
    std::filesystem::create_directories(silo.output.directory);
    const CheckpointFiles files(silo.output.directory);
    files.write("content");
    EXPECT_EQ(read_checkpoint_content(files.last), "content");
    // With the checksum of that text.
    write_text(files.last,
               "Sandglass checkpoint 8\n"
               "2d2cf360");
    try
      {
        read_checkpoint_content(files.last);
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("of another version"),
                  std::string::npos)
          << error.what();
      }
  }



  TEST(CheckpointFiles, the_last_two_are_kept)
  {
    SmallSilo silo;
    std::filesystem::create_directories(silo.output.directory);
    const CheckpointFiles files(silo.output.directory);
    for (const std::string content : {"1", "2", "3"})
      files.write(content);
    EXPECT_EQ(read_checkpoint_content(files.last), "3");
    EXPECT_EQ(read_checkpoint_content(files.before), "2");
    const std::filesystem::directory_iterator all(silo.output.directory);
    EXPECT_EQ(std::distance(begin(all), end(all)), 2);
  }
} // namespace
