#ifndef asperity_flow_wall_nodes_h
#define asperity_flow_wall_nodes_h

#include <asperity/flow/fluid_space.h>

#include <deal.II/base/point.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace asperity
{
  /** Nodal values of a vector field on a wall, in the order of its nodes. */
  using NodalVectors = std::vector<dealii::Tensor<1, 2>>;

  /**
   * The velocity nodes of some boundaries, each once, in the order in which the
   * cells' faces meet them. Of two nodes that are one by periodicity both are
   * listed.
   */
  class WallNodes
  {
  public:
    WallNodes(const FluidSpace &space, const BoundaryIds &ids);

    /** The nodes of the inner walls, as they are now. */
    static WallNodes
    on_inner_walls(const FluidSpace &space);

    unsigned int
    size() const;

    /** Index of a velocity component in the vector of unknowns. */
    unsigned int
    dof(const unsigned int node, const unsigned int component) const;

    /** Positions [m] of the nodes with a shape of the cells. */
    std::vector<dealii::Point<2>>
    positions(const dealii::Mapping<2> &mapping) const;

    /** The velocity part of a vector of unknowns (or of forces). */
    NodalVectors
    extract(const dealii::Vector<double> &unknowns) const;

    /** A vector field of the geometry space, as displacements, at the nodes. */
    NodalVectors
    extract_geometry(const dealii::Vector<double> &field) const;

  private:
    explicit WallNodes(const FluidSpace &space);

    struct Place
    {
      dealii::DoFHandler<2>::active_cell_iterator cell;
      dealii::Point<2>                            unit_point;
    };

    const FluidSpace                        &space;
    std::vector<Place>                       place;
    std::vector<std::array<unsigned int, 2>> dofs;
  };
} // namespace asperity

#endif
