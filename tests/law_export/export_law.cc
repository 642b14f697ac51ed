#include <asperity/base/errors.h>
#include <asperity/law_export/export_law.h>

#include <set>

#include "../files.h"
#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

TEST(ExportLaw, writes_every_file_with_licence_and_provenance)
{
  const Folder       folder;
  const ExportReport report =
    export_law(train(law_kinds[2]), folder.path / "out");
  std::set<std::string> names;
  for (const ExportedFile &file : report.files)
    {
      names.insert(file.name);
      SCOPED_TRACE(file.name);
      const std::string text = folder.read("out/" + file.name);
      EXPECT_NE(text.find("Permission is hereby granted"), std::string::npos);
      EXPECT_NE(text.find("blasted.x3p"), std::string::npos);
      EXPECT_NE(text.find("This mu comes from ploughing and oil; adhesion"),
                std::string::npos);
      EXPECT_NE(text.find("kernel Matern 5/2"), std::string::npos);
      const std::string extension =
        file.name.substr(file.name.find_last_of('.') + 1);
      const bool is_table = extension != "f" && extension != "c" &&
                            extension != "h" && extension != "js" &&
                            extension != "txt";
      EXPECT_EQ(file.interpolation_error > 0., is_table);
    }
  for (const std::string name : {"tribmu.h",
                                 "tribmu.c",
                                 "tribmu.f",
                                 "friction_law.js",
                                 "abaqus_fric_coef.f",
                                 "abaqus_vfriction.f",
                                 "deform_usr_bcc.f",
                                 "abaqus_friction.inp",
                                 "lsdyna_friction.k",
                                 "deform_frcfac_1.key",
                                 "friction_table.csv",
                                 "README.txt"})
    EXPECT_EQ(names.count(name), 1u) << name;
  const std::string readme = folder.read("out/README.txt");
  for (const std::string &name : names)
    EXPECT_TRUE(name == "README.txt" || readme.find(name) != std::string::npos)
      << name;
  EXPECT_TRUE(report.has_deviation);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_LE(report.table_error, ExportOptions().grid.tolerance);
  EXPECT_GT(report.table_error, 0.);
}

TEST(ExportLaw, warns_when_something_is_left_out)
{
  const Folder  folder;
  ExportOptions options;
  options.largest_factor_size = 20;
  options.grid.tolerance      = 1e-4;
  options.grid.max_nodes      = 100;
  const ExportReport report =
    export_law(train(law_kinds[2]), folder.path.string(), options);
  EXPECT_FALSE(report.has_deviation);
  ASSERT_EQ(report.warnings.size(), 2u);
  EXPECT_NE(report.warnings[0].find("more than 20 runs"), std::string::npos);
  EXPECT_NE(report.warnings[1].find("is not reached with 100 entries"),
            std::string::npos);
  EXPECT_NE(folder.read("README.txt").find("Warning: The law has more than"),
            std::string::npos);
}

TEST(ExportLaw, wants_values_of_further_inputs)
{
  LawKind kind;
  kind.has_wetting      = true;
  const FrictionLaw law = train(kind, 60);
  const Folder      folder;
  const auto        message = [&](const std::map<std::string, double> &fixed) {
    ExportOptions options;
    options.fixed = fixed;
    return message_of<InputError>(
      [&] { export_law(law, folder.path.string(), options); });
  };
  EXPECT_EQ(message({}),
            "The friction law also depends on 'Lubrication/Wetting'; a value "
            "of it is expected, 0 to 1.");
  EXPECT_EQ(message({{"Wetting", 1.5}}),
            "The value of 'Lubrication/Wetting' is 1.5; a value inside of the "
            "training data is expected, 0 to 1.");
  EXPECT_EQ(message({{"Wettting", 0.5}}),
            "A value is given for 'Wettting', but the friction law has no such "
            "input beside pressure, velocity and temperature; its others are "
            "'Lubrication/Wetting'.");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));

  ExportOptions options;
  options.fixed = {{"Wetting", 0.5}};
  export_law(law, folder.path.string(), options);
  EXPECT_NE(folder.read("tribmu.c").find("Lubrication/Wetting = 0.5, held"),
            std::string::npos);
}

TEST(ExportLaw, wants_a_law_of_mu)
{
  const FrictionLaw      law         = train(law_kinds[2]);
  FrictionLawDescription description = law.description();
  description.output                 = "contact fraction";
  const Folder folder;
  EXPECT_EQ(message_of<InputError>([&] {
              export_law(FrictionLaw::train(description,
                                            law.data().x,
                                            law.data().y),
                         folder.path.string());
            }),
            "The law is one of 'contact fraction'; a law of 'mu' is expected.");
}

TEST(ExportLaw, says_when_the_directory_cannot_be_written)
{
  const Folder folder;
  folder.write("file", "not a folder\n");
  EXPECT_NE(message_of<ComputationError>([&] {
              export_law(train(law_kinds[2]), (folder.path / "file").string());
            }).find("could not be written"),
            std::string::npos);
}
