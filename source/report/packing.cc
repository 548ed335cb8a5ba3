#include <sandglass/report/packing.h>

#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <stdexcept>

namespace Sandglass
{
  namespace Report
  {
    std::string
    pack(const std::vector<std::uint8_t> &bytes)
    {
      vtkNew<vtkZLibDataCompressor> compressor;
      compressor->SetCompressionLevel(9);
      std::vector<std::uint8_t> compressed(
        compressor->GetMaximumCompressionSpace(bytes.size()));
      compressed.resize(compressor->Compress(
        bytes.data(), bytes.size(), compressed.data(), compressed.size()));
      if (compressed.empty())
        throw std::runtime_error("zlib can't compress: out of memory?");

      std::string text((compressed.size() + 2) / 3 * 4, '=');
      vtkBase64Utilities::Encode(compressed.data(),
                                 compressed.size(),
                                 reinterpret_cast<unsigned char *>(
                                   text.data()));
      return text;
    }



    std::string
    pack(const std::string &text)
    {
      return pack(std::vector<std::uint8_t>(text.begin(), text.end()));
    }



    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char character : text)
        switch (character)
          {
            case '<':
              result += "&lt;";
              break;
            case '&':
              result += "&amp;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += character;
          }
      return result;
    }
  } // namespace Report
} // namespace Sandglass
