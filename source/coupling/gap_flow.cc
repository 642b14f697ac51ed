#include <asperity/base/errors.h>
#include <asperity/coupling/gap_flow.h>
#include <asperity/mesh_motion/column_layout.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  namespace
  {
    const BoundaryIds chip_wall = {ColumnMesh::chip_wall};

    /** Residual of the flow over the size of its terms: far below what the
     *  coupling can see, and above round-off in narrow cells. */
    constexpr double flow_tolerance = 1e-8;

    /** Between the iterations of a coupled step the flow hardly changes. */
    constexpr double kept_tangent_contraction = 0.3;



    ColumnLayout
    make_layout(const SplineCurve &chip, const GapFlowOptions &options)
    {
      // The columns go with the chip, and narrow places pass over all of them.
      ColumnLayout layout;
      layout.columns = columns_on_spans(chip.knot_vector(),
                                        options.columns_per_span *
                                          chip.knot_vector().n_spans());
      layout.rows    = graded_rows(options.rows);
      layout.residual_film =
        options.sealing_gap > 0. ? options.sealing_gap : options.residual_film;
      return layout;
    }



    FluidModel
    make_model(const LubricantParameters &oil,
               const bool                 inertia,
               const bool                 compressible)
    {
      FluidModel model;
      model.density    = inertia ? oil.density : 0.;
      model.viscosity  = oil.viscosity;
      model.convection = inertia;
      if (compressible)
        model.compressibility = oil.compressibility;
      return model;
    }



    FluidOptions
    make_fluid(const GapFlowOptions &options)
    {
      FluidOptions fluid;
      fluid.model =
        make_model(options.oil, options.inertia, options.compressible);
      fluid.element                  = options.element;
      fluid.scheme                   = options.scheme;
      fluid.linear_solver            = options.linear_solver;
      fluid.tolerance                = flow_tolerance;
      fluid.kept_tangent_contraction = kept_tangent_contraction;
      return fluid;
    }
  } // namespace



  GapFlow::Side::Side(GapFlow &gap)
    : AleFluid(gap.flow_,
               chip_wall,
               [&gap](const Vector &) { return gap.mesh_displacement(); })
    , gap(gap)
  {}



  void
  GapFlow::Side::begin_step(const double dt)
  {
    // A tangent of an earlier step would make the run depend on where it was
    // interrupted.
    gap.flow_.forget_tangent();
    AleFluid::begin_step(dt);
  }



  ConvergenceReport
  GapFlow::Side::solve(const WallCondition &condition, WallResponse &response)
  {
    dealii::Timer timer;
    ++gap.n_solutions;
    ConvergenceReport report;
    if (gap.pockets_ && gap.pockets_->n_pockets() == 0)
      {
        report.reason = "the oil has no room to flow, since the gap is nowhere "
                        "wider than the sealing gap";
        return report;
      }
    report = gap.mesh_.update(gap.chip_curve(), {});
    if (report.converged)
      {
        gap.set_tool_velocity();
        if (gap.flow_.space().cells().empty())
          report = rest(response);
        else
          {
            if (gap.pockets_)
              gap.flow_.set_part_volumes(gap.oil_of_parts());
            report = AleFluid::solve(condition, response);
          }
      }
    if (report.converged && gap.pockets_)
      {
        gap.column_pressures = gap.find_column_pressures();
        const NodalVectors seals =
          gap.flow_.boundary().nodes(chip_wall).extract(gap.seal_forces());
        for (unsigned int i = 0; i < response.force.size(); ++i)
          response.force(i) += seals[i / 2][i % 2];
        report.reason    = gap.overfilled();
        report.converged = report.reason.empty();
      }
    gap.seconds_ += timer.wall_time();
    return report;
  }



  ConvergenceReport
  GapFlow::Side::rest(WallResponse &response)
  {
    const NodalVectors w = gap.flow_.wall_mesh_velocity(chip_wall);
    response.force.reinit(2 * w.size());
    response.velocity.reinit(2 * w.size());
    for (unsigned int i = 0; i < response.velocity.size(); ++i)
      response.velocity(i) = w[i / 2][i % 2];
    response.wall_velocity = response.velocity;
    ConvergenceReport report;
    report.converged = true;
    return report;
  }



  GapFlow::GapFlow(const SplineSpace<2>   &space,
                   const PatchGeometry<2> &geometry,
                   const SplineCurve      &tool,
                   const GapFlowOptions   &options)
    : inertia(options.inertia)
    , geometry(geometry)
    , edge(*space.hierarchy(), Edge::top)
    , length(tool.period()[0])
    , chip(2 * space.n_functions())
    , mesh_(chip_curve(), tool, make_layout(chip_curve(), options))
    , flow_(mesh_.triangulation(),
            make_fluid(options),
            options.periodic_sides(),
            options.outlets())
    , side_(*this)
    , interface_(space, geometry, chip_points())
    , load_(interface_)
    , force(2 * interface_.n_points())
    , tool_numbers(numbers_from_left(ColumnMesh::tool_wall, mesh_.tool_nodes()))
    , density(make_fluid(options).model.compressibility)
  {
    load_.set_force(force);
    find_wall_pressures();
    const ConvergenceReport report = mesh_.update(chip_curve(), {});
    if (!report.converged)
      throw InputError("The oil between tool and chip cannot be meshed: " +
                       report.reason + ".");
    if (options.mesh_update == MeshUpdateKind::elastic)
      make_elastic_update(options.stiffening);
    flow_.set_initial_displacement(mesh_displacement());
    flow_.set_material_walls(chip_wall);
    set_initial_pressure(options.initial_pressure);
    const std::vector<double> contents = flow_.cell_contents();
    initial_content    = std::accumulate(contents.begin(), contents.end(), 0.);
    state_.void_volume = flow_.volume();
    state_.oil_volume  = state_.void_volume;
    state_.reference_volume = initial_content;
    state_.smallest_film    = mesh_.film().smallest_gap;
    state_.n_pockets        = 1;
    if (options.sealing_gap > 0.)
      fill_pockets(options);
    else if (options.compressible)
      flow_.set_part_volumes({initial_content});
    set_tool_velocity();
  }



  std::vector<unsigned int>
  GapFlow::numbers_from_left(const dealii::types::boundary_id         wall,
                             const std::vector<ColumnMesh::WallNode> &nodes)
  {
    Vector number(mesh_.dofs().n_dofs());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      number(nodes[i].dof_x) = i;
    std::vector<unsigned int> result;
    for (const Tensor<1, 2> &value :
         flow_.boundary().nodes({wall}).extract_geometry(number))
      result.push_back(std::lround(value[0]));
    return result;
  }



  std::vector<EdgePoint>
  GapFlow::chip_points()
  {
    const double           end = edge.knots().back();
    std::vector<EdgePoint> points;
    for (const unsigned int i :
         numbers_from_left(ColumnMesh::chip_wall, mesh_.chip_nodes()))
      {
        // The end of the period is its start.
        const double parameter = mesh_.chip_nodes()[i].parameter;
        points.push_back(
          {Edge::top, parameter < end ? parameter : edge.knots().front()});
      }
    return points;
  }



  void
  GapFlow::find_wall_pressures()
  {
    std::vector<double> parameter(mesh_.dofs().n_dofs(), -1.);
    for (const ColumnMesh::WallNode &node : mesh_.chip_nodes())
      parameter[node.dof_x] = node.parameter;
    const auto &fe          = flow_.space().dofs().get_fe();
    const auto &geometry_fe = flow_.space().geometry_dofs().get_fe();
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell()),
      geometry_dofs(geometry_fe.n_dofs_per_cell());
    for (const auto &cell : flow_.space().dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->at_boundary(f) ||
              chip_wall.count(cell->face(f)->boundary_id()) == 0)
            continue;
          cell->get_dof_indices(dofs);
          flow_.space().geometry_cell(cell)->get_dof_indices(geometry_dofs);
          for (unsigned int k = 0; k < 2; ++k)
            {
              // Both spaces number the vertices of a cell first.
              const unsigned int v =
                dealii::GeometryInfo<2>::face_to_cell_vertices(f, k);
              wall_pressures.emplace_back(
                parameter
                  [geometry_dofs[geometry_fe.component_to_system_index(0, v)]],
                dofs[fe.component_to_system_index(2, v)]);
            }
        }
    std::sort(wall_pressures.begin(), wall_pressures.end());
    wall_pressures.erase(std::unique(wall_pressures.begin(),
                                     wall_pressures.end()),
                         wall_pressures.end());
  }



  const Interface &
  GapFlow::interface() const
  {
    return interface_;
  }



  FluidSide &
  GapFlow::side()
  {
    return side_;
  }



  void
  GapFlow::set_chip(const Vector &u)
  {
    chip = u;
  }



  void
  GapFlow::set_force(const Vector &new_force)
  {
    force = new_force;
    load_.set_force(force);
  }



  void
  GapFlow::set_oil(const LubricantParameters &oil)
  {
    const FluidModel model = make_model(oil, inertia, flow_.is_compressible());
    density                = model.compressibility;
    flow_.set_model(model);
  }



  void
  GapFlow::begin_step(const Vector &u,
                      const unsigned int,
                      const double,
                      const double)
  {
    n_solutions = 0;
    if (!pockets_)
      return;
    chip = u;
    mesh_.update(chip_curve(), {});
    flow_.set_mesh_displacement(mesh_displacement());
    switch_columns();
  }



  void
  GapFlow::add_couplings(dealii::DynamicSparsityPattern &pattern) const
  {
    load_.add_couplings(pattern);
  }



  bool
  GapFlow::add(const Vector                 &u,
               Vector                       &residual,
               dealii::SparseMatrix<double> *tangent)
  {
    return load_.add(u, residual, tangent);
  }
} // namespace asperity
