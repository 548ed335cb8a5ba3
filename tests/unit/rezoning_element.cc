// Triangles with three and six nodes.

#include <deal.II/fe/fe_simplex_p.h>

#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <gtest/gtest.h>

using namespace Sandglass;

// deal.II's numbering of six-node triangles is the one that the meshes have.
TEST(RezoningElement, NodesAreNumberedAsDealIIDoes)
{
  for (const unsigned int order : {1, 2})
    {
      const FE_SimplexP<2> element(order);
      ASSERT_EQ(element.n_dofs_per_cell(), 3 * order);
      for (unsigned int i = 0; i < 3 * order; ++i)
        {
          EXPECT_LT(element.get_unit_support_points()[i].distance(
                      reference_nodes[i]),
                    1e-15);
          const Point<2> p(0.2, 0.37);
          EXPECT_NEAR(element.shape_value(i, p),
                      shape_values(order, p)[i],
                      1e-15);
          EXPECT_LT(
            (element.shape_grad(i, p) - shape_gradients(order, p)[i]).norm(),
            1e-14);
        }
    }
}
