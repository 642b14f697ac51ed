#include <asperity/base/errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools_mean_value.h>

#include <algorithm>

#include "problems.h"

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  Tensor<1, 2>
  FluidStructureProblem::displacement() const
  {
    return system->displacement(watched);
  }



  double
  FluidStructureProblem::mean_pressure() const
  {
    const NavierStokes &flow = system->flow();
    return dealii::VectorTools::compute_mean_value(flow.mapping(),
                                                   flow.space().dofs(),
                                                   dealii::QGauss<2>(
                                                     flow.space().degree() + 1),
                                                   flow.solution(),
                                                   2);
  }



  std::unique_ptr<FluidStructureProblem>
  make_problem(const FluidStructureParameters &parameters)
  {
    const auto make = [&] {
      switch (parameters.problem.kind)
        {
          case ProblemKind::turek_hron:
            return make_turek_hron(parameters);
          case ProblemKind::inflatable_box:
            return make_inflatable_box(parameters);
          case ProblemKind::lined_channel:
            return make_lined_channel(parameters);
          default:
            return make_enclosed_domain(parameters);
        }
    };
    auto problem = make();
    problem->system->coupling(); // refuses what cannot work
    return problem;
  }



  FluidStructureOptions
  options_of(const FluidStructureParameters &parameters)
  {
    const FluidParameters &fluid = parameters.fluid;
    const BodyParameters  &body  = parameters.body;
    FluidStructureOptions  options;
    options.fluid.model.density             = fluid.density;
    options.fluid.model.viscosity.viscosity = fluid.viscosity;
    options.fluid.degree                    = fluid.degree;
    options.fluid.geometry_degree           = fluid.degree;
    options.fluid.scheme                    = fluid.scheme;
    options.fluid.tolerance                 = fluid.tolerance;
    options.fluid.kept_tangent_contraction  = fluid.kept_tangent;
    options.mesh_stiffening                 = fluid.stiffening;
    options.solid.dynamic                   = body.dynamic;
    options.solid.spectral_radius           = body.spectral_radius;
    options.solid.tolerance                 = body.tolerance;
    options.solid.load_floor                = body.load_floor;
    options.coupling                        = parameters.coupling;
    return options;
  }



  namespace
  {
    void
    read_mesh(dealii::Triangulation<2> &mesh, const std::string &file)
    {
      try
        {
          dealii::GridIn<2> reader(mesh);
          reader.read(file);
        }
      catch (const dealii::ExceptionBase &error)
        {
          throw InputError(file +
                           ": no mesh of quadrilaterals can be read from it (" +
                           error.get_exc_name() +
                           "); expected a file of Gmsh, Abaqus, VTK or Unv.");
        }
    }
  } // namespace



  void
  make_or_read_mesh(dealii::Triangulation<2>       &mesh,
                    const std::string              &file,
                    const std::vector<std::string> &names,
                    const std::function<void()>    &generate)
  {
    if (file.empty())
      {
        generate();
        return;
      }
    read_mesh(mesh, file);
    const auto ids = mesh.get_boundary_ids();
    for (const auto id : ids)
      if (id >= names.size())
        throw InputError(file + ": found the boundary id " +
                         std::to_string(id) + "; expected ids from 0 to " +
                         std::to_string(names.size() - 1) + ".");
    for (unsigned int id = 0; id < names.size(); ++id)
      if (std::find(ids.begin(), ids.end(), id) == ids.end())
        throw InputError(file + ": found no boundary with the id " +
                         std::to_string(id) + "; expected one, the " +
                         names[id] + ".");
  }



  std::vector<double>
  uniform_breaks(const unsigned int n)
  {
    std::vector<double> breaks;
    for (unsigned int i = 0; i <= n; ++i)
      breaks.push_back(double(i) / n);
    return breaks;
  }



  FluidFunction
  no_velocity()
  {
    return [](const Point<2> &, const double) { return Tensor<1, 2>(); };
  }
} // namespace asperity
