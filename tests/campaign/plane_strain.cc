#include "campaign_examples.h"

using namespace asperity;

using CampaignPlaneStrain = CampaignExample;

// What patches have told about the profiles goes into the law and no further:
// its interval stays what it is.
TEST_F(CampaignPlaneStrain, is_part_of_what_the_law_says)
{
  std::vector<double> deviations;
  for (const std::string entries :
       {"", " set Plane strain below = 0.1\n set Plane strain above = 1.2\n"})
    {
      CampaignInput input(folder,
                          text("subsection Friction law\n" + entries +
                               "end\n"));
      input.parameters.design.initial_runs = 6; // learns from all at once
      input.parameters.design.maximum_runs = 6;
      input.parameters.design.test_runs    = 0;
      std::filesystem::remove_all(folder / "out");
      Campaign campaign(input.parameters,
                        input.declarator,
                        MPI_COMM_WORLD,
                        formula_run);
      campaign.run();
      const FrictionLaw law =
        campaign.results().train(campaign.results().training_data(6));
      const std::vector<double> point = {600e6, 1.};
      deviations.push_back(law.predict(point.data()).deviation);
      const auto &choices = law.description().choices;
      ASSERT_EQ(choices.size(), entries.empty() ? 0u : 1u);
      if (entries.empty())
        continue;
      EXPECT_EQ(choices[0].kind, "plane strain");
      EXPECT_EQ(choices[0].below, 0.1);
      EXPECT_EQ(choices[0].above, 1.2);
    }
  EXPECT_EQ(deviations[0], deviations[1]);
}
