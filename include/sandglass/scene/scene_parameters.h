#ifndef sandglass_scene_scene_parameters_h
#define sandglass_scene_scene_parameters_h

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/partition.h>
#include <sandglass/scene/resolution.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Section `Scene`: the silo's half or whole section, or in three dimensions
   * its quarter, half or whole; its mesh, and where material is at the start.
   * Lengths in m.
   */
  class SceneParameters : public dealii::ParameterAcceptor
  {
  public:
    SceneParameters();

    enum class Shape
    {
      silo,
      mesh_file
    };

    enum class MeshAlgorithm
    {
      frontal_delaunay,
      delaunay,
      mesh_adapt
    };

    /// The silo seen from above (three dimensions), and its outlet.
    enum class CrossSection
    {
      rectangle,
      circle
    };
    enum class OutletShape
    {
      slot,
      circle,
      rectangle
    };

    /// Which symmetry planes end the mesh (three dimensions).
    enum class SymmetryPlanes
    {
      automatic,
      none,
      x,
      z,
      x_and_z
    };

    Formulation           formulation = Formulation::plane_strain;
    Shape                 shape       = Shape::silo;
    std::string           mesh_file;
    bool                  is_symmetric        = true;
    double                outlet_eccentricity = 0.;
    double                half_width          = 0.80;
    double                wall_height         = 1.70;
    double                outlet_half_width   = 0.225;
    double                hopper_height       = 0.;
    double                fall_region_depth   = 0.65;
    std::optional<double> headroom; ///< none: as the program chooses

    /// In three dimensions only.
    CrossSection          cross_section = CrossSection::rectangle;
    std::optional<double> half_depth; ///< none: as the half width
    OutletShape           outlet_shape = OutletShape::slot;
    std::optional<double> outlet_half_depth; ///< none: as its half width
    double                outlet_eccentricity_along_z = 0.;
    SymmetryPlanes        chosen_symmetry_planes = SymmetryPlanes::automatic;

    /// How fine, as far as the user says; what has no value is chosen. See
    /// resolution().
    std::optional<double>       element_size;
    std::optional<double>       outlet_element_size; ///< 0: as element_size
    std::optional<unsigned int> particles_per_cell;
    /// Edges of cells become shorter by this factor.
    double refinement = 1.;

    MeshAlgorithm mesh_algorithm = MeshAlgorithm::frontal_delaunay;
    unsigned int  mesh_seed      = 1;
    CellType      cell_type      = CellType::triangle;
    bool          outlet_is_open = true;
    Partitioner   partitioner    = Partitioner::metis;

    /// In m/s^2.
    std::vector<double> gravity{0., -9.81};

    std::optional<double> fill_height;              ///< none: to the top
    double                surface_slope       = 0.; ///< of a heap, in degrees
    bool                  is_filled_in_layers = false;
    unsigned int          n_layers            = 10;

    /// The same as a vector of the grid.
    template <int dim>
    dealii::Tensor<1, dim>
    gravity_vector() const
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim && d < gravity.size(); ++d)
        result[d] = gravity[d];
      return result;
    }

    /// Half length along z of a rectangular silo, given or as its half width,
    /// in m.
    double
    whole_half_depth() const
    {
      return half_depth.value_or(half_width);
    }

    /// Whether the mesh of a body ends at the planes x = 0 and z = 0: as given,
    /// or where the outlet lies in the middle.
    std::array<bool, 2>
    symmetry_planes() const;

    /// Height of the silo's top above the outlet level, in m.
    double
    silo_height() const
    {
      return hopper_height + wall_height;
    }

    /// How fine the silo is computed: the numbers given or fixed, those chosen
    /// where there are none, and all cells smaller by the refinement.
    Resolution
    resolution() const;

    /// Height of the empty cells above the material, given or chosen, in m.
    double
    headroom_height() const;

    /**
     * Give the parameters that are `auto` the numbers chosen, as if they stood
     * in the parameter file: then parameters.prm repeats the run, whatever a
     * later version of the program would choose.
     *
     * @param wave_speed  see automatic_resolution().
     */
    void
    fix_resolution(const double wave_speed);

    /// Throws InputError where values contradict each other.
    void
    check() const;

  private:
    /// The parameters of silos in three dimensions.
    void
    declare_body();

    /// The part of check() for them, and for what they must not be in two.
    void
    check_body() const;

    /// The same without the refinement; see automatic_resolution().
    Resolution
    unrefined_resolution(const double wave_speed) const;

    /// The part of check() for whole sections and outlets beside the middle.
    void
    check_symmetry() const;

    /// The part of check() for lengths of cells.
    void
    check_element_size() const;
  };
} // namespace Sandglass

#endif
