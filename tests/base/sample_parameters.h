#ifndef asperity_tests_base_sample_parameters_h
#define asperity_tests_base_sample_parameters_h

#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  enum class Inertia
  {
    none,
    full
  };

  /** One of each kind, in nested subsections, as the rooms do it. */
  struct Sample
  {
    double                      pressure    = 300e6;
    double                      temperature = 948.15;
    std::optional<double>       step;
    Inertia                     inertia = Inertia::none;
    bool                        restart = false;
    double                      penalty = 20;
    unsigned int                spans   = 120;
    std::optional<unsigned int> rows    = 11;
    std::string                 title   = "a run";
    std::vector<double>         heights = {1e-6, 2.5e-6};
    double                      density = 7850;
    std::string                 height_map;

    void
    declare(ParameterDeclarator &p)
    {
      p.text("Title", title, "What the run is called.");
      {
        const auto load = p.subsection("Load");
        p.quantity("Pressure", pressure, "MPa", Range::positive(), "Load p.");
        p.quantity("Temperature",
                   temperature,
                   "degC",
                   Range::positive(),
                   "Initial temperature of the chip.");
        p.quantity(
          "Time step", step, "us", Range::positive(), "Length of a step.");
        p.choice("Inertia",
                 inertia,
                 {{"quasi-static", Inertia::none}, {"dynamic", Inertia::full}},
                 "Whether mass resists.");
        p.flag("Restart", restart, "Continue from the last checkpoint.");
      }
      const auto mesh = p.subsection("Mesh");
      p.integer("Spans", spans, Range::at_least(2), "Knot spans along x.");
      p.integer("Rows", rows, Range::at_least(1), "Rows in depth.");
      p.list(
        "Heights", heights, "um", Range::non_negative(), "Breakpoints in y.");
      const auto contact = p.subsection("Contact");
      p.number("Penalty",
               penalty,
               Range::between(0.1, 1000),
               "Dimensionless penalty c in c E/h.");
    }

    void
    declare_mandatory(ParameterDeclarator &p)
    {
      const auto chip = p.subsection("Chip");
      p.quantity("Density",
                 density,
                 "kg/m3",
                 Range::positive(),
                 "Mass density.",
                 Need::mandatory);
      p.file("Height map",
             height_map,
             "The measured surface.",
             Need::mandatory);
    }
  };

  struct Declared
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      parameters{handler};
    Sample                   sample;

    explicit Declared(const bool mandatory = false)
    {
      sample.declare(parameters);
      if (mandatory)
        sample.declare_mandatory(parameters);
    }

    std::string
    message_of(const std::string &text)
    {
      try
        {
          parameters.read_text(text, "x.prm");
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "no error";
    }
  };
} // namespace asperity

#endif
