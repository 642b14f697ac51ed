#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// tools/asperity_friction.py, with numpy and as if there were none.

namespace
{
  const char *const preamble = R"(
import sys
if sys.argv[1] == "without":
    sys.modules["numpy"] = None
sys.path.insert(0, sys.argv[2])
import asperity_friction
from asperity_friction import FrictionLaw, FrictionError
law = FrictionLaw("law.json", library=sys.argv[3])
points = [tuple(map(float, line.split())) for line in open("points.txt")]
def show(*values):
    print(" ".join("%.17g" % value for value in values))
)";

  const char *const scalars = R"(
for p, v, T in points:
    at = law.predict(p, v, T)
    assert isinstance(at.mu, float) and isinstance(at.trusted, bool)
    assert abs(law.mean(p, v, T) - at.mu) <= 1e-14
    show(at.mu, *at.derivatives, at.deviation, at.trusted,
         law.shear_limit(T), law.shear_stress(p, v, T))
assert law.mechanisms.startswith("This mu comes from ploughing and oil; adh")
assert law.topography.profiles == 3 and law.topography.scatter == 0.2
# Student's quantile for two degrees of freedom
assert abs(law.topography.error - 4.302652729696142 * 0.2 / 3**0.5) < 1e-9
)";

  const char *const lists = R"(
p, v, T = (list(column) for column in zip(*points))
at = law.predict(p, v, T)
assert isinstance(at.mu, list) and len(at.derivatives[0]) == 3
for row in zip(at.mu, at.derivatives, at.deviation, at.trusted,
               law.shear_limit(T), law.shear_stress(p, v, T)):
    show(row[0], *row[1], *row[2:])
# a number goes with every entry of a list
assert law.mean(p, 1.5, 573.15)[7] == law.mean(p[7], 1.5, 573.15)
)";

  const char *const arrays = R"(
import numpy
p, v, T = numpy.array(points).T
at = law.predict(p, v, T)
assert at.mu.shape == p.shape and at.derivatives.shape == p.shape + (3,)
assert at.trusted.dtype == bool
for i in range(len(p)):
    show(at.mu[i], *at.derivatives[i], at.deviation[i], at.trusted[i],
         law.shear_limit(T)[i], law.shear_stress(p, v, T)[i])
grid = law.mean(p[:6].reshape(3, 2), 1.5, numpy.array([400., 500.]))
assert grid.shape == (3, 2)
assert abs(grid[2, 1] - law.mean(p[5], 1.5, 500.)) < 1e-14
)";

  const char *const errors = R"(
def sentence(call):
    try:
        call()
    except FrictionError as error:
        print(error)
    else:
        print("nothing was raised")
