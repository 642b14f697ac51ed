#include "campaign_examples.h"

using namespace asperity;

using CampaignPressureScale = CampaignExample;

// A power of the pressure is a straight line over its logarithm. Where the
// points lie does not depend on what the law sees.
TEST_F(CampaignPressureScale, sees_the_logarithm_of_the_pressure_over_strength)
{
  std::vector<double> errors;
  for (const std::string before : {"", "logarithm of "})
    {
      CampaignInput input(folder,
                          text("subsection Friction law\n"
                               " set Pressure scale = " +
                               before + "pressure over shear strength\nend\n"));
      input.parameters.design.initial_runs = 16; // learns from all at once
      input.parameters.design.maximum_runs = 16;
      std::filesystem::remove_all(folder / "out");
      Campaign campaign(input.parameters,
                        input.declarator,
                        MPI_COMM_WORLD,
                        formula_run);
      campaign.run();
      EXPECT_EQ(campaign.plan().inputs()[0].scale, Scale::linear);
      const FrictionLaw law =
        campaign.results().train(campaign.results().training_data(16));
      EXPECT_EQ(law.description().inputs[0].scale,
                before.empty() ? Scale::linear : Scale::logarithmic);
      errors.push_back(
        test_law(law, campaign.results().test_data()).largest_error);
    }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
}
