#ifndef asperity_tests_campaign_campaign_examples_h
#define asperity_tests_campaign_campaign_examples_h

#include <asperity/campaign/campaign.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace asperity
{
  /** A campaign over pressure and velocity in a folder of its own. */
  class CampaignExample : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      std::filesystem::remove_all(folder);
      std::filesystem::create_directories(folder);
      std::ofstream(folder / "scene.prm")
        << "subsection Mesh\n set Spans = 32\n set Refinement levels = 1\nend\n";
    }

    void
    TearDown() override
    {
      std::filesystem::remove_all(folder);
    }

    /** Profiles are those of a map. */
    void
    use_measured_tool() const
    {
      std::ofstream(folder / "scene.prm")
        << "include " ASPERITY_SOURCE_DIR
           "/parameter_files/friction_law/blasted_contact.prm\n";
    }

    std::string
    text(const std::string &further = "") const
    {
      return "subsection Campaign\n set Base scene = scene.prm\n"
             " set Output directory = " +
             (folder / "out").string() +
             "\n subsection Input 1\n  set Entry = Load/Pressure\n"
             "  set From = 300 MPa\n  set To = 1300 MPa\n end\n"
             " subsection Input 2\n  set Entry = Load/Velocity\n"
             "  set From = 22.5 m/min\n  set To = 200 m/min\n"
             "  set Scale = logarithmic\n end\n"
             " subsection Design\n  set Initial runs = 8\n  set Batch = 4\n"
             "  set Maximum runs = 20\n  set Target error = 1e-9\n"
             "  set Test runs = 10\n end\nend\n" +
             further;
    }

    std::string
    read(const std::string &name) const
    {
      std::ifstream in(folder / name);
      return {std::istreambuf_iterator<char>(in), {}};
    }

    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      (std::string("asperity_campaign_") +
       testing::UnitTest::GetInstance()->current_test_info()->name());
  };

  /** The parameters of a campaign, read and checked. */
  struct CampaignInput
  {
    CampaignInput(const std::filesystem::path &folder, const std::string &text)
      : declarator(handler)
    {
      parameters.declare(declarator);
      std::ofstream(folder / "campaign.prm") << text;
      declarator.read_file((folder / "campaign.prm").string());
      parameters.check(declarator);
    }

    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator;
    CampaignParameters       parameters;
  };

  /** mu as a smooth function of the first two inputs, instead of a scene. */
  inline double
  formula(const double pressure, const double velocity)
  {
    return 0.2 * std::pow(pressure / 300e6, -0.4) *
           (1. + 0.1 * std::log(velocity));
  }

  inline double
  value_of(const RunOrder &order, const std::size_t i)
  {
    const std::string &text = order.changes[i].second;
    const std::string  unit = text.substr(text.rfind(' ') + 1);
    return parse_quantity(text, dimension_of(unit));
  }

  inline RunRecord
  formula_run(const std::string &, const RunOrder &order)
  {
    RunRecord record;
    record.done    = true;
    record.mu      = formula(value_of(order, 0), value_of(order, 1));
    record.mu_end  = record.mu;
    record.seconds = 1.;
    return record;
  }
} // namespace asperity

#endif
