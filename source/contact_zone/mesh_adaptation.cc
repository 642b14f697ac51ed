#include <asperity/contact_zone/mesh_adaptation.h>
#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace asperity
{
  namespace
  {
    /** Over Adaptive halo, which are there after a change of the mesh: how many
     *  cells of a level there are beside what touches at the least, and which
     *  are kept where they are. */
    constexpr double smallest_halo = 0.6, halo_kept = 1.2;

    /** Adaptive halo. Fewer change mu of a profile by more than 0.1 % as cells
     *  come (tools/benchmarks); with 3 instead of 5, each of which costs cells
     *  all around a spot, a change moves mu of a patch by up to 0.4 instead of
     *  0.05 % (parameter_files/surface_patches). */
    constexpr unsigned int halo_of_profile = 10, halo_of_patch = 5;

    /** Plastic strain, in the root mean square, that a coarsening may lose:
     *  with 0.005 it moves mu by up to 0.3 % when the spot comes round again,
     *  which fails to find the layer that it has worked. */
    constexpr double largest_loss = 0.002;

    /** Part of the Remesh distance that must be left. */
    constexpr double reserve = 0.25;

    /** Part of the halo and multiple of the loss that meshes with too many
     *  unknowns have left, before they lose a level. */
    constexpr std::array<std::array<double, 2>, 4> savings = {
      {{{1., 1.}}, {{0.75, 4.}}, {{0.5, 16.}}, {{0.35, 64.}}}};

    /** Distance from an interval of a period to the nearest of sorted points.
     */
    double
    distance(const std::vector<double> &points,
             const double               begin,
             const double               end,
             const double               period)
    {
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

    double
    height_at(const Surface &surface, const dealii::Point<2> &x)
    {
      return surface.height(x[0]);
    }

    double
    height_at(const SheetSurface &surface, const dealii::Point<3> &x)
    {
      return surface.sheet.value(dealii::Point<2>(x[0], x[1]));
    }
  } // namespace



  /** Rows along x of points with one y (in two dimensions one row). */
  template <int dim>
  class MeshAdaptation<dim>::Points
  {
  public:
    /** @param proportion of lengths along y to those along x that count as
     *    much: of the elements */
    Points(const double length, const double width, const double proportion)
      : length(length)
      , width(width)
      , proportion(proportion)
    {}

    void
    add(const dealii::Point<dim> &parameter)
    {
      rows[dim == 2 ? 0. : parameter[1]].push_back(parameter[0]);
    }

    void
    sort()
    {
      for (auto &row : rows)
        std::sort(row.second.begin(), row.second.end());
    }

    /** Whether a box is nearer to a point than so much along x, and than what
     *  this is along y [m]. */
    bool
    are_within(const dealii::Point<dim> &lower,
               const dealii::Point<dim> &upper,
               const double              reach) const
    {
      if (length < reach)
        return true;
      return std::any_of(rows.begin(), rows.end(), [&](const auto &row) {
        return (dim == 2 || distance({row.first}, lower[1], upper[1], width) <
                              reach * proportion) &&
               distance(row.second, lower[0], upper[0], length) < reach;
      });
    }

  private:
    double length, width, proportion;

    std::map<double, std::vector<double>> rows;
  };



  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(const SceneParameters &parameters,
                                      const Scene<dim>      &scene,
                                      const LoadProtocol    &protocol)
    : parameters(parameters)
    , scene(scene)
    , protocol(protocol)
    , thrift(steps_of_thrift(parameters.mesh))
  {}



  template <int dim>
  std::vector<typename MeshAdaptation<dim>::Thrift>
  MeshAdaptation<dim>::steps_of_thrift(const MeshParameters &mesh)
  {
    if (mesh.most_unknowns == 0)
      return {{1., 1., 0}};
    std::vector<Thrift> steps;
    for (unsigned int levels = 0; levels < mesh.adaptive_levels; ++levels)
      for (const auto &[halo, loss] : savings)
        steps.push_back({halo, loss, levels});
    steps.push_back({0., 0., mesh.adaptive_levels});
    return steps;
  }



  template <int dim>
  typename MeshAdaptation<dim>::CellLevel
  MeshAdaptation<dim>::level_beside(const std::shared_ptr<const Points> &points,
                                    const double                         halo,
                                    const unsigned int finest) const
  {
    return [this, points, halo, finest](const dealii::Point<dim> &lower,
                                        const dealii::Point<dim> &upper) {
      const MeshParameters &mesh  = parameters.mesh;
      const double          depth = parameters.geometry.height - upper[dim - 1];
      unsigned int          level = 0;
      while (level < finest && is_in_strip(mesh, level + 1, depth) &&
             (level < mesh.n_even_levels() ||
              points->are_within(lower,
                                 upper,
                                 halo * scene.length / mesh.spans *
                                   (1u << (mesh.refinement - level - 1)))))
        ++level;
      return level;
    };
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::is_needed(const double time, const double approach) const
  {
    // Without all of the levels nothing would ever be missing.
    const Thrift    spared = thrift[std::min<std::size_t>(
      taken, std::max<std::size_t>(thrift.size(), 2) - 2)];
    const CellLevel level =
      level_beside(touching(time,
                            approach,
                            std::max(reserve * parameters.mesh.remesh_distance,
                                     next_way(protocol, time))),
                   smallest_halo * spared.halo * halo(),
                   parameters.mesh.refinement - spared.levels);
    for (const unsigned int cell : scene.space->edge_cells(Edge::top))
      {
        const auto [lower, upper] = scene.space->cell_box(cell);
        if (scene.space->hierarchy()->cell_index(cell).level <
            level(lower, upper))
          return true;
      }
    return false;
  }



  template <int dim>
  std::vector<typename MeshAdaptation<dim>::CellLevel>
  MeshAdaptation<dim>::wanted(const double time, const double approach) const
  {
    const auto          points = touching(time,
                                 approach,
                                 std::max(parameters.mesh.remesh_distance,
                                          2. * next_way(protocol, time)));
    const auto          before = scene.space->hierarchy();
    std::vector<double> strain;
    for (const MaterialState &state : scene.chip->history())
      strain.push_back(state.plastic_strain);
    const auto loss = std::make_shared<const std::vector<double>>(
      coarsening_loss(*before,
                      dealii::QGauss<dim>(
                        parameters.mesh.n_quadrature_points()),
                      strain));
    std::vector<CellLevel> meshes;
    for (const Thrift &spared : thrift)
      {
        const unsigned int finest = parameters.mesh.refinement - spared.levels;
        const auto needed = level_beside(points, spared.halo * halo(), finest),
                   kept   = level_beside(points,
                                       spared.halo * halo_kept * halo(),
                                       finest);
        const double largest = spared.loss * largest_loss;
        meshes.push_back([needed, kept, before, loss, finest, largest](
                           const dealii::Point<dim> &lower,
                           const dealii::Point<dim> &upper) {
          const unsigned int cell =
            before->find_cell(lower + 0.5 * (upper - lower));
          const unsigned int now =
            std::min(before->cell_index(cell).level, finest);
          // The loss of one level is known, not that of more.
          const unsigned int worthy =
            (*loss)[cell] > largest || now == 0 ? now : now - 1;
          return std::max(
            {needed(lower, upper), worthy, std::min(now, kept(lower, upper))});
        });
      }
    return meshes;
  }



  template <int dim>
  double
  MeshAdaptation<dim>::halo() const
  {
    return parameters.mesh.halo.value_or(dim == 2 ? halo_of_profile :
                                                    halo_of_patch);
  }



  template <int dim>
  void
  MeshAdaptation<dim>::set_taken(const unsigned int number)
  {
    AssertIndexRange(number, thrift.size());
    taken = number;
  }



  template <int dim>
  unsigned int
  MeshAdaptation<dim>::missing_levels(const unsigned int number) const
  {
    return thrift[number].levels;
  }



  template <int dim>
  double
  MeshAdaptation<dim>::n_elements_of_way(const double distance) const
  {
    return dim == 2 ? distance * parameters.mesh.spans / scene.length :
                      distance / scene.contact_element_length();
  }



  template <int dim>
  std::shared_ptr<const typename MeshAdaptation<dim>::Points>
  MeshAdaptation<dim>::touching(const double time,
                                const double approach,
                                const double distance) const
  {
    const double ahead = distance / std::abs(parameters.load.velocity);
    const double lift  = std::max(0., approach) * ahead;
    const double way =
      protocol.displacement(time + ahead) - protocol.displacement(time);
    const auto n =
      static_cast<unsigned int>(std::ceil(n_elements_of_way(distance)));
    const std::vector<bool> touches = scene.contact->touching();
    const MeshParameters   &mesh    = parameters.mesh;
    const auto              points  = std::make_shared<Points>(
      scene.length,
      scene.width,
      scene.width / mesh.n_spans_across(scene.length, scene.width) /
        (scene.length / mesh.spans));
    for (unsigned int q = 0; q < touches.size(); ++q)
      {
        const dealii::Point<dim> &x    = scene.contact->positions()[q];
        bool                      will = touches[q];
        for (unsigned int i = 0; i <= n && !will; ++i)
          will = height_at(scene.tool_surface, x + way * i / n * scene.motion) <
                 x[dim - 1] + lift * i / n;
        if (will)
          points->add(scene.contact->table().parameter[q]);
      }
    points->sort();
    return points;
  }



  template <int dim>
  double
  plastic_work(const SolidAssembler<dim>        &chip,
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



  template class MeshAdaptation<2>;
  template class MeshAdaptation<3>;
  template double
  plastic_work(const SolidAssembler<2> &,
               const std::vector<MaterialState> &,
               const LoadParameters &);
  template double
  plastic_work(const SolidAssembler<3> &,
               const std::vector<MaterialState> &,
               const LoadParameters &);
} // namespace asperity
