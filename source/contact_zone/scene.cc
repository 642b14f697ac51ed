#include <asperity/contact/curve_obstacle.h>
#include <asperity/contact/sheet_obstacle.h>
#include <asperity/contact_zone/scene.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace asperity
{
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  namespace
  {
    std::shared_ptr<RigidObstacle<2>>
    make_obstacle(const Surface &tool)
    {
      return std::make_shared<CurveObstacle>(tool.curve, CurveSide::right);
    }

    std::shared_ptr<RigidObstacle<3>>
    make_obstacle(const SheetSurface &tool)
    {
      return std::make_shared<SheetObstacle>(tool.sheet);
    }

    /** Exact for right angles. @param angle to x, of a patch [rad] */
    template <int dim>
    dealii::Tensor<1, dim>
    direction_of_motion(const double angle)
    {
      dealii::Tensor<1, dim> motion;
      motion[0] = 1.;
      if constexpr (dim == 3)
        {
          motion[0] = std::cos(angle);
          motion[1] = std::sin(angle);
          for (unsigned int d = 0; d < 2; ++d)
            if (std::abs(motion[d]) < 1e-12)
              motion[d] = 0.;
          motion /= motion.norm();
        }
      return motion;
    }
  } // namespace



  template <int dim>
  Scene<dim>::Scene(const SceneParameters &parameters, const Ranks &ranks)
    : motion(direction_of_motion<dim>(parameters.load.direction))
    , share_{ranks, {}}
  {
    build_surfaces(parameters);
    build_mesh(parameters);
    build_share(parameters);
    law = parameters.make_law();
    build_chip(parameters);
    build_contact(parameters);
    build_lubricant(parameters);
    build_heat(parameters);
    build_boundaries();
    build_equilibrium();
  }



  template <int dim>
  Scene<dim>::~Scene() = default;



  template <>
  void
  Scene<2>::build_surfaces(const SceneParameters &parameters)
  {
    std::tie(tool_surface, chip_surface) = make_surfaces(parameters);
    length                               = tool_surface.period;
    // Measured heights point out of the tool, and the tool is above.
    if (parameters.tool.kind == SurfaceKind::measured)
      tool_surface = tool_surface.mapped(-1., 0.);
    const double height = parameters.geometry.height;
    chip_surface        = chip_surface.mapped(1., height);
    const double gap    = smallest_gap(chip_surface, tool_surface);
    oil                 = oil_in_gap(parameters.lubrication,
                     parameters.geometry.initial_gap,
                     tool_surface.mean() - chip_surface.mean() - gap);
    tool_surface        = tool_surface.mapped(1., oil.initial_gap - gap);
    const double distance =
      parameters.mesh.offset * length / parameters.mesh.spans;
    if (distance == 0.)
      return;
    tool_surface = tool_surface.moved(distance);
    chip_surface = chip_surface.moved(distance);
  }



  template <>
  void
  Scene<3>::build_surfaces(const SceneParameters &parameters)
  {
    std::tie(tool_surface, chip_surface) = make_sheets(parameters);
    length                               = tool_surface.sheet.period(0);
    width                                = tool_surface.sheet.period(1);
    if (parameters.tool.kind == SurfaceKind::measured)
      tool_surface = tool_surface.mapped(-1., 0.); // x, y stay the map's
    chip_surface     = chip_surface.mapped(1., parameters.geometry.height);
    const double gap = smallest_gap(chip_surface, tool_surface);
    oil =
      oil_in_gap(parameters.lubrication,
                 parameters.geometry.initial_gap,
                 tool_surface.sheet.mean() - chip_surface.sheet.mean() - gap);
    tool_surface               = tool_surface.mapped(1., oil.initial_gap - gap);
    const MeshParameters &mesh = parameters.mesh;
    if (mesh.offset == 0.)
      return;
    const double along_x = mesh.offset * length / mesh.spans,
                 along_y =
                   mesh.offset * width / mesh.n_spans_across(length, width);
    tool_surface = tool_surface.moved(along_x, along_y);
    chip_surface = chip_surface.moved(along_x, along_y);
  }



  template <int dim>
  void
  Scene<dim>::build_chip(const SceneParameters &parameters)
  {
    chip = std::make_unique<SolidAssembler<dim>>(
      space,
      geometry,
      law,
      Kinematics::plane_strain,
      parameters.mesh.n_quadrature_points(),
      share_);
    MaterialState start;
    start.temperature    = parameters.load.temperature;
    start.plastic_strain = parameters.load.plastic_strain;
    chip->initialize(start);
    if (!parameters.output.field_times.empty())
      chip->keep_stress();
  }



  template <int dim>
  void
  Scene<dim>::build_contact(const SceneParameters &parameters)
  {
    tool = make_obstacle(tool_surface);
    contact_element_length_ =
      dim == 2 ?
        length / parameters.mesh.spans :
        way_through(length / parameters.mesh.spans,
                    width / parameters.mesh.n_spans_across(length, width));
    penalty_ = parameters.contact.penalty.value_or(
      parameters.contact.penalty_factor * law->young_modulus() /
      contact_element_length_);

    ContactOptions options;
    options.formulation        = parameters.contact.formulation;
    options.penalty            = penalty_;
    options.points_per_element = parameters.contact.quadrature;
    options.interface          = parameters.interface;
    // Elements that come and go do not change what touches.
    if (parameters.mesh.adaptive_levels > 0)
      options.element_length =
        dim == 2 ? contact_element_length_ :
                   std::sqrt(area() / parameters.mesh.spans /
                             parameters.mesh.n_spans_across(length, width));
    if constexpr (dim == 3)
      options.motion = {{motion[0], motion[1]}};
    contact = std::make_unique<ContactAssembler<dim>>(
      space, geometry, Edge::top, tool, options, share_);
    surface_layer =
      std::make_unique<SurfaceLayer<dim>>(chip->table(), contact->table());
  }



  template <int dim>
  void
  Scene<dim>::build_boundaries()
  {
    constraints_.clear();
    bottom_load_.reinit(n_unknowns());
    for (const unsigned int a : space->edge_functions(Edge::bottom))
      for (unsigned int c = 0; c < dim - 1; ++c)
        constraints_.add_line(displacement_dof<dim>(a, c));
    constraints_.close();
    const BasisTable<dim> bottom =
      tabulate_edge(*space,
                    geometry,
                    Edge::bottom,
                    dealii::QGauss<dim - 1>(space->degree() + 1));
    for (const auto &entry : bottom.elements)
      {
        const ElementView<dim> element(bottom, entry);
        for (unsigned int q = 0; q < bottom.points_per_element; ++q)
          for (unsigned int a = 0; a < element.n_functions(); ++a)
            bottom_load_(element.dof(a, dim - 1)) +=
              element.N(q, a) * element.JxW(q);
      }
  }



  template <int dim>
  void
  Scene<dim>::build_heat(const SceneParameters &parameters)
  {
    if (parameters.heat_model() != HeatModel::conducting)
      return;
    typename SceneHeat<dim>::Periods periods;
    periods[0] = length;
    if constexpr (dim == 3)
      periods[1] = width;
    heat = std::make_unique<SceneHeat<dim>>(
      parameters, *space, geometry, periods, *chip, *contact, share_);
  }



  template <int dim>
  unsigned int
  Scene<dim>::n_dofs() const
  {
    return dim * space->n_functions();
  }



  template <int dim>
  unsigned int
  Scene<dim>::n_unknowns() const
  {
    return n_dofs() + n_lubricant_unknowns;
  }



  template <int dim>
  Vector
  Scene<dim>::initial_unknowns() const
  {
    return initial_unknowns_;
  }



  template <int dim>
  double
  Scene<dim>::penalty() const
  {
    return penalty_;
  }



  template <int dim>
  double
  Scene<dim>::contact_element_length() const
  {
    return contact_element_length_;
  }



  template <int dim>
  std::vector<double>
  Scene<dim>::shear_strength(const double rate) const
  {
    std::vector<double> k;
    for (const auto &point : surface_layer->at_edge(chip->history()))
      k.push_back(
        law->shear_limit(point.plastic_strain, rate, point.temperature));
    return k;
  }



  template <int dim>
  const Vector &
  Scene<dim>::bottom_load() const
  {
    return bottom_load_;
  }



  template <int dim>
  const dealii::AffineConstraints<double> &
  Scene<dim>::constraints() const
  {
    return constraints_;
  }



  template <int dim>
  Vector
  Scene<dim>::translation(const double along, const double up) const
  {
    Vector u(n_unknowns());
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      {
        for (unsigned int c = 0; c < dim - 1; ++c)
          u(displacement_dof<dim>(a, c)) = along * motion[c];
        u(displacement_dof<dim>(a, dim - 1)) = up;
      }
    return u;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Scene<dim>::across() const
  {
    dealii::Tensor<1, dim> left;
    if constexpr (dim == 3)
      {
        left[0] = -motion[1];
        left[1] = motion[0];
      }
    return left;
  }



  template <int dim>
  double
  Scene<dim>::period_of_motion() const
  {
    return way_through(length, width);
  }



  template <int dim>
  double
  Scene<dim>::way_through(const double along_x, const double along_y) const
  {
    if constexpr (dim == 2)
      return along_x;
    const double edges[] = {along_x, along_y};
    double       way     = std::numeric_limits<double>::max();
    for (unsigned int d = 0; d < 2; ++d)
      if (motion[d] != 0.)
        way = std::min(way, edges[d] / std::abs(motion[d]));
    return way;
  }



  template <int dim>
  double
  Scene<dim>::flash_temperature() const
  {
    if (heat)
      return heat->flash_temperature();
    double hottest = 0.;
    for (const auto &point : surface_layer->at_edge(chip->history()))
      hottest = std::max(hottest, point.temperature);
    return hottest;
  }



  template <int dim>
  double
  Scene<dim>::area() const
  {
    return length * width;
  }



  template <int dim>
  double
  Scene<dim>::interface_temperature() const
  {
    return surface_layer->mean_temperature(chip->history());
  }



  template class Scene<2>;
  template class Scene<3>;
} // namespace asperity
