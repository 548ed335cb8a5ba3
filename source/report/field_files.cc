#include <sandglass/base/exceptions.h>
#include <sandglass/report/field_files.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringOutputWindow.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace Sandglass
{
  namespace Report
  {
    std::vector<FieldFile>
    read_pvd(const std::filesystem::path &file)
    {
      std::vector<FieldFile> files;
      if (!std::filesystem::exists(file))
        return files;
      try
        {
          boost::property_tree::ptree tree;
          boost::property_tree::read_xml(file.string(), tree);
          for (const auto &[element, content] :
               tree.get_child("VTKFile.Collection"))
            if (element == "DataSet")
              files.push_back({content.get<double>("<xmlattr>.timestep"),
                               file.parent_path() /
                                 content.get<std::string>("<xmlattr>.file")});
        }
      catch (const boost::property_tree::ptree_error &error)
        {
          throw InputError("'" + file.string() +
                           "' is damaged: " + error.what() + '.');
        }
      return files;
    }



    namespace
    {
      /// VTK's readers tell of errors in its window for messages only.
      template <typename Reader>
      vtkSmartPointer<vtkUnstructuredGrid>
      read_with(const std::filesystem::path &file)
      {
        vtkNew<vtkStringOutputWindow> messages;
        vtkOutputWindow::SetInstance(messages);
        vtkNew<Reader> reader;
        reader->SetFileName(file.c_str());
        reader->Update();
        const bool failed = !messages->GetOutput().empty();
        vtkOutputWindow::SetInstance(nullptr);
        if (failed)
          throw InputError("'" + file.string() +
                           "' is damaged: VTK can't read it.");
        return reader->GetOutput();
      }
    } // namespace



    vtkSmartPointer<vtkUnstructuredGrid>
    read_fields(const std::filesystem::path &file)
    {
      if (!std::filesystem::exists(file))
        throw InputError("'" + file.string() + "' is missing.");
      return file.extension() == ".pvtu" ?
               read_with<vtkXMLPUnstructuredGridReader>(file) :
               read_with<vtkXMLUnstructuredGridReader>(file);
    }



    namespace
    {
      vtkDataArray &
      find_field(vtkFieldData                &fields,
                 const std::string           &name,
                 const int                    n_components,
                 const std::filesystem::path &file)
      {
        vtkDataArray *const field = fields.GetArray(name.c_str());
        if (field == nullptr || field->GetNumberOfComponents() != n_components)
          throw InputError("'" + file.string() + "' has no field '" + name +
                           "': it is damaged, or of another program.");
        return *field;
      }
    } // namespace



    vtkDataArray &
    point_field(vtkUnstructuredGrid         &grid,
                const std::string           &name,
                const int                    n_components,
                const std::filesystem::path &file)
    {
      return find_field(*grid.GetPointData(), name, n_components, file);
    }



    vtkDataArray &
    cell_field(vtkUnstructuredGrid         &grid,
               const std::string           &name,
               const int                    n_components,
               const std::filesystem::path &file)
    {
      return find_field(*grid.GetCellData(), name, n_components, file);
    }
  } // namespace Report
} // namespace Sandglass
