#include <sandglass/output/field_series.h>
#include <sandglass/output/grid_fields.h>
#include <sandglass/output/particle_fields.h>

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>

#include "empty_flow.h"
#include "output_silo.h"

using namespace Sandglass;

namespace
{
  /// A .vtu as VTK reads it.
  class VtuReader
  {
  public:
    explicit VtuReader(const std::string &filename)
    {
      reader->SetFileName(filename.c_str());
      reader->Update();
    }

    vtkUnstructuredGrid *
    operator->()
    {
      return reader->GetOutput();
    }

    vtkDataArray *
    field(const char *name)
    {
      auto *array = reader->GetOutput()->GetPointData()->GetArray(name);
      if (array == nullptr)
        throw std::runtime_error(std::string("no field ") + name);
      return array;
    }

  private:
    vtkNew<vtkXMLUnstructuredGridReader> reader;
  };



  constexpr double sink = 1e-3;

  /// Particles with a displacement and a stress that tells its components.
  void
  give_state(DynamicFlow<2> &flow)
  {
    flow.start_from(
      [](const unsigned int, const Point<2> &) {
        return InitialState<2>{Tensor<1, 2>({0., -sink}),
                               SymmetricComponents<4>(-1., -2., -4., 8.),
                               1.,
                               {}};
      },
      {});
  }



  Layers
  layers_of(const Scene<2> &scene)
  {
    return {scene.fill_bottom, scene.fill_top};
  }



