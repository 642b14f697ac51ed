#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/solver_tables.h>

#include <algorithm>
#include <map>
#include <set>

#include "../files.h"
#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

// Each table is read back from its text and interpolated here, independently of
// the program, and has to keep the error that it states.

namespace
{
  using Nodes = std::array<std::vector<double>, 3>;

  /** mu at the nodes (p, v, T) of a full grid, in whatever units. */
  struct Table
  {
    std::map<ContactPoint, double> mu;

    Nodes
    nodes() const
    {
      std::array<std::set<double>, 3> sets;
      for (const auto &[point, value] : mu)
        for (unsigned int c = 0; c < 3; ++c)
          sets[c].insert(point[c]);
      Nodes result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c].assign(sets[c].begin(), sets[c].end());
      return result;
    }

    double
    interpolate(const Nodes &nodes, const ContactPoint &x) const
    {
      return interpolate(nodes, x, x, 0);
    }

  private:
    /** Linear along one coordinate after the other. */
    double
    interpolate(const Nodes        &nodes,
                const ContactPoint &x,
                const ContactPoint &node,
                const unsigned int  c) const
    {
      if (c == 3)
        return mu.at(node);
      ContactPoint               low = node, high = node;
      const std::vector<double> &axis = nodes[c];
      if (axis.size() == 1)
        {
          low[c] = axis[0];
          return interpolate(nodes, x, low, c + 1);
        }
      std::size_t i = 0;
      while (i + 2 < axis.size() && axis[i + 1] < x[c])
        ++i;
      low[c]              = axis[i];
      high[c]             = axis[i + 1];
      const double weight = (x[c] - axis[i]) / (axis[i + 1] - axis[i]);
      return (1. - weight) * interpolate(nodes, x, low, c + 1) +
             weight * interpolate(nodes, x, high, c + 1);
    }
  };

  std::vector<double>
  numbers(std::string line)
  {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream  in(line);
    std::vector<double> result;
    for (double value; in >> value;)
      result.push_back(value);
    return result;
  }

  std::vector<std::string>
  lines_without(const std::string &text, const std::string &comment)
  {
    std::vector<std::string> result;
    std::istringstream       in(text);
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, comment.size(), comment) != 0)
        result.push_back(line);
    return result;
  }

  /** The error that a text states, "Largest error ...: 0.47 % of mu". */
  double
  stated_error(const std::string &text, const std::string &comment)
  {
    std::string plain;
    for (const std::string &line : split(text, '\n'))
      if (line.compare(0, comment.size(), comment) == 0)
        plain += line.substr(comment.size());
    const std::size_t begin = plain.find("Largest error");
    EXPECT_NE(begin, std::string::npos);
    const std::size_t colon = plain.find(": ", begin);
    return parse_quantity(plain.substr(colon + 2,
                                       plain.find(" of mu", colon) - colon - 2),
                          Dimension::none);
  }

  /** The largest relative error at points between the nodes, in SI. */
  double
  largest_error(const Table           &table,
                const ContactPointLaw &law,
                const SolverUnits     &units)
  {
    const Nodes nodes  = table.nodes();
    double      result = 0.;
    for (std::size_t j = 0; j < 2000; ++j)
      {
        const std::vector<double> u = evenly_spread_point(j + 77, 3);
        ContactPoint              x, si;
        for (unsigned int c = 0; c < 3; ++c)
          {
            x[c] =
              nodes[c].front() + u[c] * (nodes[c].back() - nodes[c].front());
            si[c] = to_si(x[c], units[c]);
          }
        const double exact = law.mean(si);
        result =
          std::max(result,
                   std::abs(table.interpolate(nodes, x) - exact) / exact);
      }
    return result;
  }

  /** Errors between the quarters at which a grid is measured. */
  constexpr double between = 1.05;

  const FrictionGridOptions options = {};
} // namespace

