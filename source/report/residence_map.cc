#include <sandglass/report/field_files.h>
#include <sandglass/report/residence_map.h>

#include <vtkDataArray.h>

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    namespace
    {
      /// Enough for a picture.
      constexpr int n_digits = 5;

      std::string
      list(const std::string &name, const std::vector<double> &values)
      {
        std::ostringstream text;
        text.precision(n_digits);
        text << ", \"" << name << "\": [";
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            text << (i == 0 ? "" : ", ");
            if (std::isfinite(values[i]))
              text << values[i];
            else
              text << "null";
          }
        text << ']';
        return text.str();
      }
    } // namespace



    std::string
    residence_map(const std::filesystem::path &file)
    {
      const auto    grid   = read_fields(file);
      vtkDataArray &times  = cell_field(*grid, "residence time", 1, file);
      vtkDataArray &shares = cell_field(*grid, "share that has left", 1, file);

      std::vector<double>   x, y, time, share;
      std::array<double, 6> box{};
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
        {
          grid->GetCellBounds(cell, box.data());
          x.push_back((box[0] + box[1]) / 2.);
          y.push_back((box[2] + box[3]) / 2.);
          time.push_back(times.GetComponent(cell, 0));
          share.push_back(shares.GetComponent(cell, 0));
        }
      std::ostringstream size;
      size.precision(n_digits);
      size << "{\"width\": " << box[1] - box[0]
           << ", \"height\": " << box[3] - box[2];
      return size.str() + list("x", x) + list("y", y) + list("time", time) +
             list("share", share) + '}';
    }
  } // namespace Report
} // namespace Sandglass
