#ifndef sandglass_continuum_in_plane_gradient_operator_h
#define sandglass_continuum_in_plane_gradient_operator_h

#include <sandglass/continuum/in_plane_response.h>

#include <boost/serialization/array_wrapper.hpp>

namespace Sandglass
{
  /**
   * Maps the displacement increments of a cell's nodes, two components each, to
   * their gradient at a point (see Gradient5), and what works on that gradient
   * back to the nodes. As a matrix, more than half of it would be zeros.
   */
  class InPlaneGradientOperator
  {
  public:
    template <int n_dofs>
    using CellVector = Eigen::Matrix<double, n_dofs, 1>;
    template <int n_dofs>
    using CellMatrix = Eigen::Matrix<double, n_dofs, n_dofs>;

    /// @param gradient    of node v's shape function at the point, in 1/m.
    /// @param hoop_share  the shape function over the radius, in 1/m; 0 without
    ///                    hoop strain.
    template <typename Vector>
    void
    set_node(const unsigned int v,
             const Vector      &gradient,
             const double       hoop_share)
    {
      gradients.col(v) << gradient[0], gradient[1];
      hoop[v]  = hoop_share;
      has_hoop = has_hoop || hoop_share != 0.;
    }

    /// Change to gradients with respect to the configuration that H leads to.
    void
    move_reference(const Gradient5 &H)
    {
      const Eigen::Matrix2d cofactor = InPlaneResponse::in_plane_cofactor(H);
      gradients = (cofactor / cofactor.determinant() * gradients).eval();
      hoop /= 1. + H[GradientComponent::hoop];
    }

    template <int n_dofs>
    Gradient5
    gradient(const CellVector<n_dofs> &increment) const
    {
      const auto &G = node_gradients<n_dofs>();
      const Eigen::Map<const Eigen::Matrix<double, 2, n_dofs / 2>> u(
        increment.data());
      Gradient5 H;
      H.head<2>()     = G * u.row(0).transpose();
      H.segment<2>(2) = G * u.row(1).transpose();
      H[GradientComponent::hoop] =
        has_hoop ? u.row(0).dot(hoop.head<n_dofs / 2>()) : 0.;
      return H;
    }

    /// The transpose: nodal forces per volume of a Piola stress in Pa.
    template <int n_dofs>
    CellVector<n_dofs>
    nodal_forces(const Gradient5 &piola_stress) const
    {
      const auto        &G = node_gradients<n_dofs>();
      CellVector<n_dofs> result;
      Eigen::Map<Eigen::Matrix<double, 2, n_dofs / 2>> force(result.data());
      force.row(0) = piola_stress.head<2>().transpose() * G;
      force.row(1) = piola_stress.segment<2>(2).transpose() * G;
      if (has_hoop)
        force.row(0) += piola_stress[GradientComponent::hoop] *
                        hoop.head<n_dofs / 2>().transpose();
      return result;
    }

    /// Derivative of nodal_forces() with respect to the increments, if that of
    /// the Piola stress with respect to the gradient is `tangent`, in Pa.
    template <int n_dofs>
    CellMatrix<n_dofs>
    stiffness(const Matrix5 &tangent) const
    {
      const auto                      &G = node_gradients<n_dofs>();
      Eigen::Matrix<double, 5, n_dofs> stress;
      CellMatrix<n_dofs>               result;
      for (int v = 0; v < n_dofs / 2; ++v)
        {
          stress.col(2 * v)     = tangent.leftCols<2>() * G.col(v);
          stress.col(2 * v + 1) = tangent.middleCols<2>(2) * G.col(v);
          if (has_hoop)
            stress.col(2 * v) += tangent.col(GradientComponent::hoop) * hoop[v];
        }
      for (int v = 0; v < n_dofs / 2; ++v)
        {
          result.row(2 * v) =
            G.col(v).transpose() * stress.template topRows<2>();
          result.row(2 * v + 1) =
            G.col(v).transpose() * stress.template middleRows<2>(2);
          if (has_hoop)
            result.row(2 * v) += hoop[v] * stress.row(GradientComponent::hoop);
        }
      return result;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &boost::serialization::make_array(gradients.data(),
                                                gradients.size());
      archive &boost::serialization::make_array(hoop.data(), hoop.size());
      archive &has_hoop;
    }

  private:
    template <int n_dofs>
    auto
    node_gradients() const
    {
      return gradients.leftCols<n_dofs / 2>();
    }

    /// A quadratic triangle's; other cells use fewer.
    static constexpr int most_nodes = 6;

    using NodeGradients = Eigen::Matrix<double, 2, most_nodes>;
    using NodeValues    = Eigen::Matrix<double, most_nodes, 1>;

    NodeGradients gradients = NodeGradients::Zero();
    NodeValues    hoop      = NodeValues::Zero();
    bool          has_hoop  = false;
  };
} // namespace Sandglass

#endif
