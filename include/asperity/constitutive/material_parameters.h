#ifndef asperity_constitutive_material_parameters_h
#define asperity_constitutive_material_parameters_h

#include <asperity/constitutive/hencky_elasticity.h>
#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/constitutive/johnson_cook.h>
#include <asperity/constitutive/voce.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

  /**
   * The point laws there are, each by the struct of its own constants; the
   * first one is the default. Such a struct has
   *
   *   static constexpr const char *name;        // as in a parameter file
   *   static constexpr const char *description; // a part of a sentence
   *   void declare(ParameterDeclarator &); // its own subsection, if any
   *   void check(const ParameterDeclarator &) const; // of its entries
   *   std::unique_ptr<MaterialLaw>
   *   make_law(const ElasticParameters &, const HeatingParameters &) const;
   *
   * A new law is one more line here.
   */
  using MaterialLaws = std::tuple<JohnsonCookParameters,
                                  VoceParameters,
                                  HenckyParameters,
                                  NeoHookeParameters,
                                  StVenantKirchhoffParameters>;

  /** A material as a parameter file describes it: the chosen law, what all laws
   *  share, and the constants of every law. */
  class MaterialParameters
  {
  public:
    ElasticParameters elasticity;
    HeatingParameters heating; ///< elastic laws leave it

    /** The constants of a law, whether it is chosen or not. */
    template <class Constants>
    Constants &
    constants()
    {
      return std::get<Constants>(laws);
    }

    /** See above. */
    template <class Constants>
    const Constants &
    constants() const
    {
      return std::get<Constants>(laws);
    }

    /** Chooses the law with these constants. */
    template <class Constants>
    void
    choose(const Constants &constants)
    {
      std::get<Constants>(laws) = constants;
      chosen                    = place<Constants>();
    }

    /** Declares the subsection "Material". */
    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @throws InputError if entries contradict each other */
    void
    check(const ParameterDeclarator &parameters) const;

    /** @throws InputError if a constant of the chosen law has no physical
     *  meaning */
    std::unique_ptr<MaterialLaw>
    make_law() const;

    /** Of the chosen law, MaterialLaw::softening().
     *  @throws InputError as make_law() */
    std::optional<Softening>
    softening() const;

    /** Path of the melting temperature of the chosen law, which has one if it
     *  softens: "Material/<law>/Melting temperature". */
    std::string
    melting_entry() const;

    /** Of all laws, in order. */
    static std::vector<std::string>
    law_names();

    /** Whether plastic work heats the points of this material.
     *  @throws InputError as make_law() */
    bool
    heats_itself() const;

  private:
    /** A place in MaterialLaws. */
    enum class Place : std::size_t
    {
    };

    template <class Constants, std::size_t i = 0>
    static constexpr Place
    place()
    {
      if constexpr (std::is_same_v<Constants,
                                   std::tuple_element_t<i, MaterialLaws>>)
        return Place(i);
      else
        return place<Constants, i + 1>();
    }

    MaterialLaws laws;
    Place        chosen{0};
  };
} // namespace asperity

#endif
