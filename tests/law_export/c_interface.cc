#include <asperity_friction.h>

#include <memory>
#include <thread>

#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// libasperity_friction.so, through its C interface alone.

namespace
{
  using Handle =
    std::unique_ptr<asperity_friction_law, decltype(&asperity_friction_free)>;

  Handle
  load(const std::string &path)
  {
    return Handle(asperity_friction_load(path.c_str()), asperity_friction_free);
  }

  /** The points by columns, and places for the answers. */
  struct Block
  {
    explicit Block(const std::vector<ContactPoint> &points)
      : mu(points.size())
      , dmu(3 * points.size())
      , sigma(points.size())
      , trusted(points.size())
    {
      for (const ContactPoint &point : points)
        {
          p.push_back(point[0]);
          v.push_back(point[1]);
          T.push_back(point[2]);
        }
    }

    int
    evaluate(const asperity_friction_law *law)
    {
      return asperity_friction_eval(law,
                                    p.size(),
                                    p.data(),
                                    v.data(),
                                    T.data(),
                                    mu.data(),
                                    dmu.data(),
                                    sigma.data(),
                                    trusted.data());
    }

    std::vector<double>        p, v, T, mu, dmu, sigma;
    std::vector<unsigned char> trusted;
  };
} // namespace

TEST(CInterface, agrees_with_the_law)
{
  const Folder folder;
  for (const LawKind &kind : law_kinds)
    {
      SCOPED_TRACE(kind.name());
      const FrictionLaw law = train(kind);
      law.save((folder.path / "law.json").string());
      const Handle handle = load((folder.path / "law.json").string());
      ASSERT_NE(handle.get(), nullptr) << asperity_friction_last_error();
      const std::vector<ContactPoint> all = points();
      Block                           block(all);
      ASSERT_EQ(block.evaluate(handle.get()), 0);
      // mu alone takes another way
      std::vector<double> mu(all.size());
      ASSERT_EQ(asperity_friction_eval(handle.get(),
                                       all.size(),
                                       block.p.data(),
                                       block.v.data(),
                                       block.T.data(),
                                       mu.data(),
                                       nullptr,
                                       nullptr,
                                       nullptr),
                0);
      for (std::size_t j = 0; j < all.size(); ++j)
        {
          const LawPrediction at = law.predict(all[j].data());
          EXPECT_NEAR(block.mu[j], at.mean, 1e-12 * std::abs(at.mean));
          EXPECT_NEAR(mu[j], at.mean, 1e-12 * std::abs(at.mean));
          for (unsigned int c = 0; c < 3; ++c)
            EXPECT_NEAR(block.dmu[3 * j + c],
                        at.gradient[c],
                        1e-12 * (std::abs(at.gradient[c]) +
                                 derivative_scale(at.mean, c)));
          EXPECT_NEAR(block.sigma[j], at.deviation, 1e-12 * std::abs(at.mean));
          EXPECT_EQ(block.trusted[j] != 0, at.trusted);
          EXPECT_FALSE(block.trusted[j] != 0 && !is_in_box(all[j]));
        }
      std::vector<double> k(all.size());
      EXPECT_EQ(asperity_friction_shear_limit(
                  handle.get(), all.size(), block.T.data(), k.data()),
                0);
      for (std::size_t j = 0; j < all.size(); ++j)
        EXPECT_DOUBLE_EQ(k[j], law.description().shear_limit(all[j][2]));
      std::size_t n_profiles;
      double      scatter, error;
      ASSERT_EQ(asperity_friction_topography(
                  handle.get(), &n_profiles, &scatter, &error),
                0);
      EXPECT_EQ(n_profiles, 3u);
      EXPECT_EQ(scatter, 0.2);
      EXPECT_EQ(error, law.description().topography_error);
    }
}

