#ifndef asperity_postprocess_field_snapshots_h
#define asperity_postprocess_field_snapshots_h

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  struct Hdf5Content;

  /** At which places of a chip a field has values. */
  enum class PlaceKind
  {
    nodes,  ///< corners of the pieces of a picture, cell by cell
    points, ///< Gauss points of the cells
    edge,   ///< Gauss points of the contact edge
    whole   ///< the chip has one value
  };

  /**
   * Fixed material places of a chip in plane strain, and what integrals over
   * them and pictures of them need. Two runs have the same if their meshes are
   * the same, whatever their loads. Per metre of thickness.
   */
  struct FieldPlaces
  {
    double       period         = 0.; ///< L [m]
    unsigned int n_subdivisions = 1;  ///< of a cell in a picture, a direction
    unsigned int n_gauss        = 1;  ///< Gauss points of a cell, a direction

    /** Reference positions X and parts of the area or of the length, one place
     *  after the other: x, y [m], weight [m^2], of the edge [m]. */
    std::vector<double> nodes, points, edge;

    std::size_t
    n_places(const PlaceKind kind) const;

    /** 1 of the whole chip. */
    double
    weight(const PlaceKind kind, const std::size_t place) const;

    unsigned int
    n_cells() const;

    /** Up to rounding. */
    bool
    is_same_as(const FieldPlaces &other) const;
  };

  /** A field of a snapshot; its name carries the unit. */
  struct FieldKind
  {
    std::string  name; ///< "contact pressure [Pa]"
    PlaceKind    places;
    unsigned int n_components;
  };

  /** The names by which fields are found. */
  namespace field_names
  {
    /** Beside the sliding, which is a rigid translation. */
    constexpr char displacement[] = "displacement [m]";

    /** Cauchy stress: xx, yy, zz, xy. */
    constexpr char stress[] = "stress [Pa]";

    /** xY and yY of the first Piola-Kirchhoff stress: the traction, per
     *  reference length, on a line that was horizontal. */
    constexpr char nominal_stress[] = "nominal stress [Pa]";
    constexpr char plastic_strain[] = "equivalent plastic strain [-]";
    constexpr char temperature[]    = "temperature [K]";

    /** That of the edge, as above. */
    constexpr char edge_displacement[] = "displacement of the edge [m]";

    /** Per present length, as pictures show them. */
    constexpr char contact_pressure[] = "contact pressure [Pa]";
    constexpr char shear_traction[]   = "shear traction [Pa]";
    constexpr char oil_pressure[]     = "oil pressure [Pa]";

    /** Of tool and oil on the chip per reference length: its integral over the
     *  edge is their force. */
    constexpr char traction[] = "traction [Pa]";

    /** Of the oil, which the traction misses: its shear, and what its own
     *  quadrature differs by [N/m]. */
    constexpr char further_force[] = "further force [N/m]";
  } // namespace field_names

  /** The fields of a chip at one time. */
  struct FieldSnapshot
  {
    double       time             = 0.; ///< [s]
    double       sliding_distance = 0.; ///< [m]
    double       direction        = 1.; ///< of the sliding along x
    double       pressure         = 0.; ///< load on the bottom [Pa]
    double       T_x = 0., T_y = 0.;    ///< force on the chip [N/m]
    double       mu   = 0.;
    unsigned int step = 0;

    /** One a field, [place * components + component]. */
    std::vector<std::vector<double>> values;
  };

  /**
   * The fields of a run, as a file `fields.h5`: places, fields, and snapshots
   * at those times that `Output/Field times` asks for. SI units.
   */
  struct FieldSnapshots
  {
    FieldPlaces                places;
    std::vector<FieldKind>     fields;
    std::vector<double>        shares; ///< of t_end that are asked for
    std::vector<FieldSnapshot> snapshots;

    /** Whether the chip is in balance at every time, without inertia. */
    bool is_quasi_static = true;

    /** Whether there is a snapshot of each share. */
    bool
    is_complete() const;

    /** Number of the field, or of fields if there is none. */
    std::size_t
    find(const std::string &field) const;

    /** What the file holds. */
    Hdf5Content
    content() const;

    /** @param origin the file, for messages
     *  @throws InputError if a table is missing or does not fit */
    static FieldSnapshots
    from_content(const Hdf5Content &content, const std::string &origin);

    /** @throws ComputationError if the file cannot be written */
    void
    write(const std::string &path) const;

    /** Also a file of a run that has not ended.
     *  @throws InputError naming the file if it is missing, damaged, or no such
     *    file */
    static FieldSnapshots
    read(const std::string &path);
  };

  /** Force on the chip by tractions and further force [N/m].
   *  @param values one vector a field, as in a snapshot */
  std::array<double, 2>
  force_of_tractions(const FieldSnapshots                   &about,
                     const std::vector<std::vector<double>> &values);

  /**
   * The same force from the stress in the chip: with the displacement Y e_i,
   * which vanishes on the bottom, virtual work says
   *
   *   int P_iY dV = int t_i Y dS,
   *
   * and so do the discrete equations, in whose space Y is. @return their
   * difference over the height of the chip [N/m], which vanishes in balance;
   * further forces act at the mean height of the edge
   */
  std::array<double, 2>
  imbalance_of_stress(const FieldSnapshots                   &about,
                      const std::vector<std::vector<double>> &values);
} // namespace asperity

#endif
