#include <deal.II/base/quadrature_lib.h>

#include <sandglass/particles/cell_integrals.h>

namespace Sandglass
{
  namespace
  {
    /// Exact for polynomials of degree 2.
    const Quadrature<dim> &
    quadrature_of(const CellShape<CellType::triangle> &)
    {
      static const QGaussSimplex<dim> quadrature(2);
      return quadrature;
    }



    /// Exact for polynomials of degree 3 in each coordinate; gradients times
    /// the Jacobian are polynomials.
    const Quadrature<dim> &
    quadrature_of(const CellShape<CellType::quadrilateral> &)
    {
      static const QGauss<dim> quadrature(2);
      return quadrature;
    }
  } // namespace



  template <CellType cell_type>
  CellIntegrals<cell_type>
  integrate_over(const CellShape<cell_type> &shape,
                 const Formulation           formulation)
  {
    const Quadrature<dim>   &quadrature = quadrature_of(shape);
    CellIntegrals<cell_type> result;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<dim> &point = quadrature.point(q);
        const double      area  = quadrature.weight(q) * shape.jacobian(point);
        const auto        gradients    = shape.shape_gradients(point);
        const auto        shape_values = shape.shape_values(point);
        double            volume       = area;
        if (formulation == Formulation::axisymmetric)
          volume *= 2. * numbers::PI * shape.to_real(point)[0];
        result.volume += volume;
        for (unsigned int i = 0; i < result.n_nodes; ++i)
          {
            for (unsigned int d = 0; d < dim; ++d)
              result.gradients[i][d] += volume * gradients[i][d];
            if (formulation == Formulation::axisymmetric)
              result.values_over_radius[i] +=
                2. * numbers::PI * area * shape_values[i];
          }
      }
    return result;
  }



  template CellIntegrals<CellType::triangle>
  integrate_over(const CellShape<CellType::triangle> &, const Formulation);
  template CellIntegrals<CellType::quadrilateral>
  integrate_over(const CellShape<CellType::quadrilateral> &, const Formulation);
} // namespace Sandglass