  TEST(ParticleFields, read_back_by_vtk)
  {
    SmallSilo silo;
    SmallRun  run(silo);
    give_state(run.flow);
    const std::string filename = SmallSilo::unique_path() + ".vtu";
    write_vtu(filename, particle_fields(run.view(), layers_of(run.scene)));
    VtuReader vtu(filename);
    std::filesystem::remove(filename);

    const unsigned int n = run.view().n_particles();
    ASSERT_GT(n, 100);
    ASSERT_EQ(vtu->GetNumberOfPoints(), n);
    EXPECT_EQ(vtu->GetNumberOfCells(), n);

    auto *stress = vtu.field("stress");
    ASSERT_EQ(stress->GetNumberOfComponents(), 6);
    const std::vector<std::pair<std::string, double>> expected_stress = {
      {"XX", -1.},
      {"YY", -2.},
      {"ZZ", -4.},
      {"XY", 8.},
      {"YZ", 0.},
      {"XZ", 0.}};
    double mass = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int c = 0; c < 6; ++c)
          {
            EXPECT_EQ(stress->GetComponentName(c), expected_stress[c].first);
            EXPECT_EQ(stress->GetComponent(i, c), expected_stress[c].second);
          }
        EXPECT_FLOAT_EQ(vtu.field("pressure")->GetTuple1(i), 7. / 3.);
        EXPECT_FLOAT_EQ(vtu.field("density")->GetTuple1(i), 1500.);
        EXPECT_NEAR(vtu.field("displacement")->GetComponent(i, 1), -sink, 1e-9);
        // 16 layers of 0.05 m of the initial height, the first at the top
        const double height = (vtu->GetPoint(i)[1] + sink) / 0.05;
        if (std::abs(height - std::round(height)) > 1e-3)
          {
            EXPECT_EQ(vtu.field("layer")->GetTuple1(i),
                      16. - std::floor(height));
          }
        mass += vtu.field("mass")->GetTuple1(i);
      }
    EXPECT_NEAR(mass, 1500. * 0.4 * 0.8, 1e-9);
  }



  TEST(ParticleFields, layers_of_a_row_on_the_edge_of_two)
  {
    SmallSilo      silo;
    const SmallRun run(silo);
    const Layers   layers = layers_of(run.scene);
    const double   edge   = 0.4;
    EXPECT_EQ(layers.of(Point<3>(0.1, edge - 1e-15, 0.)), 9);
    EXPECT_EQ(layers.of(Point<3>(0.1, edge + 1e-15, 0.)), 9);
    EXPECT_EQ(layers.of(Point<3>(0.1, 0.8, 0.)), 1);
    EXPECT_EQ(layers.of(Point<3>(0.1, 0., 0.)), 16);
  }



  /// One particle, and what a law with state variables has left in it.
  class FlowWithLawState : public EmptyFlow
  {
    std::vector<StateVariable>
    state_variables() const override
    {
      return {{"void ratio", "1", 1}, {"fabric", "1", 6}};
    }

    unsigned int
    n_particles() const override
    {
      return 1;
    }

    void
    for_each_particle(const std::function<void(const ParticleRecord &)>
                        &function) const override
    {
      const std::array<double, 7> state = {{0.5, 1., 2., 3., 4., 5., 6.}};
      ParticleRecord              particle{};
      particle.law_state = state.data();
      function(particle);
    }
  };



  TEST(ParticleFields, state_variables_of_the_law)
  {
    const VtuPiece piece =
      particle_fields(FlowWithLawState().view(), Layers{0., 1.});
    ASSERT_EQ(piece.point_fields.size(), particle_table.size() + 2);
    const auto &fields = piece.point_fields;
    EXPECT_EQ(fields[fields.size() - 2].name, "void ratio");
    EXPECT_EQ(std::get<std::vector<float>>(fields[fields.size() - 2].values),
              std::vector<float>({0.5}));
    EXPECT_EQ(std::get<std::vector<float>>(fields.back().values),
              std::vector<float>({1., 2., 3., 4., 5., 6.}));
    EXPECT_EQ(fields.back().component_names[3], "XY");
  }



  void
  check_grid(const CellType cell_type, const int vtk_cell_type)
  {
    SmallSilo silo;
    silo.scene.cell_type = cell_type;
    SmallRun run(silo);
    run.flow.step();
    const std::string filename = SmallSilo::unique_path() + ".vtu";
    write_vtu(filename, grid_fields(run.view(), 2));
    VtuReader vtu(filename);
    std::filesystem::remove(filename);

    ASSERT_EQ(vtu->GetNumberOfCells(),
              run.scene.triangulation.n_active_cells());
    EXPECT_EQ(vtu->GetNumberOfPoints(), run.scene.dof_handler.n_dofs());
    double area = 0.;
    for (int c = 0; c < vtu->GetNumberOfCells(); ++c)
      {
        EXPECT_EQ(vtu->GetCellType(c), vtk_cell_type);
        // The shoelace formula is positive for counterclockwise points.
        vtkPoints *points    = vtu->GetCell(c)->GetPoints();
        const int  n         = points->GetNumberOfPoints();
        double     cell_area = 0.;
        for (int i = 0; i < n; ++i)
          {
            double a[3], b[3];
            points->GetPoint(i, a);
            points->GetPoint((i + 1) % n, b);
            cell_area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
          }
        EXPECT_GT(cell_area, 0.);
        area += cell_area;
      }
    EXPECT_NEAR(area, 0.4 * 0.8 + 0.2 * 0.1, 1e-12);

    double mass = 0., momentum = 0.;
    for (int i = 0; i < vtu->GetNumberOfPoints(); ++i)
      {
        mass += vtu.field("mass")->GetTuple1(i);
        momentum += vtu.field("mass")->GetTuple1(i) *
                    vtu.field("velocity")->GetComponent(i, 1);
      }
    EXPECT_NEAR(mass, 480., 1e-4);
    EXPECT_LT(momentum, 0.);

    auto  *n_particles = vtu->GetCellData()->GetArray("number of particles");
    double sum         = 0.;
    for (int c = 0; c < vtu->GetNumberOfCells(); ++c)
      sum += n_particles->GetTuple1(c);
    EXPECT_EQ(sum, run.view().n_particles());
  }



  TEST(GridFields, triangles)
  {
    check_grid(CellType::triangle, VTK_TRIANGLE);
  }



  TEST(GridFields, quadrilaterals)
  {
    check_grid(CellType::quadrilateral, VTK_QUAD);
  }



  TEST(VtuFile, piece_of_a_rank_without_particles)
  {
    VtuPiece piece;
    piece.point_fields         = {{"value", 3, std::vector<float>(), {}},
                                  {"id", 1, std::vector<std::int64_t>(), {}}};
    const std::string filename = SmallSilo::unique_path() + ".vtu";
    write_vtu(filename, piece);
    VtuReader vtu(filename);
    std::filesystem::remove(filename);
    EXPECT_EQ(vtu->GetNumberOfPoints(), 0);
    EXPECT_EQ(vtu.field("value")->GetNumberOfComponents(), 3);
  }



  TEST(FieldSeries, pvd_lists_all_times)
  {
    const std::string directory = SmallSilo::unique_path();
    std::filesystem::create_directories(directory + "/vtu");
    FieldSeries series(directory, "dots", MPI_COMM_SELF);
    VtuPiece    piece;
    piece.points       = {0., 0., 0.};
    piece.cells        = {0};
    piece.point_fields = {{"value", 1, std::vector<double>{1.5}, {}}};
    series.write(0., piece);
    series.write(0.25, piece);
    const std::string pvd = read_text(directory + "/dots.pvd");
    EXPECT_NE(pvd.find("timestep=\"0.25\""), std::string::npos);
    EXPECT_NE(pvd.find("file=\"vtu/dots_00001.vtu\""), std::string::npos);
    EXPECT_EQ(
      VtuReader(directory + "/vtu/dots_00001.vtu").field("value")->GetTuple1(0),
      1.5);
    std::filesystem::remove_all(directory);
  }
} // namespace
