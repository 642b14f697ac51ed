#ifndef asperity_tests_contact_contact_problem_h
#define asperity_tests_contact_contact_problem_h

#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/contact/contact_assembler.h>
#include <asperity/contact/curve_obstacle.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solid/solid_assembler.h>

#include <functional>
#include <memory>
#include <vector>

namespace example
{
  /** A soft body [Pa]. */
  inline asperity::ElasticParameters
  elasticity()
  {
    asperity::ElasticParameters parameters;
    parameters.young_modulus = 1e6;
    parameters.poisson_ratio = 0.3;
    return parameters;
  }

  /** The half-plane above y = height; the body is below. */
  class Ceiling : public asperity::RigidObstacle<2>
  {
  public:
    explicit Ceiling(const double height);

    asperity::GapPoint<2>
    gap(const dealii::Point<2> &x, dealii::Point<1> &hint) const override;

  private:
    double height;
  };

  /** A disc above its lowest point. */
  class Cylinder : public asperity::RigidObstacle<2>
  {
  public:
    Cylinder(const dealii::Point<2> &lowest_point, const double radius);

    asperity::GapPoint<2>
    gap(const dealii::Point<2> &x, dealii::Point<1> &hint) const override;

  private:
    dealii::Point<2> lowest_point;
    double           radius;
  };

  /** The graph of an L-periodic function as a tool above the body. */
  std::shared_ptr<const asperity::CurveObstacle>
  periodic_tool(const std::function<double(double)> &height,
                const double                         period,
                const unsigned int                   n_spans);

  /** Rows from -height to 0, the top one about `top`, growing downwards. */
  std::vector<double>
  graded_rows(const double height, const double top, const double growth);

  std::vector<double>
  equal_steps(const double begin, const double end, const unsigned int n);

  enum class Support
  {
    clamped_bottom,
    rollers ///< bottom without vertical, left side without lateral motion
  };

  /** An elastic body under a rigid obstacle, quasi-static. */
  class ContactProblem
  {
  public:
    ContactProblem(std::shared_ptr<const asperity::SplineSpace<2>>   space,
                   std::shared_ptr<const asperity::MaterialLaw>      law,
                   std::shared_ptr<const asperity::RigidObstacle<2>> obstacle,
                   const asperity::ContactOptions                   &options,
                   const Support support = Support::clamped_bottom,
                   const asperity::PatchGeometry<2> &geometry = {});

    /** Moves the obstacle to the offset (x, y) and finds the balance. */
    asperity::ConvergenceReport
    solve(const double x, const double y);

    /**
     * Lowers the obstacle until it presses with a force, by the secant method.
     * @param force [N/m], positive
     * @param depth where to start [m], positive downwards
     * @return the depth, or NaN if none was found
     */
    double
    press(const double force, const double depth);

    /** Moves the obstacle down from one depth to another, in as many steps as
     *  it takes. */
    bool
    move(const double from, const double to);

    /** Vertical force of the body on the obstacle [N/m]. */
    double
    force() const;

    dealii::Vector<double>                          u;
    asperity::NewtonOptions                         options;
    asperity::NewtonStatistics                      statistics;
    asperity::ConvergenceReport                     last;
    std::shared_ptr<const asperity::SplineSpace<2>> space;
    std::unique_ptr<asperity::SolidAssembler<2>>    solid;
    std::unique_ptr<asperity::ContactAssembler<2>>  contact;
    std::unique_ptr<asperity::Equilibrium>          equilibrium;
  };
} // namespace example

#endif
