#include <asperity/coupling/gap_flow.h>

#include <deal.II/fe/mapping_q_eulerian.h>

// How the mesh in the gap follows chip and tool.
namespace asperity
{
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  SplineCurve
  GapFlow::chip_curve() const
  {
    std::vector<Tensor<1, 2>> offset = geometry.offset;
    offset.resize(chip.size() / 2);
    for (unsigned int a = 0; a < offset.size(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        offset[a][c] += chip(displacement_dof<2>(a, c));
    return edge.curve(offset);
  }



  Vector
  GapFlow::mesh_displacement() const
  {
    if (!elastic)
      return mesh_.displacement();
    Vector change = mesh_.displacement();
    change -= elastic_start;
    Vector displacement = elastic->update(change);
    displacement += elastic_start;
    return displacement;
  }



  void
  GapFlow::make_elastic_update(const double stiffening)
  {
    elastic_start = mesh_.displacement();
    const dealii::MappingQEulerian<2, Vector> gap(2,
                                                  mesh_.dofs(),
                                                  elastic_start);
    ElasticMeshOptions                        options;
    options.stiffening_exponent = stiffening;
    options.prescribed = {ColumnMesh::chip_wall, ColumnMesh::tool_wall};
    options.periodic   = {{ColumnMesh::left_side, ColumnMesh::right_side}};
    elastic = std::make_unique<ElasticMeshUpdate>(mesh_.dofs(), gap, options);
  }



  void
  GapFlow::set_tool_velocity()
  {
    flow_.set_mesh_displacement(mesh_displacement());
    const BoundaryIds  tool_wall = {ColumnMesh::tool_wall};
    const NodalVectors w         = flow_.wall_mesh_velocity(tool_wall);
    Vector             w_field(mesh_.dofs().n_dofs());
    for (unsigned int n = 0; n < w.size(); ++n)
      {
        const ColumnMesh::WallNode &node = mesh_.tool_nodes()[tool_numbers[n]];
        w_field(node.dof_x)              = w[n][0];
        w_field(node.dof_y)              = w[n][1];
      }
    const auto   from_left = mesh_.tool_wall_velocity({}, w_field);
    NodalVectors velocity(w.size());
    for (unsigned int n = 0; n < w.size(); ++n)
      velocity[n] = from_left[tool_numbers[n]];
    flow_.boundary().set_wall_velocity(tool_wall, velocity);
  }
} // namespace asperity
