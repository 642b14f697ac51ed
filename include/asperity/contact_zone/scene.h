#ifndef asperity_contact_zone_scene_h
#define asperity_contact_zone_scene_h

#include <asperity/contact/contact_assembler.h>
#include <asperity/contact_zone/oil_in_gap.h>
#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/contact_zone/sheet_surface.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/contact_zone/surface_layer.h>
#include <asperity/coupling/gap_flow.h>
#include <asperity/isogeometric/cell_partition.h>
#include <asperity/lubricant/lubricant.h>
#include <asperity/solid/equilibrium.h>
#include <asperity/solid/solid_assembler.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace asperity
{
  template <int dim>
  class SceneHeat;

  /** The surfaces of a scene: profiles, or sheets in three dimensions. */
  template <int dim>
  using SurfaceOf = std::conditional_t<dim == 2, Surface, SheetSurface>;

  /** Which of several wanted meshes has been taken. */
  struct AdaptedMesh
  {
    unsigned int number      = 0;
    bool         has_changed = false; ///< against the mesh before
  };

  /**
   * The bodies of a contact scene: an isogeometric chip block, periodic in
   * x (and in three dimensions in y), below a rigid periodic tool. Lengths in
   * metres; the last coordinate points from the chip's bottom, where it is 0,
   * to the tool; the chip slides along x, or in the direction in the plane of
   * x and y that the load says. A profile is extruded along the
   * direction across, and everything counts per metre of it.
   *
   * In three dimensions there is no oil that flows, and several ranks may share
   * the cells of a chip: everything is on each of them, but the integrals over
   * cells and over the contact face, and the tangent.
   */
  template <int dim>
  class Scene
  {
  public:
    /** @param ranks that share it
     *  @throws InputError if surfaces, mesh or oil cannot be made of the
     *    parameters */
    explicit Scene(const SceneParameters &parameters,
                   const Ranks           &ranks = Ranks());

    ~Scene();

    Scene(const Scene &) = delete;
    Scene &
    operator=(const Scene &) = delete;

    /** Components of the chip's displacement. */
    unsigned int
    n_dofs() const;

    /** Length of the vector of unknowns: the displacement, then what the
     *  lubricant solves for together with it. */
    unsigned int
    n_unknowns() const;

    /** The unknowns at rest. */
    dealii::Vector<double>
    initial_unknowns() const;

    /** Contact penalty epsilon [Pa/m]. */
    double
    penalty() const;

    /** Way along the motion through an element of the contact edge, where it
     *  has all levels [m]. */
    double
    contact_element_length() const;

    /** Mean temperature of the chip at its top, that of its uppermost Gauss
     *  points, at the last accepted step [K]. */
    double
    interface_temperature() const;

    /** Shear strength k of the chip at the points of the contact edge, at its
     *  strain and temperature at the last accepted step [Pa].
     *  @param rate of its shear [1/s] */
    std::vector<double>
    shear_strength(const double rate) const;

    /** Highest temperature of the interface at the last accepted step [K]: that
     *  of the chip at its top unless heat is conducted. */
    double
    flash_temperature() const;

    /** Vertical dead load on the bottom per pressure [m^(dim - 1)]: times p it
     *  is the load vector. */
    const dealii::Vector<double> &
    bottom_load() const;

    /** Of the components along the bottom of its functions, which are moved. */
    const dealii::AffineConstraints<double> &
    constraints() const;

    /** A way along the motion and one upwards everywhere; other unknowns zero.
     */
    dealii::Vector<double>
    translation(const double along, const double up) const;

    /** Of one period of the contact edge [m^(dim - 1)]: times a pressure it is
     *  a force. */
    double
    area() const;

    /**
     * Refines and coarsens the chip, divides its cells anew between the ranks,
     * and builds what stands on its mesh: chip and contact as at the start, and
     * the balance, with the cost so far. Of a scene with a flat chip and no
     * oil that flows. The numbers of cells and functions follow from the cells
     * alone. Collective.
     * @param wanted meshes, of which the first is taken that has not more than
     *   Mesh/Maximum unknowns
     */
    AdaptedMesh
    adapt_mesh(const SceneParameters &parameters,
               const std::vector<typename SplineSpace<dim>::CellLevel> &wanted);

    /** Takes the cells of a mesh that adapt_mesh() has made; the rest as there.
     *  @throws InputError if they are not those of such a mesh */
    void
    set_mesh(const SceneParameters             &parameters,
             const std::vector<CellIndex<dim>> &cells);

    /** The solver of the tangent: that of the parameters, or for `automatic`
     * the one that suits the size. */
    LinearSolverKind
    linear_solver() const;

    /** Which rank has which cell. */
    const CellShare &
    share() const;

    /** Work of the rank that has most of it over the mean, by the weights of
     * the cells. */
    double
    imbalance() const;

    double length;     ///< period L along x [m]
    double width = 1.; ///< period W along y [m]; 1 in two dimensions

    /** Unit vector in which the chip slides, normal to the last axis. */
    dealii::Tensor<1, dim> motion;

    /** Unit vector across the motion, to its left, in the plane of x and y;
     *  zero in two dimensions. */
    dealii::Tensor<1, dim>
    across() const;

    /** Way along the motion through the period: L along x, W along y, between
     *  them the shorter of L/|cos| and W/|sin| [m]. */
    double
    period_of_motion() const;

    SurfaceOf<dim>                         tool_surface, chip_surface;
    OilInGap                               oil;
    std::shared_ptr<SplineSpace<dim>>      space;
    PatchGeometry<dim>                     geometry;
    std::shared_ptr<const MaterialLaw>     law;
    std::shared_ptr<RigidObstacle<dim>>    tool;
    std::unique_ptr<SolidAssembler<dim>>   chip;
    std::unique_ptr<ContactAssembler<dim>> contact;
    std::unique_ptr<SurfaceLayer<dim>>     surface_layer; ///< of the chip
    std::unique_ptr<Lubricant>             lubricant;     ///< null: dry
    GapFlow *gap_flow = nullptr;          ///< the lubricant, if it is one
    std::unique_ptr<SceneHeat<dim>> heat; ///< null: no heat is conducted
    std::unique_ptr<Equilibrium>    equilibrium;

  private:
    /** Way along the motion through a rectangle of these edges along x and y
     *  [m]. */
    double
    way_through(const double along_x, const double along_y) const;

    void
    build_surfaces(const SceneParameters &parameters);

    void
    build_mesh(const SceneParameters &parameters);

    /** Everything that stands on the mesh, once that has changed. */
    void
    rebuild(const SceneParameters &parameters);

    void
    build_chip(const SceneParameters &parameters);

    void
    build_contact(const SceneParameters &parameters);

    void
    build_boundaries();

    void
    build_lubricant(const SceneParameters &parameters);

    void
    build_film(const SceneParameters &parameters);

    void
    build_heat(const SceneParameters &parameters);

    /** A typical gap between the surfaces, positive [m]. */
    double
    gap_scale(const SceneParameters &parameters) const;

    void
    build_flow(const SceneParameters &parameters);

    void
    build_equilibrium();

    /** Chooses the solver of a mesh of so many elements.
     *  @throws InputError if it does not run on the ranks, or if the memory
     *    that all of it takes is not there */
    void
    choose_solver(const SceneParameters &parameters, const double n_elements);

    /** Of `automatic`, the solver of the mesh that is there instead of that
     *  of the largest one. */
    void
    suit_solver(const SceneParameters &parameters);

    /** Divides the cells between the ranks. */
    void
    build_share(const SceneParameters &parameters);

    /** The rigid motions of the chip, as displacements. */
    std::vector<dealii::Vector<double>>
    rigid_motions() const;

    CellShare        share_;
    double           imbalance_     = 1.;
    LinearSolverKind linear_solver_ = LinearSolverKind::cholmod;

    dealii::Vector<double> initial_unknowns_;

    dealii::Vector<double>            bottom_load_;
    dealii::AffineConstraints<double> constraints_;
    double                            penalty_                = 0.;
    double                            contact_element_length_ = 0.;
    unsigned int                      n_lubricant_unknowns    = 0;
  };

  // What fills the gap needs profiles.
  template <>
  void
  Scene<2>::build_lubricant(const SceneParameters &parameters);
  template <>
  void
  Scene<3>::build_lubricant(const SceneParameters &parameters);
  template <>
  void
  Scene<2>::build_surfaces(const SceneParameters &parameters);
  template <>
  void
  Scene<3>::build_surfaces(const SceneParameters &parameters);
  template <>
  void
  Scene<2>::choose_solver(const SceneParameters &parameters,
                          const double           n_elements);
  template <>
  void
  Scene<3>::choose_solver(const SceneParameters &parameters,
                          const double           n_elements);
  template <>
  double
  Scene<2>::gap_scale(const SceneParameters &parameters) const;
  template <>
  void
  Scene<2>::build_film(const SceneParameters &parameters);
  template <>
  void
  Scene<2>::build_flow(const SceneParameters &parameters);

  /** Levels of the rows of the coarsest mesh: heights from 0 to `height`, the
   *  topmost row about `top` high, growing downwards by `grading`; at least one
   *  row. */
  std::vector<double>
  graded_rows(const double height, const double top, const double grading);

  /**
   * Numbers in a factor of the tangent of a patch of so many elements of degree
   * p, with n unknowns, 3 an element: 20.4 (p n)^1.38, fitted to the panels
   * that CHOLMOD's analysis counts on meshes of 1,300 to 20,000 unknowns
   * (within 10 %; its power is near the 4/3 of nested dissection in space, A.
   * George, SIAM J. Numer. Anal. 10 (1973) 345-363).
   */
  double
  numbers_in_factor(const double n_elements, const unsigned int degree);

  /** Memory of the patch [bytes]: of tables, pattern and matrices as scenes of
   *  these meshes took them, and of two factors, or of a second matrix and its
   *  coarser levels where the solver iterates. */
  double
  patch_memory(const double           n_elements,
               const unsigned int     degree,
               const LinearSolverKind solver = LinearSolverKind::cholmod);

  /** Whether a cell whose upper edge is so deep [m] belongs to the strip of a
   *  level below the contact edge. */
  bool
  is_in_strip(const MeshParameters &mesh,
              const unsigned int    level,
              const double          depth);
} // namespace asperity

#endif
