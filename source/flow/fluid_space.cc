#include <asperity/base/errors.h>
#include <asperity/flow/fluid_space.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>



namespace asperity
{
  FluidSpace::FluidSpace(const dealii::Triangulation<2>   &mesh,
                         const FluidElement                element,
                         const unsigned int                degree,
                         const unsigned int                geometry_degree,
                         const std::vector<PeriodicSides> &periodic)
    : element_(element)
    , degree_(degree)
    , fe(dealii::FE_Q<2>(degree),
         2,
         dealii::FE_Q<2>(element == FluidElement::taylor_hood ?
                           std::max(degree, 2U) - 1 :
                           degree),
         1)
    , geometry_fe(dealii::FE_Q<2>(geometry_degree), 2)
    , mapping(geometry_degree)
    , dofs_(mesh)
    , geometry_dofs_(mesh)
  {
    if (element == FluidElement::taylor_hood && degree < 2)
      throw InputError("Taylor-Hood elements need a velocity of degree 2 or "
                       "more, found " +
                       std::to_string(degree) + ".");
    if (geometry_degree < 2)
      throw InputError("The fluid mesh needs a geometry of degree 2 or more, "
                       "found " +
                       std::to_string(geometry_degree) + ".");
    number_dofs();
    make_topology(periodic);
    set_active(std::vector<bool>(mesh.n_active_cells(), true));
  }



  void
  FluidSpace::number_dofs()
  {
    dofs_.distribute_dofs(fe);
    geometry_dofs_.distribute_dofs(geometry_fe);
    dealii::DoFRenumbering::Cuthill_McKee(dofs_);
    const std::vector<unsigned int> block = {0, 0, 1};
    dealii::DoFRenumbering::component_wise(dofs_, block);
    n_velocity =
      dealii::DoFTools::count_dofs_per_fe_block(dofs_, block).front();
  }



  void
  FluidSpace::make_topology(const std::vector<PeriodicSides> &periodic)
  {
    dealii::DoFTools::make_hanging_node_constraints(dofs_, topology_);
    for (const PeriodicSides &pair : periodic)
      {
        dealii::DoFTools::make_periodicity_constraints(
          dofs_, pair.left, pair.right, pair.direction, topology_);
        periodic_ids_.insert({pair.left, pair.right});
      }
    topology_.close();
  }



  FluidElement
  FluidSpace::element() const
  {
    return element_;
  }



  unsigned int
  FluidSpace::degree() const
  {
    return degree_;
  }



  const dealii::DoFHandler<2> &
  FluidSpace::dofs() const
  {
    return dofs_;
  }



  unsigned int
  FluidSpace::n_velocity_dofs() const
  {
    return n_velocity;
  }



  const dealii::DoFHandler<2> &
  FluidSpace::geometry_dofs() const
  {
    return geometry_dofs_;
  }



  dealii::DoFHandler<2>::active_cell_iterator
  FluidSpace::geometry_cell(
    const dealii::DoFHandler<2>::active_cell_iterator &cell) const
  {
    return {&cell->get_triangulation(),
            cell->level(),
            cell->index(),
            &geometry_dofs_};
  }



  const dealii::Mapping<2> &
  FluidSpace::reference_mapping() const
  {
    return mapping;
  }



  const dealii::AffineConstraints<double> &
  FluidSpace::topology() const
  {
    return topology_;
  }



  const BoundaryIds &
  FluidSpace::periodic_ids() const
  {
    return periodic_ids_;
  }
} // namespace asperity
