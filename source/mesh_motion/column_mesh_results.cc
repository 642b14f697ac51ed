#include <asperity/mesh_motion/column_mesh.h>

#include <array>

// What a column mesh tells of itself.
namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  std::vector<Tensor<1, 2>>
  ColumnMesh::tool_wall_normals() const
  {
    const unsigned int n = tool_wall_nodes.size();
    // Three times the integral of the shape function of a node and the tangent,
    // over the quadratic edges at the node.
    std::vector<Tensor<1, 2>> along(n);
    for (unsigned int i = 0; i + 2 < n; i += 2)
      {
        std::array<Tensor<1, 2>, 3> x;
        for (unsigned int k = 0; k < 3; ++k)
          {
            const WallNode &node = tool_wall_nodes[i + k];
            x[k][0] = reference_x[i + k] + displacement_(node.dof_x);
            x[k][1] = displacement_(node.dof_y);
          }
        along[i] += 2. * (x[1] - x[0]) - 0.5 * (x[2] - x[0]);
        along[i + 1] += 2. * (x[2] - x[0]);
        along[i + 2] += 2. * (x[2] - x[1]) - 0.5 * (x[2] - x[0]);
      }
    // The ends of the period are one node.
    along.front() += along.back();
    along.back() = along.front();
    std::vector<Tensor<1, 2>> normals(n);
    for (unsigned int i = 0; i < n; ++i)
      normals[i] = Point<2>(-along[i][1], along[i][0]) / along[i].norm();
    return normals;
  }



  std::vector<Tensor<1, 2>>
  ColumnMesh::tool_wall_velocity(const Tensor<1, 2> &tool_velocity,
                                 const Vector       &w) const
  {
    const std::vector<Tensor<1, 2>> normals = tool_wall_normals();
    std::vector<Tensor<1, 2>>       v(normals.size(), tool_velocity);
    for (unsigned int i = 0; i < v.size(); ++i)
      {
        const WallNode    &node = tool_wall_nodes[i];
        const Tensor<1, 2> slip =
          Point<2>(w(node.dof_x), w(node.dof_y)) - Point<2>(tool_velocity);
        v[i] += (slip * normals[i]) * normals[i];
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
