#include <asperity/contact/curve_obstacle.h>
#include <asperity/contact_zone/scene.h>
#include <asperity/contact_zone/scene_heat.h>
#include <asperity/isogeometric/element_view.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace asperity
{
  using dealii::Point;
  using Vector = dealii::Vector<double>;

  Scene::Scene(const SceneParameters &parameters)
  {
    build_surfaces(parameters);
    build_mesh(parameters);
    law = parameters.make_law();
    build_chip(parameters);
    build_contact(parameters);
    build_lubricant(parameters);
    build_heat(parameters);
    build_boundaries();
    build_equilibrium(parameters.solver.linear_solver);
  }



  Scene::~Scene() = default;



  void
  Scene::build_surfaces(const SceneParameters &parameters)
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
  }



  void
  Scene::build_chip(const SceneParameters &parameters)
  {
    chip =
      std::make_unique<SolidAssembler<2>>(space,
                                       geometry,
                                       law,
                                       Kinematics::plane_strain,
                                       parameters.mesh.n_quadrature_points());
    MaterialState start;
    start.temperature    = parameters.load.temperature;
    start.plastic_strain = parameters.load.plastic_strain;
    chip->initialize(start);
  }



  void
  Scene::build_contact(const SceneParameters &parameters)
  {
    tool =
      std::make_shared<CurveObstacle>(tool_surface.curve, CurveSide::right);
    contact_element_length_ = length / parameters.mesh.spans;
    penalty_                = parameters.contact.penalty.value_or(
      parameters.contact.penalty_factor * law->young_modulus() /
      contact_element_length_);

    ContactOptions options;
    options.formulation        = parameters.contact.formulation;
    options.penalty            = penalty_;
    options.points_per_element = parameters.contact.quadrature;
    options.interface          = parameters.interface;
    contact                    = std::make_unique<ContactAssembler<2>>(
      space, geometry, Edge::top, tool, options);
    surface_layer =
      std::make_unique<SurfaceLayer>(chip->table(), contact->table(), length);
  }



  void
  Scene::build_equilibrium(const DirectSolverKind linear_solver)
  {
    std::vector<ForceTerm *> terms = {chip.get(), contact.get()};
    if (lubricant)
      terms.push_back(lubricant.get());
    // The tangent of a film is symmetric in structure only.
    const bool symmetric = n_lubricant_unknowns == 0;
    equilibrium =
      std::make_unique<Equilibrium>(n_unknowns(),
                                    terms,
                                    constraints_,
                                    symmetric || linear_solver !=
                                                   DirectSolverKind::cholmod ?
                                      linear_solver :
                                      DirectSolverKind::supernodal_lu);
    // A chip that floats on oil is held by the oil's volume alone.
    equilibrium->set_support(
      displacement_dof<2>(space->edge_functions(Edge::bottom).front(), 1));
  }



  void
  Scene::build_boundaries()
  {
    constraints_.clear();
    bottom_load_.reinit(n_unknowns());
    for (const unsigned int a : space->edge_functions(Edge::bottom))
      constraints_.add_line(displacement_dof<2>(a, 0));
    constraints_.close();
    const BasisTable<2> bottom = tabulate_edge(
      *space, geometry, Edge::bottom, dealii::QGauss<1>(space->degree() + 1));
    for (const auto &entry : bottom.elements)
      {
        const ElementView<2> element(bottom, entry);
        for (unsigned int q = 0; q < bottom.points_per_element; ++q)
          for (unsigned int a = 0; a < element.n_functions(); ++a)
            bottom_load_(element.dof(a, 1)) += element.N(q, a) * element.JxW(q);
      }
  }



  void
  Scene::build_heat(const SceneParameters &parameters)
  {
    if (parameters.heat_model() == HeatModel::conducting)
      heat = std::make_unique<SceneHeat>(
        parameters, *space, geometry, length, *chip, *contact);
  }



  unsigned int
  Scene::n_dofs() const
  {
    return 2 * space->n_functions();
  }



  unsigned int
  Scene::n_unknowns() const
  {
    return n_dofs() + n_lubricant_unknowns;
  }



  Vector
  Scene::initial_unknowns() const
  {
    return initial_unknowns_;
  }



  double
  Scene::penalty() const
  {
    return penalty_;
  }



  double
  Scene::contact_element_length() const
  {
    return contact_element_length_;
  }



  std::vector<double>
  Scene::shear_strength(const double rate) const
  {
    std::vector<double> k;
    for (const SurfaceLayer::Point &point :
         surface_layer->at_edge(chip->history()))
      k.push_back(
        law->shear_limit(point.plastic_strain, rate, point.temperature));
    return k;
  }



  const Vector &
  Scene::bottom_load() const
  {
    return bottom_load_;
  }



  const dealii::AffineConstraints<double> &
  Scene::constraints() const
  {
    return constraints_;
  }



  Vector
  Scene::translation(const double x, const double y) const
  {
    Vector u(n_unknowns());
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      {
        u(displacement_dof<2>(a, 0)) = x;
        u(displacement_dof<2>(a, 1)) = y;
      }
    return u;
  }



  double
  Scene::flash_temperature() const
  {
    if (heat)
      return heat->flash_temperature();
    double hottest = 0.;
    for (const SurfaceLayer::Point &point :
         surface_layer->at_edge(chip->history()))
      hottest = std::max(hottest, point.temperature);
    return hottest;
  }
} // namespace asperity
