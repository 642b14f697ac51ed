#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/coupling/fluid_structure.h>
#include <asperity/flow/flow_transfer.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <array>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    /** Fluid nodes may miss the body's edge by this share of the body's size:
     *  the accuracy to which positions are known. */
    constexpr double gap_tolerance = 1e-6;

    ElasticMeshOptions
    mesh_options(const dealii::Triangulation<2> &mesh,
                 const FluidWalls               &walls,
                 const double                    stiffening)
    {
      ElasticMeshOptions options;
      options.stiffening_exponent = stiffening;
      options.sliding_in_x        = walls.sliding;
      for (const auto id : mesh.get_boundary_ids())
        if (walls.sliding.count(id) == 0)
          options.prescribed.insert(id);
      return options;
    }



    Interface
    make_interface(const AleFluid &fluid, const SplineBody &body)
    {
      const auto   positions = fluid.positions();
      const double size = dealii::BoundingBox<2>(positions).side_length(0) +
                          dealii::BoundingBox<2>(positions).side_length(1);
      return Interface(*body.space,
                       body.geometry,
                       find_on_edges(*body.space,
                                     body.geometry,
                                     body.wet,
                                     positions,
                                     gap_tolerance * size));
    }
  } // namespace



  FluidStructure::FluidStructure(const dealii::Triangulation<2> &mesh,
                                 const FluidWalls               &walls,
                                 const SplineBody               &body,
                                 const FluidStructureOptions    &options)
    : options(options)
    , body_(body)
    , flow_(mesh, options.fluid)
    , mesh_update(flow_.space().geometry_dofs(),
                  flow_.space().reference_mapping(),
                  mesh_options(mesh, walls, options.mesh_stiffening))
    , fluid_side(flow_,
                 walls.wet,
                 [this](const dealii::Vector<double> &displacement) {
                   return mesh_update.update(displacement);
                 })
    , interface(make_interface(fluid_side, body))
    , assembler(body.space, body.geometry, body.law)
  {
    BoundaryIds material = walls.wet;
    material.insert(walls.moving.begin(), walls.moving.end());
    flow_.set_material_walls(material);
    if (!walls.moving.empty())
      fluid_side.add_moving_wall(walls.moving, walls.motion);
    fluid_side.set_sliding_walls(walls.sliding);
    if (!walls.sliding.empty())
      flow_.boundary().set_velocity(walls.sliding,
                                    [](const dealii::Point<2> &, const double) {
                                      return Tensor<1, 2>();
                                    },
                                    {{false, true}});
  }



  void
  FluidStructure::start()
  {
    dealii::AffineConstraints<double> constraints;
    for (const Edge edge : body_.clamped)
      for (const unsigned int a : body_.space->edge_functions(edge))
        for (unsigned int c = 0; c < 2; ++c)
          constraints.add_line(displacement_dof<2>(a, c));
    for (const Edge edge : body_.held_in_y)
      for (const unsigned int a : body_.space->edge_functions(edge))
        constraints.add_line(displacement_dof<2>(a, 1));
    constraints.close();
    solid_side = std::make_unique<SplineSolid>(assembler,
                                               constraints,
                                               interface,
                                               options.solid);
    step       = std::make_unique<PartitionedStep>(*solid_side,
                                             fluid_side,
                                             options.coupling);
  }



  ConvergenceReport
  FluidStructure::advance(const double dt)
  {
    return coupling().advance(dt);
  }



  NavierStokes &
  FluidStructure::flow()
  {
    return flow_;
  }



  const NavierStokes &
  FluidStructure::flow() const
  {
    return flow_;
  }



  PartitionedStep &
  FluidStructure::coupling()
  {
    if (step == nullptr)
      start();
    return *step;
  }



  Tensor<1, 2>
  FluidStructure::displacement(const dealii::Point<2> &parameter) const
  {
    Tensor<1, 2> value;
    if (solid_side == nullptr)
      return value;
    const dealii::Vector<double> &u    = solid_side->displacement();
    const unsigned int            cell = body_.space->find_cell(parameter);
    std::vector<double>           N;
    body_.space->evaluate(cell, parameter, N);
    for (unsigned int a = 0; a < N.size(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        value[c] +=
          N[a] *
          u(displacement_dof<2>(body_.space->cell_functions(cell)[a], c));
    return value;
  }



  const SplineSolid &
  FluidStructure::solid() const
  {
    return *solid_side;
  }



  const SplineBody &
  FluidStructure::body() const
  {
    return body_;
  }



  const SolidAssembler<2> &
  FluidStructure::body_assembler() const
  {
    return assembler;
  }



  void
  FluidStructure::save(OutputArchive &archive)
  {
    const PartitionedStep &coupled = coupling(); // makes the sides
    flow_.state().save(archive);
    solid_side->state().save(archive);
    coupled.save(archive);
  }



  void
  FluidStructure::load(InputArchive &archive)
  {
    PartitionedStep &coupled    = coupling(); // makes the sides
    FluidState       flow_state = flow_.state();
    SolidStep::State body_state = solid_side->state();
    flow_state.load(archive);
    body_state.load(archive);
    coupled.load(archive);
    flow_.set_state(flow_state);
    solid_side->set_state(body_state);
  }



  void
  FluidStructure::continue_from(const FluidStructure &other)
  {
    PartitionedStep       &coupled    = coupling();
    const SolidStep::State body_state = other.solid().state();
    const unsigned int     n          = solid_side->displacement().size();
    if (body_state.u.size() != n)
      throw InputError("The body to continue from has " +
                       std::to_string(body_state.u.size()) +
                       " unknowns; expected " + std::to_string(n) + ".");
    const dealii::Vector<double> wall_displacement =
      interface.interpolate(body_state.u);
    const FluidState old       = other.flow_.state();
    const auto      &old_space = other.flow_.space();
    FluidState       state     = old;
    for (const auto &[from, to] :
         {std::pair{&old.u, &state.u}, {&old.u_old, &state.u_old}})
      {
        *to =
          interpolate_to_mesh(old_space.dofs(), *from, flow_.space().dofs());
        flow_.space().topology().distribute(*to);
      }
    dealii::Vector<double> last_motion = old.displacement;
    last_motion -= old.displacement_old;
    state.displacement =
      fluid_side.mesh_displacement(wall_displacement, old.time);
    state.displacement_old = state.displacement;
    state.displacement_old -= mesh_update.update(interpolate_to_mesh(
      old_space.geometry_dofs(), last_motion, flow_.space().geometry_dofs()));
    state.divergence.reinit(state.u.size());
    flow_.set_state(state);
    solid_side->set_state(body_state);
    coupled.set_state(dealii::Vector<double>(wall_displacement.size()),
                      wall_displacement);
  }
} // namespace asperity
