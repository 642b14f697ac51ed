#include <asperity/base/parameters.h>
#include <asperity/topography/topography_parameters.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    void
    declare_file(ParameterDeclarator &parameters, TopographyParameters &p)
    {
      parameters.file("File",
                      p.file,
                      "The measured surface: X3P, SDF, SUR, AL3D, PLUX, GSF "
                      "or text, recognised by its content.");
      parameters.text("Lateral unit",
                      p.lateral_unit,
                      "Unit of the coordinates (m, mm, um, nm) in a file that "
                      "carries none; empty: the file says it.");
      parameters.text("Height unit",
                      p.height_unit,
                      "Unit of the heights (m, mm, um, nm) in a file that "
                      "carries none; empty: the file says it.");
      parameters.quantity("Spacing x",
                          p.spacing_x,
                          "um",
                          Range::between(1e-12, 1e-2),
                          "Distance of the samples in a line of a text matrix; "
                          "automatic: the file says it.");
      parameters.quantity("Spacing y",
                          p.spacing_y,
                          "um",
                          Range::between(1e-12, 1e-2),
                          "Distance of the lines of a text matrix; automatic: "
                          "as Spacing x.");
    }

    void
    declare_treatment(ParameterDeclarator &parameters, TopographyParameters &p)
    {
      parameters.number("Spike threshold",
                        p.spike_threshold,
                        Range::between(0., 1000.),
                        "Points further from the median of their neighbours "
                        "than this many robust standard deviations count as "
                        "missing; 0 switches the search off, 6 is usual.");
      parameters.choice("Crop",
                        p.crop,
                        {{"none", CropChoice::none},
                         {"hole-free", CropChoice::hole_free},
                         {"window", CropChoice::window}},
                        "The part of the map that is used. none: all of it; "
                        "hole-free: the largest rectangle without missing "
                        "points; window: Crop columns and Crop rows.");
      parameters.text("Crop columns",
                      p.crop_columns,
                      "Range along x: all, first and last column (60 .. 195, "
                      "counted from 0) or lengths (380 um .. 1250 um).");
      parameters.text("Crop rows",
                      p.crop_rows,
                      "Range along y, as Crop columns.");
      parameters.choice("F-operator",
                        p.form,
                        {{"none", FormChoice::none},
                         {"plane", FormChoice::plane},
                         {"polynomial", FormChoice::polynomial}},
                        "Form removal of ISO 25178-3 by least squares over the "
                        "valid points: none, a plane, or a polynomial.");
      parameters.integer("Polynomial degree",
                         p.polynomial_degree,
                         Range::between(1, 10),
                         "Total degree of the polynomial of the F-operator.");
      parameters.quantity("S-filter nesting index",
                          p.s_filter,
                          "um",
                          Range::between(0., 0.1),
                          "Cutoff of the Gaussian filter (ISO 16610-61) that "
                          "removes shorter waves; 0 um switches it off.");
      parameters.quantity("L-filter nesting index",
                          p.l_filter,
                          "um",
                          Range::between(0., 0.1),
                          "Cutoff of the Gaussian filter (ISO 16610-61) that "
                          "removes longer waves; 0 um switches it off.");
    }

    void
    declare_profile(ParameterDeclarator &parameters, TopographyParameters &p)
    {
      parameters.quantity("Profile direction",
                          p.direction,
                          "deg",
                          Range::between(-2. * M_PI, 2. * M_PI),
                          "Angle of the profile to x: 0 deg is along the rows, "
                          "90 deg along the columns.");
      parameters.text("Profile position",
                      p.position,
                      "Where the profile crosses the cropped map: middle, row "
                      "30, column 12, or a length across its direction such "
                      "as 33 um.");
      parameters.quantity("Profile start",
                          p.start,
                          "um",
                          Range::between(0., 1.),
                          "Arc length at which the profile begins.");
      parameters.quantity("Profile length",
                          p.length,
                          "um",
                          Range::between(0., 1.),
                          "Length of the profile before scaling, which is "
                          "its period (half of it, mirrored); 0 um takes what "
                          "the map has. Of a patch the length of the window "
                          "along x, which must be given.");
      parameters.number("Largest missing fraction",
                        p.largest_missing_fraction,
                        Range::between(0., 1.),
                        "Missing samples of the profile are filled by straight "
                        "lines up to this fraction of it; more are an error.");
      parameters.number("Scale x",
                        p.scale_x,
                        Range::between(1e-6, 1e6),
                        "Factor on the lengths of the finished profile.");
      parameters.number(
        "Scale z",
        p.scale_z,
        Range::between(1e-6, 1e6),
        "Factor on the heights of the finished profile, or of the "
        "harmonics of a scene's surface.");
    }

    void
    declare_continuation(ParameterDeclarator  &parameters,
                         TopographyParameters &p)
    {
      parameters.choice("Periodic continuation",
                        p.continuation,
                        {{"wrapped spline", Continuation::wrapped_spline},
                         {"mirror", Continuation::mirror},
                         {"none", Continuation::none}},
                        "How the profile becomes periodic. wrapped spline: "
                        "least-squares spline around the period that bridges "
                        "the seam; mirror: followed by its mirror image; none: "
                        "repeated with the jump that it has.");
      parameters.integer("Spline degree",
                         p.spline.degree,
                         Range::between(2, 5),
                         "Degree of the wrapped spline.");
      parameters.number("Samples per knot",
                        p.spline.samples_per_knot,
                        Range::between(1., 1000.),
                        "Knot spacing of the wrapped spline over the sample "
                        "spacing; more is smoother.");
      parameters.number("Blend fraction",
                        p.spline.blend_fraction,
                        Range::between(0., 0.25),
                        "Part of the profile at each end in which the measured "
                        "heights fade out of the fit.");
    }
  } // namespace

  void
  TopographyParameters::declare(ParameterDeclarator &parameters)
  {
    declare_file(parameters, *this);
    declare_treatment(parameters, *this);
    declare_profile(parameters, *this);
    declare_continuation(parameters, *this);
  }
} // namespace asperity