TEST(CInterface, tells_inputs_and_takes_any_number_of_them)
{
  LawKind kind;
  kind.has_wetting      = true;
  const FrictionLaw law = train(kind, 60);
  const Folder      folder;
  law.save((folder.path / "law.json").string());
  const Handle handle = load((folder.path / "law.json").string());
  ASSERT_NE(handle.get(), nullptr) << asperity_friction_last_error();
  EXPECT_EQ(asperity_friction_version(), ASPERITY_FRICTION_VERSION);
  ASSERT_EQ(asperity_friction_n_inputs(handle.get()), 4u);
  asperity_friction_input input;
  ASSERT_EQ(asperity_friction_get_input(handle.get(), 1, &input), 0);
  EXPECT_STREQ(input.name, "Lubrication/Wetting");
  EXPECT_STREQ(input.unit, "1");
  EXPECT_EQ(input.upper, 1.);

  const std::vector<double> x = {5e8, 0.3, 1., 500., 9e8, 0.8, 2., 700.};
  std::vector<double>       mu(2), dmu(8), sigma(2);
  ASSERT_EQ(
    asperity_friction_eval_inputs(
      handle.get(), 2, x.data(), mu.data(), dmu.data(), sigma.data(), nullptr),
    0);
  for (unsigned int j = 0; j < 2; ++j)
    {
      const LawPrediction at = law.predict(&x[4 * j]);
      EXPECT_NEAR(mu[j], at.mean, 1e-12 * at.mean);
      EXPECT_NEAR(sigma[j], at.deviation, 1e-12 * at.mean);
      for (unsigned int i = 0; i < 4; ++i)
        EXPECT_NEAR(dmu[4 * j + i],
                    at.gradient[i],
                    1e-12 * std::abs(at.gradient[i]));
    }
  Block block(std::vector<ContactPoint>{{{5e8, 1., 500.}}});
  EXPECT_NE(block.evaluate(handle.get()), 0);
  EXPECT_STREQ(asperity_friction_last_error(),
               "The law depends on 'Lubrication/Wetting' beside p, v and T; "
               "asperity_friction_eval_inputs() is expected.");
}

TEST(CInterface, answers_threads_that_share_a_law)
{
  const Folder folder;
  train(law_kinds[2]).save((folder.path / "law.json").string());
  const Handle handle = load((folder.path / "law.json").string());
  ASSERT_NE(handle.get(), nullptr) << asperity_friction_last_error();
  Block expected(points());
  ASSERT_EQ(expected.evaluate(handle.get()), 0);

  constexpr unsigned int   n_threads = 8;
  std::vector<Block>       blocks(n_threads, Block(points()));
  std::vector<std::string> errors(n_threads);
  std::vector<std::thread> threads;
  for (unsigned int i = 0; i < n_threads; ++i)
    threads.emplace_back([&, i] {
      for (unsigned int repetition = 0; repetition < 5; ++repetition)
        {
          if (blocks[i].evaluate(handle.get()) != 0)
            errors[i] += "evaluation failed ";
          // failures of one thread are none of the others' business
          asperity_friction_input input;
          if (i % 2 == 1 &&
              asperity_friction_get_input(handle.get(), 100 + i, &input) == 0)
            errors[i] += "there is no such input ";
        }
      const std::string last = asperity_friction_last_error();
      if (i % 2 == 0 && !last.empty())
        errors[i] += "got the error of another thread: " + last;
      if (i % 2 == 1 && last.find(std::to_string(100 + i)) == std::string::npos)
        errors[i] += "lost its own error: " + last;
    });
  for (std::thread &thread : threads)
    thread.join();
  for (unsigned int i = 0; i < n_threads; ++i)
    {
      EXPECT_EQ(errors[i], "");
      EXPECT_EQ(blocks[i].mu, expected.mu);
      EXPECT_EQ(blocks[i].dmu, expected.dmu);
      EXPECT_EQ(blocks[i].sigma, expected.sigma);
      EXPECT_EQ(blocks[i].trusted, expected.trusted);
    }
}

