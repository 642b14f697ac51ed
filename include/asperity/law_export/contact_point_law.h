#ifndef asperity_law_export_contact_point_law_h
#define asperity_law_export_contact_point_law_h

#include <asperity/surrogate/friction_law.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /** Pressure [Pa], velocity [m/s] and temperature [K] at a contact point. */
  using ContactPoint = std::array<double, 3>;

  /**
   * A friction law as a chip-formation program asks for it: by pressure,
   * velocity and temperature, which are the inputs with the symbols p, v and T.
   * Those of them that the law does not have change nothing; its other inputs,
   * the wetting for example, are held at fixed values: those given, else the
   * law's own references.
   */
  class ContactPointLaw
  {
  public:
    static constexpr unsigned int n_coordinates = 3;

    /** "p", "v", "T" */
    static const std::array<std::string, n_coordinates> &
    symbols();

    /**
     * @param fixed SI values of the inputs that are none of p, v, T, by name
     *   ("Lubrication/Wetting") or symbol
     * @throws InputError if the law is not one of mu, a value is missing that
     *   has no reference, is none of the law's inputs, or is outside of its
     *   range
     */
    explicit ContactPointLaw(const FrictionLaw                   &law,
                             const std::map<std::string, double> &fixed = {});

    double
    mean(const ContactPoint &point) const;

    std::vector<double>
    means(const std::vector<ContactPoint> &points) const;

    /** The gradient has an entry for p, v and T each, 0 if the law does not
     *  depend on it. */
    LawPrediction
    predict(const ContactPoint &point) const;

    bool
    is_inside(const ContactPoint &point) const;

    /** The law's input at this coordinate (0: p, 1: v, 2: T), or null. */
    const LawInput *
    input(const unsigned int coordinate) const;

    /** k(T) [Pa], infinite if the law does not know it. */
    double
    shear_limit(const double temperature) const;

    /** min(mu p, k) [Pa] */
    double
    shear_stress(const ContactPoint &point) const;

    const FrictionLaw &
    law() const;

    /** For each input of the law: its coordinate, or n_coordinates if fixed. */
    const std::vector<unsigned int> &
    coordinates() const;

    /** For each input of the law: its value if it is fixed, else 0. */
    const std::vector<double> &
    fixed_values() const;

  private:
    std::vector<double>
    law_input(const ContactPoint &point) const;

    FrictionLaw               law_;
    std::vector<unsigned int> coordinates_;
    std::vector<double>       fixed_values_;
  };
} // namespace asperity

#endif