TEST(SolverTables, abaqus_keeps_its_error_and_limits_tau)
{
  for (const LawKind &kind : law_kinds)
    {
      SCOPED_TRACE(kind.name());
      const ContactPointLaw law(train(kind));
      const FrictionGrid    grid(law, options);
      const std::string     text  = abaqus_table(law, grid, 735.65);
      const auto            lines = lines_without(text, "**");
      // k = 600 MPa (1 - ((735.65 - 293.15) / 1480)^1.3558)
      const double k = 600. * (1. - std::pow(442.5 / 1480., 1.3558));
      ASSERT_EQ(lines[0].compare(0, 18, "*FRICTION, TAUMAX="), 0) << lines[0];
      EXPECT_NEAR(std::stod(lines[0].substr(18)), k, 1e-3);

      Table               table;
      std::vector<double> last;
      for (std::size_t i = 1; i < lines.size(); ++i)
        {
          const std::vector<double> row = numbers(lines[i]);
          ASSERT_EQ(row.size(), 4u);
          table.mu[{{row[2], row[1], row[3]}}] = row[0];
          // Abaqus wants the last variable to change least often
          const std::vector<double> order = {row[3], row[2], row[1]};
          EXPECT_LT(last, order);
          last = order;
        }
      EXPECT_EQ(table.mu.size(), grid.n_nodes());
      EXPECT_EQ(table.nodes()[0].front(), 300.);
      EXPECT_EQ(table.nodes()[0].back(), 1300.);
      EXPECT_EQ(table.nodes()[1].front(), 375.);
      EXPECT_EQ(table.nodes()[2].front(), 25.);
      EXPECT_EQ(table.nodes()[2].back(), 900.);

      const double stated = stated_error(text, "**");
      EXPECT_NEAR(stated, grid.interpolation_error(), 0.01 * stated);
      EXPECT_TRUE(grid.tolerance_is_reached());
      EXPECT_LE(stated, options.tolerance);
      const double error = largest_error(table, law, options.units);
      EXPECT_LE(error, between * grid.interpolation_error());
      EXPECT_GT(error, 0.3 * stated)
        << "nobody wants a table finer than need be";
      EXPECT_NE(text.find("Not run in that program"), std::string::npos);
      EXPECT_NE(text.find("Permission is hereby granted"), std::string::npos);
    }
}

TEST(SolverTables, lsdyna_has_a_table_for_each_temperature)
{
  const ContactPointLaw law(train(law_kinds[0]));
  const FrictionGrid    grid(law, options);
  const std::string     text  = lsdyna_table(law, grid);
  const auto            lines = lines_without(text, "$");
  ASSERT_EQ(lines.front(), "*KEYWORD");
  ASSERT_EQ(lines.back(), "*END");

  std::map<int, std::vector<std::pair<double, int>>>    tables;
  std::map<int, std::vector<std::pair<double, double>>> curves;
  bool                                                  is_table = false;
  int                                                   id       = 0;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i)
    if (lines[i][0] == '*')
      {
        is_table = lines[i] == "*DEFINE_TABLE_2D";
        ASSERT_TRUE(is_table || lines[i] == "*DEFINE_CURVE") << lines[i];
        id = std::stoi(lines[++i].substr(0, 10));
        EXPECT_EQ(tables.count(id) + curves.count(id), 0u);
      }
    else if (is_table)
      tables[id].push_back({std::stod(lines[i].substr(0, 20)),
                            std::stoi(lines[i].substr(20, 20))});
    else
      curves[id].push_back({std::stod(lines[i].substr(0, 20)),
                            std::stod(lines[i].substr(20, 20))});

  ASSERT_EQ(tables.size(), grid.nodes(2).size());
  std::size_t k = 0;
  for (const auto &[id, rows] : tables)
    {
      Table        table;
      const double T = grid.nodes(2)[k++];
      for (const auto &[p, curve] : rows)
        for (const auto &[v, mu] : curves.at(curve))
          table.mu[{{p, v, T}}] = mu;
      EXPECT_LE(largest_error(table, law, options.units),
                between * stated_error(text, "$"));
    }
}

TEST(SolverTables, deform_has_a_table_for_each_velocity)
{
  const ContactPointLaw law(train(law_kinds[1]));
  const FrictionGrid    grid(law, options);
  for (std::size_t j = 0; j < grid.nodes(1).size(); ++j)
    {
      const std::string text  = deform_table(law, grid, j);
      const auto        lines = lines_without(text, "*");
      const std::size_t n_p = grid.nodes(0).size(), n_T = grid.nodes(2).size();
      EXPECT_EQ(lines[0],
                "FRCFAC 1 2 2 5 " + std::to_string(n_p) + " " +
                  std::to_string(n_T) + " 1");
      ASSERT_EQ(lines.size(), 4 + n_T);
      const std::vector<double> p = numbers(lines[1]), T = numbers(lines[2]);
      Table                     table;
      for (std::size_t k = 0; k < n_T; ++k)
        {
          const std::vector<double> mu = numbers(lines[4 + k]);
          ASSERT_EQ(mu.size(), n_p);
          for (std::size_t i = 0; i < n_p; ++i)
            table.mu[{{p[i], grid.nodes(1)[j], T[k]}}] = mu[i];
        }
      const double stated = stated_error(text, "*");
      EXPECT_LE(stated, grid.interpolation_error() * 1.01);
      EXPECT_LE(largest_error(table, law, options.units), between * stated);
    }
}