sentence(lambda: FrictionLaw("nowhere.json", library=sys.argv[3]))
sentence(lambda: FrictionLaw("law.json", library="nowhere.so"))
sentence(lambda: law.predict([1e8, 2e8], [1., 2., 3.], 500.))
sentence(lambda: law.predict(5e8, 1., 500., {"Load/Speed": 3.}))
wet = FrictionLaw("wet.json", library=sys.argv[3])
sentence(lambda: wet.predict(5e8, 1., 500.))
print(wet.inputs[1].name, wet.inputs[1].upper)
show(wet.mean(5e8, 1., 500., {"Lubrication/Wetting": 0.3}),
     *wet.predict(5e8, 1., 500., {"Wetting": 0.3}).derivatives)
)";

  /** A Python that has numpy: the first of the path, or the system's; or "". */
  std::string
  python_with_numpy()
  {
    for (const std::string python : {"python3", "/usr/bin/python3"})
      if (std::system(
            (python + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0)
        return python;
    return "";
  }

  void
  run_python(const Folder      &folder,
             const std::string &script,
             const bool         with_numpy,
             const std::string &output)
  {
    folder.write("script.py", preamble + script);
    folder.run((with_numpy ? python_with_numpy() + " script.py with" :
                             std::string("python3 script.py without")) +
               " '" + ASPERITY_SOURCE_DIR + "/tools' '" + ASPERITY_BINARY_DIR +
               "/libasperity_friction.so' >" + output);
  }

  void
  expect_same_answers(const FrictionLaw                      &law,
                      const std::vector<std::vector<double>> &rows)
  {
    const std::vector<ContactPoint> all = points();
    const ContactPointLaw           at_points(law);
    ASSERT_EQ(rows.size(), all.size());
    for (std::size_t j = 0; j < all.size(); ++j)
      {
        const LawPrediction at = law.predict(all[j].data());
        ASSERT_EQ(rows[j].size(), 8u);
        EXPECT_NEAR(rows[j][0], at.mean, 1e-12 * at.mean);
        for (unsigned int c = 0; c < 3; ++c)
          EXPECT_NEAR(rows[j][1 + c],
                      at.gradient[c],
                      1e-12 * (std::abs(at.gradient[c]) +
                               derivative_scale(at.mean, c)));
        EXPECT_NEAR(rows[j][4], at.deviation, 1e-12 * at.mean);
        EXPECT_EQ(rows[j][5] == 1., at.trusted);
        EXPECT_FALSE(rows[j][5] != 0. && !is_in_box(all[j]));
        EXPECT_DOUBLE_EQ(rows[j][6], law.description().shear_limit(all[j][2]));
        EXPECT_NEAR(rows[j][7],
                    at_points.shear_stress(all[j]),
                    1e-12 * std::abs(rows[j][7]));
      }
  }

  /** Sanitizers want to be loaded before Python. */
  constexpr bool is_sanitized =
#if defined(__SANITIZE_ADDRESS__)
    true;
#else
    false;
#endif
} // namespace

TEST(PythonModule, agrees_with_the_law)
{
  if (!has_program("python3") || is_sanitized)
    GTEST_SKIP() << "python3 was not found, or cannot load a sanitized library";
  const FrictionLaw law = train(law_kinds[2]);
  const Folder      folder;
  law.save((folder.path / "law.json").string());
  folder.write_points("points.txt", points());
  for (const std::string script : {scalars, lists})
    {
      run_python(folder, script, false, "answers.txt");
      expect_same_answers(law, folder.rows("answers.txt"));
    }
}

TEST(PythonModule, takes_arrays_of_numpy)
{
  if (is_sanitized || python_with_numpy().empty())
    GTEST_SKIP() << "numpy was not found, or the library is sanitized";
  const FrictionLaw law = train(law_kinds[2]);
  const Folder      folder;
  law.save((folder.path / "law.json").string());
  folder.write_points("points.txt", points());
  for (const std::string script : {arrays, scalars, lists})
    {
      run_python(folder, script, true, "answers.txt");
      expect_same_answers(law, folder.rows("answers.txt"));
    }
}

TEST(PythonModule, says_what_is_wrong_and_takes_further_inputs)
{
  if (!has_program("python3") || is_sanitized)
    GTEST_SKIP() << "python3 was not found, or cannot load a sanitized library";
  LawKind kind;
  kind.has_wetting      = true;
  const FrictionLaw wet = train(kind, 60);
  const Folder      folder;
  wet.save((folder.path / "wet.json").string());
  train(law_kinds[2]).save((folder.path / "law.json").string());
  folder.write_points("points.txt", {});
  run_python(folder, errors, false, "answers.txt");
  std::istringstream       in(folder.read("answers.txt"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_NE(lines[0].find("nowhere.json"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("The library 'nowhere.so' cannot be loaded"),
            std::string::npos)
    << lines[1];
  EXPECT_EQ(lines[2], "The points have different numbers of values: 2, 3.");
  EXPECT_EQ(lines[3], "The law has no input 'Load/Speed'.");
  EXPECT_EQ(lines[4],
            "The law also depends on 'Lubrication/Wetting' [1]; give its SI "
            "value in `others`.");
  EXPECT_EQ(lines[5], "Lubrication/Wetting 1.0");
  const LawPrediction at =
    ContactPointLaw(wet, {{"Wetting", 0.3}}).predict({{5e8, 1., 500.}});
  std::istringstream numbers(lines[6]);
  double             value;
  numbers >> value;
  EXPECT_NEAR(value, at.mean, 1e-12 * at.mean);
  for (unsigned int c = 0; c < 3; ++c)
    {
      numbers >> value;
      EXPECT_NEAR(value, at.gradient[c], 1e-12 * std::abs(at.gradient[c]));
    }
}
