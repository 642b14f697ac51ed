#include <asperity/coupling/gap_flow.h>

// The ends of the period, and what the oil starts with.
namespace asperity
{
  std::vector<PeriodicSides>
  GapFlowOptions::periodic_sides() const
  {
    if (left.kind != GapEndKind::periodic)
      return {};
    return {{ColumnMesh::left_side, ColumnMesh::right_side, 0}};
  }



  std::vector<FluidOutlet>
  GapFlowOptions::outlets() const
  {
    std::vector<FluidOutlet> list;
    const auto               add = [&list](const GapEnd                    &end,
                             const dealii::types::boundary_id side) {
      const bool resists = end.kind == GapEndKind::resistance;
      if (end.kind != GapEndKind::periodic)
        list.push_back({side, end.pressure, resists ? end.resistance : 0.});
    };
    add(left, ColumnMesh::left_side);
    add(right, ColumnMesh::right_side);
    return list;
  }



  void
  GapFlow::set_initial_pressure(const double pressure)
  {
    FluidState start = flow_.state();
    for (unsigned int i = flow_.space().n_velocity_dofs(); i < start.u.size();
         ++i)
      start.u(i) = pressure;
    flow_.set_state(start);
    Vector uniform = side_.uniform_loads().front();
    uniform *= pressure;
    set_force(uniform);
  }
} // namespace asperity