TEST(SolverTables, csv_has_everything_in_SI)
{
  const ContactPointLaw law(train(law_kinds[2]));
  FrictionGridOptions   si = options;
  si.units                 = {{"Pa", "m/s", "K"}};
  const FrictionGrid grid(law, si);
  const std::string  text  = friction_table_csv(law, grid);
  const auto         lines = lines_without(text, "#");
  ASSERT_EQ(lines[0], "p_Pa,v_m_per_s,T_K,mu,sigma_mu,tau_Pa,k_Pa,trusted");
  Table table;
  for (std::size_t i = 1; i < lines.size(); ++i)
    {
      const std::vector<double> row = numbers(lines[i]);
      ASSERT_EQ(row.size(), 8u);
      const ContactPoint  x  = {{row[0], row[1], row[2]}};
      const LawPrediction at = law.predict(x);
      table.mu[x]            = row[3];
      EXPECT_TRUE(law.is_inside(x));
      EXPECT_NEAR(row[3], at.mean, 1e-5 * at.mean);
      EXPECT_NEAR(row[4], at.deviation, 1e-5 * at.deviation);
      EXPECT_NEAR(row[6], law.shear_limit(row[2]), 1e-5 * row[6]);
      EXPECT_NEAR(row[5], std::min(row[3] * row[0], row[6]), 2e-5 * row[5]);
      EXPECT_EQ(row[7] == 1., at.trusted);
    }
  EXPECT_EQ(table.mu.size(), grid.n_nodes());
  EXPECT_LE(largest_error(table, law, si.units),
            between * stated_error(text, "#"));
  for (const std::string word : {"Matern 5/2", "leave-one-out", "blasted.x3p"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
}

TEST(FrictionGrid, is_as_fine_as_it_is_told)
{
  const ContactPointLaw law(train(law_kinds[2]));
  std::size_t           n_last = 0;
  for (const double tolerance : {0.05, 0.01, 0.002})
    {
      FrictionGridOptions finer = options;
      finer.tolerance           = tolerance;
      const FrictionGrid grid(law, finer);
      EXPECT_LE(grid.interpolation_error(), tolerance);
      EXPECT_GT(grid.n_nodes(), n_last);
      n_last = grid.n_nodes();
    }
}

TEST(FrictionGrid, says_when_it_gives_up)
{
  const ContactPointLaw law(train(law_kinds[2]));
  FrictionGridOptions   impossible = options;
  impossible.tolerance             = 1e-4;
  impossible.max_nodes             = 200;
  const FrictionGrid grid(law, impossible);
  EXPECT_LE(grid.n_nodes(), 200u);
  EXPECT_FALSE(grid.tolerance_is_reached());
  EXPECT_GT(grid.interpolation_error(), 1e-4);
  EXPECT_NE(abaqus_table(law, grid, 500.).find("could not be kept"),
            std::string::npos);
}

TEST(FrictionGrid, needs_only_one_node_where_the_law_does_not_look)
{
  const FrictionLaw      full        = train(law_kinds[2]);
  FrictionLawDescription description = full.description();
  description.inputs                 = {description.inputs[0]};
  std::vector<double> x;
  for (std::size_t j = 0; j < full.data().y.size(); ++j)
    x.push_back(full.data().x[3 * j]);
  const ContactPointLaw law(FrictionLaw::train(description, x, full.data().y));
  const FrictionGrid    grid(law, options);
  EXPECT_EQ(grid.nodes(1).size(), 1u);
  EXPECT_EQ(grid.nodes(2).size(), 1u);
  EXPECT_EQ(grid.n_nodes(), grid.nodes(0).size());
  EXPECT_LE(grid.interpolation_error(), options.tolerance);
  EXPECT_EQ(law.predict({{5e8, 1., 300.}}).gradient[1], 0.);
  EXPECT_EQ(law.mean({{5e8, 1., 300.}}), law.mean({{5e8, 2., 900.}}));
}

TEST(FrictionGrid, refuses_units_of_something_else)
{
  const ContactPointLaw law(train(law_kinds[2]));
  FrictionGridOptions   wrong = options;
  wrong.units[1]              = "MPa";
  EXPECT_EQ(message_of<InputError>([&] { FrictionGrid(law, wrong); }),
            "The unit 'MPa' for v in a friction table is none of a velocity.");
  wrong           = options;
  wrong.tolerance = 0.;
  EXPECT_EQ(message_of<InputError>([&] { FrictionGrid(law, wrong); }),
            "The tolerance of friction tables is 0; a number above 0 and below "
            "1 is expected.");
}
