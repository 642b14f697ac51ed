#ifndef asperity_flow_fluid_cell_h
#define asperity_flow_fluid_cell_h

#include <asperity/flow/fluid_assembler.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <array>

// What the parts of the FluidAssembler share while they integrate a cell.

namespace asperity
{
  /** The fields at a quadrature point; names as in the class description. */
  struct FluidAssembler::Point
  {
    unsigned int         q;
    double               JxW;
    dealii::Tensor<1, 2> acceleration; // dv/dt|_X + c.grad v - b
    dealii::Tensor<1, 2> c;            // v - w_mesh, or 0 without convection
    dealii::Tensor<2, 2> grad_v;
    dealii::Tensor<2, 2> D;
    double               div_v;
    double               p;
    double               rate; // of shear
    ViscosityValue       eta;

    // Of a compressible fluid
    double               r = 1.;
    dealii::Tensor<1, 2> grad_r;
    dealii::Tensor<1, 2> b;              // v - w_mesh
    double               dilation  = 0.; // a_0 + div(v - w_mesh)
    double               mass_rate = 0.; // a_0 r - r div w_mesh + b.grad r
    double               r_dot     = 0.; // dr/dt|_X + b.grad r
    double               excess    = 0.; // e
  };



  /** One cell: shape functions, fields, results. Shape functions of one
   *  velocity component are numbered a, those of the pressure k. */
  struct FluidAssembler::Cell
  {
    static constexpr unsigned int dim = 2;

    Cell(const FluidSpace &space,
         const MovingMesh &mesh,
         const bool        is_compressible)
      : fe(space.dofs().get_fe())
      , quadrature(fe.degree + 1)
      , stabilised(space.element() == FluidElement::equal_order)
      , is_compressible(is_compressible)
      , flow(mesh.mapping(), fe, quadrature, flags(stabilised))
      , geometry(mesh.mapping(),
                 space.geometry_dofs().get_fe(),
                 quadrature,
                 is_compressible ?
                   dealii::update_values | dealii::update_gradients :
                   dealii::update_values)
      , n_velocity(fe.base_element(0).n_dofs_per_cell())
      , n_pressure(fe.base_element(1).n_dofs_per_cell())
      , dofs(fe.n_dofs_per_cell())
      , R(dofs.size())
      , size(dofs.size())
      , K(dofs.size(), dofs.size())
      , v(quadrature.size())
      , rate(quadrature.size())
      , w(quadrature.size())
      , grad_p(quadrature.size())
      , grad_v(quadrature.size())
      , p(quadrature.size())
      , div_w(quadrature.size())
      , r_history(quadrature.size())
      , r(n_pressure)
      , dr(n_pressure)
      , N(n_velocity)
      , g(n_velocity)
      , H(n_velocity)
      , M(n_pressure)
      , m(n_pressure)
      , second_derivatives(quadrature.size())
    {
      for (unsigned int a = 0; a < n_velocity; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          index[i].push_back(fe.component_to_system_index(i, a));
      for (unsigned int k = 0; k < n_pressure; ++k)
        index[dim].push_back(fe.component_to_system_index(dim, k));
    }

    static dealii::UpdateFlags
    flags(const bool stabilised)
    {
      const auto basic = dealii::update_values | dealii::update_gradients |
                         dealii::update_JxW_values |
                         dealii::update_quadrature_points;
      return stabilised ? basic | dealii::update_hessians |
                            dealii::update_inverse_jacobians :
                          basic;
    }

    /** Copies the shape functions at a point. */
    void
    load(const unsigned int q)
    {
      for (unsigned int a = 0; a < n_velocity; ++a)
        {
          N[a] = flow.shape_value(index[0][a], q);
          g[a] = flow.shape_grad(index[0][a], q);
          if (stabilised)
            H[a] = flow.shape_hessian(index[0][a], q);
        }
      for (unsigned int k = 0; k < n_pressure; ++k)
        {
          M[k] = flow.shape_value(index[dim][k], q);
          if (stabilised || is_compressible)
            m[k] = flow.shape_grad(index[dim][k], q);
        }
    }

    const dealii::FiniteElement<2> &fe;
    const dealii::QGauss<2>         quadrature;
    const bool                      stabilised, is_compressible;
    dealii::FEValues<2>             flow, geometry;
    const unsigned int              n_velocity, n_pressure;

    std::vector<dealii::types::global_dof_index> dofs;
    std::array<std::vector<unsigned int>, 3> index; // component -> functions

    dealii::Vector<double>     R, size;
    dealii::FullMatrix<double> K;

    std::vector<dealii::Tensor<1, 2>> v, rate, w, grad_p;
    std::vector<dealii::Tensor<2, 2>> grad_v;
    std::vector<double>               p, div_w, r_history;
    std::vector<double>               r, dr; // nodal, and the derivative by p

    std::vector<double>               N; // velocity functions
    std::vector<dealii::Tensor<1, 2>> g; // their gradients
    std::vector<dealii::Tensor<2, 2>> H; // their second derivatives
    std::vector<double>               M; // pressure functions
    std::vector<dealii::Tensor<1, 2>> m; // their gradients

    std::vector<dealii::Tensor<3, 2>>
      second_derivatives; // of v: [i][j][l] = v_i,jl
  };
} // namespace asperity

#endif
