#include "flow_learning.h"

#include <asperity/learned_fields/train_decoder.h>
#include <asperity/surrogate/friction_law.h>

#include <cstdio>
#include <fstream>
#include <iostream>

namespace learned_flows
{
  namespace
  {
    /** What errors of held-out solutions add up to. */
    struct Errors
    {
      double       sum = 0., largest = 0.;
      unsigned int n = 0;

      void
      add(const double error)
      {
        sum += error;
        largest = std::max(largest, error);
        ++n;
      }

      double
      mean() const
      {
        return sum / n;
      }
    };
  } // namespace



  Numbers
  difference(const Numbers &a, const Numbers &b)
  {
    Numbers result = a;
    for (std::size_t i = 0; i < a.size(); ++i)
      result[i] -= b[i];
    return result;
  }



  FlowStudy::FlowStudy(LearnedFlow &flow, const FlowSnapshots &all)
    : flow(flow)
    , all(all)
    , weights(flow.weights())
  {
    Numbers     learnt;
    std::size_t n = 0;
    for (std::size_t i = 0; i < all.solutions.size(); ++i)
      if (!is_held_out(i))
        {
          learnt.insert(learnt.end(),
                        all.solutions[i].begin(),
                        all.solutions[i].end());
          ++n;
        }
    modes = std::make_unique<const OrthogonalDecomposition>(learnt, n, weights);
  }



