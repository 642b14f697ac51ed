#ifndef asperity_flow_fluid_cell_h
#define asperity_flow_fluid_cell_h

#include <asperity/flow/fluid_assembler.h>
#include <asperity/flow/shape_table.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/full_matrix.h>

#include <array>

// What the parts of the FluidAssembler share while they integrate a cell.

namespace asperity
{
  /** The shape functions on the reference cell. */
  struct FluidAssembler::Shapes
  {
    explicit Shapes(const FluidSpace &space)
      : is_stabilised(space.element() == FluidElement::equal_order)
      , quadrature(space.dofs().get_fe().degree + 1)
      , velocity(space.dofs().get_fe().base_element(0),
                 quadrature.get_points(),
                 is_stabilised)
      , pressure(space.dofs().get_fe().base_element(1), quadrature.get_points())
      , geometry(space.geometry_dofs().get_fe().base_element(0),
                 quadrature.get_points(),
                 is_stabilised)
    {}

    const bool              is_stabilised;
    const dealii::QGauss<2> quadrature;
    const ShapeTable        velocity, pressure, geometry;
  };



  /** The fields at a quadrature point; names as in the class description. */
  struct FluidAssembler::Point
  {
    double               JxW;
    dealii::Tensor<2, 2> inverse_jacobian; // d xi/d x
    dealii::Tensor<1, 2> v, w;
    dealii::Tensor<1, 2> history;      // of the rate of v
    dealii::Tensor<1, 2> acceleration; // dv/dt|_X + c.grad v - b
    dealii::Tensor<1, 2> c;            // v - w, or -w without convection
    dealii::Tensor<2, 2> grad_v;
    dealii::Tensor<2, 2> D;
    double               div_v;
    double               p;
    double               rate; // of shear
    ViscosityValue       eta;

    // Of a compressible fluid
    double               r = 1.;
    dealii::Tensor<1, 2> grad_r;
    dealii::Tensor<1, 2> b;              // v - w
    double               dilation  = 0.; // a_0 + div(v - w)
    double               mass_rate = 0.; // a_0 r - r div w + b.grad r
    double               r_dot     = 0.; // dr/dt|_X + b.grad r
    double               excess    = 0.; // e
  };



  /** One cell: nodal values, shape functions at a point, results. Shape
   *  functions of one velocity component are numbered a, those of the pressure
   *  k, those of the mesh l. */
  struct FluidAssembler::Cell
  {
    static constexpr unsigned int dim = 2;

    Cell(const FluidSpace &space, const Shapes &shapes)
      : unknowns(space.dofs().get_fe())
      , mesh_unknowns(space.geometry_dofs().get_fe())
      , dofs(unknowns.dofs())
      , index{{unknowns.functions(0),
               unknowns.functions(1),
               unknowns.functions(2)}}
      , n_velocity(shapes.velocity.n_functions())
      , n_pressure(shapes.pressure.n_functions())
      , R(dofs.size())
      , size(dofs.size())
      , K(dofs.size(), dofs.size())
      , r(n_pressure)
      , dr(n_pressure)
      , g(n_velocity)
      , m(n_pressure)
      , H(n_velocity)
    {}

    CellUnknowns                                        unknowns, mesh_unknowns;
    const std::vector<dealii::types::global_dof_index> &dofs;
    const std::array<std::vector<unsigned int>, 3> index; // component, function
    const unsigned int                             n_velocity, n_pressure;

    dealii::Vector<double>     R, size;
    dealii::FullMatrix<double> K;

    // Nodal values
    NodalVectors        v, history; // history of the rate of v
    NodalVectors        x, w;       // of the mesh
    std::vector<double> p, r_history;
    std::vector<double> r, dr; // density ratio, and its derivative by p

    // At a point
    const double                     *N, *M; // velocity, pressure functions
    std::vector<dealii::Tensor<1, 2>> g, m;  // their gradients
    std::vector<dealii::Tensor<2, 2>> H;     // second derivatives of N
  };
} // namespace asperity

#endif
