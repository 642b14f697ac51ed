#ifndef asperity_contact_zone_surface_chooser_h
#define asperity_contact_zone_surface_chooser_h

#include <asperity/base/parameters.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/contact_zone/surface_choice.h>
#include <asperity/topography/autocorrelation.h>
#include <asperity/topography/texture.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace asperity
{
  // Numbers as the reasons of choices have them: three digits, or two.
  inline std::string
  um(const double length)
  {
    return format_quantity(length, "um", 3);
  }

  inline std::string
  number(const double value)
  {
    return format_quantity(value, "1", 2);
  }

  inline std::string
  percent(const double fraction)
  {
    return number(100. * fraction) + " %";
  }

  /** Makes the choices one after the other, each on the map that the earlier
   *  ones leave. */
  class SurfaceChooser
  {
  public:
    explicit SurfaceChooser(const TopographyParameters &given);

    SurfaceChoice
    choose();

  private:
    void
    choose_spikes();
    void
    choose_crop(const double missing, const Window &hole_free);
    void
    choose_form();
    void
    choose_profile();
    bool
    noise_disturbs(const Texture &texture);
    void
    choose_direction(const Texture &slopes, const ArealTexture &areal);
    void
    choose_period_and_l_filter(HeightMap &filtered);
    void
    choose_place(const HeightMap &filtered);
    void
    look_at_profile();
    void
    describe();

    /** Goes to the next coarser S-filter. @return false if the map is too
     *  small for that */
    bool
    filter_more();

    /** Every choice goes this way, so that file and parameters agree. */
    void
    set(const std::string &key,
        const std::string &text,
        const std::string &reason);

    SurfaceChoice            choice;
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator;
    TopographyReport         report;
    HeightMap                map; ///< without spikes, cropped, without form

    double      wave = 0.; ///< nesting index of the S-filter
    std::string reason_of_wave, reason_of_length;
    double      noise     = 0.;
    double      direction = 0.;
    double      available = 0.; ///< length along it
    double      period    = 0.;
    double      l_filter  = 0.;
    Surface     surface;
  };
} // namespace asperity

#endif
