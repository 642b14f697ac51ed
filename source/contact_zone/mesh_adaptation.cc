#include <asperity/contact_zone/mesh_adaptation.h>
#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity
{
  namespace
  {
    /** How many cells of a level there are beside what touches at the least,
     *  after a change of the mesh, and which are kept where they are. Fewer
     *  change mu by more than 0.1 % as they come (tools/benchmarks). */
    constexpr double smallest_halo = 6., halo_ahead = 10., halo_kept = 12.;

    /** Plastic strain, in the root mean square, that a coarsening may lose:
     *  with 0.005 it moves mu by up to 0.3 % when the spot comes round again,
     *  which fails to find the layer that it has worked. */
    constexpr double largest_loss = 0.002;

    /** Part of the Remesh distance that must be left. */
    constexpr double reserve = 0.25;

    /** Distance from an interval of a period to the nearest of sorted points.
     */
    double
    distance(const std::vector<double> &points,
             const double               begin,
             const double               end,
             const double               period)
    {
      if (points.empty())
        return period;
      const auto after = std::lower_bound(points.begin(), points.end(), begin);
      const double next =
        after != points.end() ? *after : points.front() + period;
      const double last =
        after != points.begin() ? *(after - 1) : points.back() - period;
      return std::min(std::max(0., next - end), begin - last);
    }



    /** Of the regular step that follows [m]. */
    double
    next_way(const LoadProtocol &protocol, const double time)
    {
      return std::abs(protocol.displacement(protocol.next_time(time)) -
                      protocol.displacement(time));
    }
  } // namespace



  MeshAdaptation::MeshAdaptation(const SceneParameters &parameters,
                                 const Scene<2>        &scene,
                                 const LoadProtocol    &protocol)
    : parameters(parameters)
    , scene(scene)
    , protocol(protocol)
  {}



  SplineSpace<2>::CellLevel
  MeshAdaptation::level_beside(const std::vector<double> &points,
                               const double               halo) const
  {
    return [this, points, halo](const dealii::Point<2> &lower,
                                const dealii::Point<2> &upper) {
      const MeshParameters &mesh  = parameters.mesh;
      const double          depth = parameters.geometry.height - upper[1];
      const double beside = distance(points, lower[0], upper[0], scene.length);
      unsigned int level  = 0;
      while (level < mesh.refinement && is_in_strip(mesh, level + 1, depth) &&
             (level < mesh.n_even_levels() ||
              beside < halo * scene.length / mesh.spans *
                         (1u << (mesh.refinement - level - 1))))
        ++level;
      return level;
    };
  }



  bool
  MeshAdaptation::is_needed(const double time, const double approach) const
  {
    const SplineSpace<2>::CellLevel level =
      level_beside(touching(time,
                            approach,
                            std::max(reserve * parameters.mesh.remesh_distance,
                                     next_way(protocol, time))),
                   smallest_halo);
    for (const unsigned int cell : scene.space->edge_cells(Edge::top))
      {
        const auto [lower, upper] = scene.space->cell_box(cell);
        if (scene.space->hierarchy()->cell_index(cell).level <
            level(lower, upper))
          return true;
      }
    return false;
  }



  SplineSpace<2>::CellLevel
  MeshAdaptation::wanted(const double time, const double approach) const
  {
    const auto points          = touching(time,
                                 approach,
                                 std::max(parameters.mesh.remesh_distance,
                                          2. * next_way(protocol, time)));
    const auto needed          = level_beside(points, halo_ahead),
               kept            = level_beside(points, halo_kept);
    const auto          before = scene.space->hierarchy();
    std::vector<double> strain;
    for (const MaterialState &state : scene.chip->history())
      strain.push_back(state.plastic_strain);
    const std::vector<double> loss =
      coarsening_loss(*before,
                      dealii::QGauss<2>(parameters.mesh.n_quadrature_points()),
                      strain);
    return [needed, kept, before, loss](const dealii::Point<2> &lower,
                                        const dealii::Point<2> &upper) {
      const unsigned int cell =
        before->find_cell(lower + 0.5 * (upper - lower));
      const unsigned int now = before->cell_index(cell).level;
      // The loss of one level is known, not that of more.
      const unsigned int worthy =
        loss[cell] > largest_loss || now == 0 ? now : now - 1;
      return std::max(
        {needed(lower, upper), worthy, std::min(now, kept(lower, upper))});
    };
  }



  std::vector<double>
  MeshAdaptation::touching(const double time,
                           const double approach,
                           const double distance) const
  {
    const double ahead = distance / std::abs(parameters.load.velocity);
    const double lift  = std::max(0., approach) * ahead;
    const double way =
      protocol.displacement(time + ahead) - protocol.displacement(time);
    const auto n = static_cast<unsigned int>(
      std::ceil(distance * parameters.mesh.spans / scene.length));
    const std::vector<bool> touches = scene.contact->touching();
    std::vector<double>     points;
    for (unsigned int q = 0; q < touches.size(); ++q)
      {
        const dealii::Point<2> &x    = scene.contact->positions()[q];
        bool                    will = touches[q];
        for (unsigned int i = 0; i <= n && !will; ++i)
          will =
            scene.tool_surface.height(x[0] + way * i / n) < x[1] + lift * i / n;
        if (will)
          points.push_back(scene.contact->table().parameter[q][0]);
      }
    return points;
  }



  double
  plastic_work(const SolidAssembler<2>          &chip,
               const std::vector<MaterialState> &states,
               const LoadParameters             &start)
  {
    const dealii::QGauss<1> rule(3);
    double                  work = 0.;
    for (std::size_t q = 0; q < states.size(); ++q)
      {
        const double growth = states[q].plastic_strain - start.plastic_strain;
        if (growth <= 0.)
          continue;
        for (unsigned int i = 0; i < rule.size(); ++i)
          work += chip.table().JxW[q] * rule.weight(i) * growth *
                  std::sqrt(3.) *
                  chip.law().shear_limit(start.plastic_strain +
                                           rule.point(i)[0] * growth,
                                         1.,
                                         start.temperature);
      }
    return work;
  }
} // namespace asperity
