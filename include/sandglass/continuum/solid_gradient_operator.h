#ifndef sandglass_continuum_solid_gradient_operator_h
#define sandglass_continuum_solid_gradient_operator_h

#include <sandglass/continuum/solid_response.h>

#include <boost/serialization/array_wrapper.hpp>

namespace Sandglass
{
  /**
   * Maps the displacement increments of a cell's nodes, three components each,
   * to their gradient at a point (see Gradient9), and what works on that
   * gradient back to the nodes.
   */
  class SolidGradientOperator
  {
  public:
    template <int n_dofs>
    using CellVector = Eigen::Matrix<double, n_dofs, 1>;
    template <int n_dofs>
    using CellMatrix = Eigen::Matrix<double, n_dofs, n_dofs>;

    /// @param gradient  of node v's shape function at the point, in 1/m.
    template <typename Vector>
    void
    set_node(const unsigned int v,
             const Vector      &gradient,
             const double /*hoop_share*/)
    {
      gradients.col(v) << gradient[0], gradient[1], gradient[2];
    }

    /// Change to gradients with respect to the configuration that H leads to.
    void
    move_reference(const Gradient9 &H)
    {
      gradients = (SolidResponse::cofactor(H) / SolidResponse::volume_ratio(H) *
                   gradients)
                    .eval();
    }

    template <int n_dofs>
    Gradient9
    gradient(const CellVector<n_dofs> &increment) const
    {
      const Eigen::Map<const Eigen::Matrix<double, 3, n_dofs / 3>> u(
        increment.data());
      Gradient9 H;
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(H.data()) =
        u * node_gradients<n_dofs>().transpose();
      return H;
    }

    /// The transpose: nodal forces per volume of a Piola stress in Pa.
    template <int n_dofs>
    CellVector<n_dofs>
    nodal_forces(const Gradient9 &piola_stress) const
    {
      CellVector<n_dofs> result;
      Eigen::Map<Eigen::Matrix<double, 3, n_dofs / 3>>(result.data()) =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
          piola_stress.data()) *
        node_gradients<n_dofs>();
      return result;
    }

    /// Derivative of nodal_forces() with respect to the increments, if that of
    /// the Piola stress with respect to the gradient is `tangent`, in Pa.
    template <int n_dofs>
    CellMatrix<n_dofs>
    stiffness(const Matrix9 &tangent) const
    {
      const auto                      &G = node_gradients<n_dofs>();
      Eigen::Matrix<double, 9, n_dofs> stress;
      CellMatrix<n_dofs>               result;
      for (int v = 0; v < n_dofs / 3; ++v)
        for (int d = 0; d < 3; ++d)
          stress.col(3 * v + d) = tangent.middleCols<3>(3 * d) * G.col(v);
      for (int v = 0; v < n_dofs / 3; ++v)
        for (int d = 0; d < 3; ++d)
          result.row(3 * v + d) =
            G.col(v).transpose() * stress.template middleRows<3>(3 * d);
      return result;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &boost::serialization::make_array(gradients.data(),
                                                gradients.size());
    }

  private:
    template <int n_dofs>
    auto
    node_gradients() const
    {
      return gradients.leftCols<n_dofs / 3>();
    }

    /// A hexahedron's; a tetrahedron has fewer.
    static constexpr int most_nodes = 8;

    using NodeGradients = Eigen::Matrix<double, 3, most_nodes>;

    NodeGradients gradients = NodeGradients::Zero();
  };
} // namespace Sandglass

#endif