TEST(CInterface, says_what_is_wrong)
{
  EXPECT_EQ(asperity_friction_load("/nowhere/law.json"), nullptr);
  EXPECT_NE(std::string(asperity_friction_last_error()).find("law.json"),
            std::string::npos)
    << asperity_friction_last_error();
  const Folder folder;
  folder.write("letter.json", "Dear Sir or Madam");
  EXPECT_EQ(asperity_friction_load(
              (folder.path / "letter.json").string().c_str()),
            nullptr);
  EXPECT_NE(std::string(asperity_friction_last_error()).find("letter.json"),
            std::string::npos)
    << asperity_friction_last_error();
  EXPECT_EQ(asperity_friction_load(nullptr), nullptr);
  EXPECT_STREQ(asperity_friction_last_error(),
               "The path of the friction law is NULL.");
  Block block(std::vector<ContactPoint>{{{5e8, 1., 500.}}});
  EXPECT_NE(block.evaluate(nullptr), 0);
  EXPECT_STREQ(asperity_friction_last_error(),
               "The friction law or the array for mu is NULL.");
  EXPECT_EQ(asperity_friction_n_inputs(nullptr), 0u);
  EXPECT_NE(asperity_friction_topography(nullptr, nullptr, nullptr, nullptr),
            0);
  EXPECT_STREQ(asperity_friction_last_error(),
               "The friction law or the place of one of its three results is "
               "NULL.");
  asperity_friction_free(nullptr);

  train(law_kinds[2]).save((folder.path / "law.json").string());
  const Handle handle = load((folder.path / "law.json").string());
  double       mu, p = 5e8, T = 500.;
  EXPECT_NE(asperity_friction_eval(
              handle.get(), 1, &p, nullptr, &T, &mu, nullptr, nullptr, nullptr),
            0);
  EXPECT_STREQ(asperity_friction_last_error(),
               "The law depends on v, but its array is NULL.");
  EXPECT_EQ(asperity_friction_eval(handle.get(),
                                   0,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr),
            0);
}

TEST(CInterface, is_C99_and_shows_nothing_else)
{
  if (!has_program("gcc") || !has_program("nm"))
    GTEST_SKIP() << "gcc or nm was not found";
  const Folder folder;
  train(law_kinds[2]).save((folder.path / "law.json").string());
  folder.write("program.c", R"(
#include <asperity_friction.h>
#include <stdio.h>
int main(void)
{
  asperity_friction_law *law = asperity_friction_load("law.json");
  const double p = 4.5e8, v = 1.5, T = 573.15;
  double mu;
  if (!law || asperity_friction_eval(law, 1, &p, &v, &T, &mu, NULL, NULL, NULL))
    {
      puts(asperity_friction_last_error());
      return 1;
    }
  printf("%.17g\n", mu);
  asperity_friction_free(law);
  return 0;
}
)");
  const std::string build = ASPERITY_BINARY_DIR;
  folder.run("gcc -std=c99 -pedantic -Wall -Wextra -Werror -I'" +
             std::string(ASPERITY_SOURCE_DIR) +
             "/include' -o program program.c -L'" + build +
             "' -lasperity_friction -Wl,-rpath,'" + build + "'");
  folder.run("./program >answer.txt");
  const double expected = formula(4.5e8, 1.5, 573.15, 0.);
  const auto   rows     = folder.rows("answer.txt");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0][0], expected, 0.02 * expected);

  folder.run("nm -D --defined-only '" + build +
             "/libasperity_friction.so' >symbols.txt");
  std::istringstream in(folder.read("symbols.txt"));
  unsigned int       n_functions = 0;
  for (std::string address, kind, name; in >> address >> kind >> name;)
    {
      EXPECT_EQ(name.compare(0, 18, "asperity_friction_"), 0) << name;
      ++n_functions;
    }
  EXPECT_EQ(n_functions, 11u);
}
