#include <sandglass/output/replace_file.h>
#include <sandglass/output/vtu_file.h>

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <type_traits>

namespace Sandglass
{
  const std::vector<std::string> VtuPiece::symmetric_tensor_components =
    {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};



  namespace
  {
    /// Without the part that has been written.
    [[noreturn]] void
    give_up(const std::string &filename)
    {
      const int       reason = errno;
      std::error_code ignored;
      std::filesystem::remove(filename, ignored);
      errno = reason;
      throw_unwritable(filename);
    }



    /// A VTK array that shows `values` without a copy.
    template <typename Number>
    vtkSmartPointer<vtkDataArray>
    wrap(const std::vector<Number> &values, const int n_components)
    {
      // VTK's 64 bits have another name than int64_t on some systems.
      using VtkNumber = std::conditional_t<std::is_same_v<Number, std::int64_t>,
                                           vtkTypeInt64,
                                           Number>;
      static_assert(sizeof(VtkNumber) == sizeof(Number));
      auto array = vtkSmartPointer<vtkAOSDataArrayTemplate<VtkNumber>>::New();
      array->SetNumberOfComponents(n_components);
      constexpr int keep_memory = 1;
      array->SetArray(const_cast<VtkNumber *>(
                        reinterpret_cast<const VtkNumber *>(values.data())),
                      values.size(),
                      keep_memory);
      return array;
    }



    vtkSmartPointer<vtkDataArray>
    wrap(const VtuPiece::Field &field)
    {
      const auto array = std::visit(
        [&field](const auto &values) {
          return wrap(values, field.n_components);
        },
        field.values);
      array->SetName(field.name.c_str());
      for (unsigned int c = 0; c < field.component_names.size(); ++c)
        array->SetComponentName(c, field.component_names[c].c_str());
      return array;
    }



    VTKCellType
    cell_type(const VtuPiece &piece)
    {
      switch (piece.points_per_cell)
        {
          case 1:
            return VTK_VERTEX;
          case 2:
            return VTK_LINE;
          case 3:
            return VTK_TRIANGLE;
          case 4:
            return piece.cell_dimension == 2 ? VTK_QUAD : VTK_TETRA;
          case 6:
            return VTK_QUADRATIC_TRIANGLE;
          default:
            return VTK_HEXAHEDRON;
        }
    }



    /// Element of the .pvtu that declares the fields of points or cells.
    void
    declare_fields(std::ostream                       &file,
                   const std::string                  &element,
                   const std::vector<VtuPiece::Field> &fields)
    {
      constexpr std::array<const char *, 4> types = {
        {"Float32", "Float64", "Int64", "Int32"}};

      file << "    <" << element << ">\n";
      for (const auto &field : fields)
        {
          file << "      <PDataArray type=\"" << types[field.values.index()]
               << "\" Name=\"" << field.name << "\" NumberOfComponents=\""
               << field.n_components << '"';
          for (unsigned int c = 0; c < field.component_names.size(); ++c)
            file << " ComponentName" << c << "=\"" << field.component_names[c]
                 << '"';
          file << "/>\n";
        }
      file << "    </" << element << ">\n";
    }
  } // namespace



  void
  write_vtu(const std::string &filename, const VtuPiece &piece)
  {
    vtkNew<vtkPoints> points;
    points->SetData(wrap(piece.points, 3));

    const std::size_t n_cells = piece.cells.size() / piece.points_per_cell;
    std::vector<std::int32_t> offsets(n_cells + 1);
    for (std::size_t i = 0; i < offsets.size(); ++i)
      offsets[i] = i * piece.points_per_cell;
    vtkNew<vtkCellArray> cells;
    cells->SetData(wrap(offsets, 1), wrap(piece.cells, 1));

    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->SetCells(cell_type(piece), cells);
    for (const auto &field : piece.point_fields)
      grid->GetPointData()->AddArray(wrap(field));
    for (const auto &field : piece.cell_fields)
      grid->GetCellData()->AddArray(wrap(field));

    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName(filename.c_str());
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    // The numbers' last digits are noise: zlib makes the files a third smaller,
    // but takes ten times as long.
    writer->SetCompressorTypeToLZ4();
    writer->SetCompressionLevel(1);
    errno = 0;
    if (writer->Write() == 0 || writer->GetErrorCode() != 0)
      give_up(filename);
  }



  void
  write_pvtu(const std::string              &filename,
             const VtuPiece                 &piece,
             const std::vector<std::string> &piece_names)
  {
    errno = 0;
    std::ofstream file(filename);
    file << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\">\n"
            "  <PUnstructuredGrid GhostLevel=\"0\">\n";
    declare_fields(file, "PPointData", piece.point_fields);
    declare_fields(file, "PCellData", piece.cell_fields);
    file << "    <PPoints>\n"
            "      <PDataArray type=\"Float64\" NumberOfComponents=\"3\"/>\n"
            "    </PPoints>\n";
    for (const auto &name : piece_names)
      file << "    <Piece Source=\"" << name << "\"/>\n";
    file << "  </PUnstructuredGrid>\n"
            "</VTKFile>\n";
    if (!file.flush())
      give_up(filename);
  }
} // namespace Sandglass