  double
  FlowStudy::norm(const Numbers &u) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < u.size(); ++i)
      sum += weights[i] * u[i] * u[i];
    return std::sqrt(sum);
  }



  void
  FlowStudy::print_singular_values() const
  {
    const Numbers &s   = modes->singular_values();
    double         sum = 0., part = 0.;
    for (const double value : s)
      sum += value * value;
    std::printf("\n%zu solutions learnt, %zu held out; norm of the mean %.4g, "
                "root mean square deviation from it %.4g\n\n| modes | singular "
                "value over the first | share of the squares beyond |\n| --- | "
                "--- | --- |\n",
                s.size(),
                all.solutions.size() - s.size(),
                norm(modes->mean()),
                std::sqrt(sum / s.size()));
    for (std::size_t i = 0; i < std::min<std::size_t>(12, s.size()); ++i)
      {
        part += s[i] * s[i];
        std::printf("| %zu | %.3g | %.2g |\n",
                    i + 1,
                    s[i] / s[0],
                    std::max(0., 1. - part / sum));
      }
  }



  FlowDecoder
  FlowStudy::pod(const unsigned int n) const
  {
    const auto decoder = std::make_shared<PodDecoder>(*modes, weights, n);
    return {"POD",
            n,
            [decoder](const Numbers &z) { return decoder->decode(z); },
            [decoder](const Numbers &u) { return decoder->encode(u); }};
  }



  FlowDecoder
  FlowStudy::manifold(const unsigned int n) const
  {
    // The deviations of as many solutions have one mode less.
    const PodDecoder     linear(*modes, weights, modes->n_modes() - 1);
    std::vector<Numbers> coefficients;
    for (std::size_t i = 0; i < all.solutions.size(); ++i)
      if (!is_held_out(i))
        coefficients.push_back(linear.encode(all.solutions[i]));
    const auto decoder = train_manifold(linear, coefficients, n, 20000);
    return {"manifold",
            n,
            [decoder](const Numbers &z) { return decoder->decode(z); },
            [decoder](const Numbers &u) { return decoder->encode(u); }};
  }



  std::vector<Numbers>
  FlowStudy::codes_of_inputs(const FlowDecoder &decoder) const
  {
    Numbers              x;
    std::vector<Numbers> z(decoder.n_codes);
    for (std::size_t i = 0; i < all.inputs.size(); ++i)
      if (!is_held_out(i))
        {
          const Numbers at   = flow.coordinates(all.inputs[i]);
          const Numbers code = decoder.encode(all.solutions[i]);
          x.insert(x.end(), at.begin(), at.end());
          for (std::size_t k = 0; k < z.size(); ++k)
            z[k].push_back(code[k]);
        }
    FrictionLawDescription description;
    const std::size_t      n_inputs = flow.coordinates(all.inputs[0]).size();
    for (std::size_t i = 0; i < n_inputs; ++i)
      description.inputs.push_back({"x" + std::to_string(i + 1),
                                    "x" + std::to_string(i + 1),
                                    "1",
                                    -1. - 1e-9,
                                    1. + 1e-9});
    description.output       = "code";
    description.output_scale = Scale::linear;
    std::vector<Numbers> codes(all.inputs.size(), Numbers(z.size()));
    for (std::size_t k = 0; k < z.size(); ++k)
      {
        const FrictionLaw law = FrictionLaw::train(description, x, z[k]);
        for (std::size_t i = 0; i < codes.size(); ++i)
          codes[i][k] = law.mean(flow.coordinates(all.inputs[i]).data());
      }
    return codes;
  }



  void
  FlowStudy::print_judgement(const FlowDecoder &decoder) const
  {
    const auto          codes = codes_of_inputs(decoder);
    Errors              best, predicted, divergence, of_run;
    std::vector<Errors> measured(flow.measures().size());
    for (std::size_t i = 0; i < all.solutions.size(); ++i)
      {
        if (!is_held_out(i))
          continue;
        const Numbers &u = all.solutions[i];
        best.add(norm(difference(decoder.decode(decoder.encode(u)), u)) /
                 norm(u));
        const Numbers of_input = decoder.decode(codes[i]);
        predicted.add(norm(difference(of_input, u)) / norm(u));
        const FlowNumbers a = flow.numbers(of_input), b = flow.numbers(u);
        for (std::size_t m = 0; m < measured.size(); ++m)
          measured[m].add(std::abs(a.measured[m] - b.measured[m]));
        divergence.add(a.divergence);
        of_run.add(b.divergence);
      }
    std::printf("| %s, %u | %.2g %% (%.2g %%) | %.2g %% (%.2g %%) |",
                decoder.name.c_str(),
                decoder.n_codes,
                100. * best.mean(),
                100. * best.largest,
                100. * predicted.mean(),
                100. * predicted.largest);
    for (const Errors &errors : measured)
      std::printf(" %.2g (%.2g) |", errors.mean(), errors.largest);
    std::printf(" %.3g, %.3g |\n", divergence.mean(), of_run.mean());
    std::fflush(stdout);
  }



  void
  FlowStudy::print_head() const
  {
    std::printf("\n| decoder, latent size | velocity, best code | velocity, "
                "code of the input |");
    for (const std::string &name : flow.measures())
      std::printf(" %s |", name.c_str());
    std::printf(" divergence, that of the run |\n| --- | --- | --- |");
    for (std::size_t m = 0; m < flow.measures().size(); ++m)
      std::printf(" --- |");
    std::printf(" --- |\n");
  }



  void
  FlowStudy::write_fields(const std::string              &path,
                          const std::vector<FlowDecoder> &decoders) const
  {
    const std::size_t    held  = 2 * (all.solutions.size() / 8) + 1;
    const auto           nodes = flow.velocity_nodes();
    std::vector<Numbers> fields{all.solutions[held]};
    std::ofstream        out(path);
    out << "x [m],y [m],u of the run [m/s],v of the run [m/s]";
    for (const FlowDecoder &decoder : decoders)
      {
        const std::string who =
          decoder.name + " " + std::to_string(decoder.n_codes);
        out << ",u of " << who << " [m/s],v of " << who << " [m/s]";
        fields.push_back(decoder.decode(codes_of_inputs(decoder)[held]));
      }
    out << "\n";
    for (std::size_t i = 0; i < nodes.u.size(); ++i)
      {
        out << nodes.positions[2 * i] << "," << nodes.positions[2 * i + 1];
        for (const Numbers &u : fields)
          out << "," << u[nodes.u[i]] << "," << u[nodes.v[i]];
        out << "\n";
      }
  }
} // namespace learned_flows
