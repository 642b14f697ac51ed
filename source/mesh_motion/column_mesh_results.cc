#include <asperity/mesh_motion/column_mesh.h>

// What a column mesh tells of itself.
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  std::vector<Tensor<1, 2>>
  ColumnMesh::tool_wall_velocity(const Tensor<1, 2> &tool_velocity,
                                 const Vector       &w) const
  {
    const unsigned int n        = tool_wall_nodes.size();
    const auto         position = [this](const unsigned int i) {
      const WallNode &node = tool_wall_nodes[i];
      return Point<2>(reference_x[i] + displacement_(node.dof_x),
                      reference_y.back() + displacement_(node.dof_y));
    };
    std::vector<Tensor<1, 2>> v(n, tool_velocity);
    for (unsigned int i = 0; i < n; ++i)
      {
        // Chord between the neighbours, across the period at its ends.
        const bool   at_end = i == 0 || i == n - 1;
        Tensor<1, 2> chord =
          position(at_end ? 1 : i + 1) - position(at_end ? n - 2 : i - 1);
        if (at_end)
          chord[0] += period;
        const Tensor<1, 2> normal =
          Point<2>(-chord[1], chord[0]) / chord.norm();
        const WallNode    &node = tool_wall_nodes[i];
        const Tensor<1, 2> slip =
          Point<2>(w(node.dof_x), w(node.dof_y)) - Point<2>(tool_velocity);
        v[i] += (slip * normal) * normal;
      }
    return v;
  }



  const dealii::Triangulation<2> &
  ColumnMesh::triangulation() const
  {
    return mesh;
  }



  const dealii::DoFHandler<2> &
  ColumnMesh::dofs() const
  {
    return dof_handler;
  }



  const ColumnMesh::Vector &
  ColumnMesh::displacement() const
  {
    return displacement_;
  }



  const ColumnMesh::Film &
  ColumnMesh::film() const
  {
    return film_;
  }



  const std::vector<ColumnMesh::WallNode> &
  ColumnMesh::chip_nodes() const
  {
    return chip_wall_nodes;
  }



  const std::vector<ColumnMesh::WallNode> &
  ColumnMesh::tool_nodes() const
  {
    return tool_wall_nodes;
  }



  const std::vector<double> &
  ColumnMesh::smallest_gaps() const
  {
    return smallest_gaps_;
  }



  unsigned int
  ColumnMesh::column_of_cell(const unsigned int cell) const
  {
    return column_of_cell_[cell];
  }



  const std::vector<double> &
  ColumnMesh::lift() const
  {
    return lift_;
  }
} // namespace asperity
